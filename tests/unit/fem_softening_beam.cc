// The beam element kernel with softening, yield and plastic stretch, on strongly strained random
// elements. Fails when the force is not minus the gradient of stored energy and plastic work, when
// the tangent is not its derivative, when rigid motion changes anything, when vector lanes and
// scalars disagree, or when linear constants do not give the linear element.

// GCC 12 warns in its own header about the undefined operand of vector square roots (GCC bug
// 105593).
#pragma GCC diagnostic ignored "-Wuninitialized"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"

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
using Vector12 = Eigen::Matrix<double, 12, 1>;

struct Case {
  BeamConstants<double> beam;
  std::array<Vector3d, 2> x;
  std::array<Quaterniond, 2> q;
  BeamStrains<double> strains() const { return beam_strains(beam_ends(x, q), beam); }
};

std::mt19937 generator(7);

Vector3d random_vector(double size)
{
  std::uniform_real_distribution<double> uniform(-size, size);
  return {uniform(generator), uniform(generator), uniform(generator)};
}

const double axial = 10, softening = 3, yield_force = 1.6;

// On the envelope (plastic stretch zero, force below yield), in yield, or on an unloading line.
enum class Branch { envelope, yield, unloading };

Case random_case(Branch branch)
{
  Case c;
  const Quaterniond frame = rotation_exponential(random_vector(2));
  const double h = 0.3, stretch = branch == Branch::yield ? 0.5 : 0.15;
  c.beam = {h,
            1 / h,
            {frame.w(), frame.x(), frame.y(), frame.z()},
            {axial, 4, 5},
            {1, 2, 3},
            {1.1, 0.7, 0.01},
            softening,
            yield_force / axial,
            branch == Branch::unloading ? 0.4 : 0};
  c.q[0] = rotation_exponential(random_vector(1.5));
  c.q[1] = rotation_exponential(random_vector(0.3)) * c.q[0];
  c.x[0] = random_vector(1);
  c.x[1] = c.x[0] + c.q[0] * frame * (h * (Vector3d(1 + stretch, 0, 0) + random_vector(0.05)));
  return c;
}

double stored_and_lost(const Case& c)
{
  const BeamStrains<double> strains = c.strains();
  return strain_energy(strains, c.beam) +
         c.beam.length *
             plastic_work({axial, softening, yield_force}, plastic_stretch(strains, c.beam));
}

void move(Case& c, int freedom, double by)
{
  const int node = freedom / 6, component = freedom % 6;
  if (component < 3)
    c.x[node][component] += by;
  else
    c.q[node] = rotation_exponential(by * Vector3d::Unit(component - 3)) * c.q[node];
}

TEST(SofteningBeam, CasesAreOnTheirBranches)
{
  for (int trial = 0; trial < 20; ++trial) {
    const Case on = random_case(Branch::envelope), in = random_case(Branch::yield),
               off = random_case(Branch::unloading);
    EXPECT_GT(plastic_stretch(on.strains(), on.beam), 0.01);
    EXPECT_LT(section_force(on.strains(), on.beam)[0], yield_force);
    EXPECT_NEAR(section_force(in.strains(), in.beam)[0], yield_force, 1e-14);
    EXPECT_EQ(plastic_stretch(off.strains(), off.beam), off.beam.plastic_stretch);
  }
}

TEST(SofteningBeam, ForcesAreMinusTheGradientOfStoredAndLostEnergy)
{
  for (const Branch branch : {Branch::envelope, Branch::yield, Branch::unloading})
    for (int trial = 0; trial < 10; ++trial) {
      const Case c = random_case(branch);
      const Vector12 force = beam_force(c.beam, c.x, c.q);
      for (int freedom = 0; freedom < 12; ++freedom) {
        Case up = c, down = c;
        const double step = 1e-5;
        move(up, freedom, step);
        move(down, freedom, -step);
        const double slope = (stored_and_lost(up) - stored_and_lost(down)) / (2 * step);
        EXPECT_NEAR(force[freedom], slope, 5e-9 * force.norm());
      }
    }
}

