// The supports of a lattice state, held where they are.
#pragma once

#include "fem/statics/static_state.h"

#include <vector>

namespace interlock::fem
{
// For LatticeSystem::set_supports: present displacements, no further turn.
inline std::vector<StaticState::Support> resting_supports(const StaticState& state)
{
  std::vector<StaticState::Support> resting = state.supports;
  for (StaticState::Support& support : resting) {
    const int node = support.node, c = support.component;
    const Eigen::Vector3d displacement =
        state.position[node] - state.lattice.reference_position(node);
    support.value = c < 3 ? displacement[c] : 0;
  }
  return resting;
}
} // namespace interlock::fem
