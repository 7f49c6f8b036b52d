// Random numbers that follow from seed, id and purpose. Fails when the generator is not
// Philox4x64-10 with the counter (block, id, purpose, 0) and the key (seed, 0), when a number
// depends on anything else, or when streams of neighbouring seeds, ids or purposes know of each
// other.
#include "dem/counter_stream.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>

using namespace interlock::dem;

namespace
{
constexpr int draws = 20000;

std::vector<double> uniforms(std::uint64_t seed, std::int64_t id, Draw purpose, int n = draws)
{
  CounterStream stream(seed, id, purpose);
  std::vector<double> numbers;
  for (int k = 0; k < n; ++k) numbers.push_back(stream.uniform());
  return numbers;
}

double correlation(const std::vector<double>& a, const std::vector<double>& b)
{
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += (a[k] - 0.5) * (b[k] - 0.5);
  return 12 * sum / static_cast<double>(a.size()); // 1/12: the variance of a uniform number
}

// First words of streams 0, 1, 2, ...: what stones get, one number each.
std::vector<double> first_of_each(const std::function<CounterStream(int)>& stream)
{
  std::vector<double> numbers;
  for (int k = 0; k < draws; ++k) numbers.push_back(stream(k).uniform());
  return numbers;
}

// Five standard deviations of the mean, the variance and the correlation of successors.
void expect_uniform(const std::vector<double>& numbers, const std::string& what)
{
  const double n = static_cast<double>(numbers.size());
  double mean = 0, square = 0;
  for (const double x : numbers) {
    ASSERT_GE(x, 0) << what;
    ASSERT_LT(x, 1) << what;
    mean += x / n;
    square += (x - 0.5) * (x - 0.5) / n;
  }
  EXPECT_NEAR(mean, 0.5, 5 * std::sqrt(1. / 12 / n)) << what;
  EXPECT_NEAR(square, 1. / 12, 5 * std::sqrt(1. / 180 / n)) << what;
  const std::vector<double> head(numbers.begin(), numbers.end() - 1),
      tail(numbers.begin() + 1, numbers.end());
  EXPECT_NEAR(correlation(head, tail), 0, 5 / std::sqrt(n)) << what;
}
} // namespace

// The known answer for philox4x64 with ten rounds, counter 0 and key 0 in the file kat_vectors of
// Random123.
TEST(CounterStream, KnownAnswerOfPhilox)
{
  PhiloxBits bits(0, 0, static_cast<Draw>(0));
  EXPECT_EQ(bits(), 0x16554d9eca36314cu);
  EXPECT_EQ(bits(), 0xdb20fe9d672d0fdcu);
  EXPECT_EQ(bits(), 0xd7e772cee186176bu);
  EXPECT_EQ(bits(), 0x7e68b68aec7ba23bu);
}

// And for the numbers of pi as counter and key, which shows that the library itself is sound.
TEST(CounterStream, KnownAnswerOfTheLibrary)
{
  const r123::Philox4x64::ctr_type pi = {
      {0x243f6a8885a308d3u, 0x13198a2e03707344u, 0xa4093822299f31d0u, 0x082efa98ec4e6c89u}};
  const r123::Philox4x64::key_type key = {{0x452821e638d01377u, 0xbe5466cf34e90c6cu}};
  const r123::Philox4x64::ctr_type answer = {
      {0xa528f45403e61d95u, 0x38c72dbd566e9788u, 0xa5a1610e72fd18b5u, 0x57bd43b5e52b7fe6u}};
  EXPECT_EQ(r123::Philox4x64()(pi, key), answer);
}

// Every word has its own place: the fourth of block 2 is the twelfth number, whatever came before.
TEST(CounterStream, CounterHoldsBlockIdAndPurpose)
{
  const std::uint64_t seed = 0x0123456789abcdefu;
  const std::int64_t id = 1234567890123;
  PhiloxBits bits(seed, id, Draw::attitude);
  for (std::uint64_t block = 0; block < 3; ++block) {
    const auto words = r123::Philox4x64()(
        {{block, static_cast<std::uint64_t>(id), static_cast<std::uint64_t>(Draw::attitude), 0}},
        {{seed, 0}});
    for (int k = 0; k < 4; ++k) EXPECT_EQ(bits(), words[k]) << "block " << block << ", word " << k;
  }
}

TEST(CounterStream, SameNamesSameNumbers)
{
  const std::vector<double> numbers = uniforms(5, 17, Draw::place, 100);
  // Another stream in between takes nothing away.
  CounterStream other(5, 18, Draw::place), stream(5, 17, Draw::place);
  for (const double x : numbers) {
    other.direction();
    EXPECT_EQ(stream.uniform(), x);
  }
}

TEST(CounterStream, OtherNamesOtherNumbers)
{
  std::set<std::uint64_t> words;
  int n = 0;
  for (const std::uint64_t seed : {0u, 1u, 2u})
    for (const std::int64_t id : {-1, 0, 1, 2, 3})
      for (const Draw purpose : {Draw::order, Draw::place, Draw::attitude, Draw::velocity}) {
        PhiloxBits bits(seed, id, purpose);
        for (int k = 0; k < 8; ++k, ++n) words.insert(bits());
      }
  EXPECT_EQ(words.size(), static_cast<std::size_t>(n));
}

TEST(CounterStream, NumbersAreUniform)
{
  expect_uniform(uniforms(1, 0, Draw::order), "one stream");
  expect_uniform(first_of_each([](int k) { return CounterStream(1, k, Draw::place); }), "ids");
  expect_uniform(first_of_each([](int k) { return CounterStream(k, 0, Draw::place); }), "seeds");
}

TEST(CounterStream, NeighboursKnowNothingOfEachOther)
{
  const std::vector<double> one = uniforms(1, 7, Draw::place);
  const double bound = 5 / std::sqrt(double(draws)); // five standard deviations
  EXPECT_NEAR(correlation(one, one), 1, 0.05);       // the measure measures
  EXPECT_NEAR(correlation(one, uniforms(1, 8, Draw::place)), 0, bound);
  EXPECT_NEAR(correlation(one, uniforms(2, 7, Draw::place)), 0, bound);
  EXPECT_NEAR(correlation(one, uniforms(1, 7, Draw::attitude)), 0, bound);
  // Stone by stone: the places and the attitudes of the stones of one filling.
  const auto of_stones = [](Draw purpose, std::uint64_t seed) {
    return first_of_each([=](int k) { return CounterStream(seed, k, purpose); });
  };
  const std::vector<double> places = of_stones(Draw::place, 1);
  EXPECT_NEAR(correlation(places, of_stones(Draw::attitude, 1)), 0, bound);
  EXPECT_NEAR(correlation(places, of_stones(Draw::place, 2)), 0, bound);
}
