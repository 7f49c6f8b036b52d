// A file whose content is not what its extension says, or that stops half-way, is refused in one
// sentence that says what and where. Fails when such a file passes or its place is not named.
#include "dem/scans/stone_file.h"
#include "tests/dem_solids.h"
#include "tests/refusal.h"
#include "tests/temporary_folder.h"

namespace
{
using namespace interlock::dem;

class StoneContent : public TemporaryFolderTest
{
protected:
  void expect_refused(const std::string& name, const std::string& bytes,
                      const std::vector<std::string>& facts) const
  {
    const std::string file = write(name, bytes).string();
    expect_refusal([&] { read_stone_mesh(file, 1); }, file, facts);
  }
};

std::string ply(const std::string& format, const std::string& body, int vertices = 3, int faces = 1)
{
  return "ply\nformat " + format + " 1.0\nelement vertex " + std::to_string(vertices) +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
         std::to_string(faces) + "\nproperty list uchar int vertex_indices\nend_header\n" + body;
}

TEST_F(StoneContent, Empty)
{
  for (const char* name : {"a.stl", "a.ply", "a.obj"}) expect_refused(name, "", {"is empty"});
}

TEST_F(StoneContent, OtherFormats)
{
  expect_refused("photo.stl", "\xFF\xD8\xFF\xE0 JFIF and more", {".stl", "a JPEG picture"});
  expect_refused("scan.obj", "PK\3\4 and more", {".obj", "a zip archive"});
  expect_refused("scan.stl", ply("ascii", ""), {"a PLY file", "rename it"});
  expect_refused("scan.ply", "solid a\nfacet normal 0 0 1\n", {"an STL mesh", "rename it"});
  expect_refused("page.obj", "<!DOCTYPE html>", {"a web page"});
  expect_refused("._a.stl", std::string("\0\5\x16\7\0\2\0\0Mac OS X", 16),
                 {"a Mac", "AppleDouble"});
}

// A byte order mark hides nothing, and text of two bytes a character is called so.
TEST_F(StoneContent, Encodings)
{
  using namespace std::literals;
  expect_refused("a.obj", "\xEF\xBB\xBFv 0 zero 0\n", {"'zero' in line 1"});
  expect_refused("b.obj", "\xEF\xBB\xBF<html>", {"a web page"});
  expect_refused("a.stl", "\xFF\xFEs\0o\0l\0i\0"s, {"text in UTF-16", "UTF-8 or ASCII"});
  expect_refused("b.stl", "s\0o\0l\0i\0d\0 \0"s, {"text in UTF-16"});
  expect_refused("c.obj", "\xFE\xFF\0v\0 \0000"s, {"text in UTF-16"});
  expect_refused("c.ply", "\0p\0l\0y\0\n"s, {"text in UTF-16"});
  expect_refused("d.ply", "\xFF\xFE\0\0p\0\0\0"s, {"text in UTF-32"});
}

// Lines are counted as an editor counts them, whatever ends them.
TEST_F(StoneContent, LinesAreCountedWithAnyEnd)
{
  for (const std::string end : {"\n", "\r\n", "\r", "\r\r\n"})
    expect_refused("a.obj", "v 0 0 0" + end + end + "v 0 zero 0" + end, {"'zero' in line 3"});
}

TEST_F(StoneContent, BinaryStlOfAnotherLength)
{
  write_stl((folder / "a.stl").string(), solids::octahedron(0.04));
  std::ifstream in(folder / "a.stl", std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(in), {});
  expect_refused("short.stl", bytes.substr(0, 300),
                 {"8 facets has 484 bytes, but it has 300", "cut short"});
  // Behind the last facet something of the size of a facet that may be one.
  const std::string more = "0123456789012345678901234567890123456789 and on and on";
  expect_refused("long.stl", bytes + more, {"8 facets has 484 bytes, but it has 538", "damaged"});
}

TEST_F(StoneContent, TextStl)
{
  const std::string start = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n";
  expect_refused("short.stl", start, {"cut short", "line 5", "'vertex'"});
  expect_refused("word.stl", start + "vertex 1 two 3\n", {"'two' in line 5", "number"});
  expect_refused("comma.stl", start + "vertex 1 0,5 3\n", {"'0,5' in line 5"});
  expect_refused("inf.stl", start + "vertex 1 inf 3\n", {"'inf'", "finite", "line 5"});
  expect_refused("keyword.stl", start + "vortex 1 0 3\n", {"'vortex' is in line 5", "'vertex'"});
  expect_refused("none.stl", "solid a\nendsolid a\n", {"has no facet"});
}

TEST_F(StoneContent, Ply)
{
  expect_refused("cut.ply", "ply\nformat ascii 1.0\n", {"header has no end"});
  expect_refused("claim.ply", ply("ascii", "0 0 0\n", 2000000000), {"2000000000 rows", "bytes"});
  expect_refused("index.ply", ply("ascii", "0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"),
                 {"vertex 3", "line 13", "0 to 2"});
  expect_refused("nan.ply", ply("ascii", "0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n"),
                 {"(1, nan, 0)", "finite", "in line 11", "line 13 uses"});
  expect_refused("type.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty half x\n",
                 {"type 'half'", "line 4"});
  expect_refused("format.ply", "ply\nformat binary 1.0\n", {"'binary'", "binary_little_endian"});
  expect_refused("cloud.ply", ply("ascii", "0 0 0\n1 0 0\n0 1 0\n", 3, 0),
                 {"no facet", "cloud of 3 points"});
  expect_refused("binary.ply",
                 ply("binary_little_endian", std::string("\0\0\x80\x7F", 4) +
                                                 std::string(8 + 24, '\0') + "\3" +
                                                 std::string(12, '\0')),
                 {"(inf, 0, 0)", "in vertex 1", "face 1 uses"});
  expect_refused("names.ply",
                 "ply\nformat ascii 1.0\nelement vertex 1\nproperty float easting\n"
                 "property float y\nproperty float z\nelement face 1\n"
                 "property list uchar int vertex_indices\nend_header\n0 0 0\n3 0 0 0\n",
                 {"without the coordinate 'x'", "they have 'easting', 'y' and 'z'"});
  expect_refused("list.ply",
                 "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
                 "property float z\nelement face 1\nproperty list uchar int corners\nend_header\n"
                 "0 0 0\n3 0 0 0\n",
                 {"without a list 'vertex_indices'", "they have 'corners'"});
  expect_refused("order.ply",
                 "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_indices\n"
                 "element vertex 1\nproperty float x\nend_header\n3 0 0 0\n0\n",
                 {"its facets in front of its vertices"});
  expect_refused("points.ply",
                 "ply\nformat ascii 1.0\nelement point 1\nproperty float x\nend_header\n0\n",
                 {"no element 'vertex'", "but 'point'"});
  expect_refused(
      "element.ply",
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
      "property float z\nelement triangles 1\nproperty list uchar int vertex_indices\n"
      "end_header\n0 0 0\n3 0 0 0\n",
      {"no facet", "cloud of 1 points", "with an element 'triangles', which is not read"});
  // 36 bytes of vertices, then a list of 255 corners with 13 bytes behind it.
  expect_refused(
      "list.ply",
      ply("binary_little_endian", std::string(36, '\0') + "\xFF" + std::string(13, '\0')),
      {"255 entries", "face 1"});
}

TEST_F(StoneContent, Obj)
{
  expect_refused("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n",
                 {"vertex 4", "line 4", "3 vertices"});
  expect_refused("b.obj", "v 0 0 0\nf 0 1 1\n", {"vertex 0", "line 2"});
  expect_refused("c.obj", "v 0 zero 0\n", {"'zero' in line 1"});
  expect_refused("d.obj", "v 0 0\n", {"missing in line 1"});
  expect_refused("nan.obj", "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n",
                 {"not a finite number at vertex 2", "line 4"});
  expect_refused("middle.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 \\ 2 3\n", {"'\\'", "line 4"});
  expect_refused("e.obj", "v 0 0 0\ncurv 0 1 2\n", {"'curv' starts line 2"});
  // A square with its last corner pushed in behind two others: no corner sees the whole facet.
  expect_refused("f.obj",
                 "v 0 0 0\nv 3 0 0\nv 3 3 0\nv 2 3 0\nv 2 1 0\nv 1 1 0\nv 1 3 0\nv 0 3 0\n"
                 "f 1 2 3 4 5 6 7 8\n",
                 {"concave facet with 8 corners in line 9"});
}
} // namespace
