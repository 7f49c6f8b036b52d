#include "coupling/pull_out/pull_out.h"

#include "coupling/pull_out/protocol.h"
#include "coupling/stones/filled_box.h"
#include "coupling/stones/stone_quality.h"
#include "dem/input_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

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

// The friction of a pair: what was given for it, or the smaller of the two.
double friction_of(double given, double one, double other)
{
  return given >= 0 ? given : std::min(one, other);
}

dem::ContactProperties stones_on_stones(const ContactParameters& c)
{
  dem::ContactProperties properties = pair(c.stone_stiffness, c.stone_stiffness, c.stone_friction,
                                           c.tangential_ratio, c.damping_ratio);
  properties.share_among_contacts = c.share_among_contacts;
  return properties;
}

dem::ContactProperties stones_on_box(const ContactParameters& c)
{
  dem::ContactProperties properties =
      pair(c.stone_stiffness, c.box_stiffness,
           friction_of(c.stone_on_box_friction, c.stone_friction, c.box_friction),
           c.tangential_ratio, c.damping_ratio);
  properties.share_among_contacts = c.share_among_contacts;
  return properties;
}

dem::ContactProperties stones_on_ribs(const ContactParameters& c, const GeogridParameters& geogrid)
{
  const double friction =
      friction_of(c.stone_on_geogrid_friction, c.stone_friction, c.geogrid_friction);
  if (c.geogrid_stiffness > 0)
    return pair(c.stone_stiffness, c.geogrid_stiffness, friction, c.tangential_ratio,
                c.geogrid_damping_ratio);
  // Stone is some twenty times as stiff as polymer: the rib alone is indented.
  const dem::Elastic rock{std::numeric_limits<double>::infinity(), 0};
  return dem::hertz_mindlin_pair(rock, {geogrid.youngs_modulus, geogrid.poisson_ratio}, friction,
                                 c.geogrid_damping_ratio);
}

// Stones are poured in any attitude, their bounding balls clear of the walls.
void check_stones_fit(const std::vector<Stone>& stones, const BoxParameters& box)
{
  const double room = std::min(box.length, box.width) - 2 * pouring_clearance;
  for (const Stone& stone : stones) {
    const double size = 2 * stone.shape.bounding_radius();
    if (size > room)
      throw InputError(fmt::format("Stone {} is {:.3g} m across, but the box is only {:.3g} m {}.",
                                   stone.shape.name, size, std::min(box.length, box.width),
                                   box.length < box.width ? "long" : "wide"));
  }
}
} // namespace

PullOut::PullOut(const PullOutParameters& parameters)
    : parameters_(parameters), stone_on_stone_(stones_on_stones(parameters.contact)),
      stone_on_box_(stones_on_box(parameters.contact)),
      stone_on_rib_(stones_on_ribs(parameters.contact, parameters.geogrid)),
      world_({}, stone_on_stone_, stone_on_rib_, parameters.gravity)
{
}

