// Everything that a pull-out run reads from its parameter file. SI units. The comment beside each
// member repeats the unit of the entry in the file.
#pragma once

#include "coupling/parameters/box_parameters.h"
#include "coupling/parameters/filling_parameters.h"
#include "coupling/parameters/geogrid_parameters.h"
#include "coupling/parameters/stone_parameters.h"
#include "coupling/parameters/time_step.h"

#include <string>

namespace interlock::coupling
{
// Springs in series at a contact, k = k1 k2/(k1 + k2); friction of a pair is the smaller of the
// two.
struct ContactParameters {
  double stone_stiffness = 0;   // [N/m]
  double box_stiffness = 0;     // [N/m]
  double geogrid_stiffness = 0; // [N/m]
  double stone_friction = 0;    // [-]
  double box_friction = 0;      // [-]
  double geogrid_friction = 0;  // [-]
  // Of a pair, instead of the smaller of its two; -1: not given [-].
  double stone_on_box_friction = -1;
  double stone_on_geogrid_friction = -1;
  double tangential_ratio = 0;       // k_t / k_n [-]
  double damping_ratio = 0;          // normal and tangential dashpot, share of critical [-]
  bool share_among_contacts = false; // ContactProperties, between stones and at walls
  double geogrid_damping_ratio = 0;  // the same at stone-rib contacts, on the reduced mass [-]
};

struct SurchargeParameters {
  std::string kind = "spheres"; // spheres | plate
  double force = 0;             // on top; 0: none [N]
  double sphere_radius = 0;     // [m]
};

struct PullParameters {
  double speed = 0;     // of the front edge [m/s]
  double distance = 0;  // [m]
  double ramp_time = 0; // from rest to full speed [s]
};

// Where a run ends because it is no simulation of ballast any more.
struct LimitParameters {
  double overlap = 1; // of any contact over the mean radius of a member sphere [-]
};

struct OutputParameters {
  int records = 0;                 // rows of history.csv during the pull [-]
  int field_frames = 0;            // frames for ParaView during the pull [-]
  bool report = true;              // draw the figures at the end
  double checkpoint_interval = 60; // of wall-clock time; 0: at the ends of stages only [s]
};

struct PullOutParameters {
  std::string start_from; // state of another run (start_from.h); empty: an empty box
  double gravity = 9.81;  // along -z [m/s2]
  StoneParameters stones;
  BoxParameters box;
  ContactParameters contact;
  GeogridParameters geogrid;
  FillingParameters filling;
  SurchargeParameters surcharge;
  PullParameters pull;
  TimeParameters time;
  LimitParameters limits;
  OutputParameters output;
};
} // namespace interlock::coupling
