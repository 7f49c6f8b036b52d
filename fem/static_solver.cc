#include "fem/static_solver.h"

#include "fem/beam_constants.h"
#include "fem/beam_tangent.h"
#include "fem/lattice_mesh.h"

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/petsc_sparse_matrix.h>
#include <deal.II/lac/vector.h>

#include <petscsnes.h>

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

void require_petsc()
{
  PetscBool running = PETSC_FALSE;
  PetscInitialized(&running);
  if (running == PETSC_FALSE)
    throw std::runtime_error(
        "The static solver needs PETSc: create a dealii::Utilities::MPI::MPI_InitFinalize first.");
}
} // namespace

// Unknowns in deal.II's numbering: displacement from the unloaded state, rotation vector on top of
// the solver's orientations. Constrained freedoms have residual zero and take their values from the
// constraints inside each evaluation.
class StaticSolver::LoadStep
{
public:
  // `share` of the loads and of prescribed displacements holds in this step; prescribed rotations
  // advance by `increment` of their final value.
  LoadStep(const StaticSolver& solver, double share, double increment);

  // Newton's method from the solver's state. Returns the number of iterations.
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
    const unsigned int dof = solver_.lattice_.first_dof(node) + first;
    return {x[dof], x[dof + 1], x[dof + 2]};
  }
  dealii::Vector<double> constrained_copy(Vec x) const;
  BeamTangent element_tangent(int e, const dealii::Vector<double>& x) const;
  std::vector<unsigned int> element_dofs(int e) const;

  const StaticSolver& solver_;
  const double share_;
  double rounding_level_ =
      0; // norm of the residual that the last digit of the coordinates causes [N]
  dealii::AffineConstraints<double> constraints_;
  dealii::PETScWrappers::SparseMatrix matrix_;
  dealii::Vector<double> solution_;
};

StaticSolver::LoadStep::LoadStep(const StaticSolver& solver, double share, double increment)
    : solver_(solver), share_(share)
{
  const Lattice& lattice = solver.lattice_;
  for (const Support& support : solver.supports_) {
    const unsigned int dof = lattice.first_dof(support.node) + support.component;
    constraints_.add_line(dof);
    constraints_.set_inhomogeneity(dof,
                                   support.value * (support.component < 3 ? share : increment));
  }
  constraints_.merge(lattice.mesh().junction_ties());
  constraints_.close();

  const dealii::DoFHandler<1, 3>& dof_handler = lattice.mesh().dof_handler();
  dealii::DynamicSparsityPattern sparsity(dof_handler.n_dofs());
  dealii::DoFTools::make_sparsity_pattern(dof_handler, sparsity, constraints_, true);
  matrix_.reinit(sparsity);

  solution_.reinit(dof_handler.n_dofs());
  for (int i = 0; i < lattice.n_nodes(); ++i)
    for (int c = 0; c < 3; ++c) solution_[lattice.first_dof(i) + c] = solver.displacement(i)[c];
  constraints_.distribute(solution_);

  for (int e = 0; e < lattice.n_elements(); ++e) {
    const double coordinate = lattice.reference_position(lattice.element(e).node[1]).norm();
    const double strain = 5e-17 * (1 + coordinate / lattice.element(e).length);
    rounding_level_ = std::hypot(rounding_level_, lattice.section(e).axial * strain);
  }
}

dealii::Vector<double> StaticSolver::LoadStep::constrained_copy(Vec x) const
{
  const PetscScalar* values = nullptr;
  VecGetArrayRead(x, &values);
  dealii::Vector<double> copy(values, values + solution_.size());
  VecRestoreArrayRead(x, &values);
  constraints_.distribute(copy);
  return copy;
}

BeamTangent StaticSolver::LoadStep::element_tangent(int e, const dealii::Vector<double>& x) const
{
  const Lattice& lattice = solver_.lattice_;
  std::array<Eigen::Vector3d, 2> position, turn;
  for (int v = 0; v < 2; ++v) {
    const int node = lattice.element(e).node[v];
    position[v] = lattice.reference_position(node) + at(x, node, 0);
    turn[v] = at(x, node, 3);
  }
  return beam_tangent(beam_constants(lattice, e, solver_.options_.rbf), position,
                      solver_.end_orientations(e), turn);
}

// Freedoms of the nodes, so those that junctions tie others to.
std::vector<unsigned int> StaticSolver::LoadStep::element_dofs(int e) const
{
  std::vector<unsigned int> dofs;
  for (const int node : solver_.lattice_.element(e).node)
    for (unsigned int c = 0; c < 6; ++c) dofs.push_back(solver_.lattice_.first_dof(node) + c);
  return dofs;
}

PetscErrorCode StaticSolver::LoadStep::residual(SNES, Vec x, Vec f, void* self)
{
  const LoadStep& step = *static_cast<LoadStep*>(self);
  const Lattice& lattice = step.solver_.lattice_;
  const dealii::Vector<double> state = step.constrained_copy(x);
  dealii::Vector<double> sum(state.size()), local(12);
  for (int e = 0; e < lattice.n_elements(); ++e) {
    const BeamTangent tangent = step.element_tangent(e, state);
    std::copy(tangent.force.begin(), tangent.force.end(), local.begin());
    step.constraints_.distribute_local_to_global(local, step.element_dofs(e), sum);
  }
  for (int i = 0; i < lattice.n_nodes(); ++i)
    for (int c = 0; c < 6; ++c)
      sum[lattice.first_dof(i) + c] -= step.share_ * step.solver_.loads_[i][c];
  step.constraints_.set_zero(sum);

  PetscScalar* values = nullptr;
  VecGetArray(f, &values);
  std::copy(sum.begin(), sum.end(), values);
  VecRestoreArray(f, &values);
  return 0;
}

