// All ribs of a geogrid: what they are, and how their ends move. World frame, SI units.
#pragma once

#include "dem/bodies/component_arrays.h"
#include "dem/ribs/ribs.h"

#include <vector>

namespace interlock::dem
{
// What stays the same of a rib. It goes from the end `first_end` to the next one; ribs that follow
// one another share the end between them.
struct RibShape {
  int line = 0;
  int first_end = 0;
  double half_width = 0, half_thickness = 0, rounding = 0; // [m]
  double inverse_mass[2] = {0, 0}; // at its ends, 0 when its motion is prescribed [1/kg]
  Vector3 width_axis[2];           // of the section at the ends before they turn, unit
};

// Indices begin ... end - 1.
struct EndRange {
  int begin = 0, end = 0;
};

class RibSet
{
public:
  RibSet() = default;
  RibSet(std::vector<RibShape> shapes, int n_ends);
  // Rods where they are, each with two ends of its own.
  RibSet(const std::vector<Rib>& rods);

  int size() const { return static_cast<int>(shapes_.size()); }
  const RibShape& shape(int rib) const { return shapes_[static_cast<std::size_t>(rib)]; }
  Rib operator[](int rib) const; // as it is now
  std::vector<Rib> all() const;

  // Of a large set one may know a part: the ribs that are present, ascending, and the ranges of
  // their ends. No others are looked at. At first all are there.
  const std::vector<int>& present() const { return present_; }
  const std::vector<EndRange>& present_ends() const { return present_ends_; }
  void set_present_ends(std::vector<EndRange> ends); // ascending, with gaps between them
  void set_all_present();

  // Of any rib [m].
  double largest_half_thickness() const { return largest_half_thickness_; }
  double largest_half_girth() const { return largest_half_girth_; } // half width + half thickness

  // Of the ends; their owner keeps them up to date. The rotation is that of the section from where
  // its width axis is that of the shape.
  VectorField position, velocity, spin; // [m], [m/s], [rad/s]
  QuaternionField rotation;

private:
  void measure();

  std::vector<RibShape> shapes_;
  std::vector<int> present_;
  std::vector<EndRange> present_ends_;
  double largest_half_thickness_ = 0, largest_half_girth_ = 0;
};
} // namespace interlock::dem
