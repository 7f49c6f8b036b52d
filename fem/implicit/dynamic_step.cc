#include "fem/implicit/dynamic_step.h"

#include "fem/statics/petsc_objects.h"

namespace interlock::fem
{
std::vector<Eigen::Matrix<double, 6, 1>> increments(const StaticState& state,
                                                    const dealii::Vector<double>& x)
{
  const Lattice& lattice = state.lattice;
  std::vector<Eigen::Matrix<double, 6, 1>> increments(lattice.n_nodes());
  for (int i = 0; i < lattice.n_nodes(); ++i) {
    for (int c = 0; c < 6; ++c) increments[i][c] = x[lattice.dof(i, c)];
    increments[i].head<3>() -= state.position[i] - lattice.reference_position(i);
  }
  return increments;
}

DynamicStep::DynamicStep(const LatticeMotion& start, const std::vector<NodeInertia>& nodes,
                         LatticeSystem& system, int max_iterations, double step_tolerance)
    : start_(start), nodes_(nodes), system_(system), step_tolerance_(step_tolerance),
      x_(system.new_vector()), f_(system.new_vector()), sum_(system.new_vector())
{
  const Lattice& lattice = start.state.lattice;
  for (int i = 0; i < lattice.n_nodes(); ++i)
    if (system.owned().is_element(lattice.dof(i, 0))) own_nodes_.push_back(i);

  SNES snes = nullptr;
  KSP ksp = nullptr;
  SNESLineSearch search = nullptr;
  check(SNESCreate(system.communicator(), &snes));
  snes_.reset(snes);
  check(SNESSetFunction(snes, f_, residual, this));
  check(SNESSetJacobian(snes, system.matrix(), system.matrix(), jacobian, this));
  check(SNESSetTolerances(snes, 0, 0, 0, max_iterations, 100000));
  check(SNESSetConvergenceTest(snes, converged, this, nullptr));
  check(SNESGetKSP(snes, &ksp));
  use_direct_solver(ksp);
  check(SNESGetLineSearch(snes, &search));
  check(SNESLineSearchSetType(search, SNESLINESEARCHBASIC));
  check(SNESSetOptionsPrefix(snes, "dynamics_"));
  check(SNESSetFromOptions(snes));
}

NodeStep DynamicStep::node_step(int node, const Eigen::Matrix<double, 6, 1>& increment) const
{
  const Eigen::Quaterniond& orientation = start_.state.orientation[node];
  const Eigen::Vector3d move = increment.head<3>(), turn = increment.tail<3>();
  return {orientation, turn, advanced(rule_, start_.translation[node], move),
          advanced(rule_, start_.rotation[node], orientation.conjugate() * turn)};
}

PetscErrorCode DynamicStep::residual(SNES, Vec x, Vec f, void* self)
{
  DynamicStep& step = *static_cast<DynamicStep*>(self);
  const dealii::Vector<double> all = step.system_.everywhere(x);
  const auto increment = increments(step.start_.state, all);
  step.sum_ = 0;
  step.system_.internal_forces(all, step.sum_);
  step.system_.add_loads(*step.end_loads_, -1, step.sum_);
  for (const int i : step.own_nodes_) {
    const Eigen::Matrix<double, 6, 1> force =
        inertia_force(step.nodes_[i], step.node_step(i, increment[i]));
    for (int c = 0; c < 6; ++c) {
      const unsigned int dof = step.start_.state.lattice.dof(i, c);
      if (!step.system_.constraints().is_constrained(dof)) step.sum_(dof) += force[c];
    }
  }
  step.sum_.compress(dealii::VectorOperation::add);
  return VecCopy(step.sum_, f);
}

PetscErrorCode DynamicStep::jacobian(SNES, Vec x, Mat, Mat, void* self)
{
  DynamicStep& step = *static_cast<DynamicStep*>(self);
  const dealii::Vector<double> all = step.system_.everywhere(x);
  const auto increment = increments(step.start_.state, all);
  step.system_.tangent(all);
  const auto& constraints = step.system_.constraints();
  for (const int i : step.own_nodes_) {
    const Eigen::Matrix<double, 6, 6> tangent =
        inertia_tangent(step.nodes_[i], step.node_step(i, increment[i]), step.rule_);
    const Lattice& lattice = step.start_.state.lattice;
    for (int a = 0; a < 6; ++a)
      for (int b = 0; b < 6; ++b) {
        const unsigned int row = lattice.dof(i, a), column = lattice.dof(i, b);
        if (!constraints.is_constrained(row) && !constraints.is_constrained(column))
          step.system_.matrix().add(row, column, tangent(a, b));
      }
  }
  step.system_.matrix().compress(dealii::VectorOperation::add);
  return 0;
}

// By the length of the Newton step, which estimates the error of the solution itself.
PetscErrorCode DynamicStep::converged(SNES, PetscInt iteration, PetscReal, PetscReal step,
                                      PetscReal residual, SNESConvergedReason* reason, void* self)
{
  *reason = SNES_CONVERGED_ITERATING;
  if (!(residual < 1e300))
    *reason = SNES_DIVERGED_FNORM_NAN;
  else if (iteration > 0 && step <= static_cast<DynamicStep*>(self)->step_tolerance_)
    *reason = SNES_CONVERGED_SNORM_RELATIVE;
  return 0;
}

void DynamicStep::predict()
{
  const StaticState& state = start_.state;
  const auto put = [this](unsigned int first, const Eigen::Vector3d& value) {
    for (unsigned int c = 0; c < 3; ++c) x_(first + c) = value[c];
  };
  for (const int i : own_nodes_) {
    put(state.lattice.dof(i, 0), state.position[i] - state.lattice.reference_position(i) +
                                     predicted_increment(rule_, start_.translation[i]));
    put(state.lattice.dof(i, 3),
        state.orientation[i] * predicted_increment(rule_, start_.rotation[i]));
  }
  x_.compress(dealii::VectorOperation::insert);
}

DynamicStep::Outcome DynamicStep::solve(const GeneralisedAlpha& rule,
                                        const std::vector<NodeLoad>& end_loads)
{
  rule_ = rule;
  end_loads_ = &end_loads;
  predict();
  check(SNESSolve(snes_.get(), nullptr, x_));
  Outcome outcome{};
  PetscInt count = 0;
  check(SNESGetConvergedReason(snes_.get(), &outcome.reason));
  check(SNESGetIterationNumber(snes_.get(), &count));
  outcome.iterations = static_cast<int>(count);
  outcome.solution = system_.everywhere(x_);
  return outcome;
}
} // namespace interlock::fem
