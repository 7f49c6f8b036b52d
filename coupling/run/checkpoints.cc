#include "coupling/run/checkpoints.h"

#include "coupling/state/checkpoint_file.h"
#include "dem/input_error.h"

#include <boost/algorithm/string/join.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace interlock::coupling
{
namespace
{
std::map<std::string, std::string> by_key(const std::vector<CaseEntry>& entries)
{
  std::map<std::string, std::string> result;
  for (const CaseEntry& entry : entries) result[entry.key] = entry.value;
  return result;
}
} // namespace

bool is_among(const std::string& key, const std::vector<std::string>& keys_and_sections)
{
  return std::any_of(
      keys_and_sections.begin(), keys_and_sections.end(), [&](const std::string& entry) {
        return entry == key || (entry.back() == '/' && key.compare(0, entry.size(), entry) == 0);
      });
}

Checkpoints::Checkpoints(std::filesystem::path folder, double interval, std::string program_version,
                         bool writes)
    : folder_(std::move(folder)), interval_(interval), program_version_(std::move(program_version)),
      writes_(writes)
{
}

bool Checkpoints::due() const
{
  const std::chrono::duration<double> since = std::chrono::steady_clock::now() - last_;
  return writes_ && interval_ > 0 && since.count() >= interval_;
}

void Checkpoints::write(const StateTree& state)
{
  if (!writes_) return;
  write_checkpoint(file(), state, program_version_);
  last_ = std::chrono::steady_clock::now();
}

void Checkpoints::write_as(const std::string& name, const StateTree& state) const
{
  if (!writes_) return;
  write_state(folder_ / name, state, program_version_);
}

StateTree Checkpoints::read() const
{
  std::error_code error;
  const std::filesystem::path before = previous_of(file());
  // A kill between two renames leaves the one before only.
  const bool whole = std::filesystem::exists(file(), error);
  return read_state(!whole && std::filesystem::exists(before, error) ? before : file());
}

void Checkpoints::clear() const
{
  if (!writes_) return;
  std::error_code error;
  std::filesystem::remove(file(), error);
  std::filesystem::remove(previous_of(file()), error);
}

bool has_checkpoint(const std::filesystem::path& folder)
{
  std::error_code error;
  const std::filesystem::path file = folder / "checkpoint.h5";
  return std::filesystem::exists(file, error) || std::filesystem::exists(previous_of(file), error);
}

std::vector<std::string> changed_entries(const std::vector<CaseEntry>& kept,
                                         const std::vector<CaseEntry>& now)
{
  const auto before = by_key(kept), after = by_key(now);
  std::vector<std::string> changed;
  for (const auto& [key, value] : before) {
    const auto found = after.find(key);
    if (found == after.end() || found->second != value) changed.push_back(key);
  }
  for (const auto& [key, value] : after)
    if (before.find(key) == before.end()) changed.push_back(key);
  return changed;
}

void require_same_case(const std::string& what, const std::vector<CaseEntry>& kept,
                       const std::vector<CaseEntry>& now,
                       const std::function<bool(const std::string& key)>& may_change)
{
  const auto before = by_key(kept), after = by_key(now);
  const auto value = [](const std::map<std::string, std::string>& entries, const std::string& key) {
    const auto found = entries.find(key);
    return found == entries.end() ? "not there" : "\"" + found->second + "\"";
  };
  std::vector<std::string> differences;
  for (const std::string& key : changed_entries(kept, now))
    if (!may_change(key))
      differences.push_back(
          fmt::format("{} was {} and is {} now", key, value(before, key), value(after, key)));
  if (differences.empty()) return;
  throw InputError(fmt::format("{} was made with other entries, which cannot change any more: {}.",
                               what, boost::algorithm::join(differences, "; ")));
}
} // namespace interlock::coupling
