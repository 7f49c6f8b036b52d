// Rolling resistance: the elastic-plastic spring-dashpot model, type C of Ai, Chen, Rotter and Ooi,
// Powder Technology 206 (2011) 269-282. Equations: docs/theory/walls.md.
//
// Meant for single spheres, which lack the shape that keeps real grains from rolling. It takes any
// contact, those of clumps too, but a clump already resists by its shape: leave it out there unless
// the roughness below the size of its spheres is what you want to add.
#pragma once

#include "dem/contacts/contact_views.h"
#include "dem/walls/mesh_contacts.h"
#include "dem/walls/wall.h"

#include <array>
#include <limits>
#include <vector>

namespace interlock::dem
{
// Of one pair of materials.
struct RollingProperties {
  // Coefficient mu_r: the moment is at most mu_r R_r F_n, R_r = r_i r_j/(r_i + r_j), and r_i
  // against a wall. A sphere stays on a slope up to tan = mu_r [-].
  double friction = 0;
  double damping_ratio = 0; // of the dashpot, share of critical, while the spring holds [-]
};

// One contact that touches, after the forces of the step were computed.
struct RollingContact {
  // Tells the contact from all others, for as long as it lives: kind (0 spheres, 1 wall, 2 wall of
  // triangles), clump i, clump j or wall, and two more numbers.
  std::array<int, 5> key;
  int i = 0, j = -1;       // clumps; j = -1: a wall
  int mesh = -1;           // number of the wall of triangles, -1: none
  Vector3 normal;          // from j (the wall) to i, unit, world
  double normal_force = 0; // [N]
  double radius_i = 0, radius_j = std::numeric_limits<double>::infinity(); // [m]
  double normal_stiffness = 0;                                             // k_n [N/m]
  RollingProperties rolling;
};

// What a contact remembers.
struct RollingSpring {
  std::array<int, 5> key;
  Vector3 angle = Vector3::Zero();   // rolling of i against j, less what slipped [rad]
  Vector3 dashpot = Vector3::Zero(); // last dissipative moment [N m]
  double stiffness = 0;              // k_r [N m/rad]
};

class RollingResistance
{
public:
  // Adds the moments of all contacts to clumps.torque and, with the opposite sign, to the torque of
  // walls of triangles, and advances the springs by `time_step` [s]. Springs of contacts that are
  // not in the list any more are lost to friction. Spins are clumps.step_spin and those of the
  // walls' last move. Books what slip and dashpots dissipate in clumps.lost and returns the energy
  // in the springs [J]. A contact with friction 0 does nothing.
  // Keys must be unique; the list may have any order.
  double evaluate(std::vector<RollingContact> contacts, Clumps& clumps,
                  std::vector<MeshWall>& meshes, double time_step);

  // After clumps or walls were removed: for every old one the new index, ascending, or -1 (`kind`:
  // 1 walls, 2 walls of triangles, as in the key).
  void renumber_clumps(const std::vector<int>& new_index);
  void renumber_walls(int kind, const std::vector<int>& new_index);

  // Sorted by key; restore() goes on from those of an earlier run, with the same digits.
  const std::vector<RollingSpring>& springs() const { return springs_; }
  void restore(std::vector<RollingSpring> springs) { springs_ = std::move(springs); }

private:
  static Vector3 moment(const RollingContact& contact, const Clumps& clumps,
                        const std::vector<MeshWall>& meshes, double time_step,
                        RollingSpring& spring, ContactEnergy& energy);

  std::vector<RollingSpring> springs_, old_; // sorted by key
};

// Appends the contacts that touch. `normal_stiffness`: of the pair [N/m].
void append_rolling(const std::vector<SphereContact>& contacts, const Clumps& clumps,
                    double normal_stiffness, const RollingProperties& rolling,
                    std::vector<RollingContact>& list);
void append_rolling(const std::vector<WallContact>& contacts, const Clumps& clumps,
                    const std::vector<Wall>& walls, const RollingProperties& rolling,
                    std::vector<RollingContact>& list);
void append_rolling(const std::vector<MeshContact>& contacts, const Clumps& clumps,
                    const std::vector<MeshWall>& meshes, const RollingProperties& rolling,
                    std::vector<RollingContact>& list);

template <class Archive> void exchange(Archive& archive, RollingProperties& rolling)
{
  archive("friction", rolling.friction);
  archive("damping_ratio", rolling.damping_ratio);
}
} // namespace interlock::dem
