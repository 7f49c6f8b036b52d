// What is read off curves, against closed forms of straight and bent lines. Fails when a mean is
// shifted, a window is not centred, or an end is cut off.
#include "coupling/stones/curve_measures.h"
#include "coupling/stones/soft_start.h"

#include <gtest/gtest.h>

using namespace interlock::coupling;

namespace
{
// Unevenly spaced from 0 to 1.
std::vector<double> places(int n)
{
  std::vector<double> result;
  for (int k = 0; k <= n; ++k) result.push_back(0.7 * k / n + 0.3 * k * k / n / n);
  return result;
}

// Means of f(x) = a + b x between the places.
std::vector<double> line_means(const std::vector<double>& x, double a, double b)
{
  std::vector<double> result = {a};
  for (std::size_t k = 1; k < x.size(); ++k) result.push_back(a + 0.5 * b * (x[k] + x[k - 1]));
  return result;
}
} // namespace

TEST(CurveMeasures, CentredMeanOfALineIsTheLine)
{
  const auto x = places(50);
  const auto mean = centred_mean(x, line_means(x, 2, 3), 0.1);
  // Within an interval the integral is taken for straight: off by b dx^2/(8 length).
  for (std::size_t k = 1; k + 1 < x.size(); ++k)
    if (x[k] > 0.05 && x[k] < 0.95) {
      EXPECT_NEAR(mean[k], 2 + 3 * x[k], 0.005);
    }
}

TEST(CurveMeasures, MeanOverEnd)
{
  const auto x = places(50);
  EXPECT_NEAR(mean_over_end(x, line_means(x, 2, 3), 1), 3.5, 1e-12);
  EXPECT_NEAR(mean_over_end(x, line_means(x, 2, 3), 0.2), 2 + 3 * 0.9, 0.005);
}

TEST(CurveMeasures, SlopeAroundAPlace)
{
  const auto x = places(100);
  std::vector<double> y;
  for (const double place : x) y.push_back(place < 0.5 ? 4 * place : 2 - 6 * (place - 0.5));
  EXPECT_NEAR(slope_around(x, y, 0.25, 0.2), 4, 1e-9);
  EXPECT_NEAR(slope_around(x, y, 0.8, 0.2), -6, 1e-9);
  EXPECT_EQ(slope_around(x, y, 0.8, 1e-9), 0);
}

TEST(CurveMeasures, FirstPlaceAtALevel)
{
  const std::vector<double> x = {0, 1, 2, 3}, y = {0, 4, 2, 8};
  EXPECT_DOUBLE_EQ(first_place_at(x, y, 3), 0.75);
  EXPECT_DOUBLE_EQ(first_place_at(x, y, 5), 2.5);
  EXPECT_DOUBLE_EQ(first_place_at(x, y, 9), 3);
}

TEST(SoftStart, RisesFromRestToFullSpeed)
{
  EXPECT_EQ(soft_start(0, 0.1), 0);
  EXPECT_NEAR(soft_start(0.05, 0.1), 0.5, 1e-15);
  EXPECT_EQ(soft_start(0.1, 0.1), 1);
  EXPECT_EQ(soft_start(0, 0), 1);
}
