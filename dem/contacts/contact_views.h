// Single contacts as the laws that read them, the output and the tests see them.
#pragma once

#include "dem/contacts/contact_law.h"

namespace interlock::dem
{
// A contact between member `a` of clump i and member `b` of clump j > i, as it was at the last
// compute_forces; world frame.
struct SphereContact {
  int i = 0, j = 0, a = 0, b = 0;
  bool touching = false;
  Vector3 force = Vector3::Zero(); // on clump i, zero when not touching [N]
  Vector3 point = Vector3::Zero(); // mid-overlap, at the present poses [m]
  double overlap = 0;              // zero when not touching [m]
  ContactHistory history;          // of i against j
  ContactShare share;
};

// A contact between member `a` of clump i and a plane wall, as it was at the last compute_forces;
// members as in SphereContact.
struct WallContact {
  int i = 0, wall = 0, a = 0;
  bool touching = false;
  Vector3 force = Vector3::Zero();
  Vector3 point = Vector3::Zero();
  double overlap = 0;
  ContactHistory history; // of the clump against the wall
  ContactShare share;
};
} // namespace interlock::dem
