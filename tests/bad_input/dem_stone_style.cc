// Forms of stones that nobody can make: each is answered with one sentence that names the entry,
// the value and the allowed range. Fails when a bad entry passes or the sentence lacks one of them.
#include "dem/input_error.h"
#include "dem/stones/synthetic_stone.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using interlock::dem::StoneStyle;

void expect_refusal(const StoneStyle& style, const std::vector<std::string>& words)
{
  try {
    interlock::dem::make_stones(1, 1, style);
    ADD_FAILURE() << "accepted: " << words.front();
  } catch (const interlock::InputError& error) {
    const std::string sentence = error.what();
    for (const std::string& word : words)
      EXPECT_NE(sentence.find(word), std::string::npos) << sentence;
    EXPECT_EQ(sentence.back(), '.');
  }
}

template <typename Entry> StoneStyle with(Entry StoneStyle::*entry, Entry value)
{
  StoneStyle style;
  style.*entry = value;
  return style;
}

TEST(StoneStyle, RefusesWhatIsOutOfRange)
{
  expect_refusal(with(&StoneStyle::flatness, 1.2), {"mean flatness", "1.2", "0.4 to 0.95"});
  expect_refusal(with(&StoneStyle::flatness_spread, -0.1), {"spread of flatness", "-0.1", "0 to"});
  expect_refusal(with(&StoneStyle::elongation, 0.1), {"mean elongation", "0.1", "0.4 to 0.95"});
  expect_refusal(with(&StoneStyle::elongation_spread, 1.), {"spread of elongation", "0 to 0.2"});
  expect_refusal(with(&StoneStyle::faces, 3), {"fracture faces", "3", "5 to 40"});
  expect_refusal(with(&StoneStyle::edge_wear, 0.), {"edge wear", "0", "0.005 to 0.5"});
  expect_refusal(with(&StoneStyle::scars, -1), {"scars", "-1", "0 to 20"});
  expect_refusal(with(&StoneStyle::scar_depth, 0.5), {"scar depth", "0.5", "0 to 0.1"});
  expect_refusal(with(&StoneStyle::steps, 7), {"steps", "7", "0 to 6"});
  expect_refusal(with(&StoneStyle::roughness, 0.1), {"roughness", "0.1 m", "0 to 0.002 m"});
  expect_refusal(with(&StoneStyle::roughness_exponent, 3.), {"exponent", "3", "0.3 to 1.5"});
}

// Millimetres where metres are wanted.
TEST(StoneStyle, RefusesASpacingInMillimetres)
{
  expect_refusal(with(&StoneStyle::spacing, 0.5), {"node spacing", "0.5 m", "5e-05 to 0.005 m"});
  expect_refusal(with(&StoneStyle::spacing, -1e-3), {"node spacing", "-0.001 m"});
}

TEST(StoneStyle, RefusesWhatIsNotANumber)
{
  expect_refusal(with(&StoneStyle::edge_wear, std::nan("")), {"edge wear", "nan"});
}
} // namespace
