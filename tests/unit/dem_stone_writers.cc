// What writers of stone files do within their format or a hand's breadth beside it: byte order
// marks, line ends, values that nobody uses, strips, counts that were never filled in. The same
// tetrahedron each time. Fails when a variant is not read, is read as another body, or goes without
// its note.
#include "dem/meshes/mass_properties.h"
#include "dem/scans/stone_file.h"
#include "tests/temporary_folder.h"

#include <cstring>

namespace
{
using namespace interlock::dem;

class StoneWriters : public TemporaryFolderTest
{
protected:
  // A corner tetrahedron with legs of 30 mm: volume 30^3/6 mm3. Expects `notes` of the reader.
  void expect_tetrahedron(const std::string& name, const std::string& bytes,
                          const std::vector<std::string>& notes = {}) const
  {
    MeshDiagnosis found;
    TriangleMesh mesh;
    ASSERT_NO_THROW(mesh = read_stone_mesh(write(name, bytes).string(), {}, &found)) << name;
    EXPECT_EQ(mesh.vertices.size(), 4u) << name;
    EXPECT_EQ(mesh.triangles.size(), 4u) << name;
    EXPECT_NEAR(mass_properties(mesh).volume, 4.5e-6, 1e-11) << name;
    ASSERT_EQ(found.notes.size(), notes.size()) << name;
    for (std::size_t k = 0; k < notes.size(); ++k)
      EXPECT_NE(found.notes[k].find(notes[k]), std::string::npos) << found.notes[k];
  }
};

const std::string mark = "\xEF\xBB\xBF";
const double corners[4][3] = {{0, 0, 0}, {0.03, 0, 0}, {0, 0.03, 0}, {0, 0, 0.03}};
const int facets[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
const std::string obj =
    "v 0 0 0\nv 0.03 0 0\nv 0 0.03 0\nv 0 0 0.03\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
const std::string points = "0 0 0\n0.03 0 0\n0 0.03 0\n0 0 0.03\n";

std::string with_line_ends(std::string text, const std::string& end)
{
  for (std::size_t k = text.find('\n'); k != std::string::npos; k = text.find('\n', k + end.size()))
    text.replace(k, 1, end);
  return text;
}

std::string text_stl()
{
  std::string text = "solid stone\n";
  for (const auto& facet : facets) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const int v : facet)
      text += "vertex " + std::to_string(corners[v][0]) + " " + std::to_string(corners[v][1]) +
              " " + std::to_string(corners[v][2]) + "\n";
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid\n";
}

// `more` are further properties of the vertices, `rows` the data of all elements.
std::string text_ply(const std::string& more, const std::string& rows)
{
  return "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
         "property float z\n" +
         more + "element face 4\nproperty list uchar int vertex_indices\nend_header\n" + rows;
}
const std::string ply_facets = "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";

template <class T> std::string bytes_of(T value)
{
  return {reinterpret_cast<const char*>(&value), sizeof(T)};
}

std::string binary_stl(const std::string& title, std::uint32_t count)
{
  std::string bytes = title;
  bytes.resize(80, ' ');
  bytes += bytes_of(count);
  for (const auto& facet : facets) {
    bytes += std::string(12, '\0');
    for (const int v : facet)
      for (const double x : corners[v]) bytes += bytes_of(static_cast<float>(x));
    bytes += std::string(2, '\0');
  }
  return bytes;
}

TEST_F(StoneWriters, ByteOrderMark)
{
  expect_tetrahedron("a.obj", mark + obj);
  expect_tetrahedron("a.stl", mark + text_stl());
  expect_tetrahedron("a.ply", mark + text_ply("", points + ply_facets));
}

TEST_F(StoneWriters, LineEnds)
{
  for (const std::string end : {"\r", "\r\n", "\r\r\n"}) {
    expect_tetrahedron("a.obj", with_line_ends(obj, end));
    expect_tetrahedron("a.stl", with_line_ends(text_stl(), end));
    expect_tetrahedron("a.ply", with_line_ends(text_ply("", points + ply_facets), end));
  }
}

// The first byte behind the header is that of a line feed.
TEST_F(StoneWriters, BinaryPlyBehindAHeaderWithCarriageReturns)
{
  std::string bytes =
      with_line_ends("ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty uchar red\n"
                     "property double x\nproperty double y\nproperty double z\nelement face 4\n"
                     "property list uchar int vertex_indices\nend_header\n",
                     "\r");
  for (const auto& x : corners) {
    bytes += "\n";
    for (const double value : x) bytes += bytes_of(value);
  }
  for (const auto& facet : facets) {
    bytes += '\3';
    for (const int v : facet) bytes += bytes_of(v);
  }
  expect_tetrahedron("a.ply", bytes);
  expect_tetrahedron("b.ply", mark + bytes);
}

TEST_F(StoneWriters, ValuesThatNobodyUsesMayBeAnything)
{
  expect_tetrahedron("quality.ply", text_ply("property float quality\n",
                                             "0 0 0 nan\n0.03 0 0 -nan(ind)\n0 0.03 0 1.#QNAN\n"
                                             "0 0 0.03 -inf\n" +
                                                 ply_facets));
  expect_tetrahedron("normal.ply",
                     text_ply("property float nx\nproperty float ny\nproperty float nz\n",
                              "0 0 0 nan nan nan\n0.03 0 0 0 0 0\n0 0.03 0 0 0 1\n"
                              "0 0 0.03 0 0 1\n" +
                                  ply_facets));
  expect_tetrahedron("list.ply", text_ply("property list uchar float weights\n",
                                          "0 0 0 2 nan 1\n0.03 0 0 0\n0 0.03 0 1 inf\n"
                                          "0 0 0.03 0\n" +
                                              ply_facets));
  expect_tetrahedron("weight.obj", "v 0 0 0 nan\nv 0.03 0 0\nv 0 0.03 0\nv 0 0 0.03\nvn nan 0 0\n"
                                   "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
}

// Scanners that see no surface in a direction write a vertex that is no place, and no facet to it.
TEST_F(StoneWriters, VerticesThatNoFacetUsesMayBeAnything)
{
  expect_tetrahedron("a.obj", "v nan nan nan\n" +
                                  with_line_ends(obj.substr(0, obj.find('f')), "\n") +
                                  "f -4 -2 -3\nf -4 -3 -1\nf -4 -1 -2\nf -3 -2 -1\n");
  std::string text = text_ply("", points + "nan inf 0\n" + ply_facets);
  text.replace(text.find("vertex 4"), 8, "vertex 5");
  expect_tetrahedron("a.ply", text);
}

TEST_F(StoneWriters, TriangleStrips)
{
  const std::string head = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\n"
                           "property float y\nproperty float z\nelement tristrips 2\n"
                           "property list int int vertex_indices\nend_header\n";
  // The first four corners make two facets that turn the same way seen from outside.
  expect_tetrahedron("a.ply", head + points + "8 0 2 1 3 -1 0 1 3\n4 0 3 2 -1\n");
}

TEST_F(StoneWriters, NamesInCapitals)
{
  std::string text = text_ply("", points + ply_facets);
  for (const std::string name : {"vertex 4", "float x", "float y", "float z", "face", "vertex_ind"})
    for (std::size_t k = text.find(name) + (name.substr(0, 5) == "float" ? 6 : 0),
                     end = text.find(name) + name.size();
         k < end; ++k)
      text[k] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[k])));
  expect_tetrahedron("a.ply", text);
}

