// Static equilibrium of a lattice by Newton's method (PETSc SNES with direct
// solution), in parallel.
#pragma once

#include "fem/beam/section_forces.h"
#include "fem/lattice/lattice.h"
#include "fem/statics/arc_length_options.h"
#include "fem/statics/static_options.h"
#include "fem/statics/static_state.h"

#include <Eigen/Dense>
#include <Eigen/Geometry>

#include <vector>

namespace interlock::fem
{
// Loads and supports are set first, then `solve` or `trace_path` brings them on in steps. Rotations
// are unit quaternions; the unknowns of a load step are displacements and the rotation vectors on
// top of the orientations of the last step, so that total rotations may be of any size. World frame
// throughout. PETSc must be running (dealii::Utilities::MPI::MPI_InitFinalize). All processes of
// the communicator must make the same calls; each holds the whole answer. MUMPS factorises; PETSc's
// options with the prefix statics_ choose otherwise, for example -statics_ksp_type cg
// -statics_pc_type gamg.
class StaticSolver
{
public:
  // Throws std::invalid_argument when the order is neither 1 nor 2, or when the lattice cannot be
  // read as quadratic elements, see quadratic_pairs.
  StaticSolver(const Lattice& lattice, const StaticOptions& options);

  // Fixes all six freedoms, or the three displacements, of these nodes.
  void clamp(const std::vector<int>& nodes);
  void pin(const std::vector<int>& nodes);
  // Prescribes freedom 0-5 of a node: displacement x, y, z from the unloaded state [m] or turn
  // about x, y, z [rad], reached at the end of `solve`. A turn grows in increments about the world
  // axis; prescribe the other two rotations of that node as zero. This is also displacement
  // control: the load is then the reaction, and falls beyond a limit point.
  void prescribe(int node, int component, double value);
  // Adds a dead load: force [N] and moment [N m] that keep their direction in the world frame.
  void add_load(int node, const Eigen::Vector3d& force, const Eigen::Vector3d& moment);

  // Ramps loads and prescribed motion up, in equal steps, from what the last call reached (from
  // nothing in the first) to what is set now. A step that does not converge is halved.
  // Returns the number of Newton iterations. Throws std::runtime_error when PETSc is not running,
  // when the lattice is not held, or when a load step does not converge; the message names the step
  // and PETSc's reason, and the state is that of the last load step that did.
  int solve();
  // Follows the equilibrium path by arc length through limit points and snap-back, see ArcLength:
  // the loads are those that the state is at rest under plus the load factor times what has been
  // added since; supports stay where they are. Throws as `solve`, and when the path cannot be
  // followed further; the state is that of the last point.
  std::vector<PathPoint> trace_path(const ArcLengthOptions& arc_length);
  // Directions in which the equilibrium of the last load step is unstable, such as that of a rib
  // above its buckling load that stays straight; and the largest number on the way. Counted with
  // the option `stable_branch` only. Where a step as short as a 64th still leads to an unstable
  // equilibrium, the path goes on from there: it may jump to another branch.
  int unstable_directions() const { return unstable_; }
  int unstable_on_the_way() const { return unstable_on_the_way_; }
  int factorisations() const { return factorisations_; } // made by all calls of `solve`

  const Lattice& lattice() const { return state_.lattice; }
  const Eigen::Vector3d& position(int node) const { return state_.position[node]; } // [m]
  Eigen::Vector3d displacement(int node) const
  {
    return state_.position[node] - state_.lattice.reference_position(node);
  }
  const Eigen::Quaterniond& orientation(int node) const { return state_.orientation[node]; }
  const StaticState& state() const { return state_; }
  // Of one element of the lattice; with order 2 at the Gauss point in that half of the pair.
  SectionForces section_forces(int e) const;
  double strain_energy() const; // [J]
  // Stretch that stays when an element is unloaded [-].
  double plastic_stretch(int e) const { return state_.plastic_stretch.at(e); }
  // Force (first three) and moment that the supports exert on a node [N, N m]; zero at free nodes
  // to the tolerance of the solution.
  NodeLoad reaction(int node) const;

private:
  StaticState state_;
  StaticOptions options_;
  int factorisations_ = 0;
  int unstable_ = 0, unstable_on_the_way_ = 0;
};
} // namespace interlock::fem
