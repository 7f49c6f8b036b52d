// The flexural overhang of laboratory.h.
#include "fem/laboratory/laboratory.h"
#include "fem/lattice/lumped_inertia.h"

#include <boost/math/tools/roots.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace interlock::fem
{
namespace
{
const double standard_angle = 41.5 * M_PI / 180;
constexpr int weight_steps = 10;

// Points from x = 0 to the tip at x = `length`, with a vertex wherever a transverse rib crosses.
std::vector<double> vertices_along(const GeogridProduct& product, double length)
{
  std::vector<double> breaks = {0};
  const int bars = static_cast<int>(length / product.pitch_along);
  for (int k = bars; k >= 0; --k) {
    const double x = length - k * product.pitch_along;
    if (x > 1e-3 * product.pitch_along) breaks.push_back(x);
  }
  std::vector<double> vertices = {0};
  for (std::size_t i = 1; i < breaks.size(); ++i) {
    const double part = breaks[i] - breaks[i - 1];
    const int n = std::max(1, static_cast<int>(std::ceil(
                                  part / product.pitch_along * product.elements_per_rib - 1e-9)));
    for (int k = 1; k <= n; ++k) vertices.push_back(breaks[i - 1] + part * k / n);
  }
  return vertices;
}

Lattice strip(const GeogridProduct& product, int ribs, double length)
{
  std::vector<RibLine> lines;
  const double half_width = 0.5 * (ribs - 1) * product.pitch_across;
  for (int r = 0; r < ribs; ++r) {
    RibLine line;
    for (const double x : vertices_along(product, length))
      line.points.emplace_back(x, r * product.pitch_across - half_width, 0);
    line.shape = product.ribs_along.shape;
    line.section = product.ribs_along.section;
    lines.push_back(line);
  }
  if (ribs > 1)
    for (double x = length; x > 1e-3 * product.pitch_along; x -= product.pitch_along) {
      lines.push_back(straight_line({x, -half_width, 0}, {x, half_width, 0},
                                    (ribs - 1) * product.elements_per_rib,
                                    product.ribs_across.section));
      lines.back().shape = product.ribs_across.shape;
    }
  if (product.junctions.reach > 0) lines = thicken_junctions(lines, product.junctions);
  return Lattice(std::move(lines), product.junction_stiffness);
}

// The strip of this length under its weight.
LaboratoryTest hang(const GeogridProduct& product, int ribs, double length, double gravity)
{
  const Lattice lattice = strip(product, ribs, length);
  StaticOptions options;
  options.load_steps = 1;
  LaboratoryTest test;
  test.solver = std::make_unique<StaticSolver>(lattice, options);
  test.solver->clamp(lattice.front_edge_nodes());
  const std::vector<NodeInertia> inertia = lump_inertia(lattice, false);
  const int tip = lattice.nearest_node({length, 0, 0});
  test.path.push_back({});
  for (int k = 1; k <= weight_steps; ++k) {
    for (int i = 0; i < lattice.n_nodes(); ++i)
      test.solver->add_load(i, {0, 0, -inertia[i].mass * gravity / weight_steps}, {0, 0, 0});
    test.solver->solve();
    test.path.push_back(
        {-test.solver->displacement(tip).z(), static_cast<double>(k) / weight_steps});
  }
  return test;
}

double fall_angle(const StaticSolver& solver, double length)
{
  const Eigen::Vector3d tip = solver.position(solver.lattice().nearest_node({length, 0, 0}));
  return std::atan2(-tip.z(), tip.x());
}
} // namespace

OverhangResult flexural_overhang(const GeogridProduct& product, int ribs, double gravity,
                                 const LaboratoryProgress& progress)
{
  if (product.pattern == Pattern::triaxial)
    throw std::invalid_argument("The flexural overhang is not offered for triaxial geogrids.");
  const double weight = product.mass_per_area() * gravity; // [N/m2]
  const double guess =
      2 * std::cbrt(product.ribs_along.section.bending_2 / product.pitch_across / weight);
  OverhangResult result;
  double tries = 0;
  const auto excess = [&](double length) {
    result.test = hang(product, ribs, length, gravity);
    result.length = length;
    if (progress) progress(std::min(0.99, ++tries / 12));
    return fall_angle(*result.test.solver, length) - standard_angle;
  };
  std::uintmax_t most = 60;
  const auto close = [](double a, double b) { return std::abs(a - b) < 1e-6 * b; };
  const auto bracket =
      boost::math::tools::bracket_and_solve_root(excess, guess, 1.3, true, close, most);
  excess(0.5 * (bracket.first + bracket.second));
  result.flexural_rigidity = weight * std::pow(0.5 * result.length, 3);
  return result;
}
} // namespace interlock::fem
