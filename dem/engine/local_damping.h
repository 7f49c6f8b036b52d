// Local damping of clumps (Cundall 1987), to settle a packing faster.
#pragma once

#include "dem/bodies/clumps.h"

namespace interlock::dem
{
// Lowers each component of the unbalanced force and torque of the clumps that touch something by a
// share of its size where it speeds the clump up, and raises it where it slows the clump down.
class LocalDamping
{
public:
  double share = 0; // 0: off [-]

  // Takes the damping off clumps.force and clumps.torque, before they are kicked in over dt [s],
  // and books what it will dissipate in clumps.lost. Signs are those of the velocity before the
  // kick. The unbalanced force is that of the clumps, the other one (per clump, world; null: none)
  // and the weight under `gravity` along -z [m/s2].
  void damp(Clumps& clumps, double gravity, double dt, const VectorField* other_force,
            const VectorField* other_torque);

private:
  VectorField nothing_;
};
} // namespace interlock::dem
