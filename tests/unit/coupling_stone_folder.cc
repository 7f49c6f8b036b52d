// The scans of a run. Fails when what lies beside the stones in a folder is taken for one, or when
// what the reader says of a stone does not reach the user of a run.
#include "coupling/stones/stone_shapes.h"
#include "tests/dem_solids.h"
#include "tests/temporary_folder.h"

namespace
{
using namespace interlock;

class StoneFolder : public TemporaryFolderTest
{
protected:
  void SetUp() override
  {
    TemporaryFolderTest::SetUp();
    parameters.folder = folder.string();
    parameters.d_min = parameters.r_min = 0.004;
    parameters.p_max = 100;
  }

  std::vector<coupling::Stone> stones()
  {
    coupling::Monitor monitor;
    monitor.message = [&](const std::string& sentence) { messages.push_back(sentence); };
    return coupling::make_stones(parameters, monitor);
  }

  static dem::TriangleMesh stone(double distance)
  {
    return solids::moved(solids::subdivide(solids::octahedron(0.04), 6), dem::Matrix3::Identity(),
                         dem::Vector3(distance, 0, 0));
  }

  coupling::StoneParameters parameters;
  std::vector<std::string> messages;
};

TEST_F(StoneFolder, WhatLiesBesideTheStonesIsNone)
{
  dem::write_stl((folder / "b.stl").string(), stone(0));
  dem::write_stl((folder / "a.STL").string(), stone(0));
  write("._a.STL", std::string("\0\5\x16\7", 4));
  write("._b.stl", std::string("\0\5\x16\7", 4));
  write("Thumbs.db", "x");
  std::filesystem::create_directories(folder / "old.stl");
  const auto found = stones();
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].shape.name, "a");
  EXPECT_EQ(found[1].shape.name, "b");
  EXPECT_TRUE(messages.empty());
}

TEST_F(StoneFolder, NotesOfTheReaderAreMessages)
{
  dem::write_stl((folder / "far.stl").string(), stone(300));
  dem::write_stl((folder / "near.stl").string(), stone(0));
  stones();
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_EQ(messages[0].find("Stone far: it is written in single precision"), 0u) << messages[0];
  EXPECT_EQ(messages[0].back(), '.');
}
} // namespace
