// Internal forces of a beam element, for output and for comparison with theory.
#pragma once

#include "fem/beam/beam_element.h"

#include <Eigen/Dense>
#include <Eigen/Geometry>

#include <array>

namespace interlock::fem
{
// In the frame midway between the element's nodes: tension positive, shear along e2 and e3 [N],
// torque about e1, bending moments about e2 and e3 [N m], all acting on the cross-section whose
// outward normal is +e1.
struct SectionForces {
  double axial, shear_2, shear_3, torque, moment_2, moment_3;
};

// Positions [m] and rotations from the unloaded state of both nodes in the order that BeamEnds
// wants.
BeamEnds<double> beam_ends(const std::array<Eigen::Vector3d, 2>& position,
                           const std::array<Eigen::Quaterniond, 2>& orientation);

// Strain energy [J].
double strain_energy(const BeamConstants<double>& beam,
                     const std::array<Eigen::Vector3d, 2>& position,
                     const std::array<Eigen::Quaterniond, 2>& orientation);

SectionForces section_forces(const BeamConstants<double>& beam,
                             const std::array<Eigen::Vector3d, 2>& position,
                             const std::array<Eigen::Quaterniond, 2>& orientation);
} // namespace interlock::fem
