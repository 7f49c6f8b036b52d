// The search for the largest drop of a force, on made-up histories whose drop is known by
// construction. It takes a step that is blurred or moved, a single record that makes a drop or
// hides one, a slow decline taken for a sudden one, a fall in the ramp, or scatter that counts, to
// fail.
#include "apps/drop/force_drop.h"
#include "dem/counter_stream.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace apps = interlock::apps;
using Numbers = std::vector<double>;

namespace
{
constexpr double mm = 1e-3;

struct History {
  Numbers place, force; // [m], [N]
};

// A record every `spacing` over 20 mm.
History history(const std::function<double(double)>& force, double spacing = 0.05 * mm)
{
  History made;
  const int n = static_cast<int>(std::lround(20 * mm / spacing));
  for (int k = 0; k <= n; ++k) {
    made.place.push_back(k * spacing);
    made.force.push_back(force(k * spacing));
  }
  return made;
}

// 20 N/mm up to 100 N at 5 mm, level to 6 mm, down to 40 N at 6.4 mm, level to 7 mm, up again.
double rise_and_drop(double u)
{
  if (u <= 6 * mm) return std::min(2e4 * u, 100.);
  if (u <= 7 * mm) return std::max(100 - 1.5e5 * (u - 6 * mm), 40.);
  return 40 + 5e3 * (u - 7 * mm);
}

std::optional<apps::ForceDrop> drop_of(const History& h, const apps::DropSearch& search = {})
{
  return apps::largest_drop(h.place, h.force, search);
}

void expect_the_drop(const std::optional<apps::ForceDrop>& drop, double tolerance)
{
  ASSERT_TRUE(drop.has_value());
  EXPECT_NEAR(drop->before.displacement, 6 * mm, tolerance);
  EXPECT_NEAR(drop->during.displacement, 6.2 * mm, tolerance);
  EXPECT_NEAR(drop->after.displacement, 6.4 * mm, tolerance);
  EXPECT_NEAR(drop->before.force, 100, 1e-9);
  EXPECT_NEAR(drop->during.force, 70, 1e-9);
  EXPECT_NEAR(drop->after.force, 40, 1e-9);
  EXPECT_NEAR(drop->fall(), 60, 1e-9);
  EXPECT_TRUE(drop->counts);
}
} // namespace

// The median keeps a corner between a level and a slope; so do finer and coarser records.
TEST(ForceDrop, IsFoundWhereItIs)
{
  for (const double spacing : {0.005 * mm, 0.05 * mm, 0.1 * mm}) {
    SCOPED_TRACE(spacing);
    expect_the_drop(drop_of(history(rise_and_drop, spacing)), 1e-9);
  }
}

TEST(ForceDrop, OfOneRecordStaysAStep)
{
  const auto drop = drop_of(history([](double u) { return u < 8.01 * mm ? 1e4 * u : 20; }));
  ASSERT_TRUE(drop.has_value());
  EXPECT_NEAR(drop->before.displacement, 8 * mm, 0.1 * mm + 1e-9);
  EXPECT_NEAR(drop->after.displacement, 8.05 * mm, 1e-9);
  EXPECT_NEAR(drop->before.force, 80, 1.5);
  EXPECT_NEAR(drop->after.force, 20, 1e-9);
}

TEST(ForceDrop, SingleRecordsNeitherMakeNorHideIt)
{
  const Numbers wrong = {0, 1, 3, 9, 16, 20};
  for (const double size : {500., -500.}) {
    History rising = history([](double u) { return 1e4 * u; });
    for (const double at : wrong) rising.force[std::lround(at / 0.05)] += size;
    EXPECT_FALSE(drop_of(rising, {0.05 * mm}).has_value()) << size;
    History dropping = history(rise_and_drop);
    for (const double at : wrong) dropping.force[std::lround(at / 0.05)] += size;
    expect_the_drop(drop_of(dropping), 1e-9);
  }
}

TEST(ForceDrop, IsSudden)
{
  // 60 N within 15 mm, or 12 N within 2 mm, beside 20 N within 0.2 mm.
  const auto force = [](double u) {
    const double slow = u < 3 * mm ? 3e4 * u : 90 - 4e3 * (u - 3 * mm);
    return slow - std::clamp(1e5 * (u - 10 * mm), 0., 20.);
  };
  const auto drop = drop_of(history(force), {0, 0.25 * mm});
  ASSERT_TRUE(drop.has_value());
  // It has no maximum of its own: the longer way down begins at 3 mm.
  EXPECT_NEAR(drop->before.displacement, 3 * mm, 0.1 * mm + 1e-9);
  EXPECT_LE(drop->fall(), 2);
  EXPECT_FALSE(drop->counts);
  // With one, it is the largest; of the way from the maximum no more than `within` counts.
  const auto hill = [&](double u) {
    const double rise = 1e4 * std::clamp(u - 9 * mm, 0., 1 * mm);
    return force(u) + rise;
  };
  const auto sharp = drop_of(history(hill));
  ASSERT_TRUE(sharp.has_value());
  EXPECT_NEAR(sharp->before.displacement, 10 * mm, 0.1 * mm + 1e-9);
  EXPECT_NEAR(sharp->after.displacement, 12 * mm, 1e-9);
  EXPECT_NEAR(sharp->fall(), 20 + 8, 1);
}

TEST(ForceDrop, BeginsAfterTheRamp)
{
  // 90 N at 1 mm, in the ramp; 60 N at 6 mm.
  const auto force = [](double u) { return u < 1 * mm ? 1e5 * u : rise_and_drop(u); };
  const History h = history(force);
  EXPECT_NEAR(drop_of(h)->before.displacement, 1 * mm, 0.1 * mm + 1e-9);
  expect_the_drop(drop_of(h, {1.5 * mm}), 1e-9);
}

TEST(ForceDrop, IsATenthOfTheHighestForceAtLeast)
{
  for (const double share : {0.09, 0.11}) {
    const auto drop = drop_of(history([&](double u) {
      const double fallen = std::clamp((u - 15 * mm) / (0.5 * mm), 0., 1.);
      return 100 - 200 * std::max(0., 0.5 - u / (20 * mm)) - 100 * share * fallen;
    }));
    ASSERT_TRUE(drop.has_value());
    EXPECT_NEAR(drop->highest, 100, 1e-9);
    EXPECT_NEAR(drop->fall(), 100 * share, 1e-9);
    EXPECT_EQ(drop->counts, share > 0.1);
  }
}

// Independent scatter of 2 % at every record: the median of five has a deviation of about half of
// that, and 400 of them spread over six deviations or so.
TEST(ForceDrop, ScatterDoesNotCount)
{
  using interlock::dem::CounterStream;
  for (int seed = 0; seed < 50; ++seed) {
    CounterStream random(seed, 0, interlock::dem::Draw::order);
    History h = history([](double) { return 100.; });
    for (double& force : h.force) {
      double sum = -6; // of twelve even numbers: nearly normal
      for (int k = 0; k < 12; ++k) sum += random.uniform();
      force += 2 * sum;
    }
    const auto drop = drop_of(h);
    ASSERT_TRUE(drop.has_value());
    EXPECT_FALSE(drop->counts) << seed << ": " << drop->fall();
  }
}

TEST(ForceDrop, NeedsAMaximum)
{
  EXPECT_FALSE(drop_of({}).has_value());
  EXPECT_FALSE(drop_of({{0, 1 * mm}, {5, 1}}).has_value());
  EXPECT_FALSE(drop_of(history([](double u) { return 100 - 1e3 * u; })).has_value());
  EXPECT_FALSE(drop_of(history([](double) { return 7.; })).has_value());
}
