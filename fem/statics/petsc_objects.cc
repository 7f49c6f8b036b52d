#include "fem/statics/petsc_objects.h"

namespace interlock::fem
{
void use_direct_solver(KSP ksp)
{
  PC pc = nullptr;
  check(KSPSetType(ksp, KSPPREONLY));
  check(KSPSetTolerances(ksp, 1e-10, PETSC_DEFAULT, PETSC_DEFAULT, PETSC_DEFAULT));
  check(KSPGetPC(ksp, &pc));
  check(PCSetType(pc, PCLU));
  check(PCFactorSetMatSolverType(pc, MATSOLVERMUMPS));
}

namespace
{
// MUMPS' factor; none where another solver is at work.
Mat mumps_factor(KSP ksp)
{
  PC pc = nullptr;
  Mat factor = nullptr;
  MatSolverType type = nullptr;
  PetscBool is_lu = PETSC_FALSE, is_mumps = PETSC_FALSE;
  check(KSPGetPC(ksp, &pc));
  check(PetscObjectTypeCompare(reinterpret_cast<PetscObject>(pc), PCLU, &is_lu));
  if (is_lu == PETSC_FALSE) return nullptr;
  check(PCFactorGetMatSolverType(pc, &type));
  check(PetscStrcmp(type, MATSOLVERMUMPS, &is_mumps));
  if (is_mumps == PETSC_FALSE) return nullptr;
  check(PCFactorSetUpMatSolverType(pc));
  check(PCFactorGetMatrix(pc, &factor));
  return factor;
}
} // namespace

void set_work_space(KSP ksp, int percent)
{
  if (Mat factor = mumps_factor(ksp)) check(MatMumpsSetIcntl(factor, 14, percent));
}

bool work_space_is_full(KSP ksp)
{
  Mat factor = mumps_factor(ksp);
  PetscInt state = 0;
  if (factor != nullptr) check(MatMumpsGetInfog(factor, 1, &state));
  return state == -8 || state == -9 || state == -14;
}
} // namespace interlock::fem
