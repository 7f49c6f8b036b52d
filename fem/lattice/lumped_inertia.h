// Mass and rotary inertia of a lattice, gathered at its nodes.
#pragma once

#include "fem/lattice/lattice.h"

#include <Eigen/Dense>

#include <vector>

namespace interlock::fem
{
struct NodeInertia {
  double mass = 0;                                  // [kg]
  Eigen::Matrix3d tensor = Eigen::Matrix3d::Zero(); // unloaded state, world axes [kg m2]
  int valence = 0;                                  // element ends that meet here
};

// Half of every element's mass and rotary inertia at each of its ends. With `spherical`, each
// tensor is replaced by its largest principal value times the identity: turning then needs no
// gyroscopic term and the fastest, physically idle rotations of slender ribs slow down, so that
// longer steps are stable.
std::vector<NodeInertia> lump_inertia(const Lattice& lattice, bool spherical);
} // namespace interlock::fem
