#include "apps/study/design.h"

#include "dem/counter_stream.h"

#include <algorithm>
#include <cmath>

namespace interlock::apps
{
namespace
{
Point point_at(const StudyFile& study, const std::vector<int>& places)
{
  Point point;
  point.places = places;
  for (std::size_t f = 0; f < places.size(); ++f)
    point.levels.push_back(study.factors[f].levels[places[f]]);
  return point;
}

Point drawn_point(const StudyFile& study, const std::vector<double>& shares)
{
  Point point;
  for (std::size_t f = 0; f < study.factors.size(); ++f) {
    point.levels.push_back(study.factors[f].at(shares[f]));
    point.places.push_back(-1);
  }
  if (shares.size() > study.factors.size())
    point.filling =
        static_cast<int>(shares.back() * static_cast<double>(study.fillings.levels.size()));
  return point;
}

std::vector<Point> grid(const StudyFile& study)
{
  std::vector<Point> points;
  std::vector<int> places(study.factors.size(), 0);
  for (;;) {
    points.push_back(point_at(study, places));
    int f = static_cast<int>(places.size()) - 1;
    while (f >= 0 && ++places[f] == static_cast<int>(study.factors[f].levels.size()))
      places[f--] = 0;
    if (f < 0) return points;
  }
}

std::vector<Point> one_at_a_time(const StudyFile& study)
{
  std::vector<int> places(study.factors.size(), 0);
  std::vector<Point> points = {point_at(study, places)};
  for (std::size_t f = 0; f < study.factors.size(); ++f) {
    for (std::size_t level = 1; level < study.factors[f].levels.size(); ++level) {
      places[f] = static_cast<int>(level);
      points.push_back(point_at(study, places));
    }
    places[f] = 0;
  }
  return points;
}

// A and B are the two halves of one hypercube with twice as many columns.
std::vector<Point> sobol(const StudyFile& study)
{
  const int n = sobol_columns(study);
  std::vector<Point> points;
  for (const std::vector<double>& row : latin_hypercube(study.samples, 2 * n, study.seed)) {
    const std::vector<double> a(row.begin(), row.begin() + n), b(row.begin() + n, row.end());
    points.push_back(drawn_point(study, a));
    points.push_back(drawn_point(study, b));
    for (int i = 0; i < n; ++i) {
      std::vector<double> mixed = a;
      mixed[i] = b[i];
      points.push_back(drawn_point(study, mixed));
    }
  }
  return points;
}
} // namespace

std::vector<std::vector<double>> latin_hypercube(int samples, int columns, std::uint64_t seed)
{
  std::vector<std::vector<double>> rows(samples, std::vector<double>(columns));
  for (int column = 0; column < columns; ++column) {
    dem::CounterStream draws(seed, column, dem::Draw::order);
    const std::vector<int> stratum = draws.permutation(samples);
    for (int row = 0; row < samples; ++row)
      rows[row][column] = (stratum[row] + draws.uniform()) / samples;
  }
  return rows;
}

int sobol_columns(const StudyFile& study)
{
  return static_cast<int>(study.factors.size()) + (study.fillings.levels.size() > 1 ? 1 : 0);
}

std::vector<Point> design_points(const StudyFile& study)
{
  if (study.design == "grid") return grid(study);
  if (study.design == "one at a time") return one_at_a_time(study);
  if (study.design == "sobol") return sobol(study);
  std::vector<Point> points;
  for (const auto& row :
       latin_hypercube(study.samples, static_cast<int>(study.factors.size()), study.seed))
    points.push_back(drawn_point(study, row));
  return points;
}
} // namespace interlock::apps
