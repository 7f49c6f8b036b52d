// What is mended in a mesh. Fails when vertices at one place stay apart or different ones are
// joined, when a facet is dropped that is needed, or when the counts are wrong.
#include "dem/scans/mesh_cleaning.h"
#include "dem/scans/mesh_diagnosis.h"
#include "tests/dem_solids.h"

#include <gtest/gtest.h>

namespace
{
using namespace interlock::dem;

// As in an STL file: each facet with three vertices of its own.
TriangleMesh taken_apart(const TriangleMesh& mesh)
{
  TriangleMesh result;
  for (const auto& t : mesh.triangles) {
    const int first = static_cast<int>(result.vertices.size());
    for (const int v : t) result.vertices.push_back(mesh.vertices[v]);
    result.triangles.push_back({first, first + 1, first + 2});
  }
  return result;
}

TEST(MeshCleaning, VerticesAreMergedByPlace)
{
  const TriangleMesh whole = solids::subdivide(solids::octahedron(0.04), 7);
  TriangleMesh mesh = taken_apart(whole);
  mesh.vertices.push_back({1, 2, 3}); // no facet uses it
  const int before = static_cast<int>(mesh.vertices.size());
  EXPECT_EQ(merge_vertices(mesh), before - static_cast<int>(whole.vertices.size()));
  EXPECT_EQ(mesh.vertices.size(), whole.vertices.size());
  EXPECT_EQ(count_open_edges(mesh), 0);
}

TEST(MeshCleaning, MinusZeroIsZeroAndNearIsNotEqual)
{
  TriangleMesh mesh;
  mesh.vertices = {{0., 0, 1}, {-0., 0, 1}, {1e-300, 0, 1}};
  mesh.triangles = {{0, 1, 2}};
  EXPECT_EQ(merge_vertices(mesh), 1);
  EXPECT_EQ(drop_degenerate_facets(mesh), 1);
  EXPECT_TRUE(mesh.triangles.empty());
}

TEST(MeshCleaning, DuplicatesOfOneSenseAreDropped)
{
  TriangleMesh mesh = solids::octahedron(1);
  const std::array<int, 3> facet = mesh.triangles[3];
  mesh.triangles.push_back({facet[1], facet[2], facet[0]});
  mesh.triangles.insert(mesh.triangles.begin(), facet);
  EXPECT_EQ(drop_duplicate_facets(mesh), 2);
  EXPECT_EQ(mesh.triangles.size(), 8u);
  EXPECT_EQ(count_open_edges(mesh), 0);
  mesh.triangles.push_back({facet[0], facet[2], facet[1]}); // the other sense
  EXPECT_EQ(drop_duplicate_facets(mesh), 0);
}

TEST(MeshDiagnosis, HolesAreRimsThatHangTogether)
{
  TriangleMesh mesh = solids::subdivide(solids::octahedron(0.04), 6);
  // The first two cells of a row share an edge: one hole of four edges.
  mesh.triangles.erase(mesh.triangles.begin(), mesh.triangles.begin() + 2);
  EXPECT_EQ(diagnose_edges(mesh).holes, 1);
  EXPECT_EQ(diagnose_edges(mesh).open, 4);
  mesh.triangles.erase(mesh.triangles.begin() + 4 * 36);
  EXPECT_EQ(diagnose_edges(mesh).holes, 2);
  EXPECT_EQ(diagnose_edges(solids::octahedron(1)).holes, 0);
}

TEST(MeshDiagnosis, SoundBody)
{
  MeshDiagnosis diagnosis;
  diagnose_surface(solids::box(0.02, 0.03, 0.04), diagnosis);
  EXPECT_TRUE(diagnosis.closed());
  EXPECT_EQ(diagnosis.shells, 1);
  EXPECT_EQ(diagnosis.largest_shell_share, 1);
  EXPECT_NEAR(diagnosis.volume, 24e-6, 1e-15);
  EXPECT_EQ(diagnosis.facets_without_area, 0);
  EXPECT_EQ(fault_of(diagnosis), "");
}

TEST(MeshDiagnosis, AFacetWithoutAreaIsKept)
{
  // The edge of a corner tetrahedron has a node in its middle on one side only; the facet that
  // closes the crack has its corners on one line.
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {1, 0, 0}};
  mesh.triangles = {{0, 2, 1}, {0, 4, 3}, {4, 1, 3}, {0, 3, 2}, {1, 2, 3}, {0, 1, 4}};
  MeshDiagnosis diagnosis;
  diagnose_surface(mesh, diagnosis);
  EXPECT_TRUE(diagnosis.closed());
  EXPECT_EQ(diagnosis.facets_without_area, 1);
  EXPECT_EQ(drop_degenerate_facets(mesh), 0);
}
} // namespace
