// Clouds of points with normals on bodies with closed forms.
#pragma once

#include "dem/random_stream.h"
#include "dem/scans/point_cloud.h"

#include <cmath>
#include <sstream>

namespace clouds
{
using interlock::dem::PointCloud;
using interlock::dem::Vector3;

// On the ellipsoid with these half axes around the origin: points of a ball, stretched. Without a
// generator along a Fibonacci spiral, which is even on the ball; with one at random.
inline PointCloud ellipsoid(const Vector3& half_axes, int points,
                            interlock::dem::RandomStream* generator = nullptr)
{
  const double pi = std::acos(-1.), golden_angle = pi * (3 - std::sqrt(5.));
  PointCloud cloud;
  for (int i = 0; i < points; ++i) {
    const double z = generator ? generator->uniform(-1, 1) : 1 - 2 * (i + 0.5) / points;
    const double angle = generator ? generator->uniform(0, 2 * pi) : i * golden_angle;
    const double r = std::sqrt(1 - z * z);
    const Vector3 on_ball(r * std::cos(angle), r * std::sin(angle), z);
    cloud.points.push_back(half_axes.cwiseProduct(on_ball));
    cloud.normals.push_back(on_ball.cwiseQuotient(half_axes).normalized());
  }
  return cloud;
}

inline std::string as_text(const PointCloud& cloud)
{
  std::ostringstream text;
  text.precision(9);
  for (std::size_t i = 0; i < cloud.points.size(); ++i)
    text << cloud.points[i].transpose() << " " << cloud.normals[i].transpose() << "\n";
  return text.str();
}
} // namespace clouds
