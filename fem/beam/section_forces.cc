#include "fem/beam/section_forces.h"

namespace interlock::fem
{
BeamEnds<double> beam_ends(const std::array<Eigen::Vector3d, 2>& position,
                           const std::array<Eigen::Quaterniond, 2>& orientation)
{
  const auto triple = [](const Eigen::Vector3d& x) { return Triple<double>{x[0], x[1], x[2]}; };
  const auto quadruple = [](const Eigen::Quaterniond& q) {
    return Quadruple<double>{q.w(), q.x(), q.y(), q.z()};
  };
  return {triple(position[0]), triple(position[1]), quadruple(orientation[0]),
          quadruple(orientation[1])};
}

double strain_energy(const BeamConstants<double>& beam,
                     const std::array<Eigen::Vector3d, 2>& position,
                     const std::array<Eigen::Quaterniond, 2>& orientation)
{
  return strain_energy(beam_strains(beam_ends(position, orientation), beam), beam);
}

SectionForces section_forces(const BeamConstants<double>& beam,
                             const std::array<Eigen::Vector3d, 2>& position,
                             const std::array<Eigen::Quaterniond, 2>& orientation)
{
  const BeamStrains<double> strains = beam_strains(beam_ends(position, orientation), beam);
  const Triple<double> force = section_force(strains, beam), moment = section_moment(strains, beam);
  return {force[0], force[1], force[2], moment[0], moment[1], moment[2]};
}
} // namespace interlock::fem
