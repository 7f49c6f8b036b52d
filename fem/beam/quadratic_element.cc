#include "fem/beam/quadratic_element.h"

#include "fem/beam/quadratic_strains.h"
#include "fem/beam/rotation_exponential.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace interlock::fem
{
namespace
{
// First derivatives, and first derivatives of first derivatives.
using First = Eigen::AutoDiffScalar<Eigen::Matrix<double, 18, 1>>;
using Second = Eigen::AutoDiffScalar<Eigen::Matrix<First, 18, 1>>;

std::array<double, 3> shape_at(double xi)
{
  return {0.5 * xi * (xi - 1), 1 - xi * xi, 0.5 * xi * (xi + 1)};
}

std::array<double, 3> slope_at(double xi)
{
  return {xi - 0.5, -2 * xi, xi + 0.5};
}

Eigen::Vector3d tangent_at(const NodePositions& position, double xi)
{
  const std::array<double, 3> slope = slope_at(xi);
  return slope[0] * (position[0] - position[1]) + slope[2] * (position[2] - position[1]);
}

QuadraticNodes<double> plain_nodes(const NodePositions& position,
                                   const NodeOrientations& orientation)
{
  QuadraticNodes<double> nodes;
  for (int i = 0; i < 3; ++i) {
    nodes.x[i] = {position[i][0], position[i][1], position[i][2]};
    nodes.q[i] = detail::quadruple(orientation[i]);
  }
  return nodes;
}

// A vector of variables number `first` ... `first` + 2.
Triple<First> first_variables(const Eigen::Vector3d& value, int first)
{
  return {First(value[0], 18, first), First(value[1], 18, first + 1),
          First(value[2], 18, first + 2)};
}

Second constant(double value)
{
  return Second(First(value));
}

// Varies both as an inner and as an outer variable, or as one of them.
Second variable(double value, int number, bool inner, bool outer)
{
  Second v = constant(value);
  if (inner) v.value().derivatives()[number] = 1;
  if (outer) v.derivatives()[number] = First(1.);
  return v;
}

void require_shape(const NodePositions& position)
{
  for (const double xi : {-1., 0., 1.}) {
    const Eigen::Vector3d chord = position[2] - position[0];
    const double along = tangent_at(position, xi).dot(chord) / chord.squaredNorm();
    if (!(along > 0))
      throw std::invalid_argument(
          "The middle node of a quadratic beam lies at (" + std::to_string(position[1][0]) + ", " +
          std::to_string(position[1][1]) + ", " + std::to_string(position[1][2]) +
          ") but must lie between its ends, nearer to the middle than to either end.");
  }
}
} // namespace

QuadraticBeam quadratic_beam(const NodePositions& position,
                             const std::array<Eigen::Quaterniond, 3>& frame,
                             const BeamSection& section)
{
  require_shape(position);
  if (section.softening != 0 || std::isfinite(section.yield_force))
    throw std::invalid_argument("A quadratic beam has softening " +
                                std::to_string(section.softening) + " and yield force " +
                                std::to_string(section.yield_force) +
                                " N but must be linear elastic: 0 and infinity.");
  QuadraticBeam beam;
  beam.frame = frame;
  for (Eigen::Quaterniond& f : beam.frame) // the shorter way round
    if (f.dot(frame[1]) < 0) f.coeffs() = -f.coeffs();
  beam.force_stiffness = {section.axial, section.shear_2, section.shear_3};
  beam.moment_stiffness = {section.torsion, section.bending_2, section.bending_3};
  const auto identity = Eigen::Quaterniond::Identity();
  const QuadraticNodes<double> nodes = plain_nodes(position, {identity, identity, identity});
  for (int p = 0; p < 2; ++p) {
    const double xi = (p == 0 ? -1 : 1) / std::sqrt(3.);
    QuadraticBeam::GaussPoint& point = beam.points[p];
    point.weight = tangent_at(position, xi).norm();
    point.shape = shape_at(xi);
    point.slope = slope_at(xi);
    for (double& slope : point.slope) slope /= point.weight;
    const CurveStrains<double> strains =
        curve_strains(beam, nodes, local_rotations(beam, nodes), point);
    point.unloaded_tangent = Eigen::Map<const Eigen::Vector3d>(strains.tangent.data());
    point.unloaded_curvature = Eigen::Map<const Eigen::Vector3d>(strains.curvature.data());
  }
  return beam;
}

std::array<Eigen::Quaterniond, 3> curve_frames(const NodePositions& position,
                                               const Eigen::Vector3d& normal)
{
  std::array<Eigen::Quaterniond, 3> frames;
  for (int i = 0; i < 3; ++i) {
    Eigen::Matrix3d axes;
    axes.col(0) = tangent_at(position, i - 1).normalized();
    const Eigen::Vector3d across = normal.cross(axes.col(0));
    if (!(across.norm() > 1e-6 * normal.norm()))
      throw std::invalid_argument(
          "The normal of a quadratic beam points along it, so the axes of its section are "
          "undefined.");
    axes.col(1) = across.normalized();
    axes.col(2) = axes.col(0).cross(axes.col(1));
    frames[i] = Eigen::Quaterniond(axes).normalized();
  }
  return frames;
}

double strain_energy(const QuadraticBeam& beam, const NodePositions& position,
                     const NodeOrientations& orientation)
{
  return quadratic_energy(beam, plain_nodes(position, orientation));
}

QuadraticForce beam_force(const QuadraticBeam& beam, const NodePositions& position,
                          const NodeOrientations& orientation)
{
  const QuadraticNodes<double> plain = plain_nodes(position, orientation);
  QuadraticNodes<First> nodes;
  for (int i = 0; i < 3; ++i) {
    nodes.x[i] = first_variables(position[i], 6 * i);
    nodes.q[i] = detail::product(
        detail::exponential(first_variables(Eigen::Vector3d::Zero(), 6 * i + 3)), plain.q[i]);
  }
  return quadratic_energy(beam, nodes).derivatives();
}

std::array<SectionForces, 2> section_forces(const QuadraticBeam& beam,
                                            const NodePositions& position,
                                            const NodeOrientations& orientation)
{
  const QuadraticNodes<double> nodes = plain_nodes(position, orientation);
  const auto psi = local_rotations(beam, nodes);
  std::array<SectionForces, 2> forces;
  for (int p = 0; p < 2; ++p) {
    const QuadraticBeam::GaussPoint& at = beam.points[p];
    const CurveStrains<double> strains = curve_strains(beam, nodes, psi, at);
    std::array<double, 3> force, moment;
    for (int c = 0; c < 3; ++c) {
      force[c] = beam.force_stiffness[c] * (strains.tangent[c] - at.unloaded_tangent[c]);
      moment[c] = beam.moment_stiffness[c] * (strains.curvature[c] - at.unloaded_curvature[c]);
    }
    forces[p] = {force[0], force[1], force[2], moment[0], moment[1], moment[2]};
  }
  return forces;
}

// The energy of displacements u + v and rotations exp(spin) exp(turn) q, where v and spin are the
// inner variables, at zero, and u and turn the outer ones: its inner gradient is the force, whose
// outer derivative is the stiffness.
QuadraticTangent beam_tangent(const QuadraticBeam& beam, const NodePositions& position,
                              const NodeOrientations& orientation, const NodePositions& turn)
{
  const QuadraticNodes<double> plain = plain_nodes(position, orientation);
  QuadraticNodes<Second> nodes;
  for (int i = 0; i < 3; ++i) {
    Triple<Second> outer, inner;
    for (int c = 0; c < 3; ++c) {
      nodes.x[i][c] = variable(position[i][c], 6 * i + c, true, true);
      outer[c] = variable(turn[i][c], 6 * i + 3 + c, false, true);
      inner[c] = variable(0, 6 * i + 3 + c, true, false);
    }
    // To first order in spin, which is all that a derivative at zero sees.
    const Quadruple<Second> spun{constant(1), 0.5 * inner[0], 0.5 * inner[1], 0.5 * inner[2]};
    nodes.q[i] = detail::product(spun, detail::product(detail::exponential(outer), plain.q[i]));
  }
  const Second energy = quadratic_energy(beam, nodes);
  QuadraticTangent tangent;
  tangent.force = energy.value().derivatives();
  for (int j = 0; j < 18; ++j) tangent.stiffness.col(j) = energy.derivatives()[j].derivatives();
  return tangent;
}
} // namespace interlock::fem
