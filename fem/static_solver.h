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

  // Solves from the present state. Returns the number of Newton iterations of all load steps.
  // Throws std::runtime_error when a load step does not converge or PETSc is not running; the
  // message names the step and PETSc's reason.
  int solve();

  const Eigen::Vector3d& position(int node) const { return position_[node]; } // [m]
  Eigen::Vector3d displacement(int node) const
  {
    return position_[node] - lattice_.reference_position(node);
  }
  const Eigen::Quaterniond& orientation(int node) const { return orientation_[node]; }
  SectionForces section_forces(int e) const;
  double strain_energy() const; // [J]
  // Force (first three) and moment that the supports exert on a node [N, N m]; zero at free nodes
  // to the tolerance of the solution.
  Eigen::Matrix<double, 6, 1> reaction(int node) const;

private:
  struct Support {
    int node, component;
    double value;
  };
  class LoadStep; // the nonlinear system of one load step, in static_solver.cc

  std::array<Eigen::Vector3d, 2> end_positions(int e) const;
  std::array<Eigen::Quaterniond, 2> end_orientations(int e) const;

  Lattice lattice_;
  StaticOptions options_;
  std::vector<Support> supports_;
  std::vector<Eigen::Matrix<double, 6, 1>> loads_; // at full load
  std::vector<Eigen::Vector3d> position_;
  std::vector<Eigen::Quaterniond> orientation_;
};
} // namespace interlock::fem
