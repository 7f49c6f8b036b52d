// The laboratory experiment as a whole, on cases with closed answers: a cantilever from a Gmsh
// file, its natural frequency, and a sheet whose stiffness is its input. Fails when a product is
// not what the parameters say, a section or a node set goes astray, or a file is not written.
#include "coupling/laboratory/laboratory.h"
#include "tests/gmsh_files.h"
#include "tests/temporary_folder.h"

#include <deal.II/base/mpi.h>
#include <gtest/gtest.h>

#include <cmath>

using namespace interlock;
using namespace interlock::coupling;

namespace
{
class LaboratoryExperiment : public TemporaryFolderTest
{
protected:
  LaboratoryParameters parameters() const
  {
    LaboratoryParameters p;
    p.product.pitch_along = 0.04;
    p.product.pitch_across = 0.05;
    p.product.along = {0.004, 0.002, 2e9, 0, 0, 0};
    p.product.across = {0.003, 0.001, 2e9, 0, 0, 0};
    p.product.poisson_ratio = 0.3;
    p.product.density = 910;
    p.product.elements_per_rib = 4;
    p.test.largest_strain = 0.05;
    p.test.largest_torque = 0.5;
    p.test.steps = 5;
    p.test.strip_ribs = 1;
    p.test.gravity = 9.81;
    p.test.apertures_along = p.test.apertures_across = 2;
    p.test.modes = 3;
    return p;
  }

  // A straight rib along x, drawn in millimetres.
  void write_rib(double length_mm, int elements)
  {
    GmshText text;
    text.line_groups = {"along"};
    text.point_groups = {"wall", "tip"};
    for (int i = 0; i <= elements; ++i) text.nodes.push_back({length_mm * i / elements, 0, 0});
    for (int i = 0; i < elements; ++i) text.lines.push_back({i, i + 1, 0});
    text.points = {{0, 0}, {elements, 1}};
    write("rib.msh", text.version_2());
  }

  double result(const Summary& summary, const char* name) const
  {
    return summary.results[name].get<double>();
  }
};
} // namespace

TEST_F(LaboratoryExperiment, CantileverFromAGmshFile)
{
  write_rib(100, 16);
  LaboratoryParameters p = parameters();
  p.test.test = "supports and loads";
  p.test.lattice_file = (folder / "rib.msh").string();
  p.test.lattice_length_unit = 1e-3;
  p.test.supports = "wall: all";
  p.test.loads = "tip: fz=-1e-4";
  const Summary s = Laboratory(p, {}).run(folder);
  const double stiffness = 2e9 * 0.004 * std::pow(0.002, 3) / 12;
  const double shear = 1e-4 * 0.1 / fem::beam_section({0.004, 0.002, 2e9, 0.3, 910}).shear_3;
  const double expected = 1e-4 * 1e-3 / (3 * stiffness) + shear;
  EXPECT_NEAR(result(s, "largest_displacement_m") / expected, 1, 1e-6);
  EXPECT_NEAR(result(s, "reaction_wall_z_N"), 1e-4, 1e-10);
  for (const char* file : {"history.csv", "table.csv", "supports_and_loads.xdmf"})
    EXPECT_TRUE(std::filesystem::exists(folder / file)) << file;
}

// (1.8751041/L)^2 sqrt(EI/(rho A))/(2 pi), lumped masses of 64 elements: second order, 2e-4; shear
// and rotary inertia less.
TEST_F(LaboratoryExperiment, FrequencyOfACantilever)
{
  write_rib(100, 64);
  LaboratoryParameters p = parameters();
  p.test.test = "modes";
  p.test.lattice_file = (folder / "rib.msh").string();
  p.test.lattice_length_unit = 1e-3;
  p.test.supports = "wall: all";
  const Summary s = Laboratory(p, {}).run(folder);
  const double radius = 0.002 / std::sqrt(12.); // of gyration
  const double expected = std::pow(1.8751041 / 0.1, 2) * std::sqrt(2e9 / 910) * radius / (2 * M_PI);
  EXPECT_NEAR(result(s, "natural_frequency_1_Hz") / expected, 1, 5e-4);
  // The width is twice the thickness, and so is the frequency in the plane.
  EXPECT_NEAR(result(s, "natural_frequency_2_Hz") / (2 * expected), 1, 2e-3);
  EXPECT_TRUE(std::filesystem::exists(folder / "modes.xdmf"));
}

TEST_F(LaboratoryExperiment, SheetHasTheStiffnessOfItsDataSheet)
{
  LaboratoryParameters p = parameters();
  p.product.along = {0.004, 0.002, 0, 300000, 240000, 30000};
  p.product.across = {0.003, 0.001, 0, 200000, 0, 0};
  const Summary s = Laboratory(p, {}).run(folder);
  EXPECT_NEAR(result(s, "wide_width_force_at_2_percent_along_kN_per_m"), 6, 1e-6);
  EXPECT_NEAR(result(s, "wide_width_force_at_5_percent_along_kN_per_m"), 12, 1e-6);
  EXPECT_NEAR(result(s, "wide_width_force_at_5_percent_across_kN_per_m"), 10, 1e-6);
  EXPECT_GT(result(s, "aperture_stability_N_m_per_deg"), 0);
  EXPECT_GT(result(s, "overhang_length_along_m"), 0);
  EXPECT_EQ(s.stages.size(), 4u);
}

// Ribs are softened so that the sheet keeps its stiffness at small strain with thick junctions.
TEST_F(LaboratoryExperiment, ThickJunctionsKeepTheStiffnessOfTheSheet)
{
  LaboratoryParameters p = parameters();
  p.product.along = {0.004, 0.002, 0, 300000, 0, 0};
  p.product.across = {0.003, 0.001, 0, 200000, 0, 0};
  p.product.junction_reach = 0.005;
  p.product.junction_thickness = 0.004;
  p.test.test = "wide-width tension";
  const Summary s = Laboratory(p, {}).run(folder);
  EXPECT_NEAR(result(s, "wide_width_force_at_2_percent_along_kN_per_m"), 6, 1e-5);
}

int main(int argc, char** argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
