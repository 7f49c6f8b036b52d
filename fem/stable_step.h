// Largest stable step of the explicit integrator, element by element.
#pragma once

#include "fem/lattice.h"
#include "fem/lumped_inertia.h"

#include <vector>

namespace interlock::fem
{
// Largest step 2/omega [s] at which the leapfrog rule stays bounded on the lattice without
// contacts. Safe side: the highest frequency of the assembled lattice lies below that of its worst
// element with that element's share of the nodal masses. `spherical` says whether `nodes` carry
// spherical inertia, of which every element end takes an equal share; otherwise each end carries
// its own rotary inertia. `rbf`: residual bending flexibility in the shear stiffness. Per element
// of length h, with the end's mass m and inertia J (twice these are a node's within a rib):
//   axial 2 EA/(h m), torsion 2 GJ/(h J), bending 2 EI/(h J), shear S (2/(h m) + h/(2 J))
// are squares of omega, the last two in both planes.
// Derived on the straight unstrained element, where these modes are orthogonal; strains of a few
// per cent change the result by less than their own size.
double stable_beam_step(const Lattice& lattice, const std::vector<NodeInertia>& nodes,
                        bool spherical, bool rbf);
} // namespace interlock::fem
