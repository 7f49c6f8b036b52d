#include "dem/scans/ply_values.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace interlock::dem
{
PlyValues::PlyValues(const InputFile& file, const PlyHeader& header)
    : file_(file), header_(header), data_(file.text().substr(header.data)),
      text_(file, data_, "", header.data_line)
{
}

double PlyValues::next(const PlyHeader::Type& type)
{
  return is_text() ? text_.number_or_nan(text_.word_on_any_line()) : next_binary(type);
}

void PlyValues::skip(const PlyHeader::Property& property)
{
  for (std::size_t k = property.is_list() ? next_count(property) : 1; k > 0; --k)
    if (is_text())
      text_.skip_word();
    else
      next_bytes(property.type);
}

std::size_t PlyValues::next_count(const PlyHeader::Property& list)
{
  const double count = next(list.count);
  const std::size_t left = data_.size() - (is_text() ? text_.position() : position_);
  if (!(count >= 0) || count != std::floor(count) ||
      count > static_cast<double>(left) / (is_text() ? 1 : list.type.size))
    file_.refuse("is damaged: a list is to have ", count, " entries in ", place(), ", but ", left,
                 " bytes are left.");
  return static_cast<std::size_t>(count);
}

void PlyValues::start_row(const PlyHeader::Element& element, std::size_t row)
{
  element_ = &element;
  row_ = row;
}

std::string PlyValues::place() const
{
  if (is_text()) return "line " + std::to_string(text_.line());
  return element_->name + " " + std::to_string(row_ + 1);
}

const char* PlyValues::next_bytes(const PlyHeader::Type& type)
{
  if (data_.size() - position_ < static_cast<std::size_t>(type.size))
    file_.refuse("is cut short: it ends in ", place(), " of ", element_->rows, ".");
  const char* bytes = data_.data() + position_;
  position_ += type.size;
  return bytes;
}

template <class T> double PlyValues::swapped(const char* bytes) const
{
  char buffer[sizeof(T)];
  std::memcpy(buffer, bytes, sizeof(T));
  if (header_.format == PlyHeader::Format::big_endian) std::reverse(buffer, buffer + sizeof(T));
  T value;
  std::memcpy(&value, buffer, sizeof(T));
  return static_cast<double>(value);
}

double PlyValues::next_binary(const PlyHeader::Type& type)
{
  using Type = PlyHeader::Type;
  const char* bytes = next_bytes(type);
  if (type.kind == Type::floating)
    return type.size == 4 ? swapped<float>(bytes) : swapped<double>(bytes);
  const bool has_sign = type.kind == Type::signed_integer;
  switch (type.size) {
  case 1:
    return has_sign ? swapped<std::int8_t>(bytes) : swapped<std::uint8_t>(bytes);
  case 2:
    return has_sign ? swapped<std::int16_t>(bytes) : swapped<std::uint16_t>(bytes);
  default:
    return has_sign ? swapped<std::int32_t>(bytes) : swapped<std::uint32_t>(bytes);
  }
}
} // namespace interlock::dem
