// One filling, many pulls: a run that begins with the state that another one has left.
//
// state_before_geogrid.h5 holds the lower half, state_before_pull.h5 everything at rest. Which
// entries of the case a state has fixed, and which may be other ones: docs/runs.md. Where contacts,
// load, slot or geogrid are new, the stones settle anew before the pull; where only the pull, the
// output and the limits are, the pull begins at once.
#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace interlock::coupling
{
// What a run has to do with the state that it started from.
struct StartState {
  bool geogrid_is_placed = false;
  bool adapts = false;            // takes over other contacts, load, slot, time step
  bool reloads = false;           // the load on top is another one
  nlohmann::ordered_json results; // of the packing, from the run that made it
};

// Whether a state has fixed this entry ("Section/Name"): state_before_pull.h5 where the geogrid is
// placed, else state_before_geogrid.h5.
bool is_fixed_by_state(const std::string& key, bool geogrid_is_placed);
} // namespace interlock::coupling
