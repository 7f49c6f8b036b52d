#include "dem/generator/union_volume.h"

#include "dem/random_stream.h"

#include <algorithm>
#include <cmath>

namespace interlock::dem
{
namespace
{
Eigen::AlignedBox3d box_around(const std::vector<Sphere>& spheres)
{
  Eigen::AlignedBox3d box(Vector3::Zero(), Vector3::Zero());
  if (!spheres.empty()) box.setEmpty();
  for (const Sphere& s : spheres) {
    box.extend(Vector3(s.centre.array() - s.radius));
    box.extend(Vector3(s.centre.array() + s.radius));
  }
  return box;
}

using Interval = std::pair<double, double>;

// Adds `chord` to the disjoint intervals of a ray; those that it meets become one with it. Returns
// the length that was not covered before.
double cover(std::vector<Interval>& ray, Interval chord)
{
  const auto first = std::lower_bound(ray.begin(), ray.end(), chord.first,
                                      [](const Interval& a, double low) { return a.second < low; });
  double covered = 0;
  auto last = first;
  for (; last != ray.end() && last->first <= chord.second; ++last) {
    covered += last->second - last->first;
    chord = {std::min(chord.first, last->first), std::max(chord.second, last->second)};
  }
  if (last == first) {
    ray.insert(first, chord);
  } else {
    *first = chord;
    ray.erase(first + 1, last);
  }
  return chord.second - chord.first - covered;
}
} // namespace

UnionVolume::UnionVolume(const Eigen::AlignedBox3d& box, int cells)
    : box_(box), cells_(cells), dx_(box.sizes()[0] / cells), dy_(box.sizes()[1] / cells),
      rays_(cells * cells)
{
  RandomStream random(1);
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j)
      for (Ray& ray : rays_[i * cells + j]) {
        ray.x = box.min()[0] + (i + random.uniform(0, 1)) * dx_;
        ray.y = box.min()[1] + (j + random.uniform(0, 1)) * dy_;
      }
}

UnionVolume::UnionVolume(const std::vector<Sphere>& spheres, int cells)
    : UnionVolume(box_around(spheres), cells)
{
  for (const Sphere& s : spheres) add(s);
}

void UnionVolume::add(const Sphere& s)
{
  // The cells under the box around the sphere's shadow.
  const auto cell = [this](double x, int axis, double size) {
    return int(std::clamp(std::floor((x - box_.min()[axis]) / size), 0., cells_ - 1.));
  };
  const int i_end = cell(s.centre[0] + s.radius, 0, dx_);
  const int j_end = cell(s.centre[1] + s.radius, 1, dy_);
  for (int i = cell(s.centre[0] - s.radius, 0, dx_); i <= i_end; ++i)
    for (int j = cell(s.centre[1] - s.radius, 1, dy_); j <= j_end; ++j)
      for (Ray& ray : rays_[i * cells_ + j]) {
        const double x = ray.x - s.centre[0], y = ray.y - s.centre[1];
        const double square = s.radius * s.radius - x * x - y * y;
        if (square <= 0) continue;
        const double half = std::sqrt(square);
        ray.length += cover(ray.chords, {s.centre[2] - half, s.centre[2] + half});
      }
}

double UnionVolume::volume() const
{
  double sum = 0;
  for (const auto& [a, b] : rays_) sum += a.length + b.length;
  return sum / 2 * dx_ * dy_;
}

double UnionVolume::error() const
{
  // The mean of two samples has a quarter of their squared difference as its variance.
  double variance = 0;
  for (const auto& [a, b] : rays_) variance += std::pow(a.length - b.length, 2) / 4;
  return 3 * std::sqrt(variance) * dx_ * dy_;
}
} // namespace interlock::dem
