// Ribs: signed distance of a rounded rectangle, one contact a line, hand-over at junctions. Fails
// when the nearest point, the choice of the rod or the merging of two lines at their junction is
// wrong.
#include "dem/ribs/rib_contacts.h"

#include "dem/random_stream.h"
#include "tests/rib_touch.h"

#include <gtest/gtest.h>

#include <numeric>

#include <limits>

using namespace interlock::dem;

namespace
{
Rib rib(const Vector3& a, const Vector3& b, int line)
{
  Rib result;
  result.line = line;
  result.half_width = 2.5e-3;
  result.half_thickness = 1.25e-3;
  result.rounding = 0.5e-3;
  result.x[0] = a;
  result.x[1] = b;
  result.width_axis[0] = result.width_axis[1] = Vector3::UnitZ().cross((b - a).normalized());
  return result;
}

ClumpShape ball(double radius)
{
  ClumpShape shape;
  shape.spheres = {{Vector3::Zero(), radius}};
  shape.volume = 4 * M_PI / 3 * std::pow(radius, 3);
  shape.unit_inertia = Vector3::Constant(0.4 * shape.volume * radius * radius);
  return shape;
}

ContactProperties elastic(double k)
{
  ContactProperties pair;
  pair.normal_stiffness = pair.tangential_stiffness = k;
  return pair;
}

// Two lines of two rods each that cross at the origin, along x and along y.
std::vector<Rib> cross()
{
  return {rib({-0.03, 0, 0}, {0, 0, 0}, 0), rib({0, 0, 0}, {0.03, 0, 0}, 0),
          rib({0, -0.03, 0}, {0, 0, 0}, 1), rib({0, 0, 0}, {0, 0.03, 0}, 1)};
}

struct Outcome {
  std::vector<RodLoads> loads;
  Vector3 force = Vector3::Zero();
};

Outcome press(const Vector3& centre, double radius)
{
  Clumps clumps({ball(radius)});
  clumps.add(0, 2650, centre, Quaternion::Identity());
  RibContacts contacts(elastic(1e6));
  ContactEnergy energy;
  const RibTouch touch = touch_ribs(contacts, clumps, cross(), 1e-6, energy);
  return {touch.loads, touch.clumps.force[0]};
}
} // namespace

TEST(Ribs, DistanceToARoundedRectangle)
{
  const Rib r = rib({0, 0, 0}, {0.01, 0, 0}, 0);
  // Above the flat face, beside the edge, off the corner, beyond the end.
  EXPECT_NEAR(rib_proximity(r, {0.005, 0.001, 0.006}, 0.005).overlap, 0.25e-3, 1e-15);
  EXPECT_NEAR(rib_proximity(r, {0.005, 0.007, 0}, 0.005).overlap, 0.5e-3, 1e-15);
  const Vector3 corner(0.005, 2e-3, 0.75e-3), out = Vector3(0, 1, 1).normalized();
  EXPECT_NEAR(rib_proximity(r, corner + 5e-3 * out, 0.005).overlap, 0.5e-3, 1e-15);
  EXPECT_NEAR(rib_proximity(r, {0.014, 0, 0}, 0.004).overlap, 0.5e-3, 1e-15);
  EXPECT_NEAR(rib_proximity(r, {0.0025, 0, 0.006}, 0.005).xi, 0.25, 1e-15);
}

// The normal is the gradient of the overlap, also on a rib whose section leans against its chord.
TEST(Ribs, NormalIsTheGradientOfTheOverlap)
{
  RandomStream random(1);
  for (int n = 0; n < 200; ++n) {
    Rib r = rib({0, 0, 0}, 0.01 * random.direction(), 0);
    r.width_axis[0] = r.width_axis[1] = random.direction();
    const Vector3 x = 0.008 * random.direction();
    const RibProximity p = rib_proximity(r, x, 0.004);
    if (p.distance < 1e-4) continue;
    for (int c = 0; c < 3; ++c) {
      Vector3 step = Vector3::Zero();
      step[c] = 1e-8;
      const double slope =
          (rib_proximity(r, x + step, 0.004).overlap - rib_proximity(r, x - step, 0.004).overlap) /
          2e-8;
      EXPECT_NEAR(slope, -p.normal[c], 1e-5);
    }
  }
}

