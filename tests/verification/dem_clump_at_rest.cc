// A clump that lands on a rough plane on three of its spheres comes to rest, through the engine.
//
// At rest the plane carries the weight, and the three normal forces follow from the balance of
// moments alone, as the tangential ones lie in one plane (but for the depth of the overlaps) and
// sum to zero. Energy that went in came out through dashpots and friction. Fails when springs
// creep, when a torque is left over, or when the ledger leaks. Rest is to rounding; the ledger is
// second order in the step.
#include "tests/dem_bodies.h"

using namespace bodies;

namespace
{
constexpr double g = 9.81, density = 2600, dt = 2e-6;

// Three feet of different radii, and a heavy body above them that leans to one side and has moments
// and axes of its own.
ClumpShape tripod()
{
  ClumpShape shape;
  shape.spheres = {{{0.012, 0.001, -0.01}, 0.003},
                   {{-0.006, 0.010, -0.009}, 0.004},
                   {{-0.004, -0.011, -0.011}, 0.002},
                   {{0.001, 0.000, 0.002}, 0.011}};
  shape.volume = ball(0.012).volume;
  shape.unit_inertia = ball(0.012).unit_inertia.cwiseProduct(Vector3(0.8, 1, 1.3));
  return shape;
}
} // namespace

TEST(ClumpAtRest, ThreeFeetCarryTheWeight)
{
  ContactProperties contact = smooth_contact(1e6, 0.3, false);
  contact.tangential_stiffness = 7e5;
  contact.friction = 0.5;
  Engine engine({tripod()}, {}, g);
  engine.add_wall(plane(contact));
  engine.add_clump(0, density, {0, 0, 0.0155}, Quaternion(Eigen::AngleAxisd(0.1, Vector3::UnitX())),
                   {0.02, -0.01, 0});
  set_spin(engine, 0, {0, 0, 2});
  const Clumps& clumps = engine.clumps();
  const double weight = clumps.mass[0] * g;
  engine.compute_forces(dt);
  const EngineEnergy start = engine.energy(dt);

  for (int n = 0; n < 250000; ++n) engine.step(dt);
  const Vector3 x = clumps.position[0];
  const Quaternion q = clumps.orientation[0];
  for (int n = 0; n < 100000; ++n) engine.step(dt);
  EXPECT_LT((clumps.position[0] - x).norm(), 1e-13);
  EXPECT_LT(clumps.orientation[0].angularDistance(q), 1e-10);
  EXPECT_LT((clumps.force[0] - Vector3(0, 0, weight)).norm(), 1e-9 * weight);
  EXPECT_LT((engine.walls()[0].force + Vector3(0, 0, weight)).norm(), 1e-9 * weight);
  EXPECT_LT(clumps.torque[0].norm(), 1e-9 * weight * 0.01);

  Matrix3 balance; // of forces along z and of moments about x and y
  Vector3 normal;
  int n = 0;
  for (const WallContact& c : engine.wall_contacts()) {
    if (!c.touching) continue;
    ASSERT_LT(n, 3);
    const Vector3 arm = clumps.member_offset(0, c.a);
    balance.col(n) = Vector3(1, arm.y(), -arm.x());
    normal[n++] = c.force.z();
    EXPECT_LE(std::hypot(c.force.x(), c.force.y()), 0.5 * c.force.z() * (1 + 1e-9));
  }
  ASSERT_EQ(n, 3);
  const Vector3 expected = balance.inverse() * Vector3(weight, 0, 0);
  EXPECT_LT((normal - expected).norm(), 1e-6 * weight);
  record("normal_force_error", (normal - expected).norm() / weight);

  const EngineEnergy end = engine.energy(dt);
  EXPECT_LT(end.kinetic, 1e-18 * start.kinetic);
  const double lost = start.kinetic + start.gravitational - end.gravitational;
  const double found = end.contact.elastic + end.contact.friction + end.contact.damping;
  EXPECT_NEAR(found, lost, 1e-4 * lost);
  record("energy_error", found / lost - 1);
  record("kinetic_share", end.kinetic / start.kinetic);
}
