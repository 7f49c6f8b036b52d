#include "coupling/pull_out/pull_out.h"

#include "coupling/loop/state_hash.h"
#include "coupling/stones/stone_shapes.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace interlock::coupling
{
namespace
{
using dem::Vector3;

dem::ContactProperties pair(double k1, double k2, double friction, double tangential_ratio,
                            double damping_ratio)
{
  dem::ContactProperties properties;
  properties.normal_stiffness = dem::series_stiffness(k1, k2);
  properties.tangential_stiffness = tangential_ratio * properties.normal_stiffness;
  properties.friction = friction;
  properties.damping_ratio = damping_ratio;
  return properties;
}

std::string text(const char* format, double value)
{
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, format, value);
  return buffer;
}
} // namespace

PullOut::PullOut(const PullOutParameters& parameters, const Monitor& monitor)
    : parameters_(parameters), monitor_(monitor)
{
  run_start_ = Clock::now();
  begin_stage("stones");
  const ContactParameters& c = parameters.contact;
  // The friction of a pair: what was given for it, or the smaller of the two.
  const auto friction = [](double given, double one, double other) {
    return given >= 0 ? given : std::min(one, other);
  };
  stone_on_stone_ = pair(c.stone_stiffness, c.stone_stiffness, c.stone_friction, c.tangential_ratio,
                         c.damping_ratio);
  stone_on_box_ = pair(c.stone_stiffness, c.box_stiffness,
                       friction(c.stone_on_box_friction, c.stone_friction, c.box_friction),
                       c.tangential_ratio, c.damping_ratio);
  stone_on_rib_ = pair(c.stone_stiffness, c.geogrid_stiffness,
                       friction(c.stone_on_geogrid_friction, c.stone_friction, c.geogrid_friction),
                       c.tangential_ratio, c.geogrid_damping_ratio);
  stone_on_stone_.share_among_contacts = stone_on_box_.share_among_contacts =
      c.share_among_contacts;

  std::vector<dem::ClumpShape> shapes = make_stone_shapes(parameters.stones, monitor);
  double volume = 0;
  std::size_t spheres = 0;
  for (const dem::ClumpShape& shape : shapes) {
    volume += shape.volume;
    spheres += shape.spheres.size();
    for (const dem::Sphere& sphere : shape.spheres) mean_sphere_radius_ += sphere.radius;
  }
  mean_sphere_radius_ /= spheres;
  mean_size_ = std::cbrt(6 / M_PI * volume / shapes.size());

  const std::vector<double> densities(shapes.size(), parameters.stones.density);
  engine_ = std::make_unique<dem::Engine>(std::move(shapes), stone_on_stone_, parameters.gravity);
  filling_ = std::make_unique<Filling>(*engine_, parameters.box, parameters.filling,
                                       parameters.stones.density);
  loop_ = std::make_unique<StaggeredStep>(*engine_, stone_on_rib_);
  geogrid_height_ = 0.5 * parameters.box.height;

  const dem::StableStep stable = engine_->expected_stable_step(densities, expected_contacts);
  dt_ = choose_time_step(parameters.time, stable);
  end_stage(std::to_string(densities.size()) + " stones of " +
            std::to_string(spheres / densities.size()) + " spheres on average, mean size " +
            text("%.1f", 1e3 * mean_size_) + " mm; " + time_step_budget(dt_, stable));
}

void PullOut::begin_stage(const std::string& name)
{
  summary_.stages.push_back({name, 0, 0, 0});
  stage_start_ = Clock::now();
  stage_time_ = time_;
  stage_steps_ = steps_;
}

void PullOut::end_stage(const std::string& result)
{
  StageSummary& stage = summary_.stages.back();
  stage.steps = steps_ - stage_steps_;
  stage.simulated_time = time_ - stage_time_;
  stage.wall_time = std::chrono::duration<double>(Clock::now() - stage_start_).count();
  if (monitor_.message)
    monitor_.message(stage.name + ": " + result + " (" + text("%.1f", stage.wall_time) + " s)");
}

