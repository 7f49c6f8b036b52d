#include "apps/study/variance_split.h"

#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace interlock::apps
{
namespace
{
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
using Numbers = std::vector<double>;

double mean(const Numbers& values)
{
  return std::accumulate(values.begin(), values.end(), 0.) / static_cast<double>(values.size());
}

// Means over all factors but those of `kept`, put back into every cell of the grid.
class Grid
{
public:
  explicit Grid(const std::vector<int>& levels) : levels_(levels) {}

  Numbers averaged(const Numbers& values, unsigned kept) const
  {
    Numbers sums(values.size(), 0.), counts(values.size(), 0.);
    for (std::size_t cell = 0; cell < values.size(); ++cell) {
      const std::size_t at = representative(cell, kept);
      sums[at] += values[cell], counts[at] += 1;
    }
    Numbers result(values.size());
    for (std::size_t cell = 0; cell < values.size(); ++cell) {
      const std::size_t at = representative(cell, kept);
      result[cell] = sums[at] / counts[at];
    }
    return result;
  }

private:
  // The first cell with the same levels of the kept factors.
  std::size_t representative(std::size_t cell, unsigned kept) const
  {
    std::size_t at = 0, stride = 1;
    for (std::size_t k = levels_.size(); k-- > 0;) {
      if (kept >> k & 1) at += stride * (cell % levels_[k]);
      cell /= levels_[k];
      stride *= levels_[k];
    }
    return at;
  }

  std::vector<int> levels_;
};

// Sum of squares of every effect, by subset.
Numbers sums_of_squares(const std::vector<int>& levels, const Numbers& values)
{
  const Grid grid(levels);
  const unsigned n = 1u << levels.size();
  Numbers centred = values;
  const double middle = mean(values);
  for (double& value : centred) value -= middle;
  std::vector<Numbers> effects(n);
  Numbers sums(n, 0.);
  for (unsigned s = 1; s < n; ++s) {
    effects[s] = grid.averaged(centred, s);
    for (unsigned t = (s - 1) & s; t > 0; t = (t - 1) & s)
      for (std::size_t cell = 0; cell < values.size(); ++cell) effects[s][cell] -= effects[t][cell];
    for (const double effect : effects[s]) sums[s] += effect * effect;
  }
  return sums;
}

void add_shares(std::vector<VarianceTerm>& terms)
{
  double all = 0;
  for (const VarianceTerm& term : terms) all += std::max(0., term.variance);
  for (VarianceTerm& term : terms) term.share = all > 0 ? std::max(0., term.variance) / all : 0;
}

// Mean of (x - y)^2/(2 V) and its standard error.
std::pair<double, double> half_squares(const Numbers& x, const Numbers& y, double variance)
{
  Numbers terms;
  for (std::size_t k = 0; k < x.size(); ++k)
    terms.push_back((x[k] - y[k]) * (x[k] - y[k]) / (2 * variance));
  const SampleMean sample = sample_mean(terms, 0.95);
  return {sample.mean, sample.deviation / std::sqrt(static_cast<double>(terms.size()))};
}
} // namespace

SampleMean sample_mean(const Numbers& values, double confidence)
{
  SampleMean result;
  result.n = static_cast<int>(values.size());
  result.mean = values.empty() ? unknown : mean(values);
  result.deviation = result.half_width = unknown;
  if (result.n < 2) return result;
  double squares = 0;
  for (const double value : values) squares += (value - result.mean) * (value - result.mean);
  result.deviation = std::sqrt(squares / (result.n - 1));
  const boost::math::students_t t(result.n - 1);
  result.half_width =
      boost::math::quantile(t, 0.5 + 0.5 * confidence) * result.deviation / std::sqrt(result.n);
  return result;
}

std::vector<VarianceTerm> analysis_of_variance(const std::vector<int>& levels,
                                               const Numbers& values, bool last_is_random)
{
  const Numbers sums = sums_of_squares(levels, values);
  const unsigned n = 1u << levels.size(), random = last_is_random ? n >> 1 : 0;
  const auto cells = static_cast<double>(values.size());
  const double fillings = last_is_random ? levels.back() : 1;
  std::vector<VarianceTerm> terms;
  for (unsigned s = 1; s < n; ++s) {
    VarianceTerm term;
    term.factors = s;
    term.degrees = 1;
    for (std::size_t k = 0; k < levels.size(); ++k)
      if (s >> k & 1) term.degrees *= levels[k] - 1;
    if (term.degrees == 0) continue; // a factor of one level
    term.sum_of_squares = sums[s];
    term.f = term.p = unknown;
    if (!last_is_random) {
      term.variance = sums[s] / cells;
    } else if (s & random) {
      term.variance = sums[s] * fillings / (cells * (fillings - 1));
    } else {
      const double with_random = sums[s | random] / (fillings - 1);
      term.variance = (sums[s] - with_random) / cells;
      if (with_random > 0) {
        term.f = sums[s] / with_random; // the degrees of S cancel
        const boost::math::fisher_f f(term.degrees, term.degrees * (fillings - 1));
        term.p = boost::math::cdf(boost::math::complement(f, term.f));
      }
    }
    terms.push_back(term);
  }
  add_shares(terms);
  return terms;
}

std::vector<SobolIndex> sobol_indices(const Numbers& a, const Numbers& b,
                                      const std::vector<Numbers>& mixed, double& variance)
{
  Numbers both = a;
  both.insert(both.end(), b.begin(), b.end());
  variance = std::pow(sample_mean(both, 0.95).deviation, 2);
  std::vector<SobolIndex> indices;
  for (const Numbers& of_column : mixed) {
    SobolIndex index;
    const auto [unexplained, first_error] = half_squares(b, of_column, variance);
    index.first = 1 - unexplained;
    index.first_error = first_error;
    std::tie(index.total, index.total_error) = half_squares(a, of_column, variance);
    indices.push_back(index);
  }
  return indices;
}
} // namespace interlock::apps
