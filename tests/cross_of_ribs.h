// Two ribs that cross at the origin, clamped at their four ends, and balls, for tests of the
// coupled loop.
#pragma once

#include "coupling/loop/rib_transfer.h"
#include "dem/bodies/clump_shape.h"

#include <cmath>
#include <optional>

namespace cross_of_ribs
{
using namespace interlock;
using dem::Vector3;

constexpr double half_length = 0.065, edge_rounding = 5e-4; // [m]

inline fem::RibSection rib_section()
{
  fem::RibSection section;
  section.width = 5e-3;
  section.thickness = 2.5e-3;
  section.youngs_modulus = 2.4e9;
  section.poisson_ratio = 0.3;
  section.density = 910;
  return section;
}

// Weightless ribs along x and y, of `elements` beams each; the ends are held. With a box they touch
// its walls.
inline coupling::RibTransfer cross(int elements, double mass_damping = 0,
                                   const std::optional<coupling::RibBox>& box = {})
{
  std::vector<fem::RibLine> lines;
  for (const Vector3& direction : {Vector3(half_length, 0, 0), Vector3(0, half_length, 0)}) {
    lines.push_back(
        fem::straight_line(-direction, direction, elements, fem::beam_section(rib_section())));
    lines.back().shape = rib_section();
  }
  fem::Lattice lattice(lines);
  std::vector<int> ends;
  for (int node = 0; node < lattice.n_nodes(); ++node)
    if (lattice.reference_position(node).norm() > half_length - 1e-9) ends.push_back(node);
  fem::DynamicsOptions options;
  options.mass_damping = mass_damping;
  return coupling::RibTransfer(std::move(lattice), options, ends, false, edge_rounding, box);
}

inline dem::ContactProperties contact(double damping_ratio)
{
  dem::ContactProperties pair;
  pair.normal_stiffness = pair.tangential_stiffness = 5.65e7;
  pair.friction = 0.6;
  pair.damping_ratio = damping_ratio;
  return pair;
}

inline dem::ClumpShape ball(double radius)
{
  dem::ClumpShape shape;
  shape.spheres = {{Vector3::Zero(), radius}};
  shape.volume = 4 * M_PI / 3 * std::pow(radius, 3);
  shape.unit_inertia = Vector3::Constant(0.4 * shape.volume * radius * radius);
  return shape;
}
} // namespace cross_of_ribs
