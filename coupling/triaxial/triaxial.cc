#include "coupling/triaxial/triaxial.h"

#include "coupling/stones/box_walls.h"
#include "coupling/stones/stone_batch.h"

#include <chrono>

namespace interlock::coupling
{
namespace
{
// Stones whose centre is above the surface by more than this share of a mean stone are taken off
// before the plate comes [-].
constexpr double margin_at_top = 0.5;
} // namespace

Triaxial::Triaxial(const TriaxialParameters& parameters)
    : parameters_(parameters),
      world_({}, stone_on_stone(parameters.contact), {}, parameters.gravity)
{
  world_.engine.stone_contact().friction =
      pair_friction(parameters.filling.stone_friction, parameters.contact.stone_friction,
                    parameters.contact.stone_friction);
}

void Triaxial::prepare(const Monitor& monitor, const std::vector<CaseEntry>&)
{
  const auto begin = std::chrono::steady_clock::now();
  const std::vector<Stone> stones = make_stones(parameters_.stones, monitor);
  check_stones_fit(stones, parameters_.box);
  set_up(stones);
  preparation_time_ =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

void Triaxial::set_up(const std::vector<Stone>& stones)
{
  const StoneBatch batch = add_shapes(stones, parameters_.stones.density, parameters_.time, world_);
  n_shapes = batch.shapes;
  mean_size = batch.mean_size;
  mean_sphere_radius = batch.mean_sphere_radius;
  stone_warnings_ = batch.warnings;
  preparation_ = batch.text;
  walls = build_triaxial_box(world_.engine, parameters_.box, stone_on_box(parameters_.contact));
  world_.engine.set_local_damping(parameters_.filling.local_damping);
}

std::vector<Triaxial::Stage> Triaxial::plan() const
{
  FillStage fill;
  fill.title = FillStage::kind;
  fill.height = parameters_.box.height;
  fill.margin = margin_at_top * mean_size;
  return {fill, IsotropicStage(), CompressStage()};
}

std::vector<std::string> Triaxial::history_columns() const
{
  std::vector<std::string> columns = {
      "time [s]",        "axial_strain [-]",   "axial_stress [Pa]",  "stress_x [Pa]",
      "stress_y [Pa]",   "stress_ratio [-]",   "volume_change [-]",  "porosity [-]",
      "length [m]",      "width [m]",          "height [m]",         "plate_force [N]",
      "floor_force [N]", "stone_contacts [-]", "largest_overlap [m]"};
  append_ledger_columns(columns);
  return columns;
}

PhysicsLimits Triaxial::limits() const
{
  const auto corner = [&](dem::WallId wall) { return world_.engine.wall(wall).corner; };
  PhysicsLimits limits;
  limits.region.min() = dem::Vector3::Zero();
  limits.region.max() = {corner(walls.x_moving).x(), corner(walls.y_moving).y(),
                         walls.plate < 0 ? hopper_height : corner(walls.plate).z()};
  limits.largest_overlap = parameters_.limits.overlap * mean_sphere_radius;
  limits.live_stable_step = true;
  return limits;
}

void Triaxial::begin(RunRecords& records) const
{
  records.add_stage("stones", preparation_, preparation_time_);
  for (const std::string& warning : stone_warnings_) records.warn(warning);
}

Filling Triaxial::filling()
{
  const FillingParameters& f = parameters_.filling;
  return {world_,
          parameters_.box,
          {f.seed, f.drop_height, parameters_.stones.density, n_shapes, {}},
          {f.kinetic_energy_ratio, f.settling_time_limit, mean_size, parameters_.gravity}};
}

double Triaxial::porosity() const
{
  return 1 - world_.engine.mass() / parameters_.stones.density / size().prod();
}
} // namespace interlock::coupling
