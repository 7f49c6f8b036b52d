// Everything that a run of a packed state reads from its parameter file. SI units. The comment
// beside each member repeats the unit of the entry in the file.
#pragma once

#include "coupling/parameters/contact_model.h"

#include <cstdint>
#include <string>

namespace interlock::coupling
{
struct PackedStateParameters {
  std::string file;              // format clump-workload-1, .json or .json.gz
  int spheres_per_clump = 0;     // 0: as in the file; more: small spheres inside the same surface
  double squeeze = 0;            // share by which box and positions shrink [-]
  bool hold_still = false;       // compute forces, move nothing
  double throw_speed = 0;        // of every clump at the start, random direction [m/s]
  double throw_spin = 0;         // the same of its spin [rad/s]
  std::uint64_t seed = 1;        // of small spheres and throws
  std::string written;           // file for the state before the first step; empty: none
  int missed_contact_checks = 0; // comparisons with all pairs of member spheres
};

// Of every contact, stone on stone and stone on wall.
struct PackedContactParameters {
  double normal_stiffness = 0;        // of the pair [N/m]
  double tangential_ratio = 0;        // k_t / k_n [-]
  double friction = 0;                // [-]
  double normal_damping_rate = 0;     // dashpot = rate * reduced mass of the clumps [1/s]
  double tangential_damping_rate = 0; // [1/s]
  ContactModelParameters model = {};
};

struct NeighbourListParameters {
  double inner_skin = 0;  // 0: automatic [m]
  double middle_skin = 0; // 0: automatic [m]
};

struct PackingParameters {
  double gravity = 9.81; // along -z [m/s2]
  PackedStateParameters state;
  PackedContactParameters contact;
  TimeParameters time;
  int warm_up_steps = 0; // before the timed ones
  int timed_steps = 0;
  NeighbourListParameters lists;
  int records = 0; // rows of history.csv in the timed steps
};
} // namespace interlock::coupling
