// The nested lists against brute force, on random clumps that fly through each other's reach. Fails
// when a skin, a displacement bound or the slab filter loses a pair, or when lists change a digit.
#include "dem/engine/engine.h"
#include "dem/random_stream.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace interlock::dem;

namespace
{
ClumpShape random_shape(RandomStream& random, int n_spheres)
{
  ClumpShape shape;
  for (int a = 0; a < n_spheres; ++a)
    shape.spheres.push_back({random.direction().cwiseProduct(Vector3(0.014, 0.010, 0.007)),
                             random.uniform(0.003, 0.007)});
  shape.volume = 2e-5;
  shape.unit_inertia = Vector3(1.2, 1.6, 2.1) * 1e-9;
  return shape;
}

// A crowd at random places and attitudes, thrown at 1 m/s and 40 rad/s (rms).
Engine crowd(std::uint64_t seed)
{
  RandomStream random(seed);
  ContactProperties soft;
  soft.normal_stiffness = soft.tangential_stiffness = 1e4;
  soft.friction = 0.5;
  soft.damping_ratio = 0.1;
  Engine engine({random_shape(random, 25), random_shape(random, 40)}, soft, 9.81);
  for (int n = 0; n < 60; ++n) {
    const Vector3 place(random.uniform(0, 0.15), random.uniform(0, 0.15),
                        random.uniform(0.03, 0.15));
    const Eigen::AngleAxisd turn(random.uniform(0, 3), random.direction());
    const int i = engine.add_clump(n % 2, 2650, place, Quaternion(turn), random.direction());
    engine.clumps().angular_momentum[i] =
        40 * engine.clumps().inertia[i].mean() * random.direction();
    engine.clumps().spin[i] = engine.clumps().spin_of(i, engine.clumps().angular_momentum[i]);
  }
  Wall floor;
  floor.corner = {-1, -1, 0};
  floor.edge1 = {2, 0, 0};
  floor.edge2 = {0, 2, 0};
  floor.contact = soft;
  engine.add_wall(floor);
  return engine;
}

int wall_overlaps_brute_force(const Engine& engine)
{
  int count = 0;
  for (int i = 0; i < engine.clumps().size(); ++i)
    for (std::size_t a = 0; a < engine.clumps().shape_of(i).spheres.size(); ++a) {
      const Vector3 x = engine.clumps().position[i] + engine.clumps().member_offset(i, a);
      const Wall& wall = engine.walls()[0];
      if ((x - wall.nearest_point(x)).norm() < engine.clumps().shape_of(i).spheres[a].radius)
        ++count;
    }
  return count;
}
} // namespace

TEST(NeighbourLists, MissNothing)
{
  Engine engine = crowd(3);
  const double dt = 2e-5;
  int checks_with_contacts = 0;
  for (int n = 0; n < 3000; ++n) {
    engine.step(dt);
    if (n % 50 != 0) continue;
    engine.compute_forces(0);
    ASSERT_EQ(engine.n_touching_spheres(), engine.count_overlaps_brute_force()) << "step " << n;
    const std::vector<WallContact> at_wall = engine.wall_contacts();
    const auto on_wall = std::count_if(at_wall.begin(), at_wall.end(),
                                       [](const WallContact& c) { return c.touching; });
    ASSERT_EQ(on_wall, wall_overlaps_brute_force(engine)) << "step " << n;
    if (engine.n_touching_spheres() > 50) ++checks_with_contacts;
  }
  EXPECT_GT(checks_with_contacts, 30);
}

