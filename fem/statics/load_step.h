// One load step of the static solver: the nonlinear system that PETSc solves.
#pragma once

#include "fem/statics/lattice_system.h"
#include "fem/statics/static_options.h"

#include <vector>

namespace interlock::fem
{
// Solves load steps one after the other from the state's present position; the matrix and its
// symbolic factorisation last from one to the next, until a step fails: after a failed numerical
// factorisation PETSc would leave out the next one, so the solver is made anew. Constrained
// freedoms have residual zero and take their values from the constraints inside each evaluation.
class LoadStep
{
public:
  // Both must outlive this object; the system must be one of this state.
  LoadStep(LatticeSystem& system, const StaticState& state, const StaticOptions& options);

  struct Outcome {
    SNESConvergedReason reason; // positive when converged
    int iterations, factorisations;
    bool singular; // the first tangent could not be factorised, or its answer was infinite
  };
  // Newton's method to rest under these loads and supports, which are as LatticeSystem wants them.
  //
  // Full steps, unless PETSc's options say otherwise: a slender beam that turns by a Newton step
  // stretches by half the square of the turn, so its residual grows by EA/EI before it falls, and a
  // line search that insists on a falling residual creeps.
  Outcome solve(const std::vector<NodeLoad>& loads,
                const std::vector<StaticState::Support>& supports);

  const dealii::Vector<double>& solution() const { return solution_; } // of the last converged step

private:
  void make_solver();
  Outcome run_newton(double reuse);
  bool is_out_of_bounds(Vec x, double residual);
  static PetscErrorCode residual(SNES, Vec x, Vec f, void* self);
  static PetscErrorCode jacobian(SNES, Vec x, Mat, Mat, void* self);
  static PetscErrorCode converged(SNES, PetscInt iteration, PetscReal, PetscReal step,
                                  PetscReal residual, SNESConvergedReason* reason, void* self);

  LatticeSystem& system_;
  const StaticState& state_;
  const StaticOptions& options_;
  double rounding_level_ =
      0;                 // norm of the residual that the last digit of the coordinates causes [N]
  double stiffness_ = 0; // norm of the axial stiffnesses: the residual of strains of 1 [N]
  int work_space_ = 20;  // of MUMPS, see set_work_space [%]
  SnesOwner snes_;
  dealii::PETScWrappers::MPI::Vector x_, f_, sum_;
  const std::vector<NodeLoad>* loads_ = nullptr; // of the step being solved
  bool moves_ = false;        // the step asks for a motion, so iteration 0 is no answer
  double first_residual_ = 0; // of the step [N]
  bool is_fresh_ = false;     // the tangent is that of the last iteration
  double reuse_ = 0, last_step_ = 0, contraction_ = 1; // of the Newton steps
  dealii::Vector<double> solution_;
};

// Norm of the residual [N] that rounding of the coordinates leaves however good the solution is.
double rounding_level(const Lattice& lattice);
} // namespace interlock::fem