void PullOut::warn(const std::string& sentence)
{
  summary_.warnings.push_back(sentence);
  if (monitor_.message) monitor_.message("warning: " + sentence);
}

void PullOut::step(double fraction, EnergyLedger* ledger)
{
  loop_->advance(dt_, clamp_velocity_, ledger);
  time_ += dt_;
  ++steps_;
  if (steps_ % 1000 == 0) drop_lost_stones();
  if (monitor_.progress && steps_ % 100 == 0)
    monitor_.progress({summary_.stages.back().name, fraction, time_, steps_});
}

// A stone that left through the slot would fall for ever.
void PullOut::drop_lost_stones()
{
  const std::vector<bool> lost = filling_->lost();
  const auto n = std::count(lost.begin(), lost.end(), true);
  if (n == 0) return;
  n_lost_ += static_cast<int>(n);
  loop_->remove_clumps(lost);
}

Summary PullOut::run(const std::filesystem::path& output)
{
  frames_ = std::make_unique<FieldFrames>(output);
  build_box(*engine_, parameters_.box, stone_on_box_);
  engine_->set_local_damping(parameters_.filling.local_damping);

  const bool flattened = parameters_.geogrid.placement == "flattened";
  const double underside = geogrid_height_ - 0.5 * parameters_.geogrid.rib_thickness;
  // A surface that is to be pressed flat starts with less standing out of it.
  fill_to(underside, flattened ? 0 : 0.25 * mean_size_, "fill lower half");
  if (flattened) press_surface(underside);
  place_geogrid();
  fill_to(parameters_.box.height, 0.5 * mean_size_, "fill upper half");
  if (parameters_.surcharge.force > 0)
    parameters_.surcharge.kind == "plate" ? add_plate() : add_surcharge();
  settle_before_pull();
  pull(output);
  collect_results();
  write_summary(output / "summary.json", summary_);
  return summary_;
}

// Pours, lets settle, and pours what is missing, until the mean surface is at `height`; then takes
// off the stones whose centre is higher than `height` + `margin`.
void PullOut::fill_to(double height, double margin, const std::string& stage)
{
  begin_stage(stage);
  const double area = parameters_.box.length * parameters_.box.width;
  // Rather too much than another round: the excess is taken off.
  const double expected_bulk_density = 0.62 * parameters_.stones.density;
  double surface = filling_->surface_height();
  const double close_enough = 0.2 * mean_size_;
  for (int round = 0; round < 8 && surface < height - close_enough; ++round) {
    const double fall_time = filling_->pour(expected_bulk_density * area * (height - surface));
    settle(fall_time, 0, Settling::between_pours);
    surface = filling_->surface_height();
  }
  const std::vector<bool> excess = filling_->above(height + margin);
  const auto n_excess = std::count(excess.begin(), excess.end(), true);
  loop_->remove_clumps(excess);
  settle(0.02, 0.9, Settling::between_pours);
  end_stage(std::to_string(engine_->clumps().size()) + " stones, " +
            text("%.2f", filling_->mass_in_box()) + " kg, mean surface at " +
            text("%.0f", 1e3 * filling_->surface_height()) + " mm; " + std::to_string(n_excess) +
            " stones above it were taken off");
}

double PullOut::settled_energy(Settling settling) const
{
  // Small stones keep slipping into voids for long; before the next pour that does not matter.
  const double looseness = settling == Settling::between_pours ? 10 : 1;
  const dem::ScalarField& masses = engine_->clumps().mass;
  const double weight = parameters_.gravity * std::accumulate(masses.begin(), masses.end(), 0.);
  return looseness * parameters_.filling.kinetic_energy_ratio * weight * mean_size_;
}

// Runs for at least `at_least` seconds and then until the kinetic energy is low; warns when the
// limit comes first.
void PullOut::settle(double at_least, double fraction_begin, Settling settling)
{
  const double start = time_, limit = at_least + parameters_.filling.settling_time_limit;
  const double target = settled_energy(settling);
  while (time_ - start < limit) {
    const double done = (time_ - start) / (at_least + 0.3);
    step(fraction_begin + (1 - fraction_begin) * std::min(0.99, done));
    if (steps_ % 200 == 0) {
      const double kinetic = engine_->kinetic_energy();
      if (!std::isfinite(kinetic))
        throw std::runtime_error("The simulation became unstable at t = " + text("%.6f", time_) +
                                 " s; lower Time/Safety factor.");
      if (time_ - start >= at_least && kinetic < target) return;
    }
  }
  warn("The stones had not settled after " + text("%.3g", limit) + " s in stage \"" +
       summary_.stages.back().name + "\".");
}

