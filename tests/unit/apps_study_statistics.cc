// What a study computes from its numbers, against tables and closed forms: Student's t, the split
// of a product of two factors, estimates over many samples with known variances, Ishigami's
// function.
#include "apps/study/design.h"
#include "apps/study/variance_split.h"
#include "dem/counter_stream.h"

#include <gtest/gtest.h>

#include <cmath>

namespace apps = interlock::apps;
using interlock::dem::CounterStream;
using Numbers = std::vector<double>;

// t_(0.975) of 4 degrees of freedom is 2.7764 (any table of Student's distribution).
TEST(StudyStatistics, IntervalOfAMean)
{
  const apps::SampleMean sample = apps::sample_mean({1, 2, 3, 4, 5}, 0.95);
  EXPECT_EQ(sample.n, 5);
  EXPECT_DOUBLE_EQ(sample.mean, 3);
  EXPECT_DOUBLE_EQ(sample.deviation, std::sqrt(2.5));
  EXPECT_NEAR(sample.half_width, 2.7764 * std::sqrt(2.5 / 5), 5e-5);
  // 12.706 of 1 degree.
  EXPECT_NEAR(apps::sample_mean({0, 2}, 0.95).half_width, 12.706, 1e-3);
  EXPECT_TRUE(std::isnan(apps::sample_mean({7}, 0.95).half_width));
  EXPECT_EQ(apps::sample_mean({7}, 0.95).mean, 7);
  // Equal values differ by nothing at all.
  EXPECT_EQ(apps::sample_mean({0, 0, 0}, 0.95).half_width, 0);
}

// f = x y with x = 1, 2, 3 and y = 1, 1/2: V_x = mean(y)^2 var(x), V_y = mean(x)^2 var(y),
// V_xy = var(x) var(y).
TEST(StudyStatistics, SplitOfAProduct)
{
  Numbers values;
  for (const double x : {1., 2., 3.})
    for (const double y : {1., 0.5}) values.push_back(x * y);
  const auto terms = apps::analysis_of_variance({3, 2}, values, false);
  ASSERT_EQ(terms.size(), 3u);
  const double var_x = 2. / 3, var_y = 1. / 16;
  EXPECT_NEAR(terms[0].variance, 0.75 * 0.75 * var_x, 1e-15);
  EXPECT_NEAR(terms[1].variance, 4 * var_y, 1e-15);
  EXPECT_NEAR(terms[2].variance, var_x * var_y, 1e-15);
  EXPECT_EQ(terms[0].degrees, 2);
  EXPECT_EQ(terms[2].degrees, 2);
  EXPECT_NEAR(terms[0].share + terms[1].share + terms[2].share, 1, 1e-15);
}

// Three factors: the sums of squares add up to that of all values about their mean, and a term that
// is not in the function has none.
TEST(StudyStatistics, SumsOfSquaresAddUp)
{
  Numbers values;
  double mean = 0;
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 4; ++b)
      for (int c = 0; c < 2; ++c) {
        values.push_back(std::sin(a + 2 * b) + 0.3 * c);
        mean += values.back() / 24;
      }
  double all = 0, sum = 0;
  for (const double value : values) all += (value - mean) * (value - mean);
  for (const apps::VarianceTerm& term : apps::analysis_of_variance({3, 4, 2}, values, false)) {
    sum += term.sum_of_squares;
    if (term.factors >= 5) {
      EXPECT_NEAR(term.sum_of_squares, 0, 1e-25) << term.factors;
    }
    if (term.factors == 4) {
      EXPECT_NEAR(term.variance, 0.15 * 0.15, 1e-15);
    }
  }
  EXPECT_NEAR(sum, all, 1e-12);
}

// y = a_i + F_j + G_ij with a = -1, 0, 1 (variance 2/3), F of variance 0.25 and, in each filling, G
// of variance 0.16 about its mean over the three levels; G alone moves that mean by 0.16/3.
// Estimates from 4 fillings, averaged over 4000 studies, must be these.
TEST(StudyStatistics, RandomFillingsAreEstimatedWithoutBias)
{
  constexpr int studies = 4000, levels = 3, fillings = 4;
  double point = 0, filling = 0, both = 0, rejected = 0;
  for (int study = 0; study < studies; ++study) {
    CounterStream draws(1, study, interlock::dem::Draw::place);
    const auto normal = [&] {
      const double u = draws.uniform(), v = draws.uniform();
      return std::sqrt(-2 * std::log(1 - u)) * std::cos(2 * M_PI * v);
    };
    Numbers of_filling, values;
    for (int j = 0; j < fillings; ++j) of_filling.push_back(0.5 * normal());
    for (int i = 0; i < levels; ++i)
      for (int j = 0; j < fillings; ++j) values.push_back(i - 1 + of_filling[j] + 0.4 * normal());
    const auto terms = apps::analysis_of_variance({levels, fillings}, values, true);
    point += terms[0].variance / studies;
    filling += terms[1].variance / studies;
    both += terms[2].variance / studies;
    Numbers none; // without an effect of the level
    for (int i = 0; i < levels; ++i)
      for (int j = 0; j < fillings; ++j) none.push_back(values[i * fillings + j] - i);
    rejected += apps::analysis_of_variance({levels, fillings}, none, true)[0].p < 0.05;
  }
  EXPECT_NEAR(point, 2. / 3, 0.02);
  EXPECT_NEAR(filling, 0.25 + 0.16 / 3, 0.02);
  EXPECT_NEAR(both, 0.16 * (levels - 1) / levels, 0.01);
  // A test at 5 % errs in 5 % of the studies.
  EXPECT_NEAR(rejected / studies, 0.05, 0.012);
}

// Ishigami's function, sin x + 7 sin^2 y + 0.1 z^4 sin x over [-pi, pi]^3: V = 13.845, first
// indices 0.3139, 0.4424, 0, total ones 0.5576, 0.4424, 0.2437 (Ishigami and Homma 1990; Saltelli
// et al. 2008, Global Sensitivity Analysis, section 4.6).
TEST(StudyStatistics, IndicesOfIshigamisFunction)
{
  constexpr int n = 8192;
  const auto f = [](const Numbers& u) {
    const auto angle = [&](int k) { return M_PI * (2 * u[k] - 1); };
    const double s = std::sin(angle(1));
    return std::sin(angle(0)) * (1 + 0.1 * std::pow(angle(2), 4)) + 7 * s * s;
  };
  Numbers a, b;
  std::vector<Numbers> mixed(3);
  for (const Numbers& row : apps::latin_hypercube(n, 6, 1)) {
    const Numbers ua(row.begin(), row.begin() + 3), ub(row.begin() + 3, row.end());
    a.push_back(f(ua));
    b.push_back(f(ub));
    for (int i = 0; i < 3; ++i) {
      Numbers u = ua;
      u[i] = ub[i];
      mixed[i].push_back(f(u));
    }
  }
  double variance = 0;
  const auto indices = apps::sobol_indices(a, b, mixed, variance);
  EXPECT_NEAR(variance, 13.845, 0.3);
  const double first[] = {0.3139, 0.4424, 0}, total[] = {0.5576, 0.4424, 0.2437};
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(indices[i].first, first[i], 4 * indices[i].first_error) << i;
    EXPECT_NEAR(indices[i].total, total[i], 4 * indices[i].total_error) << i;
    EXPECT_LT(indices[i].first_error, 0.025) << i;
    EXPECT_LT(indices[i].total_error, 0.025) << i;
  }
}
