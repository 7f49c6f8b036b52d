// PETSc's handles with owners, and the linear solver of all statics.
#pragma once

#include <deal.II/lac/exceptions.h>

#include <petscsnes.h>

#include <memory>

namespace interlock::fem
{
inline void check(PetscErrorCode code)
{
  AssertThrow(code == 0, dealii::LACExceptions::ExcPETScError(code));
}

template <class Handle, PetscErrorCode (*destroy)(Handle*)> struct PetscDeleter {
  using pointer = Handle;
  void operator()(Handle handle) const { destroy(&handle); }
};
using SnesOwner = std::unique_ptr<SNES, PetscDeleter<SNES, SNESDestroy>>;
using MatOwner = std::unique_ptr<Mat, PetscDeleter<Mat, MatDestroy>>;
using KspOwner = std::unique_ptr<KSP, PetscDeleter<KSP, KSPDestroy>>;
using VecOwner = std::unique_ptr<Vec, PetscDeleter<Vec, VecDestroy>>;
using ScatterOwner = std::unique_ptr<VecScatter, PetscDeleter<VecScatter, VecScatterDestroy>>;

// Prefix of the options of statics on PETSc's command line or from PetscOptionsSetValue, for
// example -statics_ksp_type cg -statics_pc_type gamg.
inline constexpr const char* statics_prefix = "statics_";

// LU by MUMPS until options say otherwise; iterative solvers get a tolerance of 1e-10 of the
// residual, unless options say otherwise too.
void use_direct_solver(KSP ksp);
} // namespace interlock::fem
