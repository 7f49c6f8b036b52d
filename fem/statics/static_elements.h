// The elements of a lattice at rest, whichever order they have.
#pragma once

#include "fem/lattice/beam_constants.h"
#include "fem/lattice/quadratic_lattice.h"
#include "fem/statics/static_state.h"

#include <array>

namespace interlock::fem
{
inline int n_elements(const StaticState& state)
{
  return static_cast<int>(state.pairs.empty() ? state.lattice.n_elements() : state.pairs.size());
}

// Calls use(beam, nodes) for an element, 0 ... n_elements - 1: with BeamConstants and two nodes, or
// with QuadraticBeam and three. beam_force, beam_tangent, section_forces and strain_energy exist
// for both. `rbf`: see StaticOptions.
template <class Use> void with_element(const StaticState& state, bool rbf, int e, const Use& use)
{
  if (state.pairs.empty())
    use(beam_constants(state.lattice, e, rbf, state.plastic_stretch[e]),
        state.lattice.element(e).node);
  else
    use(state.pairs[e].beam, state.pairs[e].node);
}

// Entries of one array for each of these nodes.
template <class Entry, std::size_t n>
std::array<Entry, n> at_nodes(const std::vector<Entry>& entries, const std::array<int, n>& nodes)
{
  std::array<Entry, n> chosen;
  for (std::size_t v = 0; v < n; ++v) chosen[v] = entries[nodes[v]];
  return chosen;
}
} // namespace interlock::fem
