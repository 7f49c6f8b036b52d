#include "coupling/shear_box/shear_box.h"

#include "coupling/run/run_failure.h"
#include "coupling/stones/box_walls.h"
#include "coupling/stones/filled_box.h"
#include "coupling/stones/stone_batch.h"
#include "dem/input_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

namespace interlock::coupling
{
namespace
{
// Stones whose centre is above the surface by more than this share of a mean stone are taken off
// before the plate comes [-].
constexpr double margin_at_top = 0.5;

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

ShearBox::ShearBox(const ShearBoxParameters& parameters)
    : parameters_(parameters),
      world_({}, stone_on_stone(parameters.contact), {}, parameters.gravity)
{
  world_.engine.stone_contact().friction =
      pair_friction(parameters.filling.stone_friction, parameters.contact.stone_friction,
                    parameters.contact.stone_friction);
}

void ShearBox::prepare(const Monitor& monitor, const std::vector<CaseEntry>&)
{
  const auto begin = std::chrono::steady_clock::now();
  const std::vector<Stone> stones = make_stones(parameters_.stones, monitor);
  check_stones_fit(stones, parameters_.box);
  set_up(stones);
  preparation_time_ =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

void ShearBox::set_up(const std::vector<Stone>& stones)
{
  check_gap(stones, parameters_.gap);
  const StoneBatch batch = add_shapes(stones, parameters_.stones.density, parameters_.time, world_);
  n_shapes = batch.shapes;
  mean_size = batch.mean_size;
  mean_sphere_radius = batch.mean_sphere_radius;
  stone_warnings_ = batch.warnings;
  preparation_ = batch.text;
  walls =
      build_shear_box(world_.engine, parameters_.box, parameters_.gap, parameters_.shear.distance,
                      stone_on_box(parameters_.contact), stone_on_floor_and_plate());
  world_.engine.set_local_damping(parameters_.filling.local_damping);
}

std::vector<ShearBox::Stage> ShearBox::plan() const
{
  FillStage fill;
  fill.title = FillStage::kind;
  fill.height = parameters_.box.height;
  fill.margin = margin_at_top * mean_size;
  return {fill, ConsolidateStage(), ShearStage()};
}

std::vector<std::string> ShearBox::history_columns() const
{
  std::vector<std::string> columns = {
      "time [s]",          "displacement [m]",   "shear_force [N]",    "normal_force [N]",
      "plate_force [N]",   "friction_ratio [-]", "dilation [m]",       "porosity [-]",
      "wall_friction [N]", "stone_contacts [-]", "largest_overlap [m]"};
  append_ledger_columns(columns);
  return columns;
}

PhysicsLimits ShearBox::limits() const
{
  PhysicsLimits limits;
  limits.region.min() = dem::Vector3::Zero();
  limits.region.max() = {parameters_.box.length + parameters_.shear.distance, parameters_.box.width,
                         hopper_height};
  limits.largest_overlap = parameters_.limits.overlap * mean_sphere_radius;
  limits.live_stable_step = true;
  return limits;
}

void ShearBox::begin(RunRecords& records) const
{
  records.add_stage("stones", preparation_, preparation_time_);
  for (const std::string& warning : stone_warnings_) records.warn(warning);
}

Filling ShearBox::filling()
{
  const FillingParameters& f = parameters_.filling;
  return {world_,
          parameters_.box,
          {f.seed, f.drop_height, parameters_.stones.density, n_shapes, {}},
          {f.kinetic_energy_ratio, f.settling_time_limit, mean_size, parameters_.gravity}};
}

double ShearBox::weight_above_plane() const
{
  const dem::Clumps& clumps = world_.engine.clumps();
  double mass = 0;
  for (int i = 0; i < clumps.size(); ++i)
    if (clumps.position[i].z() > 0.5 * parameters_.box.height) mass += clumps.mass[i];
  return mass * parameters_.gravity;
}

dem::ContactProperties ShearBox::stone_on_floor_and_plate() const
{
  dem::ContactProperties contact = stone_on_box(parameters_.contact);
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

double ShearBox::porosity() const
{
  const double solid = world_.engine.mass() / parameters_.stones.density;
  return 1 - solid / (area() * plate_height());
}
} // namespace interlock::coupling
