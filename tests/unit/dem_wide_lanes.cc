// A bundle of lanes against plain numbers: every lane must find what the same formula finds alone.
#include "dem/bodies/wide.h"
#include "dem/bodies/rigid_motion.h"
#include "dem/contacts/contact_law.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace interlock::dem
{
namespace
{
using Numbers = std::array<double, Wide::lanes>;

Numbers numbers(const Wide& wide)
{
  Numbers result;
  wide.store(result.data());
  return result;
}
Wide wide(const Numbers& numbers)
{
  return Wide::load(numbers.data());
}

// Lanes that touch, open, stick, slide, and have never touched.
struct Lanes {
  Numbers overlap, was, speed, spring, turn;
};
Lanes all_kinds()
{
  Lanes lanes;
  for (int l = 0; l < Wide::lanes; ++l) {
    lanes.overlap[l] = l % 4 == 3 ? -1e-6 : 1e-6 * (1 + l);
    lanes.was[l] = l % 8 == 7 ? 0 : 1.1e-6 * (1 + l % 5);
    lanes.speed[l] = 0.01 * (l % 3 - 1);
    lanes.spring[l] = lanes.was[l] > 0 ? 1e-7 * (l % 6) * (l % 2 == 0 ? 1 : -40) : 0;
    lanes.turn[l] = 1e-4 * (l - 7);
  }
  return lanes;
}

template <bool shared, class Number, class Law>
std::array<Number, 8> law_of(const Law& law, Number overlap, Number was, Number speed,
                             Number spring, Number turn)
{
  const ConstantsOf<Number> constants{0.02, std::sqrt(0.02), 0.004};
  const ShareOf<Number> share{1.2 * overlap, 0.7};
  HistoryOf<Number> history{{0, spring, 0}, {1e-3 * was, 0, 0}, was, 4e5};
  EnergyOf<Number> energy;
  const LaneVector<Number> force =
      contact_force<shared>(law, constants, overlap, {0, 0, 1}, {speed, 0.02, 0.5 * speed},
                            {turn, turn, 0.5 * turn}, share, 1e-5, history, energy);
  return {force.x,          force.y,         force.z,        history.spring.x,
          history.spring.y, energy.friction, energy.damping, energy.elastic};
}

template <bool shared, class Law> void compare(const Law& law)
{
  const Lanes lanes = all_kinds();
  const auto together =
      law_of<shared, Wide>(law, wide(lanes.overlap), wide(lanes.was), wide(lanes.speed),
                           wide(lanes.spring), wide(lanes.turn));
  for (int l = 0; l < Wide::lanes; ++l) {
    const auto alone = law_of<shared, double>(law, lanes.overlap[l], lanes.was[l], lanes.speed[l],
                                              lanes.spring[l], lanes.turn[l]);
    for (int k = 0; k < 8; ++k)
      EXPECT_NEAR(numbers(together[k])[l], alone[k], 1e-12 * std::abs(alone[k]) + 1e-20)
          << "lane " << l << ", number " << k;
    if (lanes.overlap[l] > 0) continue;
    for (int k = 0; k < 5; ++k) EXPECT_EQ(numbers(together[k])[l], 0) << "open lane " << l;
  }
}

ContactProperties linear_pair()
{
  ContactProperties pair;
  pair.normal_stiffness = 1e7;
  pair.tangential_stiffness = 0.7e7;
  pair.friction = 0.5;
  pair.damping_ratio = 0.1;
  pair.normal_damping_rate = 4000;
  return pair;
}
} // namespace

TEST(WideLanes, LinearLawInEachLane)
{
  compare<false>(LinearLaw(linear_pair()));
  compare<true>(LinearLaw(linear_pair()));
}

TEST(WideLanes, HertzMindlinLawInEachLane)
{
  const HertzMindlinLaw law(hertz_mindlin_pair({5e10, 0.25}, {5e10, 0.25}, 0.5, 0.1));
  compare<false>(law);
  compare<true>(law);
}

// Out of line, so that the compiler cannot know that lanes are alike.
[[gnu::noinline]] std::array<Wide, 8> law_of_loaded(const Lanes& lanes)
{
  return law_of<false, Wide>(LinearLaw(linear_pair()), wide(lanes.overlap), wide(lanes.was),
                             wide(lanes.speed), wide(lanes.spring), wide(lanes.turn));
}

// Four contacts, each in every fourth lane: the same to the last bit, whichever lane it is.
TEST(WideLanes, NoLaneDiffersFromAnother)
{
  Lanes lanes = all_kinds();
  for (Numbers* row : {&lanes.overlap, &lanes.was, &lanes.speed, &lanes.spring, &lanes.turn})
    for (int l = 4; l < Wide::lanes; ++l) (*row)[l] = (*row)[l % 4];
  for (const Wide& number : law_of_loaded(lanes))
    for (int l = 4; l < Wide::lanes; ++l) EXPECT_EQ(numbers(number)[l], numbers(number)[l % 4]);
}

TEST(WideLanes, AttitudeInEachLane)
{
  Numbers x;
  for (int l = 0; l < Wide::lanes; ++l) x[l] = 0.1 * (l - 5);
  const auto together =
      advance_attitude<Wide>({0.6, 0, 0, 0.8}, {wide(x), 1e-3, wide(x)}, {1e3, 2e3, 3e3}, 1e-4);
  for (int l = 0; l < Wide::lanes; ++l) {
    const auto alone =
        advance_attitude<double>({0.6, 0, 0, 0.8}, {x[l], 1e-3, x[l]}, {1e3, 2e3, 3e3}, 1e-4);
    EXPECT_NEAR(numbers(together.attitude.x)[l], alone.attitude.x, 1e-15);
    EXPECT_NEAR(numbers(together.attitude.w)[l], alone.attitude.w, 1e-15);
    EXPECT_NEAR(numbers(together.spin.z)[l], alone.spin.z, 1e-12);
  }
}
} // namespace interlock::dem
