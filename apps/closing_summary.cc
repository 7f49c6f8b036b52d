#include "apps/closing_summary.h"

#include "apps/progress.h"
#include "apps/result_text.h"
#include "apps/shell_word.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <vector>

namespace interlock::apps
{
namespace
{
constexpr std::size_t most_results = 12; // lines

// What is asked first of an experiment; what a run has not got is left out.
const std::map<std::string, std::vector<std::string>>& headlines()
{
  static const std::map<std::string, std::vector<std::string>> names = {
      {"pull-out",
       {"not_usable_from_mm", "peak_pull_force_N", "displacement_at_peak_m", "pull_force_at_end_N",
        "pull_distance_m", "largest_axial_force_in_a_rib_N", "largest_stretch_of_a_rib",
        "mass_in_box_kg", "mass_above_geogrid_kg", "apparent_density_kg_per_m3",
        "porosity_of_stones", "largest_overlap_over_mean_sphere_radius", "stones_lost_through_slot",
        "surcharge_N"}},
      {"heap",
       {"angle_of_repose_deg", "angle_of_repose_scatter_over_azimuths_deg", "height_m", "r50_m",
        "radius_of_gyration_m", "mass_kg", "stones_lost_over_the_edge",
        "time_to_rest_after_last_release_s", "largest_overlap_over_mean_sphere_radius"}},
      {"shear box",
       {"not_usable_from_mm", "peak_friction_angle_deg", "residual_friction_angle_deg",
        "dilation_angle_at_peak_deg", "displacement_at_peak_m", "normal_stress_Pa",
        "peak_shear_stress_Pa", "stones", "mass_kg", "bulk_density_kg_per_m3", "porosity",
        "inertial_number", "largest_overlap_over_mean_sphere_radius"}},
      {"triaxial",
       {"not_usable_from_mm", "peak_friction_angle_deg", "residual_friction_angle_deg",
        "dilation_angle_at_peak_deg", "strain_at_peak", "cell_pressure_Pa", "peak_deviator_Pa",
        "stones", "mass_kg", "bulk_density_kg_per_m3", "porosity", "inertial_number",
        "largest_overlap_over_mean_sphere_radius"}},
      {"packing",
       {"contacts_s_per_step", "integration_s_per_step", "lists_s_per_step",
        "broad_phase_s_per_step", "output_s_per_step", "carried_weight_over_weight"}}};
  return names;
}

// Tables and sentences within the results have no place in a line, and no word is no news.
bool fits_a_line(const nlohmann::ordered_json& value)
{
  constexpr std::size_t most_letters = 50;
  if (!value.is_string()) return !value.is_structured();
  const std::size_t letters = value.get_ref<const std::string&>().size();
  return letters > 0 && letters <= most_letters;
}

std::vector<std::string> in_order(const coupling::Summary& summary)
{
  std::vector<std::string> order;
  const auto add = [&](const std::string& name) {
    if (!summary.results.contains(name) || !fits_a_line(summary.results[name])) return;
    if (std::find(order.begin(), order.end(), name) == order.end()) order.push_back(name);
  };
  const auto of_experiment = headlines().find(summary.experiment);
  if (of_experiment != headlines().end())
    for (const std::string& name : of_experiment->second) add(name);
  for (const auto& result : summary.results.items()) add(result.key());
  return order;
}

std::size_t numbers_in(const nlohmann::ordered_json& value)
{
  if (!value.is_structured()) return 1;
  std::size_t sum = 0;
  for (const auto& part : value) sum += numbers_in(part);
  return sum;
}
} // namespace

std::string closing_summary(const coupling::Summary& summary, const std::filesystem::path& folder)
{
  std::string text = "Done: ";
  if (summary.clumps > 0)
    text += fmt::format("{} stones of {} spheres, ", summary.clumps, summary.spheres);
  text += fmt::format("{} steps in {}.", summary.steps, duration_text(summary.wall_time));
  std::vector<std::string> order = in_order(summary);
  if (order.size() > most_results) order.resize(most_results);
  for (const std::string& name : order) text += "\n  " + result_text(name, summary.results[name]);
  if (summary.energy.contains("relative_error") && summary.energy["relative_error"].is_number())
    text += fmt::format("\n  error of the energy ledger = {:.2g} % of the work put in",
                        100 * summary.energy["relative_error"].get<double>());
  if (const std::size_t n = summary.warnings.size(); n > 0)
    text += fmt::format("\n  {} warning{}, see above", n, n == 1 ? "" : "s");
  const std::size_t numbers = numbers_in(summary.results) + numbers_in(summary.energy);
  text += fmt::format("\n  ... all {} numbers, with all their digits: {}", numbers,
                      (folder / "summary.json").string());
  return text + "\nEverything is in " + folder.string() + '.';
}

std::string next_step(const std::filesystem::path& folder, bool draws_figures)
{
  std::error_code error;
  const std::filesystem::path page = folder / "report.html";
  if (std::filesystem::is_regular_file(page, error))
    return "Look at it in a browser: " + page.string();
  if (draws_figures)
    return "Draw figures and page again: interlock report " + shell_word(folder.string());
  return "Numbers for a script: " + (folder / "summary.json").string();
}
} // namespace interlock::apps
