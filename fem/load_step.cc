#include "fem/load_step.h"

#include "fem/beam_constants.h"
#include "fem/lattice_mesh.h"

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>

namespace interlock::fem
{
namespace
{
void check(PetscErrorCode code)
{
  AssertThrow(code == 0, dealii::LACExceptions::ExcPETScError(code));
}

// Owners of PETSc objects.
struct SnesDeleter {
  using pointer = SNES;
  void operator()(SNES snes) const { SNESDestroy(&snes); }
};
struct VecDeleter {
  using pointer = Vec;
  void operator()(Vec vec) const { VecDestroy(&vec); }
};
using SnesOwner = std::unique_ptr<SNES, SnesDeleter>;
using VecOwner = std::unique_ptr<Vec, VecDeleter>;

VecOwner make_vec(unsigned int size)
{
  Vec vec = nullptr;
  check(VecCreateSeq(PETSC_COMM_SELF, static_cast<PetscInt>(size), &vec));
  return VecOwner(vec);
}
} // namespace

LoadStep::LoadStep(const StaticState& state, const StaticOptions& options, double share,
                   double increment)
    : state_(state), options_(options), share_(share)
{
  const Lattice& lattice = state.lattice;
  for (const StaticState::Support& support : state.supports) {
    const unsigned int dof = lattice.dof(support.node, support.component);
    constraints_.add_line(dof);
    constraints_.set_inhomogeneity(dof,
                                   support.value * (support.component < 3 ? share : increment));
  }
  constraints_.merge(lattice.mesh().junction_ties());
  constraints_.close();

  const dealii::DoFHandler<1, 3>& dof_handler = lattice.mesh().dof_handler();
  dealii::DynamicSparsityPattern sparsity(dof_handler.n_dofs());
  dealii::DoFTools::make_sparsity_pattern(dof_handler, sparsity, constraints_, true);
  for (int i = 0; i < lattice.n_springs(); ++i)
    constraints_.add_entries_local_to_global(spring_dofs(i), sparsity, true);
  matrix_.reinit(sparsity);

  solution_.reinit(dof_handler.n_dofs());
  for (int i = 0; i < lattice.n_nodes(); ++i)
    for (int c = 0; c < 3; ++c)
      solution_[lattice.dof(i, c)] = (state.position[i] - lattice.reference_position(i))[c];
  constraints_.distribute(solution_);

  for (int e = 0; e < lattice.n_elements(); ++e) {
    const double coordinate = lattice.reference_position(lattice.element(e).node[1]).norm();
    const double strain = 5e-17 * (1 + coordinate / lattice.element(e).length);
    rounding_level_ = std::hypot(rounding_level_, lattice.section(e).axial * strain);
  }
}

dealii::Vector<double> LoadStep::constrained_copy(Vec x) const
{
  const PetscScalar* values = nullptr;
  VecGetArrayRead(x, &values);
  dealii::Vector<double> copy(values, values + solution_.size());
  VecRestoreArrayRead(x, &values);
  constraints_.distribute(copy);
  return copy;
}

SpringTangent LoadStep::spring_tangent_at(int s, const dealii::Vector<double>& x) const
{
  const std::array<int, 2>& node = state_.lattice.spring(s).node;
  return spring_tangent(state_.lattice.spring(s),
                        {state_.orientation[node[0]], state_.orientation[node[1]]},
                        {at(x, node[0], 3), at(x, node[1], 3)});
}

BeamTangent LoadStep::element_tangent(int e, const dealii::Vector<double>& x) const
{
  const Lattice& lattice = state_.lattice;
  std::array<Eigen::Vector3d, 2> position, turn;
  for (int v = 0; v < 2; ++v) {
    const int node = lattice.element(e).node[v];
    position[v] = lattice.reference_position(node) + at(x, node, 0);
    turn[v] = at(x, node, 3);
  }
  return beam_tangent(beam_constants(lattice, e, options_.rbf), position,
                      state_.end_orientations(e), turn);
}

// Freedoms of the nodes, so those that junctions tie others to.
std::vector<unsigned int> LoadStep::element_dofs(int e) const
{
  std::vector<unsigned int> dofs;
  for (const int node : state_.lattice.element(e).node)
    for (unsigned int c = 0; c < 6; ++c) dofs.push_back(state_.lattice.dof(node, c));
  return dofs;
}

// Rotations of both nodes.
std::vector<unsigned int> LoadStep::spring_dofs(int s) const
{
  std::vector<unsigned int> dofs;
  for (const int node : state_.lattice.spring(s).node)
    for (unsigned int c = 3; c < 6; ++c) dofs.push_back(state_.lattice.dof(node, c));
  return dofs;
}

PetscErrorCode LoadStep::residual(SNES, Vec x, Vec f, void* self)
{
  const LoadStep& step = *static_cast<LoadStep*>(self);
  const Lattice& lattice = step.state_.lattice;
  const dealii::Vector<double> state = step.constrained_copy(x);
  dealii::Vector<double> sum(state.size()), local(12);
  for (int e = 0; e < lattice.n_elements(); ++e) {
    const BeamTangent tangent = step.element_tangent(e, state);
    std::copy(tangent.force.begin(), tangent.force.end(), local.begin());
    step.constraints_.distribute_local_to_global(local, step.element_dofs(e), sum);
  }
  local.reinit(6);
  for (int s = 0; s < lattice.n_springs(); ++s) {
    const SpringTangent tangent = step.spring_tangent_at(s, state);
    std::copy(tangent.moment.begin(), tangent.moment.end(), local.begin());
    step.constraints_.distribute_local_to_global(local, step.spring_dofs(s), sum);
  }
  for (int i = 0; i < lattice.n_nodes(); ++i)
    for (int c = 0; c < 6; ++c) sum[lattice.dof(i, c)] -= step.share_ * step.state_.loads[i][c];
  step.constraints_.set_zero(sum);

  PetscScalar* values = nullptr;
  VecGetArray(f, &values);
  std::copy(sum.begin(), sum.end(), values);
  VecRestoreArray(f, &values);
  return 0;
}

PetscErrorCode LoadStep::jacobian(SNES, Vec x, Mat, Mat, void* self)
{
  LoadStep& step = *static_cast<LoadStep*>(self);
  const dealii::Vector<double> state = step.constrained_copy(x);
  step.matrix_ = 0;
  dealii::FullMatrix<double> local(12, 12);
  for (int e = 0; e < step.state_.lattice.n_elements(); ++e) {
    const BeamTangent tangent = step.element_tangent(e, state);
    for (int i = 0; i < 12; ++i)
      for (int j = 0; j < 12; ++j) local(i, j) = tangent.stiffness(i, j);
    step.constraints_.distribute_local_to_global(local, step.element_dofs(e), step.matrix_);
  }
  local.reinit(6, 6);
  for (int s = 0; s < step.state_.lattice.n_springs(); ++s) {
    const SpringTangent tangent = step.spring_tangent_at(s, state);
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j) local(i, j) = tangent.stiffness(i, j);
    step.constraints_.distribute_local_to_global(local, step.spring_dofs(s), step.matrix_);
  }
  // Fixed and tied freedoms are rows of the identity: their residual is zero, so they stay as they
  // are.
  step.matrix_.compress(dealii::VectorOperation::add);
  for (unsigned int dof = 0; dof < state.size(); ++dof)
    if (step.constraints_.is_constrained(dof)) step.matrix_.set(dof, dof, 1.);
  step.matrix_.compress(dealii::VectorOperation::insert);
  return 0;
}

