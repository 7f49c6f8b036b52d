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
  table.open_section("Box");
  table.require("Length", parameters.box.length, positive,
                "Inner length along x, the way of the lower half. [m]");
  table.require("Width", parameters.box.width, positive, "Inner width along y. [m]");
  table.require("Height", parameters.box.height, positive,
                "Height along z up to which the box is filled; the halves meet at half of it. [m]");
  table.require("Gap", parameters.gap, not_negative, "Between the two halves. [m]");
  table.offer("Floor and plate friction", parameters.floor_and_plate_friction, -1,
              pair_friction_range,
              "Friction coefficient between stones and the floor or the plate, which laboratories "
              "make rough; -1: that of the other walls. [-]");
}

void declare_test(ParameterTable& table, ShearBoxParameters& parameters)
{
  table.open_section("Load");
  table.require("Normal stress", parameters.normal_stress, positive,
                "On the plane between the halves, weight of the stones above it included; a plate "
                "keeps its force. [Pa]");
  table.offer("Compaction stress", parameters.compaction_stress, 0, not_negative,
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
  if (p.gap >= 0.5 * p.box.height)
    problems.add("Box/Gap", "The gap is ", p.gap,
                 " m wide, but must be smaller than half the height of the box, ",
                 0.5 * p.box.height, " m.");
}

// The stones above the plane weigh at least so much: a filling is never looser than this share [-].
void check_load(const ShearBoxParameters& p, ParameterProblems& problems)
{
  constexpr double loosest_solid_share = 0.45;
  const double weight =
      0.5 * p.box.height * loosest_solid_share * p.stones.density * p.gravity; // [Pa]
  if (p.normal_stress <= weight)
    problems.add("Load/Normal stress", "The normal stress is ", p.normal_stress,
                 " Pa, but the stones of the upper half alone press with ", weight,
                 " Pa or more; raise it, or lower Box/Height.");
  if (p.compaction_stress > 0 && p.compaction_stress < p.normal_stress)
    problems.add("Load/Compaction stress", "The compaction stress is ", p.compaction_stress,
                 " Pa, but must be at least the normal stress, ", p.normal_stress,
                 " Pa, or 0 for no compaction.");
}

void check_shear(const ShearBoxParameters& p, ParameterProblems& problems)
{
  const ShearParameters& shear = p.shear;
  if (shear.distance > 0.5 * p.box.length)
    problems.add("Shear/Distance", "The lower half moves by ", shear.distance,
                 " m, but must move by at most half the length of the box, ", 0.5 * p.box.length,
                 " m.");
  const double ramp = 0.5 * shear.speed * shear.ramp_time;
  if (ramp > shear.distance)
    problems.add("Shear/Ramp time", "The lower half needs ", ramp, " m to reach full speed in ",
                 shear.ramp_time, " s, but moves by ", shear.distance, " m only.");
}
} // namespace

void declare_shear_box(ParameterTable& table, ShearBoxParameters& parameters)
{
  table.open_section("");
  table.require("Gravity", parameters.gravity, positive,
                "Acceleration of gravity, downwards along z. [m/s2]");
  declare_stones(table, parameters.stones);
  declare_box(table, parameters);
  declare_stone_contact(table, parameters.contact);
  declare_filling(table, parameters.filling);
  declare_test(table, parameters);
  declare_time(table, parameters.time);
  declare_limits_and_output(table, parameters.limits, parameters.output);
}

std::vector<ParameterProblem> check_shear_box(const ShearBoxParameters& parameters)
{
  ParameterProblems problems;
  check_stones(parameters.stones, problems);
  check_box(parameters, problems);
  check_load(parameters, problems);
  check_shear(parameters, problems);
  check_stone_contact(parameters.contact, problems);
  check_pair_friction("Box/Floor and plate friction", parameters.floor_and_plate_friction,
                      problems);
  check_pair_friction("Filling/Stone friction", parameters.filling.stone_friction, problems);
  return problems.take();
}
} // namespace interlock::coupling
