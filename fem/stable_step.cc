#include "fem/stable_step.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace interlock::fem
{
namespace
{
// Rotary inertia about e1, e2, e3 that the weaker end of an element can count on [kg m2].
Eigen::Vector3d end_inertia(const Lattice& lattice, int e, const std::vector<NodeInertia>& nodes,
                            bool spherical)
{
  const BeamSection& section = lattice.section(e);
  const LatticeElement& element = lattice.element(e);
  if (!spherical)
    return 0.5 * element.length *
           Eigen::Vector3d(section.rotary_1, section.rotary_2, section.rotary_3);
  double share = nodes[element.node[0]].tensor(0, 0) / nodes[element.node[0]].valence;
  share = std::min(share, nodes[element.node[1]].tensor(0, 0) / nodes[element.node[1]].valence);
  return Eigen::Vector3d::Constant(share);
}
} // namespace

double stable_beam_step(const Lattice& lattice, const std::vector<NodeInertia>& nodes,
                        bool spherical, bool rbf)
{
  double square = 0; // largest omega^2
  for (int e = 0; e < lattice.n_elements(); ++e) {
    const BeamSection& s = lattice.section(e);
    const double h = lattice.element(e).length, m = 0.5 * s.line_density * h;
    const Eigen::Vector3d j = end_inertia(lattice, e, nodes, spherical);
    // Shear along e2 goes with turning about e3, and the other way round.
    const double shear_2 = rbf ? residual_shear(s.shear_2, s.bending_3, h) : s.shear_2;
    const double shear_3 = rbf ? residual_shear(s.shear_3, s.bending_2, h) : s.shear_3;
    square = std::max({square, 2 * s.axial / (h * m), 2 * s.torsion / (h * j[0]),
                       2 * s.bending_2 / (h * j[1]), 2 * s.bending_3 / (h * j[2]),
                       shear_2 * (2 / (h * m) + h / (2 * j[2])),
                       shear_3 * (2 / (h * m) + h / (2 * j[1]))});
  }
  return 2 / std::sqrt(square);
}
} // namespace interlock::fem
