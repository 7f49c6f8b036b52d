// Inserting clumps without overlap. It takes a place that is called free although member spheres
// overlap, or taken although none does (random clumps against all pairs of spheres, in poses where
// the bounding balls overlap), a wall or a clearance that is not seen, to fail.
#include "dem/engine/engine.h"
#include "dem/engine/insertion.h"
#include "dem/random_stream.h"

#include <gtest/gtest.h>

using namespace interlock::dem;

namespace
{
ClumpShape ball(double radius)
{
  ClumpShape shape;
  shape.spheres = {{Vector3::Zero(), radius}};
  shape.volume = 4 * M_PI / 3 * radius * radius * radius;
  shape.unit_inertia = Vector3::Constant(0.4 * shape.volume * radius * radius);
  return shape;
}

// A crooked rod of 8 spheres, much smaller than its bounding ball.
ClumpShape rod(RandomStream& random)
{
  ClumpShape shape = ball(0.02);
  shape.spheres.clear();
  for (int a = 0; a < 8; ++a)
    shape.spheres.push_back({0.006 * (a - 3.5) * Vector3::UnitX() + 0.002 * random.direction(),
                             random.uniform(4e-3, 6e-3)});
  return shape;
}

Quaternion attitude(RandomStream& random)
{
  return Quaternion(Eigen::AngleAxisd(random.uniform(0, 2 * M_PI), random.direction()));
}

Vector3 place(RandomStream& random)
{
  return {random.uniform(0, 0.12), random.uniform(0, 0.12), random.uniform(0, 0.12)};
}

const ContactProperties contact = [] {
  ContactProperties pair;
  pair.normal_stiffness = pair.tangential_stiffness = 1e6;
  pair.friction = 0.5;
  pair.damping_ratio = 0.1;
  return pair;
}();
} // namespace

TEST(Insertion, AgreesWithAllPairsOfSpheres)
{
  RandomStream random(1);
  Engine engine({rod(random), rod(random), rod(random)}, contact, 9.81);
  int free = 0, taken = 0, free_inside_balls = 0;
  for (int attempt = 0; attempt < 3000 && engine.clumps().size() < 60; ++attempt) {
    const int shape = random.index(3);
    const Vector3 x = place(random);
    const Quaternion q = attitude(random);
    const bool is_free = place_is_free(engine.clumps(), {}, engine.clumps().shapes()[shape], x, q);
    const int i = engine.add_clump(shape, 2650, x, q);
    EXPECT_EQ(engine.count_overlaps_brute_force() == 0, is_free);
    ++(is_free ? free : taken);
    if (is_free) {
      for (int j = 0; j < i; ++j)
        if ((engine.clumps().position[j] - x).norm() <
            engine.clumps().bounding_radius(i) + engine.clumps().bounding_radius(j)) {
          ++free_inside_balls;
          break;
        }
    } else {
      std::vector<bool> remove(engine.clumps().size(), false);
      remove[i] = true;
      engine.remove_clumps(remove);
    }
  }
  // All three answers came up often.
  EXPECT_EQ(free, 60);
  EXPECT_GT(free_inside_balls, 20);
  EXPECT_GT(taken, 100);
}

TEST(Insertion, BallsMayTouchAndKeepTheirClearance)
{
  Clumps clumps({ball(0.25)});
  clumps.add(0, 1, Vector3::Zero(), Quaternion::Identity());
  const auto free = [&](double x, double clearance) {
    return place_is_free(clumps, {}, clumps.shapes()[0], {x, 0, 0}, Quaternion::Identity(),
                         clearance);
  };
  EXPECT_TRUE(free(0.5, 0));
  EXPECT_FALSE(free(std::nextafter(0.5, 0.), 0));
  EXPECT_TRUE(free(0.75, 0.25));
  EXPECT_FALSE(free(std::nextafter(0.75, 0.), 0.25));
}

TEST(Insertion, WallsAreInTheWay)
{
  const Clumps clumps({ball(0.25)});
  Wall floor;
  floor.corner = {-1, -1, 0};
  floor.edge1 = {2, 0, 0};
  floor.edge2 = {0, 2, 0};
  const auto free = [&](const Vector3& x) {
    return place_is_free(clumps, {floor}, clumps.shapes()[0], x, Quaternion::Identity());
  };
  EXPECT_TRUE(free({0, 0, 0.25}));
  EXPECT_FALSE(free({0, 0, 0.249}));
  EXPECT_FALSE(free({0, 0, -0.1}));
  EXPECT_TRUE(free({1.26, 0, 0})); // beside the rim
  EXPECT_FALSE(free({1.24, 0, 0}));
}
