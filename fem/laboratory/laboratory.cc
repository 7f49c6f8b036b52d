// Tension and aperture stability; the overhang has its own file.
#include "fem/laboratory/laboratory.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace interlock::fem
{
namespace
{
// Sizes of the specimens [m].
constexpr double tension_width = 0.2, tension_length = 0.1, stability_side = 0.229;

StaticOptions one_step()
{
  StaticOptions options;
  options.load_steps = 1;
  return options;
}

std::vector<int> nodes_where(const Lattice& lattice,
                             const std::function<bool(const Eigen::Vector3d&)>& is_there)
{
  std::vector<int> nodes;
  for (int i = 0; i < lattice.n_nodes(); ++i)
    if (is_there(lattice.reference_position(i))) nodes.push_back(i);
  return nodes;
}

void refuse_triaxial(const GeogridProduct& product, const std::string& test)
{
  if (product.pattern == Pattern::triaxial)
    throw std::invalid_argument(test + " is not offered for triaxial geogrids.");
}

// Pulls the nodes at x = `length` away from those at x = 0. `width` [m] is what the force is spread
// over.
LaboratoryTest pull(const Lattice& lattice, double length, double width, double largest_strain,
                    int steps, const LaboratoryProgress& progress)
{
  const double near = 1e-6 * length;
  const std::vector<int> held = nodes_where(lattice, [&](const auto& x) { return x.x() < near; });
  const std::vector<int> moved =
      nodes_where(lattice, [&](const auto& x) { return x.x() > length - near; });
  LaboratoryTest test;
  test.solver = std::make_unique<StaticSolver>(lattice, one_step());
  test.solver->clamp(held);
  test.solver->clamp(moved);
  test.path.push_back({});
  for (int k = 1; k <= steps; ++k) {
    const double strain = largest_strain * k / steps;
    for (const int node : moved) test.solver->prescribe(node, 0, strain * length);
    test.solver->solve();
    test.path.push_back({strain, total_reaction(*test.solver, moved)[0] / width});
    if (progress) progress(static_cast<double>(k) / steps);
  }
  return test;
}
} // namespace

NodeLoad total_reaction(const StaticSolver& solver, const std::vector<int>& nodes)
{
  NodeLoad sum = NodeLoad::Zero();
  for (const int node : nodes) {
    const NodeLoad reaction = solver.reaction(node);
    if (solver.lattice().joined_nodes(node).front() == node) sum.head<3>() += reaction.head<3>();
    sum.tail<3>() += reaction.tail<3>();
  }
  return sum;
}

double load_at(const std::vector<LaboratoryPoint>& path, double deformation)
{
  for (std::size_t i = 1; i < path.size(); ++i) {
    const LaboratoryPoint &a = path[i - 1], &b = path[i];
    if (deformation > b.deformation * (1 + 1e-12)) continue;
    return a.load +
           (b.load - a.load) * (deformation - a.deformation) / (b.deformation - a.deformation);
  }
  throw std::invalid_argument("The path of the test ends before a deformation of " +
                              std::to_string(deformation) + ".");
}

LaboratoryTest wide_width_tension(const GeogridProduct& product, double largest_strain, int steps,
                                  const LaboratoryProgress& progress)
{
  const int along =
      std::max(2, static_cast<int>(std::ceil(tension_length / product.pitch_along - 1e-9)));
  const double ribs = std::round(tension_width / product.pitch_across);
  const int across = std::max(1, static_cast<int>(ribs) - (product.pattern != Pattern::triaxial));
  return pull(piece(product, along, across), length_of_piece(product, along),
              width_of_piece(product, across), largest_strain, steps, progress);
}

LaboratoryTest single_rib_tension(const GeogridProduct& product, double largest_strain, int steps,
                                  const LaboratoryProgress& progress)
{
  refuse_triaxial(product, "Single-rib tension");
  const double length = product.pitch_along;
  const Lattice rib({straight_line({0, 0, 0}, {length, 0, 0}, product.elements_per_rib,
                                   product.ribs_along.section)});
  return pull(rib, length, product.pitch_across, largest_strain, steps, progress);
}

LaboratoryTest aperture_stability(const GeogridProduct& product, double largest_torque, int steps,
                                  const LaboratoryProgress& progress)
{
  const auto even_number = [](double pitch) {
    return 2 * std::max(1, static_cast<int>(std::round(0.5 * stability_side / pitch)));
  };
  const int along = even_number(product.pitch_along), across = even_number(product.pitch_across);
  const Lattice lattice = piece(product, along, across);
  const double length = length_of_piece(product, along), near = 1e-6 * length;
  // Every second row of triangles ends half a side before the edge.
  const double half_width = 0.5 * across * product.pitch_across -
                            (product.pattern == Pattern::triaxial ? 0.5 * product.pitch_across : 0);
  LaboratoryTest test;
  test.solver = std::make_unique<StaticSolver>(lattice, one_step());
  test.solver->clamp(nodes_where(lattice, [&](const Eigen::Vector3d& x) {
    return x.x() < near || x.x() > length - near || std::abs(x.y()) > half_width - near;
  }));
  const int middle = lattice.nearest_node({0.5 * length, 0, 0});
  const std::vector<int> together = lattice.joined_nodes(middle);
  test.path.push_back({});
  for (int k = 1; k <= steps; ++k) {
    // All ribs that meet in the middle are turned together.
    for (const int node : together)
      test.solver->add_load(node, {0, 0, 0}, {0, 0, largest_torque / steps / together.size()});
    test.solver->solve();
    const Eigen::Quaterniond& q = test.solver->orientation(middle);
    test.path.push_back({2 * std::atan2(q.z(), q.w()), largest_torque * k / steps});
    if (progress) progress(static_cast<double>(k) / steps);
  }
  return test;
}
} // namespace interlock::fem
