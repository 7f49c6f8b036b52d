#include "dem/scans/facet_crossing.h"

#include <algorithm>
#include <cmath>

namespace interlock::dem
{
namespace
{
bool straddles(const std::array<double, 3>& distances)
{
  const auto [least, most] = std::minmax_element(distances.begin(), distances.end());
  return *least < 0 && *most > 0;
}
} // namespace

FacetCrossing::FacetCrossing(const TriangleMesh& mesh) : mesh_(mesh)
{
  double largest = 0;
  for (const Vector3& x : mesh.vertices) largest = std::max(largest, x.cwiseAbs().maxCoeff());
  tolerance_ = 2.4e-7 * largest;
}

std::optional<Vector3> FacetCrossing::operator()(const Triangle& a, const Triangle& b) const
{
  long shared = 0;
  for (const int v : a) shared += std::count(b.begin(), b.end(), v);
  if (shared > 1) return {};
  const Vector3 normal_a = normal(a), normal_b = normal(b);
  const Distances distances_a = distances(a, b, normal_b), distances_b = distances(b, a, normal_a);
  if (!straddles(distances_a) || !straddles(distances_b)) return {};
  const Vector3 along = normal_a.cross(normal_b).normalized();
  const Interval of_a = interval(a, distances_a, along), of_b = interval(b, distances_b, along);
  const double first = std::max(of_a.first, of_b.first), last = std::min(of_a.last, of_b.last);
  if (!(last - first > tolerance_)) return {};
  return Vector3(of_a.point + ((first + last) / 2 - of_a.point.dot(along)) * along);
}

Vector3 FacetCrossing::normal(const Triangle& t) const
{
  const Vector3 ab = corner(t, 1) - corner(t, 0), ac = corner(t, 2) - corner(t, 0);
  return ab.cross(ac).normalized();
}

FacetCrossing::Distances FacetCrossing::distances(const Triangle& t, const Triangle& other,
                                                  const Vector3& normal) const
{
  Distances result;
  for (int k = 0; k < 3; ++k) {
    const double distance = normal.dot(corner(t, k) - corner(other, 0));
    const bool is_shared = std::find(other.begin(), other.end(), t[k]) != other.end();
    result[k] = is_shared || std::abs(distance) <= tolerance_ ? 0 : distance;
  }
  return result;
}

// Of a facet that has corners on either side of the other one's plane.
FacetCrossing::Interval FacetCrossing::interval(const Triangle& t, const Distances& d,
                                                const Vector3& along) const
{
  std::array<Vector3, 2> ends;
  int found = 0;
  for (int k = 0; k < 3 && found < 2; ++k) {
    const int next = (k + 1) % 3;
    if (d[k] == 0)
      ends[found++] = corner(t, k);
    else if (d[k] * d[next] < 0)
      ends[found++] = corner(t, k) + d[k] / (d[k] - d[next]) * (corner(t, next) - corner(t, k));
  }
  const double p = ends[0].dot(along), q = ends[1].dot(along);
  return {std::min(p, q), std::max(p, q), ends[0]};
}
} // namespace interlock::dem
