// The last stage of the pull-out experiment and its results.
#include "coupling/loop/state_hash.h"
#include "coupling/pull_out/pull_out.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace interlock::coupling
{
namespace
{
std::string sentence(const char* format, double a, double b)
{
  char buffer[256];
  std::snprintf(buffer, sizeof buffer, format, a, b);
  return buffer;
}

std::vector<std::string> history_columns()
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
  for (const auto& entry : EnergyLedger().entries())
    columns.push_back("energy_" + entry.first + " [J]");
  columns.push_back("energy_relative_error [-]");
  return columns;
}

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
} // namespace

// Speed of the clamp: half a cosine from rest to full speed, then constant. A start with a jump
// would send a wave through the ribs.
void PullOut::pull(const std::filesystem::path& output)
{
  begin_stage("pull");
  const PullParameters& p = parameters_.pull;
  warn_of_rib_at_wall();
  const double duration = p.distance / p.speed + 0.5 * p.ramp_time;
  History history(output / "history.csv", history_columns());
  const int n_records = parameters_.output.records, n_frames = parameters_.output.field_frames;
  int next_record = 0, next_frame = 0;
  double displacement = 0;
  pull_start_ = time_;
  while (true) {
    const double elapsed = time_ - pull_start_;
    const double progress = displacement / p.distance;
    const bool over = displacement >= p.distance;
    const bool record_now = over || progress * n_records >= next_record;
    step(progress, record_now ? &ledger_ : nullptr);
    watch_pull();
    impulse_ -= loop_->clamp_force().x() * dt_;
    impulse_time_ += dt_;
    if (surcharge_plate_ >= 0) plate_impulse_ += dt_ * engine_->walls()[surcharge_plate_].force.z();
    if (record_now) {
      if (next_record == 0) ledger_at_pull_ = ledger_;
      record(history, displacement);
      ++next_record;
    }
    if (n_frames > 0 && (over || progress * n_frames >= next_frame)) {
      frames_->write(time_, *engine_, *loop_);
      ++next_frame;
    }
    if (over) break;
    const double ramp =
        elapsed < p.ramp_time ? 0.5 * (1 - std::cos(M_PI * elapsed / p.ramp_time)) : 1;
    clamp_velocity_ = {-p.speed * ramp, 0, 0};
    displacement += p.speed * ramp * dt_;
    if (elapsed > 2 * duration) throw std::runtime_error("The pull did not come to its end.");
  }
  end_stage(sentence("%.1f mm, pull force at the end %.0f N", 1e3 * displacement,
                     mean_over_window(record_displacements_, record_forces_, 1e-3)));
}

// Stones caught between the second transverse rib and the front wall carry the pull on their own.
void PullOut::warn_of_rib_at_wall()
{
  const GeogridParameters& g = parameters_.geogrid;
  const double left = g.pitch_along - g.overhang - g.rib_width - parameters_.pull.distance;
  if (g.apertures_along > 1 && left < 0.5 * mean_size_)
    warn(sentence("The pull brings the second transverse rib to %.1f mm from the front wall, less "
                  "than half a stone of %.1f mm: stones caught there raise the force.",
                  1e3 * left, 1e3 * mean_size_));
}

void PullOut::watch_pull()
{
  largest_overlap_ = std::max(largest_overlap_, engine_->largest_overlap());
  for (const dem::RibContact& c : loop_->rib_contacts().contacts())
    largest_overlap_ = std::max(largest_overlap_, c.overlap);
}

// The state that the pull starts from.
void PullOut::describe_packing()
{
  const BoxParameters& box = parameters_.box;
  const double mass = filling_->mass_in_box(), surface = filling_->surface_height();
  int stones = 0;
  for (int i = 0; i < engine_->clumps().size(); ++i) stones += filling_->is_stone(i);
  const dem::ScalarField& masses = engine_->clumps().mass; // the surcharge's, too
  const double total_mass = std::accumulate(masses.begin(), masses.end(), 0.);
  nlohmann::ordered_json& results = summary_.results;
  results["rigid"] = parameters_.geogrid.rigid;
  results["placement"] = parameters_.geogrid.placement;
  results["stones"] = stones;
  results["mass_in_box_kg"] = mass;
  results["mass_above_geogrid_kg"] = filling_->mass_above(geogrid_height_);
  results["mean_surface_height_m"] = surface;
  results["bulk_density_kg_per_m3"] = mass / (box.length * box.width * surface);
  results["rms_speed_before_pull_m_per_s"] = std::sqrt(2 * engine_->kinetic_energy() / total_mass);
  results["surcharge_N"] = parameters_.surcharge.force;
}

