#include "apps/study/study_results.h"

#include <boost/algorithm/string/join.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace interlock::apps
{
namespace
{
using Numbers = std::vector<double>;

bool is_drawn(const Plan& plan)
{
  return plan.study.design == "latin hypercube" || plan.study.design == "sobol";
}

std::string sample_cells(const SampleMean& sample)
{
  return fmt::format("{},{},{},{}", sample.n, csv_number(sample.mean), csv_number(sample.deviation),
                     csv_number(sample.half_width));
}

// Runs by point and filling.
std::map<std::pair<int, int>, const RunRow*> rows_by_cell(const RunTable& table)
{
  std::map<std::pair<int, int>, const RunRow*> rows;
  for (const RunRow& row : table.rows) {
    const Task& task = table.plan->tasks[row.task];
    rows[{task.point, task.filling}] = &row;
  }
  return rows;
}

// One difference a filling: of level `level` of factor `k` less its first level.
std::vector<Numbers> paired(const RunTable& table, std::size_t k, int level,
                            const std::string& measure)
{
  const Plan& plan = *table.plan;
  const auto rows = rows_by_cell(table);
  std::map<std::vector<int>, int> point_at;
  for (std::size_t p = 0; p < plan.points.size(); ++p)
    point_at[plan.points[p].places] = static_cast<int>(p);
  Numbers differences, references;
  for (int filling = 0; filling < static_cast<int>(plan.study.fillings.levels.size()); ++filling) {
    double difference = 0, reference = 0;
    int pairs = 0;
    for (const Point& point : plan.points) {
      if (point.places[k] != level) continue;
      std::vector<int> partner = point.places;
      partner[k] = 0;
      if (point_at.count(partner) == 0) continue;
      const auto mine = table.usable(*rows.at({point_at[point.places], filling}), measure),
                 other = table.usable(*rows.at({point_at[partner], filling}), measure);
      if (!mine || !other) continue;
      difference += *mine - *other;
      reference += *other;
      ++pairs;
    }
    if (pairs == 0) continue;
    differences.push_back(difference / pairs);
    references.push_back(reference / pairs);
  }
  return {differences, references};
}

struct Term {
  std::string name, kind;
};

// Factors of the analysis: those of the study, or the points as one; the filling is the last one.
struct Layout {
  std::vector<int> levels;
  std::vector<Term> factors;
  bool filling_is_random = false;
};

Layout layout_of(const Plan& plan)
{
  Layout layout;
  if (plan.study.design == "grid") {
    for (const Factor& factor : plan.study.factors) {
      layout.levels.push_back(static_cast<int>(factor.levels.size()));
      layout.factors.push_back({factor.name, kind_name(factor.kind())});
    }
  } else {
    layout.levels.push_back(static_cast<int>(plan.points.size()));
    layout.factors.push_back({"point", "geogrid and set-up"});
  }
  const int fillings = static_cast<int>(plan.study.fillings.levels.size());
  layout.filling_is_random = fillings > 1;
  if (fillings > 1) {
    layout.levels.push_back(fillings);
    layout.factors.push_back({"filling", kind_name(FactorKind::filling)});
  }
  return layout;
}

// Name of a term, and the one kind that all of its factors have; else "several".
Term term_of(const Layout& layout, unsigned factors)
{
  std::vector<std::string> names;
  std::string kind;
  for (std::size_t k = 0; k < layout.factors.size(); ++k) {
    if ((factors >> k & 1) == 0) continue;
    names.push_back(layout.factors[k].name);
    kind = kind.empty() || kind == layout.factors[k].kind ? layout.factors[k].kind : "several";
  }
  return {boost::algorithm::join(names, " x "), kind};
}

// The value of every cell; empty where a run lacks it.
Numbers cells_of(const RunTable& table, const std::string& measure)
{
  Numbers values;
  for (const RunRow& row : table.rows) {
    const auto value = table.usable(row, measure);
    if (!value) return {};
    values.push_back(*value);
  }
  return values;
}

std::string anova_rows(const RunTable& table, const std::string& measure)
{
  const Layout layout = layout_of(*table.plan);
  const Numbers values = cells_of(table, measure);
  if (values.size() < 2 || layout.factors.size() > 10) return {};
  std::string text;
  std::map<std::string, std::pair<double, double>> kinds; // variance and share
  for (const VarianceTerm& term :
       analysis_of_variance(layout.levels, values, layout.filling_is_random)) {
    const Term named = term_of(layout, term.factors);
    text += fmt::format("{},{},{},{},{},{},{},{},{}\n", csv_cell(measure), csv_cell(named.name),
                        named.kind, csv_number(term.degrees), csv_number(term.sum_of_squares),
                        csv_number(term.variance), csv_number(term.share), csv_number(term.f),
                        csv_number(term.p));
    kinds[named.kind].first += term.variance;
    kinds[named.kind].second += term.share;
  }
  for (const auto& [kind, sums] : kinds)
    text += fmt::format("{},all of {},{},,,{},{},,\n", csv_cell(measure), kind, kind,
                        csv_number(sums.first), csv_number(sums.second));
  return text;
}

// Runs stand in the order A, B, A with column 1 of B, ...
std::string sobol_rows(const RunTable& table, const std::string& measure)
{
  const Plan& plan = *table.plan;
  const int columns = sobol_columns(plan.study);
  const Numbers values = cells_of(table, measure);
  if (values.empty()) return {};
  Numbers a, b;
  std::vector<Numbers> mixed(columns);
  for (std::size_t k = 0; k < values.size(); k += columns + 2) {
    a.push_back(values[k]);
    b.push_back(values[k + 1]);
    for (int i = 0; i < columns; ++i) mixed[i].push_back(values[k + 2 + i]);
  }
  double variance = 0;
  const std::vector<SobolIndex> indices = sobol_indices(a, b, mixed, variance);
  std::string text;
  for (int i = 0; i < columns; ++i) {
    const bool is_filling = i == static_cast<int>(plan.study.factors.size());
    const std::string name = is_filling ? "filling" : plan.study.factors[i].name;
    const FactorKind kind = is_filling ? FactorKind::filling : plan.study.factors[i].kind();
    text += fmt::format("{},{},{},{},{},{},{},{}\n", csv_cell(measure), csv_cell(name),
                        kind_name(kind), csv_number(variance), csv_number(indices[i].first),
                        csv_number(indices[i].first_error), csv_number(indices[i].total),
                        csv_number(indices[i].total_error));
  }
  return text;
}
} // namespace

std::string point_name(const Plan& plan, int point)
{
  std::vector<std::string> parts;
  for (std::size_t f = 0; f < plan.study.factors.size(); ++f)
    parts.push_back(plan.study.factors[f].name + "=" + plan.points[point].levels[f].name);
  return parts.empty() ? "base case" : boost::algorithm::join(parts, ", ");
}

std::string means_csv(const RunTable& table)
{
  const Plan& plan = *table.plan;
  std::string text = "point,measure,n,mean,standard_deviation,half_width_of_interval\n";
  const bool sobol = plan.study.design == "sobol"; // its rows are one sample of all
  for (int p = 0; p < (sobol ? 1 : static_cast<int>(plan.points.size())); ++p)
    for (const std::string& measure : table.measures) {
      Numbers values;
      for (const RunRow& row : table.rows) {
        const int point = plan.tasks[row.task].point;
        const bool mine = sobol ? point % (sobol_columns(plan.study) + 2) < 2 : point == p;
        if (const auto value = mine ? table.usable(row, measure) : std::optional<double>())
          values.push_back(*value);
      }
      text += csv_cell(sobol ? "all of A and B" : point_name(plan, p)) + ',' + csv_cell(measure) +
              ',' + sample_cells(sample_mean(values, plan.study.confidence)) + '\n';
    }
  return text;
}

std::string differences_csv(const RunTable& table)
{
  const Plan& plan = *table.plan;
  std::string text = "factor,level,less,measure,n,mean_difference,standard_deviation,"
                     "half_width_of_interval,mean_of_reference\n";
  if (is_drawn(plan)) return text;
  for (std::size_t k = 0; k < plan.study.factors.size(); ++k) {
    const Factor& factor = plan.study.factors[k];
    for (std::size_t level = 1; level < factor.levels.size(); ++level)
      for (const std::string& measure : table.measures) {
        const auto values = paired(table, k, static_cast<int>(level), measure);
        text += fmt::format("{},{},{},{},{},{}\n", csv_cell(factor.name),
                            csv_cell(factor.levels[level].name), csv_cell(factor.levels[0].name),
                            csv_cell(measure),
                            sample_cells(sample_mean(values[0], plan.study.confidence)),
                            csv_number(sample_mean(values[1], plan.study.confidence).mean));
      }
  }
  return text;
}

std::string variance_csv(const RunTable& table)
{
  const bool sobol = table.plan->study.design == "sobol";
  std::string text =
      sobol ? "measure,factor,kind,variance,first_index,standard_error_of_first,total_index,"
              "standard_error_of_total\n"
            : "measure,term,kind,degrees_of_freedom,sum_of_squares,variance,share,F,p\n";
  for (const std::string& measure : table.measures)
    text += sobol ? sobol_rows(table, measure) : anova_rows(table, measure);
  return text;
}
} // namespace interlock::apps
