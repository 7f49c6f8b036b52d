#include "coupling/loop/rib_wall_points.h"

#include <algorithm>
#include <cmath>

namespace interlock::coupling
{
namespace
{
using dem::Vector3;

constexpr int n_planes = 4;

// From a plane into the box.
Vector3 inward(BoxSide plane)
{
  switch (plane) {
  case BoxSide::floor:
    return Vector3::UnitZ();
  case BoxSide::right:
    return Vector3::UnitY();
  case BoxSide::left:
    return -Vector3::UnitY();
  default:
    return -Vector3::UnitX();
  }
}

// How far a rectangle with these half sizes along these axes reaches along n [m].
double support(const dem::Rib& rib, const Vector3& along, const Vector3& n)
{
  const Vector3& width = rib.width_axis[0];
  return rib.half_width * std::abs(width.dot(n)) +
         rib.half_thickness * std::abs(along.cross(width).dot(n));
}
} // namespace

RibWallPoints::RibWallPoints(const RibBox& box, const dem::RibSet& unloaded)
    : box_(box), vertices_(static_cast<std::size_t>(unloaded.position.size()))
{
  for (int r = 0; r < unloaded.size(); ++r) add_rib(unloaded[r], unloaded.shape(r).first_end, r);
  // Cut at the wall, or laid against it: no overlap at the start.
  for (int v = 0; v < n_vertices(); ++v)
    for (int plane = 0; plane < n_planes; ++plane) {
      double& reach = vertices_[v].reach[plane];
      reach = std::min(reach, distance(unloaded.position[v], static_cast<BoxSide>(plane)));
    }
}

void RibWallPoints::add_rib(const dem::Rib& rib, int first_end, int number)
{
  const Vector3 along = (rib.x[1] - rib.x[0]).normalized();
  vertices_[first_end].rib = number;
  vertices_[first_end].half_thickness = rib.half_thickness;
  for (const int v : {first_end, first_end + 1}) {
    Vertex& vertex = vertices_[v];
    vertex.along = std::abs(along.x()) >= std::abs(along.y());
    for (int plane = 0; plane < n_planes; ++plane)
      vertex.reach[plane] =
          std::max(vertex.reach[plane], support(rib, along, inward(static_cast<BoxSide>(plane))));
    vertex.reach_x = std::max(vertex.reach_x, support(rib, along, Vector3::UnitX()));
    vertex.reach_z = std::max(vertex.reach_z, support(rib, along, Vector3::UnitZ()));
  }
}

double RibWallPoints::distance(const Vector3& x, BoxSide plane) const
{
  switch (plane) {
  case BoxSide::floor:
    return x.z();
  case BoxSide::right:
    return x.y();
  case BoxSide::left:
    return box_.width - x.y();
  default:
    return box_.length - x.x();
  }
}

bool RibWallPoints::can_touch(int v, BoxSide side) const
{
  const Vertex& vertex = vertices_[v];
  if (is_edge(side)) return vertex.rib >= 0 && vertex.along;
  if (vertex.reach_z == 0) return false; // no rib is here
  return side < BoxSide::front_below || !vertex.along;
}

WallGap RibWallPoints::gap(const dem::RibSet& ribs, int v, BoxSide side) const
{
  const Vertex& vertex = vertices_[v];
  const Vector3 x = ribs.position[v];
  switch (side) {
  case BoxSide::front_below:
    return gap_at_front(vertex, x, true);
  case BoxSide::front_above:
    return gap_at_front(vertex, x, false);
  case BoxSide::edge_below:
    return gap_at_edge(vertex, x, ribs.position[v + 1], box_.slot_bottom);
  case BoxSide::edge_above:
    return gap_at_edge(vertex, x, ribs.position[v + 1], box_.slot_top);
  default:
    break;
  }
  const double reach = vertex.reach[static_cast<int>(side)];
  return {reach - distance(x, side), inward(side), 0};
}

// The section is a bar with round edges: a core, flat or upright, grown by half its smaller size.
WallGap RibWallPoints::gap_at_front(const Vertex& vertex, const Vector3& x, bool below) const
{
  const double round = std::min(vertex.reach_x, vertex.reach_z);
  const double core_x = vertex.reach_x - round, core_z = vertex.reach_z - round;
  // From the half-line to the core.
  const double along = x.x() - std::clamp(x.x(), -core_x, core_x);
  const double up = below ? std::max(0., x.z() - core_z - box_.slot_bottom)
                          : std::min(0., x.z() + core_z - box_.slot_top);
  const double d = std::sqrt(along * along + up * up);
  const Vector3 n = d > 0 ? Vector3(along / d, 0, up / d) : Vector3(0, 0, below ? 1 : -1);
  return {round - d, n, 0};
}

WallGap RibWallPoints::gap_at_edge(const Vertex& vertex, const Vector3& a, const Vector3& b,
                                   double height) const
{
  const double chord_x = b.x() - a.x(), chord_z = b.z() - a.z();
  const double square = chord_x * chord_x + chord_z * chord_z;
  const double way = -a.x() * chord_x + (height - a.z()) * chord_z;
  const double xi = square > 0 ? std::clamp(way / square, 0., 1.) : 0;
  const double x = a.x() + xi * chord_x, z = a.z() + xi * chord_z - height;
  const double d = std::sqrt(x * x + z * z);
  const Vector3 n = d > 0 ? Vector3(x / d, 0, z / d) : Vector3::UnitZ();
  return {vertex.half_thickness - d, n, xi};
}
} // namespace interlock::coupling