void PullOut::prepare(const Monitor& monitor, const std::vector<CaseEntry>& entries)
{
  if (!parameters_.start_from.empty()) {
    start_from(parameters_.start_from, entries);
    return;
  }
  const auto begin = std::chrono::steady_clock::now();
  const std::vector<Stone> stones = make_stones(parameters_.stones, monitor);
  check_stones_fit(stones, parameters_.box);
  n_shapes = static_cast<int>(stones.size());
  double volume = 0;
  std::size_t spheres = 0;
  for (const Stone& stone : stones) {
    const dem::ClumpShape& shape = stone.shape;
    volume += shape.volume;
    spheres += shape.spheres.size();
    for (const dem::Sphere& sphere : shape.spheres) mean_sphere_radius += sphere.radius;
    world_.engine.clumps().add_shape(shape);
  }
  mean_sphere_radius /= static_cast<double>(spheres);
  mean_size = std::cbrt(6 / M_PI * volume / n_shapes);

  const dem::StableStep stable = expected_stable_step();
  choose_step(stable);
  walls = build_box(world_.engine, parameters_.box, stone_on_box_);
  world_.engine.set_local_damping(parameters_.filling.local_damping);
  preparation_ = fmt::format("{} stones of {} spheres on average, {}, mean size {:.1f} mm; {}",
                             n_shapes, spheres / n_shapes, quality_text(stones), 1e3 * mean_size,
                             time_step_budget(world_.clock.dt, stable));
  stone_warnings_ = quality_warnings(stones);
  preparation_time_ =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

// For contacts that are not there yet, or not the ones of this run.
void PullOut::choose_step(const dem::StableStep& stable)
{
  const double given = choose_time_step(parameters_.time, stable);
  world_.step_rule = step_rule(parameters_.time, stable);
  world_.clock.set_step(parameters_.time.step > 0 ? given : world_.step_rule.step({}));
}

dem::StableStep PullOut::expected_stable_step() const
{
  return world_.engine.expected_stable_step(
      std::vector<double>(n_shapes, parameters_.stones.density), expected_contacts);
}

std::vector<PullOut::Stage> PullOut::plan() const
{
  if (start_) return plan_from_state();
  const bool flattened = parameters_.geogrid.placement == "flattened";
  const double underside = geogrid_height() - 0.5 * parameters_.geogrid.rib_thickness;
  std::vector<Stage> plan;
  // A surface that is to be pressed flat starts with less standing out of it.
  const double margin = flattened ? 0 : protocol::margin_not_flattened * mean_size;
  plan.emplace_back(FillStage{"fill lower half", underside, margin});
  if (flattened) plan.emplace_back(FlattenStage{underside});
  append_upper_half(plan);
  return plan;
}

// From the placing of the geogrid on.
void PullOut::append_upper_half(std::vector<Stage>& plan) const
{
  plan.emplace_back(PlaceStage());
  plan.emplace_back(
      FillStage{"fill upper half", parameters_.box.height, protocol::margin_at_top * mean_size});
  if (parameters_.surcharge.force > 0) plan.emplace_back(LoadStage());
  plan.emplace_back(SettleStage());
  plan.emplace_back(PullStage());
}

std::vector<std::string> PullOut::history_columns() const
{
  std::vector<std::string> columns = {"time [s]",
                                      "displacement [m]",
                                      "pull_force [N]",
                                      "pull_force_filtered [N]",
                                      "rear_displacement [m]",
                                      "largest_axial_force [N]",
                                      "stone_contacts [-]",
                                      "rib_contacts [-]",
                                      "largest_overlap [m]",
                                      "substeps [-]"};
  append_ledger_columns(columns);
  return columns;
}

// Stones may leave through the slot only, towards -x.
PhysicsLimits PullOut::limits() const
{
  PhysicsLimits limits;
  limits.region.min() = Vector3(-1e300, 0, -1e300);
  limits.region.max() = Vector3(parameters_.box.length, parameters_.box.width, hopper_height);
  limits.largest_overlap = parameters_.limits.overlap * mean_sphere_radius;
  limits.break_strain = parameters_.geogrid.break_strain;
  limits.live_stable_step = true;
  return limits;
}

void PullOut::begin(RunRecords& records) const
{
  records.add_stage(start_ ? "start" : "stones", preparation_, preparation_time_);
  if (start_) records.summary.results = start_->results;
  for (const std::string& warning : stone_warnings_) records.warn(warning);
}

std::unique_ptr<RibTransfer> PullOut::make_geogrid() const
{
  const GeogridParameters& g = parameters_.geogrid;
  const Vector3 front(-g.overhang - 0.5 * g.rib_width, 0.5 * parameters_.box.width,
                      geogrid_height());
  return std::make_unique<RibTransfer>(RibTransfer::biaxial(g, front, parameters_.gravity));
}

Pouring PullOut::pouring() const
{
  return {parameters_.filling.seed,
          parameters_.filling.drop_height,
          parameters_.stones.density,
          n_shapes,
          {}};
}

SettlingParameters PullOut::settling() const
{
  return {parameters_.filling.kinetic_energy_ratio, parameters_.filling.settling_time_limit,
          mean_size};
}

double PullOut::displacement_of_rib_at_wall() const
{
  const GeogridParameters& g = parameters_.geogrid;
  if (g.apertures_along < 2) return std::numeric_limits<double>::infinity();
  return g.pitch_along - g.overhang - g.rib_width - protocol::room_at_wall * mean_size;
}

void PullOut::drop_lost_stones()
{
  constexpr int steps_between_looks = 1000;
  if (world_.clock.step % steps_between_looks != 0) return;
  const auto count = [](const std::vector<bool>& gone) {
    return static_cast<int>(std::count(gone.begin(), gone.end(), true));
  };
  if (!world_.any(count(clumps_below_floor(world_.engine.clumps())) > 0)) return;
  world_.make_whole();
  const std::vector<bool> gone = clumps_below_floor(world_.engine.clumps());
  lost += count(gone);
  world_.remove(gone);
}

bool PullOut::has_settled(const Settling& wait, RunRecords& records) const
{
  const Stillness now = stillness(wait, world_, settling());
  if (now == Stillness::timed_out)
    records.warn(fmt::format("The stones had not settled after {:.3g} s in stage \"{}\".",
                             wait.least + parameters_.filling.settling_time_limit,
                             records.stage_name()));
  return now != Stillness::moving;
}
} // namespace interlock::coupling
