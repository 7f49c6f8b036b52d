// The parameters of the heap experiment in SI units, grouped as the sections of its parameter file.
#pragma once

#include "coupling/parameters/contact_model.h"
#include "coupling/parameters/stone_parameters.h"

namespace interlock::coupling
{
// A contact has one stiffness, whoever touches: the paper gives that of the contact.
struct HeapContactParameters {
  double normal_stiffness = 0; // of a contact, stone with stone or floor [N/m]
  double tangential_ratio = 0; // k_t / k_n [-]
  double stone_friction = 0;   // stone with stone [-]
  double floor_friction = 0;   // stone with floor [-]
  ContactModelParameters model;
  double local_damping = 0;    // of stones that touch something (Cundall) [-]
  double rolling_friction = 0; // of single spheres, elastic-plastic [-]
};

// A fixed wall of triangles, a hopper or a step; none without a file.
struct MeshWallParameters {
  std::string file;       // STL, PLY or OBJ
  double length_unit = 0; // of the file [m]
  double friction = 0;    // with stones [-]
};

struct DropParameters {
  std::uint64_t seed = 1; // of the places of the shapes and of the attitudes
  int batches = 0;        // each holds every shape once
  double height = 0;      // of the centre of a stone above the floor when it is let go [m]
  double disc_radius = 0; // the places of the shapes lie in this disc [m]
  double floor_side = 0;  // of the square floor around the middle of the disc [m]
  double kinetic_energy_ratio =
      0;                          // at rest when E_kin < ratio * total weight * mean stone size [-]
  double settling_time_limit = 0; // after the last stone has landed, with a warning [s]
};

struct HeapMeasureParameters {
  double radius = 0;           // share of the mass outside this distance is reported [m]
  double elongation_limit = 0; // a stone is elongated when I/L is below [-]
};

struct HeapOutputParameters {
  double record_interval = 0;      // between two rows of history.csv [s]
  double frame_interval = 0;       // between two frames for ParaView; 0: only the last one [s]
  bool report = true;              // draw the figures at the end
  double checkpoint_interval = 60; // of wall-clock time; 0: at the ends of stages only [s]
};

struct HeapParameters {
  double gravity = 9.81; // along -z [m/s2]
  StoneParameters stones;
  HeapContactParameters contact;
  MeshWallParameters mesh_wall;
  DropParameters drop;
  HeapMeasureParameters measures;
  TimeParameters time;
  HeapOutputParameters output;
};
} // namespace interlock::coupling