TEST(Ribs, OneContactWhereRodsOfALineMeet)
{
  // Over the joint of the two rods of line 0, away from line 1.
  Clumps clumps({ball(5e-3)});
  clumps.add(0, 2650, {0.01, 0, 6e-3}, Quaternion::Identity());
  const std::vector<Rib> ribs = {rib({0, 0, 0}, {0.01, 0, 0}, 0),
                                 rib({0.01, 0, 0}, {0.02, 0, 0}, 0)};
  RibContacts contacts(elastic(1e6));
  ContactEnergy energy;
  const RibTouch touch = touch_ribs(contacts, clumps, ribs, 1e-6, energy);
  EXPECT_EQ(touch.loads.size(), 1u);
  EXPECT_NEAR(touch.clumps.force[0].z(), 1e6 * 0.25e-3, 1e-9);
}

TEST(Ribs, OneContactOnAJunctionTwoInItsCorner)
{
  // On top of the junction the two ribs are one body.
  const Outcome top = press({0.3e-3, -0.2e-3, 6e-3}, 5e-3);
  EXPECT_EQ(top.loads.size(), 1u);
  EXPECT_NEAR(top.force.z(), 1e6 * 0.25e-3, 1e-9);
  // In the corner between them it leans on both.
  const Outcome corner = press({7.4e-3, 7.4e-3, 0}, 5e-3);
  EXPECT_EQ(corner.loads.size(), 2u);
  EXPECT_NEAR(corner.force.x(), 100, 1e-9);
  EXPECT_NEAR(corner.force.y(), 100, 1e-9);
}

TEST(Ribs, LoadsAreTheReactionOfTheForceOnTheStone)
{
  const Outcome o = press({6e-3, 2.2e-3, 5.5e-3}, 5e-3);
  ASSERT_EQ(o.loads.size(), 1u);
  EXPECT_LT((o.loads[0].force[0] + o.loads[0].force[1] + o.force).norm(), 1e-12 * o.force.norm());
}

// Fails when the law of a rib's material is not Hertz's, with the radius of the sphere.
TEST(Ribs, ElasticRibsResistLikeHertz)
{
  const double radius = 5e-3, overlap = 0.1e-3;
  const Elastic rock{std::numeric_limits<double>::infinity(), 0}, rib{2.4e9, 0.3};
  Clumps clumps({ball(radius)});
  clumps.add(0, 2650, {0.015, 0, 1.25e-3 + radius - overlap}, Quaternion::Identity());
  RibContacts contacts(hertz_mindlin_pair(rock, rib, 0.5, 0));
  ContactEnergy energy;
  const RibTouch touch = touch_ribs(contacts, clumps, cross(), 1e-9, energy);
  const double force = 4. / 3 * 2.4e9 / (1 - 0.3 * 0.3) * std::sqrt(radius * overlap) * overlap;
  EXPECT_NEAR(touch.clumps.force[0].z(), force, 1e-9 * force);
  EXPECT_NEAR(energy.elastic, 0.4 * force * overlap, 1e-9 * force * overlap);
  const std::vector<double> stored = contacts.elastic_energies();
  EXPECT_NEAR(std::accumulate(stored.begin(), stored.end(), 0.), energy.elastic,
              1e-9 * energy.elastic);
  const TangentStiffness k = tangent_stiffness(contacts.properties(), overlap, radius);
  EXPECT_NEAR(k.normal, 1.5 * force / overlap, 1e-9 * k.normal);
}

