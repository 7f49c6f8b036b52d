#include "coupling/packing/packing_declarations.h"

#include "coupling/packing/packed_state.h"

#include <filesystem>

namespace interlock::coupling
{
namespace
{
namespace fs = std::filesystem;

void declare_state(ParameterTable& table, PackedStateParameters& state)
{
  table.open_section("Packing");
  table.require_file("State file", state.file,
                     "Packed state to start from (format clump-workload-1, .json or .json.gz), "
                     "relative to this file.");
  table.offer("Spheres per clump", state.spheres_per_clump, 0, {0, 100000, true},
              "Fill every shape up to this number of spheres with small ones inside its surface, "
              "which stays the same; 0: as in the file. [-]");
  table.offer(
      "Squeeze", state.squeeze, 0, {0, 0.1, true},
      "Share by which the box and all positions shrink at the start; the spheres keep their "
      "size. [-]");
  table.offer("Hold still", state.hold_still, false,
              "Compute the forces of every step, but move nothing.");
  table.offer("Throw speed", state.throw_speed, 0, not_negative,
              "Speed that every clump gets at the start, in a random direction. [m/s]");
  table.offer("Throw spin", state.throw_spin, 0, not_negative,
              "Spin that every clump gets at the start, about a random axis. [rad/s]");
  table.offer_seed("Seed", state.seed, "Seed of the small spheres and of the throws. [-]");
  table.offer_file("Write state", state.written,
                   "File for the state before the first step, in the same format (.json or "
                   ".json.gz), relative to this file; empty: none.");
  table.offer(
      "Missed contact checks", state.missed_contact_checks, 0, not_negative,
      "How often in the timed steps, but outside of their time, all pairs of member spheres "
      "are searched for a contact that the neighbour lists lack. [-]");
}

void declare_contact(ParameterTable& table, PackedContactParameters& contact)
{
  table.open_section("Contact");
  declare_contact_model(table, contact.model);
  table.require(
      "Normal stiffness", contact.normal_stiffness, positive,
      "Normal stiffness of a contact of two spheres, or of a sphere and a wall; of the linear "
      "model. [N/m]");
  table.require("Tangential ratio", contact.tangential_ratio, {0, 2, false},
                "Tangential over normal contact stiffness, of the linear model. [-]");
  table.require("Friction", contact.friction, {0, 5, true}, "Friction coefficient. [-]");
  table.require("Normal damping rate", contact.normal_damping_rate, not_negative,
                "Normal dashpot over the reduced mass of the two clumps. [1/s]");
  table.require("Tangential damping rate", contact.tangential_damping_rate, not_negative,
                "Tangential dashpot over the reduced mass of the two clumps. [1/s]");
}

void check_written_file(const PackedStateParameters& state, ParameterProblems& problems)
{
  if (state.written.empty()) return;
  const fs::path file = state.written;
  const char* entry = "Packing/Write state";
  std::error_code error;
  if (!is_packed_state_name(file))
    problems.add(entry, "The file is \"", state.written,
                 "\", but its name must end with .json or .json.gz.");
  else if (fs::equivalent(file, state.file, error))
    problems.add(entry, "The file \"", state.written,
                 "\" is the state file itself; it must be another one.");
  else if (!fs::is_directory(file.parent_path(), error))
    problems.add(entry, "The folder of \"", state.written, "\" does not exist.");
}
} // namespace

void declare_packing(ParameterTable& table, PackingParameters& parameters)
{
  table.open_section("");
  table.require("Gravity", parameters.gravity, not_negative,
                "Acceleration of gravity, downwards along z. [m/s2]");
  declare_state(table, parameters.state);
  declare_contact(table, parameters.contact);

  declare_time(table, parameters.time);
  table.require("Warm-up steps", parameters.warm_up_steps, not_negative,
                "Steps before the timed ones: a state file has no springs of friction, they must "
                "form first. [-]");
  table.require("Timed steps", parameters.timed_steps, {1, 2e9, true},
                "Steps whose time and mean forces are the results. [-]");

  table.open_section("Neighbour lists");
  table.offer("Inner skin", parameters.lists.inner_skin, 0, not_negative,
              "Skin of the list of sphere pairs about to touch; 0: automatic. [m]");
  table.offer("Middle skin", parameters.lists.middle_skin, 0, not_negative,
              "Skin of the list of sphere pairs that the inner list is made of; 0: automatic. [m]");

  table.open_section("Output");
  table.offer("Records", parameters.records, 50, {1, 1e6, true},
              "Rows of history.csv in the timed steps. [-]");
}

std::vector<ParameterProblem> check_packing(const PackingParameters& parameters)
{
  const PackedStateParameters& state = parameters.state;
  ParameterProblems problems;
  std::error_code error;
  if (!fs::is_regular_file(state.file, error))
    problems.add("Packing/State file", "The file \"", state.file, "\" does not exist.");
  if (state.hold_still && (state.throw_speed > 0 || state.throw_spin > 0))
    problems.add("Packing/Hold still",
                 "Stones that are held still cannot be thrown; set Throw speed and Throw spin to 0 "
                 "or Hold still to false.");
  check_contact_model(parameters.contact.model, parameters.time, problems);
  check_written_file(state, problems);
  // Steps with a record or a check are not timed.
  const double looks = double(parameters.records) + state.missed_contact_checks;
  if (2 * looks > parameters.timed_steps)
    problems.add("Output/Records", "There are ", parameters.records, " records and ",
                 state.missed_contact_checks,
                 " missed contact checks, but together they may be at "
                 "most half of the ",
                 parameters.timed_steps, " timed steps.");
  const double inner = parameters.lists.inner_skin, middle = parameters.lists.middle_skin;
  if (inner > 0 && middle > 0 && inner >= middle)
    problems.add("Neighbour lists/Inner skin", "The inner skin is ", inner,
                 " m, but must be smaller than the middle one, ", middle, " m.");
  return problems.take();
}
} // namespace interlock::coupling
