#include "dem/scans/ply_file.h"

#include "dem/scans/facet_polygon.h"
#include "dem/scans/text_scanner.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace interlock::dem
{
namespace
{
// The data behind the header as a row of numbers, whatever the format.
class Values
{
public:
  Values(const InputFile& file, const PlyHeader& header)
      : file_(file), header_(header), data_(file.bytes().substr(header.data)),
        text_(file, data_, "", header.data_line)
  {
  }

  double next(const PlyHeader::Type& type)
  {
    if (header_.format == PlyHeader::Format::text) return text_.number(text_.word_on_any_line());
    return next_binary(type);
  }

  // The number of entries of a list, each of which takes bytes from what is left.
  std::size_t next_count(const PlyHeader::Property& list)
  {
    const double count = next(list.count);
    const bool is_text = header_.format == PlyHeader::Format::text;
    const std::size_t left = is_text ? data_.size() - text_.position() : data_.size() - position_;
    if (!(count >= 0) || count != std::floor(count) ||
        count > static_cast<double>(left) / (is_text ? 1 : list.type.size))
      file_.refuse("is damaged: a list is to have ", count, " entries in ", place(), ", but ", left,
                   " bytes are left.");
    return static_cast<std::size_t>(count);
  }

  void start_row(const PlyHeader::Element& element, std::size_t row)
  {
    element_ = &element;
    row_ = row;
  }

  std::string place() const
  {
    if (header_.format == PlyHeader::Format::text) return "line " + std::to_string(text_.line());
    return element_->name + " " + std::to_string(row_ + 1);
  }

private:
  template <class T> double swapped(const char* bytes, int size) const
  {
    char buffer[sizeof(T)];
    std::memcpy(buffer, bytes, size);
    if (header_.format == PlyHeader::Format::big_endian) std::reverse(buffer, buffer + size);
    T value;
    std::memcpy(&value, buffer, sizeof(T));
    return static_cast<double>(value);
  }

  double next_binary(const PlyHeader::Type& type)
  {
    using Type = PlyHeader::Type;
    if (data_.size() - position_ < static_cast<std::size_t>(type.size))
      file_.refuse("is cut short: it ends in ", place(), " of ", element_->rows, ".");
    const char* bytes = data_.data() + position_;
    position_ += type.size;
    if (type.kind == Type::floating)
      return type.size == 4 ? swapped<float>(bytes, 4) : swapped<double>(bytes, 8);
    const bool has_sign = type.kind == Type::signed_integer;
    switch (type.size) {
    case 1:
      return has_sign ? swapped<std::int8_t>(bytes, 1) : swapped<std::uint8_t>(bytes, 1);
    case 2:
      return has_sign ? swapped<std::int16_t>(bytes, 2) : swapped<std::uint16_t>(bytes, 2);
    default:
      return has_sign ? swapped<std::int32_t>(bytes, 4) : swapped<std::uint32_t>(bytes, 4);
    }
  }

  const InputFile& file_;
  const PlyHeader& header_;
  std::string_view data_;
  TextScanner text_;
  std::size_t position_ = 0; // in binary data
  const PlyHeader::Element* element_ = nullptr;
  std::size_t row_ = 0;
};

void read_vertices(const InputFile& file, const PlyHeader::Element& element, Values& values,
                   PlyData& data)
{
  const char* names[] = {"x", "y", "z", "nx", "ny", "nz"};
  std::array<int, 6> columns;
  for (int k = 0; k < 6; ++k) columns[k] = element.column(names[k]);
  for (int k = 0; k < 3; ++k)
    if (columns[k] < 0 || element.properties[columns[k]].is_list())
      file.refuse("has vertices without the coordinate '", names[k], "'.");
  const bool has_normals = columns[3] >= 0 && columns[4] >= 0 && columns[5] >= 0;
  std::vector<double> row(element.properties.size());
  for (std::size_t r = 0; r < element.rows; ++r) {
    values.start_row(element, r);
    for (std::size_t p = 0; p < row.size(); ++p) {
      const PlyHeader::Property& property = element.properties[p];
      if (property.is_list())
        for (std::size_t left = values.next_count(property); left > 0; --left)
          values.next(property.type);
      else
        row[p] = values.next(property.type);
    }
    const Vector3 x(row[columns[0]], row[columns[1]], row[columns[2]]);
    if (!x.allFinite())
      file.refuse("has a coordinate that is not a finite number in ", values.place(), ": (", x[0],
                  ", ", x[1], ", ", x[2], ").");
    data.mesh.vertices.push_back(x);
    if (has_normals) data.normals.emplace_back(row[columns[3]], row[columns[4]], row[columns[5]]);
  }
}

void read_facets(const InputFile& file, const PlyHeader::Element& element, Values& values,
                 PlyData& data)
{
  int column = element.column("vertex_indices");
  if (column < 0) column = element.column("vertex_index");
  if (element.rows > 0 && (column < 0 || !element.properties[column].is_list()))
    file.refuse("has faces without a list 'vertex_indices'.");
  const double vertices = static_cast<double>(data.mesh.vertices.size());
  std::vector<int> corners;
  for (std::size_t r = 0; r < element.rows; ++r) {
    values.start_row(element, r);
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const PlyHeader::Property& property = element.properties[p];
      const std::size_t count = property.is_list() ? values.next_count(property) : 1;
      if (static_cast<int>(p) == column) corners.clear();
      for (std::size_t k = 0; k < count; ++k) {
        const double value = values.next(property.type);
        if (static_cast<int>(p) != column) continue;
        if (!(value >= 0 && value < vertices) || value != std::floor(value))
          file.refuse("has a facet with the vertex ", value, " in ", values.place(),
                      ", but its vertices go from 0 to ", vertices - 1, ".");
        corners.push_back(static_cast<int>(value));
      }
    }
    const std::string fault = append_polygon(corners, data.mesh);
    if (!fault.empty())
      file.refuse("has ", fault, " in ", values.place(), ": save the mesh with triangles.");
  }
}

void skip(const PlyHeader::Element& element, Values& values)
{
  if (element.properties.empty()) return;
  for (std::size_t r = 0; r < element.rows; ++r) {
    values.start_row(element, r);
    for (const PlyHeader::Property& property : element.properties)
      for (std::size_t k = property.is_list() ? values.next_count(property) : 1; k > 0; --k)
        values.next(property.type);
  }
}
} // namespace

PlyData read_ply(const InputFile& file, const PlyHeader& header)
{
  PlyData data;
  Values values(file, header);
  for (const PlyHeader::Element& element : header.elements) {
    if (element.name == "vertex")
      read_vertices(file, element, values, data);
    else if (element.name == "face")
      read_facets(file, element, values, data);
    else
      skip(element, values);
  }
  return data;
}
} // namespace interlock::dem
