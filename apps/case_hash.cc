#include "apps/case_hash.h"

#include "apps/parameter_scanner.h"
#include "coupling/output/summary.h"
#include "coupling/state/state_archive.h"
#include "dem/input_error.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <vector>

namespace interlock::apps
{
namespace fs = std::filesystem;

namespace
{
template <class Value> std::string hash_of_value(const char* name, Value value)
{
  coupling::StateTree tree;
  coupling::StateWriter archive(tree);
  archive(name, value);
  return coupling::hexadecimal(coupling::hash_of(tree));
}
} // namespace

std::string file_hash(const fs::path& file)
{
  std::error_code error;
  std::ifstream stream(file, std::ios::binary);
  if (!stream || !fs::is_regular_file(file, error)) return "";
  return hash_of_value("content", std::string(std::istreambuf_iterator<char>(stream), {}));
}

std::string case_hash(const fs::path& parameter_file)
{
  const ScannedFile scanned = scan_parameter_file(parameter_file);
  if (!scanned.errors.empty()) throw InputError(scanned.errors.front());
  std::vector<std::string> lines;
  for (const Assignment& entry : scanned.assignments)
    lines.push_back(entry.key() + "=" + entry.value);
  std::sort(lines.begin(), lines.end());
  return hash_of_value("lines", lines);
}

void require_one_run(const fs::path& folder)
{
  const fs::path used = folder / "used.prm", summary = folder / "summary.json";
  if (!fs::is_regular_file(used) || !fs::is_regular_file(summary)) return;
  std::ifstream stream(summary);
  const auto json = nlohmann::json::parse(stream, nullptr, false);
  if (!json.is_object() || !json.contains("parameters_hash")) return;
  if (json["parameters_hash"] != case_hash(used))
    throw InputError("\"" + used.string() + "\" and \"" + summary.string() +
                     "\" do not belong together: they are of two runs, or entries were changed "
                     "since; nothing was drawn.");
}
} // namespace interlock::apps
