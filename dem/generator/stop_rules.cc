#include "dem/generator/stop_rules.h"

#include <cmath>

namespace interlock::dem
{
StopRules::StopRules(const ClumpParameters& parameters, const MassProperties& stone,
                     const Eigen::AlignedBox3d& box)
    : parameters_(parameters), stone_(stone)
{
  const Vector3 margin = Vector3::Constant(parameters.bulge);
  if (parameters.target_volume_error > 0)
    union_.emplace(Eigen::AlignedBox3d(box.min() - margin, box.max() + margin));
}

std::optional<Stop> StopRules::after(const std::vector<Sphere>& spheres)
{
  if (union_) {
    union_->add({spheres.back().centre, spheres.back().radius + parameters_.bulge});
    const double excess = union_->volume() - stone_.volume;
    const double allowed = parameters_.target_volume_error * stone_.volume;
    // With a bulge too much is as good: a smaller one meets the volume.
    if (excess >= -allowed && (excess <= allowed || parameters_.bulge > 0))
      return Stop::volume_error;
  }
  if (parameters_.target_inertia_error > 0) {
    const auto mass = clump_mass_properties(stone_, spheres, parameters_.mass_scheme);
    if (inertia_error(mass, stone_) <= parameters_.target_inertia_error) return Stop::inertia_error;
  }
  const int n = static_cast<int>(spheres.size());
  if (parameters_.max_spheres > 0 && n >= parameters_.max_spheres) return Stop::max_spheres;
  return std::nullopt;
}
} // namespace interlock::dem
