#include "coupling/laboratory/laboratory_declarations.h"

#include "coupling/parameters/product_declarations.h"

namespace interlock::coupling
{
namespace
{
void declare_test(ParameterTable& table, LaboratoryTestParameters& test)
{
  table.open_section("Laboratory");
  table.require_choice("Test", test.test,
                       {"data sheet", "wide-width tension", "single-rib tension",
                        "aperture stability", "flexural overhang", "supports and loads", "modes"},
                       "One test, or all that a data sheet states.");
  table.offer_choice(
      "Direction", test.direction, "along", {"along", "across"},
      "Of tension and overhang in a single test: machine or cross-machine direction.");
  table.offer("Largest strain", test.largest_strain, 0.05, {0, 0.5, false},
              "Tension goes on to this strain. [-]");
  table.offer(
      "Largest torque", test.largest_torque, 2, positive,
      "Aperture stability goes on to this torque; 2 N m is the 20 kg cm of the standard. [N m]");
  table.offer("Steps", test.steps, 25, {1, 100000, true}, "Equal steps of a test. [-]");
  table.offer("Strip ribs", test.strip_ribs, 3, {1, 1000, true},
              "Number of ribs along the strip of the overhang test. [-]");
  table.offer("Apertures along", test.apertures_along, 4, {1, 1000, true},
              "Apertures of the piece for supports and loads, and for modes. [-]");
  table.offer("Apertures across", test.apertures_across, 4, {1, 1000, true},
              "The same in the other direction. [-]");
  table.offer_input_file(
      "Lattice file", test.lattice_file,
      "A Gmsh file (.msh) instead of the piece, relative to this file: its groups of "
      "lines are named "
      "along or across and take those ribs, its groups of points are sets of nodes.");
  table.offer("Lattice length unit", test.lattice_length_unit, 1, positive,
              "Length of one unit of that file, 0.001 for millimetres. [m]");
  table.offer_text(
      "Supports", test.supports,
      "For supports and loads, and for modes: SET: FREEDOMS; ..., such as \"front: all; "
      "back: x=0.002 y z\" with sets front, back, left, right, rim, middle, everywhere "
      "and freedoms x y z (m), rx ry rz (rad), all.");
  table.offer_text(
      "Loads", test.loads,
      "For supports and loads: SET: COMPONENTS; ..., such as \"middle: fz=-5 mx=0.1\" with "
      "fx fy fz (N), mx my mz (N m), shared equally by the nodes of the set.");
  table.offer("Modes", test.modes, 10, {1, 10000, true},
              "Number of natural frequencies, from the lowest. [-]");
  table.offer("Gravity", test.gravity, 9.81, positive, "Acceleration of gravity. [m/s2]");
}

void declare_data_sheet(ParameterTable& table, DataSheetParameters& sheet)
{
  table.open_section("Data sheet");
  table.offer_text("Source", sheet.source, "Where these values are from.");
  const auto stated = [&](const std::string& name, double& member, const std::string& text) {
    table.offer(name, member, 0, not_negative, text);
  };
  stated("Force at 2 % along", sheet.force_2_along, "Force per width at 2 % strain. [kN/m]");
  stated("Force at 5 % along", sheet.force_5_along, "Force per width at 5 % strain. [kN/m]");
  stated("Force at 2 % across", sheet.force_2_across, "Force per width at 2 % strain. [kN/m]");
  stated("Force at 5 % across", sheet.force_5_across, "Force per width at 5 % strain. [kN/m]");
  stated("Aperture stability", sheet.aperture_stability, "Torque per rotation. [N m/deg]");
  stated("Flexural rigidity", sheet.flexural_rigidity, "Of the overhang test, along. [mg cm]");
  stated("Mass per area", sheet.mass_per_area, "Of the sheet. [kg/m2]");
}

} // namespace

void declare_laboratory(ParameterTable& table, LaboratoryParameters& parameters)
{
  declare_product(table, parameters.product);
  declare_test(table, parameters.test);
  declare_data_sheet(table, parameters.data_sheet);
  table.open_section("Output");
  table.offer("Report", parameters.report, true,
              "Draw the figures and write report.html at the end of the run.");
}

std::vector<ParameterProblem> check_laboratory(const LaboratoryParameters& parameters)
{
  ParameterProblems problems;
  const ProductParameters& product = parameters.product;
  check_product(product, problems);
  const LaboratoryTestParameters& test = parameters.test;
  if (product.pattern == "triaxial" &&
      (test.test == "single-rib tension" || test.test == "flexural overhang"))
    problems.add("Laboratory/Test", "The ", test.test, " is not offered for triaxial geogrids.");
  if (product.pattern != "biaxial" && test.direction == "across")
    problems.add("Laboratory/Direction",
                 "Only biaxial geogrids are tested across, and this one is ", product.pattern, ".");
  return problems.take();
}
} // namespace interlock::coupling
