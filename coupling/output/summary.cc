#include "coupling/output/summary.h"

#include "coupling/files/atomic_file.h"

#include <iomanip>
#include <sstream>

namespace interlock::coupling
{
namespace
{
nlohmann::ordered_json to_json(const StageSummary& stage)
{
  return {{"name", stage.name},
          {"steps", stage.steps},
          {"simulated_time_s", stage.simulated_time},
          {"wall_time_s", stage.wall_time}};
}

// An empty member must be {} in the file, not null.
nlohmann::ordered_json object(const nlohmann::ordered_json& value)
{
  return value.is_null() ? nlohmann::ordered_json::object() : value;
}

// Why nobody should use the results; empty when they may.
std::string not_usable(const Summary& summary)
{
  return summary.ledger_closes ? summary.not_usable
                               : "A tenth of the work or more was made or lost.";
}
} // namespace

std::string hexadecimal(const std::uint64_t hash)
{
  std::ostringstream text;
  text << std::hex << std::setw(16) << std::setfill('0') << hash;
  return text.str();
}

void add_ledger(Summary& summary, const EnergyLedger& ledger)
{
  for (const auto& [name, value] : ledger.entries()) summary.energy[name + "_J"] = value;
  summary.energy["residual_J"] = ledger.residual();
  summary.energy["work_put_in_J"] = ledger.work_put_in();
  summary.energy["relative_error"] = ledger.relative_error();
}

nlohmann::ordered_json to_json(const Summary& summary)
{
  nlohmann::ordered_json stages = nlohmann::ordered_json::array();
  for (const StageSummary& stage : summary.stages) stages.push_back(to_json(stage));
  const double mean =
      summary.steps > 0 ? summary.wall_time / static_cast<double>(summary.steps) : 0;
  const double per_step = summary.wall_time_per_step > 0 ? summary.wall_time_per_step : mean;
  return {{"version", summary.version},
          {"origin", object(summary.origin)},
          {"parameters_hash", summary.parameters_hash},
          {"experiment", summary.experiment},
          {"ranks", summary.ranks},
          {"seed", summary.seed},
          {"clumps", summary.clumps},
          {"spheres", summary.spheres},
          {"time_step_s", summary.time_step},
          {"steps", summary.steps},
          {"simulated_time_s", summary.simulated_time},
          {"wall_time_s", summary.wall_time},
          {"wall_time_per_step_s", per_step},
          {"stages", stages},
          {"contacts", summary.contacts},
          {"energy", object(summary.energy)},
          {"results", object(summary.results)},
          {"warnings", summary.warnings},
          {"not_usable", not_usable(summary)},
          {"state_hash", hexadecimal(summary.state_hash)}};
}

void write_summary(const std::filesystem::path& file, const Summary& summary)
{
  write_atomically(file, to_json(summary).dump(2) + '\n');
}
} // namespace interlock::coupling
