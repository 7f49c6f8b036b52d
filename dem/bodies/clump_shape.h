// The template of a clump: member spheres of one stone in its body frame, with the mass properties
// that the equations of motion use. Many clumps share one shape.
#pragma once

#include "dem/vector.h"

#include <string>
#include <vector>

namespace interlock::dem
{
struct Sphere {
  Vector3 centre; // body frame [m]
  double radius;  // [m]
};

// Body frame: origin at the centre of mass, axes along the principal axes of inertia
// (right-handed).
struct ClumpShape {
  std::string name;
  std::vector<Sphere> spheres;
  double volume = 0;                      // of the stone, the mass is density * volume [m3]
  Vector3 unit_inertia = Vector3::Zero(); // principal moments for unit density [m5]

  // Largest |centre| + radius: the clump lies inside this ball around its centre of mass [m].
  double bounding_radius() const;

  static constexpr bool stored_as_groups = true; // shapes differ in their number of spheres
};

// One clump as JSON (`*.clump.json`), SI units, read back to the same digits. Writing goes to a
// temporary name first, then renames (atomic_files.h). Reading throws InputError (file, entry,
// value).
std::string clump_shape_text(const ClumpShape& shape);
void write_clump_shape(const std::string& path, const ClumpShape& shape);
ClumpShape read_clump_shape(const std::string& path);

template <class Archive> void exchange(Archive& archive, Sphere& sphere)
{
  archive("centre", sphere.centre, "m");
  archive("radius", sphere.radius, "m");
}
template <class Archive> void exchange(Archive& archive, ClumpShape& shape)
{
  archive("name", shape.name);
  archive("spheres", shape.spheres);
  archive("volume", shape.volume, "m3");
  archive("unit_inertia", shape.unit_inertia, "m5");
}
} // namespace interlock::dem
