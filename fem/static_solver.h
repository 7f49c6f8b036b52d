// Static equilibrium of a lattice by Newton's method (PETSc SNES with line search and direct
// solution).
#pragma once

#include "fem/lattice.h"
#include "fem/section_forces.h"

#include <Eigen/Dense>
#include <Eigen/Geometry>

#include <array>
#include <vector>

namespace interlock::fem
{
struct StaticOptions {
  bool rbf = true;               // residual bending flexibility in the shear stiffness
  int load_steps = 10;           // loads and prescribed motion grow in equal steps
  int max_iterations = 100;      // Newton iterations in one load step
  double step_tolerance = 1e-10; // a load step ends when the Newton step [m, rad] is shorter, or
                                 // when the residual is at the rounding level of the axial forces
};

// What the solver works on: the lattice, what acts on it at full load, and where it is now.
struct StaticState {
  struct Support {
    int node, component; // freedom 0-5 of the node, as in StaticSolver::prescribe
    double value;        // at full load [m, rad]
  };
  // Unloaded, without supports.
  explicit StaticState(const Lattice& unloaded);
  // Of both nodes of an element.
  std::array<Eigen::Vector3d, 2> end_positions(int e) const;
  std::array<Eigen::Quaterniond, 2> end_orientations(int e) const;

  Lattice lattice;
  std::vector<Support> supports;
  std::vector<Eigen::Matrix<double, 6, 1>>
      loads;                             // force and moment on each node at full load [N, N m]
  std::vector<Eigen::Vector3d> position; // [m]
  std::vector<Eigen::Quaterniond> orientation; // rotation from the unloaded state
};

// Loads and supports are set first, then `solve` brings them on in steps. Rotations are unit
// quaternions; the unknowns of a load step are displacements and the rotation vectors on top of the
// orientations of the last step, so that total rotations may be of any size. World frame
// throughout. PETSc must be running (dealii::Utilities::MPI::MPI_InitFinalize); every process
// solves the whole lattice.
class StaticSolver
{
public:
  StaticSolver(const Lattice& lattice, const StaticOptions& options);

  // Fixes all six freedoms, or the three displacements, of these nodes.
  void clamp(const std::vector<int>& nodes);
  void pin(const std::vector<int>& nodes);
  // Prescribes freedom 0-5 of a node: displacement x, y, z [m] or rotation about x, y, z [rad],
  // reached at the last load step. A rotation grows in increments about the world axis; prescribe
  // the other two rotations of that node as zero.
  void prescribe(int node, int component, double value);
  // Adds a dead load: force [N] and moment [N m] that keep their direction in the world frame.
  void add_load(int node, const Eigen::Vector3d& force, const Eigen::Vector3d& moment);

  // Ramps loads and prescribed motion up from the present state; meant to be called once, because a
  // second call ramps anew and adds its prescribed rotations to the present ones. Returns the
  // number of Newton iterations of all load steps. Throws std::runtime_error when a load step does
  // not converge or PETSc is not running; the message names the step and PETSc's reason.
  int solve();

  const Lattice& lattice() const { return state_.lattice; }
  const Eigen::Vector3d& position(int node) const { return state_.position[node]; } // [m]
  Eigen::Vector3d displacement(int node) const
  {
    return state_.position[node] - state_.lattice.reference_position(node);
  }
  const Eigen::Quaterniond& orientation(int node) const { return state_.orientation[node]; }
  SectionForces section_forces(int e) const;
  double strain_energy() const; // [J]
  // Force (first three) and moment that the supports exert on a node [N, N m]; zero at free nodes
  // to the tolerance of the solution.
  Eigen::Matrix<double, 6, 1> reaction(int node) const;

private:
  StaticState state_;
  StaticOptions options_;
};
} // namespace interlock::fem