void PullOut::settle_before_pull()
{
  begin_stage("settle");
  settle(0.02, 0, Settling::before_pull);
  // Local damping also holds stones up a little; let them find their place without it.
  engine_->set_local_damping(0);
  settle(0.02, 0.5, Settling::before_pull);
  const dem::StableStep live = engine_->stable_step(&loop_->rib_contacts());
  describe_packing();
  end_stage("kinetic energy " + text("%.2g", engine_->kinetic_energy()) + " J; live stable step " +
            text("%.3g", 1e6 * live.step) + " us, set by a stone of " +
            text("%.1f", 1e3 * live.mass) + " g with " + std::to_string(live.contacts) +
            " contacts");
}

// Presses what stands out of the surface down with a plate that moves at a prescribed speed, until
// it is at `height` or the stones carry the force limit.
void PullOut::press_surface(double height)
{
  begin_stage("flatten");
  const dem::Clumps& clumps = engine_->clumps();
  double top = height;
  for (int i = 0; i < clumps.size(); ++i)
    for (std::size_t a = 0; a < clumps.shape_of(i).spheres.size(); ++a)
      top = std::max(top, clumps.position[i].z() + clumps.member_offset(i, a).z() +
                              clumps.shape_of(i).spheres[a].radius);
  dem::Wall plate;
  plate.name = "plate";
  plate.corner = {0, 0, top};
  plate.edge1 = {parameters_.box.length, 0, 0};
  plate.edge2 = {0, parameters_.box.width, 0};
  plate.contact = stone_on_box_;
  plate.velocity = {0, 0, -parameters_.filling.plate_speed};
  const int index = engine_->add_wall(plate);

  const double begin = top;
  double force = 0;
  while (engine_->walls()[index].corner.z() > height &&
         force < parameters_.filling.plate_force_limit) {
    step(std::min(0.8, (begin - engine_->walls()[index].corner.z()) / (begin - height)));
    force = std::max(force, engine_->walls()[index].force.z());
  }
  const double reached = engine_->walls()[index].corner.z();
  // Up again, clear of the stones.
  engine_->walls()[index].velocity = {0, 0, parameters_.filling.plate_speed};
  while (engine_->walls()[index].force.z() > 0) step(0.9);
  engine_->replace_walls(BoxWalls::first_extra, {});
  settle(0.01, 0.9, Settling::between_pours);
  end_stage("plate down from " + text("%.1f", 1e3 * begin) + " to " + text("%.1f", 1e3 * reached) +
            " mm, largest force " + text("%.0f", force) + " N");
}

void PullOut::place_geogrid()
{
  begin_stage("place geogrid");
  const double front = -parameters_.geogrid.overhang - 0.5 * parameters_.geogrid.rib_width;
  geogrid_ = std::make_unique<RibTransfer>(RibTransfer::biaxial(
      parameters_.geogrid, Vector3(front, 0.5 * parameters_.box.width, geogrid_height_),
      parameters_.gravity));
  const int before = engine_->clumps().size();
  clear_ribs();
  open_slot(*engine_, parameters_.box, stone_on_box_, geogrid_height_);
  loop_->place_geogrid(*geogrid_);
  settle(0.02, 0, Settling::between_pours);
  end_stage(std::to_string(geogrid_->lattice().n_elements()) + " beam elements, " +
            text("%.1f", 1e3 * geogrid_->mass()) + " g, " +
            (geogrid_->rigid()
                 ? std::string("rigid")
                 : "stable step of the beams alone " +
                       text("%.2f", 1e6 * geogrid_->dynamics().stable_step()) + " us") +
            "; " + std::to_string(before - engine_->clumps().size()) +
            " stones in the way of ribs were taken out");
}

