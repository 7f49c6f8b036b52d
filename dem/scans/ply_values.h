// The data of a PLY file behind its header.
#pragma once

#include "dem/scans/ply_file.h"
#include "dem/scans/text_scanner.h"

namespace interlock::dem
{
// A row of numbers, whatever the format. Keeps references to the file and to its header. Throws
// InputError where the data ends too early or a text holds something else than a number.
class PlyValues
{
public:
  PlyValues(const InputFile& file, const PlyHeader& header);

  // May be infinite or none ("nan"): that is a fault only where the value is used.
  double next(const PlyHeader::Type& type);
  // Passes a value, or all of a list, that nobody asks for and that may be anything.
  void skip(const PlyHeader::Property& property);
  // The number of entries of a list, each of which takes bytes from what is left.
  std::size_t next_count(const PlyHeader::Property& list);

  // To be called in front of each row, for place(): "line 12", or "vertex 3" in binary data.
  void start_row(const PlyHeader::Element& element, std::size_t row);
  std::string place() const;

private:
  bool is_text() const { return header_.format == PlyHeader::Format::text; }
  const char* next_bytes(const PlyHeader::Type& type);
  double next_binary(const PlyHeader::Type& type);
  template <class T> double swapped(const char* bytes) const;

  const InputFile& file_;
  const PlyHeader& header_;
  std::string_view data_;
  TextScanner text_;
  std::size_t position_ = 0; // in binary data
  const PlyHeader::Element* element_ = nullptr;
  std::size_t row_ = 0;
};
} // namespace interlock::dem
