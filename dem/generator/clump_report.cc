#include "dem/generator/clump_report.h"

#include "dem/generator/sphere_groups.h"
#include "dem/generator/union_volume.h"

#include <algorithm>
#include <cmath>

namespace interlock::dem
{
namespace
{
// Axes have no sign. Eigenvalues ascend, so equal columns belong together.
double largest_angle(const Matrix3& a, const Matrix3& b)
{
  const Vector3 cosines = (a.transpose() * b).diagonal().cwiseAbs();
  return std::acos(std::min(1., cosines.minCoeff())) * 180 / M_PI;
}

void compare_schemes(const MassProperties& stone, const std::vector<Sphere>& spheres,
                     ClumpReport& report)
{
  const PrincipalFrame exact = principal_frame(stone);
  const Vector3& moments = exact.moments;
  report.axes_are_distinct = moments[1] > 1.05 * moments[0] && moments[2] > 1.05 * moments[1];
  for (const auto scheme : {MassScheme::uniform, MassScheme::equal_mass, MassScheme::mesh}) {
    const MassProperties mass = clump_mass_properties(stone, spheres, scheme);
    const auto entry = static_cast<std::size_t>(scheme);
    report.inertia_error[entry] = inertia_error(mass, stone);
    report.axis_error[entry] = largest_angle(principal_frame(mass).axes, exact.axes);
    report.centre_offset[entry] = (mass.centre - stone.centre).norm();
  }
}

void measure_distances(const std::vector<Vector3>& nodes, const std::vector<Sphere>& spheres,
                       ClumpReport& report)
{
  std::vector<double> distances;
  distances.reserve(nodes.size());
  double sum = 0;
  for (const Vector3& p : nodes) {
    double signed_distance = INFINITY;
    for (const Sphere& s : spheres)
      signed_distance = std::min(signed_distance, (p - s.centre).norm() - s.radius);
    distances.push_back(std::abs(signed_distance));
    sum += distances.back();
  }
  const auto rank_95 = distances.begin() + (distances.size() - 1) * 95 / 100;
  std::nth_element(distances.begin(), rank_95, distances.end());
  report.surface_distance_mean = sum / distances.size();
  report.surface_distance_95 = *rank_95;
  report.surface_distance_max = *std::max_element(rank_95, distances.end());
}
} // namespace

MassProperties clump_mass_properties(const MassProperties& stone,
                                     const std::vector<Sphere>& spheres, MassScheme scheme)
{
  if (scheme == MassScheme::mesh) return stone;
  std::vector<double> volumes;
  double total = 0;
  for (const Sphere& s : spheres) {
    volumes.push_back(scheme == MassScheme::uniform ? std::pow(s.radius, 3) : 1);
    total += volumes.back();
  }
  for (double& volume : volumes) volume *= stone.volume / total;
  MassProperties mass = mass_properties(spheres, volumes);
  mass.volume = stone.volume; // to the last digit
  return mass;
}

double inertia_error(const MassProperties& value, const MassProperties& exact)
{
  const Vector3 reference = principal_frame(exact).moments;
  return (principal_frame(value).moments - reference).cwiseQuotient(reference).cwiseAbs().mean();
}

void measure_errors(const std::vector<Vector3>& nodes, const MassProperties& stone,
                    const std::vector<Sphere>& spheres, ClumpReport& report)
{
  compare_schemes(stone, spheres, report);
  measure_distances(nodes, spheres, report);
  const UnionVolume all(spheres);
  report.volume_error = (all.volume() - stone.volume) / stone.volume;
  report.volume_uncertainty = all.error() / stone.volume;
  report.groups = sphere_groups(spheres);
}
} // namespace interlock::dem
