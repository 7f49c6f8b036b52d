// The nested lists against brute force, on random clumps that fly through each other's reach. Fails
// when a skin, a displacement bound or the slab filter loses a pair, or when lists change a digit.
#include "tests/dem_crowd.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

using namespace interlock::dem;
using crowd::time_step;

namespace
{
Engine linear_crowd(std::uint64_t seed)
{
  return crowd::thrown(seed, crowd::laws().front().pair).engine;
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
  Engine engine = linear_crowd(3);
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
  Engine engine = linear_crowd(4);
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

// With every law: idle entries must add exact zeros wherever a law or a sum meets them.
class NeighbourListsOfEachLaw : public testing::TestWithParam<crowd::Law>
{
protected:
  Engine throw_crowd(std::uint64_t seed) const
  {
    return crowd::thrown(seed, GetParam().pair).engine;
  }

  static void expect_same_digits(const Engine& a, const Engine& b)
  {
    ASSERT_GT(a.n_touching_spheres(), 30);
    ASSERT_EQ(a.n_touching_spheres(), b.n_touching_spheres());
    for (int i = 0; i < a.clumps().size(); ++i) {
      ASSERT_EQ(a.clumps().position[i], b.clumps().position[i]) << "clump " << i;
      ASSERT_EQ(a.clumps().angular_momentum[i], b.clumps().angular_momentum[i]) << "clump " << i;
    }
    const EngineEnergy p = a.energy(time_step), q = b.energy(time_step);
    EXPECT_EQ(p.kinetic, q.kinetic);
    EXPECT_EQ(p.contact.elastic, q.contact.elastic);
    EXPECT_EQ(p.contact.friction, q.contact.friction);
    EXPECT_EQ(p.contact.damping, q.contact.damping);
    EXPECT_EQ(p.contact.crushing, q.contact.crushing);
  }
};
INSTANTIATE_TEST_SUITE_P(Laws, NeighbourListsOfEachLaw, testing::ValuesIn(crowd::laws()),
                         [](const auto& law) { return law.param.name; });

// Rebuilding the lists at every step must give the same digits as rebuilding them when they expire.
TEST_P(NeighbourListsOfEachLaw, RebuildingChangesNoDigit)
{
  Engine lazy = throw_crowd(5), eager = throw_crowd(5);
  for (int n = 0; n < 500; ++n) {
    lazy.step(time_step);
    // Removing nobody invalidates the lists and keeps the history.
    eager.remove_clumps(std::vector<bool>(eager.clumps().size(), false));
    eager.step(time_step);
  }
  expect_same_digits(lazy, eager);
}

// Neither does any width of the skins.
TEST_P(NeighbourListsOfEachLaw, SkinsChangeNoDigit)
{
  Engine reference = throw_crowd(7);
  for (int n = 0; n < 500; ++n) reference.step(time_step);
  for (const ListSettings& skins :
       {ListSettings{1e-6, 1e-4}, ListSettings{1e-4, 1e-3}, ListSettings{5e-4, 2e-3}}) {
    Engine engine = throw_crowd(7);
    engine.set_list_settings(skins);
    for (int n = 0; n < 500; ++n) engine.step(time_step);
    expect_same_digits(engine, reference);
  }
}

// Two balls that rub on each other and on the floor fly off, farther in one step than narrow skins
// reach. What their contacts held and what the dashpots did meanwhile must be booked all the same.
TEST_P(NeighbourListsOfEachLaw, ContactsThatOpenWideAreBooked)
{
  constexpr double radius = 0.01, depth = 1e-4, dt = 1e-5;
  const auto fly_off = [&](const ListSettings& skins) {
    ClumpShape ball;
    ball.spheres = {{Vector3::Zero(), radius}};
    ball.volume = 4e-6;
    ball.unit_inertia = Vector3::Constant(1.6e-10);
    Engine engine({ball}, GetParam().pair, 0);
    engine.set_list_settings(skins);
    engine.add_wall(rectangle_wall("floor", {-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, GetParam().pair));
    for (const double side : {-1, 1})
      engine.add_clump(0, 2650, {side * (radius - 0.5 * depth), 0, radius - depth},
                       Quaternion::Identity(), {0, 0.1 * side, 0});
    for (int n = 0; n < 5; ++n) engine.step(dt);
    const ContactEnergy before = engine.energy(dt).contact;
    for (int i : {0, 1}) engine.clumps().velocity[i] = Vector3(i == 0 ? -40 : 40, 0, 60);
    engine.step(dt);
    engine.compute_forces(dt);
    EXPECT_EQ(engine.n_touching_spheres(), 0);
    ContactEnergy lost = engine.energy(dt).contact;
    EXPECT_EQ(lost.elastic, 0);
    EXPECT_GT(lost.friction, before.friction + 1e-7); // what the springs held [J]
    EXPECT_NE(lost.damping, before.damping);
    return lost;
  };
  const ContactEnergy narrow = fly_off({1e-6, 1e-4}), wide = fly_off({2e-3, 5e-3});
  EXPECT_EQ(narrow.friction, wide.friction);
  EXPECT_EQ(narrow.damping, wide.damping);
}

// A ball and another one, and the floor, meet so fast that narrow skins do not know of it when the
// ball is removed. What goes with it must not depend on the skins.
TEST_P(NeighbourListsOfEachLaw, RemovalBooksTheSame)
{
  const auto inserted = [&](const ListSettings& skins) {
    constexpr double radius = 0.01, dt = 1e-5;
    ClumpShape ball;
    ball.spheres = {{Vector3::Zero(), radius}};
    ball.volume = 4e-6;
    ball.unit_inertia = Vector3::Constant(1.6e-10);
    Engine engine({ball}, GetParam().pair, 0);
    engine.set_list_settings(skins);
    engine.add_wall(rectangle_wall("floor", {-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, GetParam().pair));
    engine.add_clump(0, 2650, {0, 0, radius + 5e-4}, Quaternion::Identity(), {0, 0, -100});
    engine.add_clump(0, 2650, {0, 0, 3 * radius + 1e-3}, Quaternion::Identity(), {0, 0, -200});
    engine.step(dt);
    EXPECT_EQ(engine.count_overlaps_brute_force(), 1);
    engine.remove_clumps({true, false});
    return engine.energy(dt).inserted;
  };
  EXPECT_EQ(inserted({1e-6, 1e-4}), inserted({2e-3, 5e-3}));
}

TEST(NeighbourLists, RemovalKeepsTheHistoryOfTheOthers)
{
  Engine engine = linear_crowd(6);
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

// Properties change between steps, as for a run that starts from a packed state: springs that a law
// of constant stiffness has loaded go on under one whose stiffness changes, and what is stored is
// what the present law stores, not what an earlier one shared.
TEST(ContactMemory, SurvivesAnotherLaw)
{
  const std::vector<crowd::Law> laws = crowd::laws();
  const auto named = [&](const std::string& name) {
    return std::find_if(laws.begin(), laws.end(), [&](const auto& law) { return law.name == name; })
        ->pair;
  };
  const auto springs = [](const Engine& engine) {
    double sum = 0;
    for (const SphereContact& c : engine.sphere_contacts()) sum += c.history.spring.norm();
    for (const WallContact& c : engine.wall_contacts()) sum += c.history.spring.norm();
    return sum;
  };
  for (const auto& [before, after] : {std::pair{"Linear", "LinearShared"},
                                      {"LinearShared", "Linear"},
                                      {"Linear", "HertzMindlin"}}) {
    Engine engine = crowd::thrown(5, named(before)).engine;
    for (int n = 0; n < 1500; ++n) engine.step(crowd::time_step);
    engine.compute_forces(crowd::time_step);
    const double held = springs(engine);
    ASSERT_GT(held, 0);
    const ContactProperties pair = named(after);
    engine.stone_contact() = pair;
    for (Wall& wall : engine.walls()) wall.contact = pair;
    engine.compute_forces(crowd::time_step);
    EXPECT_GT(springs(engine), 0.2 * held) << before << " to " << after;

    if (pair.model != ContactModel::linear || pair.share_among_contacts) continue;
    double stored = 0;
    const auto add = [&](const auto& c) {
      stored += 0.5 * pair.normal_stiffness * c.overlap * c.overlap +
                0.5 * pair.tangential_stiffness * c.history.spring.squaredNorm();
    };
    for (const SphereContact& c : engine.sphere_contacts()) add(c);
    for (const WallContact& c : engine.wall_contacts()) add(c);
    EXPECT_NEAR(engine.energy(crowd::time_step).contact.elastic, stored, 1e-9 * stored);
  }
}
