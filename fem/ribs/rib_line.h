// A line of beam elements: the piece from which lattices are put together.
#pragma once

#include "fem/ribs/beam_section.h"

#include <Eigen/Dense>

#include <vector>

namespace interlock::fem
{
// Cross-section of a piece of rib: what contacts see and what the beam feels.
struct RibProfile {
  RibSection shape;    // outer shape for contacts; may stay empty for a bare beam
  BeamSection section; // stiffness and inertia
};

// Straight or curved, given by the vertices of its elements in the unloaded state. Lines that share
// a vertex position are joined there.
struct RibLine {
  std::vector<Eigen::Vector3d> points; // vertices in order, at least two, world frame [m]
  Eigen::Vector3d normal{0, 0, 1}; // direction of the section's e3, made normal to each element [-]
  RibSection shape;                // outer shape for contacts; may stay empty for a bare beam
  BeamSection section;             // stiffness and inertia
  // Where these differ along the line: one entry an element instead of `shape` and `section`;
  // otherwise empty.
  std::vector<RibProfile> profiles;
};

// Section of element i of a line, counted from its first vertex.
const RibSection& shape_of_element(const RibLine& line, int i);
const BeamSection& section_of_element(const RibLine& line, int i);

// A straight line from `start` to `end` [m] cut into `elements` equal elements.
// Throws std::invalid_argument when `elements` is not positive or both ends coincide.
RibLine straight_line(const Eigen::Vector3d& start, const Eigen::Vector3d& end, int elements,
                      const BeamSection& section, const Eigen::Vector3d& normal = {0, 0, 1});
} // namespace interlock::fem
