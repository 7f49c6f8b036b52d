// Corners that differ in their last digits. Fails when a surface that is closed but for them stays
// open, when a hole or a facet of a real size is closed with them, when the result depends on
// chance, or when a gap that is not joined is not named.
#include "dem/meshes/mass_properties.h"
#include "dem/random_stream.h"
#include "dem/scans/near_corners.h"
#include "dem/scans/stone_file.h"
#include "tests/dem_solids.h"
#include "tests/refusal.h"
#include "tests/temporary_folder.h"

namespace
{
using namespace interlock::dem;

// Each facet with corners of its own, off by up to `shift` along each axis [m].
TriangleMesh shaken(const TriangleMesh& mesh, double shift)
{
  RandomStream generator(7);
  TriangleMesh result;
  for (const auto& t : mesh.triangles) {
    const int first = static_cast<int>(result.vertices.size());
    for (const int v : t)
      result.vertices.push_back(mesh.vertices[v] + Vector3(generator.uniform(-shift, shift),
                                                           generator.uniform(-shift, shift),
                                                           generator.uniform(-shift, shift)));
    result.triangles.push_back({first, first + 1, first + 2});
  }
  return result;
}

TriangleMesh ball() // of edges of 3 mm
{
  return solids::subdivide(solids::octahedron(0.04), 12);
}

TEST(NearCorners, AreJoinedOnOpenEdges)
{
  const TriangleMesh whole = ball();
  const JoinedSurface joined = join_near_corners(shaken(whole, 1e-9), 5e-8);
  EXPECT_EQ(joined.edges.open + joined.edges.flipped + joined.edges.branching, 0);
  EXPECT_EQ(joined.mesh.vertices.size(), whole.vertices.size());
  EXPECT_EQ(joined.mesh.triangles.size(), whole.triangles.size());
  EXPECT_EQ(joined.joined, int(3 * whole.triangles.size() - whole.vertices.size()));
  EXPECT_EQ(joined.degenerate_facets, 0);
  EXPECT_LT(joined.largest_gap, 2 * std::sqrt(3.) * 1e-9);
  EXPECT_NEAR(mass_properties(joined.mesh).volume / mass_properties(whole).volume, 1, 1e-6);
}

TEST(NearCorners, SoundSurfacesStayAsTheyAre)
{
  const JoinedSurface joined = join_near_corners(ball(), 1); // larger than the body
  EXPECT_EQ(joined.joined, 0);
  EXPECT_EQ(joined.mesh.triangles, ball().triangles);
}

TEST(NearCorners, TheOrderOfWorkIsThatOfTheFile)
{
  const TriangleMesh mesh = shaken(ball(), 1e-9);
  const JoinedSurface once = join_near_corners(mesh, 5e-8), again = join_near_corners(mesh, 5e-8);
  EXPECT_EQ(once.mesh.triangles, again.mesh.triangles);
  for (std::size_t v = 0; v < once.mesh.vertices.size(); ++v)
    EXPECT_EQ(once.mesh.vertices[v], again.mesh.vertices[v]);
  // The corner that comes first in the file stays where it is.
  EXPECT_EQ(once.mesh.vertices[0], mesh.vertices[0]);
}

class NearCornersFile : public TemporaryFolderTest
{
protected:
  // In text with all digits of a double.
  std::string with_mesh(const TriangleMesh& mesh) const
  {
    std::ostringstream text;
    text.precision(17);
    for (const Vector3& x : mesh.vertices) text << "v " << x.transpose() << "\n";
    for (const auto& t : mesh.triangles)
      text << "f " << t[0] + 1 << " " << t[1] + 1 << " " << t[2] + 1 << "\n";
    return write("stone.obj", text.str()).string();
  }
};

TEST_F(NearCornersFile, AreNoted)
{
  const TriangleMesh whole = ball();
  MeshDiagnosis found;
  const TriangleMesh mesh = read_stone_mesh(with_mesh(shaken(whole, 1e-9)), {}, &found);
  EXPECT_EQ(mesh.vertices.size(), whole.vertices.size());
  EXPECT_GT(found.corners_joined, 0);
  ASSERT_EQ(found.notes.size(), 1u);
  EXPECT_NE(found.notes[0].find(std::to_string(found.corners_joined) + " corners that nearly met"),
            std::string::npos)
      << found.notes[0];
}

TEST_F(NearCornersFile, HolesStayHoles)
{
  TriangleMesh mesh = ball();
  mesh.triangles.erase(mesh.triangles.begin() + 30); // inside the first face
  const std::string file = with_mesh(shaken(mesh, 1e-9));
  expect_refusal([&] { read_stone_mesh(file, 1); }, file,
                 {"is open: 3 edges", "around 1 hole;", "corners that nearly met", "were joined"});
}

// Real facets, a hundred times larger than what is joined, beside a hole of their size.
TEST_F(NearCornersFile, SmallFacetsAreKept)
{
  TriangleMesh mesh = ball();
  const std::array<int, 3> cut = mesh.triangles[30];
  const Vector3 a = mesh.vertices[cut[0]];
  const int first = static_cast<int>(mesh.vertices.size());
  for (const int v : {cut[1], cut[2]}) {
    const Vector3 x = a + 6e-6 * (mesh.vertices[v] - a).normalized();
    mesh.vertices.push_back(x);
  }
  // The corner a is cut off: a facet with edges of 6 micrometres, and a hole in its place later.
  mesh.triangles[30] = {first, cut[1], cut[2]};
  mesh.triangles.push_back({first, cut[2], first + 1});
  mesh.triangles.push_back({cut[0], first, first + 1});
  const int before = diagnose_edges(mesh).open; // the neighbours do not have these corners
  const JoinedSurface joined = join_near_corners(mesh, joined_gap * extents(mesh).maxCoeff());
  EXPECT_GT(before, 0);
  EXPECT_EQ(joined.joined, 0);
  EXPECT_EQ(joined.edges.open, before);
}

// Its corners are not the same corner: merging over its edges would take facets away everywhere.
TEST_F(NearCornersFile, ASmallHoleIsNoGap)
{
  TriangleMesh mesh = solids::subdivide(solids::octahedron(0.04), 6);
  const std::array<int, 3> facet = mesh.triangles[10];
  Vector3 middle = Vector3::Zero();
  for (const int v : facet) middle += mesh.vertices[v] / 3;
  const int rim = static_cast<int>(mesh.vertices.size());
  for (const int v : facet) {
    const Vector3 x = middle + 1e-5 * (mesh.vertices[v] - middle).normalized();
    mesh.vertices.push_back(x);
  }
  mesh.triangles.erase(mesh.triangles.begin() + 10);
  for (int k = 0; k < 3; ++k) {
    const int next = (k + 1) % 3;
    mesh.triangles.push_back({facet[k], facet[next], rim + next});
    mesh.triangles.push_back({facet[k], rim + next, rim + k});
  }
  EXPECT_EQ(closing_gap(mesh), 0);
  const std::string file = with_mesh(mesh);
  expect_refusal([&] { read_stone_mesh(file, 1); }, file,
                 {"is open: 3 edges", "around 1 hole; close the holes"});
}

TEST_F(NearCornersFile, LargerGapsAreNamed)
{
  const std::string file = with_mesh(shaken(ball(), 1e-6)); // gaps of up to 3.5e-3 mm
  expect_refusal([&] { read_stone_mesh(file, 1); }, file,
                 {"is open", "its corners nearly meet (largest gap 0.00", "mm): merge corners"});
}
} // namespace
