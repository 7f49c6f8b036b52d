#include "dem/scans/facet_polygon.h"

namespace interlock::dem
{
namespace
{
// Twice the area of the polygon, along its normal (Newell's sum).
Vector3 area_vector(const std::vector<int>& corners, const std::vector<Vector3>& vertices)
{
  Vector3 sum = Vector3::Zero();
  const Vector3& origin = vertices[corners[0]];
  for (std::size_t k = 1; k + 1 < corners.size(); ++k)
    sum += (vertices[corners[k]] - origin).cross(vertices[corners[k + 1]] - origin);
  return sum;
}

// Whether no triangle of the fan around corners[start] turns against `area`.
bool is_fan(const std::vector<int>& corners, std::size_t start,
            const std::vector<Vector3>& vertices, const Vector3& area)
{
  const std::size_t n = corners.size();
  const Vector3& origin = vertices[corners[start]];
  for (std::size_t k = 1; k + 1 < n; ++k) {
    const Vector3 a = vertices[corners[(start + k) % n]] - origin;
    const Vector3 b = vertices[corners[(start + k + 1) % n]] - origin;
    // Corners on one line are allowed, with the rounding of single precision.
    if (a.cross(b).dot(area) < -1e-6 * area.squaredNorm()) return false;
  }
  return true;
}
} // namespace

std::string append_polygon(const std::vector<int>& corners, TriangleMesh& mesh)
{
  constexpr std::size_t most_corners = 100;
  const std::size_t n = corners.size();
  if (n < 3) return "";
  if (n > most_corners) return "a facet with more than 100 corners";
  std::size_t start = 0;
  if (n > 3) {
    const Vector3 area = area_vector(corners, mesh.vertices);
    while (start < n && !is_fan(corners, start, mesh.vertices, area)) ++start;
    if (start == n) return "a concave facet with " + std::to_string(n) + " corners";
  }
  for (std::size_t k = 1; k + 1 < n; ++k)
    mesh.triangles.push_back(
        {corners[start], corners[(start + k) % n], corners[(start + k + 1) % n]});
  return "";
}
} // namespace interlock::dem
