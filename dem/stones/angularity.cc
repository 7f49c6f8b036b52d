#include "dem/stones/angularity.h"

#include "dem/meshes/mass_properties.h"

#include <algorithm>
#include <cmath>

namespace interlock::dem
{
namespace
{
using Vector2 = Eigen::Vector2d;
using Outline = std::vector<Vector2>; // closed, counter-clockwise

double cross(const Vector2& a, const Vector2& b)
{
  return a[0] * b[1] - a[1] * b[0];
}

// The farthest point of the shadow on each of 720 rays from the origin.
Outline outline_of(const TriangleMesh& mesh, const std::vector<Vector2>& shadow)
{
  constexpr int rays = 720;
  const auto ray = [](int k) {
    const double angle = 2 * M_PI * k / rays;
    return Vector2(std::cos(angle), std::sin(angle));
  };
  std::vector<double> farthest(rays, 0);
  for (const auto& triangle : mesh.triangles)
    for (int side = 0; side < 3; ++side) {
      Vector2 a = shadow[triangle[side]], b = shadow[triangle[(side + 1) % 3]];
      // Every edge is run through in both directions. Those that point at the origin lie between
      // others and would divide nothing by nothing.
      if (cross(a, b) <= 1e-9 * a.norm() * b.norm()) continue;
      const double first = std::atan2(a[1], a[0]) * rays / (2 * M_PI);
      const double span = std::atan2(cross(a, b), a.dot(b)) * rays / (2 * M_PI);
      for (int k = int(std::ceil(first)); k <= first + span; ++k) {
        const Vector2 direction = ray(k);
        // Rounding may put a ray beside the edge, even parallel to it: hence the bound.
        const double distance =
            std::min(cross(a, b) / cross(direction, b - a), std::max(a.norm(), b.norm()));
        double& known = farthest[(k + rays) % rays];
        known = std::max(known, distance);
      }
    }
  Outline outline;
  for (int k = 0; k < rays; ++k) outline.push_back(farthest[k] * ray(k));
  return outline;
}

// `count` points at equal distances along the outline, the first at `start` of such a distance.
Outline equal_steps(const Outline& outline, int count, double start)
{
  std::vector<double> length{0};
  for (std::size_t k = 0; k < outline.size(); ++k)
    length.push_back(length.back() + (outline[(k + 1) % outline.size()] - outline[k]).norm());
  Outline polygon;
  for (int i = 0; i < count; ++i) {
    const double s = (i + start) / count * length.back();
    const auto k = std::upper_bound(length.begin(), length.end() - 1, s) - length.begin() - 1;
    const double share = (s - length[k]) / std::max(length[k + 1] - length[k], 1e-300);
    polygon.push_back((1 - share) * outline[k] + share * outline[(k + 1) % outline.size()]);
  }
  return polygon;
}

// A of the header for one polygon.
double angle_changes(const Outline& polygon)
{
  const int count = int(polygon.size());
  std::vector<double> turn; // 180 degrees less the angle at the vertex
  for (int i = 0; i < count; ++i) {
    const Vector2 in = polygon[i] - polygon[(i + count - 1) % count];
    const Vector2 out = polygon[(i + 1) % count] - polygon[i];
    turn.push_back(std::atan2(cross(in, out), in.dot(out)) * 180 / M_PI);
  }
  double sum = 0;
  for (int i = 0; i < count; ++i) {
    const double change = std::abs(turn[i] - turn[(i + count - 1) % count]);
    sum += 10 * std::floor(change / 10 + 1e-9); // a right angle is not to become 80 by rounding
  }
  return sum;
}
} // namespace

double angularity_index(const TriangleMesh& mesh)
{
  constexpr int sides = 24, starts = 12;
  const MassProperties mass = mass_properties(mesh);
  const Matrix3 axes = principal_frame(mass).axes;
  double sum = 0, total_area = 0;
  for (int view = 0; view < 3; ++view) {
    std::vector<Vector2> shadow;
    for (const Vector3& x : mesh.vertices) {
      const Vector3 local = axes.transpose() * (x - mass.centre);
      shadow.push_back({local[(view + 1) % 3], local[(view + 2) % 3]});
    }
    const Outline outline = outline_of(mesh, shadow);
    double area = 0, changes = 0;
    for (std::size_t k = 0; k < outline.size(); ++k)
      area += cross(outline[k], outline[(k + 1) % outline.size()]) / 2;
    for (int k = 0; k < starts; ++k)
      changes += angle_changes(equal_steps(outline, sides, double(k) / starts)) / starts;
    sum += area * changes;
    total_area += area;
  }
  return total_area > 0 ? sum / total_area : 0;
}
} // namespace interlock::dem
