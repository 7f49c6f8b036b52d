#include "coupling/packing/packing.h"

#include "dem/bodies/refined_shape.h"
#include "dem/input_error.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace interlock::coupling
{
namespace
{
using dem::Vector3;

// Radii of the small spheres that refine a shape [m].
constexpr dem::RadiusRange small_spheres{1.5e-3, 3e-3};
// The side walls reach this far above the box of the file, so that no thrown stone leaves [m].
constexpr double headroom = 1;
// So many steps between two looks at the clock and the screen.
constexpr int batch = 100;

template <class... Values> std::string text(const char* format, Values... values)
{
  char buffer[256];
  std::snprintf(buffer, sizeof buffer, format, values...);
  return buffer;
}

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

Packing::Packing(const PackingParameters& parameters, const Monitor& monitor)
    : parameters_(parameters), monitor_(monitor), run_start_(Clock::now())
{
  begin_stage("state");
  state_ = prepared(parameters.state);
  engine_ = std::make_unique<dem::Engine>(state_.shapes, properties(parameters.contact),
                                          parameters.gravity);
  const std::vector<double> densities(state_.shapes.size(), state_.density);
  dt_ = choose_time_step(parameters.contact.model, parameters.time, *engine_, densities);
  engine_->set_list_settings({parameters.lists.inner_skin, parameters.lists.middle_skin});
  build();
  const dem::Clumps& clumps = engine_->clumps();
  for (int i = 0; i < clumps.size(); ++i) weight_ += clumps.mass[i] * parameters.gravity;
  end_stage(text("%d stones of %.0f spheres on average, weight %.1f N; time step %.3g us",
                 clumps.size(), double(clumps.n_spheres()) / clumps.size(), weight_, 1e6 * dt_));
  const double stable = engine_->stable_step().step;
  if (stable > 0 && dt_ > stable)
    warn(text(
        "The time step of %.3g us is above the stable step of %.3g us of the state's contacts.",
        1e6 * dt_, 1e6 * stable));
}

void Packing::build()
{
  build_walls(*engine_, state_.box);
  for (const PackedClump& c : state_.clumps)
    engine_->add_clump(c.shape, state_.density, c.position, c.orientation);
  // Packed stones touch from the start: what their springs hold was put in by nobody's work.
  engine_->compute_forces(dt_);
  inserted_ = engine_->energy(dt_).contact.elastic;
  if (!parameters_.state.hold_still) throw_stones();
}

// The velocities of the file and the throws.
void Packing::throw_stones()
{
  dem::Clumps& clumps = engine_->clumps();
  dem::RandomStream random(parameters_.state.seed);
  const double speed = parameters_.state.throw_speed, spin = parameters_.state.throw_spin;
  for (int i = 0; i < clumps.size(); ++i) {
    const Vector3 v = state_.clumps[i].velocity + speed * random.direction();
    const Vector3 w = state_.clumps[i].spin + spin * random.direction();
    const dem::Quaternion q = clumps.orientation[i];
    const Vector3 inertia = clumps.inertia[i];
    const Vector3 momentum = q * inertia.cwiseProduct(q.conjugate() * w).eval();
    clumps.velocity[i] = clumps.step_velocity[i] = clumps.drift_velocity[i] = v;
    clumps.angular_momentum[i] = momentum;
    clumps.spin[i] = clumps.step_spin[i] = w;
  }
  inserted_ += engine_->kinetic_energy();
}

void Packing::begin_stage(const std::string& name)
{
  summary_.stages.push_back({name, 0, 0, 0});
  stage_start_ = Clock::now();
  stage_steps_ = steps_;
  fraction_ = 0;
}

void Packing::end_stage(const std::string& result)
{
  StageSummary& stage = summary_.stages.back();
  stage.steps = steps_ - stage_steps_;
  stage.simulated_time = stage.steps * dt_;
  stage.wall_time = std::chrono::duration<double>(Clock::now() - stage_start_).count();
  if (monitor_.message)
    monitor_.message(stage.name + ": " + result + text(" (%.1f s)", stage.wall_time));
}

void Packing::warn(const std::string& sentence)
{
  summary_.warnings.push_back(sentence);
  if (monitor_.message) monitor_.message("warning: " + sentence);
}

void Packing::step()
{
  if (parameters_.state.hold_still)
    engine_->compute_forces(dt_);
  else
    engine_->step(dt_);
}

// One step, with a look at the state while poses and forces belong together.
void Packing::step_with(const std::function<void()>& look)
{
  engine_->compute_forces(dt_);
  look();
  if (!parameters_.state.hold_still) {
    engine_->kick_all(dt_);
    engine_->drift_all(dt_);
    engine_->move_walls(dt_);
  }
  ++steps_;
  time_ += dt_;
}

// Adds the wall time of the steps alone to `wall_time`.
void Packing::run_steps(int n, double& wall_time)
{
  while (n > 0) {
    const int now = std::min(n, batch);
    const Clock::time_point start = Clock::now();
    for (int k = 0; k < now; ++k) {
      step();
      const std::vector<dem::Wall>& walls = engine_->walls();
      loads_.floor -= walls[0].force.z();
      for (std::size_t w = 1; w < walls.size(); ++w) loads_.side_walls -= walls[w].force.z();
    }
    wall_time += std::chrono::duration<double>(Clock::now() - start).count();
    loads_.steps += now;
    steps_ += now;
    time_ += now * dt_;
    n -= now;
    if (monitor_.progress)
      monitor_.progress({summary_.stages.back().name, fraction_, time_, steps_});
  }
}

void Packing::warm_up()
{
  if (parameters_.warm_up_steps == 0) return;
  begin_stage("warm up");
  double wall_time = 0;
  const int total = parameters_.warm_up_steps;
  for (int done = 0; done < total; done += batch) {
    fraction_ = double(done) / total;
    run_steps(std::min(batch, total - done), wall_time);
  }
  if (!std::isfinite(engine_->kinetic_energy()))
    throw std::runtime_error("The simulation became unstable in its warm-up; lower Time/Step.");
  end_stage(text("%d steps, %.4g ms a step, kinetic energy %.2g J", total, 1e3 * wall_time / total,
                 engine_->kinetic_energy()));
}
} // namespace interlock::coupling