// A clump that comes after the list was made must be found at the next update, wherever it comes.
TEST(Ribs, ListSeesNewClumps)
{
  Clumps clumps({ball(5e-3)});
  const std::vector<Rib> ribs = cross();
  clumps.add(0, 2650, {0.02, 0.05, 0.03}, Quaternion::Identity());
  RibContacts contacts(elastic(1e6));
  contacts.update_list(clumps, ribs, 1e-6);
  EXPECT_TRUE(contacts.near_clumps().empty());
  clumps.add(0, 2650, {0.015, 0, 6e-3}, Quaternion::Identity());
  ContactEnergy energy;
  EXPECT_EQ(touch_ribs(contacts, clumps, ribs, 1e-6, energy).loads.size(), 1u);
  EXPECT_EQ(contacts.near_clumps(), std::vector<int>{1});
}

// Ribs with sharp edges are one body at their junction too.
TEST(Ribs, SharpEdgesAreMergedToo)
{
  Clumps clumps({ball(5e-3)});
  clumps.add(0, 2650, {0.3e-3, -0.2e-3, 6e-3}, Quaternion::Identity());
  std::vector<Rib> ribs = cross();
  for (Rib& r : ribs) r.rounding = 0;
  RibContacts contacts(elastic(1e6));
  ContactEnergy energy;
  EXPECT_EQ(touch_ribs(contacts, clumps, ribs, 1e-6, energy).loads.size(), 1u);
}

// Along a twisted rod the overlap changes although the distance from the axis does not. Fails when
// the force on the stone is not the gradient of the energy in the contact.
TEST(Ribs, ForceIsTheGradientOfTheEnergyOnATwistedRod)
{
  Rib r = rib({0, 0, 0}, {8e-3, 1e-3, 0}, 0);
  const Vector3 along = (r.x[1] - r.x[0]).normalized();
  for (int end : {0, 1})
    r.width_axis[end] = Eigen::AngleAxisd((end - 0.4) * 0.3, along) * r.width_axis[end];
  for (const Vector3& x : {Vector3(4e-3, 2.2e-3, 5.9e-3), Vector3(3e-3, -7.1e-3, 0.3e-3),
                           Vector3(5e-3, 5.5e-3, -4e-3)}) {
    const RibProximity p = rib_proximity(r, x, 5e-3);
    for (int c = 0; c < 3; ++c) {
      const double step = 1e-7;
      const Vector3 shift = step * Vector3::Unit(c);
      const double slope =
          (rib_proximity(r, x + shift, 5e-3).overlap - rib_proximity(r, x - shift, 5e-3).overlap) /
          (2 * step);
      EXPECT_NEAR(p.normal[c] + p.lean[c], -slope, 1e-7) << x.transpose();
    }
    EXPECT_GT(p.lean.norm(), 1e-4);
  }
}

// A ball dragged to and fro over the rim of a junction, where one contact becomes two and two
// become one. Fails when a contact comes to life with energy that no work has put in.
TEST(Ribs, NoEnergyAppearsWhereTheLinesOfAJunctionPart)
{
  Clumps clumps({ball(5e-3)});
  const double height = 1.25e-3 + 5e-3 - 80e-6, step = 5e-7;
  clumps.add(0, 2650, {2.3e-3, 2.3e-3, height}, Quaternion::Identity());
  const std::vector<Rib> ribs = {rib({-0.03, 0, 0}, {0.03, 0, 0}, 0),
                                 rib({0, -0.03, 0}, {0, 0.03, 0}, 1)};
  RibContacts contacts(elastic(5.65e7));
  double work = 0, stored = 0;
  Vector3 last = Vector3::Zero();
  std::size_t most = 0;
  ContactEnergy energy;
  for (int k = 0; k < 12000; ++k) {
    const double a = 2.5e-3 - 0.2e-3 * std::cos(2 * M_PI * k / 4000);
    const Vector3 move = Vector3(a, a, height) - clumps.position[0];
    clumps.position[0] += move;
    clumps.velocity[0] = clumps.drift_velocity[0] = move / step;
    const RibTouch touch = touch_ribs(contacts, clumps, ribs, step, energy);
    most = std::max(most, touch.loads.size());
    const Vector3 force = touch.clumps.force[0];
    if (k == 0)
      stored = energy.elastic;
    else
      work += 0.5 * (force + last).dot(move); // on the ball
    last = force;
  }
  EXPECT_EQ(most, 2u);
  EXPECT_NEAR(work + energy.elastic - stored + energy.damping, 0, 1e-3 * stored);
  EXPECT_LT(energy.damping, stored);
}

