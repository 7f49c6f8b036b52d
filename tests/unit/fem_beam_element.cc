// The beam element kernel against what it must satisfy by definition, on strongly strained random
// elements. Fails when a force is not minus the gradient of the energy, when forces do not balance,
// when rigid motion changes anything, when the tangent is not the derivative of the force, or when
// vector lanes and scalars disagree.

// GCC 12 warns in its own header about the undefined operand of vector square roots (GCC bug
// 105593).
#pragma GCC diagnostic ignored "-Wuninitialized"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"

#include "fem/beam/beam_element.h"
#include "fem/beam/beam_tangent.h"
#include "fem/beam/section_forces.h"
#include "fem/explicit/wide.h"

#include <gtest/gtest.h>

#include <random>

namespace
{
using namespace interlock::fem;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using Positions = std::array<Vector3d, 2>;
using Orientations = std::array<Quaterniond, 2>;

struct Case {
  BeamConstants<double> beam;
  Positions x;
  Orientations q;
};

std::mt19937 generator(7);

Vector3d random_vector(double size)
{
  std::uniform_real_distribution<double> uniform(-size, size);
  return {uniform(generator), uniform(generator), uniform(generator)};
}

// Relative turn up to about 1 rad and force strains up to about 0.5, far beyond any use.
Case random_case()
{
  Case c;
  const Quaterniond frame = rotation_exponential(random_vector(2));
  const double h = 0.3;
  c.beam = {h,          1 / h,     {frame.w(), frame.x(), frame.y(), frame.z()},
            {10, 4, 5}, {1, 2, 3}, {1.1, 0.7, 0.01}};
  c.q[0] = rotation_exponential(random_vector(1.5));
  c.q[1] = rotation_exponential(random_vector(0.6)) * c.q[0];
  c.x[0] = random_vector(1);
  c.x[1] = c.x[0] + c.q[0] * frame * (h * (Vector3d(1, 0, 0) + random_vector(0.3)));
  return c;
}

double energy(const BeamConstants<double>& beam, const Positions& x, const Orientations& q)
{
  return strain_energy(beam_strains(beam_ends(x, q), beam), beam);
}

// Moves one of the twelve freedoms: displacement, or spin on top of the orientation.
void move(Case& c, int freedom, double by)
{
  const int node = freedom / 6, component = freedom % 6;
  if (component < 3)
    c.x[node][component] += by;
  else
    c.q[node] = rotation_exponential(by * Vector3d::Unit(component - 3)) * c.q[node];
}

TEST(BeamElement, ForcesAreMinusTheGradientOfTheEnergy)
{
  for (int trial = 0; trial < 20; ++trial) {
    const Case c = random_case();
    const auto force = beam_force(c.beam, c.x, c.q);
    for (int freedom = 0; freedom < 12; ++freedom) {
      Case up = c, down = c;
      const double step = 1e-5;
      move(up, freedom, step);
      move(down, freedom, -step);
      const double slope =
          (energy(c.beam, up.x, up.q) - energy(c.beam, down.x, down.q)) / (2 * step);
      EXPECT_NEAR(force[freedom], slope, 2e-9 * force.norm());
    }
  }
}

TEST(BeamElement, ForcesAndMomentsBalance)
{
  for (int trial = 0; trial < 20; ++trial) {
    const Case c = random_case();
    const auto f = beam_force(c.beam, c.x, c.q);
    const Vector3d force = f.segment<3>(0) + f.segment<3>(6);
    const Vector3d moment = f.segment<3>(3) + f.segment<3>(9) + c.x[0].cross(f.segment<3>(0)) +
                            c.x[1].cross(f.segment<3>(6));
    EXPECT_LT(force.norm() + moment.norm(), 1e-14 * (1 + f.norm()));
  }
}

TEST(BeamElement, TenTurnsAndATranslationChangeNothing)
{
  for (int trial = 0; trial < 20; ++trial) {
    const Case c = random_case();
    Case moved = c;
    const Vector3d axis = random_vector(1).normalized();
    const Quaterniond increment = rotation_exponential(0.1 * M_PI * axis);
    for (int i = 0; i < 200; ++i) // ten turns in increments, as a solver would
      for (int v = 0; v < 2; ++v) {
        moved.q[v] = (increment * moved.q[v]).normalized();
        moved.x[v] = increment * moved.x[v] + Vector3d(0.01, -0.02, 0.03);
      }
    const double before = energy(c.beam, c.x, c.q), after = energy(c.beam, moved.x, moved.q);
    EXPECT_NEAR(after, before, 1e-12 * before);
    const SectionForces a = section_forces(c.beam, c.x, c.q),
                        b = section_forces(c.beam, moved.x, moved.q);
    EXPECT_NEAR(a.axial, b.axial, 3e-12);
    EXPECT_NEAR(a.shear_2, b.shear_2, 3e-12);
    EXPECT_NEAR(a.shear_3, b.shear_3, 3e-12);
    EXPECT_NEAR(a.torque, b.torque, 3e-12);
    EXPECT_NEAR(a.moment_2, b.moment_2, 3e-12);
    EXPECT_NEAR(a.moment_3, b.moment_3, 3e-12);
  }
}

// Curvature is the relative rotation vector over the length, up to the stated range of the series.
TEST(BeamElement, CurvatureIsTheRotationVectorOverTheLength)
{
  for (const double angle : {0., 1e-9, 1e-3, 0.1, 0.7, 1.2, 1.6, 2.5}) {
    Case c = random_case();
    const Vector3d axis = random_vector(1).normalized(); // in the element's frame
    const Quaterniond frame(c.beam.frame[0], c.beam.frame[1], c.beam.frame[2], c.beam.frame[3]);
    c.q[1] = c.q[0] * frame * rotation_exponential(angle * axis) * frame.conjugate();
    const auto strains = beam_strains(beam_ends(c.x, c.q), c.beam);
    for (int i = 0; i < 3; ++i)
      EXPECT_NEAR(strains.kappa[i] * c.beam.length, angle * axis[i], angle > 2 ? 1e-11 : 2e-15)
          << "angle " << angle;
  }
}

TEST(BeamElement, TangentIsTheDerivativeOfTheForce)
{
  for (int trial = 0; trial < 10; ++trial) {
    const Case c = random_case();
    // A turn on top of the orientations, below and above the switch between series and closed form.
    const Positions turn{random_vector(0.02), random_vector(0.4)};
    const BeamTangent tangent = beam_tangent(c.beam, c.x, c.q, turn);
    const auto force = [&](const Positions& x, const Positions& t) {
      return beam_force(c.beam, x,
                        {rotation_exponential(t[0]) * c.q[0], rotation_exponential(t[1]) * c.q[1]});
    };
    EXPECT_LT((tangent.force - force(c.x, turn)).norm(), 1e-13 * tangent.force.norm());
    for (int freedom = 0; freedom < 12; ++freedom) {
      const double step = 1e-5;
      Positions x[2] = {c.x, c.x}, t[2] = {turn, turn};
      for (int side = 0; side < 2; ++side) {
        Positions& moved = freedom % 6 < 3 ? x[side] : t[side];
        moved[freedom / 6][freedom % 3] += side == 0 ? step : -step;
      }
      const Eigen::Matrix<double, 12, 1> slope =
          (force(x[0], t[0]) - force(x[1], t[1])) / (2 * step);
      EXPECT_LT((tangent.stiffness.col(freedom) - slope).norm(), 3e-8 * tangent.stiffness.norm());
    }
  }
}

TEST(BeamElement, VectorLanesAgreeWithScalars)
{
  std::vector<Case> cases;
  BeamConstants<Wide> beam;
  BeamEnds<Wide> ends;
  for (int lane = 0; lane < wide_lanes; ++lane) {
    cases.push_back(random_case());
    const Case& c = cases.back();
    const BeamEnds<double> one = beam_ends(c.x, c.q);
    beam.length[lane] = c.beam.length;
    beam.inverse_length[lane] = c.beam.inverse_length;
    for (int i = 0; i < 3; ++i) {
      beam.force_stiffness[i][lane] = c.beam.force_stiffness[i];
      beam.moment_stiffness[i][lane] = c.beam.moment_stiffness[i];
      beam.bowing[i][lane] = c.beam.bowing[i];
      ends.x1[i][lane] = one.x1[i];
      ends.x2[i][lane] = one.x2[i];
    }
    for (int i = 0; i < 4; ++i) {
      beam.frame[i][lane] = c.beam.frame[i];
      ends.q1[i][lane] = one.q1[i];
      ends.q2[i][lane] = one.q2[i];
    }
  }
  const BeamEndLoads<Wide> wide = end_loads(beam_strains(ends, beam), beam);
  for (int lane = 0; lane < wide_lanes; ++lane) {
    const auto one = beam_force(cases[lane].beam, cases[lane].x, cases[lane].q);
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(wide.force1[i][lane], -one[i], 1e-14 * one.norm());
      EXPECT_NEAR(wide.torque1[i][lane], -one[3 + i], 1e-14 * one.norm());
      EXPECT_NEAR(wide.torque2[i][lane], -one[9 + i], 1e-14 * one.norm());
    }
  }
}
} // namespace
