#include "fem/beam/rotational_spring.h"

#include "fem/beam/section_forces.h"

namespace interlock::fem
{
namespace
{
const std::array<Eigen::Vector3d, 2> one_place{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};

// A beam element of unit length without force stiffness.
BeamConstants<double> as_beam(const RotationalSpring& spring)
{
  const Eigen::Quaterniond frame =
      Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), spring.normal);
  return {1,
          1,
          {frame.w(), frame.x(), frame.y(), frame.z()},
          {0, 0, 0},
          {spring.out_of_plane, spring.out_of_plane, spring.in_plane},
          {0, 0, 0}};
}
} // namespace

SpringTangent spring_tangent(const RotationalSpring& spring,
                             const std::array<Eigen::Quaterniond, 2>& orientation,
                             const std::array<Eigen::Vector3d, 2>& turn)
{
  const BeamTangent beam = beam_tangent(as_beam(spring), one_place, orientation, turn);
  SpringTangent tangent;
  for (int a = 0; a < 2; ++a) {
    tangent.moment.segment<3>(3 * a) = beam.force.segment<3>(6 * a + 3);
    for (int b = 0; b < 2; ++b)
      tangent.stiffness.block<3, 3>(3 * a, 3 * b) =
          beam.stiffness.block<3, 3>(6 * a + 3, 6 * b + 3);
  }
  return tangent;
}

Eigen::Vector3d spring_moment(const RotationalSpring& spring,
                              const std::array<Eigen::Quaterniond, 2>& orientation)
{
  // Minus the gradient on the first node.
  return -beam_force(as_beam(spring), one_place, orientation).segment<3>(3);
}

double spring_energy(const RotationalSpring& spring,
                     const std::array<Eigen::Quaterniond, 2>& orientation)
{
  const BeamConstants<double> constants = as_beam(spring);
  return strain_energy(beam_strains(beam_ends(one_place, orientation), constants), constants);
}
} // namespace interlock::fem