TEST(NeighbourLists, ContactsAreSortedAndUnique)
{
  Engine engine = crowd(4);
  std::size_t touching = 0, partners = 0, at_wall = 0;
  for (int n = 0; n < 3000; ++n) {
    engine.step(2e-5);
    if (n % 20 != 0) continue;
    const std::vector<SphereContact> contacts = engine.sphere_contacts();
    for (std::size_t c = 1; c < contacts.size(); ++c) {
      ASSERT_LT(
          std::tie(contacts[c - 1].i, contacts[c - 1].j, contacts[c - 1].a, contacts[c - 1].b),
          std::tie(contacts[c].i, contacts[c].j, contacts[c].a, contacts[c].b));
      // Pairs with the same first clump are what an unsorted list would mix.
      partners += contacts[c - 1].i == contacts[c].i && contacts[c - 1].j != contacts[c].j;
    }
    for (const SphereContact& c : contacts) {
      ASSERT_LT(c.i, c.j);
      touching += c.touching;
    }
    const std::vector<WallContact> walls = engine.wall_contacts();
    for (std::size_t c = 1; c < walls.size(); ++c)
      ASSERT_LT(std::tie(walls[c - 1].wall, walls[c - 1].i, walls[c - 1].a),
                std::tie(walls[c].wall, walls[c].i, walls[c].a));
    at_wall += walls.size();
  }
  EXPECT_GT(touching, 1000u);
  EXPECT_GT(partners, 200u);
  EXPECT_GT(at_wall, 200u);
}

// Rebuilding the lists at every step must give the same digits as rebuilding them when they expire.
TEST(NeighbourLists, RebuildingChangesNoDigit)
{
  Engine lazy = crowd(5), eager = crowd(5);
  for (int n = 0; n < 500; ++n) {
    lazy.step(2e-5);
    // Removing nobody invalidates the lists and keeps the history.
    eager.remove_clumps(std::vector<bool>(eager.clumps().size(), false));
    eager.step(2e-5);
  }
  for (int i = 0; i < lazy.clumps().size(); ++i) {
    ASSERT_EQ(lazy.clumps().position[i], eager.clumps().position[i]) << "clump " << i;
    ASSERT_EQ(lazy.clumps().angular_momentum[i], eager.clumps().angular_momentum[i])
        << "clump " << i;
  }
}

// Neither does any width of the skins.
TEST(NeighbourLists, SkinsChangeNoDigit)
{
  Engine reference = crowd(7);
  for (int n = 0; n < 500; ++n) reference.step(2e-5);
  for (const ListSettings& skins :
       {ListSettings{1e-6, 1e-4}, ListSettings{1e-4, 1e-3}, ListSettings{5e-4, 2e-3}}) {
    Engine engine = crowd(7);
    engine.set_list_settings(skins);
    for (int n = 0; n < 500; ++n) engine.step(2e-5);
    ASSERT_EQ(engine.n_touching_spheres(), reference.n_touching_spheres());
    for (int i = 0; i < engine.clumps().size(); ++i) {
      ASSERT_EQ(engine.clumps().position[i], reference.clumps().position[i]) << "clump " << i;
      ASSERT_EQ(engine.clumps().angular_momentum[i], reference.clumps().angular_momentum[i]);
    }
    EXPECT_EQ(engine.energy(2e-5).contact.damping, reference.energy(2e-5).contact.damping);
  }
}

TEST(NeighbourLists, RemovalKeepsTheHistoryOfTheOthers)
{
  Engine engine = crowd(6);
  for (int n = 0; n < 400; ++n) engine.step(2e-5);
  std::vector<std::pair<std::int64_t, Vector3>> before;
  const std::int64_t gone = engine.clumps().id[7];
  for (const SphereContact& c : engine.sphere_contacts())
    if (c.touching && engine.clumps().id[c.i] != gone && engine.clumps().id[c.j] != gone)
      before.emplace_back(engine.clumps().id[c.i], c.history.spring);
  std::vector<bool> remove(engine.clumps().size(), false);
  remove[7] = true;
  engine.remove_clumps(remove);
  std::vector<std::pair<std::int64_t, Vector3>> after;
  for (const SphereContact& c : engine.sphere_contacts())
    if (c.touching) after.emplace_back(engine.clumps().id[c.i], c.history.spring);
  ASSERT_GT(before.size(), 10u);
  EXPECT_EQ(before, after);
}
