// The tangent of a small lattice as a dense matrix, for tests that look at its eigenvalues.
#pragma once

#include "fem/statics/lattice_system.h"

#include <Eigen/Dense>

#include <vector>

// Freedoms that neither a junction ties nor a support prescribes.
inline std::vector<unsigned int> free_freedoms(const interlock::fem::LatticeSystem& system)
{
  std::vector<unsigned int> freedoms;
  for (unsigned int dof = 0; dof < system.n_freedoms(); ++dof)
    if (!system.constraints().is_constrained(dof)) freedoms.push_back(dof);
  return freedoms;
}

// Rows and columns of these freedoms of the tangent at x; one process only.
inline Eigen::MatrixXd dense_tangent(interlock::fem::LatticeSystem& system,
                                     const dealii::Vector<double>& x,
                                     const std::vector<unsigned int>& freedoms)
{
  system.tangent(x);
  Eigen::MatrixXd dense(freedoms.size(), freedoms.size());
  for (std::size_t i = 0; i < freedoms.size(); ++i)
    for (std::size_t j = 0; j < freedoms.size(); ++j)
      dense(i, j) = system.matrix().el(freedoms[i], freedoms[j]);
  return dense;
}