// Takes out the stones that overlap a rib.
void PullOut::clear_ribs()
{
  const dem::Clumps& clumps = engine_->clumps();
  std::vector<bool> in_the_way(clumps.size(), false);
  for (int i = 0; i < clumps.size(); ++i) {
    if (std::abs(clumps.position[i].z() - geogrid_height_) >
        clumps.bounding_radius(i) + parameters_.geogrid.rib_width)
      continue;
    for (std::size_t a = 0; a < clumps.shape_of(i).spheres.size() && !in_the_way[i]; ++a) {
      const Vector3 x = clumps.position[i] + clumps.member_offset(i, a);
      const double radius = clumps.shape_of(i).spheres[a].radius;
      in_the_way[i] =
          std::any_of(geogrid_->ribs().begin(), geogrid_->ribs().end(), [&](const dem::Rib& rib) {
            return dem::rib_proximity(rib, x, radius).overlap > 0;
          });
    }
  }
  loop_->remove_clumps(in_the_way);
}

// Heavy spheres, larger than the stones, in a square pattern on the surface; together they weigh
// the given force (section 4 of the paper).
void PullOut::add_surcharge()
{
  begin_stage("surcharge");
  const double radius = parameters_.surcharge.sphere_radius, gap = 1e-3;
  const int nx = std::max(1, static_cast<int>(parameters_.box.length / (2 * radius + gap)));
  const int ny = std::max(1, static_cast<int>(parameters_.box.width / (2 * radius + gap)));
  dem::ClumpShape ball;
  ball.name = "surcharge sphere";
  ball.spheres = {{Vector3::Zero(), radius}};
  ball.volume = 4 * M_PI / 3 * std::pow(radius, 3);
  ball.unit_inertia = Vector3::Constant(0.4 * ball.volume * radius * radius);
  const double density =
      parameters_.surcharge.force / parameters_.gravity / (nx * ny) / ball.volume;
  const int shape = engine_->clumps().add_shape(ball);

  double top = 0;
  const dem::Clumps& clumps = engine_->clumps();
  for (int i = 0; i < clumps.size(); ++i)
    top = std::max(top, clumps.position[i].z() + clumps.bounding_radius(i));
  for (int i = 0; i < nx; ++i)
    for (int j = 0; j < ny; ++j)
      engine_->add_clump(shape, density,
                         {(i + 0.5) * parameters_.box.length / nx,
                          (j + 0.5) * parameters_.box.width / ny, top + radius},
                         dem::Quaternion::Identity());
  settle(0.1, 0, Settling::between_pours);
  end_stage(std::to_string(nx * ny) + " spheres of " + text("%.0f", 2e3 * radius) + " mm, " +
            text("%.1f", parameters_.surcharge.force) + " N in all");
}

// A plate over the whole box that keeps the force until the end.
void PullOut::add_plate()
{
  begin_stage("surcharge");
  const dem::Clumps& clumps = engine_->clumps();
  double top = 0;
  for (int i = 0; i < clumps.size(); ++i)
    for (std::size_t a = 0; a < clumps.shape_of(i).spheres.size(); ++a)
      top = std::max(top, clumps.position[i].z() + clumps.member_offset(i, a).z() +
                              clumps.shape_of(i).spheres[a].radius);
  surcharge_plate_ = engine_->add_wall(
      dem::rectangle_wall("surcharge plate", {0, 0, top}, {parameters_.box.length, 0, 0},
                          {0, parameters_.box.width, 0}, stone_on_box_));
  dem::ForceControl control;
  control.axis = -Vector3::UnitZ();
  control.force = parameters_.surcharge.force;
  control.largest_speed = parameters_.filling.plate_speed;
  engine_->control_wall(surcharge_plate_, control);
  settle(0.1, 0, Settling::between_pours);
  const dem::Wall& plate = engine_->walls()[surcharge_plate_];
  end_stage("plate at " + text("%.1f", 1e3 * plate.corner.z()) + " mm, presses with " +
            text("%.1f", plate.force.z()) + " N");
}
} // namespace interlock::coupling
