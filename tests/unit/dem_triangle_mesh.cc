// Diagnosis, normals and files of triangle meshes. Fails when an open, flipped or branching edge
// goes unseen, when node normals depend on how faces are cut, or when a mesh does not survive its
// file: vertices not merged, unit not applied, degenerate facets or loose vertices kept.
#include "dem/meshes/mass_properties.h"
#include "dem/meshes/triangle_mesh.h"
#include "tests/dem_solids.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace
{
using namespace interlock::dem;
namespace fs = std::filesystem;

std::string write_text(const std::string& name, const std::string& text)
{
  const std::string path = (fs::path(testing::TempDir()) / ("interlock_mesh_" + name)).string();
  std::ofstream(path) << text;
  return path;
}

TEST(TriangleMesh, SoundSurfacesHaveNoOpenEdge)
{
  EXPECT_EQ(count_open_edges(solids::box(1, 2, 3)), 0);
  EXPECT_EQ(count_open_edges(solids::subdivide(solids::octahedron(1), 5)), 0);
  EXPECT_EQ(count_open_edges(solids::inside_out(solids::box(1, 2, 3))), 0);
}

TEST(TriangleMesh, EdgesAreCountedByFault)
{
  TriangleMesh mesh = solids::octahedron(1);
  mesh.triangles.pop_back();
  EXPECT_EQ(diagnose_edges(mesh).open, 3);
  EXPECT_EQ(count_open_edges(mesh), 3);

  mesh = solids::octahedron(1);
  std::swap(mesh.triangles[0][1], mesh.triangles[0][2]);
  EXPECT_EQ(diagnose_edges(mesh).flipped, 3);
  EXPECT_EQ(diagnose_edges(mesh).open, 0);

  mesh = solids::octahedron(1);
  mesh.triangles.push_back({0, 2, 1}); // a wall inside: edge 0-2 and 2-1 get a third facet
  EXPECT_EQ(diagnose_edges(mesh).branching, 2);
  EXPECT_EQ(diagnose_edges(mesh).open, 1);
}

TEST(TriangleMesh, NormalsOfACubeDoNotDependOnItsDiagonals)
{
  const TriangleMesh cube = solids::subdivide(solids::box(2, 2, 2), 4);
  const auto normals = node_normals(cube);
  for (std::size_t i = 0; i < normals.size(); ++i) {
    // On the surface exactly the coordinates at +-1 belong to a face that meets here.
    Vector3 exact = Vector3::Zero();
    for (int k = 0; k < 3; ++k)
      if (std::abs(std::abs(cube.vertices[i][k]) - 1) < 1e-12) exact[k] = cube.vertices[i][k];
    EXPECT_LT((normals[i] - exact.normalized()).norm(), 1e-12) << cube.vertices[i].transpose();
  }
}

TEST(TriangleMesh, AreaAndExtents)
{
  EXPECT_NEAR(surface_area(solids::box(1, 2, 3)), 22, 1e-12);
  EXPECT_LT((extents(solids::box(1, 2, 3)) - Vector3(1, 2, 3)).norm(), 1e-12);
  EXPECT_EQ(extents(TriangleMesh()).norm(), 0);
}

TEST(StoneFile, StlComesBackClosed)
{
  const TriangleMesh mesh = solids::subdivide(solids::octahedron(0.04), 6);
  const std::string path = (fs::path(testing::TempDir()) / "interlock_octahedron.stl").string();
  write_stl(path, mesh);
  EXPECT_EQ(fs::file_size(path), 84 + 50 * mesh.triangles.size());
  EXPECT_FALSE(fs::exists(path + ".tmp"));
  const TriangleMesh copy = read_stone_mesh(path, 1);
  ASSERT_EQ(copy.vertices.size(), mesh.vertices.size());
  ASSERT_EQ(copy.triangles.size(), mesh.triangles.size());
  EXPECT_EQ(count_open_edges(copy), 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k)
      EXPECT_LT((copy.vertices[copy.triangles[t][k]] - mesh.vertices[mesh.triangles[t][k]]).norm(),
                1e-7 * 0.04);
}

TEST(StoneFile, ObjInMillimetresWithQuadsGroupsAndLooseVertices)
{
  // A 20 mm cube; two groups, and a vertex that nothing uses.
  const std::string path = write_text(
      "cube.obj", "v 0 0 0\nv 20 0 0\nv 20 20 0\nv 0 20 0\nv 0 0 20\nv 20 0 20\nv 20 20 20\n"
                  "v 0 20 20\nv 500 0 0\ng a\nf 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\ng b\nf 2 3 7 6\n"
                  "f 3 4 8 7\nf 4 1 5 8\n");
  const TriangleMesh cube = read_stone_mesh(path, 0.001);
  EXPECT_EQ(cube.vertices.size(), 8u);
  EXPECT_EQ(cube.triangles.size(), 12u);
  EXPECT_NEAR(mass_properties(cube).volume, 8e-6, 1e-12);
}

TEST(StoneFile, PlyWithADegenerateFacetAndDoubleVertices)
{
  // A corner tetrahedron of 30 mm whose base has its own copy of the corner at the origin (vertex
  // 4), and a facet without area.
  const std::string path = write_text(
      "tetrahedron.ply",
      "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\n"
      "property float z\nelement face 5\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0\n0.03 0 0\n0 0.03 0\n0 0 0.03\n0 0 0\n"
      "3 4 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n3 0 4 1\n");
  const TriangleMesh body = read_stone_mesh(path, 1);
  EXPECT_EQ(body.vertices.size(), 4u);
  EXPECT_EQ(body.triangles.size(), 4u);
  EXPECT_NEAR(mass_properties(body).volume, 4.5e-6, 1e-12);
}
} // namespace
