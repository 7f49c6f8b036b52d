#include "coupling/shear_box/shear_box.h"

#include "coupling/run/run_failure.h"
#include "coupling/stones/box_walls.h"
#include "dem/input_error.h"

#include <fmt/format.h>

#include <algorithm>

namespace interlock::coupling
{
namespace
{
// Simulated time of the consolidation, which ends by itself, of the case [s].
constexpr double consolidating_time = 0.4;

// A stone that fits through the gap would leave the box.
void check_gap(const std::vector<Stone>& stones, double gap)
{
  const auto smaller = [](const Stone& a, const Stone& b) {
    return a.shape.bounding_radius() < b.shape.bounding_radius();
  };
  const Stone& smallest = *std::min_element(stones.begin(), stones.end(), smaller);
  const double size = 2 * smallest.shape.bounding_radius();
  if (gap > 0.5 * size)
    throw InputError(fmt::format("Entry Box/Gap is {:.3g} m, but it must be at most half the "
                                 "size of the smallest stone, {:.3g} m ({} is {:.3g} m across).",
                                 gap, 0.5 * size, smallest.shape.name, size));
}
} // namespace

void ShearBox::set_up(const std::vector<Stone>& stones)
{
  check_gap(stones, parameters_.gap);
  specimen.add(stones);
  const SpecimenParameters& p = specimen.parameters();
  walls = build_shear_box(world().engine, p.box, parameters_.gap, parameters_.shear.distance,
                          stone_on_box(p.contact), stone_on_floor_and_plate());
}

std::vector<std::string> ShearBox::history_columns() const
{
  std::vector<std::string> columns = {"time [s]",         "displacement [m]", "shear_force [N]",
                                      "normal_force [N]", "plate_force [N]",  "friction_ratio [-]",
                                      "dilation [m]",     "porosity [-]",     "wall_friction [N]"};
  append_common_columns(columns);
  return columns;
}

PhysicsLimits ShearBox::limits() const
{
  const BoxParameters& box = specimen.parameters().box;
  return specimen.limits({box.length + parameters_.shear.distance, box.width, hopper_height});
}

double ShearBox::area() const
{
  const BoxParameters& box = specimen.parameters().box;
  return box.length * box.width;
}

double ShearBox::weight_above_plane() const
{
  const dem::Clumps& clumps = world().engine.clumps();
  const SpecimenParameters& p = specimen.parameters();
  double mass = 0;
  for (int i = 0; i < clumps.size(); ++i)
    if (clumps.position[i].z() > 0.5 * p.box.height) mass += clumps.mass[i];
  return mass * p.gravity;
}

dem::ContactProperties ShearBox::stone_on_floor_and_plate() const
{
  dem::ContactProperties contact = stone_on_box(specimen.parameters().contact);
  contact.friction =
      pair_friction(parameters_.floor_and_plate_friction, contact.friction, contact.friction);
  return contact;
}

double ShearBox::plate_force(double normal_stress) const
{
  const double force = normal_stress * area(), weight = weight_above_plane();
  if (force <= weight)
    throw RunFailure(fmt::format(
        "The stones of the upper half press on the plane with {:.4g} Pa by their weight alone, but "
        "Load/Normal stress is {:.4g} Pa; raise it, or lower Box/Height.",
        weight / area(), normal_stress));
  return force - weight;
}

Forecast forecast(const ShearBox& box)
{
  const ShearParameters& p = box.parameters().shear;
  return forecast(box.specimen, consolidating_time, ShearStage::kind,
                  p.distance / p.speed + 0.5 * p.ramp_time, box.parameters().output.field_frames);
}
} // namespace interlock::coupling
