// What the next step of a whole world needs is in its field list. A state is written in the middle
// of contacts of ribs with stones and walls, read into a world that was made from nothing, and both
// go on. Fails when any digit of either differs later: of the stones, of the lattice, of what a rib
// contact remembers or of an entry of the ledger.
#include "coupling/loop/world.h"
#include "tests/carry_over.h"
#include "tests/cross_of_ribs.h"
#include "tests/dem_bodies.h"
#include "tests/temporary_folder.h"

#include <algorithm>
#include <memory>

using namespace interlock;
using namespace carry;
using dem::Engine;
using dem::Vector3;

namespace
{
dem::ClumpShape three_balls()
{
  dem::ClumpShape shape;
  shape.spheres = {{Vector3(0.005, 0.001, 0), 0.008},
                   {Vector3(-0.006, 0, 0.001), 0.007},
                   {Vector3(0, 0.004, 0.002), 0.006}};
  shape.volume = 6e-6;
  shape.unit_inertia = Vector3(2.2, 2.9, 3.6) * 1e-10;
  return shape;
}

// The rib along x lies on the edge of a slot, and where x > 0 both lie with their middle plane on
// the floor.
std::unique_ptr<RibTransfer> geogrid()
{
  RibBox box;
  box.length = box.width = 1;
  box.slot_bottom = -0.5 * cross_of_ribs::rib_section().thickness;
  box.slot_top = 0.01;
  box.contact = cross_of_ribs::contact(0.1);
  return std::make_unique<RibTransfer>(cross_of_ribs::cross(12, 100, box));
}

std::unique_ptr<World> empty_world()
{
  const dem::ContactProperties pair = cross_of_ribs::contact(0.1);
  return std::make_unique<World>(std::vector<dem::ClumpShape>(), dem::ContactProperties(), pair, 0);
}

// A ball on the crossing with another one on top, and a clump that spins on a rib, while the clamp
// pulls.
std::unique_ptr<World> start(double local_damping)
{
  const dem::ContactProperties pair = cross_of_ribs::contact(0.1);
  auto world = std::make_unique<World>(
      std::vector<dem::ClumpShape>{cross_of_ribs::ball(0.011), three_balls()}, pair, pair, 9.81);
  Engine& engine = world->engine;
  engine.set_local_damping(local_damping);
  const double surface = 0.5 * cross_of_ribs::rib_section().thickness;
  engine.add_clump(0, 2650, {5e-4, 2e-4, surface + 0.011 + 1e-5}, dem::Quaternion::Identity(),
                   {0.05, 0, -0.2});
  engine.add_clump(0, 2650, {2e-3, 0, surface + 0.033 + 1e-5}, dem::Quaternion::Identity(),
                   {0, 0, -0.3});
  const int i = engine.add_clump(1, 2650, {0.035, 5e-4, surface + 0.008 + 2e-5},
                                 dem::Quaternion::Identity(), {0.01, 0.02, -0.2});
  bodies::set_spin(engine, i, Vector3(0.3, 0.2, 4));
  engine.add_clump(1, 2650, {0.3, 0, 0.5}, dem::Quaternion::Identity()); // far from all ribs
  world->clock.set_step(2.5e-6);
  world->clamp_velocity = {0.05, 0, 0};
  world->place_geogrid(geogrid());
  return world;
}

void run(World& world, int steps)
{
  for (int n = 0; n < steps; ++n) {
    world.compute_forces();
    world.move();
  }
}

std::unique_ptr<World> carried_over(const World& world, const std::filesystem::path& file)
{
  std::unique_ptr<World> next = empty_world();
  next->attach_geogrid(geogrid());
  carry_over(world, *next, file);
  return next;
}

class WorldState : public TemporaryFolderTest, public testing::WithParamInterface<double>
{
protected:
  std::unique_ptr<World> in_the_middle() const
  {
    std::unique_ptr<World> world = start(GetParam());
    for (int n = 0; n < 4000; ++n) {
      run(*world, 1);
      int rubbing = 0;
      for (const dem::RibContact& c : world->ribs.rib_contacts().contacts())
        rubbing += c.overlap > 0 && c.history.spring.norm() > 0;
      int at_walls = 0;
      for (const RibTouch& touch : world->geogrid()->walls()->touches())
        at_walls += touch.history.overlap > 0 && touch.history.spring.norm() > 0;
      if (rubbing >= 1 && at_walls >= 2 && world->engine.n_touching_spheres() >= 1) return world;
    }
    ADD_FAILURE()
        << "there was no moment with contacts of a rib with a stone and walls and one of stones";
    return world;
  }
};
INSTANTIATE_TEST_SUITE_P(LocalDamping, WorldState, testing::Values(0., 0.5),
                         [](const auto& share) { return share.param > 0 ? "On" : "Off"; });

void expect_same_ledgers(World& a, World& b)
{
  a.compute_forces();
  b.compute_forces();
  const auto p = a.ledger().entries(), q = b.ledger().entries();
  for (std::size_t k = 0; k < p.size(); ++k) EXPECT_EQ(p[k].second, q[k].second) << p[k].first;
  EXPECT_EQ(a.ribs.clamp_force(), b.ribs.clamp_force());
  EXPECT_EQ(a.ribs.substeps(), b.ribs.substeps());
  EXPECT_EQ(a.clock.time(), b.clock.time());
  a.move();
  b.move();
}
} // namespace

TEST_P(WorldState, GoesOnWithTheSameDigits)
{
  const std::unique_ptr<World> one = in_the_middle();
  const std::unique_ptr<World> two = carried_over(*one, folder / "state.h5");
  ASSERT_FALSE(HasFatalFailure());
  for (int hundred = 1; hundred <= 5; ++hundred) {
    run(*one, 99);
    run(*two, 99);
    expect_same_ledgers(*one, *two);
    ASSERT_NO_FATAL_FAILURE(
        expect_same(*one, *two, std::to_string(100 * hundred) + " steps later"));
  }
}

// From before the first touch to after it, cut at uneven places.
TEST_P(WorldState, ManyInterruptionsChangeNoDigit)
{
  const std::unique_ptr<World> one = start(GetParam());
  std::unique_ptr<World> many = start(GetParam());
  double deepest = 0; // [m]
  for (int part = 0; part < 40; ++part) {
    many = carried_over(*many, folder / "state.h5");
    run(*one, 1 + part % 23);
    run(*many, 1 + part % 23);
    ASSERT_NO_FATAL_FAILURE(expect_same(*one, *many, "part " + std::to_string(part)));
    deepest = std::max(deepest, many->largest_overlap());
  }
  EXPECT_GT(deepest, 0);
}

// The stone that is sub-cycled with the ribs goes; the indices of the others shift.
TEST_P(WorldState, LaterRemovalsHaveTheSameDigits)
{
  const std::unique_ptr<World> one = in_the_middle();
  const std::unique_ptr<World> two = carried_over(*one, folder / "state.h5");
  ASSERT_FALSE(HasFatalFailure());
  for (World* world : {one.get(), two.get()}) {
    world->remove({true, false, false, false});
    run(*world, 200);
  }
  ASSERT_NO_FATAL_FAILURE(expect_same(*one, *two, "after the removal"));
  expect_same_ledgers(*one, *two);
}
