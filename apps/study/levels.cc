#include "apps/study/levels.h"

#include "dem/input_error.h"

#include <boost/algorithm/string.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <set>
#include <sstream>

namespace interlock::apps
{
namespace
{
[[noreturn]] void refuse(const Assignment& line, const std::string& sentence)
{
  throw InputError(line.place + ": \"" + line.name + "\" " + sentence);
}

std::optional<double> number(const std::string& text)
{
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !std::isfinite(value)) return {};
  return value;
}

// "Section/Entry" and its value, at the place of the line.
Assignment assignment(const Assignment& line, const std::string& key, const std::string& value)
{
  Assignment result = parse_override(key + "=" + value);
  result.place = line.place;
  result.base = line.base;
  result.file = line.file;
  return result;
}

// A number whose text is the same number again, with six digits: nobody wants 0.61803398874989.
std::string short_number(double value)
{
  return fmt::format("{:.6g}", value);
}

// LOW to HIGH [in COUNT] [log]
bool read_range(const Assignment& line, Factor& factor)
{
  std::istringstream words(line.value);
  std::vector<std::string> word{std::istream_iterator<std::string>(words), {}};
  if (word.size() < 3 || word[1] != "to") return false;
  if (word.back() == "log") {
    factor.is_logarithmic = true;
    word.pop_back();
  }
  const auto low = number(word[0]), high = number(word[2]);
  const bool counted = word.size() == 5 && word[3] == "in";
  const auto count = counted ? number(word[4]) : std::optional<double>(2);
  if (!low || !high || !count || (word.size() != 3 && !counted))
    refuse(line,
           "is \"" + line.value +
               "\", but a range is written \"LOW to HIGH\", \"LOW to HIGH in COUNT\" or one of "
               "these with \"log\" behind it.");
  if (!(*low < *high))
    refuse(line, "is \"" + line.value + "\": the upper end must be above the lower one.");
  if (factor.is_logarithmic && !(*low > 0))
    refuse(line, "is \"" + line.value + "\": a range with \"log\" must begin above 0.");
  if (*count != std::floor(*count) || *count < 2 || *count > 1000)
    refuse(line, "is \"" + line.value + "\": the count must be an integer from 2 to 1000.");
  factor.is_range = true;
  factor.low = *low, factor.high = *high;
  for (int k = 0; k < static_cast<int>(*count); ++k)
    factor.levels.push_back(factor.at(k / (*count - 1)));
  return true;
}

Level read_level(const Assignment& line, const std::string& text)
{
  const auto colon = text.find(':');
  Level level;
  level.name = boost::trim_copy(text.substr(0, colon));
  if (colon == std::string::npos || level.name.empty())
    refuse(line,
           "has the level \"" + text +
               "\", but a level is written \"NAME: Section/Entry=VALUE & Section/Entry=VALUE\"; a "
               "factor without level names must be an entry of the base case.");
  std::vector<std::string> changes;
  const std::string rest = boost::trim_copy(text.substr(colon + 1));
  if (!rest.empty()) boost::split(changes, rest, boost::is_any_of("&"));
  for (const std::string& change : changes) {
    const auto equals = change.find('=');
    const std::string key = boost::trim_copy(change.substr(0, equals));
    if (equals == std::string::npos || key.empty())
      refuse(line, "has the change \"" + boost::trim_copy(change) + "\" in its level \"" +
                       level.name + "\", which lacks the \"=\" between entry and value.");
    level.entries.push_back(assignment(line, key, boost::trim_copy(change.substr(equals + 1))));
  }
  return level;
}
} // namespace

std::string kind_name(FactorKind kind)
{
  if (kind == FactorKind::filling) return "filling";
  return kind == FactorKind::geogrid ? "geogrid" : "set-up";
}

Level Factor::at(double share) const
{
  if (!is_range) {
    const int n = static_cast<int>(levels.size());
    return levels[std::min(n - 1, static_cast<int>(share * n))];
  }
  const double value =
      is_logarithmic ? low * std::pow(high / low, share) : low + share * (high - low);
  const std::string text = short_number(value);
  return {text, {assignment(source, source.name, text)}};
}

FactorKind Factor::kind() const
{
  bool any = false;
  for (const Level& level : levels)
    for (const Assignment& entry : level.entries) {
      any = true;
      if (entry.section != "Geogrid" && entry.section != "Product") return FactorKind::set_up;
    }
  return any ? FactorKind::geogrid : FactorKind::set_up;
}

std::vector<std::string> split_list(const std::string& text)
{
  std::vector<std::string> parts;
  if (boost::trim_copy(text).empty()) return parts;
  boost::split(parts, text, boost::is_any_of(","));
  for (std::string& part : parts) boost::trim(part);
  return parts;
}

Factor read_factor(const Assignment& line)
{
  Factor factor;
  factor.name = line.name;
  factor.source = line;
  if (read_range(line, factor)) return factor;
  const std::vector<std::string> texts = split_list(line.value);
  if (texts.empty()) refuse(line, "has no values.");
  const bool named = line.name.find('/') == std::string::npos &&
                     std::any_of(texts.begin(), texts.end(), [](const std::string& text) {
                       return text.find(':') != std::string::npos;
                     });
  std::set<std::string> names;
  for (const std::string& text : texts) {
    if (text.empty()) refuse(line, "has an empty place between two commas.");
    factor.levels.push_back(named ? read_level(line, text)
                                  : Level{text, {assignment(line, line.name, text)}});
    if (!names.insert(factor.levels.back().name).second)
      refuse(line, "has the level \"" + factor.levels.back().name + "\" twice.");
  }
  return factor;
}
} // namespace interlock::apps