// A bent and twisted rod with a ball on its edge, its side, and beyond its end: the loads on ball
// and rod ends against the energy in the contact, freedom by freedom. Spins turn the width axes.
class LoadsOfALaw : public testing::TestWithParam<ContactProperties>
{
};

TEST_P(LoadsOfALaw, AreTheGradientOfTheEnergy)
{
  Rib r = rib({0, 0, 0}, {8e-3, 1e-3, -0.5e-3}, 0);
  const Vector3 along = (r.x[1] - r.x[0]).normalized();
  for (int end : {0, 1})
    r.width_axis[end] = Eigen::AngleAxisd((end - 0.4) * 0.6, Vector3(0.5, 0.2, 0.8).normalized()) *
                        Eigen::AngleAxisd((end - 0.4) * 0.3, along) * r.width_axis[end];
  const double radius = 5e-3;
  const auto energy = [&](const Rib& rod, const Vector3& x) {
    return stored_energy(GetParam(), rib_proximity(rod, x, radius).overlap, radius, 0, {});
  };
  for (const Vector3& x : {Vector3(4e-3, 2.4e-3, 5.9e-3), Vector3(3e-3, -7.0e-3, 0.3e-3),
                           Vector3(5e-3, 5.5e-3, -4e-3), Vector3(12.6e-3, 2e-3, 1e-3)}) {
    ASSERT_GT(rib_proximity(r, x, radius).overlap, 0) << x.transpose();
    Clumps clumps({ball(radius)});
    clumps.add(0, 2650, x, Quaternion::Identity());
    RibContacts contacts(GetParam());
    ContactEnergy stored;
    const RibTouch touch = touch_ribs(contacts, clumps, std::vector<Rib>{r}, 1e-6, stored);
    ASSERT_EQ(touch.loads.size(), 1u);
    const RodLoads& loads = touch.loads[0];
    const Vector3 force = touch.clumps.force[0];
    EXPECT_LT(touch.clumps.torque[0].norm(), 1e-12 * force.norm());
    const double step = 1e-7, tolerance = 1e-4 * force.norm();
    for (int c = 0; c < 3; ++c) {
      const Vector3 by = step * Vector3::Unit(c);
      EXPECT_NEAR(force[c], -(energy(r, x + by) - energy(r, x - by)) / (2 * step), tolerance);
      for (int end : {0, 1}) {
        Rib up = r, down = r;
        up.x[end] += by;
        down.x[end] -= by;
        EXPECT_NEAR(loads.force[end][c], -(energy(up, x) - energy(down, x)) / (2 * step),
                    tolerance);
        const double turn = 1e-5;
        up = down = r;
        const Eigen::AngleAxisd left(turn, Vector3::Unit(c)), right(-turn, Vector3::Unit(c));
        up.width_axis[end] = left * r.width_axis[end];
        down.width_axis[end] = right * r.width_axis[end];
        EXPECT_NEAR(loads.moment[end][c], -(energy(up, x) - energy(down, x)) / (2 * turn),
                    1e-2 * tolerance);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Ribs, LoadsOfALaw,
    testing::Values(elastic(5.65e7),
                    hertz_mindlin_pair({std::numeric_limits<double>::infinity(), 0}, {2.4e9, 0.3},
                                       0.5, 0)),
    [](const auto& info) { return info.index == 0 ? "linear" : "hertz_mindlin"; });
