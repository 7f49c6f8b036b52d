// The timed stage of the packing experiment and its results.
#include "coupling/loop/state_hash.h"
#include "coupling/packing/packing.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace interlock::coupling
{
namespace
{
// Whether one of `n` events, spread evenly over `total` steps, falls on this step; the last one
// falls on the last step.
bool is_due(std::int64_t step, std::int64_t n, std::int64_t total)
{
  return (step + 1) * n / total > step * n / total;
}

int touching_clump_pairs(const dem::Engine& engine)
{
  int pairs = 0, i = -1, j = -1;
  for (const dem::SphereContact& c : engine.sphere_contacts()) { // sorted by clumps
    if (!c.touching || (c.i == i && c.j == j)) continue;
    i = c.i, j = c.j;
    ++pairs;
  }
  return pairs;
}

int touching_walls(const dem::Engine& engine)
{
  int contacts = 0;
  for (const dem::WallContact& c : engine.wall_contacts()) contacts += c.touching;
  return contacts;
}

std::string table_row(const char* part, double seconds)
{
  char row[128];
  std::snprintf(row, sizeof row, "\n  %-12s %10.3f us", part, 1e6 * seconds);
  return row;
}

std::string share(double part, double whole)
{
  char text[32];
  std::snprintf(text, sizeof text, " %6.1f %%", 100 * part / whole);
  return text;
}
} // namespace

Summary Packing::run(const std::filesystem::path& output)
{
  if (!parameters_.state.written.empty()) write_packed_state(parameters_.state.written, state_);
  warm_up();
  run_timed(output);
  collect_results();
  write_summary(output / "summary.json", summary_);
  return summary_;
}

void Packing::run_timed(const std::filesystem::path& output)
{
  begin_stage("timed");
  History history(output / "history.csv",
                  {"time [s]", "kinetic_energy [J]", "touching_sphere_pairs [-]",
                   "wall_contacts [-]", "largest_overlap [m]", "floor_force [N]",
                   "side_wall_friction [N]", "energy_relative_error [-]"});
  loads_ = Loads();
  const int total = parameters_.timed_steps;
  const auto record_due = [&](int k) { return is_due(k, parameters_.records, total); };
  const auto check_due = [&](int k) {
    return is_due(k, parameters_.state.missed_contact_checks, total);
  };
  for (int k = 0; k < total; ++k) {
    int plain = 0;
    while (!record_due(k + plain) && !check_due(k + plain)) ++plain;
    fraction_ = double(k) / total;
    engine_->reset_profile();
    run_steps(plain, timed_);
    add_profile();
    k += plain;
    step_with([&] {
      book();
      if (record_due(k)) record(history);
      if (check_due(k)) check_for_missed_contacts();
    });
  }
  end_stage(std::to_string(loads_.steps) + " of " + std::to_string(total) +
            " steps timed, between records and checks");
}

void Packing::add_profile()
{
  const dem::StepProfile p = engine_->profile();
  profile_.broad_phase += p.broad_phase;
  profile_.lists += p.lists;
  profile_.contacts += p.contacts;
  profile_.integration += p.integration;
}

void Packing::book()
{
  if (parameters_.state.hold_still) return; // stones that forces do not move have no ledger
  ledger_ = ledger_of(engine_->energy(dt_));
  ledger_.inserted += inserted_;
  if (!std::isfinite(ledger_.kinetic_stones))
    throw std::runtime_error("The simulation became unstable at t = " + std::to_string(time_) +
                             " s; lower Time/Step.");
}

void Packing::record(History& history)
{
  double side_walls = 0;
  const std::vector<dem::Wall>& walls = engine_->walls();
  for (std::size_t w = 1; w < walls.size(); ++w) side_walls -= walls[w].force.z();
  history.add({time_, ledger_.kinetic_stones, double(engine_->n_touching_spheres()),
               double(touching_walls(*engine_)), engine_->largest_overlap(), -walls[0].force.z(),
               side_walls, ledger_.relative_error()});
  summary_.contacts = engine_->n_touching_spheres();
  summary_.results["touching_sphere_pairs"] = summary_.contacts;
  summary_.results["touching_clump_pairs"] = touching_clump_pairs(*engine_);
  summary_.results["wall_contacts"] = touching_walls(*engine_);
  summary_.results["largest_overlap_m"] = engine_->largest_overlap();
}

void Packing::check_for_missed_contacts()
{
  const int listed = engine_->n_touching_spheres(), there = engine_->count_overlaps_brute_force();
  if (listed != there)
    throw std::runtime_error("at step " + std::to_string(steps_) + " the neighbour lists hold " +
                             std::to_string(listed) +
                             " touching sphere pairs, but a search of all pairs finds " +
                             std::to_string(there) + ".");
}

void Packing::collect_results()
{
  const dem::Clumps& clumps = engine_->clumps();
  Summary& s = summary_;
  s.experiment = "packing";
  s.seed = parameters_.state.seed;
  s.clumps = clumps.size();
  s.spheres = clumps.n_spheres();
  s.time_step = dt_;
  s.steps = steps_;
  s.simulated_time = time_;
  s.wall_time = std::chrono::duration<double>(Clock::now() - run_start_).count();
  s.wall_time_per_step = timed_ / loads_.steps;
  s.state_hash = state_hash(clumps, nullptr);

  const double floor = loads_.floor / loads_.steps, sides = loads_.side_walls / loads_.steps;
  s.results["kinetic_energy_J"] = ledger_.kinetic_stones;
  // Means over the timed steps; downwards.
  s.results["floor_force_N"] = floor;
  s.results["side_wall_friction_N"] = sides;
  s.results["weight_N"] = weight_;
  if (weight_ > 0 && !parameters_.state.hold_still)
    s.results["carried_weight_over_weight"] = (floor + sides) / weight_;
  s.results["missed_contact_checks"] = parameters_.state.missed_contact_checks;
  s.results["timed_steps"] = loads_.steps;
  collect_speed();
  if (!parameters_.state.hold_still) collect_energies();
}

void Packing::collect_speed()
{
  const double steps = static_cast<double>(loads_.steps), whole = summary_.wall_time_per_step;
  // Records, checks and the screen are outside of the time of a step; they are given beside it.
  const double outside = summary_.stages.back().wall_time - timed_;
  const std::pair<const char*, double> parts[] = {{"broad_phase", profile_.broad_phase / steps},
                                                  {"lists", profile_.lists / steps},
                                                  {"contacts", profile_.contacts / steps},
                                                  {"integration", profile_.integration / steps}};
  std::string table = "a step takes " + std::to_string(1e3 * whole) + " ms (" +
                      std::to_string(std::lround(1 / whole)) + " steps/s), of which";
  for (const auto& [name, seconds] : parts) {
    summary_.results[std::string(name) + "_s_per_step"] = seconds;
    table += table_row(name, seconds) + share(seconds, whole);
  }
  summary_.results["output_s_per_step"] = outside / steps;
  const dem::ListCounts lists = engine_->profile().counts;
  summary_.results["list_builds"] = {{"clump_pairs", lists.outer_builds},
                                     {"sphere_pairs", lists.middle_builds},
                                     {"about_to_touch", lists.inner_builds}};
  summary_.results["list_sizes"] = {{"clump_pairs", lists.clump_pairs},
                                    {"sphere_pairs", lists.candidates},
                                    {"about_to_touch", lists.lanes}};
  table += table_row("output", outside / steps) + " besides, with checks";
  if (monitor_.message)
    monitor_.message(table + "\n  state hash " + hexadecimal(summary_.state_hash));
}

void Packing::collect_energies()
{
  Summary& s = summary_;
  add_ledger(s, ledger_);
  char sentence[160];
  std::snprintf(sentence, sizeof sentence,
                "The energy ledger leaves its bound: error %.2g of the work put in, bound %.2g.",
                ledger_.relative_error(), ledger_bound);
  if (ledger_.relative_error() > ledger_bound) warn(sentence);
  s.ledger_closes = ledger_.relative_error() <= ledger_failure;

  const dem::StableStep live = engine_->stable_step();
  std::snprintf(sentence, sizeof sentence,
                "The time step of %.3g s is above the live stable step of %.3g s.", dt_, live.step);
  if (live.step > 0 && dt_ > live.step) warn(sentence);
}
} // namespace interlock::coupling
