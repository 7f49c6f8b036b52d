// Text of STL files: read_text_stl of stl_file.h.
#include "dem/scans/stl_file.h"
#include "dem/scans/text_scanner.h"

#include <algorithm>
#include <cctype>

namespace interlock::dem
{
namespace
{
class TextReader
{
public:
  explicit TextReader(const InputFile& file) : file_(file), scanner_(file, file.text()) {}

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

TriangleMesh read_text_stl(const InputFile& file)
{
  return TextReader(file).read();
}
} // namespace interlock::dem
