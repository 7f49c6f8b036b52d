#include "dem/stones/stone_size.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace interlock::dem
{
namespace
{
double extent_along(const std::vector<Vector3>& points, const Vector3& direction)
{
  double low = INFINITY, high = -INFINITY;
  for (const Vector3& point : points) {
    const double x = point.dot(direction);
    low = std::min(low, x);
    high = std::max(high, x);
  }
  return high - low;
}
} // namespace

double sieve_size(const std::vector<Vector3>& points, const Vector3& direction)
{
  const Vector3 u = direction.unitOrthogonal(), v = direction.cross(u);
  // A square turned by 90 degrees is the same square.
  const auto side = [&](double degrees) {
    const double angle = degrees * M_PI / 180;
    const Vector3 a = std::cos(angle) * u + std::sin(angle) * v;
    return std::max(extent_along(points, a), extent_along(points, direction.cross(a)));
  };
  double best_angle = 0, best = side(0);
  const auto search = [&](double first, double last, double step) {
    for (double angle = first; angle <= last; angle += step)
      if (const double s = side(angle); s < best) best = s, best_angle = angle;
  };
  search(3, 87, 3);
  const double coarse = best_angle;
  search(coarse - 2.5, coarse + 2.5, 0.5);
  const double middle = best_angle;
  search(middle - 0.4, middle + 0.4, 0.1);
  return best;
}

StoneSize stone_size(const TriangleMesh& mesh)
{
  return stone_size(mesh.vertices, mass_properties(mesh), surface_area(mesh));
}

StoneSize stone_size(const std::vector<Vector3>& points, const MassProperties& body, double area)
{
  const Matrix3 axes = principal_frame(body).axes;
  std::array<double, 3> extent;
  for (int k = 0; k < 3; ++k) extent[k] = extent_along(points, axes.col(k));
  // The smallest moment belongs to the longest axis but for odd forms, which sorting takes care of.
  const int longest = std::max_element(extent.begin(), extent.end()) - extent.begin();

  StoneSize size;
  size.sieve = sieve_size(points, axes.col(longest));
  std::sort(extent.begin(), extent.end(), std::greater<>());
  size.longest = extent[0], size.intermediate = extent[1], size.shortest = extent[2];
  if (area > 0) size.sphericity = std::cbrt(36 * M_PI * body.volume * body.volume) / area;
  return size;
}
} // namespace interlock::dem
