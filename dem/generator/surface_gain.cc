#include "dem/generator/surface_gain.h"

namespace interlock::dem
{
SurfaceGain::SurfaceGain(const std::vector<Vector3>& points, const std::vector<double>& areas)
    : x_(points.size()), y_(points.size()), z_(points.size()),
      area_(Eigen::Map<const Eigen::ArrayXd>(areas.data(), areas.size()))
{
  Eigen::AlignedBox3d box;
  for (std::size_t i = 0; i < points.size(); ++i) {
    x_[i] = points[i][0];
    y_[i] = points[i][1];
    z_[i] = points[i][2];
    box.extend(points[i]);
  }
  distance_ = Eigen::ArrayXd::Constant(points.size(), box.diagonal().norm());
}

Eigen::ArrayXd SurfaceGain::distances_from(const Sphere& s) const
{
  const auto squares =
      (x_ - s.centre[0]).square() + (y_ - s.centre[1]).square() + (z_ - s.centre[2]).square();
  return (squares.sqrt() - s.radius).max(0.);
}

double SurfaceGain::gain(const Sphere& sphere) const
{
  return (area_ * (distance_ - distances_from(sphere)).max(0.)).sum();
}

void SurfaceGain::add(const Sphere& sphere)
{
  distance_ = distance_.min(distances_from(sphere));
}
} // namespace interlock::dem
