// Header of PLY files: read_ply_header of ply_file.h.
#include "dem/scans/ply_file.h"
#include "dem/scans/text_scanner.h"

#include <map>

namespace interlock::dem
{
namespace
{
PlyHeader::Type type_of(const InputFile& file, const TextScanner& scanner, std::string_view word)
{
  using Type = PlyHeader::Type;
  static const std::map<std::string_view, Type> types = {
      {"char", {1, Type::signed_integer}},     {"int8", {1, Type::signed_integer}},
      {"uchar", {1, Type::unsigned_integer}},  {"uint8", {1, Type::unsigned_integer}},
      {"short", {2, Type::signed_integer}},    {"int16", {2, Type::signed_integer}},
      {"ushort", {2, Type::unsigned_integer}}, {"uint16", {2, Type::unsigned_integer}},
      {"int", {4, Type::signed_integer}},      {"int32", {4, Type::signed_integer}},
      {"uint", {4, Type::unsigned_integer}},   {"uint32", {4, Type::unsigned_integer}},
      {"float", {4, Type::floating}},          {"float32", {4, Type::floating}},
      {"double", {8, Type::floating}},         {"float64", {8, Type::floating}},
  };
  const auto found = types.find(word);
  if (found == types.end())
    file.refuse("has the type ", quoted(word), " in line ", scanner.line(),
                " of its header, which PLY does not know.");
  return found->second;
}

PlyHeader::Format format_of(const InputFile& file, std::string_view word)
{
  if (word == "ascii") return PlyHeader::Format::text;
  if (word == "binary_little_endian") return PlyHeader::Format::little_endian;
  if (word == "binary_big_endian") return PlyHeader::Format::big_endian;
  file.refuse("has the format ", quoted(word),
              ", but must be ascii, binary_little_endian or binary_big_endian.");
}

PlyHeader::Property property_of(const InputFile& file, TextScanner& scanner)
{
  PlyHeader::Property property;
  std::string_view word = scanner.word();
  if (word == "list") {
    property.count = type_of(file, scanner, scanner.word());
    if (property.count.kind == PlyHeader::Type::floating)
      file.refuse("counts the entries of a list with a floating-point number in line ",
                  scanner.line(), " of its header.");
    word = scanner.word();
  }
  property.type = type_of(file, scanner, word);
  property.name = scanner.word();
  return property;
}

// Each row has a number of bytes at least: a claim of more rows than fit would allocate for
// nothing.
void check_rows(const InputFile& file, const PlyHeader& header)
{
  std::size_t left = file.text().size() - header.data;
  for (const PlyHeader::Element& element : header.elements) {
    std::size_t least = 0; // bytes of a row; one for each value in a text
    for (const PlyHeader::Property& property : element.properties)
      least += header.format == PlyHeader::Format::text ? 1
               : property.is_list()                     ? property.count.size
                                                        : property.type.size;
    if (element.rows == 0 || least == 0) continue;
    if (element.rows > left / least)
      file.refuse("is cut short or damaged: its header promises ", element.rows, " rows of ",
                  quoted(element.name), ", at least ", least, " bytes each, but ", left,
                  " bytes are left for them.");
    left -= least * element.rows;
  }
}

void check_vertices(const InputFile& file, const PlyHeader& header)
{
  std::vector<std::string> names;
  for (const PlyHeader::Element& element : header.elements) {
    if (element.is_named("vertex")) return;
    if (element.is_facet() && element.rows > 0 && header.rows("vertex") > 0)
      file.refuse("has its facets in front of its vertices; save it with the vertices first.");
    names.push_back(element.name);
  }
  file.refuse("has no element 'vertex' in its header, but ", listed(names), ".");
}
} // namespace

PlyHeader read_ply_header(const InputFile& file)
{
  PlyHeader header;
  TextScanner scanner(file, file.text());
  if (scanner.word() != "ply" || !scanner.next_line())
    file.refuse("cannot be read as a mesh: a PLY file starts with a line 'ply'.");
  bool has_format = false;
  for (std::string_view word = scanner.word(); word != "end_header"; word = scanner.word()) {
    if (word == "format") {
      header.format = format_of(file, scanner.word());
      has_format = true;
    } else if (word == "element") {
      header.elements.emplace_back();
      header.elements.back().name = scanner.word();
      const long long rows = scanner.integer(scanner.word());
      if (rows < 0) file.refuse("has ", rows, " rows of an element in line ", scanner.line(), ".");
      header.elements.back().rows = static_cast<std::size_t>(rows);
    } else if (word == "property") {
      if (header.elements.empty())
        file.refuse("has a property in front of the first element in line ", scanner.line(), ".");
      header.elements.back().properties.push_back(property_of(file, scanner));
    } else if (word != "comment" && word != "obj_info" && !word.empty()) {
      file.refuse("cannot be read as a mesh: ", quoted(word), " is in line ", scanner.line(),
                  " of its header, where PLY has a keyword.");
    }
    if (!scanner.next_line()) file.refuse("is cut short: its header has no end.");
  }
  if (!has_format) file.refuse("has no line 'format' in its header.");
  scanner.next_line();
  header.data = scanner.position();
  header.data_line = scanner.line();
  check_rows(file, header);
  check_vertices(file, header);
  return header;
}
} // namespace interlock::dem
