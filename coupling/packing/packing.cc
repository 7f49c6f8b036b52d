#include "coupling/packing/packing.h"

#include "dem/bodies/refined_shape.h"
#include "dem/counter_stream.h"
#include "dem/input_error.h"
#include "dem/random_stream.h"

#include <fmt/format.h>

#include <chrono>

namespace interlock::coupling
{
namespace
{
using dem::Vector3;

// Radii of the small spheres that refine a shape [m].
constexpr dem::RadiusRange small_spheres{1.5e-3, 3e-3};
// The side walls reach this far above the box of the file, so that no thrown stone leaves [m].
constexpr double headroom = 1;

dem::ContactProperties properties(const PackedContactParameters& contact)
{
  dem::ContactProperties pair =
      contact_pair(contact.model, contact.normal_stiffness,
                   contact.tangential_ratio * contact.normal_stiffness, contact.friction);
  pair.normal_damping_rate = contact.normal_damping_rate;
  pair.tangential_damping_rate = contact.tangential_damping_rate;
  return pair;
}

// The floor is the first of them.
void build_walls(dem::Engine& engine, const Vector3& box)
{
  const Vector3 x(box.x(), 0, 0), y(0, box.y(), 0), z(0, 0, box.z() + headroom), origin(0, 0, 0);
  const dem::ContactProperties& contact = engine.stone_contact();
  engine.add_wall(dem::rectangle_wall("floor", origin, x, y, contact));
  engine.add_wall(dem::rectangle_wall("x = 0", origin, y, z, contact));
  engine.add_wall(dem::rectangle_wall("x = length", x, y, z, contact));
  engine.add_wall(dem::rectangle_wall("y = 0", origin, x, z, contact));
  engine.add_wall(dem::rectangle_wall("y = width", y, x, z, contact));
}

PackedState prepared(const PackedStateParameters& parameters)
{
  PackedState state = read_packed_state(parameters.file);
  dem::RandomStream random(parameters.seed);
  if (parameters.spheres_per_clump > 0)
    for (dem::ClumpShape& shape : state.shapes) {
      try {
        shape = dem::refined_shape(shape, parameters.spheres_per_clump, small_spheres, random);
      } catch (const InputError& error) {
        throw InputError("Entry Packing/Spheres per clump is " +
                         std::to_string(parameters.spheres_per_clump) + ", but: " + error.what());
      }
    }
  squeeze(state, parameters.squeeze);
  return state;
}
} // namespace

Packing::Packing(const PackingParameters& parameters)
    : parameters_(parameters), world_({}, properties(parameters.contact), {}, parameters.gravity)
{
  world_.engine.set_list_settings({parameters.lists.inner_skin, parameters.lists.middle_skin});
  world_.held = parameters.state.hold_still;
}

void Packing::prepare(const Monitor&, const std::vector<CaseEntry>&)
{
  const auto begin = std::chrono::steady_clock::now();
  const PackedState state = prepared(parameters_.state);
  for (const dem::ClumpShape& shape : state.shapes) world_.engine.clumps().add_shape(shape);
  const std::vector<double> densities(state.shapes.size(), state.density);
  world_.clock.set_step(
      choose_time_step(parameters_.contact.model, parameters_.time, world_.engine, densities));
  build(state);
  if (!parameters_.state.written.empty()) write_packed_state(parameters_.state.written, state);
  const dem::Clumps& clumps = world_.engine.clumps();
  preparation_ = fmt::format("{} stones of {:.0f} spheres on average, weight {:.1f} N; time step "
                             "{:.3g} us",
                             clumps.size(), double(clumps.n_spheres()) / clumps.size(),
                             world_.weight(), 1e6 * world_.clock.dt);
  preparation_time_ =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

void Packing::build(const PackedState& state)
{
  dem::Engine& engine = world_.engine;
  build_walls(engine, state.box);
  for (const PackedClump& c : state.clumps)
    engine.add_clump(c.shape, state.density, c.position, c.orientation);
  // Packed stones touch from the start: what their springs hold was put in by nobody's work.
  world_.compute_forces();
  world_.inserted = engine.energy(world_.clock.dt).contact.elastic;
  if (!world_.held) throw_stones(state);
}

// The velocities of the file and the throws.
void Packing::throw_stones(const PackedState& state)
{
  dem::Clumps& clumps = world_.engine.clumps();
  const double speed = parameters_.state.throw_speed, spin = parameters_.state.throw_spin;
  for (int i = 0; i < clumps.size(); ++i) {
    dem::CounterStream random(parameters_.state.seed, clumps.id[i], dem::Draw::velocity);
    const Vector3 v = state.clumps[i].velocity + speed * random.direction();
    const Vector3 w = state.clumps[i].spin + spin * random.direction();
    clumps.set_motion(i, v, w);
  }
  world_.inserted += world_.kinetic_energy();
}

std::vector<Packing::Stage> Packing::plan() const
{
  std::vector<Stage> plan;
  if (parameters_.warm_up_steps > 0) plan.emplace_back(WarmUpStage());
  plan.emplace_back(TimedStage());
  return plan;
}

std::vector<std::string> Packing::history_columns() const
{
  return {"time [s]",
          "kinetic_energy [J]",
          "touching_sphere_pairs [-]",
          "wall_contacts [-]",
          "largest_overlap [m]",
          "floor_force [N]",
          "side_wall_friction [N]",
          "energy_relative_error [-]"};
}

void Packing::begin(RunRecords& records) const
{
  records.add_stage("state", preparation_, preparation_time_);
  const double stable = world_.engine.stable_step().step, dt = world_.clock.dt;
  if (stable > 0 && dt > stable)
    records.warn(
        fmt::format("The time step of {:.3g} us is above the stable step of {:.3g} us of the "
                    "state's contacts.",
                    1e6 * dt, 1e6 * stable));
}
} // namespace interlock::coupling