TEST_F(StoneWriters, ObjLinesThatGoOn)
{
  expect_tetrahedron("a.obj",
                     "v 0 0\\\n0\nv 0.03 0 0\\\r\n 1\nv 0 0.03 0 # third\nv 0 0 0.03\n"
                     "vn 0 0 \\\n1\nusemtl C:\\rock\\\nf 1 3\\\n2\nf 1\\\n2\\\n4\nf 1 4 3\\\n"
                     "\nf 2 3 4 # last\n");
}

TEST_F(StoneWriters, BinaryStlWhoseCountIsNoCount)
{
  expect_tetrahedron("zero.stl", binary_stl("stream", 0), {"promises 0 facets"});
  expect_tetrahedron("most.stl", binary_stl("stream", 0xFFFFFFFFu), {"fit its length, 4,"});
}

TEST_F(StoneWriters, BinaryStlWithPadding)
{
  expect_tetrahedron("two.stl", binary_stl("a", 4) + std::string(2, '\0'), {"2 bytes behind"});
  expect_tetrahedron("sector.stl", binary_stl("a", 4) + std::string(512, '\0'), {"512 bytes"});
  expect_tetrahedron("word.stl", binary_stl("a", 4) + "more", {"4 bytes behind its last facet"});
}

TEST_F(StoneWriters, BinaryStlWithTheTitleOfAnotherFormat)
{
  expect_tetrahedron("a.stl", binary_stl("{ \"made\": \"by hand\" }", 4));
  expect_tetrahedron("b.stl", binary_stl("solid facet normal", 4));
}
} // namespace
