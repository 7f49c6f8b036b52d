#include "coupling/triaxial/triaxial_declarations.h"

#include "coupling/parameters/filling_declarations.h"
#include "coupling/parameters/stone_contact.h"
#include "coupling/parameters/stone_declarations.h"

namespace interlock::coupling
{
namespace
{
void declare_test(ParameterTable& table, TriaxialParameters& parameters)
{
  // Half of the height is more than any triaxial test is driven to.
  const Range strain_range{0, 0.5, false};
  declare_load(table, parameters.specimen, "Cell pressure", parameters.cell_pressure,
               "That the sides keep, and before the compression the plate. [Pa]",
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
  SpecimenParameters& specimen = parameters.specimen;
  declare_stones_and_box(
      table, specimen,
      "Acceleration of gravity, downwards along z, until the plate lies on the stones; the test is "
      "made without. [m/s2]",
      "Inner length along x of the box that the stones are poured into. [m]",
      "Height along z up to which the box is filled. [m]");
  declare_stone_contact(table, specimen.contact);
  declare_filling(table, specimen.filling);
  declare_test(table, parameters);
  declare_time(table, specimen.time);
  declare_limits_and_output(table, specimen.limits, parameters.output);
}

std::vector<ParameterProblem> check_triaxial(const TriaxialParameters& parameters)
{
  ParameterProblems problems;
  const SpecimenParameters& specimen = parameters.specimen;
  check_stones(specimen.stones, problems);
  check_stone_contact(specimen.contact, problems);
  check_pair_friction("Filling/Stone friction", specimen.filling.stone_friction, problems);
  check_compaction(specimen, parameters.cell_pressure, "cell pressure", problems);
  check_compression(parameters.compression, problems);
  return problems.take();
}
} // namespace interlock::coupling
