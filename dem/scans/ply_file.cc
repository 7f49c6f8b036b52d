#include "dem/scans/ply_file.h"

#include "dem/scans/facet_polygon.h"
#include "dem/scans/ply_values.h"

#include <algorithm>
#include <cmath>

namespace interlock::dem
{
namespace
{
class Reader
{
public:
  Reader(const InputFile& file, const PlyHeader& header)
      : file_(file), header_(header), values_(file, header)
  {
  }

  PlyData read()
  {
    for (const PlyHeader::Element& element : header_.elements) {
      if (element.is_named("vertex"))
        read_vertices(element);
      else if (element.is_facet())
        read_facets(element);
      else
        skip(element);
    }
    return std::move(data_);
  }

private:
  // Columns of x, y and z, and behind them of the normal where the file is a cloud that has one.
  std::vector<int> used_columns(const PlyHeader::Element& vertex) const
  {
    std::vector<int> columns;
    for (const char* name : {"x", "y", "z"}) {
      columns.push_back(vertex.column({name}));
      if (columns.back() < 0)
        file_.refuse("has vertices without the coordinate '", name, "': they have ",
                     vertex.property_names(), ".");
    }
    if (header_.has_facets()) return columns;
    for (const auto& names : normal_names)
      if (const int column = vertex.column(names); column >= 0) columns.push_back(column);
    if (columns.size() < 6) columns.resize(3);
    return columns;
  }

  void read_vertices(const PlyHeader::Element& element)
  {
    const std::vector<int> columns = used_columns(element);
    data_.single_precision = std::any_of(columns.begin(), columns.begin() + 3, [&](int column) {
      return header_.is_single(element.properties[column].type);
    });
    std::vector<double> row(element.properties.size());
    for (std::size_t r = 0; r < element.rows; ++r) {
      values_.start_row(element, r);
      for (std::size_t p = 0; p < row.size(); ++p)
        if (std::find(columns.begin(), columns.end(), int(p)) != columns.end())
          row[p] = values_.next(element.properties[p].type);
        else
          values_.skip(element.properties[p]);
      const auto vector = [&](int first) {
        return Vector3(row[columns[first]], row[columns[first + 1]], row[columns[first + 2]]);
      };
      const Vector3 x = vector(0);
      if (!x.allFinite()) {
        if (!header_.has_facets()) refuse_coordinate(x, values_.place(), "");
        unusable_.emplace_back(static_cast<int>(r), values_.place());
      }
      data_.mesh.vertices.push_back(x);
      if (columns.size() == 6) data_.normals.push_back(vector(3));
    }
  }

  [[noreturn]] void refuse_coordinate(const Vector3& x, const std::string& place,
                                      const std::string& user) const
  {
    file_.refuse("has a coordinate that is not a finite number in ", place, ": (", x[0], ", ", x[1],
                 ", ", x[2], ")", user, ".");
  }

  void read_facets(const PlyHeader::Element& element)
  {
    const int column = element.column({"vertex_indices", "vertex_index"}, true);
    if (element.rows > 0 && column < 0)
      file_.refuse("has facets without a list 'vertex_indices': they have ",
                   element.property_names(), ".");
    const bool has_strips = element.is_strip();
    std::vector<int> corners;
    for (std::size_t r = 0; r < element.rows; ++r) {
      values_.start_row(element, r);
      for (std::size_t p = 0; p < element.properties.size(); ++p)
        if (static_cast<int>(p) == column)
          read_corners(element.properties[p], has_strips, corners);
        else
          values_.skip(element.properties[p]);
      if (has_strips)
        append_strips(corners);
      else if (const std::string fault = append_polygon(corners, data_.mesh); !fault.empty())
        file_.refuse("has ", fault, " in ", values_.place(), ": save the mesh with triangles.");
    }
  }

  // Numbers of vertices; -1 where a strip ends.
  void read_corners(const PlyHeader::Property& list, bool has_strips, std::vector<int>& corners)
  {
    const double vertices = static_cast<double>(data_.mesh.vertices.size());
    corners.clear();
    for (std::size_t left = values_.next_count(list); left > 0; --left) {
      const double value = values_.next(list.type);
      const bool is_vertex = value >= 0 && value < vertices && value == std::floor(value);
      if (!is_vertex && !(has_strips && value == -1))
        file_.refuse("has a facet with the vertex ", value, " in ", values_.place(),
                     ", but its vertices go from 0 to ", vertices - 1, ".");
      corners.push_back(static_cast<int>(value));
      if (is_vertex && !unusable_.empty()) check_usable(corners.back());
    }
  }

  void check_usable(int vertex) const
  {
    const auto found =
        std::lower_bound(unusable_.begin(), unusable_.end(), std::make_pair(vertex, std::string()));
    if (found != unusable_.end() && found->first == vertex)
      refuse_coordinate(data_.mesh.vertices[vertex], found->second,
                        ", which a facet in " + values_.place() + " uses");
  }

  // Each corner from the third on makes a triangle with the two in front of it; every second one
  // turns the other way.
  void append_strips(const std::vector<int>& corners)
  {
    std::size_t first = 0;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      if (corners[k] < 0) first = k + 1;
      if (k < first + 2) continue;
      const bool is_turned = (k - first) % 2 == 1;
      data_.mesh.triangles.push_back(
          {corners[is_turned ? k - 1 : k - 2], corners[is_turned ? k - 2 : k - 1], corners[k]});
    }
  }

  void skip(const PlyHeader::Element& element)
  {
    if (element.properties.empty()) return;
    for (std::size_t r = 0; r < element.rows; ++r) {
      values_.start_row(element, r);
      for (const PlyHeader::Property& property : element.properties) values_.skip(property);
    }
  }

  const InputFile& file_;
  const PlyHeader& header_;
  PlyValues values_;
  std::vector<std::pair<int, std::string>> unusable_; // vertices that are no point, and their place
  PlyData data_;
};
} // namespace

PlyData read_ply(const InputFile& file, const PlyHeader& header)
{
  return Reader(file, header).read();
}
} // namespace interlock::dem
