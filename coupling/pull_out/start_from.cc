#include "coupling/pull_out/start_from.h"

#include "coupling/pull_out/pull_out.h"
#include "coupling/run/checkpoints.h"
#include "coupling/state/checkpoint_file.h"
#include "coupling/state/state_archive.h"
#include "dem/input_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

namespace interlock::coupling
{
namespace
{
// What made the stones and the lower half.
const std::vector<std::string> fixed_always = {
    "Experiment", "Gravity", "Stones/", "Box/Length", "Box/Width", "Box/Height", "Filling/Seed",
    "Filling/Lower bulk density", "Geogrid/Placement", "Geogrid/Rib thickness",
    // Where the underside of the geogrid is.
    "Geogrid/Product", "Product/Rib thickness along", "Product/Rib thickness across",
    "Product/Junction thickness", "Product/Junction reach"};
// And what the stones lie around.
const std::vector<std::string> fixed_by_geogrid = {
    "Geogrid/Apertures along",  "Geogrid/Apertures across",    "Geogrid/Overhang",
    "Geogrid/Pitch along",      "Geogrid/Pitch across",        "Geogrid/Rib width",
    "Geogrid/Edge rounding",    "Geogrid/Elements per rib",    "Geogrid/Cut width",
    "Geogrid/Lattice file",     "Geogrid/Lattice length unit", "Product/Pattern",
    "Product/Pitch along",      "Product/Pitch across",        "Product/Rib width along",
    "Product/Rib width across", "Product/Elements per rib"};
// What says nothing about the stones before the pull.
const std::vector<std::string> without_effect_before_pull = {
    "Unusual values", "Start from",           "Pull/",       "Output/",
    "Limits/",        "Geogrid/Break strain", "Product/Name"};
// What matters from the placing of the geogrid on only.
const std::vector<std::string> without_effect_before_geogrid = {"Unusual values",
                                                                "Start from",
                                                                "Pull/",
                                                                "Output/",
                                                                "Limits/",
                                                                "Geogrid/",
                                                                "Product/",
                                                                "Contact/Ribs touch walls",
                                                                "Surcharge/",
                                                                "Box/Slot height",
                                                                "Filling/Drop height",
                                                                "Filling/Plate speed",
                                                                "Filling/Plate force limit",
                                                                "Filling/Local damping",
                                                                "Filling/Kinetic energy ratio",
                                                                "Filling/Settling time limit",
                                                                "Filling/Upper bulk density"};

bool any_outside(const std::vector<std::string>& keys, const std::vector<std::string>& list)
{
  return std::any_of(keys.begin(), keys.end(),
                     [&](const std::string& key) { return !is_among(key, list); });
}

// Where in its plan the run was: at the begin of a stage that others may start at.
bool is_before_pull(const std::vector<PullOut::Stage>& plan, std::size_t next, bool in_stage,
                    const std::string& what)
{
  const bool at_begin = next < plan.size() && !in_stage;
  if (at_begin && std::holds_alternative<PullStage>(plan[next])) return true;
  if (at_begin && std::holds_alternative<PlaceStage>(plan[next])) return false;
  throw InputError(what + " is from the middle of a run; start from its state_before_geogrid.h5 or "
                          "state_before_pull.h5, or go on with --resume.");
}

// Ribs that nobody held, or that a lower slot would cut, would be thrown off.
void require_ribs_clear_of_walls(const RibTransfer& geogrid, const std::string& what)
{
  constexpr double bound = 1e-4; // more than walls press into ribs [m]
  if (!geogrid.walls()) return;
  const double overlap = geogrid.walls()->largest_overlap(geogrid.ribs());
  if (overlap > bound)
    throw InputError(fmt::format(
        "{} has ribs that are {:.2g} mm in a wall of the box and would be thrown off: start from a "
        "state that was made with Contact/Ribs touch walls = true and this Box/Slot height, or set "
        "Ribs touch walls = false.",
        what, 1e3 * overlap));
}
} // namespace

bool is_fixed_by_state(const std::string& key, bool geogrid_is_placed)
{
  return is_among(key, fixed_always) || (geogrid_is_placed && is_among(key, fixed_by_geogrid));
}

void PullOut::start_from(const std::filesystem::path& file, const std::vector<CaseEntry>& entries)
{
  const auto begin = std::chrono::steady_clock::now();
  const std::string what = "The state \"" + file.string() + "\"";
  const StateTree state = read_state(file);
  StateReader archive(state);
  std::string experiment, results;
  std::vector<CaseEntry> kept;
  std::vector<Stage> kept_plan;
  std::size_t next = 0;
  bool in_stage = false;
  archive("experiment", experiment);
  if (experiment != name)
    throw InputError(what + " belongs to an experiment \"" + experiment + "\", not to \"" + name +
                     "\".");
  archive("case", kept);
  archive("plan", kept_plan);
  archive("next_stage", next);
  archive("records/in_stage", in_stage);
  archive("records/results", results);

  StartState start;
  start.geogrid_is_placed = is_before_pull(kept_plan, next, in_stage, what);
  require_same_case(what, kept, entries, [&](const std::string& key) {
    return !is_fixed_by_state(key, start.geogrid_is_placed);
  });
  const std::vector<std::string> changed = changed_entries(kept, entries);
  start.adapts = any_outside(changed, start.geogrid_is_placed ? without_effect_before_pull
                                                              : without_effect_before_geogrid);
  start.reloads = std::any_of(changed.begin(), changed.end(),
                              [](const std::string& key) { return is_among(key, {"Surcharge/"}); });
  if (!results.empty()) start.results = nlohmann::ordered_json::parse(results);
  archive("state", *this);
  if (start.geogrid_is_placed) require_ribs_clear_of_walls(*world_.geogrid(), what);
  start_ = std::move(start);
  world_.step_rule = step_rule(parameters_.time, expected_stable_step());
  preparation_ =
      fmt::format("{} stones at t = {:.4g} s from {}{}", world_.engine.clumps().size(),
                  world_.clock.time(), file.string(), start_->adapts ? ", with other entries" : "");
  preparation_time_ =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

std::vector<PullOut::Stage> PullOut::plan_from_state() const
{
  std::vector<Stage> plan;
  if (start_->adapts) plan.emplace_back(AdaptStage());
  if (!start_->geogrid_is_placed) {
    append_upper_half(plan);
    return plan;
  }
  if (start_->reloads && parameters_.surcharge.force > 0) plan.emplace_back(LoadStage());
  if (start_->adapts) plan.emplace_back(SettleStage());
  plan.emplace_back(PullStage());
  return plan;
}

// Contacts and walls of this case; a load that is another one goes, a new one is a stage of its
// own.
void PullOut::adapt()
{
  dem::Engine& engine = world_.engine;
  engine.stone_contact() =
      start_ && !start_->geogrid_is_placed ? filling_contact() : stone_on_stone_;
  world_.ribs.stone_on_rib() = stone_on_rib_;
  for (dem::Wall& wall : engine.walls()) wall.contact = stone_on_box_;
  engine.set_local_damping(parameters_.filling.local_damping);
  choose_step(expected_stable_step());
  if (start_ && start_->reloads) {
    const std::vector<dem::BodyKind>& kind = engine.clumps().kind;
    std::vector<bool> load(kind.size());
    for (std::size_t i = 0; i < kind.size(); ++i) load[i] = kind[i] == dem::BodyKind::surcharge;
    world_.remove(load);
    if (surcharge_plate >= 0) engine.remove_walls({surcharge_plate});
    surcharge_plate = -1;
  }
  if (start_ && start_->geogrid_is_placed)
    open_slot(engine, parameters_.box, stone_on_box_, geogrid_height(), walls);
}

StageStatus before_step(AdaptStage& stage, PullOut& experiment, RunRecords&)
{
  if (stage.looked)
    return finished(fmt::format("time step {:.3g} us", 1e6 * experiment.world().clock.dt));
  experiment.adapt();
  return running(0, Look::at_everything);
}

// The springs hold other energies than before, and nobody's work brought the difference: the ledger
// of this run begins closed.
void look(AdaptStage& stage, PullOut& experiment, RunRecords&)
{
  World& world = experiment.world();
  world.inserted += world.ledger().residual();
  stage.looked = true;
}
} // namespace interlock::coupling
