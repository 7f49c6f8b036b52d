#include "fem/statics/negative_pivots.h"

#include "fem/statics/lattice_system.h"
#include "fem/statics/resting_supports.h"

namespace interlock::fem
{
int negative_pivots(Mat symmetric)
{
  check(MatSetOption(symmetric, MAT_SYMMETRIC, PETSC_TRUE));
  KSP ksp = nullptr;
  PC pc = nullptr;
  Mat factor = nullptr;
  check(KSPCreate(PetscObjectComm(reinterpret_cast<PetscObject>(symmetric)), &ksp));
  const KspOwner ksp_owner(ksp);
  use_direct_solver(ksp);
  check(KSPSetOperators(ksp, symmetric, symmetric));
  check(KSPGetPC(ksp, &pc));
  check(PCSetType(pc, PCCHOLESKY)); // L D L^T, any signs
  check(PCFactorSetMatSolverType(pc, MATSOLVERMUMPS));
  check(PCFactorSetUpMatSolverType(pc));
  check(PCFactorGetMatrix(pc, &factor));
  check(MatMumpsSetIcntl(factor, 13, 1)); // pivots of the root counted too, on several processes
  PCFailedReason failed = PC_NOERROR;
  PetscInt negative = 0;
  const QuietPetsc quiet;
  if (KSPSetUp(ksp) != 0) return -1;
  check(PCGetFailedReason(pc, &failed));
  if (failed != PC_NOERROR || MatGetInertia(factor, &negative, nullptr, nullptr) != 0) return -1;
  return static_cast<int>(negative);
}

// Rows of constrained freedoms are those of the identity, with positive pivots.
int unstable_directions(LatticeSystem& system, const StaticState& state)
{
  system.set_supports(resting_supports(state));
  system.tangent(system.present());
  Mat transposed = nullptr;
  check(MatTranspose(system.matrix(), MAT_INITIAL_MATRIX, &transposed));
  const MatOwner symmetric(transposed);
  check(MatAXPY(transposed, 1, system.matrix(), SAME_NONZERO_PATTERN));
  return negative_pivots(transposed);
}
} // namespace interlock::fem
