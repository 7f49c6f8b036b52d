#include "coupling/laboratory/laboratory_declarations.h"

#include <algorithm>
#include <cmath>

namespace interlock::coupling
{
namespace
{
void declare_ribs(ParameterTable& table, ProductRibsParameters& ribs, const std::string& direction)
{
  const std::string of = " of the ribs that run " + direction;
  table.require("Rib width " + direction, ribs.width, positive, "Width" + of + ". [m]");
  table.require("Rib thickness " + direction, ribs.thickness, positive,
                "Thickness" + of + ", between two junctions. [m]");
  const std::string secant = "Force per width over strain of the sheet pulled " + direction;
  table.offer("Youngs modulus " + direction, ribs.youngs_modulus, 0, not_negative,
              "Young's modulus" + of + "; 0: that of the stiffness of the sheet. [Pa]");
  table.offer("Stiffness at 2 % " + direction, ribs.stiffness_2, 0, not_negative,
              secant + ", at 2 % strain; 0: that of Young's modulus. [N/m]");
  table.offer("Stiffness at 5 % " + direction, ribs.stiffness_5, 0, not_negative,
              secant + ", at 5 % strain; 0: the same as at 2 %. [N/m]");
  table.offer("Strength " + direction, ribs.strength, 0, not_negative,
              "Force per width at which ribs that run " + direction + " yield; 0: never. [N/m]");
}

void declare_product(ParameterTable& table, ProductParameters& product)
{
  table.open_section("Product");
  table.offer_text("Name", product.name, "Name of the product, for tables and figures.");
  table.offer_choice("Pattern", product.pattern, "biaxial", {"biaxial", "uniaxial", "triaxial"},
                     "Ribs both ways; ribs along that bars across hold together; or equilateral "
                     "triangles, whose ribs along are both diagonal families.");
  table.require(
      "Pitch along", product.pitch_along, positive,
      "Centre to centre of neighbouring ribs that run across (cross-machine direction). [m]");
  table.require("Pitch across", product.pitch_across, positive,
                "Centre to centre of neighbouring ribs that run along (machine direction). [m]");
  declare_ribs(table, product.along, "along");
  declare_ribs(table, product.across, "across");
  table.require("Poisson ratio", product.poisson_ratio, {0, 0.5, true}, "Poisson's ratio. [-]");
  table.require("Density", product.density, {100, 30000, true}, "Density of the polymer. [kg/m3]");
  table.offer(
      "Junction reach", product.junction_reach, 0, not_negative,
      "Distance from the middle of a junction up to which ribs have its thickness; 0: ribs are "
      "uniform. [m]");
  table.offer("Junction thickness", product.junction_thickness, 0, not_negative,
              "Thickness of junctions; needed with a reach. [m]");
  table.offer(
      "Junction stiffness", product.junction_stiffness, 0, not_negative,
      "Torque over in-plane angle between ribs that cross; 0: junctions are rigid. [N m/rad]");
  table.offer("Elements per rib", product.elements_per_rib, 8, {1, 1000, true},
              "Beam elements between two junctions. [-]");
}

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
  table.offer_file("Lattice file", test.lattice_file,
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

void check_ribs(const ProductRibsParameters& ribs, double neighbour_pitch,
                const std::string& direction, ParameterProblems& problems)
{
  if (ribs.width >= neighbour_pitch)
    problems.add("Product/Rib width " + direction, "Ribs that run ", direction, " are ", ribs.width,
                 " m wide, but their pitch is ", neighbour_pitch, " m: they overlap.");
  if ((ribs.youngs_modulus > 0) == (ribs.stiffness_2 > 0))
    problems.add("Product/Youngs modulus " + direction,
                 "Either Young's modulus or the stiffness at 2 % ", direction,
                 " must be given, for example a stiffness of 205000 N/m.");
  if (ribs.stiffness_5 > 0 && ribs.stiffness_2 <= 0)
    problems.add("Product/Stiffness at 5 % " + direction,
                 "It needs the stiffness at 2 %, which is not given.");
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
  check_ribs(product.along, product.pitch_across, "along", problems);
  check_ribs(product.across, product.pitch_along, "across", problems);
  const double height = std::sqrt(0.75) * product.pitch_across;
  if (product.pattern == "triaxial" && std::abs(product.pitch_along / height - 1) > 1e-3)
    problems.add("Product/Pitch along", "A triaxial geogrid with a side of ", product.pitch_across,
                 " m (Pitch across) has triangles ", height, " m high, but Pitch along is ",
                 product.pitch_along, " m.");
  const LaboratoryTestParameters& test = parameters.test;
  if (product.pattern == "triaxial" &&
      (test.test == "single-rib tension" || test.test == "flexural overhang"))
    problems.add("Laboratory/Test", "The ", test.test, " is not offered for triaxial geogrids.");
  if (product.pattern != "biaxial" && test.direction == "across")
    problems.add("Laboratory/Direction",
                 "Only biaxial geogrids are tested across, and this one is ", product.pattern, ".");
  const double thickest = std::max(product.along.thickness, product.across.thickness);
  if (product.junction_reach > 0 && product.junction_thickness < thickest)
    problems.add("Product/Junction thickness", "Junctions are ", product.junction_thickness,
                 " m thick, but must be at least as thick as their ribs, ", thickest, " m.");
  if (2 * product.junction_reach >= std::min(product.pitch_along, product.pitch_across))
    problems.add("Product/Junction reach", "A reach of ", product.junction_reach,
                 " m leaves no rib between two junctions.");
  return problems.take();
}
} // namespace interlock::coupling
