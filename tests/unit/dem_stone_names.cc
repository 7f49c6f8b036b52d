// Which files of a folder are stones. Fails when a hidden file, a folder or what Windows keeps in
// folders is taken for one, or a stone is passed over in silence.
#include "dem/scans/stone_names.h"
#include "tests/temporary_folder.h"

#include <set>

namespace
{
using namespace interlock::dem;

class StoneNames : public TemporaryFolderTest
{
};

TEST_F(StoneNames, HiddenFilesAndFoldersAreNone)
{
  for (const char* name :
       {"a.stl", "b.PLY", "c.Obj", "d.xyz", "._a.stl", ".hidden.ply", ".stl", "Thumbs.db",
        "desktop.ini", ".DS_Store", "a.stl~", "a.stl.part", "notes.txt", "e..stl"})
    write(name, "x");
  std::filesystem::create_directories(folder / "folder.stl");
  std::filesystem::create_symlink(folder / "nowhere", folder / "link.stl");
  std::set<std::string> meshes, stones;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (is_stone_file(entry, mesh_endings)) meshes.insert(entry.path().filename().string());
    if (is_stone_file(entry, stone_endings)) stones.insert(entry.path().filename().string());
  }
  EXPECT_EQ(meshes, (std::set<std::string>{"a.stl", "b.PLY", "c.Obj", "e..stl", "link.stl"}));
  EXPECT_EQ(stones.size(), meshes.size() + 1);
}
} // namespace
