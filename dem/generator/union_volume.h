// Volume of the union of spheres, one sphere after the other.
#pragma once

#include "dem/bodies/clump_shape.h"

#include <array>
#include <utility>
#include <vector>

namespace interlock::dem
{
// Exact lengths along parallel rays (z of the spheres' frame): two rays at random places in each
// cell of a grid in x and y. Random, because a regular grid says nothing about its own error where
// the spheres lie as regularly as it does; the two rays of a cell tell how much it varies within.
// Source: stratified sampling, e.g. Owen, Monte Carlo theory, methods and examples (2013), 8.4.
class UnionVolume
{
public:
  // Only what lies within `box` in x and y counts; `cells` a side.
  explicit UnionVolume(const Eigen::AlignedBox3d& box, int cells = 90);
  // Around all of `spheres`, with them in it.
  explicit UnionVolume(const std::vector<Sphere>& spheres, int cells = 90);

  void add(const Sphere& sphere);

  double volume() const; // [m3]
  double error() const;  // three standard errors of volume() [m3]

private:
  struct Ray {
    double x, y;                                   // [m]
    double length = 0;                             // covered [m]
    std::vector<std::pair<double, double>> chords; // disjoint, ascending [m]
  };
  Eigen::AlignedBox3d box_;
  int cells_;
  double dx_, dy_; // of a cell [m]
  std::vector<std::array<Ray, 2>> rays_;
};
} // namespace interlock::dem
