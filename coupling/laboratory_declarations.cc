#include "coupling/laboratory_declarations.h"

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
  table.offer("Youngs modulus " + direction, ribs.youngs_modulus, 0, not_negative,
              "Young's modulus" + of + "; 0: that of the secant stiffness. [Pa]");
  table.offer("Secant stiffness " + direction, ribs.secant_stiffness_2, 0, not_negative,
              "Force per width over strain of the sheet pulled " + direction +
                  ", at 2 % strain; 0: that of Young's modulus. [N/m]");
}

void declare_product(ParameterTable& table, ProductParameters& product)
{
  table.open_section("Product");
  table.offer_text("Name", product.name, "Name of the product, for tables and figures.");
  table.require(
      "Pitch along", product.pitch_along, positive,
      "Centre to centre of neighbouring ribs that run across (cross-machine direction). [m]");
  table.require("Pitch across", product.pitch_across, positive,
                "Centre to centre of neighbouring ribs that run along (machine direction). [m]");
  declare_ribs(table, product.along, "along");
  declare_ribs(table, product.across, "across");
  table.require("Poisson ratio", product.poisson_ratio, {0, 0.5, true}, "Poisson's ratio. [-]");
  table.require("Density", product.density, {100, 30000, true}, "Density of the polymer. [kg/m3]");
  table.offer("Elements per rib", product.elements_per_rib, 8, {1, 1000, true},
              "Beam elements between two junctions. [-]");
}

void declare_test(ParameterTable& table, LaboratoryTestParameters& test)
{
  table.open_section("Laboratory");
  table.require_choice("Test", test.test,
                       {"data sheet", "wide-width tension", "single-rib tension",
                        "aperture stability", "flexural overhang"},
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
  if ((ribs.youngs_modulus > 0) == (ribs.secant_stiffness_2 > 0))
    problems.add("Product/Youngs modulus " + direction,
                 "Either Young's modulus or the secant stiffness ", direction,
                 " must be given, for example a secant stiffness of 205000 N/m.");
}
} // namespace

void declare_laboratory(ParameterTable& table, LaboratoryParameters& parameters)
{
  declare_product(table, parameters.product);
  declare_test(table, parameters.test);
  declare_data_sheet(table, parameters.data_sheet);
  table.open_section("Output");
  table.offer("Report", parameters.report, true, "Draw the figures at the end of the run.");
}

std::vector<ParameterProblem> check_laboratory(const LaboratoryParameters& parameters)
{
  ParameterProblems problems;
  const ProductParameters& product = parameters.product;
  check_ribs(product.along, product.pitch_across, "along", problems);
  check_ribs(product.across, product.pitch_along, "across", problems);
  return problems.take();
}
} // namespace interlock::coupling
