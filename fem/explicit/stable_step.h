// Largest stable step of the explicit integrator, element by element.
#pragma once

#include "fem/lattice/lattice.h"
#include "fem/lattice/lumped_inertia.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace interlock::fem
{
// Bound on the highest frequency of a lattice without contacts: omega^2 <= unloaded + tension
// per_tension + plastic stretch * per_plastic_stretch.
struct BeamFrequency {
  double unloaded = 0;            // [1/s2]
  double per_tension = 0;         // for the largest tension of any element [1/(s2 N)]
  double per_plastic_stretch = 0; // for the largest plastic stretch of any element [1/s2]
  // Largest step 2/omega at which the leapfrog rule stays bounded [s]. `bent`: what BentBeams says
  // of the elements in their present shape, instead of `unloaded` where it is larger [1/s2].
  double stable_step(double tension = 0, double plastic_stretch = 0, double bent = 0) const
  {
    return 2 / std::sqrt(std::max(unloaded, bent) + tension * per_tension +
                         plastic_stretch * per_plastic_stretch);
  }
};

// Safe side: the highest frequency of the assembled lattice lies below that of its worst
// element with that element's share of the nodal masses. `spherical` says whether `nodes` carry
// spherical inertia, of which every element end takes an equal share; otherwise each end carries
// its own rotary inertia. `rbf`: residual bending flexibility in the shear stiffness. Per element
// of length h, with the end's mass m and inertia J (twice these are a node's within a rib):
//   axial 2 EA/(h m), torsion 2 GJ/(h J), bending 2 EI/(h J), shear S (2/(h m) + h/(2 J))
// are squares of omega, the last two in both planes.
// Derived on the straight element, where these modes are orthogonal; BentBeams has the others.
// Throws std::invalid_argument for an element without mass or rotary inertia. Tension N adds (1 +
// b) N to the shear stiffness against displacement, some (b - 1) N against turning, and N h^2/12 to
// the bending stiffness, with the bowing b of residual_bowing. Good for stretches up to 0.2,
// plastic stretch included. Softening and yield only lower the axial stiffness.
BeamFrequency beam_frequency(const Lattice& lattice, const std::vector<NodeInertia>& nodes,
                             bool spherical, bool rbf);
} // namespace interlock::fem
