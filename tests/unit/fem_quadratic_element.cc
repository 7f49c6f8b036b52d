// The three-node beam element against what it must satisfy by definition, on strongly strained
// random curved elements. Fails when the unloaded curve carries strain, when forces are not the
// gradient of the energy or do not balance, when rigid motion changes anything, when there are more
// or fewer than six rigid modes, when the tangent is not the derivative of the force, or when a
// state of constant strain is missed.
#include "fem/beam/beam_tangent.h"
#include "fem/beam/quadratic_element.h"

#include <Eigen/Eigenvalues>

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

namespace
{
using namespace interlock::fem;
using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

std::mt19937 generator(13);

Vector3d random_vector(double size)
{
  std::uniform_real_distribution<double> uniform(-size, size);
  return {uniform(generator), uniform(generator), uniform(generator)};
}

Matrix3d cross_matrix(const Vector3d& v)
{
  Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

BeamSection section()
{
  BeamSection s;
  s.axial = 10;
  s.shear_2 = 4;
  s.shear_3 = 5;
  s.torsion = 1;
  s.bending_2 = 2;
  s.bending_3 = 3;
  return s;
}

struct Case {
  QuadraticBeam beam;
  NodePositions unloaded, x;
  NodeOrientations q;
};

// Unloaded: a random parabola with a node off its middle, random position and twist. Loaded: turns
// between nodes up to about 1 rad and force strains up to about 0.5, far beyond any use.
Case random_case()
{
  Case c;
  const Quaterniond place = rotation_exponential(random_vector(2));
  const NodePositions local{Vector3d(0, 0, 0), Vector3d(0.16, 0.03, 0.01), Vector3d(0.3, 0, 0.05)};
  const Vector3d shift = random_vector(1);
  for (int i = 0; i < 3; ++i) c.unloaded[i] = shift + place * local[i];
  auto frames = curve_frames(c.unloaded, place * Vector3d(0.1, 0.2, 1));
  for (int i = 0; i < 3; ++i)
    frames[i] = frames[i] * rotation_exponential(0.2 * (i - 1) * Vector3d::UnitX());
  c.beam = quadratic_beam(c.unloaded, frames, section());
  const Quaterniond turn = rotation_exponential(random_vector(1.5));
  const Vector3d move = random_vector(1);
  for (int i = 0; i < 3; ++i) {
    c.q[i] = (rotation_exponential(random_vector(0.4)) * turn).normalized();
    c.x[i] = turn * c.unloaded[i] + move + random_vector(0.04);
  }
  return c;
}

NodeOrientations identity()
{
  return {Quaterniond::Identity(), Quaterniond::Identity(), Quaterniond::Identity()};
}

NodePositions no_turn()
{
  return {Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero()};
}

// Moves one of the eighteen freedoms: displacement, or spin on top of the orientation.
void move(Case& c, int freedom, double by)
{
  const int node = freedom / 6, component = freedom % 6;
  if (component < 3)
    c.x[node][component] += by;
  else
    c.q[node] = rotation_exponential(by * Vector3d::Unit(component - 3)) * c.q[node];
}

TEST(QuadraticElement, UnloadedCurveIsUnstrained)
{
  for (int trial = 0; trial < 10; ++trial) {
    const Case c = random_case();
    EXPECT_LT(strain_energy(c.beam, c.unloaded, identity()), 1e-28);
    EXPECT_LT(beam_force(c.beam, c.unloaded, identity()).norm(), 1e-13);
  }
}

TEST(QuadraticElement, ForcesAreTheGradientOfTheEnergy)
{
  for (int trial = 0; trial < 10; ++trial) {
    const Case c = random_case();
    const QuadraticForce force = beam_force(c.beam, c.x, c.q);
    for (int freedom = 0; freedom < 18; ++freedom) {
      Case up = c, down = c;
      const double step = 1e-5;
      move(up, freedom, step);
      move(down, freedom, -step);
      const double slope =
          (strain_energy(c.beam, up.x, up.q) - strain_energy(c.beam, down.x, down.q)) / (2 * step);
      EXPECT_NEAR(force[freedom], slope, 1e-8 * force.norm());
    }
  }
}

TEST(QuadraticElement, ForcesAndMomentsBalance)
{
  for (int trial = 0; trial < 10; ++trial) {
    const Case c = random_case();
    const QuadraticForce f = beam_force(c.beam, c.x, c.q);
    Vector3d force(0, 0, 0), moment(0, 0, 0);
    for (int i = 0; i < 3; ++i) {
      force += f.segment<3>(6 * i);
      moment += f.segment<3>(6 * i + 3) + c.x[i].cross(f.segment<3>(6 * i));
    }
    EXPECT_LT(force.norm() + moment.norm(), 1e-13 * f.norm());
  }
}

TEST(QuadraticElement, TenTurnsAndATranslationChangeNothing)
{
  for (int trial = 0; trial < 10; ++trial) {
    const Case c = random_case();
    Case moved = c;
    const Quaterniond increment = rotation_exponential(0.1 * M_PI * random_vector(1).normalized());
    for (int i = 0; i < 200; ++i) // ten turns in increments, as a solver would
      for (int v = 0; v < 3; ++v) {
        moved.q[v] = (increment * moved.q[v]).normalized();
        moved.x[v] = increment * moved.x[v] + Vector3d(0.01, -0.02, 0.03);
      }
    const double before = strain_energy(c.beam, c.x, c.q);
    EXPECT_NEAR(strain_energy(c.beam, moved.x, moved.q), before, 1e-12 * before);
    const auto a = section_forces(c.beam, c.x, c.q), b = section_forces(c.beam, moved.x, moved.q);
    for (int p = 0; p < 2; ++p) {
      EXPECT_NEAR(a[p].axial, b[p].axial, 1e-11);
      EXPECT_NEAR(a[p].shear_2, b[p].shear_2, 1e-11);
      EXPECT_NEAR(a[p].shear_3, b[p].shear_3, 1e-11);
      EXPECT_NEAR(a[p].torque, b[p].torque, 1e-11);
      EXPECT_NEAR(a[p].moment_2, b[p].moment_2, 1e-11);
      EXPECT_NEAR(a[p].moment_3, b[p].moment_3, 1e-11);
    }
  }
}

TEST(QuadraticElement, TangentIsTheDerivativeOfTheForce)
{
  for (int trial = 0; trial < 5; ++trial) {
    const Case c = random_case();
    // A turn on top of the orientations, below and above the switch between series and closed form.
    const NodePositions turn{random_vector(0.02), random_vector(0.2), random_vector(0.02)};
    const QuadraticTangent tangent = beam_tangent(c.beam, c.x, c.q, turn);
    const auto force = [&](const NodePositions& x, const NodePositions& t) {
      NodeOrientations q;
      for (int i = 0; i < 3; ++i) q[i] = rotation_exponential(t[i]) * c.q[i];
      return beam_force(c.beam, x, q);
    };
    EXPECT_LT((tangent.force - force(c.x, turn)).norm(), 1e-13 * tangent.force.norm());
    for (int freedom = 0; freedom < 18; ++freedom) {
      const double step = 1e-5;
      NodePositions x[2] = {c.x, c.x}, t[2] = {turn, turn};
      for (int side = 0; side < 2; ++side) {
        NodePositions& moved = freedom % 6 < 3 ? x[side] : t[side];
        moved[freedom / 6][freedom % 3] += side == 0 ? step : -step;
      }
      const QuadraticForce slope = (force(x[0], t[0]) - force(x[1], t[1])) / (2 * step);
      EXPECT_LT((tangent.stiffness.col(freedom) - slope).norm(), 3e-8 * tangent.stiffness.norm());
    }
  }
}

// The stiffness is a second derivative of the energy, but by spins, which do not commute: it
// differs from its transpose by the nodal moments, and so by nothing where these are in balance.
TEST(QuadraticElement, TangentIsSymmetricUpToTheNodalMoments)
{
  for (int trial = 0; trial < 10; ++trial) {
    const Case c = random_case();
    const QuadraticTangent tangent = beam_tangent(c.beam, c.x, c.q, no_turn());
    Eigen::Matrix<double, 18, 18> skew = tangent.stiffness - tangent.stiffness.transpose().eval();
    for (int i = 0; i < 3; ++i)
      skew.block<3, 3>(6 * i + 3, 6 * i + 3) += cross_matrix(tangent.force.segment<3>(6 * i + 3));
    EXPECT_LT(skew.norm(), 1e-12 * tangent.stiffness.norm());
  }
}

// Unstrained at any place: six zero eigenvalues and no more, although two Gauss points give only
// twelve strains.
TEST(QuadraticElement, SixRigidModesAndNoOther)
{
  for (int trial = 0; trial < 10; ++trial) {
    const Case c = random_case();
    const Quaterniond turn = rotation_exponential(random_vector(1.5));
    NodePositions x;
    for (int i = 0; i < 3; ++i) x[i] = turn * c.unloaded[i];
    const QuadraticTangent tangent = beam_tangent(c.beam, x, {turn, turn, turn}, no_turn());
    const auto stiffness = 0.5 * (tangent.stiffness + tangent.stiffness.transpose());
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(stiffness, Eigen::EigenvaluesOnly);
    const double largest = modes.eigenvalues()[17];
    EXPECT_LT(modes.eigenvalues().head<6>().norm(), 1e-13 * largest);
    EXPECT_GT(modes.eigenvalues()[6], 1e-4 * largest);
  }
}

// Strained, a rigid motion turns the forces with it.
TEST(QuadraticElement, RigidMotionTurnsTheForces)
{
  const Case c = random_case();
  const QuadraticTangent tangent = beam_tangent(c.beam, c.x, c.q, no_turn());
  const Vector3d move = random_vector(1), spin = random_vector(1);
  QuadraticForce motion, turned;
  for (int i = 0; i < 3; ++i) {
    motion.segment<3>(6 * i) = move + spin.cross(c.x[i]);
    motion.segment<3>(6 * i + 3) = spin;
    for (const int part : {0, 3})
      turned.segment<3>(6 * i + part) = spin.cross(tangent.force.segment<3>(6 * i + part));
  }
  EXPECT_LT((tangent.stiffness * motion - turned).norm(), 1e-12 * tangent.stiffness.norm());
}

// A straight element stretched, sheared and twisted evenly, and one bent to an arc whose sections
// turn evenly, have the strains that were put in.
TEST(QuadraticElement, ConstantStrainsAreExact)
{
  const double length = 0.4, stretch = 0.1, shear = 0.05, twist = 0.7, curvature = 1.1;
  const NodePositions unloaded{Vector3d(0, 0, 0), Vector3d(0.2, 0, 0), Vector3d(0.4, 0, 0)};
  const QuadraticBeam beam =
      quadratic_beam(unloaded, curve_frames(unloaded, Vector3d::UnitZ()), section());
  NodePositions x;
  NodeOrientations twisted, bent;
  for (int i = 0; i < 3; ++i) {
    const double s = 0.5 * length * i;
    x[i] = {(1 + stretch) * s, 0, 0};
    twisted[i] = rotation_exponential({twist * s, 0, 0});
    bent[i] = rotation_exponential({0, 0, curvature * s});
  }
  for (const SectionForces& f : section_forces(beam, x, twisted)) {
    EXPECT_NEAR(f.axial, section().axial * stretch, 1e-13);
    EXPECT_NEAR(f.torque, section().torsion * twist, 1e-13);
    EXPECT_NEAR(f.moment_2, 0, 1e-13);
  }
  for (const SectionForces& f : section_forces(beam, x, bent)) {
    EXPECT_NEAR(f.moment_3, section().bending_3 * curvature, 1e-13);
    EXPECT_NEAR(f.torque, 0, 1e-13);
  }
  for (int i = 0; i < 3; ++i) x[i] = unloaded[i] + Vector3d(0, shear * unloaded[i].x(), 0);
  for (const SectionForces& f : section_forces(beam, x, identity())) {
    EXPECT_NEAR(f.shear_2, section().shear_2 * shear, 1e-13);
    EXPECT_NEAR(f.axial, 0, 1e-13);
  }
}

TEST(QuadraticElement, RefusesWhatIsNoElement)
{
  NodePositions x{Vector3d(0, 0, 0), Vector3d(0.04, 0, 0), Vector3d(0.4, 0, 0)};
  const auto frames = curve_frames({x[0], Vector3d(0.2, 0, 0), x[2]}, Vector3d::UnitZ());
  EXPECT_THROW(quadratic_beam(x, frames, section()), std::invalid_argument); // off the middle
  x[1] = {0.2, 0, 0};
  EXPECT_THROW(curve_frames(x, Vector3d::UnitX()), std::invalid_argument);
  BeamSection softening = section();
  softening.softening = 8;
  EXPECT_THROW(quadratic_beam(x, frames, softening), std::invalid_argument);
  x[2] = x[0];
  EXPECT_THROW(quadratic_beam(x, frames, section()), std::invalid_argument);
}
} // namespace
