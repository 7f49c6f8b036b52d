// Every fault of a stone file is one InputError, one sentence that names the file and what is
// wrong. Fails when a fault passes, when another exception escapes, or when the sentence lacks the
// file or its facts.
#include "dem/input_error.h"
#include "dem/meshes/triangle_mesh.h"
#include "tests/dem_solids.h"
#include "tests/refusal.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace
{
using namespace interlock::dem;
namespace fs = std::filesystem;

class StoneMesh : public testing::Test
{
protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  std::string with_text(const std::string& name, const std::string& text) const
  {
    std::ofstream(path(name)) << text;
    return path(name);
  }

  std::string with_mesh(const TriangleMesh& mesh) const
  {
    write_stl(path("stone.stl"), mesh);
    return path("stone.stl");
  }

  // Expects a refusal that contains the file's name and all of `facts`, in one line.
  void expect_refusal(const std::string& file, const std::vector<std::string>& facts,
                      double length_unit = 1) const
  {
    ::expect_refusal([&] { read_stone_mesh(file, length_unit); }, file, facts);
  }

private:
  const fs::path folder_ =
      fs::path(testing::TempDir()) /
      ("interlock_stones_" +
       std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
};

TEST_F(StoneMesh, Missing)
{
  expect_refusal(path("absent.stl"), {"does not exist"});
}

TEST_F(StoneMesh, Folder)
{
  fs::create_directories(path("folder.stl"));
  expect_refusal(path("folder.stl"), {"is not a file"});
}

TEST_F(StoneMesh, Extension)
{
  expect_refusal(with_text("stone.txt", "hello"), {"'.txt'", ".stl, .ply or .obj"});
}

TEST_F(StoneMesh, Garbage)
{
  expect_refusal(with_text("garbage.stl", "this is a shopping list"), {"cannot be read as a mesh"});
  expect_refusal(with_text("garbage.ply", "ply? no"), {"cannot be read as a mesh"});
  expect_refusal(with_text("garbage.obj", "milk, eggs, bread and some more text"), {});
  expect_refusal(with_text("empty.stl", ""), {});
}

TEST_F(StoneMesh, CutShort)
{
  const std::string file = with_mesh(solids::octahedron(0.04));
  fs::resize_file(file, 200);
  expect_refusal(file, {});
}

TEST_F(StoneMesh, NoFacet)
{
  expect_refusal(with_text("points.obj", "v 0 0 0\nv 0.01 0 0\nv 0 0.01 0\n"), {});
  expect_refusal(with_text("points.ply", "ply\nformat ascii 1.0\nelement vertex 3\n"
                                         "property float x\nproperty float y\nproperty float z\n"
                                         "end_header\n0 0 0\n0.03 0 0\n0 0.03 0\n"),
                 {});
}

TEST_F(StoneMesh, NotANumber)
{
  TriangleMesh mesh = solids::octahedron(0.04);
  mesh.vertices[3][1] = std::nan("");
  expect_refusal(with_mesh(mesh), {"not a finite number", "facet 3"});
}

TEST_F(StoneMesh, Open)
{
  TriangleMesh mesh = solids::subdivide(solids::octahedron(0.04), 3);
  mesh.triangles.erase(mesh.triangles.begin() + 4); // in the middle of the first face
  expect_refusal(with_mesh(mesh), {"is open", " 3 edges"});
}

TEST_F(StoneMesh, OneFacetFlipped)
{
  TriangleMesh mesh = solids::octahedron(0.04);
  std::swap(mesh.triangles[5][0], mesh.triangles[5][1]);
  expect_refusal(with_mesh(mesh), {"not consistently oriented", " 3 edges"});
}

TEST_F(StoneMesh, InsideOut)
{
  expect_refusal(with_mesh(solids::inside_out(solids::octahedron(0.04))), {"is inside out"});
}

TEST_F(StoneMesh, WrongUnit)
{
  const std::string millimetres = with_mesh(solids::box(30, 40, 50));
  expect_refusal(millimetres, {"50 m long", "millimetres read as metres"});
  EXPECT_NO_THROW(read_stone_mesh(millimetres, 0.001));
  const std::string metres = with_mesh(solids::box(0.03, 0.04, 0.05));
  expect_refusal(metres, {"5e-05 m long", "metres read as millimetres"}, 0.001);
  EXPECT_NO_THROW(read_stone_mesh(metres, 1));
  expect_refusal(metres, {"file unit of -1 m"}, -1);
}

TEST_F(StoneMesh, FolderForWritingIsMissing)
{
  EXPECT_THROW(write_stl(path("absent/stone.stl"), solids::octahedron(0.04)),
               interlock::InputError);
}
} // namespace
