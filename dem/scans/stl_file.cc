#include "dem/scans/stl_file.h"

#include "dem/scans/text_scanner.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace interlock::dem
{
namespace
{
constexpr std::size_t head_size = 84, facet_size = 50; // [bytes]

void append_triangle(const std::array<Vector3, 3>& corners, TriangleMesh& mesh)
{
  const int first = static_cast<int>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), corners.begin(), corners.end());
  mesh.triangles.push_back({first, first + 1, first + 2});
}

// The file is little endian, as are all machines that this program is built for.
TriangleMesh read_binary(const InputFile& file, std::size_t facets)
{
  TriangleMesh mesh;
  mesh.vertices.reserve(3 * facets);
  mesh.triangles.reserve(facets);
  for (std::size_t f = 0; f < facets; ++f) {
    float values[12]; // normal and three corners
    std::memcpy(values, file.bytes().data() + head_size + f * facet_size, sizeof(values));
    std::array<Vector3, 3> corners;
    for (int k = 0; k < 3; ++k) {
      const float* v = values + 3 * (k + 1);
      if (!std::isfinite(v[0]) || !std::isfinite(v[1]) || !std::isfinite(v[2]))
        file.refuse("has a coordinate that is not a finite number in facet ", f + 1, ": (", v[0],
                    ", ", v[1], ", ", v[2], ").");
      corners[k] = Vector3(v[0], v[1], v[2]);
    }
    append_triangle(corners, mesh);
  }
  return mesh;
}

class TextReader
{
public:
  explicit TextReader(const InputFile& file) : file_(file), scanner_(file, file.bytes()) {}

  TriangleMesh read()
  {
    // One file may hold several solids; a title runs to the end of its line.
    while (read_solid()) {
    }
    return std::move(mesh_);
  }

private:
  static bool same(std::string_view word, std::string_view keyword)
  {
    return word.size() == keyword.size() &&
           std::equal(word.begin(), word.end(), keyword.begin(),
                      [](unsigned char a, char b) { return std::tolower(a) == b; });
  }

  void expect(std::string_view keyword) { check(scanner_.word_on_any_line(), keyword); }

  void check(std::string_view word, std::string_view keyword)
  {
    if (word.empty())
      file_.refuse("is cut short: it ends in line ", scanner_.line(), ", where '", keyword,
                   "' must be.");
    if (!same(word, keyword))
      file_.refuse("cannot be read as a mesh: ", quoted(word), " is in line ", scanner_.line(),
                   ", where '", keyword, "' must be.");
  }

  bool read_solid()
  {
    std::string_view word = scanner_.word_on_any_line();
    if (word.empty()) return false;
    check(word, "solid");
    scanner_.next_line();
    for (;;) {
      word = scanner_.word_on_any_line();
      if (same(word, "endsolid")) break;
      check(word, "facet");
      read_facet();
    }
    scanner_.next_line();
    return true;
  }

  void read_facet()
  {
    expect("normal");
    // Not read as numbers: writers put "nan" where a facet has no area.
    for (int k = 0; k < 3; ++k) scanner_.word_on_any_line();
    expect("outer");
    expect("loop");
    std::array<Vector3, 3> corners;
    for (Vector3& corner : corners) {
      expect("vertex");
      for (int k = 0; k < 3; ++k) corner[k] = scanner_.number(scanner_.word_on_any_line());
    }
    expect("endloop");
    expect("endfacet");
    append_triangle(corners, mesh_);
  }

  const InputFile& file_;
  TextScanner scanner_;
  TriangleMesh mesh_;
};
} // namespace

TriangleMesh read_stl(const InputFile& file)
{
  const std::string_view bytes = file.bytes();
  std::uint32_t facets = 0;
  if (bytes.size() >= head_size) {
    std::memcpy(&facets, bytes.data() + 80, sizeof(facets));
    if (bytes.size() == head_size + facet_size * facets) return read_binary(file, facets);
  }
  std::string_view start = bytes.substr(0, std::min<std::size_t>(bytes.size(), 1000));
  const bool is_text = std::none_of(start.begin(), start.end(),
                                    [](unsigned char c) { return c < 32 && !std::isspace(c); });
  if (is_text) return TextReader(file).read();
  if (bytes.size() < head_size)
    file.refuse("cannot be read as a mesh: it has ", bytes.size(),
                " bytes, but a binary STL file has at least ", head_size, ".");
  const std::uint64_t expected = head_size + std::uint64_t(facet_size) * facets;
  file.refuse("cannot be read as a mesh: a binary STL file of ", facets, " facets has ", expected,
              " bytes, but it has ", bytes.size(),
              bytes.size() < expected ? "; it is cut short or no STL file."
                                      : "; it is damaged or no STL file.");
}
} // namespace interlock::dem
