// Lowest eigenvalues of a symmetric pair of matrices, by SLEPc.
#pragma once

#include "fem/statics/petsc_objects.h"

#include <slepceps.h>

#include <vector>

namespace interlock::fem
{
using EpsOwner = std::unique_ptr<EPS, PetscDeleter<EPS, EPSDestroy>>;

// K u = lambda M u with M positive definite, both with the same sparsity and the same rows on each
// process. Krylov-Schur with shift and invert, factorised by MUMPS.
class LowestEigenvalues
{
public:
  // Looks for the `count` eigenvalues nearest to `shift`, which must be below all that matter and
  // no eigenvalue itself. Throws std::runtime_error when fewer converge, or when one below the
  // highest is missed, as may happen to a multiple one: by Sylvester's law of inertia the negative
  // pivots of K - lambda M count the eigenvalues below lambda. The matrices must outlive this.
  LowestEigenvalues(Mat stiffness, Mat mass, int count, double shift);

  const std::vector<double>& values() const { return values_; } // rising
  // Eigenvector of values()[i] with u . M u = 1.
  void vector(int i, Vec u) const { check(EPSGetEigenvector(eps_.get(), order_[i], u, nullptr)); }

private:
  EpsOwner eps_;
  std::vector<int> order_; // of SLEPc's numbers
  std::vector<double> values_;
};
} // namespace interlock::fem
