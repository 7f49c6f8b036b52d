// Everything that a pull-out run reads from its parameter file. SI units. The comment beside each
// member repeats the unit of the entry in the file.
#pragma once

#include "coupling/parameters/box_parameters.h"
#include "coupling/parameters/filling_parameters.h"
#include "coupling/parameters/geogrid_parameters.h"
#include "coupling/parameters/output_parameters.h"
#include "coupling/parameters/stone_contact.h"
#include "coupling/parameters/stone_parameters.h"
#include "coupling/parameters/time_step.h"

#include <string>
#include <vector>

namespace interlock::coupling
{
// Contacts of ribs; what a stone has of its own is in StoneContactParameters.
struct GeogridContactParameters {
  double stiffness = 0;         // of a rib's surface; 0: that of its material [N/m]
  double friction = 0;          // of the ribs [-]
  double stone_friction = -1;   // of the pair, instead of the smaller one; -1: not given [-]
  double damping_ratio = 0;     // of the dashpots, on the reduced mass [-]
  bool ribs_touch_walls = true; // of the box, and the edges of its slot
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

struct PullOutParameters {
  std::string start_from; // state of another run (start_from.h); empty: an empty box
  double gravity = 9.81;  // along -z [m/s2]
  StoneParameters stones;
  BoxParameters box;
  StoneContactParameters contact;
  GeogridContactParameters geogrid_contact;
  GeogridParameters geogrid;
  FillingParameters filling;
  SurchargeParameters surcharge;
  PullParameters pull;
  TimeParameters time;
  LimitParameters limits;
  OutputParameters output;
  std::vector<double> frames_at; // displacements of the front edge, beside output.field_frames [m]
};
} // namespace interlock::coupling
