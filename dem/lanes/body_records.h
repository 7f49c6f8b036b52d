// What contacts read of a clump and what they add to it, as one piece of memory each: a contact
// takes both clumps from any place, and fetches two cache lines of each instead of thirteen.
#pragma once

#include "dem/bodies/clumps.h"
#include "dem/lanes/quads.h"

#include <vector>

namespace interlock::dem
{
// World frame; the fourth number of the vectors is zero.
struct alignas(64) BodyRecord {
  double position[4]; // of the centre of mass [m]
  double attitude[4]; // quaternion x, y, z, w, body to world
  // Of the body's frame at the world's origin, step_velocity - step_spin x position [m/s]: the
  // velocity of the body's material at any point P is this + step_spin x P.
  double velocity[4];
  double spin[4]; // step_spin [rad/s]
};

class BodyRecords
{
public:
  // As the clumps are now.
  void take(const Clumps& clumps);
  const BodyRecord& operator[](int i) const { return records_[i]; }

private:
  std::vector<BodyRecord> records_;
};

// Forces and their moments about the world's origin, clump by clump. Two sums a clump: of the pairs
// in which it is the first body, which lie one behind the other and are added in registers, and of
// all other contacts, those at walls among them, in the order of the calls. Lists therefore change
// no digit: lanes that do not touch add zeros.
class BodySums
{
public:
  struct alignas(64) Sum {
    // The fourth numbers carry energies: see contact_forces.cc.
    Quad first_force{}, first_moment{}, other_force{}, other_moment{};
  };

  // Zero for n clumps. To be called whenever there are new lanes: the sum as first body is
  // overwritten by the clump's lanes and never cleared, so it would outlive them.
  void clear(int n);
  Sum* data() { return sums_.data(); }
  // What contacts crushed in this step, clump by clump [J]; whoever asks adds to it.
  double* crushing()
  {
    crushes_ = true;
    return crushing_.data();
  }

  // Writes force and torque about the centre of mass of every clump, books what its contacts lost,
  // half of it to each of two clumps, and makes the sums ready for the next step.
  void write(Clumps& clumps);

private:
  std::vector<Sum> sums_;
  std::vector<double> crushing_; // [J]
  bool crushes_ = false;
};
} // namespace interlock::dem
