// Stability of an equilibrium by the signs of the pivots of its tangent.
#pragma once

#include "fem/statics/petsc_objects.h"

namespace interlock::fem
{
class LatticeSystem;
struct StaticState;

// Negative pivots of L D L^T (MUMPS) of a symmetric matrix: by Sylvester's law of inertia the
// number of its negative eigenvalues. Sets the matrix' option `symmetric`. -1 where the matrix is
// singular or the factorisation fails.
int negative_pivots(Mat symmetric);

// Directions in which a lattice at rest runs away from its equilibrium when it is nudged: negative
// eigenvalues of the symmetric part of the tangent, supports at rest. 0: the equilibrium is stable;
// -1: not known, see negative_pivots.
// `system` must be of `state`; its matrix and supports are changed.
int unstable_directions(LatticeSystem& system, const StaticState& state);
} // namespace interlock::fem
