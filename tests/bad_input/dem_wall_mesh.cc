// What is wrong with a wall of triangles is one InputError, one sentence that names the file and
// the fact. Fails when a fault passes, another exception escapes, or the sentence lacks them.
#include "dem/walls/mesh_contacts.h"
#include "tests/refusal.h"
#include "tests/temporary_folder.h"

#include <cmath>
#include <cstring>

namespace
{
using namespace interlock::dem;

class WallMesh : public TemporaryFolderTest
{
protected:
  void expect_refused(const std::string& file, const std::vector<std::string>& facts,
                      double length_unit = 1) const
  {
    expect_refusal([&] { read_wall_mesh(file, length_unit); }, file, facts);
  }
  std::string text(const std::string& name, const std::string& content) const
  {
    return write(name, content).string();
  }
};

const std::string facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n";
} // namespace

TEST_F(WallMesh, FilesWithFaultsAreRefused)
{
  expect_refused((folder / "missing.stl").string(), {"Wall mesh"});
  expect_refused(folder.string(), {});
  expect_refused(text("wall.txt", "hello"), {".txt", ".stl"});
  expect_refused(text("empty.stl", ""), {"empty"});
  expect_refused(text("none.stl", "solid none\nendsolid none\n"), {"no facet"});
  expect_refused(text("cut.stl", "solid cut\n" + facet), {"line"});
  expect_refused(text("number.stl", "solid n\n" + facet + "vertex 0 x 0\nendloop\nendfacet\n"),
                 {"line 6", "'x'"});
  expect_refused(
      text("line.stl", "solid l\n" + facet + "vertex 2 0 0\nendloop\nendfacet\nendsolid l\n"),
      {"1 facet", "area"});
}

TEST_F(WallMesh, UnitsMustBeAboveZero)
{
  const std::string good =
      text("good.stl", "solid g\n" + facet + "vertex 0 1 0\nendloop\nendfacet\nendsolid g\n");
  EXPECT_EQ(read_wall_mesh(good, 1).triangles.size(), 1u);
  for (const double unit : {0., -1., std::nan("")}) expect_refused(good, {"unit"}, unit);
}

// A thousand kilometres from the origin single precision tells places 6 cm apart, five from it half
// a millimetre.
TEST_F(WallMesh, CoordinatesThatAreTooCoarseAreRefused)
{
  const auto stl = [this](const std::string& name, double x0) {
    std::string bytes(84, '\0');
    const std::uint32_t facets = 1;
    std::memcpy(&bytes[80], &facets, 4);
    for (const double x : {0., 0., 1., x0, 0., 0., x0 + 1, 0., 0., x0, 1., 0.}) {
      const float value = static_cast<float>(x);
      bytes.append(reinterpret_cast<const char*>(&value), 4);
    }
    bytes.append(2, '\0');
    return write(name, bytes).string();
  };
  expect_refused(stl("far.stl", 1e6), {"precision"});
  std::vector<std::string> notes;
  read_wall_mesh(stl("near.stl", 10), 1, &notes);
  EXPECT_TRUE(notes.empty());
  read_wall_mesh(stl("farther.stl", 5e3), 1, &notes);
  EXPECT_EQ(notes.size(), 1u);
}

TEST_F(WallMesh, SurfacesWithoutAreaOrWithWrongCornersAreRefused)
{
  const auto refused = [](const TriangleMesh& mesh, const std::string& fact) {
    expect_refusal([&] { MeshSurface surface(mesh); }, "wall of triangles", {fact});
  };
  const std::vector<Vector3> points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  refused({points, {}}, "no triangle");
  refused({points, {{0, 1, 2}}}, "1 without");
  refused({points, {{0, 1, 3}}}, "corner 3");
  refused({{{0, 0, 0}, {1, 0, 0}, {0, std::nan(""), 0}}, {{0, 1, 2}}}, "finite");
}

TEST_F(WallMesh, OtherContactModelsAreRefused)
{
  MeshWall wall = mesh_wall("hopper", {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
  wall.contact.model = ContactModel::hertz_mindlin;
  Clumps clumps({});
  std::vector<MeshWall> walls = {wall};
  MeshContacts contacts;
  contacts.update_list(clumps, walls);
  expect_refusal([&] { contacts.evaluate(clumps, walls, 1e-6); }, "hopper", {"linear"});
}
