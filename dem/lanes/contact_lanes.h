// The contacts about to touch as flat arrays, one lane a contact, padded to whole registers.
#pragma once

#include "dem/bodies/clumps.h"
#include "dem/contacts/contact_memory.h"
#include "dem/lanes/wrench_sums.h"
#include "dem/walls/wall.h"

namespace interlock::dem
{
// Names one contact: member sphere `a` of clump `i` against member `b` of clump `j` > i, or against
// wall `j` (b = 0).
struct ContactKey {
  int i = 0, j = 0, a = 0, b = 0;
};

// Lanes [begin, end) of one wall; begin is a multiple of the lane width.
struct WallSegment {
  int begin = 0, end = 0;
};

// Entries that cannot touch fill up registers. Histories and forces are those of the last
// evaluation.
class ContactLanes
{
public:
  int size() const { return overlap.size(); }
  void resize(int n);

  // See ContactKey. Indices as wide as a double: narrower ones make the compiler work on twice as
  // many lanes at a time, more than there are registers for.
  std::vector<std::int64_t> i, j;
  std::vector<int> a, b;
  VectorField centre1, centre2{Vector3::UnitX()}; // of the member spheres, body frames [m]
  ScalarField radius1{never_touching()}, radius2; // [m]
  ScalarField reduced_mass{one()}, root_mass{one()}, reduced_radius{one()}; // ContactConstants
  ScalarField shared_depth, gradient{one()}; // ContactShare of this step

  // LaneHistory.
  VectorField spring, dashpot;
  ScalarField overlap, tangential_stiffness;

  // On the clump i, world; torques about the centres of mass of i and of j [N], [N m].
  VectorField force, torque1, torque2;
  // LaneEnergy of the last evaluation.
  ScalarField elastic, friction, damping;

  // Sets keys and constants of lane k; the history is left alone.
  void set_pair(int k, const ContactKey& key, const Clumps& clumps);
  void set_wall(int k, const ContactKey& key, const Clumps& clumps);
  void copy_history(int k, const ContactLanes& from, int from_k);
  LaneMemory memory(int k) const;
  void remember(int k, const LaneMemory& memory);
  bool holds_something(int k) const { return overlap[k] > 0; } // an open contact holds nothing

private:
  static Eigen::Matrix<double, 1, 1> one() { return Eigen::Matrix<double, 1, 1>::Ones(); }
  static Eigen::Matrix<double, 1, 1> never_touching() { return -1e3 * one(); }
};

// Forces, torques and new histories of all lanes, from the poses and the step's motion of the
// clumps. `dt`: step over which springs advance [s].
void evaluate_pairs(const Clumps& clumps, const ContactProperties& pair, double dt,
                    ContactLanes& lanes);
// The same for the lanes of one wall.
void evaluate_wall(const Clumps& clumps, const Wall& wall, double dt, WallSegment segment,
                   ContactLanes& lanes);

// Adds forces and torques to the sums of their clumps, in list order, and energies to `energy`;
// returns the number of touching contacts.
int add_pair_forces(const ContactLanes& lanes, WrenchSums& sums, ContactEnergy& energy);
// The same for one wall, whose force is set, too.
int add_wall_forces(const ContactLanes& lanes, WallSegment segment, WrenchSums& sums, Wall& wall,
                    ContactEnergy& energy);

double largest_overlap(const ContactLanes& lanes); // [m]

// Sets the shares of lanes [begin, end) from their present overlaps, which are left in
// lanes.elastic: lanes of the same i and j share one contact (contact_shares.cc).
void share_contacts(int begin, int end, ContactLanes& lanes);
} // namespace interlock::dem
