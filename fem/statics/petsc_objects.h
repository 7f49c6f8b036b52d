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

// PETSc's own reports of errors, stacks on the standard error, are left out while this lives: what
// goes wrong is seen by the code that a call returns.
class QuietPetsc
{
public:
  QuietPetsc() { check(PetscPushErrorHandler(PetscIgnoreErrorHandler, nullptr)); }
  ~QuietPetsc() { PetscPopErrorHandler(); }
  QuietPetsc(const QuietPetsc&) = delete;
  QuietPetsc& operator=(const QuietPetsc&) = delete;
};

// Prefix of the options of statics on PETSc's command line or from PetscOptionsSetValue, for
// example -statics_ksp_type cg -statics_pc_type gamg.
inline constexpr const char* statics_prefix = "statics_";

// LU by MUMPS until options say otherwise; iterative solvers get a tolerance of 1e-10 of the
// residual, unless options say otherwise too.
void use_direct_solver(KSP ksp);

// Room for fill-in [%] that MUMPS adds to what its analysis expects (ICNTL 14); the operators must
// be set. Nothing happens with other solvers.
void set_work_space(KSP ksp, int percent);
// Whether the last factorisation ended because that room was full (INFOG(1) of -8, -9 or -14).
bool work_space_is_full(KSP ksp);
} // namespace interlock::fem
