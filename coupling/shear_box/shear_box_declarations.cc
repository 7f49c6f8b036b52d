#include "coupling/shear_box/shear_box_declarations.h"

#include "coupling/parameters/filling_declarations.h"
#include "coupling/parameters/stone_contact.h"
#include "coupling/parameters/stone_declarations.h"

namespace interlock::coupling
{
namespace
{
void declare_box(ParameterTable& table, ShearBoxParameters& parameters)
{
  declare_stones_and_box(
      table, parameters.specimen, "Acceleration of gravity, downwards along z. [m/s2]",
      "Inner length along x, the way of the lower half. [m]",
      "Height along z up to which the box is filled; the halves meet at half of it. [m]");
  table.require("Gap", parameters.gap, not_negative, "Between the two halves. [m]");
  table.offer("Floor and plate friction", parameters.floor_and_plate_friction, -1,
              pair_friction_range,
              "Friction coefficient between stones and the floor or the plate, which laboratories "
              "make rough; -1: that of the other walls. [-]");
}

void declare_test(ParameterTable& table, ShearBoxParameters& parameters)
{
  declare_load(table, parameters.specimen, "Normal stress", parameters.normal_stress,
               "On the plane between the halves, weight of the stones above it included; a plate "
               "keeps its force. [Pa]",
               "The same while the stones still have the friction of the filling: the plate first "
               "presses with that, then with the normal stress; 0: never with more. [Pa]");
  table.open_section("Shear");
  table.require("Speed", parameters.shear.speed, positive, "Speed of the lower half. [m/s]");
  table.require("Distance", parameters.shear.distance, positive,
                "Displacement of the lower half at the end. [m]");
  table.require("Ramp time", parameters.shear.ramp_time, not_negative,
                "Time from rest to full speed. [s]");
}

void check_box(const ShearBoxParameters& p, ParameterProblems& problems)
{
  const double half = 0.5 * p.specimen.box.height;
  if (p.gap >= half)
    problems.add("Box/Gap", "The gap is ", p.gap,
                 " m wide, but must be smaller than half the height of the box, ", half, " m.");
}

// The stones above the plane weigh at least so much: a filling is never looser than this share [-].
void check_load(const ShearBoxParameters& p, ParameterProblems& problems)
{
  constexpr double loosest_solid_share = 0.45;
  const SpecimenParameters& s = p.specimen;
  const double weight =
      0.5 * s.box.height * loosest_solid_share * s.stones.density * s.gravity; // [Pa]
  if (p.normal_stress <= weight)
    problems.add("Load/Normal stress", "The normal stress is ", p.normal_stress,
                 " Pa, but the stones of the upper half alone press with ", weight,
                 " Pa or more; raise it, or lower Box/Height.");
  check_compaction(s, p.normal_stress, "normal stress", problems);
}

void check_shear(const ShearBoxParameters& p, ParameterProblems& problems)
{
  const ShearParameters& shear = p.shear;
  const double farthest = 0.5 * p.specimen.box.length;
  if (shear.distance > farthest)
    problems.add("Shear/Distance", "The lower half moves by ", shear.distance,
                 " m, but must move by at most half the length of the box, ", farthest, " m.");
  const double ramp = 0.5 * shear.speed * shear.ramp_time;
  if (ramp > shear.distance)
    problems.add("Shear/Ramp time", "The lower half needs ", ramp, " m to reach full speed in ",
                 shear.ramp_time, " s, but moves by ", shear.distance, " m only.");
}
} // namespace

void declare_shear_box(ParameterTable& table, ShearBoxParameters& parameters)
{
  SpecimenParameters& specimen = parameters.specimen;
  declare_box(table, parameters);
  declare_stone_contact(table, specimen.contact);
  declare_filling(table, specimen.filling);
  declare_test(table, parameters);
  declare_time(table, specimen.time);
  declare_limits_and_output(table, specimen.limits, parameters.output);
}

std::vector<ParameterProblem> check_shear_box(const ShearBoxParameters& parameters)
{
  ParameterProblems problems;
  const SpecimenParameters& specimen = parameters.specimen;
  check_stones(specimen.stones, problems);
  check_box(parameters, problems);
  check_pair_friction("Box/Floor and plate friction", parameters.floor_and_plate_friction,
                      problems);
  check_stone_contact(specimen.contact, problems);
  check_pair_friction("Filling/Stone friction", specimen.filling.stone_friction, problems);
  check_load(parameters, problems);
  check_shear(parameters, problems);
  return problems.take();
}
} // namespace interlock::coupling
