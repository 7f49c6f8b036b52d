#include "fem/implicit/eigenvalues.h"

#include "fem/statics/negative_pivots.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

namespace interlock::fem
{
namespace
{
EpsOwner shift_and_invert(Mat stiffness, Mat mass, int count, double shift)
{
  EPS eps = nullptr;
  check(EPSCreate(PetscObjectComm(reinterpret_cast<PetscObject>(stiffness)), &eps));
  EpsOwner owner(eps);
  check(EPSSetOperators(eps, stiffness, mass));
  check(EPSSetProblemType(eps, EPS_GHEP));
  check(EPSSetWhichEigenpairs(eps, EPS_TARGET_MAGNITUDE));
  check(EPSSetTarget(eps, shift));
  check(EPSSetDimensions(eps, count, PETSC_DEFAULT, PETSC_DEFAULT));
  check(EPSSetTolerances(eps, 1e-12, 500));
  ST st = nullptr;
  KSP ksp = nullptr;
  check(EPSGetST(eps, &st));
  check(STSetType(st, STSINVERT));
  check(STSetMatStructure(st, SAME_NONZERO_PATTERN));
  check(STGetKSP(st, &ksp));
  use_direct_solver(ksp);
  check(EPSSetFromOptions(eps));
  check(EPSSolve(eps));

  PetscInt found = 0;
  EPSConvergedReason reason = EPS_CONVERGED_ITERATING;
  check(EPSGetConverged(eps, &found));
  check(EPSGetConvergedReason(eps, &reason));
  if (found < count)
    throw std::runtime_error(
        "Only " + std::to_string(found) + " of the " + std::to_string(count) +
        " eigenvalues asked for have converged: " + EPSConvergedReasons[reason] + ".");
  return owner;
}

// Number of eigenvalues below `limit`.
int count_below(Mat stiffness, Mat mass, double limit)
{
  Mat shifted = nullptr;
  check(MatDuplicate(stiffness, MAT_COPY_VALUES, &shifted));
  const MatOwner shifted_owner(shifted);
  check(MatAXPY(shifted, -limit, mass, SAME_NONZERO_PATTERN));
  return negative_pivots(shifted);
}
} // namespace

LowestEigenvalues::LowestEigenvalues(Mat stiffness, Mat mass, int count, double shift)
    : eps_(shift_and_invert(stiffness, mass, count, shift)), order_(count)
{
  std::vector<double> unsorted(count);
  for (int i = 0; i < count; ++i) check(EPSGetEigenvalue(eps_.get(), i, &unsorted[i], nullptr));
  std::iota(order_.begin(), order_.end(), 0);
  std::sort(order_.begin(), order_.end(), [&](int a, int b) { return unsorted[a] < unsorted[b]; });
  for (const int i : order_) values_.push_back(unsorted[i]);

  // Just below the highest one, whose own multiplicity may exceed what was asked for.
  const double limit = values_.back() - 1e-6 * (std::abs(values_.back()) + std::abs(shift));
  const auto have = std::lower_bound(values_.begin(), values_.end(), limit) - values_.begin();
  const int exist = count_below(stiffness, mass, limit);
  if (have != exist)
    throw std::runtime_error("The eigenvalue solver found " + std::to_string(have) + " of the " +
                             std::to_string(exist) + " eigenvalues below " + std::to_string(limit) +
                             ".");
}
} // namespace interlock::fem
