#include "coupling/heap/heap.h"

#include "coupling/stones/stone_quality.h"
#include "dem/walls/mesh_wall.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace interlock::coupling
{
namespace
{
using dem::Vector3;

dem::ContactProperties properties(const HeapContactParameters& contact, double friction)
{
  return contact_pair(contact.model, contact.normal_stiffness,
                      contact.tangential_ratio * contact.normal_stiffness, friction);
}

dem::Wall floor_of(double side, const dem::ContactProperties& contact)
{
  return dem::rectangle_wall("floor", {-0.5 * side, -0.5 * side, 0}, {side, 0, 0}, {0, side, 0},
                             contact);
}
} // namespace

Heap::Heap(const HeapParameters& parameters)
    : parameters_(parameters),
      world_({}, properties(parameters.contact, parameters.contact.stone_friction), {},
             parameters.gravity)
{
  const HeapContactParameters& c = parameters.contact;
  dem::Engine& engine = world_.engine;
  engine.add_wall(floor_of(parameters.drop.floor_side, properties(c, c.floor_friction)));
  if (!parameters.mesh_wall.file.empty()) {
    const MeshWallParameters& m = parameters.mesh_wall;
    dem::MeshWall wall =
        dem::mesh_wall("wall", dem::read_wall_mesh(m.file, m.length_unit, &wall_notes_));
    wall.contact = properties(c, m.friction);
    engine.add_mesh_wall(wall);
  }
  engine.set_rolling({c.rolling_friction, c.model.damping_ratio});
  engine.set_local_damping(c.local_damping);
}

void Heap::prepare(const Monitor& monitor, const std::vector<CaseEntry>&)
{
  const auto begin = std::chrono::steady_clock::now();
  stones = make_stones(parameters_.stones, monitor);
  double volume = 0;
  std::size_t spheres = 0;
  for (const Stone& stone : stones) {
    world_.engine.clumps().add_shape(stone.shape);
    volume += stone.shape.volume;
    spheres += stone.shape.spheres.size();
    for (const dem::Sphere& sphere : stone.shape.spheres) mean_sphere_radius += sphere.radius;
  }
  const double n = static_cast<double>(stones.size());
  mean_sphere_radius /= static_cast<double>(spheres);
  mean_size = std::cbrt(6 / M_PI * volume / n);

  const HeapContactParameters& c = parameters_.contact;
  const std::vector<double> densities(stones.size(), parameters_.stones.density);
  world_.clock.set_step(choose_time_step(c.model, parameters_.time, world_.engine, densities));
  releases = plan_drop(stones, parameters_.drop, parameters_.gravity);
  const double dt = world_.clock.dt;
  preparation_ = fmt::format(
      "{} shapes of {:.1f} spheres on average, {}, mean size {:.1f} mm; {} stones let go in {:.2f} "
      "s; "
      "{}",
      stones.size(), static_cast<double>(spheres) / n, quality_text(stones), 1e3 * mean_size,
      releases.size(), releases.back().time,
      c.model.linear()
          ? time_step_budget(dt, world_.engine.expected_stable_step(densities, expected_contacts))
          : fmt::format("time step {:.3g} us", 1e6 * dt));
  preparation_time_ =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

void Heap::begin(RunRecords& records) const
{
  records.add_stage("stones", preparation_, preparation_time_);
  for (const std::string& warning : quality_warnings(stones)) records.warn(warning);
  for (const std::string& note : wall_notes_)
    records.warn("The wall mesh \"" + parameters_.mesh_wall.file + "\" " + note + ".");
}

void Heap::drop_lost_stones()
{
  const auto below_floor = [this] {
    const dem::Clumps& clumps = world_.engine.clumps();
    std::vector<bool> gone(clumps.size());
    for (int i = 0; i < clumps.size(); ++i)
      gone[i] = clumps.position[i].z() < -clumps.bounding_radius(i);
    return gone;
  };
  const auto count = [](const std::vector<bool>& gone) {
    return static_cast<int>(std::count(gone.begin(), gone.end(), true));
  };
  if (!world_.any(count(below_floor()) > 0)) return;
  world_.make_whole();
  const std::vector<bool> gone = below_floor();
  lost += count(gone);
  world_.remove(gone);
}
} // namespace interlock::coupling