PetscErrorCode StaticSolver::LoadStep::jacobian(SNES, Vec x, Mat, Mat, void* self)
{
  LoadStep& step = *static_cast<LoadStep*>(self);
  const dealii::Vector<double> state = step.constrained_copy(x);
  step.matrix_ = 0;
  dealii::FullMatrix<double> local(12, 12);
  for (int e = 0; e < step.solver_.lattice_.n_elements(); ++e) {
    const BeamTangent tangent = step.element_tangent(e, state);
    for (int i = 0; i < 12; ++i)
      for (int j = 0; j < 12; ++j) local(i, j) = tangent.stiffness(i, j);
    step.constraints_.distribute_local_to_global(local, step.element_dofs(e), step.matrix_);
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
PetscErrorCode StaticSolver::LoadStep::converged(SNES, PetscInt iteration, PetscReal,
                                                 PetscReal step, PetscReal residual,
                                                 SNESConvergedReason* reason, void* self)
{
  const LoadStep& load_step = *static_cast<LoadStep*>(self);
  *reason = SNES_CONVERGED_ITERATING;
  if (!(residual < 1e300))
    *reason = SNES_DIVERGED_FNORM_NAN;
  else if (residual <= load_step.rounding_level_)
    *reason = SNES_CONVERGED_FNORM_ABS;
  else if (iteration > 0 && step <= load_step.solver_.options_.step_tolerance)
    *reason = SNES_CONVERGED_SNORM_RELATIVE;
  return 0;
}

SNESConvergedReason StaticSolver::LoadStep::run_newton(SNESLineSearchType line_search,
                                                       PetscInt& iterations)
{
  SNES raw = nullptr;
  check(SNESCreate(PETSC_COMM_SELF, &raw));
  const SnesOwner snes(raw);
  const VecOwner x = make_vec(solution_.size()), f = make_vec(solution_.size());
  check(SNESSetFunction(snes.get(), f.get(), residual, this));
  check(SNESSetJacobian(snes.get(), matrix_, matrix_, jacobian, this));
  check(SNESSetTolerances(snes.get(), 0, 0, 0, solver_.options_.max_iterations, 100000));
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

int StaticSolver::LoadStep::solve()
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

StaticSolver::StaticSolver(const Lattice& lattice, const StaticOptions& options)
    : lattice_(lattice), options_(options),
      loads_(lattice.n_nodes(), Eigen::Matrix<double, 6, 1>::Zero()),
      orientation_(lattice.n_nodes(), Eigen::Quaterniond::Identity())
{
  for (int i = 0; i < lattice.n_nodes(); ++i) position_.push_back(lattice.reference_position(i));
}

void StaticSolver::clamp(const std::vector<int>& nodes)
{
  for (const int node : nodes)
    for (int c = 0; c < 6; ++c) prescribe(node, c, 0);
}

void StaticSolver::pin(const std::vector<int>& nodes)
{
  for (const int node : nodes)
    for (int c = 0; c < 3; ++c) prescribe(node, c, 0);
}

void StaticSolver::prescribe(int node, int component, double value)
{
  for (Support& support : supports_)
    if (support.node == node && support.component == component) {
      support.value = value;
      return;
    }
  supports_.push_back({node, component, value});
}

void StaticSolver::add_load(int node, const Eigen::Vector3d& force, const Eigen::Vector3d& moment)
{
  loads_.at(node).head<3>() += force;
  loads_[node].tail<3>() += moment;
}

int StaticSolver::solve()
{
  require_petsc();
  int iterations = 0;
  for (int k = 1; k <= options_.load_steps; ++k) {
    LoadStep step(*this, static_cast<double>(k) / options_.load_steps, 1. / options_.load_steps);
    iterations += step.solve();
    for (int i = 0; i < lattice_.n_nodes(); ++i) {
      position_[i] = lattice_.reference_position(i) + step.displacement(i);
      orientation_[i] = (rotation_exponential(step.turn(i)) * orientation_[i]).normalized();
    }
  }
  return iterations;
}

std::array<Eigen::Vector3d, 2> StaticSolver::end_positions(int e) const
{
  const auto& node = lattice_.element(e).node;
  return {position_[node[0]], position_[node[1]]};
}

std::array<Eigen::Quaterniond, 2> StaticSolver::end_orientations(int e) const
{
  const auto& node = lattice_.element(e).node;
  return {orientation_[node[0]], orientation_[node[1]]};
}

SectionForces StaticSolver::section_forces(int e) const
{
  return fem::section_forces(beam_constants(lattice_, e, options_.rbf), end_positions(e),
                             end_orientations(e));
}

double StaticSolver::strain_energy() const
{
  double sum = 0;
  for (int e = 0; e < lattice_.n_elements(); ++e) {
    const BeamConstants<double> beam = beam_constants(lattice_, e, options_.rbf);
    sum += fem::strain_energy(beam_strains(beam_ends(end_positions(e), end_orientations(e)), beam),
                              beam);
  }
  return sum;
}

Eigen::Matrix<double, 6, 1> StaticSolver::reaction(int node) const
{
  Eigen::Matrix<double, 6, 1> sum = -loads_.at(node);
  for (int e = 0; e < lattice_.n_elements(); ++e)
    for (int v = 0; v < 2; ++v)
      if (lattice_.element(e).node[v] == node)
        sum += beam_force(beam_constants(lattice_, e, options_.rbf), end_positions(e),
                          end_orientations(e))
                   .segment<6>(6 * v);
  return sum;
}
} // namespace interlock::fem
