#include "fem/statics/load_step.h"

#include <cmath>

namespace interlock::fem
{
double rounding_level(const Lattice& lattice)
{
  double level = 0;
  for (int e = 0; e < lattice.n_elements(); ++e) {
    const double coordinate = lattice.reference_position(lattice.element(e).node[1]).norm();
    const double strain = 5e-17 * (1 + coordinate / lattice.element(e).length);
    level = std::hypot(level, lattice.section(e).axial * strain);
  }
  return level;
}

LoadStep::LoadStep(LatticeSystem& system, const StaticState& state, const StaticOptions& options)
    : system_(system), state_(state), options_(options),
      rounding_level_(rounding_level(state.lattice)), x_(system.new_vector()),
      f_(system.new_vector()), sum_(system.new_vector())
{
  for (int e = 0; e < state.lattice.n_elements(); ++e)
    stiffness_ = std::hypot(stiffness_, state.lattice.section(e).axial);
  make_solver();
}

void LoadStep::make_solver()
{
  SNES snes = nullptr;
  KSP ksp = nullptr;
  check(SNESCreate(system_.communicator(), &snes));
  snes_.reset(snes);
  check(SNESSetFunction(snes, f_, residual, this));
  check(SNESSetTolerances(snes, 0, 0, 0, options_.max_iterations, 100000));
  check(SNESSetConvergenceTest(snes, converged, this, nullptr));
  check(SNESGetKSP(snes, &ksp));
  use_direct_solver(ksp);
  SNESLineSearch line_search = nullptr;
  check(SNESGetLineSearch(snes, &line_search));
  check(SNESLineSearchSetType(line_search, SNESLINESEARCHBASIC));
  check(SNESSetOptionsPrefix(snes, statics_prefix));
}

PetscErrorCode LoadStep::residual(SNES, Vec x, Vec f, void* self)
{
  LoadStep& step = *static_cast<LoadStep*>(self);
  step.sum_ = 0;
  step.system_.internal_forces(step.system_.everywhere(x), step.sum_);
  step.system_.add_loads(*step.loads_, -1, step.sum_);
  step.sum_.compress(dealii::VectorOperation::add);
  return VecCopy(step.sum_, f);
}

// Leaves the matrix as it is while the last Newton steps shrank fast enough with it; PETSc then
// keeps its factors.
PetscErrorCode LoadStep::jacobian(SNES, Vec x, Mat, Mat, void* self)
{
  LoadStep& step = *static_cast<LoadStep*>(self);
  step.is_fresh_ = step.contraction_ >= step.reuse_;
  if (!step.is_fresh_) return 0;
  step.system_.tangent(step.system_.everywhere(x));
  return 0;
}

// Strains of 10^4, or turns of several times the whole: from there Newton's method does not come
// back to the branch that it left, and its tangents are no longer regular.
bool LoadStep::is_out_of_bounds(Vec x, double residual)
{
  if (residual > 1e4 * stiffness_ + 10 * first_residual_) return true;
  const dealii::Vector<double> freedoms = system_.everywhere(x);
  for (int i = 0; i < state_.lattice.n_nodes(); ++i) {
    double square = 0;
    for (int c = 3; c < 6; ++c) square += std::pow(freedoms[state_.lattice.dof(i, c)], 2);
    if (square > std::pow(8 * M_PI, 2)) return true;
  }
  return false;
}

// Not by the residual: its size at the start says little (a prescribed rotation strains one element
// by it), while the Newton step estimates the error of the solution itself. A residual below
// rounding ends the step too, but not before the load has been answered: a load below the rounding
// of the axial stiffness may bend a rib by its length.
PetscErrorCode LoadStep::converged(SNES snes, PetscInt iteration, PetscReal, PetscReal step,
                                   PetscReal residual, SNESConvergedReason* reason, void* self)
{
  LoadStep& load_step = *static_cast<LoadStep*>(self);
  const double tolerance = load_step.options_.step_tolerance;
  load_step.contraction_ = iteration > 1 ? step / load_step.last_step_ : 1;
  load_step.last_step_ = step;
  if (iteration == 0) load_step.first_residual_ = residual;
  const bool answered =
      !load_step.moves_ || (iteration > 0 && residual <= 1e-6 * load_step.first_residual_);
  // Short steps with a fresh tangent that no longer shrink: their size is rounding.
  const bool stands_still = iteration > 1 && load_step.is_fresh_ && step <= 1e4 * tolerance &&
                            load_step.contraction_ > 0.5;
  *reason = SNES_CONVERGED_ITERATING;
  if (!(residual < 1e300))
    *reason = SNES_DIVERGED_FNORM_NAN;
  else if (residual <= load_step.rounding_level_ && answered)
    *reason = SNES_CONVERGED_FNORM_ABS;
  else if (iteration > 0 && (step <= tolerance || stands_still))
    *reason = SNES_CONVERGED_SNORM_RELATIVE;
  else if (iteration > 0) {
    Vec x = nullptr;
    check(SNESGetSolution(snes, &x));
    if (load_step.is_out_of_bounds(x, residual)) *reason = SNES_DIVERGED_DTOL;
  }
  return 0;
}

LoadStep::Outcome LoadStep::run_newton(double reuse)
{
  check(SNESSetJacobian(snes_.get(), system_.matrix(), system_.matrix(), jacobian, this));
  check(SNESSetFromOptions(snes_.get()));
  KSP ksp = nullptr;
  check(SNESGetKSP(snes_.get(), &ksp));
  check(KSPSetOperators(ksp, system_.matrix(), system_.matrix()));
  if (work_space_ > 20) set_work_space(ksp, work_space_);
  reuse_ = reuse;
  for (const auto dof : system_.owned()) x_(dof) = solution_[dof];
  x_.compress(dealii::VectorOperation::insert);
  const int tangents_before = system_.n_tangents();
  Outcome outcome{};
  PetscErrorCode error = 0;
  {
    const QuietPetsc quiet;
    error = SNESSolve(snes_.get(), nullptr, x_);
  }
  outcome.factorisations = system_.n_tangents() - tangents_before;
  PetscInt count = 0;
  check(SNESGetConvergedReason(snes_.get(), &outcome.reason));
  check(SNESGetIterationNumber(snes_.get(), &count));
  outcome.iterations = static_cast<int>(count);
  if (error != 0) outcome.reason = SNES_DIVERGED_LINEAR_SOLVE;
  // A zero pivot that MUMPS does not refuse makes the first Newton step infinite.
  outcome.singular = (count == 0 && outcome.reason == SNES_DIVERGED_LINEAR_SOLVE) ||
                     (count <= 1 && outcome.reason == SNES_DIVERGED_FNORM_NAN);
  return outcome;
}

LoadStep::Outcome LoadStep::solve(const std::vector<NodeLoad>& loads,
                                  const std::vector<StaticState::Support>& supports)
{
  loads_ = &loads;
  moves_ = loads != state_.reached_loads;
  for (const StaticState::Support& support : supports) {
    const Eigen::Vector3d displacement =
        state_.position[support.node] - state_.lattice.reference_position(support.node);
    moves_ =
        moves_ || support.value != (support.component < 3 ? displacement[support.component] : 0.);
  }
  system_.set_supports(supports);
  solution_ = system_.present();
  Outcome total{};
  double reuse = options_.reuse;
  for (bool again = true; again;) {
    const Outcome outcome = run_newton(reuse);
    total = {outcome.reason, total.iterations + outcome.iterations,
             total.factorisations + outcome.factorisations, outcome.singular};
    again = false;
    if (outcome.reason > 0) break;
    KSP ksp = nullptr;
    check(SNESGetKSP(snes_.get(), &ksp));
    const bool is_full = work_space_is_full(ksp) && work_space_ < 1000;
    make_solver();
    again = is_full || reuse > 0;
    if (is_full)
      work_space_ *= 4;
    else
      reuse = 0;
  }
  if (total.reason > 0) solution_ = system_.everywhere(x_);
  return total;
}
} // namespace interlock::fem
