// Natural frequencies and mode shapes of a lattice about a state of equilibrium.
#pragma once

#include "fem/statics/static_state.h"

#include <Eigen/Dense>

#include <mpi.h>

#include <vector>

namespace interlock::fem
{
struct NaturalMode {
  // [Hz]; minus the growth rate over 2 pi where the equilibrium is unstable. Rigid motions of an
  // unsupported lattice have zero: whatever is below a thousandth of the bending frequency of a
  // beam as long as the lattice.
  double frequency = 0;
  // Displacement [m] and rotation vector [rad] of each node, world frame; the modal mass
  // sum of m |u|^2 + rotation . J rotation is 1 kg m2.
  std::vector<Eigen::Matrix<double, 6, 1>> shape;
};

// The `count` lowest modes K u = (2 pi f)^2 M u, in rising order of frequency, of small free
// vibration about `state`: unloaded, or as a StaticSolver has left it. K is the symmetric part of
// the tangent, which in equilibrium under forces is all of it; M holds the lumped masses and rotary
// inertias (not spherical), turned with the nodes. Supports are at rest; moments of the load keep
// their direction. `rbf` as in StaticOptions. Supported and tied freedoms have no modes of their
// own.
//
// Krylov-Schur with shift and invert (SLEPc, MUMPS), every process of `communicator` with its part
// of the lattice and all of the result. How many modes lie below the highest one asked for is
// checked by Sylvester's law of inertia, so that none of a multiple frequency is missed.
//
// Throws std::invalid_argument when `count` is not between 1 and the number of free freedoms with
// inertia (a section without rotary inertia leaves the displacements),
// std::runtime_error when the method does not converge or misses a mode.
std::vector<NaturalMode> natural_modes(const StaticState& state, int count, bool rbf = true,
                                       MPI_Comm communicator = MPI_COMM_WORLD);

// Freedoms that are neither supported nor tied to others: as many modes as a lattice has.
int n_free_freedoms(const StaticState& state, MPI_Comm communicator = MPI_COMM_WORLD);
} // namespace interlock::fem
