// A lattice at rest: what acts on it and where its nodes are.
#pragma once

#include "fem/lattice/lattice.h"
#include "fem/lattice/quadratic_lattice.h"

#include <Eigen/Dense>
#include <Eigen/Geometry>

#include <array>
#include <vector>

namespace dealii
{
template <typename> class Vector;
}

namespace interlock::fem
{
using NodeLoad = Eigen::Matrix<double, 6, 1>; // force [N], then moment about the node [N m], world

// Every process holds the whole state.
struct StaticState {
  struct Support {
    int node, component; // freedom 0-5 of the node, as in StaticSolver::prescribe
    double value;        // displacement from the unloaded state [m] or turn [rad]
    double reached = 0;  // turn that earlier load steps have made [rad]
  };
  // Unloaded, without supports.
  explicit StaticState(const Lattice& unloaded);
  Eigen::Vector3d world_position(int node) const { return origin + position[node]; } // [m]
  // Of both nodes of an element.
  std::array<Eigen::Vector3d, 2> end_positions(int e) const;
  std::array<Eigen::Quaterniond, 2> end_orientations(int e) const;
  // Moves the nodes to freedoms in deal.II's numbering, as LatticeSystem has them: displacement
  // from the unloaded state [m], rotation vector on top of the present orientation [rad].
  void advance(const dealii::Vector<double>& freedoms);
  // Makes the plastic stretch of the present state part of the history. `rbf`: see StaticOptions.
  void commit_plastic_stretch(bool rbf);

  // Where a lattice lies far from zero, as on a map, its nodes are counted from the middle of its
  // box: near zero there are digits for displacements. Otherwise the origin is zero.
  Eigen::Vector3d origin; // [m]
  Lattice lattice;        // about the origin
  std::vector<Support> supports;
  std::vector<NodeLoad> loads;                 // on each node
  std::vector<NodeLoad> reached_loads;         // under which the present state is at rest
  std::vector<Eigen::Vector3d> position;       // from the origin [m]
  std::vector<Eigen::Quaterniond> orientation; // rotation from the unloaded state
  std::vector<double> plastic_stretch;         // of each element, see tension_law.h [-]
  std::vector<QuadraticPair> pairs; // quadratic elements; empty: the lattice's own elements
};

// Throws std::runtime_error when the supports leave the lattice, or a part of it that hangs
// together with nothing else, free to move as a rigid body: then statics has no answer.
void require_held(const StaticState& state);
} // namespace interlock::fem