// Not by the residual: its size at the start says little (a prescribed rotation strains one element
// by it), while the Newton step estimates the error of the solution itself.
PetscErrorCode LoadStep::converged(SNES, PetscInt iteration, PetscReal, PetscReal step,
                                   PetscReal residual, SNESConvergedReason* reason, void* self)
{
  const LoadStep& load_step = *static_cast<LoadStep*>(self);
  *reason = SNES_CONVERGED_ITERATING;
  if (!(residual < 1e300))
    *reason = SNES_DIVERGED_FNORM_NAN;
  else if (residual <= load_step.rounding_level_)
    *reason = SNES_CONVERGED_FNORM_ABS;
  else if (iteration > 0 && step <= load_step.options_.step_tolerance)
    *reason = SNES_CONVERGED_SNORM_RELATIVE;
  return 0;
}

SNESConvergedReason LoadStep::run_newton(SNESLineSearchType line_search, PetscInt& iterations)
{
  SNES raw = nullptr;
  check(SNESCreate(PETSC_COMM_SELF, &raw));
  const SnesOwner snes(raw);
  const VecOwner x = make_vec(solution_.size()), f = make_vec(solution_.size());
  check(SNESSetFunction(snes.get(), f.get(), residual, this));
  check(SNESSetJacobian(snes.get(), matrix_, matrix_, jacobian, this));
  check(SNESSetTolerances(snes.get(), 0, 0, 0, options_.max_iterations, 100000));
  check(SNESSetConvergenceTest(snes.get(), converged, this, nullptr));
  KSP ksp = nullptr;
  PC pc = nullptr;
  SNESLineSearch search = nullptr;
  check(SNESGetKSP(snes.get(), &ksp));
  check(KSPSetType(ksp, KSPPREONLY));
  check(KSPGetPC(ksp, &pc));
  check(PCSetType(pc, PCLU));
  check(SNESGetLineSearch(snes.get(), &search));
  check(SNESLineSearchSetType(search, line_search));
  check(SNESSetFromOptions(snes.get()));

  PetscScalar* values = nullptr;
  check(VecGetArray(x.get(), &values));
  std::copy(solution_.begin(), solution_.end(), values);
  check(VecRestoreArray(x.get(), &values));
  check(SNESSolve(snes.get(), nullptr, x.get()));

  SNESConvergedReason reason;
  PetscInt count = 0;
  check(SNESGetConvergedReason(snes.get(), &reason));
  check(SNESGetIterationNumber(snes.get(), &count));
  iterations += count;
  if (reason > 0) solution_ = constrained_copy(x.get());
  return reason;
}

int LoadStep::solve()
{
  PetscInt iterations = 0;
  SNESConvergedReason reason = run_newton(SNESLINESEARCHBASIC, iterations);
  if (reason <= 0) reason = run_newton(SNESLINESEARCHL2, iterations);
  if (reason <= 0)
    throw std::runtime_error("Newton's method stopped at load share " + std::to_string(share_) +
                             " after " + std::to_string(iterations) +
                             " iterations: " + SNESConvergedReasons[reason] + ".");
  return static_cast<int>(iterations);
}
} // namespace interlock::fem
