#include "coupling/strength_test/specimen.h"

#include "coupling/stones/filled_box.h"
#include "coupling/stones/stone_batch.h"
#include "coupling/strength_test/consolidate_stage.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace interlock::coupling
{
namespace
{
// Stones whose centre is above the surface by more than this share of a mean stone are taken off
// before the plate comes [-].
constexpr double margin_at_top = 0.5;
// Simulated time of a filling, which ends by itself, of the cases [s].
constexpr double filling_time = 1;
} // namespace

Specimen::Specimen(const SpecimenParameters& parameters)
    : parameters_(parameters),
      world_({}, stone_on_stone(parameters.contact), {}, parameters.gravity)
{
  const double test_friction = parameters.contact.stone_friction;
  world_.engine.stone_contact().friction =
      pair_friction(parameters.filling.stone_friction, test_friction, test_friction);
}

std::vector<Stone> Specimen::make_stones(const Monitor& monitor)
{
  const auto begin = std::chrono::steady_clock::now();
  std::vector<Stone> stones = coupling::make_stones(parameters_.stones, monitor);
  check_stones_fit(stones, parameters_.box);
  preparation_time_ =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return stones;
}

void Specimen::add(const std::vector<Stone>& stones)
{
  const StoneBatch batch = add_shapes(stones, parameters_.stones.density, parameters_.time, world_);
  n_shapes = batch.shapes;
  mean_size = batch.mean_size;
  mean_sphere_radius = batch.mean_sphere_radius;
  stone_warnings_ = batch.warnings;
  preparation_ = batch.text;
  world_.engine.set_local_damping(parameters_.filling.local_damping);
}

FillStage Specimen::fill_stage() const
{
  return {FillStage::kind, parameters_.box.height, margin_at_top * mean_size};
}

Filling Specimen::filling()
{
  const FillingParameters& f = parameters_.filling;
  return {world_,
          parameters_.box,
          {f.seed, f.drop_height, parameters_.stones.density, n_shapes, {}},
          {f.kinetic_energy_ratio, f.settling_time_limit, mean_size, parameters_.gravity}};
}

void Specimen::log_preparation(RunRecords& records) const
{
  records.add_stage("stones", preparation_, preparation_time_);
  for (const std::string& warning : stone_warnings_) records.warn(warning);
}

double Specimen::first_stress(double stress) const
{
  return std::max(stress, parameters_.compaction_stress);
}

double Specimen::porosity(double volume) const
{
  return 1 - world_.engine.mass() / parameters_.stones.density / volume;
}

PhysicsLimits Specimen::limits(const dem::Vector3& far_corner) const
{
  PhysicsLimits limits;
  limits.region.min() = dem::Vector3::Zero();
  limits.region.max() = far_corner;
  limits.largest_overlap = parameters_.limits.overlap * mean_sphere_radius;
  limits.live_stable_step = true;
  return limits;
}

void describe_stones(const Specimen& specimen, nlohmann::ordered_json& results)
{
  const dem::Clumps& clumps = specimen.world().engine.clumps();
  results["stones"] = stones(clumps);
  results["mean_stone_size_m"] = specimen.mean_size;
  results["spheres_per_stone"] = double(clumps.n_spheres()) / std::max(1, clumps.size());
  results["mass_kg"] = specimen.world().engine.mass();
}

void describe_density(const Specimen& specimen, double volume, nlohmann::ordered_json& results)
{
  results["bulk_density_kg_per_m3"] = specimen.world().engine.mass() / volume;
  results["porosity"] = specimen.porosity(volume);
}

Forecast forecast(const Specimen& specimen, double consolidation, const std::string& motion_name,
                  double motion, int frames)
{
  const dem::Clumps& clumps = specimen.world().engine.clumps();
  const BoxParameters& box = specimen.parameters().box;
  Forecast result;
  result.stones = specimen.preparation();
  result.warnings = specimen.stone_warnings();
  result.clumps = expected_stones(clumps, box.length * box.width * box.height);
  result.spheres = std::llround(mean_spheres(clumps) * static_cast<double>(result.clumps));
  result.time_step = specimen.world().clock.dt;
  result.frames = frames + 1;
  const double all = static_cast<double>(result.spheres);
  result.stages = {{FillStage::kind, filling_time, 0.5 * all, false},
                   {ConsolidateStage::kind, consolidation, all, false},
                   {motion_name, motion, all, false}};
  return result;
}
} // namespace interlock::coupling
