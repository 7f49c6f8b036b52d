// How much of the variance of a result belongs to what was varied. No tables, no files: numbers.
#pragma once

#include <string>
#include <vector>

namespace interlock::apps
{
// Mean of a sample and how sure it is.
struct SampleMean {
  int n = 0;
  double mean = 0;
  double deviation = 0;  // standard deviation of the sample, n - 1; not a number for n < 2
  double half_width = 0; // of the confidence interval of the mean: t_(n-1) s/sqrt(n); likewise
};
SampleMean sample_mean(const std::vector<double>& values, double confidence);

// A main effect or an interaction: a subset of the factors, as bits.
struct VarianceTerm {
  unsigned factors = 0;
  double degrees = 0;        // of freedom
  double sum_of_squares = 0; // of the effect over all runs
  double variance = 0;       // estimate of its part of the variance of a run; may be negative
  double share = 0;          // of the sum of the variances that are not negative
  double f = 0, p = 0;       // of the test against the interaction with the random factor; not a
                             // number where there is none
};

// Analysis of variance of a complete grid with one run a cell. `levels`: of each factor; `values`
// with the last factor changing fastest. The sums of squares add up to that of all values about
// their mean. Where the last factor is random (fillings, a sample of f of all that there could be)
// and the others are fixed, with P cells of these, N = P f:
//     variance of the random factor F and of interactions SF with it   SS/(P (f - 1))
//     variance of a term S of fixed factors      (SS_S - SS_SF/(f - 1))/N,   F = MS_S/MS_SF
// the restricted mixed model (Montgomery, Design and Analysis of Experiments, 8th ed., chapter 13).
// Otherwise the variance of a term is SS/N. At most ten factors.
std::vector<VarianceTerm> analysis_of_variance(const std::vector<int>& levels,
                                               const std::vector<double>& values,
                                               bool last_is_random);

// Sobol's indices of one column of the matrices.
struct SobolIndex {
  double first = 0, total = 0;             // of the variance
  double first_error = 0, total_error = 0; // standard errors
};

// f(A), f(B), and f(A with column i of B), i by i: Jansen's estimators, the best of table 2 in
// Saltelli et al., Comput. Phys. Commun. 181 (2010) 259-270:
//     S_i = 1 - sum (f(B) - f(AB_i))^2/(2 n V),  T_i = sum (f(A) - f(AB_i))^2/(2 n V),
// with V the variance of f(A) and f(B) together. `variance` receives V.
std::vector<SobolIndex> sobol_indices(const std::vector<double>& a, const std::vector<double>& b,
                                      const std::vector<std::vector<double>>& mixed,
                                      double& variance);
} // namespace interlock::apps
