#include "dem/scans/obj_file.h"

#include "dem/scans/facet_polygon.h"
#include "dem/scans/text_scanner.h"

#include <algorithm>

namespace interlock::dem
{
namespace
{
// Keywords that say nothing about the surface. Free-form curves and surfaces are not among them: a
// file that has some would lose a part of its body.
bool is_skipped(std::string_view keyword)
{
  static const std::string_view known[] = {
      "vt",     "vn",       "vp",       "g",          "o",        "s",      "usemtl",
      "mtllib", "l",        "p",        "mg",         "lod",      "usemap", "maplib",
      "bevel",  "c_interp", "d_interp", "shadow_obj", "trace_obj"};
  return keyword.empty() || keyword[0] == '#' ||
         std::find(std::begin(known), std::end(known), keyword) != std::end(known);
}

// Of these the ones with numbers, which may go on in the next line. Names are not looked at: a path
// may end with a backslash.
bool has_numbers(std::string_view keyword)
{
  return keyword == "vt" || keyword == "vn" || keyword == "vp" || keyword == "l" || keyword == "p";
}

class Reader
{
public:
  explicit Reader(const InputFile& file) : file_(file), scanner_(file, file.text()) {}

  TriangleMesh read()
  {
    do {
      const std::string_view keyword = scanner_.word();
      if (keyword == "v")
        read_vertex();
      else if (keyword == "f")
        read_facet();
      else if (has_numbers(keyword))
        skip_rest();
      else if (!is_skipped(keyword))
        file_.refuse("cannot be read as a mesh: ", quoted(keyword), " starts line ",
                     scanner_.line(), ", where OBJ has a keyword such as v or f.");
    } while (scanner_.next_line());
    return std::move(mesh_);
  }

private:
  // The next word of this line or, where it ends with a backslash, of the line that continues it.
  // Empty at its end, and at a comment behind the numbers.
  std::string_view word()
  {
    for (;;) {
      if (is_continued_) {
        if (!scanner_.word().empty())
          file_.refuse("has a '\\' in the middle of line ", scanner_.line(),
                       ", but it must end its line.");
        is_continued_ = false;
        if (!scanner_.next_line()) return {};
      }
      std::string_view result = scanner_.word();
      if (result.empty() || result[0] == '#') return {};
      is_continued_ = result.back() == '\\';
      if (is_continued_) result.remove_suffix(1);
      if (!result.empty()) return result;
    }
  }

  void skip_rest()
  {
    while (!word().empty()) {
    }
  }

  void read_vertex()
  {
    Vector3 x;
    for (int k = 0; k < 3; ++k) x[k] = scanner_.number_or_nan(word());
    mesh_.vertices.push_back(x);
    skip_rest(); // a weight or a colour
  }

  // A corner is v, v/vt, v//vn or v/vt/vn; from 1, or backwards from the last vertex with -1.
  void read_facet()
  {
    corners_.clear();
    const long long vertices = static_cast<long long>(mesh_.vertices.size());
    for (std::string_view corner = word(); !corner.empty(); corner = word()) {
      const long long number = scanner_.integer(corner.substr(0, corner.find('/')));
      if (number == 0 || number > vertices || number < -vertices)
        file_.refuse("has a facet with the vertex ", number, " in line ", scanner_.line(), ", but ",
                     vertices, " vertices stand above it.");
      corners_.push_back(static_cast<int>(number > 0 ? number - 1 : vertices + number));
      if (!mesh_.vertices[corners_.back()].allFinite())
        file_.refuse("has a coordinate that is not a finite number at vertex ", corners_.back() + 1,
                     ", which the facet in line ", scanner_.line(), " uses.");
    }
    const std::string fault = append_polygon(corners_, mesh_);
    if (!fault.empty())
      file_.refuse("has ", fault, " in line ", scanner_.line(), ": save the mesh with triangles.");
  }

  const InputFile& file_;
  TextScanner scanner_;
  bool is_continued_ = false; // the line, behind the word that was read last
  std::vector<int> corners_;
  TriangleMesh mesh_;
};
} // namespace

TriangleMesh read_obj(const InputFile& file)
{
  return Reader(file).read();
}
} // namespace interlock::dem
