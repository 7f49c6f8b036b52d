// Which ribs are near a place. Fails when the search leaves out a rib whose box meets the place,
// gives one twice, or in another order than theirs, or when a point of a rod is outside its box.
#include "dem/ribs/rib_search.h"
#include "dem/random_stream.h"

#include <gtest/gtest.h>

using namespace interlock::dem;

namespace
{
Vector3 somewhere(RandomStream& random)
{
  return {random.uniform(-0.2, 0.2), random.uniform(-0.1, 0.1), random.uniform(-0.02, 0.02)};
}

std::vector<Rib> rods(int count, RandomStream& random)
{
  std::vector<Rib> ribs(count);
  for (Rib& rib : ribs) {
    rib.half_width = random.uniform(1e-3, 4e-3);
    rib.half_thickness = random.uniform(5e-4, 2e-3);
    rib.x[0] = somewhere(random);
    rib.x[1] = rib.x[0] + 0.01 * random.direction();
  }
  return ribs;
}
} // namespace

TEST(RibSearch, FindsThoseWhoseBoxesMeetThePlace)
{
  RandomStream random(5);
  constexpr double margin = 3e-4;
  for (const int count : {1, 7, 400}) {
    const std::vector<Rib> ribs = rods(count, random);
    const RibSearch search(RibSet(ribs), margin);
    int found_at_all = 0;
    for (int n = 0; n < 500; ++n) {
      const Vector3 centre = somewhere(random);
      const double half = random.uniform(0, 0.03);
      const RibSearch::Box place(centre.array() - half, centre.array() + half);
      std::vector<int> expected, found = {-1}; // what was there before is gone
      for (int r = 0; r < count; ++r)
        if (search.box(r).intersects(place)) expected.push_back(r);
      search.find(place, found);
      EXPECT_EQ(found, expected);
      found_at_all += !found.empty();
    }
    EXPECT_GT(found_at_all, count == 1 ? 1 : 20);
  }
}

TEST(RibSearch, BoxesHoldTheRodsAndTheirMargin)
{
  RandomStream random(6);
  constexpr double margin = 2e-4;
  const std::vector<Rib> ribs = rods(50, random);
  const RibSearch search(RibSet(ribs), margin);
  for (std::size_t r = 0; r < ribs.size(); ++r)
    for (int n = 0; n < 100; ++n) {
      const double xi = random.uniform(0, 1);
      const Vector3 on_line = (1 - xi) * ribs[r].x[0] + xi * ribs[r].x[1];
      const Vector3 outside =
          (std::hypot(ribs[r].half_width, ribs[r].half_thickness) + margin) * random.direction();
      EXPECT_TRUE(search.box(static_cast<int>(r)).contains(on_line + outside));
    }
}

TEST(RibSearch, WithoutRibsFindsNone)
{
  const RibSearch search(RibSet(), 1e-3);
  std::vector<int> found = {3};
  search.find(RibSearch::Box(Vector3::Constant(-1), Vector3::Constant(1)), found);
  EXPECT_TRUE(found.empty());
}

TEST(RibSearch, FindsPresentRibsOnly)
{
  RandomStream random(7);
  RibSet ribs(rods(10, random));
  // Each rod has two ends: the second one has lost one of them, and the range in the middle is
  // short.
  ribs.set_present_ends({{0, 3}, {8, 9}, {12, 18}});
  EXPECT_EQ(ribs.present(), (std::vector<int>{0, 6, 7, 8}));
  std::vector<int> found;
  const RibSearch search(ribs, 1e-3);
  search.find(RibSearch::Box(Vector3::Constant(-1), Vector3::Constant(1)), found);
  EXPECT_EQ(found, ribs.present());
  ribs.set_all_present();
  EXPECT_EQ(ribs.present().size(), 10);
}
