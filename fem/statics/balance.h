// What supports exert, and whether it holds the loads.
#pragma once

#include "fem/statics/static_state.h"

#include <vector>

namespace interlock::fem
{
// Internal forces less loads of every node [N, N m], moments about the node: what a support there
// exerts, zero at free nodes to the tolerance of the solution. Nodes that a junction with
// rotational stiffness joins have a share each. `rbf`: see StaticOptions; `correction`: added, if
// it is not empty, see LastCorrection.
std::vector<NodeLoad> unbalanced_forces(const StaticState& state, bool rbf,
                                        const std::vector<NodeLoad>& correction);

// Loads and reactions of the supported freedoms together. A lattice at rest has the sum zero.
struct Balance {
  double error = 0; // of forces, and of moments about the middle over the lattice's size [N]
  double scale = 0; // sum of the amounts of all loads and reactions, moments over the size [N]
};
Balance balance(const StaticState& state, bool rbf, const std::vector<NodeLoad>& correction);
} // namespace interlock::fem
