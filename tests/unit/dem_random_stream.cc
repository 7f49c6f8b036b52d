// Random numbers have the digits that the standard fixes and the distributions that they promise.
// Fails when the engine or the mapping to [0, 1) changes, when a permutation loses an entry or
// favours a place, or when directions crowd anywhere on the sphere.
#include "dem/random_stream.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{
using interlock::dem::RandomStream;
using interlock::dem::Vector3;

// The C++ standard requires 9981545732273789042 as the 10000th number of mt19937_64 with seed 5489.
TEST(RandomStream, DigitsOfTheStandard)
{
  RandomStream stream(5489);
  for (int i = 0; i < 9999; ++i) stream.uniform();
  EXPECT_EQ(stream.uniform(), double(9981545732273789042u >> 11) / 9007199254740992.0);
}

TEST(RandomStream, PermutationsAreFair)
{
  RandomStream stream(1);
  constexpr int entries = 7, trials = 70000;
  std::array<int, entries> first{};
  for (int t = 0; t < trials; ++t) {
    auto order = stream.permutation(entries);
    ++first[order[0]];
    std::sort(order.begin(), order.end());
    for (int i = 0; i < entries; ++i) ASSERT_EQ(order[i], i);
  }
  // Standard deviation of a count: sqrt(trials * 1/7 * 6/7) = 93; five of them.
  for (const int count : first) EXPECT_NEAR(count, trials / entries, 465);
}

// Uniform on the sphere: zero mean, second moments 1/3. Five standard deviations of the means.
TEST(RandomStream, DirectionsCoverTheSphere)
{
  RandomStream stream(2);
  constexpr int trials = 100000;
  Vector3 mean = Vector3::Zero(), squares = Vector3::Zero();
  for (int t = 0; t < trials; ++t) {
    const Vector3 x = stream.direction();
    ASSERT_NEAR(x.norm(), 1, 1e-14);
    mean += x / trials;
    squares += x.cwiseAbs2() / trials;
  }
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(mean[k], 0, 5 * std::sqrt(1. / 3 / trials));
    EXPECT_NEAR(squares[k], 1. / 3, 5 * std::sqrt(4. / 45 / trials));
  }
}
} // namespace