void PullOut::record(History& history, double displacement)
{
  const fem::ExplicitDynamics& dynamics = geogrid_->dynamics();
  const fem::Lattice& lattice = dynamics.lattice();
  record_displacements_.push_back(displacement);
  record_forces_.push_back(impulse_ / impulse_time_);
  impulse_ = impulse_time_ = 0;
  filtered_forces_.push_back(mean_over_window(record_displacements_, record_forces_, 1e-3));
  const dem::StableStep live = engine_->stable_step(&loop_->rib_contacts());
  if (live.step > 0) smallest_stable_step_ = std::min(smallest_stable_step_, live.step);
  if (!std::isfinite(record_forces_.back()))
    throw std::runtime_error(sentence("The simulation became unstable at t = %.6f s (step %.3g s); "
                                      "lower Time/Safety factor.",
                                      time_, dt_));

  double rear = 0, rear_x = -1e300, axial = 0;
  for (int node = 0; node < lattice.n_nodes(); ++node)
    rear_x = std::max(rear_x, lattice.reference_position(node).x());
  int n_rear = 0;
  for (int node = 0; node < lattice.n_nodes(); ++node)
    if (lattice.reference_position(node).x() > rear_x - 1e-6) {
      rear += lattice.reference_position(node).x() - dynamics.position(node).x();
      ++n_rear;
    }
  for (int e = 0; e < lattice.n_elements(); ++e) {
    const double force = dynamics.section_forces(e).axial;
    axial = std::max(axial, std::abs(force));
    largest_stretch_ = std::max(largest_stretch_, force / lattice.section(e).axial);
  }
  largest_axial_force_ = std::max(largest_axial_force_, axial);
  const auto& rib_contacts = loop_->rib_contacts().contacts();
  const auto touching = std::count_if(rib_contacts.begin(), rib_contacts.end(),
                                      [](const dem::RibContact& c) { return c.overlap > 0; });

  std::vector<double> row = {time_,
                             displacement,
                             record_forces_.back(),
                             filtered_forces_.back(),
                             rear / n_rear,
                             axial,
                             static_cast<double>(engine_->n_touching_spheres()),
                             static_cast<double>(touching),
                             engine_->largest_overlap(),
                             static_cast<double>(loop_->substeps())};
  for (const auto& entry : ledger_.entries()) row.push_back(entry.second);
  row.push_back(ledger_.relative_error());
  history.add({row.begin(), row.end()});
}

void PullOut::collect_results()
{
  const dem::Clumps& clumps = engine_->clumps();
  Summary& s = summary_;
  s.experiment = "pull-out";
  s.seed = parameters_.filling.seed;
  s.clumps = clumps.size();
  s.spheres = clumps.n_spheres();
  s.time_step = dt_;
  s.steps = steps_;
  s.simulated_time = time_;
  s.wall_time = std::chrono::duration<double>(Clock::now() - run_start_).count();
  s.contacts = engine_->n_touching_spheres();
  s.state_hash = state_hash(clumps, &geogrid_->dynamics());

  add_ledger(s, ledger_);
  const EnergyLedger pull = difference(ledger_, ledger_at_pull_);
  s.energy["interface_residual_J"] = ledger_.interface_residual();
  s.energy["pull_interface_residual_J"] = pull.interface_residual();
  s.energy["pull_clamp_work_J"] = pull.clamp_work;
  s.energy["pull_residual_J"] = pull.residual();
  s.energy["pull_relative_error"] =
      pull.clamp_work != 0 ? std::abs(pull.residual() / pull.clamp_work) : 0;

  // The very first record holds one step only.
  const auto peak = std::max_element(filtered_forces_.begin() + 1, filtered_forces_.end());
  const auto raw_peak = std::max_element(record_forces_.begin() + 1, record_forces_.end());
  s.results["mean_sphere_radius_m"] = mean_sphere_radius_;
  s.results["largest_overlap_m"] = largest_overlap_;
  s.results["largest_overlap_over_mean_sphere_radius"] = largest_overlap_ / mean_sphere_radius_;
  s.results["pull_speed_m_per_s"] = parameters_.pull.speed;
  s.results["pull_distance_m"] = record_displacements_.back();
  if (surcharge_plate_ >= 0) {
    const dem::Wall& plate = engine_->walls()[surcharge_plate_];
    s.results["surcharge_plate_mean_force_N"] = plate_impulse_ / (time_ - pull_start_);
    s.results["surcharge_plate_height_at_end_m"] = plate.corner.z();
  }
  // Filtered: mean over the last millimetre. Raw: mean between two records.
  s.results["pull_force_at_end_N"] = filtered_forces_.back();
  s.results["peak_pull_force_N"] = *peak;
  s.results["displacement_at_peak_m"] = record_displacements_[peak - filtered_forces_.begin()];
  s.results["peak_pull_force_between_records_N"] = *raw_peak;
  s.results["largest_axial_force_in_a_rib_N"] = largest_axial_force_;
  s.results["largest_stretch_of_a_rib"] = largest_stretch_;
  s.results["mean_surface_height_after_pull_m"] = filling_->surface_height();
  s.results["smallest_stable_step_s"] = smallest_stable_step_;
  s.results["stones_lost_through_slot"] = n_lost_;
  s.results["substeps"] = loop_->substeps();

  if (dt_ > smallest_stable_step_)
    warn(sentence("The time step of %.3g s was above the live stable step of %.3g s.", dt_,
                  smallest_stable_step_));
  if (n_lost_ > 0)
    warn(std::to_string(n_lost_) + " stones fell out of the slot and were taken out.");
  const double pull_error = s.energy["pull_relative_error"];
  if (pull_error > ledger_bound)
    warn(sentence("The energy ledger of the pull leaves its bound: error %.2g of the clamp's work, "
                  "bound %.2g.",
                  pull_error, ledger_bound));
  if (ledger_.relative_error() > ledger_bound)
    warn(sentence("The energy ledger leaves its bound: error %.2g of the work put in, bound %.2g.",
                  ledger_.relative_error(), ledger_bound));
  s.ledger_closes = std::max(pull_error, ledger_.relative_error()) <= ledger_failure;
}
} // namespace interlock::coupling
