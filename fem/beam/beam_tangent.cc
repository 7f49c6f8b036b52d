#include "fem/beam/beam_tangent.h"

#include "fem/beam/rotation_exponential.h"
#include "fem/beam/section_forces.h"

namespace interlock::fem
{
namespace
{
using Derivatives = Eigen::Matrix<double, 12, 1>;
using Dual = Eigen::AutoDiffScalar<Derivatives>;

Triple<Dual> seeded(const Eigen::Vector3d& value, int first)
{
  return {Dual(value[0], 12, first), Dual(value[1], 12, first + 1), Dual(value[2], 12, first + 2)};
}
} // namespace

BeamTangent beam_tangent(const BeamConstants<double>& beam,
                         const std::array<Eigen::Vector3d, 2>& position,
                         const std::array<Eigen::Quaterniond, 2>& orientation,
                         const std::array<Eigen::Vector3d, 2>& turn)
{
  const BeamEnds<double> start = beam_ends(position, orientation);
  BeamEnds<Dual> ends;
  ends.x1 = seeded(position[0], 0);
  ends.x2 = seeded(position[1], 6);
  ends.q1 = detail::product(detail::exponential(seeded(turn[0], 3)), start.q1);
  ends.q2 = detail::product(detail::exponential(seeded(turn[1], 9)), start.q2);
  const BeamEndLoads<Dual> loads = end_loads(beam_strains(ends, beam), beam);

  BeamTangent tangent;
  const auto put = [&](int row, const Dual& entry, double sign) {
    tangent.force[row] = sign * entry.value();
    tangent.stiffness.row(row) = sign * entry.derivatives().transpose();
  };
  for (int c = 0; c < 3; ++c) {
    put(c, loads.force1[c], -1);
    put(3 + c, loads.torque1[c], -1);
    put(6 + c, loads.force1[c], 1);
    put(9 + c, loads.torque2[c], -1);
  }
  return tangent;
}

Eigen::Matrix<double, 12, 1> beam_force(const BeamConstants<double>& beam,
                                        const std::array<Eigen::Vector3d, 2>& position,
                                        const std::array<Eigen::Quaterniond, 2>& orientation)
{
  const BeamEndLoads<double> loads =
      end_loads(beam_strains(beam_ends(position, orientation), beam), beam);
  Eigen::Matrix<double, 12, 1> force;
  for (int c = 0; c < 3; ++c) {
    force[c] = -loads.force1[c];
    force[3 + c] = -loads.torque1[c];
    force[6 + c] = loads.force1[c];
    force[9 + c] = -loads.torque2[c];
  }
  return force;
}

Eigen::Quaterniond rotation_exponential(const Eigen::Vector3d& turn)
{
  const Quadruple<double> q = detail::exponential<double>({turn[0], turn[1], turn[2]});
  return {q[0], q[1], q[2], q[3]};
}
} // namespace interlock::fem
