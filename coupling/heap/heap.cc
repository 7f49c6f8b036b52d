#include "coupling/heap/heap.h"

#include "dem/engine/insertion.h"
#include "dem/walls/mesh_wall.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace interlock::coupling
{
namespace
{
using dem::Vector3;

// So many steps between two looks at kinetic energy and lost stones.
constexpr int steps_between_looks = 200;

template <class... Values> std::string text(const char* format, Values... values)
{
  char buffer[256];
  std::snprintf(buffer, sizeof buffer, format, values...);
  return buffer;
}

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

std::vector<std::string> history_columns()
{
  std::vector<std::string> columns = {"time [s]",           "stage",
                                      "stones [-]",         "kinetic_energy [J]",
                                      "height [m]",         "radius_of_gyration [m]",
                                      "stone_contacts [-]", "largest_overlap [m]"};
  for (const auto& entry : EnergyLedger().entries())
    columns.push_back("energy_" + entry.first + " [J]");
  columns.push_back("energy_relative_error [-]");
  return columns;
}
} // namespace

Heap::Heap(const HeapParameters& parameters, const Monitor& monitor)
    : parameters_(parameters), monitor_(monitor), run_start_(Clock::now())
{
  begin_stage("stones");
  stones_ = make_stones(parameters.stones, monitor);
  std::vector<dem::ClumpShape> shapes;
  double volume = 0;
  std::size_t spheres = 0;
  for (const Stone& stone : stones_) {
    shapes.push_back(stone.shape);
    volume += stone.shape.volume;
    spheres += stone.shape.spheres.size();
    for (const dem::Sphere& sphere : stone.shape.spheres) mean_sphere_radius_ += sphere.radius;
  }
  mean_sphere_radius_ /= spheres;
  mean_size_ = std::cbrt(6 / M_PI * volume / stones_.size());

  const HeapContactParameters& c = parameters.contact;
  engine_ = std::make_unique<dem::Engine>(std::move(shapes), properties(c, c.stone_friction),
                                          parameters.gravity);
  engine_->add_wall(floor_of(parameters.drop.floor_side, properties(c, c.floor_friction)));
  if (!parameters.mesh_wall.file.empty()) {
    const MeshWallParameters& m = parameters.mesh_wall;
    dem::MeshWall wall = dem::mesh_wall("wall", dem::read_wall_mesh(m.file, m.length_unit));
    wall.contact = properties(c, m.friction);
    engine_->add_mesh_wall(wall);
  }
  engine_->set_rolling({c.rolling_friction, c.model.damping_ratio});
  engine_->set_local_damping(c.local_damping);
  const std::vector<double> densities(stones_.size(), parameters.stones.density);
  dt_ = choose_time_step(c.model, parameters.time, *engine_, densities);
  plan_ = plan_drop(stones_, parameters.drop, parameters.gravity);
  end_stage(text("%zu shapes of %.1f spheres on average, mean size %.1f mm; %zu stones let go in "
                 "%.2f s; ",
                 stones_.size(), double(spheres) / stones_.size(), 1e3 * mean_size_, plan_.size(),
                 plan_.back().time) +
            (c.model.linear() ? time_step_budget(dt_, engine_->expected_stable_step(
                                                          densities, expected_contacts))
                              : text("time step %.3g us", 1e6 * dt_)));
}

void Heap::begin_stage(const std::string& name)
{
  summary_.stages.push_back({name, 0, 0, 0});
  stage_start_ = Clock::now();
  stage_time_ = time_;
  stage_steps_ = steps_;
}

void Heap::end_stage(const std::string& result)
{
  StageSummary& stage = summary_.stages.back();
  stage.steps = steps_ - stage_steps_;
  stage.simulated_time = time_ - stage_time_;
  stage.wall_time = std::chrono::duration<double>(Clock::now() - stage_start_).count();
  if (monitor_.message)
    monitor_.message(stage.name + ": " + result + text(" (%.1f s)", stage.wall_time));
}

void Heap::warn(const std::string& sentence)
{
  summary_.warnings.push_back(sentence);
  if (monitor_.message) monitor_.message("warning: " + sentence);
}

Summary Heap::run(const std::filesystem::path& output)
{
  frames_ = std::make_unique<FieldFrames>(output);
  history_ = std::make_unique<History>(output / "history.csv", history_columns());
  drop();
  settle();
  frames_->write(time_, *engine_);
  write_stones(output / "stones.csv");
  collect_results(output);
  write_summary(output / "summary.json", summary_);
  return summary_;
}

void Heap::release_due()
{
  for (int k = engine_->clumps().size() + n_lost_; k < static_cast<int>(plan_.size()); ++k) {
    Release release = plan_[k];
    if (release.time > time_) return;
    // The plan's time lies within the last step, unless another stone was in the way.
    const double delay = time_ - release.time;
    const bool late = delay > 1.5 * dt_;
    if (late) release.time = time_;
    const Stone& stone = stones_[release.stone];
    const FallingStone falling = falling_stone(stone, release, time_, dt_, parameters_.gravity);
    if (!dem::place_is_free(engine_->clumps(), engine_->walls(), stone.shape, falling.pose.position,
                            falling.pose.orientation))
      return;
    if (late) longest_delay_ = std::max(longest_delay_, delay);
    engine_->add_clump(release.stone, parameters_.stones.density, falling.pose.position,
                       falling.pose.orientation, falling.velocity);
  }
}

// One step; now and then the ledger, for which poses and forces must belong together.
void Heap::step(double fraction)
{
  if (time_ >= next_record_) {
    engine_->compute_forces(dt_);
    record();
    engine_->kick_all(dt_);
    engine_->drift_all(dt_);
    engine_->move_walls(dt_);
    next_record_ += parameters_.output.record_interval;
  } else {
    engine_->step(dt_);
  }
  largest_overlap_ = std::max(largest_overlap_, engine_->largest_overlap());
  time_ += dt_;
  ++steps_;
  if (parameters_.output.frame_interval > 0 && time_ >= next_frame_) {
    frames_->write(time_, *engine_);
    next_frame_ += parameters_.output.frame_interval;
  }
  if (steps_ % steps_between_looks == 0) watch();
  if (monitor_.progress && steps_ % 100 == 0)
    monitor_.progress({summary_.stages.back().name, fraction, time_, steps_});
}

void Heap::watch()
{
  if (!std::isfinite(engine_->kinetic_energy()))
    throw std::runtime_error(
        text("The simulation became unstable at t = %.6f s; lower Time/Safety factor.", time_));
  drop_lost_stones();
}

// A stone that rolled over the edge of the floor would fall for ever.
void Heap::drop_lost_stones()
{
  const dem::Clumps& clumps = engine_->clumps();
  std::vector<bool> lost(clumps.size());
  for (int i = 0; i < clumps.size(); ++i)
    lost[i] = clumps.position[i].z() < -clumps.bounding_radius(i);
  const auto n = std::count(lost.begin(), lost.end(), true);
  if (n == 0) return;
  n_lost_ += static_cast<int>(n);
  engine_->remove_clumps(lost);
}

void Heap::drop()
{
  begin_stage("drop");
  const std::size_t all = plan_.size();
  while (engine_->clumps().size() + n_lost_ < static_cast<int>(all)) {
    release_due();
    step(double(engine_->clumps().size() + n_lost_) / all);
    if (time_ > 2 * plan_.back().time + 10)
      throw std::runtime_error("The place of the next stone does not become free: the heap has "
                               "grown up to Drop/Height.");
  }
  end_stage(text("%zu stones let go", all));
}

// Until the last stone has landed and then until the kinetic energy is low.
void Heap::settle()
{
  begin_stage("settle");
  const double fall = std::sqrt(2 * parameters_.drop.height / parameters_.gravity);
  const double target = parameters_.drop.kinetic_energy_ratio * weight() * mean_size_;
  const double start = time_, limit = fall + parameters_.drop.settling_time_limit;
  double kinetic = 0;
  while (time_ - start < limit) {
    step(std::min(0.99, (time_ - start) / limit));
    if (steps_ % steps_between_looks != 0 || time_ - start < fall) continue;
    kinetic = engine_->kinetic_energy();
    if (kinetic < target) break;
  }
  at_rest_time_ = time_ - start;
  if (kinetic >= target)
    warn(text("The heap was not at rest %.3g s after the last stone was let go: its kinetic energy "
              "is %.2g J, at rest means below %.2g J.",
              at_rest_time_, kinetic, target));
  engine_->compute_forces(dt_);
  record();
  end_stage(text("kinetic energy %.2g J %.2f s after the last stone was let go",
                 engine_->kinetic_energy(), at_rest_time_));
}

double Heap::weight() const
{
  const dem::ScalarField& mass = engine_->clumps().mass;
  return parameters_.gravity * std::accumulate(mass.begin(), mass.end(), 0.);
}
} // namespace interlock::coupling
