// Bad parameter files of a laboratory test: each test states one slip and the words that must be in
// the answer. It takes a slip that is accepted, or an answer that does not name entry, value and
// what is allowed, to fail. Also that every product of the library can be read.
#include "apps/case_templates.h"
#include "apps/parameter_file.h"
#include "coupling/laboratory/laboratory.h"
#include "tests/refusal.h"
#include "tests/temporary_folder.h"

#include <deal.II/base/mpi.h>
#include <gtest/gtest.h>

using namespace interlock;

namespace
{
class BadLaboratory : public TemporaryFolderTest
{
protected:
  void SetUp() override
  {
    TemporaryFolderTest::SetUp();
    write("product.prm", apps::laboratory_template());
  }

  void expect(const std::vector<std::string>& changes, const std::string& entry,
              const std::vector<std::string>& words) const
  {
    expect_refusal([&] { apps::read_parameter_file(folder / "product.prm", changes); }, entry,
                   words);
  }

  // Only the experiment itself can tell.
  void expect_when_prepared(const std::vector<std::string>& changes, const std::string& fact,
                            const std::vector<std::string>& words) const
  {
    const auto input = apps::read_parameter_file(folder / "product.prm", changes);
    expect_refusal([&] { input.experiment->prepare(input.parameters, {}); }, fact, words);
  }
};
} // namespace

TEST_F(BadLaboratory, ValuesAndNames)
{
  expect({"Product/Pitch along=0"}, "Product/Pitch along", {"0", "greater than 0", "m"});
  expect({"Product/Rib thickness along=-1e-3"}, "Product/Rib thickness along",
         {"-1e-3", "greater than 0"});
  expect({"Product/Rib width across=0.05"}, "Product/Rib width across", {"0.05", "overlap"});
  expect({"Product/Poisson ratio=0.7"}, "Product/Poisson ratio", {"0.7", "from 0 to 0.5"});
  expect({"Laboratory/Test=bending"}, "Laboratory/Test",
         {"bending", "\"modes\"", "\"flexural overhang\""});
  expect({"Laboratory/Largest strain=5"}, "Laboratory/Largest strain", {"5", "at most 0.5"});
  expect({"Product/Stiffness at 2 % along=0", "Product/Stiffness at 5 % along=0"},
         "Product/Youngs modulus along", {"must be given"});
  expect({"Product/Youngs modulus along=2e9"}, "Product/Youngs modulus along", {"Either"});
}

TEST_F(BadLaboratory, WhatOnlyTheLatticeCanTell)
{
  expect_when_prepared({"Product/Stiffness at 5 % along=300000"}, "5 %", {"stiff"});
  const std::string loaded = "Laboratory/Test=supports and loads";
  expect_when_prepared({loaded, "Laboratory/Supports=", "Laboratory/Loads=middle: fz=-5"},
                       "not held", {"rigid body"});
  expect_when_prepared({loaded, "Laboratory/Supports=middle: x y z"}, "not held", {"rigid body"});
  expect_when_prepared({loaded, "Laboratory/Supports=frnt: all"}, "frnt", {"front", "rim"});
  expect_when_prepared({loaded, "Laboratory/Supports=front: all", "Laboratory/Loads=back: q=1"},
                       "Laboratory/Loads", {"\"q\"", "fx"});
}

TEST_F(BadLaboratory, MoreModesThanFreedoms)
{
  expect_when_prepared({"Laboratory/Test=modes", "Laboratory/Modes=9999"}, "Laboratory/Modes",
                       {"9999", "at most", "freedoms"});
}

TEST_F(BadLaboratory, LatticeFiles)
{
  const std::string loaded = "Laboratory/Test=supports and loads";
  write("text.msh", "nothing of Gmsh\n");
  expect_when_prepared({loaded, "Laboratory/Lattice file=" + (folder / "text.msh").string()},
                       "text.msh", {"Lattice file"});
  expect_when_prepared({loaded, "Laboratory/Lattice file=" + (folder / "none.msh").string()},
                       "none.msh", {"Lattice file"});
}

TEST_F(BadLaboratory, EveryProductCanBeRead)
{
  int products = 0;
  for (const auto& file :
       std::filesystem::directory_iterator(INTERLOCK_SOURCE_DIR "/cases/geogrids"))
    if (file.path().extension() == ".prm") {
      const auto input = apps::read_parameter_file(file.path(), {});
      EXPECT_NO_THROW(input.experiment->prepare(input.parameters, {})) << file.path();
      ++products;
    }
  EXPECT_GE(products, 6);
}

int main(int argc, char** argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
