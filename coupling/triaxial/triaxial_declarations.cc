#include "coupling/triaxial/triaxial_declarations.h"

#include "coupling/parameters/filling_declarations.h"
#include "coupling/parameters/stone_contact.h"
#include "coupling/parameters/stone_declarations.h"

namespace interlock::coupling
{
namespace
{
void declare_box(ParameterTable& table, TriaxialParameters& parameters)
{
  table.open_section("Box");
  table.require("Length", parameters.box.length, positive,
                "Inner length along x of the box that the stones are poured into. [m]");
  table.require("Width", parameters.box.width, positive, "Inner width along y. [m]");
  table.require("Height", parameters.box.height, positive,
                "Height along z up to which the box is filled. [m]");
}

void declare_test(ParameterTable& table, TriaxialParameters& parameters)
{
  // Half of the height is more than any triaxial test is driven to.
  const Range strain_range{0, 0.5, false};
  table.open_section("Load");
  table.require("Cell pressure", parameters.cell_pressure, positive,
                "That the sides keep, and before the compression the plate. [Pa]");
  table.offer("Compaction stress", parameters.compaction_stress, 0, not_negative,
              "The same while the stones still have the friction of the filling: sides and plate "
              "first press with that, then with the cell pressure; 0: never with more. [Pa]");
  table.open_section("Compression");
  table.require("Strain rate", parameters.compression.strain_rate, positive,
                "Speed of the plate over the height when the compression begins. [1/s]");
  table.require("Strain", parameters.compression.strain, strain_range,
                "Way of the plate at the end over that height. [-]");
  table.require("Ramp time", parameters.compression.ramp_time, not_negative,
                "Time from rest to full speed. [s]");
}

void check_compression(const CompressionParameters& p, ParameterProblems& problems)
{
  const double ramp = 0.5 * p.strain_rate * p.ramp_time;
  if (ramp > p.strain)
    problems.add("Compression/Ramp time", "The plate needs a strain of ", ramp,
                 " to reach full speed in ", p.ramp_time, " s, but compresses by ", p.strain,
                 " only.");
}
} // namespace

void declare_triaxial(ParameterTable& table, TriaxialParameters& parameters)
{
  table.open_section("");
  table.require("Gravity", parameters.gravity, positive,
                "Acceleration of gravity, downwards along z, until the plate lies on the stones; "
                "the test is made without. [m/s2]");
  declare_stones(table, parameters.stones);
  declare_box(table, parameters);
  declare_stone_contact(table, parameters.contact);
  declare_filling(table, parameters.filling);
  declare_test(table, parameters);
  declare_time(table, parameters.time);
  declare_limits_and_output(table, parameters.limits, parameters.output);
}

std::vector<ParameterProblem> check_triaxial(const TriaxialParameters& parameters)
{
  ParameterProblems problems;
  check_stones(parameters.stones, problems);
  check_stone_contact(parameters.contact, problems);
  check_pair_friction("Filling/Stone friction", parameters.filling.stone_friction, problems);
  check_compression(parameters.compression, problems);
  if (parameters.compaction_stress > 0 && parameters.compaction_stress < parameters.cell_pressure)
    problems.add("Load/Compaction stress", "The compaction stress is ",
                 parameters.compaction_stress, " Pa, but must be at least the cell pressure, ",
                 parameters.cell_pressure, " Pa, or 0 for no compaction.");
  return problems.take();
}
} // namespace interlock::coupling
