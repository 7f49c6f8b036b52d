// Words and numbers that the exported clump files share.
#pragma once

#include "dem/bodies/clump_shape.h"

#include <string>
#include <vector>

namespace interlock::dem
{
// A clump on its way into a file.
struct ClumpExport {
  const ClumpShape& shape;
  double density;        // [kg/m3]
  std::string file_name; // of the main file, without its folder

  double mass() const { return density * shape.volume; }           // [kg]
  Vector3 inertia() const { return density * shape.unit_inertia; } // [kg m2]
  std::vector<double> member_masses() const;                       // sum: mass() [kg]
};

// One file of an export; its name is that of the main file followed by `suffix`.
struct ExportedFile {
  std::string suffix, text;
};
using ExportedFiles = std::vector<ExportedFile>;

// 17 significant digits, which read back to the same number.
std::string digits(double value);

// The values with `separator` between them.
std::string digits(const std::vector<double>& values, const std::string& separator);

// "x y z r" of the sphere with `separator` between them.
std::string sphere_digits(const Sphere& sphere, const std::string& separator);

// `name` without line breaks and quotes, for comments and texts.
std::string plain_name(const std::string& name);

// `name` with everything but letters, digits and underscores replaced by an underscore, and a
// letter in front.
std::string identifier(const std::string& name);

// Comment lines, each after `prefix`: name, spheres, density, mass, volume, moments, frame and
// units, then the lines of `usage`.
std::string comment_head(const ClumpExport& clump, const std::string& prefix,
                         const std::vector<std::string>& usage);
} // namespace interlock::dem
