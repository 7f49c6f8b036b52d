#include "apps/clump_writing.h"

#include "dem/export/member_volumes.h"
#include "dem/input_error.h"

#include <nlohmann/json.hpp>

#include <cstdio>

namespace interlock::apps
{
namespace
{
namespace fs = std::filesystem;

double sum_deviation(const ClumpResult& result)
{
  return dem::sum_deviation(result.shape, dem::member_volumes(result.shape));
}

// What LAMMPS makes of the clump where it sums the spheres.
std::string sums_sentence(double deviation)
{
  if (deviation < dem::allowed_sum_deviation)
    return "the masses of its spheres sum to the stone's mass, centre and inertia.\n";
  char text[200];
  std::snprintf(
      text, sizeof(text),
      "the masses of its spheres sum to the stone's mass, but their moments are off by up "
      "to %.2g %%: insert with fix deposit or fix pour.\n",
      100 * deviation);
  return text;
}
} // namespace

std::vector<dem::FileText> clump_texts(const StoneFiles& files, const ClumpResult& result)
{
  std::vector<dem::FileText> texts = {{files.clump, dem::clump_shape_text(result.shape)}};
  for (const ExportFile& file : files.exports)
    for (dem::FileText& text :
         dem::clump_export_files(file.path, result.shape, file.format, result.density))
      texts.push_back(std::move(text));
  return texts;
}

void write_files(const std::vector<dem::FileText>& texts)
{
  std::error_code error;
  const fs::path folder = fs::absolute(texts.front().path).parent_path();
  fs::create_directories(folder, error); // a folder that is not there is said below
  if (const auto failed =
          fs::is_directory(folder, error) ? dem::write_atomically(texts) : texts.front().path)
    throw InputError("The file '" + failed->string() + "' cannot be written.");
}

void write_report(const std::string& path, const std::vector<ClumpResult>& results,
                  const std::vector<Refusal>& refusals, const std::vector<OrderRow>& orders)
{
  nlohmann::ordered_json report;
  const dem::ClumpParameters& p = results.front().parameters;
  report["version"] = INTERLOCK_VERSION;
  report["parameters"] = {
      {"d_min_m", p.d_min},
      {"r_min_m", p.r_min},
      {"p_max_percent", p.p_max},
      {"max_spheres", p.max_spheres},
      {"sphere_order", p.sphere_order == dem::SphereOrder::gain ? "gain" : "random"},
      {"bulge_m", p.bulge},
      {"target_volume_error", p.target_volume_error},
      {"target_inertia_error", p.target_inertia_error},
      {"touching_radius", p.touching_radius == dem::TouchingRadius::surface ? "surface" : "nodes"},
      {"seed", p.seed}};
  for (const ClumpResult& result : results) report["clumps"].push_back(clump_json(result));
  if (!orders.empty()) report["orders"] = orders_json(orders);
  for (const Refusal& refusal : refusals)
    report["refused"].push_back({{"file", refusal.stone}, {"reason", refusal.sentence}});
  // Names of files may hold bytes that are no UTF-8.
  write_files(
      {{path, report.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n"}});
}

std::string export_lines(const StoneFiles& files, const ClumpResult& result)
{
  std::string text;
  for (const ExportFile& file : files.exports) {
    text += "For " + file.format_name + ": '" + file.path + "'\n";
    if (file.format == dem::ClumpFormat::lammps)
      text += "  " + sums_sentence(sum_deviation(result));
  }
  return text;
}

std::string export_remarks(const StoneFiles& files, const ClumpResult& result)
{
  const std::string of = "  '" + files.name + "': ";
  std::string text, renamed, name;
  for (const ExportFile& file : files.exports) {
    const std::string written = fs::path(file.path).stem().string();
    if (written != files.name) {
      renamed += (renamed.empty() ? "" : ", ") + file.format_name;
      name = written;
    }
    if (file.format != dem::ClumpFormat::lammps) continue;
    if (const double deviation = sum_deviation(result); deviation >= dem::allowed_sum_deviation)
      text += of + sums_sentence(deviation);
  }
  if (!renamed.empty()) text += of + "written as '" + name + "' for " + renamed + ".\n";
  return text;
}
} // namespace interlock::apps