TEST(SofteningBeam, TangentIsTheDerivativeOfTheForce)
{
  for (const Branch branch : {Branch::envelope, Branch::yield, Branch::unloading})
    for (int trial = 0; trial < 10; ++trial) {
      const Case c = random_case(branch);
      const BeamTangent tangent =
          beam_tangent(c.beam, c.x, c.q, {Vector3d::Zero(), Vector3d::Zero()});
      EXPECT_LT((tangent.force - beam_force(c.beam, c.x, c.q)).norm(),
                1e-13 * tangent.force.norm());
      for (int freedom = 0; freedom < 12; ++freedom) {
        Case up = c, down = c;
        const double step = 1e-5;
        move(up, freedom, step);
        move(down, freedom, -step);
        const Vector12 slope =
            (beam_force(c.beam, up.x, up.q) - beam_force(c.beam, down.x, down.q)) / (2 * step);
        EXPECT_LT((tangent.stiffness.col(freedom) - slope).norm(), 3e-8 * tangent.stiffness.norm());
      }
    }
}

TEST(SofteningBeam, TenTurnsAndATranslationChangeNothing)
{
  for (const Branch branch : {Branch::envelope, Branch::yield, Branch::unloading})
    for (int trial = 0; trial < 10; ++trial) {
      const Case c = random_case(branch);
      Case moved = c;
      const Vector3d axis = random_vector(1).normalized();
      const Quaterniond increment = rotation_exponential(0.1 * M_PI * axis);
      for (int i = 0; i < 200; ++i) // in increments, with the history committed as a solver would
        for (int v = 0; v < 2; ++v) {
          moved.q[v] = (increment * moved.q[v]).normalized();
          moved.x[v] = increment * moved.x[v] + Vector3d(0.01, -0.02, 0.03);
        }
      moved.beam.plastic_stretch = plastic_stretch(moved.strains(), moved.beam);
      EXPECT_NEAR(moved.beam.plastic_stretch, plastic_stretch(c.strains(), c.beam), 1e-12);
      EXPECT_NEAR(stored_and_lost(moved), stored_and_lost(c), 1e-12 * stored_and_lost(c));
      EXPECT_NEAR(section_force(moved.strains(), moved.beam)[0],
                  section_force(c.strains(), c.beam)[0], 1e-11);
    }
}

TEST(SofteningBeam, VectorLanesAgreeWithScalars)
{
  std::vector<Case> cases;
  BeamConstants<Wide> beam;
  BeamEnds<Wide> ends;
  const Branch branches[] = {Branch::envelope, Branch::yield, Branch::unloading};
  for (int lane = 0; lane < wide_lanes; ++lane) {
    cases.push_back(random_case(branches[lane % 3]));
    const Case& c = cases.back();
    const BeamEnds<double> one = beam_ends(c.x, c.q);
    beam.length[lane] = c.beam.length;
    beam.inverse_length[lane] = c.beam.inverse_length;
    beam.softening[lane] = c.beam.softening;
    beam.yield_stretch[lane] = c.beam.yield_stretch;
    beam.plastic_stretch[lane] = c.beam.plastic_stretch;
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
  const BeamStrains<Wide> strains = beam_strains(ends, beam);
  const BeamEndLoads<Wide> wide = end_loads(strains, beam);
  const Wide plastic = plastic_stretch(strains, beam);
  for (int lane = 0; lane < wide_lanes; ++lane) {
    const Case& c = cases[lane];
    const Vector12 one = beam_force(c.beam, c.x, c.q);
    EXPECT_NEAR(plastic[lane], plastic_stretch(c.strains(), c.beam), 1e-15);
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(wide.force1[i][lane], -one[i], 2e-14 * one.norm());
      EXPECT_NEAR(wide.torque1[i][lane], -one[3 + i], 2e-14 * one.norm());
      EXPECT_NEAR(wide.torque2[i][lane], -one[9 + i], 2e-14 * one.norm());
    }
  }
}

// Elements that neither soften nor yield, and have no history: same digits as the linear kernel.
TEST(SofteningBeam, LinearConstantsGiveTheLinearElement)
{
  for (int trial = 0; trial < 20; ++trial) {
    Case c = random_case(Branch::envelope);
    c.beam.softening = 0;
    c.beam.yield_stretch = std::numeric_limits<double>::infinity();
    const BeamEndLoads<double> linear = end_loads<Tension::linear>(c.strains(), c.beam),
                               law = end_loads<Tension::softening>(c.strains(), c.beam);
    EXPECT_EQ(linear.force1, law.force1);
    EXPECT_EQ(linear.torque1, law.torque1);
    EXPECT_EQ(linear.torque2, law.torque2);
    EXPECT_EQ(strain_energy<Tension::linear>(c.strains(), c.beam),
              strain_energy<Tension::softening>(c.strains(), c.beam));
    EXPECT_EQ(plastic_stretch(c.strains(), c.beam), 0);
  }
}
} // namespace
