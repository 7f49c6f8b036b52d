#include "fem/ribs/rib_line.h"

#include <stdexcept>
#include <string>

namespace interlock::fem
{
const RibSection& shape_of_element(const RibLine& line, int i)
{
  return line.profiles.empty() ? line.shape : line.profiles[i].shape;
}

const BeamSection& section_of_element(const RibLine& line, int i)
{
  return line.profiles.empty() ? line.section : line.profiles[i].section;
}

RibLine straight_line(const Eigen::Vector3d& start, const Eigen::Vector3d& end, int elements,
                      const BeamSection& section, const Eigen::Vector3d& normal)
{
  if (elements < 1)
    throw std::invalid_argument("A rib line was asked for with " + std::to_string(elements) +
                                " elements but needs at least 1.");
  if ((end - start).norm() == 0)
    throw std::invalid_argument("A rib line starts and ends at the same point.");
  RibLine line;
  line.normal = normal;
  line.section = section;
  for (int i = 0; i <= elements; ++i)
    line.points.push_back(start + (end - start) * (static_cast<double>(i) / elements));
  return line;
}
} // namespace interlock::fem
