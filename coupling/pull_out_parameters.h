// Everything that a pull-out run reads from its parameter file. SI units. The comment beside each
// member repeats the unit of the entry in the file.
#pragma once

#include "coupling/time_step.h"

#include <cstdint>
#include <string>

namespace interlock::coupling
{
struct StoneParameters {
  std::string folder;     // scans (STL, PLY, OBJ); empty: synthetic stones
  double length_unit = 1; // of the scans: length of one file unit [m]
  int count = 41;         // synthetic stones in one batch
  std::uint64_t seed = 1; // of the synthetic stones and of the node order of the clumps
  double density = 0;     // [kg/m3]
  double d_min = 0;       // clump generator [m]
  double r_min = 0;       // clump generator [m]
  double p_max = 0;       // clump generator [%]
  int max_spheres = 0;    // clump generator; 0: no limit
  std::string mass_properties = "mesh"; // uniform | equal-mass | mesh
};

// Box with its floor at z = 0, walls at x = 0 (front, with the slot), x = length, y = 0, y = width.
struct BoxParameters {
  double length = 0;      // along x, the direction of the pull [m]
  double width = 0;       // along y [m]
  double height = 0;      // along z [m]
  double slot_height = 0; // of the gap in the front wall, centred on the geogrid [m]
};

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

struct GeogridParameters {
  bool rigid = false;                  // prescribe every freedom (the paper's geogrid)
  std::string placement = "flattened"; // flattened | not flattened
  int apertures_along = 0;             // in the direction of the pull
  int apertures_across = 0;
  double overhang = 0;       // of the clamped front rib, from the front wall to its near edge [m]
  double pitch_along = 0;    // rib centre line to rib centre line [m]
  double pitch_across = 0;   // [m]
  double rib_width = 0;      // in plane [m]
  double rib_thickness = 0;  // out of plane [m]
  double edge_rounding = 0;  // radius of the rounded edges, at most half the thickness [m]
  double youngs_modulus = 0; // [Pa]
  double poisson_ratio = 0;  // [-]
  double density = 0;        // [kg/m3]
  int elements_per_rib = 8;  // between two junctions
  double mass_damping = 0;   // force = mass_damping * mass * velocity [1/s]
};

struct FillingParameters {
  std::uint64_t seed = 1;       // of the order, places and attitudes of the stones
  double drop_height = 0;       // clear height between the surface and the lowest new stone [m]
  double plate_speed = 0;       // of the flattening plate [m/s]
  double plate_force_limit = 0; // the plate stops pressing there [N]
  double local_damping = 0;     // of stones in contact, until the pull starts [-]
  // Settled before the pull when E_kin < ratio * total weight * mean stone size [-].
  double kinetic_energy_ratio = 0;
  double settling_time_limit = 0; // each settling stage ends there, with a warning [s]
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

struct OutputParameters {
  int records = 0;      // rows of history.csv during the pull [-]
  int field_frames = 0; // frames for ParaView during the pull [-]
  bool report = true;   // draw the figures at the end
};

struct PullOutParameters {
  double gravity = 9.81; // along -z [m/s2]
  StoneParameters stones;
  BoxParameters box;
  ContactParameters contact;
  GeogridParameters geogrid;
  FillingParameters filling;
  SurchargeParameters surcharge;
  PullParameters pull;
  TimeParameters time;
  OutputParameters output;
};
} // namespace interlock::coupling
