#include "coupling/parameters/product_declarations.h"

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
  const bool has_5 = ribs.stiffness_5 > 0;
  const double strain = has_5 ? 0.05 : 0.02,
               force = strain * (has_5 ? ribs.stiffness_5 : ribs.stiffness_2);
  const bool stiffens = has_5 && ribs.stiffness_5 > ribs.stiffness_2; // refused by the law
  if (!stiffens && ribs.strength > 0 && ribs.strength < force)
    problems.add("Product/Strength " + direction, "Ribs that yield at ", ribs.strength,
                 " N/m cannot carry the ", force, " N/m that the stiffness says for a strain of ",
                 100 * strain, " %.");
}
} // namespace

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

void check_product(const ProductParameters& product, ParameterProblems& problems)
{
  check_ribs(product.along, product.pitch_across, "along", problems);
  check_ribs(product.across, product.pitch_along, "across", problems);
  const double height = std::sqrt(0.75) * product.pitch_across;
  if (product.pattern == "triaxial" && std::abs(product.pitch_along / height - 1) > 1e-3)
    problems.add("Product/Pitch along", "A triaxial geogrid with a side of ", product.pitch_across,
                 " m (Pitch across) has triangles ", height, " m high, but Pitch along is ",
                 product.pitch_along, " m.");
  const double thickest = std::max(product.along.thickness, product.across.thickness);
  if (product.junction_reach > 0 && product.junction_thickness < thickest)
    problems.add("Product/Junction thickness", "Junctions are ", product.junction_thickness,
                 " m thick, but must be at least as thick as their ribs, ", thickest, " m.");
  if (2 * product.junction_reach >= std::min(product.pitch_along, product.pitch_across))
    problems.add("Product/Junction reach", "A reach of ", product.junction_reach,
                 " m leaves no rib between two junctions.");
}
} // namespace interlock::coupling
