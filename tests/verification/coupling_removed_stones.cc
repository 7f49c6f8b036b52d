// Stones that are taken out while a geogrid is in place. It takes energy that goes with them and is
// not booked, or another stone or a rib that moves on in another way although the stone had nothing
// to do with them, to fail.
#include "coupling/loop/staggered_step.h"
#include "tests/cross_of_ribs.h"

#include <gtest/gtest.h>

using namespace cross_of_ribs;

namespace
{
constexpr double radius = 0.012, gravity = 9.81, dt = 2.5e-6;
constexpr double rounding = 1e-10; // of the radius, of 1 m/s

// A ball that lies on a plate far from the ribs (index 0), one that falls on the crossing, and one
// that falls on the edge of a rib.
struct World {
  World(const dem::ContactProperties& pair, double local_damping)
      : geogrid(cross(16)), engine({ball(radius)}, pair, gravity), loop(engine, pair)
  {
    const double mass = 2650 * ball(radius).volume, k = 1e5;
    dem::ContactProperties soft;
    soft.normal_stiffness = soft.tangential_stiffness = k;
    engine.add_wall(dem::rectangle_wall("plate", {0.9, -0.1, -1}, {0.2, 0, 0}, {0, 0.2, 0}, soft));
    const double on_ribs = 0.5 * rib_section().thickness + radius;
    for (const Vector3& place :
         {Vector3(1, 0, -1 + radius - mass * gravity / k), Vector3(0, 0, on_ribs + 1e-3),
          Vector3(0.04, 2e-3, on_ribs + 5e-4)})
      engine.add_clump(0, 2650, place, dem::Quaternion::Identity());
    engine.set_local_damping(local_damping);
    loop.place_geogrid(geogrid);
  }

  void run(int steps)
  {
    for (int n = 0; n < steps; ++n) loop.advance(dt, Vector3::Zero());
  }
  // Taken at the beginning of one more step.
  coupling::EnergyLedger ledger()
  {
    coupling::EnergyLedger result;
    loop.advance(dt, Vector3::Zero(), &result);
    return result;
  }
  // In the normal springs of a clump at the ribs [J].
  double stored(int clump) const
  {
    double sum = 0;
    for (const dem::RibContact& c : loop.rib_contacts().contacts())
      if (c.i == clump)
        sum += 0.5 * loop.rib_contacts().properties().normal_stiffness * c.overlap * c.overlap;
    return sum;
  }

  coupling::RibTransfer geogrid;
  dem::Engine engine;
  coupling::StaggeredStep loop;
};

void expect_same(const World& a, int i, const World& b, int j)
{
  const dem::Clumps &p = a.engine.clumps(), &q = b.engine.clumps();
  EXPECT_EQ(p.id[i], q.id[j]);
  EXPECT_LT((p.position[i] - q.position[j]).norm(), rounding * radius);
  EXPECT_LT((p.orientation[i].coeffs() - q.orientation[j].coeffs()).norm(), rounding);
  EXPECT_LT((p.velocity[i] - q.velocity[j]).norm(), rounding);
  EXPECT_LT((p.angular_momentum[i] - q.angular_momentum[j]).norm(), rounding * p.mass[i] * radius);
}
} // namespace

// The ball on the crossing has bent the ribs and squeezed its contact when it goes. Its own energy
// and that of its contact leave the ledger; what the ribs have stored stays, and swings on.
TEST(RemovedStones, LedgerClosesWhenAStoneGoesFromARib)
{
  dem::ContactProperties soft = contact(0.1); // stores as much as the ribs
  soft.normal_stiffness = soft.tangential_stiffness = 2e4;
  World world(soft, 0);
  const double fall = 2650 * ball(radius).volume * gravity * (1e-3 + 5e-4); // of both balls
  for (int n = 0; n < 20000 && world.stored(1) < 5e-2 * fall; ++n) world.run(1);
  ASSERT_GE(world.stored(1), 5e-2 * fall); // or the checks below would not see it
  const coupling::EnergyLedger before = world.ledger();
  ASSERT_GT(before.elastic_geogrid, 5e-3 * fall);
  world.loop.remove_clumps({false, true, false});
  ASSERT_EQ(world.engine.clumps().size(), 2);
  const coupling::EnergyLedger after = world.ledger();
  EXPECT_NEAR(after.residual(), before.residual(), 1e-3 * fall);
  EXPECT_NEAR(after.interface_residual(), before.interface_residual(), 1e-3 * fall);
  world.run(20000);
  const coupling::EnergyLedger end = world.ledger();
  EXPECT_NEAR(end.residual(), before.residual(), 2e-2 * fall);
  EXPECT_NEAR(end.interface_residual(), before.interface_residual(), 2e-2 * fall);
}

// The ball on the plate comes first, so that all other indices change when it goes. Local damping
// goes by forces of the ribs of the step before: they must move along with their stones.
TEST(RemovedStones, OthersMoveOnAsBefore)
{
  for (const double local_damping : {0., 0.5}) {
    World with(contact(0.1), local_damping), without(contact(0.1), local_damping),
        nobody(contact(0.1), local_damping);
    for (World* world : {&with, &without, &nobody}) world->run(8000);
    ASSERT_GT(with.stored(1) + with.stored(2), 0);
    without.loop.remove_clumps({true, false, false});
    nobody.loop.remove_clumps({false, false, false});
    for (World* world : {&with, &without, &nobody}) world->run(2000);
    for (const int i : {1, 2}) {
      expect_same(with, i, without, i - 1);
      expect_same(with, i, nobody, i);
    }
    for (int node = 0; node < with.geogrid.lattice().n_nodes(); ++node)
      for (const World* other : {&without, &nobody})
        EXPECT_LT(
            (with.geogrid.dynamics().position(node) - other->geogrid.dynamics().position(node))
                .norm(),
            rounding * radius);
  }
}
