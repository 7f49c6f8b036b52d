// One step of implicit dynamics: the nonlinear system that PETSc solves.
#pragma once

#include "fem/implicit/generalised_alpha.h"
#include "fem/implicit/inertia_force.h"
#include "fem/lattice/lumped_inertia.h"
#include "fem/statics/lattice_system.h"
#include "fem/statics/static_state.h"

#include <deal.II/lac/petsc_vector.h>

#include <vector>

namespace interlock::fem
{
// Places of all nodes, and the rates that generalised alpha carries.
struct LatticeMotion {
  StaticState state;
  std::vector<Rates> translation; // world
  std::vector<Rates> rotation;    // frame of each node
};

// Displacement [m] and rotation vector [rad] of each node in a step from `state` to the freedoms x
// of LatticeSystem, world frame.
std::vector<Eigen::Matrix<double, 6, 1>> increments(const StaticState& state,
                                                    const dealii::Vector<double>& x);

// Unknowns as in LatticeSystem. Constrained freedoms have residual zero and take their values from
// the constraints of the system, whose set of freedoms must not change any more.
class DynamicStep
{
public:
  // All must outlive this object. `step_tolerance`: length of the Newton step [m, rad] that ends
  // it.
  DynamicStep(const LatticeMotion& start, const std::vector<NodeInertia>& nodes,
              LatticeSystem& system, int max_iterations, double step_tolerance);

  struct Outcome {
    SNESConvergedReason reason; // positive: converged
    int iterations;
    dealii::Vector<double> solution; // all freedoms, on every process
  };
  // Newton's method from unchanged accelerations, with the loads at the end of the step.
  Outcome solve(const GeneralisedAlpha& rule, const std::vector<NodeLoad>& end_loads);

private:
  static PetscErrorCode residual(SNES, Vec x, Vec f, void* self);
  static PetscErrorCode jacobian(SNES, Vec x, Mat, Mat, void* self);
  static PetscErrorCode converged(SNES, PetscInt iteration, PetscReal, PetscReal step,
                                  PetscReal residual, SNESConvergedReason* reason, void* self);
  void predict();
  NodeStep node_step(int node, const Eigen::Matrix<double, 6, 1>& increment) const;

  const LatticeMotion& start_;
  const std::vector<NodeInertia>& nodes_;
  LatticeSystem& system_;
  double step_tolerance_;
  std::vector<int> own_nodes_; // of this process
  SnesOwner snes_;
  dealii::PETScWrappers::MPI::Vector x_, f_, sum_;
  // Of the step that is being solved:
  GeneralisedAlpha rule_{1, 1};
  const std::vector<NodeLoad>* end_loads_ = nullptr;
};
} // namespace interlock::fem
