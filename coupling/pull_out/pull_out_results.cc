// What a pull-out run leaves in its summary.
#include "coupling/pull_out/protocol.h"
#include "coupling/pull_out/pull_out.h"
#include "coupling/stones/filled_box.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace interlock::coupling
{
namespace
{
using dem::Vector3;

// How far a node is in a side wall or the floor, and a rib that leaves the box in the front wall
// above or below its slot, at most [m]: the overlap of their contacts, or what nobody holds where
// ribs do not touch walls. Not negative.
double way_into_walls(const PullOut& experiment)
{
  const fem::ExplicitDynamics& ribs = experiment.world().geogrid()->dynamics();
  const BoxParameters& box = experiment.parameters().box;
  double into = 0;
  for (int e = 0; e < ribs.lattice().n_elements(); ++e) {
    const fem::RibSection& shape = ribs.lattice().shape(e);
    const bool across = std::abs((ribs.lattice().element(e).frame * Vector3::UnitX()).y()) > 0.5;
    const double beside = across ? 0 : 0.5 * shape.width, below = 0.5 * shape.thickness;
    const Vector3 a = ribs.end_position(e, 0), b = ribs.end_position(e, 1);
    for (const Vector3& x : {a, b})
      if (x.x() > 0)
        into = std::max(
            {into, std::abs(x.y() - 0.5 * box.width) + beside - 0.5 * box.width, below - x.z()});
    if (a.x() * b.x() >= 0) continue;
    const double height = (b.x() * a.z() - a.x() * b.z()) / (b.x() - a.x()); // in the wall's plane
    into = std::max(into,
                    std::abs(height - experiment.geogrid_height()) + below - 0.5 * box.slot_height);
  }
  return into;
}

void describe_pull(const PullStage& pull, const PullOut& experiment,
                   nlohmann::ordered_json& results)
{
  const World& world = experiment.world();
  // The first record stands for no displacement.
  const std::vector<double>&filtered = pull.filtered_forces, &forces = pull.record_forces;
  const auto peak = std::max_element(filtered.begin() + 1, filtered.end());
  const auto raw_peak = std::max_element(forces.begin() + 1, forces.end());
  results["mean_sphere_radius_m"] = experiment.mean_sphere_radius;
  results["largest_overlap_m"] = pull.largest_overlap;
  results["largest_overlap_over_mean_sphere_radius"] =
      pull.largest_overlap / experiment.mean_sphere_radius;
  results["pull_speed_m_per_s"] = experiment.parameters().pull.speed;
  results["pull_distance_m"] = pull.record_displacements.back();
  if (experiment.surcharge_plate >= 0) {
    results["surcharge_plate_mean_force_N"] =
        pull.plate_impulse / (world.clock.time() - pull.begin);
    results["surcharge_plate_height_at_end_m"] =
        world.engine.wall(experiment.surcharge_plate).corner.z();
  }
  // Filtered: mean over the last millimetre. Raw: mean between two records.
  results["pull_force_at_end_N"] = filtered.back();
  results["peak_pull_force_N"] = *peak;
  results["displacement_at_peak_m"] = pull.record_displacements[peak - filtered.begin()];
  results["peak_pull_force_between_records_N"] = *raw_peak;
  results["largest_axial_force_in_a_rib_N"] = pull.largest_axial_force;
  results["largest_stretch_of_a_rib"] = pull.largest_stretch;
  results["ribs_in_walls_at_end_m"] = way_into_walls(experiment);
  results["mean_surface_height_after_pull_m"] =
      surface_height(world.engine.clumps(), experiment.parameters().box);
  results["smallest_stable_step_s"] = pull.smallest_stable_step;
  results["stones_lost_through_slot"] = experiment.lost;
  results["substeps"] = world.ribs.substeps();
}

void describe_energy(const PullStage& pull, Summary& summary)
{
  add_ledger(summary, pull.ledger);
  const EnergyLedger change = difference(pull.ledger, pull.ledger_at_begin);
  summary.energy["interface_residual_J"] = pull.ledger.interface_residual();
  summary.energy["pull_interface_residual_J"] = change.interface_residual();
  summary.energy["pull_clamp_work_J"] = change.clamp_work;
  summary.energy["pull_residual_J"] = change.residual();
  summary.energy["pull_relative_error"] =
      change.clamp_work != 0 ? std::abs(change.residual() / change.clamp_work) : 0;
}

// From where on the pull is not to be used, and why; what is only doubtful does not fail the run.
void describe_usability(const PullStage& pull, const PullOut& experiment, Summary& summary)
{
  struct Bound {
    double left_at; // [m]
    bool fails;
    std::string reason;
  };
  const double at_wall = experiment.displacement_of_rib_at_wall();
  if (!pull.wedge.empty()) {
    summary.results["wedged_stone"] = pull.wedge;
    summary.results["wedged_from_mm"] = 1e3 * pull.wedged_from;
  }
  // Stones that crush are meant to be pressed in.
  const bool crushes = experiment.parameters().contact.crushing_pressure > 0;
  const std::vector<Bound> bounds = {
      {pull.ledger_left_at, true,
       fmt::format("the energy ledger of the pull misses more than {:.2g} of the clamp's work",
                   ledger_bound)},
      {pull.overlap_left_at, !crushes,
       fmt::format("a contact overlaps by more than {:.2g} of the mean radius of a sphere ({})",
                   protocol::usable_overlap,
                   pull.wedge.empty() ? "a wedged stone?" : "wedged: " + pull.wedge)},
      {pull.stretch_left_at, true,
       fmt::format("a rib is stretched by more than {:.2g} %, the largest strain of data sheets",
                   100 * protocol::usable_stretch)},
      {pull.record_displacements.back() > at_wall ? std::max(0., at_wall) : -1, false,
       "the second transverse rib squeezes stones against the front wall"}};
  const Bound* first = nullptr;
  for (const Bound& bound : bounds)
    if (bound.left_at >= 0 && (!first || bound.left_at < first->left_at)) first = &bound;
  if (!first) return;
  const std::string sentence = fmt::format("From {:.1f} mm on the pull is not to be used: {}.",
                                           1e3 * first->left_at, first->reason);
  summary.results["not_usable_from_mm"] = 1e3 * first->left_at;
  summary.results["not_usable_because"] = first->reason;
  if (std::any_of(bounds.begin(), bounds.end(),
                  [](const Bound& b) { return b.fails && b.left_at >= 0; }))
    summary.not_usable = sentence;
}

// How far the geogrid has left the plane in which it was laid. On all ranks: everything is whole.
void describe_flatness(const PullOut& experiment, nlohmann::ordered_json& results)
{
  const fem::ExplicitDynamics& ribs = experiment.world().geogrid()->dynamics();
  const int n = ribs.lattice().n_nodes();
  double largest = 0, lowest = 0, squares = 0;
  for (int node = 0; node < n; ++node) {
    const double off = ribs.position(node).z() - ribs.lattice().reference_position(node).z();
    largest = std::max(largest, std::abs(off));
    lowest = std::min(lowest, off);
    squares += off * off;
  }
  results["geogrid_largest_deviation_m"] = largest;
  results["geogrid_rms_deviation_m"] = std::sqrt(squares / n);
  results["geogrid_largest_sag_m"] = -lowest;
}

// Below the mean surface; the apparent density is that of the paper, mass over volume of the box.
void describe_density(const PullOut& experiment, double surface, nlohmann::ordered_json& results)
{
  const dem::Clumps& clumps = experiment.world().engine.clumps();
  const BoxParameters& box = experiment.parameters().box;
  const double volume = box.length * box.width * surface, mass = mass_in_box(clumps, box);
  const SolidVolumes solid = solid_volumes(clumps, box);
  results["bulk_density_kg_per_m3"] = mass / volume;
  results["apparent_density_kg_per_m3"] = mass / (box.length * box.width * box.height);
  results["porosity_of_stones"] = 1 - solid.stones / volume;
  results["porosity_of_clumps"] = 1 - solid.clumps / volume;
}
} // namespace

// The state that the pull starts from.
void describe_packing(const PullOut& experiment, RunRecords& records)
{
  const dem::Clumps& clumps = experiment.world().engine.clumps();
  const PullOutParameters& p = experiment.parameters();
  const double mass = mass_in_box(clumps, p.box), surface = surface_height(clumps, p.box);
  // The surcharge moves, too.
  const double total_mass = std::accumulate(clumps.mass.begin(), clumps.mass.end(), 0.);
  nlohmann::ordered_json& results = records.summary.results;
  results["rigid"] = p.geogrid.rigid;
  results["placement"] = p.geogrid.placement;
  if (p.geogrid.product) results["product"] = p.geogrid.product->name;
  results["stones"] = stones(clumps);
  results["mass_in_box_kg"] = mass;
  const double above = mass_above(clumps, p.box, experiment.geogrid_height());
  results["mass_above_geogrid_kg"] = above; // by the centres of the stones
  results["mass_below_geogrid_kg"] = mass - above;
  results["mass_poured_on_geogrid_kg"] = mass_since(clumps, p.box, experiment.first_above);
  results["mean_surface_height_m"] = surface;
  describe_density(experiment, surface, results);
  describe_flatness(experiment, results);
  results["rms_speed_before_pull_m_per_s"] =
      std::sqrt(2 * experiment.world().kinetic_energy() / total_mass);
  results["surcharge_N"] = p.surcharge.force;
}

void PullOut::finish(std::vector<Stage>& plan, RunRecords& records) const
{
  const PullStage& pull = std::get<PullStage>(plan.back());
  Summary& summary = records.summary;
  summary.seed = parameters_.filling.seed;
  summary.contacts = world_.engine.n_touching_spheres();
  describe_energy(pull, summary);
  describe_pull(pull, *this, summary.results);
  describe_usability(pull, *this, summary);

  if (world_.clock.dt > pull.smallest_stable_step)
    records.warn(
        fmt::format("The time step of {:.3g} s was above the live stable step of {:.3g} s.",
                    world_.clock.dt, pull.smallest_stable_step));
  if (lost > 0)
    records.warn(fmt::format("{} stones fell out of the slot and were taken out.", lost));
  const double pull_error = summary.energy["pull_relative_error"];
  if (pull_error > ledger_bound)
    records.warn(fmt::format("The energy ledger of the pull leaves its bound: error {:.2g} of the "
                             "clamp's work, bound {:.2g}.",
                             pull_error, ledger_bound));
  warn_of_ledger(pull.ledger, records);
  summary.ledger_closes = std::max(pull_error, pull.ledger.relative_error()) <= ledger_failure;
}
} // namespace interlock::coupling
