#include "coupling/pull_out/pull_out.h"

#include "coupling/pull_out/protocol.h"
#include "coupling/pull_out/rib_contact.h"
#include "coupling/stones/filled_box.h"
#include "coupling/stones/stone_batch.h"
#include "dem/input_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace interlock::coupling
{
namespace
{
using dem::Vector3;

GeogridSheet laid(const PullOutParameters& p)
{
  GeogridSheet sheet = lay_geogrid(p.geogrid, front_of_geogrid(p.geogrid, p.box));
  check_sheet_fits(sheet, p.box);
  // Other sheets have been looked at before anything was laid.
  double rear = 0; // [m]
  for (int n = 0; n < sheet.lattice.n_nodes(); ++n)
    rear = std::max(rear, sheet.lattice.reference_position(n).x());
  if (p.pull.distance > rear)
    throw InputError(
        fmt::format("Pull/Distance: The geogrid is pulled over {:g} m, but only {:.4g} "
                    "m of it lie in the box.",
                    p.pull.distance, rear));
  return sheet;
}

} // namespace

PullOut::PullOut(const PullOutParameters& parameters)
    : parameters_(parameters), sheet_(laid(parameters)),
      stone_on_stone_(coupling::stone_on_stone(parameters.contact)),
      stone_on_box_(coupling::stone_on_box(parameters.contact)),
      stone_on_rib_(stone_on_geogrid(parameters)),
      world_({}, filling_contact(), stone_on_rib_, parameters.gravity)
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
  const StoneBatch batch = add_shapes(stones, world_.engine.clumps());
  n_shapes = batch.shapes;
  mean_size = batch.mean_size;
  mean_sphere_radius = batch.mean_sphere_radius;

  const dem::StableStep stable = expected_stable_step();
  choose_step(stable);
  walls = build_box(world_.engine, parameters_.box, stone_on_box_);
  world_.engine.set_local_damping(parameters_.filling.local_damping);
  preparation_ = fmt::format("{}; {}", batch.text, time_step_budget(world_.clock.dt, stable));
  stone_warnings_ = batch.warnings;
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
  std::vector<Stage> plan;
  append_lower_half(plan);
  append_upper_half(plan);
  return plan;
}

dem::ContactProperties PullOut::filling_contact() const
{
  dem::ContactProperties contact = stone_on_stone_;
  contact.friction =
      pair_friction(parameters_.filling.stone_friction, contact.friction, contact.friction);
  return contact;
}

double PullOut::mass_of_half(double bulk_density) const
{
  const BoxParameters& box = parameters_.box;
  return bulk_density * box.length * box.width * 0.5 * box.height;
}

void PullOut::append_lower_half(std::vector<Stage>& plan) const
{
  const bool flattened = parameters_.geogrid.placement == "flattened";
  const double underside = geogrid_height() - 0.5 * sheet_.thickness;
  // A surface that is to be pressed flat starts with less standing out of it.
  const double margin = flattened ? 0 : protocol::margin_not_flattened * mean_size;
  const double mass = mass_of_half(parameters_.filling.lower_bulk_density);
  plan.emplace_back(FillStage{"fill lower half", underside, margin, mass});
  if (!flattened) return;
  const double room = mass > 0 ? protocol::room_below_ribs : 0;
  plan.emplace_back(FlattenStage{"flatten", underside - room});
}

// From the placing of the geogrid on.
void PullOut::append_upper_half(std::vector<Stage>& plan) const
{
  plan.emplace_back(PlaceStage());
  const double mass = mass_of_half(parameters_.filling.upper_bulk_density);
  plan.emplace_back(FillStage{"fill upper half", parameters_.box.height,
                              protocol::margin_at_top * mean_size, mass});
  if (mass > 0) plan.emplace_back(FlattenStage{"flatten top", parameters_.box.height});
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
                                      "substeps [-]",
                                      "walls_load [N]",
                                      "longitudinal_ribs_load [N]"};
  // Numbered from the clamped one at the front.
  for (std::size_t rib = 0; rib < sheet_.rows.size(); ++rib)
    columns.push_back(fmt::format("transverse_rib_{}_load [N]", rib));
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
  fem::DynamicsOptions options;
  options.gravity = {0, 0, -parameters_.gravity};
  options.mass_damping = parameters_.geogrid.mass_damping;
  std::optional<RibBox> box;
  if (parameters_.geogrid_contact.ribs_touch_walls) box = box_of_ribs(parameters_);
  return std::make_unique<RibTransfer>(sheet_.lattice, options, sheet_.clamped,
                                       parameters_.geogrid.rigid, parameters_.geogrid.edge_rounding,
                                       box);
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
          mean_size, parameters_.gravity};
}

double PullOut::displacement_of_rib_at_wall() const
{
  return room_at_wall() - protocol::room_at_wall * mean_size;
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

Filling PullOut::filling()
{
  return {world_, parameters_.box, pouring(), settling()};
}

bool PullOut::has_settled(const Settling& wait, RunRecords& records) const
{
  return coupling::has_settled(wait, world_, settling(), records);
}
} // namespace interlock::coupling
