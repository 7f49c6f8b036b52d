#include "fem/lattice/quadratic_lattice.h"

#include <stdexcept>
#include <string>

namespace interlock::fem
{
std::vector<QuadraticPair> quadratic_pairs(const Lattice& lattice)
{
  for (int l = 0; l < lattice.n_lines(); ++l) {
    const std::size_t elements = lattice.line(l).points.size() - 1;
    if (elements % 2 != 0)
      throw std::invalid_argument("Rib line " + std::to_string(l) + " has " +
                                  std::to_string(elements) +
                                  " segments but needs an even number for quadratic elements.");
  }
  std::vector<QuadraticPair> pairs;
  for (int e = 0; e < lattice.n_elements(); e += 2) {
    QuadraticPair pair;
    pair.node = {lattice.element(e).node[0], lattice.element(e).node[1],
                 lattice.element(e + 1).node[1]};
    NodePositions position;
    for (int i = 0; i < 3; ++i) position[i] = lattice.reference_position(pair.node[i]);
    const Eigen::Vector3d& normal = lattice.line(lattice.element(e).line).normal;
    pair.beam = quadratic_beam(position, curve_frames(position, normal), lattice.section(e));
    pairs.push_back(pair);
  }
  return pairs;
}
} // namespace interlock::fem
