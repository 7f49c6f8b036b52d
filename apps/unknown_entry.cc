#include "apps/unknown_entry.h"

#include "apps/nearest_name.h"

#include <boost/algorithm/string/join.hpp>

#include <algorithm>

namespace interlock::apps
{
using coupling::ParameterEntry;
using coupling::ParameterTable;

namespace
{
// The entry that is probably meant: one of the same name in another section, a similar name in this
// section, or, where there is no such section, a similar section and name. Empty when none is near.
std::string nearest_entry(const ParameterTable& table, const Assignment& assignment)
{
  std::vector<std::string> keys, siblings;
  for (const ParameterEntry& entry : table.entries()) {
    if (entry.name == assignment.name) return entry.key();
    keys.push_back(entry.key());
    if (entry.section == assignment.section) siblings.push_back(entry.name);
  }
  if (siblings.empty()) return nearest_name(assignment.key(), keys);
  Assignment nearest = assignment;
  nearest.name = nearest_name(assignment.name, siblings);
  return nearest.name.empty() ? "" : nearest.key();
}
} // namespace

const ParameterEntry* find_entry(const ParameterTable& table, const std::string& key)
{
  const auto& entries = table.entries();
  const auto found = std::find_if(entries.begin(), entries.end(),
                                  [&](const ParameterEntry& entry) { return entry.key() == key; });
  return found == entries.end() ? nullptr : &*found;
}

std::string explain_unknown(const ParameterTable& table, const Assignment& assignment)
{
  const std::string start = "there is no entry \"" + assignment.key() + "\"";
  const std::string nearest = nearest_entry(table, assignment);
  if (!nearest.empty()) return start + "; the nearest known one is \"" + nearest + "\".";
  std::vector<std::string> siblings;
  for (const ParameterEntry& entry : table.entries())
    if (entry.section == assignment.section) siblings.push_back('"' + entry.name + '"');
  if (siblings.empty()) return start + ", nor a section of this name.";
  return start + "; this section has " + boost::algorithm::join(siblings, ", ") + ".";
}
} // namespace interlock::apps
