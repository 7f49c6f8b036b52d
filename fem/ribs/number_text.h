// Numbers as they stand in error messages.
#pragma once

#include <Eigen/Dense>

#include <sstream>
#include <string>

namespace interlock::fem
{
// Six significant digits, also of very small and very large numbers.
inline std::string number_text(double value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}

// (x, y, z)
inline std::string point_text(const Eigen::Vector3d& point)
{
  return "(" + number_text(point.x()) + ", " + number_text(point.y()) + ", " +
         number_text(point.z()) + ")";
}
} // namespace interlock::fem
