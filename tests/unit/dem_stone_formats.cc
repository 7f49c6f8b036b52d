// The same body in each format of a stone file. Fails when a variant that its format allows is not
// read, or when the counts of what was mended are wrong.
#include "dem/meshes/mass_properties.h"
#include "dem/scans/stone_file.h"
#include "tests/temporary_folder.h"

#include <algorithm>
#include <cstring>

namespace
{
using namespace interlock::dem;

class StoneFormats : public TemporaryFolderTest
{
protected:
  // A corner tetrahedron with legs of 30 mm: volume 30^3/6 mm3.
  void expect_tetrahedron(const std::string& name, const std::string& bytes,
                          MeshDiagnosis* diagnosis = nullptr) const
  {
    const TriangleMesh mesh = read_stone_mesh(write(name, bytes).string(), {}, diagnosis);
    EXPECT_EQ(mesh.vertices.size(), 4u) << name;
    EXPECT_EQ(mesh.triangles.size(), 4u) << name;
    EXPECT_NEAR(mass_properties(mesh).volume, 4.5e-6, 1e-11) << name;
  }
};

const double corners[4][3] = {{0, 0, 0}, {0.03, 0, 0}, {0, 0.03, 0}, {0, 0, 0.03}};
const int facets[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

template <class T> std::string bytes_of(T value, bool big_endian)
{
  std::string bytes(reinterpret_cast<const char*>(&value), sizeof(T));
  if (big_endian) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

// With properties and elements that a stone does not need before, between and behind.
std::string binary_ply(bool big_endian)
{
  std::string bytes = "ply\r\nformat " +
                      std::string(big_endian ? "binary_big_endian" : "binary_little_endian") +
                      " 1.0\ncomment by hand\nelement camera 1\nproperty list uint8 int16 shape\n"
                      "element vertex 4\nproperty uchar red\nproperty double x\nproperty float y\n"
                      "property float z\nelement face 4\nproperty list ushort uint vertex_index\n"
                      "property int8 part\nend_header\n";
  bytes += bytes_of<std::uint8_t>(2, big_endian) + bytes_of<std::int16_t>(-1, big_endian) +
           bytes_of<std::int16_t>(1, big_endian);
  for (const auto& x : corners)
    bytes += bytes_of<std::uint8_t>(255, big_endian) + bytes_of<double>(x[0], big_endian) +
             bytes_of<float>(static_cast<float>(x[1]), big_endian) +
             bytes_of<float>(static_cast<float>(x[2]), big_endian);
  for (const auto& facet : facets) {
    bytes += bytes_of<std::uint16_t>(3, big_endian);
    for (const int v : facet) bytes += bytes_of<std::uint32_t>(v, big_endian);
    bytes += bytes_of<std::int8_t>(-3, big_endian);
  }
  return bytes;
}

std::string text_stl(const std::string& line_end, bool upper_case)
{
  std::string text = "solid stone with a title" + line_end;
  for (const auto& facet : facets) {
    text += "  facet normal nan nan nan" + line_end + "    outer loop" + line_end;
    for (const int v : facet)
      text += "      vertex " + std::to_string(corners[v][0]) + " +" +
              std::to_string(corners[v][1]) + " " + std::to_string(corners[v][2]) + "e0" + line_end;
    text += "    endloop" + line_end + "  endfacet" + line_end;
  }
  text += "endsolid stone with a title" + line_end;
  if (upper_case)
    for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

TEST_F(StoneFormats, Ply)
{
  expect_tetrahedron("little.ply", binary_ply(false));
  expect_tetrahedron("big.PLY", binary_ply(true));
}

TEST_F(StoneFormats, TextStl)
{
  expect_tetrahedron("unix.stl", text_stl("\n", false));
  expect_tetrahedron("windows.stl", text_stl("\r\n", false));
  expect_tetrahedron("capitals.STL", text_stl("\n", true));
}

TEST_F(StoneFormats, BinaryStlThatStartsLikeText)
{
  std::string bytes = "solid is what some writers put here";
  bytes.resize(80, '\0');
  bytes += bytes_of<std::uint32_t>(6, false);
  // One facet twice, and one without area.
  const int more[6][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}, {3, 1, 2}, {1, 1, 2}};
  for (const auto& facet : more) {
    bytes += std::string(12, '\0');
    for (const int v : facet)
      for (const double x : corners[v]) bytes += bytes_of<float>(static_cast<float>(x), false);
    bytes += "ab"; // attributes
  }
  MeshDiagnosis diagnosis;
  expect_tetrahedron("a.stl", bytes, &diagnosis);
  EXPECT_EQ(diagnosis.facets_read, 6);
  EXPECT_EQ(diagnosis.vertices_merged, 18 - 4);
  EXPECT_EQ(diagnosis.duplicate_facets_dropped, 1);
  EXPECT_EQ(diagnosis.degenerate_facets_dropped, 1);
}

TEST_F(StoneFormats, ObjWithTexturesBackwardIndicesAndContinuedLines)
{
  expect_tetrahedron("a.obj", "# by hand\nmtllib a.mtl\no stone\nv 0 0 0 1 0 0\nv 0.03 0 0\n"
                              "v 0 0.03 0\nv 0 0 0.03\nvt 0 0\nvn 0 0 1\ns off\nf 1/1 3/1 2/1\n"
                              "f 1//1 2//1 4//1\nf -4/1/1 -1/1/1 -2/1/1\nf 2 3 \\\n 4\n");
}

TEST_F(StoneFormats, PolygonsAreCutFromACornerThatSeesThemAll)
{
  // A prism of 20 mm height over an arrow head, whose notch (third corner) alone sees all corners.
  const auto file = write("arrow.obj", "v 0 0 0\nv 0.02 0.02 0\nv 0.01 0 0\nv 0.02 -0.02 0\n"
                                       "v 0 0 0.02\nv 0.02 0.02 0.02\nv 0.01 0 0.02\n"
                                       "v 0.02 -0.02 0.02\nf 1 2 3 4\nf 8 7 6 5\nf 2 1 5 6\n"
                                       "f 3 2 6 7\nf 4 3 7 8\nf 1 4 8 5\n");
  const TriangleMesh mesh = read_stone_mesh(file.string(), 1);
  EXPECT_EQ(mesh.triangles.size(), 12u);
  EXPECT_NEAR(mass_properties(mesh).volume, 0.01 * 0.02 * 0.02, 1e-12);
  // Cut wrongly, the area of the two arrow heads would be larger than 2 x 2 cm2.
  double flat = 0;
  for (const auto& t : mesh.triangles) {
    const Vector3 a = mesh.vertices[t[0]];
    flat += std::abs((mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a).z()) / 2;
  }
  EXPECT_NEAR(flat, 2 * 0.01 * 0.02, 1e-12);
}
} // namespace
