#include "fem/lattice/lumped_inertia.h"

#include <Eigen/Eigenvalues>

namespace interlock::fem
{
std::vector<NodeInertia> lump_inertia(const Lattice& lattice, bool spherical)
{
  std::vector<NodeInertia> nodes(lattice.n_nodes());
  for (int e = 0; e < lattice.n_elements(); ++e) {
    const BeamSection& section = lattice.section(e);
    const double half = 0.5 * lattice.element(e).length;
    const Eigen::Matrix3d frame = lattice.element(e).frame.toRotationMatrix();
    const Eigen::Vector3d rotary(section.rotary_1, section.rotary_2, section.rotary_3);
    for (const int node : lattice.element(e).node) {
      nodes[node].mass += half * section.line_density;
      nodes[node].tensor += half * frame * rotary.asDiagonal() * frame.transpose();
      ++nodes[node].valence;
    }
  }
  if (!spherical) return nodes;
  for (NodeInertia& node : nodes) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(node.tensor,
                                                                   Eigen::EigenvaluesOnly);
    node.tensor = principal.eigenvalues()[2] * Eigen::Matrix3d::Identity();
  }
  return nodes;
}
} // namespace interlock::fem
