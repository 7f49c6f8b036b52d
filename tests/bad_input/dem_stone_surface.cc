// A surface that is none, or not that of one stone, is refused with the numbers that tell where to
// look and the option that helps. Fails when a fault passes, or when the sentence lacks its facts.
#include "dem/scans/stone_file.h"
#include "tests/dem_solids.h"
#include "tests/refusal.h"
#include "tests/temporary_folder.h"

namespace
{
using namespace interlock::dem;

class StoneSurface : public TemporaryFolderTest
{
protected:
  std::string with_mesh(const TriangleMesh& mesh) const
  {
    const std::string file = (folder / "stone.stl").string();
    write_stl(file, mesh);
    return file;
  }

  void expect_refused(const TriangleMesh& mesh, const std::vector<std::string>& facts,
                      const StoneFileOptions& options = {}) const
  {
    const std::string file = with_mesh(mesh);
    expect_refusal([&] { read_stone_mesh(file, options); }, file, facts);
  }
};

TriangleMesh together(TriangleMesh a, const TriangleMesh& b)
{
  const int shift = static_cast<int>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const auto& t : b.triangles)
    a.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  return a;
}

TriangleMesh shifted(const TriangleMesh& mesh, const Vector3& shift)
{
  return solids::moved(mesh, Matrix3::Identity(), shift);
}

// A box of 20 mm one corner of which is pulled through the opposite face.
TriangleMesh pierced()
{
  TriangleMesh mesh = solids::box(0.02, 0.02, 0.02);
  mesh.vertices[7] = Vector3(0.003, 0.004, -0.012);
  return mesh;
}

TEST_F(StoneSurface, HolesAreCounted)
{
  TriangleMesh mesh = solids::subdivide(solids::octahedron(0.04), 5);
  mesh.triangles.erase(mesh.triangles.begin() + 12); // in the middle of the first face
  mesh.triangles.erase(mesh.triangles.begin() + 12 + 3 * 25);
  expect_refused(mesh, {"is open", " 6 edges", "2 holes"});
}

TEST_F(StoneSurface, InsideOutNamesTheOption)
{
  const TriangleMesh inward = solids::inside_out(solids::octahedron(0.04));
  expect_refused(inward, {"is inside out", "--flip"});
  StoneFileOptions flip;
  flip.flip = true;
  MeshDiagnosis diagnosis;
  read_stone_mesh(with_mesh(inward), flip, &diagnosis);
  EXPECT_GT(diagnosis.volume, 0);
  EXPECT_TRUE(diagnosis.flipped);
  expect_refused(solids::octahedron(0.04), {"is inside out with --flip", "leave --flip away"},
                 flip);
}

TEST_F(StoneSurface, SeveralShells)
{
  // Edges of 40 mm and 20 mm: volumes as 8 to 1.
  const TriangleMesh two =
      together(solids::octahedron(0.04), shifted(solids::octahedron(0.02), Vector3(0.1, 0, 0)));
  expect_refused(two, {"2 separate closed surfaces", "88.8889 % of the volume"});
}

// Two boxes that share one corner: each edge is sound, and each body too.
TEST_F(StoneSurface, TouchingInACorner)
{
  const TriangleMesh large = solids::box(0.06, 0.04, 0.03);
  const TriangleMesh small = shifted(solids::box(0.02, 0.02, 0.02), Vector3(0.04, 0.03, 0.025));
  expect_refused(together(large, small),
                 {"2 closed surfaces that touch each other in one corner", "90 % of the volume"});
  const TriangleMesh apart = shifted(solids::box(0.02, 0.02, 0.02), Vector3(-0.2, 0, 0));
  expect_refused(together(together(large, small), apart),
                 {"3 closed surfaces, some of which touch each other in one corner only"});
  const TriangleMesh second = shifted(solids::box(0.02, 0.02, 0.02), Vector3(-0.04, -0.03, -0.025));
  expect_refused(together(together(large, small), second),
                 {"3 closed surfaces that touch each other in 2 single corners only"});
}

// A cube with a pit whose tip comes up to a corner from inside: one surface that meets itself
// there.
TEST_F(StoneSurface, TouchingItselfInACornerIsNoted)
{
  TriangleMesh mesh = solids::box(0.02, 0.02, 0.02);
  const int tip = static_cast<int>(mesh.vertices.size()) - 1; // (0.01, 0.01, 0.01)
  // Opens at the bottom, in place of its first facet: corners 0, 2, 3, seen from below.
  const int rim = static_cast<int>(mesh.vertices.size());
  const std::array<int, 3> bottom = mesh.triangles[0];
  Vector3 middle = Vector3::Zero();
  for (const int v : bottom) middle += mesh.vertices[v] / 3;
  for (const int v : bottom) {
    const Vector3 x = 0.5 * middle + 0.5 * mesh.vertices[v];
    mesh.vertices.push_back(x);
  }
  mesh.triangles.erase(mesh.triangles.begin());
  for (int k = 0; k < 3; ++k) {
    const int next = (k + 1) % 3;
    mesh.triangles.push_back({bottom[k], bottom[next], rim + next});
    mesh.triangles.push_back({bottom[k], rim + next, rim + k});
    mesh.triangles.push_back({rim + k, rim + next, tip});
  }
  MeshDiagnosis diagnosis;
  const TriangleMesh read = read_stone_mesh(with_mesh(mesh), {}, &diagnosis);
  EXPECT_EQ(diagnosis.corners_parted, 1);
  EXPECT_EQ(diagnosis.shells, 1);
  EXPECT_EQ(read.vertices.size(), 8u + 3 + 1);
  ASSERT_EQ(diagnosis.notes.size(), 1u);
  EXPECT_EQ(diagnosis.notes[0], "its surface touches itself in 1 corner");
}

TEST_F(StoneSurface, TwoFacetsBackToBack)
{
  TriangleMesh mesh = solids::octahedron(0.04);
  mesh.triangles.push_back({mesh.triangles[0][0], mesh.triangles[0][2], mesh.triangles[0][1]});
  expect_refused(mesh, {"is not a surface", "3 edges have more than two facets"});
}

TEST_F(StoneSurface, CrossingItself)
{
  expect_refused(pierced(), {"crosses itself", "pairs of facets cut", "--accept-crossings"});
  StoneFileOptions accept;
  accept.accept_crossings = true;
  MeshDiagnosis diagnosis;
  read_stone_mesh(with_mesh(pierced()), accept, &diagnosis);
  EXPECT_GT(diagnosis.crossings.pairs, 0); // still told
}

TEST_F(StoneSurface, UnitsAreGuessed)
{
  expect_refused(solids::box(3, 4, 5), {"5 m long", "centimetres read as metres: 0.05 m",
                                        "inches read as metres: 0.127 m"});
  expect_refused(solids::box(2e4, 2e4, 3e4), {"30000 m long", "check the length unit."});
  StoneFileOptions inches;
  inches.length_unit = length_of_unit("inch");
  EXPECT_NO_THROW(read_stone_mesh(with_mesh(solids::box(1.5, 1.5, 2)), inches));
  EXPECT_THROW(length_of_unit("foot"), interlock::InputError);
}
} // namespace
