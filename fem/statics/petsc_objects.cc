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
} // namespace interlock::fem
