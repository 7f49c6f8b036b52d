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
class LatticeSystem;

// Whether a lattice at rest comes back when it is nudged. Not known: the tangent is singular;
// moments act that keep their direction, and its symmetric part has negative pivots; or a load step
// as short as a 64th still turned a node by more than StaticOptions::longest_turn, so that another
// branch may have been reached.
enum class Stability { stable, unstable, not_known };

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
  // Throws std::invalid_argument when the order is neither 1 nor 2, when a number of steps or
  // iterations or the tolerance is not positive, or when the lattice cannot be read as quadratic
  // elements, see quadratic_pairs.
  StaticSolver(const Lattice& lattice, const StaticOptions& options);

  // These throw std::invalid_argument for a node or a freedom that there is not, and for values
  // that are not finite. Fixes all six freedoms, or the three displacements, of these nodes.
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
  // nothing in the first) to what is set now. A step that does not converge is halved, up to ten
  // times, and so is one that turns an element's ends against each other by more than the kernel is
  // good for; one that turns a node by more than StaticOptions::longest_turn, up to six times.
  // Returns the number of Newton iterations. Throws std::runtime_error when PETSc is not running,
  // when the lattice is not held, when a load step does not converge or an element stays folded
  // (the state is that of the last load step that was right), or where the loads drown in the
  // rounding of the axial stiffness: when one Newton step more would move a node by more than 1e-6
  // of the largest displacement so far, or when reactions and loads leave more than
  // StaticOptions::largest_imbalance unbalanced. Reactions contain what that step changes in them,
  // see LastCorrection, unless they balance to 1e-10 as they are.
  int solve();
  // Follows the equilibrium path by arc length through limit points and snap-back, see ArcLength:
  // the loads are those that the state is at rest under plus the load factor times what has been
  // added since; supports stay where they are. Throws as `solve`, and when the path cannot be
  // followed further; the state is that of the last point.
  std::vector<PathPoint> trace_path(const ArcLengthOptions& arc_length);
  // What was left of the sum of loads and reactions, and of their moments about the middle over the
  // lattice's size, after the last `solve`; share of the largest sum of their amounts so far [-].
  double imbalance() const { return imbalance_; }
  // Share of the largest displacement so far that one Newton step more would move a node by after
  // the last `solve`: what rounding leaves uncertain; 0 where reactions balance to 1e-10 [-].
  double uncertainty() const { return uncertainty_; }
  // Of the present equilibrium; factorises its tangent unless `stable_branch` has done so.
  Stability stability();
  // Directions in which the equilibrium of the last load step is unstable, such as that of a rib
  // above its buckling load that stays straight; and the largest number on the way. Counted with
  // the option `stable_branch` only. Where a step as short as a 64th still leads to an unstable
  // equilibrium, the path goes on from there: it may jump to another branch.
  int unstable_directions() const { return unstable_; }
  int unstable_on_the_way() const { return unstable_on_the_way_; }
  int factorisations() const { return factorisations_; } // made by all calls of `solve`

  const Lattice& lattice() const { return lattice_; }
  Eigen::Vector3d position(int node) const { return state_.world_position(node); } // [m]
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
  enum class Judgement { right, astray };
  // Of the step from `before` to the present state.
  Judgement judge(const StaticState& before, LatticeSystem& system, int stride);
  void require_balance(LatticeSystem& system);

  Lattice lattice_; // as it was given; that of the state is about the state's origin
  StaticState state_;
  StaticOptions options_;
  int factorisations_ = 0;
  int unstable_ = 0, unstable_on_the_way_ = 0;
  bool has_moved_ = false, jumped_ = false;
  std::vector<NodeLoad> correction_;          // of the forces, see LastCorrection; empty: none
  double imbalance_ = 0, largest_forces_ = 0; // share [-], sum of amounts [N]
  double uncertainty_ = 0, largest_displacement_ = 0; // share [-], [m]
};
} // namespace interlock::fem
