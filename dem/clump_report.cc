#include "dem/clump_report.h"

#include "dem/mass_properties.h"

#include <algorithm>
#include <cmath>

namespace interlock::dem
{
namespace
{
// Length of the union of the intervals; sorts them.
double union_length(std::vector<std::pair<double, double>>& intervals)
{
  std::sort(intervals.begin(), intervals.end());
  double length = 0, covered_to = -INFINITY;
  for (const auto& [low, high] : intervals) {
    if (high <= covered_to) continue;
    length += high - std::max(low, covered_to);
    covered_to = high;
  }
  return length;
}
} // namespace

double union_volume(const std::vector<Sphere>& spheres, int lines)
{
  Eigen::AlignedBox3d box;
  for (const Sphere& s : spheres) {
    box.extend(Vector3(s.centre.array() - s.radius));
    box.extend(Vector3(s.centre.array() + s.radius));
  }
  if (spheres.empty()) return 0;
  const double dx = box.sizes()[0] / lines, dy = box.sizes()[1] / lines;
  // Rays along z through the middle of each cell of a grid on the box; every sphere adds its chord
  // to the rays that it meets.
  std::vector<std::vector<std::pair<double, double>>> chords(lines * lines);
  for (const Sphere& s : spheres) {
    const auto first = [&](int axis, double step) {
      return int(std::max(0., (s.centre[axis] - s.radius - box.min()[axis]) / step - 1));
    };
    for (int i = first(0, dx); i < lines; ++i) {
      const double x = box.min()[0] + (i + 0.5) * dx - s.centre[0];
      if (x > s.radius) break;
      for (int j = first(1, dy); j < lines; ++j) {
        const double y = box.min()[1] + (j + 0.5) * dy - s.centre[1];
        if (y > s.radius) break;
        const double square = s.radius * s.radius - x * x - y * y;
        if (square <= 0) continue;
        const double half = std::sqrt(square);
        chords[i * lines + j].emplace_back(s.centre[2] - half, s.centre[2] + half);
      }
    }
  }
  double length = 0;
  for (auto& line : chords) length += union_length(line);
  return length * dx * dy;
}

void measure_surface(const TriangleMesh& stone, const std::vector<Sphere>& spheres,
                     ClumpReport& report)
{
  std::vector<double> distances;
  for (const Vector3& node : stone.vertices) {
    double nearest = INFINITY;
    for (const Sphere& s : spheres)
      nearest = std::min(nearest, (node - s.centre).norm() - s.radius);
    distances.push_back(std::abs(nearest));
  }
  std::sort(distances.begin(), distances.end());
  double sum = 0;
  for (const double distance : distances) sum += distance;
  report.surface_distance_mean = sum / distances.size();
  report.surface_distance_95 = distances[(distances.size() - 1) * 95 / 100];
  report.surface_distance_max = distances.back();
  const double volume = mass_properties(stone).volume;
  report.volume_error = (union_volume(spheres) - volume) / volume;
}
} // namespace interlock::dem
