#include "coupling/pull_out/protocol.h"
#include "coupling/pull_out/pull_out.h"
#include "coupling/pull_out/wedge.h"
#include "coupling/stones/soft_start.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace interlock::coupling
{
namespace
{
// Mean of the last values that lie within `window` of the last position.
double mean_over_window(const std::vector<double>& position, const std::vector<double>& value,
                        double window)
{
  double sum = 0;
  int n = 0;
  for (std::size_t k = value.size(); k-- > 0 && position.back() - position[k] <= window;) {
    sum += value[k];
    ++n;
  }
  return sum / n;
}

// Stones caught between the second transverse rib and the front wall carry the pull on their own.
void warn_of_rib_at_wall(const PullOut& experiment, RunRecords& records)
{
  const double distance = experiment.parameters().pull.distance, size = experiment.mean_size;
  const double limit = experiment.displacement_of_rib_at_wall();
  if (distance > limit)
    records.warn(fmt::format(
        "From {:.1f} mm on the second transverse rib is nearer to the front wall than half a stone "
        "of {:.1f} mm: stones caught there raise the force; {:.1f} mm are left at the end.",
        1e3 * std::max(0., limit), 1e3 * size, 1e3 * (experiment.room_at_wall() - distance)));
}

// Where the pull leaves its bounds.
void note_bounds(PullStage& stage, const PullOut& experiment)
{
  const auto mark = [&](double& left_at, bool outside) {
    if (outside && left_at < 0) left_at = stage.displacement;
  };
  // Before the first millimetre there is no work to compare with.
  const EnergyLedger change = difference(stage.ledger, stage.ledger_at_begin);
  const bool outside = std::abs(change.residual()) > ledger_bound * std::abs(change.clamp_work);
  if (!outside) stage.ledger_left_at = -1;
  mark(stage.ledger_left_at, outside && stage.displacement > protocol::filter_length);
  const double overlap_bound = protocol::usable_overlap * experiment.mean_sphere_radius;
  mark(stage.overlap_left_at, stage.largest_overlap > overlap_bound);
  if (stage.overlap_left_at >= 0 && stage.wedge.empty()) {
    stage.wedge = wedged_stone(experiment.world(), overlap_bound);
    stage.wedged_from = stage.displacement;
  }
  mark(stage.stretch_left_at, stage.largest_stretch > protocol::usable_stretch);
}

// Mean way of the nodes of the rear edge, along the pull [m].
double rear_displacement(const fem::ExplicitDynamics& dynamics)
{
  const fem::Lattice& lattice = dynamics.lattice();
  double rear_x = -1e300, way = 0;
  for (int node = 0; node < lattice.n_nodes(); ++node)
    rear_x = std::max(rear_x, lattice.reference_position(node).x());
  int n = 0;
  for (int node = 0; node < lattice.n_nodes(); ++node)
    if (lattice.reference_position(node).x() > rear_x - 1e-6) {
      way += lattice.reference_position(node).x() - dynamics.position(node).x();
      ++n;
    }
  return way / n;
}

double largest_axial_force(const fem::ExplicitDynamics& dynamics)
{
  double largest = 0;
  for (int e = 0; e < dynamics.lattice().n_elements(); ++e)
    largest = std::max(largest, std::abs(dynamics.section_forces(e).axial));
  return largest;
}

// Of the walls of the box and the edges of its slot; positive when it resists the pull [N].
double load_of_walls(const RibTransfer& geogrid)
{
  return geogrid.walls() ? geogrid.walls()->force().x() : 0;
}

// What resists the pull: of all longitudinal ribs together, of each transverse row.
void append_loads_on_ribs(std::vector<History::Cell>& row, const PullOut& experiment)
{
  const std::vector<double> loads = experiment.world().ribs.loads_on_lines();
  const auto sum = [&](const std::vector<int>& lines) {
    return std::accumulate(lines.begin(), lines.end(), 0.,
                           [&](double sum, int line) { return sum + loads[line]; });
  };
  row.emplace_back(sum(experiment.sheet().along));
  for (const std::vector<int>& lines : experiment.sheet().rows) row.emplace_back(sum(lines));
}

// Whether the step to come is the last one that is not beyond one of Output/Frames at. What it goes
// by is in the state already, so that a resumed pull may have other places.
bool passes_a_frame(const PullStage& stage, const PullOut& experiment)
{
  const std::vector<double>& places = experiment.parameters().frames_at;
  return std::any_of(places.begin(), places.end(), [&](double place) {
    return stage.displacement <= place && place < stage.next_displacement;
  });
}

void record(PullStage& stage, PullOut& experiment, RunRecords& records)
{
  World& world = experiment.world();
  stage.ledger = world.ledger();
  if (stage.records == 0) stage.ledger_at_begin = stage.ledger;
  // The first record has no step behind it: the clamp's force of the settling.
  const double force =
      stage.impulse_time > 0 ? stage.impulse / stage.impulse_time : -world.ribs.clamp_force().x();
  stage.impulse = stage.impulse_time = 0;
  stage.record_displacements.push_back(stage.displacement);
  stage.record_forces.push_back(force);
  stage.filtered_forces.push_back(
      mean_over_window(stage.record_displacements, stage.record_forces, protocol::filter_length));
  const dem::StableStep live = world.stable_step();
  if (live.step > 0) stage.smallest_stable_step = std::min(stage.smallest_stable_step, live.step);
  const double axial = largest_axial_force(world.geogrid()->dynamics());
  stage.largest_axial_force = std::max(stage.largest_axial_force, axial);
  stage.largest_stretch = std::max(stage.largest_stretch, largest_stretch(world).strain);

  std::vector<History::Cell> row = {world.clock.time(),
                                    stage.displacement,
                                    force,
                                    stage.filtered_forces.back(),
                                    rear_displacement(world.geogrid()->dynamics()),
                                    axial,
                                    static_cast<double>(world.touching_spheres()),
                                    static_cast<double>(world.touching_ribs()),
                                    world.largest(world.largest_overlap()),
                                    static_cast<double>(world.ribs.substeps()),
                                    load_of_walls(*world.geogrid())};
  append_loads_on_ribs(row, experiment);
  append_ledger(row, stage.ledger);
  records.add(row);
  ++stage.records;
  note_bounds(stage, experiment);
}
} // namespace

StageStatus before_step(PullStage& stage, PullOut& experiment, RunRecords& records)
{
  World& world = experiment.world();
  const PullParameters& p = experiment.parameters().pull;
  if (stage.over)
    return finished(fmt::format("{:.1f} mm, pull force at the end {:.0f} N",
                                1e3 * stage.displacement, stage.filtered_forces.back()));
  experiment.drop_lost_stones();
  if (!stage.begun) {
    stage.begun = true;
    stage.begin = world.clock.time();
    warn_of_rib_at_wall(experiment, records);
  }
  world.clamp_velocity = {-p.speed * soft_start(world.clock.time() - stage.begin, p.ramp_time), 0,
                          0};
  const double progress = stage.displacement / p.distance;
  const OutputParameters& output = experiment.parameters().output;
  stage.is_last = progress >= 1;
  stage.record_due = stage.is_last || progress * output.records >= stage.records;
  stage.frame_due =
      output.field_frames > 0 && (stage.is_last || progress * output.field_frames >= stage.frames);
  stage.next_displacement = stage.displacement - world.clamp_velocity.x() * world.clock.dt;
  stage.extra_frame_due = passes_a_frame(stage, experiment);
  if (stage.is_last || stage.frame_due || stage.extra_frame_due)
    return running(progress, Look::at_everything);
  return running(progress, stage.record_due ? Look::at_part : Look::none);
}

void unite_notes(PullStage& stage, PullOut& experiment)
{
  stage.largest_overlap = experiment.world().largest(stage.largest_overlap);
}

void look(PullStage& stage, PullOut& experiment, RunRecords& records)
{
  World& world = experiment.world();
  stage.over = stage.is_last;
  stage.largest_overlap = std::max(stage.largest_overlap, world.largest_overlap());
  unite_notes(stage, experiment);
  if (stage.record_due) record(stage, experiment, records);
  if (stage.frame_due) ++stage.frames;
  if (stage.frame_due || stage.extra_frame_due) records.add_frame(world);
}

void after_step(PullStage& stage, PullOut& experiment, RunRecords&)
{
  World& world = experiment.world();
  const double dt = world.clock.dt;
  stage.largest_overlap = std::max(stage.largest_overlap, world.largest_overlap());
  stage.displacement = stage.next_displacement;
  stage.impulse -= world.ribs.clamp_force().x() * dt;
  stage.impulse_time += dt;
  if (experiment.surcharge_plate >= 0)
    stage.plate_impulse += dt * world.engine.wall(experiment.surcharge_plate).force.z();
}
} // namespace interlock::coupling
