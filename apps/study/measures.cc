#include "apps/study/measures.h"

#include "apps/study/levels.h"
#include "coupling/stones/curve_measures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>

namespace interlock::apps
{
namespace
{
namespace fs = std::filesystem;
using Columns = std::map<std::string, std::vector<double>>;
using Numbers = std::vector<double>;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

// On the broken line through the points; unknown beyond its end.
double value_at(const Numbers& place, const Numbers& value, double at)
{
  if (place.empty() || at < place.front() || at > place.back()) return unknown;
  const auto above = std::lower_bound(place.begin(), place.end(), at);
  const std::size_t k = above - place.begin();
  if (k == 0) return value.front();
  return value[k - 1] + (at - place[k - 1]) / (place[k] - place[k - 1]) * (value[k] - value[k - 1]);
}

// Forces between records, from `begin` on: their mean, and their r.m.s. about the straight line of
// least squares.
std::pair<double, double> mean_and_fluctuation(const Numbers& place, const Numbers& force,
                                               double begin)
{
  const double end = place.back(),
               slope = coupling::slope_around(place, force, 0.5 * (begin + end), end - begin);
  double n = 0, x = 0, y = 0, squares = 0;
  const auto counts = [&](std::size_t k) { return k > 0 && place[k] >= begin; };
  for (std::size_t k = 0; k < place.size(); ++k)
    if (counts(k)) n += 1, x += place[k], y += force[k];
  if (n < 3) return {unknown, unknown};
  for (std::size_t k = 0; k < place.size(); ++k)
    if (counts(k)) squares += std::pow(force[k] - y / n - slope * (place[k] - x / n), 2);
  return {y / n, std::sqrt(squares / n)};
}

// Secant from the start to where the force first has made half of its way to its highest value
// within `length`.
double initial_stiffness(const Numbers& place, const Numbers& smooth, double length)
{
  double highest = smooth.front();
  for (std::size_t k = 0; k < place.size() && place[k] <= length; ++k)
    highest = std::max(highest, smooth[k]);
  const double half = 0.5 * (highest - smooth.front());
  const double at = coupling::first_place_at(place, smooth, smooth.front() + half) - place.front();
  return at > 0 ? half / at : unknown;
}

// Where the work put in during the pull went.
void add_energy_split(const Columns& history, std::vector<Measure>& measures)
{
  const auto change = [&](const char* name) {
    const auto column = history.find(std::string("energy_") + name);
    return column == history.end() ? 0. : column->second.back() - column->second.front();
  };
  const double put_in = change("clamp_work") + change("wall_work") + change("inserted");
  const auto add = [&](const char* name, double energy) {
    measures.push_back(
        {std::string("energy_share_") + name, put_in != 0 ? energy / put_in : unknown});
  };
  add("friction", change("friction"));
  add("contact_damping", change("contact_damping"));
  add("crushing", change("crushing"));
  add("geogrid_damping", change("geogrid_damping"));
  add("elastic_contacts", change("elastic_contacts"));
  add("elastic_geogrid", change("elastic_geogrid"));
  add("gravitational", change("gravitational"));
  add("kinetic", change("kinetic_stones") + change("kinetic_geogrid"));
}

// Mean load of each rib over the records of the pull, over that of all ribs together.
void add_load_shares(const Columns& history, std::vector<Measure>& measures)
{
  const auto mean = [](const Numbers& loads) {
    double sum = 0;
    for (std::size_t k = 1; k < loads.size(); ++k) sum += loads[k];
    return sum / static_cast<double>(loads.size() - 1);
  };
  const auto longitudinal = history.find("longitudinal_ribs_load");
  if (longitudinal == history.end() || longitudinal->second.size() < 2) return;
  double all = mean(longitudinal->second);
  Numbers loads;
  for (int rib = 0;; ++rib) {
    const auto column = history.find(fmt::format("transverse_rib_{}_load", rib));
    if (column == history.end()) break;
    loads.push_back(mean(column->second));
    all += loads.back();
  }
  const auto share = [&](double load) { return all != 0 ? load / all : unknown; };
  for (std::size_t rib = 0; rib < loads.size(); ++rib)
    measures.push_back({fmt::format("load_share_transverse_rib_{}", rib), share(loads[rib])});
  measures.push_back({"load_share_longitudinal_ribs", share(mean(longitudinal->second))});
}

void add_pull_out(const Columns& history, const MeasureOptions& options,
                  std::vector<Measure>& measures)
{
  const auto place_column = history.find("displacement"), force_column = history.find("pull_force");
  if (place_column == history.end() || force_column == history.end() ||
      place_column->second.size() < 3)
    return;
  const Numbers &place = place_column->second, &force = force_column->second;
  const Numbers smooth = coupling::centred_mean(place, force, options.mean_over);
  for (const double at : options.forces_at)
    measures.push_back(
        {fmt::format("force_at_{:g}_mm_N", 1e3 * at), value_at(place, smooth, at), at});
  measures.push_back({"initial_stiffness_N_per_m",
                      initial_stiffness(place, smooth, options.stiffness_over),
                      options.stiffness_over});
  const auto peak = std::max_element(smooth.begin() + 1, smooth.end());
  measures.push_back({"peak_force_N", *peak});
  measures.push_back({"displacement_at_peak_force_mm", 1e3 * place[peak - smooth.begin()]});
  const auto [mean, fluctuation] =
      mean_and_fluctuation(place, force, options.fluctuation_from * place.back());
  measures.push_back({"mean_force_N", mean});
  measures.push_back({"fluctuation_N", fluctuation});
  add_energy_split(history, measures);
  add_load_shares(history, measures);
}
} // namespace

Columns read_history(const fs::path& run)
{
  std::ifstream in(run / "history.csv");
  std::string line;
  if (!std::getline(in, line)) return {};
  const std::vector<std::string> heads = split_list(line);
  std::vector<Numbers> columns(heads.size());
  std::vector<bool> is_text(heads.size(), false);
  while (std::getline(in, line)) {
    const std::vector<std::string> cells = split_list(line);
    if (cells.size() != heads.size()) continue;
    for (std::size_t c = 0; c < cells.size(); ++c) {
      char* end = nullptr;
      columns[c].push_back(std::strtod(cells[c].c_str(), &end));
      if (*end != '\0') is_text[c] = true;
    }
  }
  Columns result;
  for (std::size_t c = 0; c < heads.size(); ++c)
    if (!is_text[c]) result[heads[c].substr(0, heads[c].find(" ["))] = columns[c];
  return result;
}

std::vector<Measure> measures_of(const fs::path& run, const nlohmann::ordered_json& summary,
                                 const MeasureOptions& options)
{
  std::vector<Measure> measures;
  if (summary.value("experiment", "") == "pull-out")
    add_pull_out(read_history(run), options, measures);
  for (const auto& [name, value] : summary["results"].items())
    if (value.is_number()) measures.push_back({name, value.get<double>()});
  return measures;
}
} // namespace interlock::apps
