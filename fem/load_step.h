// One load step of the static solver: the nonlinear system that PETSc solves.
#pragma once

#include "fem/beam_tangent.h"
#include "fem/static_solver.h"

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/petsc_sparse_matrix.h>
#include <deal.II/lac/vector.h>

#include <petscsnes.h>

#include <vector>

namespace interlock::fem
{
// Unknowns in deal.II's numbering: displacement from the unloaded state, rotation vector on top of
// the state's orientations. Constrained freedoms have residual zero and take their values from the
// constraints inside each evaluation.
class LoadStep
{
public:
  // `share` of the loads and of prescribed displacements holds in this step; prescribed rotations
  // advance by `increment` of their final value. The state must outlive this object.
  LoadStep(const StaticState& state, const StaticOptions& options, double share, double increment);

  // Newton's method from the given state. Returns the number of iterations.
  // Throws std::runtime_error when neither way converges.
  //
  // Full steps first. A slender beam that turns by a Newton step stretches by half the square of
  // the turn, so its residual grows by EA/EI before it falls, and a search that insists on a
  // falling residual creeps. Where full steps fail, steps that minimise the residual along each
  // direction are slow but sure.
  int solve();

  Eigen::Vector3d displacement(int node) const { return at(solution_, node, 0); }
  Eigen::Vector3d turn(int node) const { return at(solution_, node, 3); }

private:
  SNESConvergedReason run_newton(SNESLineSearchType line_search, PetscInt& iterations);
  static PetscErrorCode residual(SNES, Vec x, Vec f, void* self);
  static PetscErrorCode jacobian(SNES, Vec x, Mat, Mat, void* self);
  static PetscErrorCode converged(SNES, PetscInt iteration, PetscReal, PetscReal step,
                                  PetscReal residual, SNESConvergedReason* reason, void* self);

  Eigen::Vector3d at(const dealii::Vector<double>& x, int node, int first) const
  {
    const unsigned int dof = state_.lattice.dof(node, first);
    return {x[dof], x[dof + 1], x[dof + 2]};
  }
  dealii::Vector<double> constrained_copy(Vec x) const;
  BeamTangent element_tangent(int e, const dealii::Vector<double>& x) const;
  SpringTangent spring_tangent_at(int s, const dealii::Vector<double>& x) const;
  std::vector<unsigned int> element_dofs(int e) const;
  std::vector<unsigned int> spring_dofs(int s) const;

  const StaticState& state_;
  const StaticOptions& options_;
  const double share_;
  double rounding_level_ =
      0; // norm of the residual that the last digit of the coordinates causes [N]
  dealii::AffineConstraints<double> constraints_;
  dealii::PETScWrappers::SparseMatrix matrix_;
  dealii::Vector<double> solution_;
};
} // namespace interlock::fem
