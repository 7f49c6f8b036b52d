// The last Newton step, which is too short for the digits of the positions.
#pragma once

#include "fem/statics/static_state.h"

#include <vector>

namespace interlock::fem
{
class LatticeSystem;

// A stretch is known to the last digit of the positions, 1e-16 of the coordinates over an element's
// length, and ribs are stiff in stretch: under loads that only bend them the axial forces are
// rounding. One Newton step more from a state at rest leads to where they are not. It cannot be
// added to the positions, but what it changes in the forces can be added to them, to first order.
struct LastCorrection {
  std::vector<NodeLoad> forces; // stiffness times the step, on every node [N, N m]; empty: the
                                // tangent is singular
  double displacement = 0;      // the longest of any node [m]: an estimate of the error
};

// `system` must be that of the state, whose supports and loads are those that it is at rest under;
// its supports are those of the state afterwards. `rbf`: see StaticOptions.
LastCorrection last_correction(LatticeSystem& system, const StaticState& state, bool rbf);
} // namespace interlock::fem
