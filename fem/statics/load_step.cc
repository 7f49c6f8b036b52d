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
    : system_(system), options_(options), rounding_level_(rounding_level(state.lattice)),
      x_(system.new_vector()), f_(system.new_vector()), sum_(system.new_vector())
{
  SNES snes = nullptr;
  KSP ksp = nullptr;
  check(SNESCreate(system.communicator(), &snes));
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

// Not by the residual: its size at the start says little (a prescribed rotation strains one element
// by it), while the Newton step estimates the error of the solution itself.
PetscErrorCode LoadStep::converged(SNES, PetscInt iteration, PetscReal, PetscReal step,
                                   PetscReal residual, SNESConvergedReason* reason, void* self)
{
  LoadStep& load_step = *static_cast<LoadStep*>(self);
  const double tolerance = load_step.options_.step_tolerance;
  load_step.contraction_ = iteration > 1 ? step / load_step.last_step_ : 1;
  load_step.last_step_ = step;
  // Short steps with a fresh tangent that no longer shrink: their size is rounding.
  const bool stands_still = iteration > 1 && load_step.is_fresh_ && step <= 1e4 * tolerance &&
                            load_step.contraction_ > 0.5;
  *reason = SNES_CONVERGED_ITERATING;
  if (!(residual < 1e300))
    *reason = SNES_DIVERGED_FNORM_NAN;
  else if (residual <= load_step.rounding_level_)
    *reason = SNES_CONVERGED_FNORM_ABS;
  else if (iteration > 0 && (step <= tolerance || stands_still))
    *reason = SNES_CONVERGED_SNORM_RELATIVE;
  return 0;
}

LoadStep::Outcome LoadStep::run_newton(double reuse)
{
  check(SNESSetFromOptions(snes_.get()));
  reuse_ = reuse;
  for (const auto dof : system_.owned()) x_(dof) = solution_[dof];
  x_.compress(dealii::VectorOperation::insert);
  const int tangents_before = system_.n_tangents();
  check(SNESSolve(snes_.get(), nullptr, x_));

  Outcome outcome{};
  outcome.factorisations = system_.n_tangents() - tangents_before;
  PetscInt count = 0;
  check(SNESGetConvergedReason(snes_.get(), &outcome.reason));
  check(SNESGetIterationNumber(snes_.get(), &count));
  outcome.iterations = static_cast<int>(count);
  return outcome;
}

// A zero pivot that MUMPS does not refuse makes the first Newton step infinite.
bool LoadStep::Outcome::singular() const
{
  return (iterations == 0 && reason == SNES_DIVERGED_LINEAR_SOLVE) ||
         (iterations <= 1 && reason == SNES_DIVERGED_FNORM_NAN);
}

LoadStep::Outcome LoadStep::solve(const std::vector<NodeLoad>& loads,
                                  const std::vector<StaticState::Support>& supports)
{
  loads_ = &loads;
  system_.set_supports(supports);
  check(SNESSetJacobian(snes_.get(), system_.matrix(), system_.matrix(), jacobian, this));
  solution_ = system_.present();
  Outcome outcome = run_newton(options_.reuse);
  if (outcome.reason <= 0 && options_.reuse > 0) {
    const Outcome first = outcome;
    outcome = run_newton(0);
    outcome.iterations += first.iterations;
    outcome.factorisations += first.factorisations;
  }
  if (outcome.reason > 0) solution_ = system_.everywhere(x_);
  return outcome;
}
} // namespace interlock::fem
