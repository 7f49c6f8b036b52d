#include "apps/value_error.h"

#include <boost/algorithm/string.hpp>

#include <cstdlib>
#include <map>
#include <optional>
#include <sstream>

namespace interlock::apps
{
namespace
{
struct NumberWithUnit {
  double number = 0;
  std::string unit;
};

std::optional<NumberWithUnit> split_unit(const std::string& value)
{
  char* rest = nullptr;
  const double number = std::strtod(value.c_str(), &rest);
  const std::string unit = boost::trim_copy(std::string(rest));
  const bool has_unit = rest != value.c_str() && !unit.empty() &&
                        (std::isalpha(static_cast<unsigned char>(unit.front())) || unit == "%");
  if (!has_unit) return {};
  return NumberWithUnit{number, unit};
}

// Factor from `typed` to `unit` where they differ by a decimal prefix: mm to m, GPa to Pa.
std::optional<double> prefix_factor(const std::string& typed, const std::string& unit)
{
  static const std::map<std::string, double> prefixes = {
      {"", 1}, {"u", 1e-6}, {"m", 1e-3}, {"c", 1e-2}, {"k", 1e3}, {"M", 1e6}, {"G", 1e9}};
  if (!boost::ends_with(typed, unit)) return {};
  const auto found = prefixes.find(typed.substr(0, typed.size() - unit.size()));
  if (found == prefixes.end()) return {};
  return found->second;
}
} // namespace

std::string explain_bad_value(const coupling::ParameterEntry& entry, const std::string& value)
{
  std::ostringstream sentence;
  sentence << '"' << entry.key() << "\" is \"" << value << "\", but ";
  const auto typed = entry.unit.empty() ? std::nullopt : split_unit(value);
  if (typed && entry.unit == "-") {
    sentence << "must be " << entry.allowed << ", without a unit.";
  } else if (typed) {
    sentence << "values are written without their unit: give " << entry.allowed << ", in "
             << entry.unit;
    if (const auto factor = prefix_factor(typed->unit, entry.unit))
      sentence << " (here " << typed->number * *factor << ")";
    sentence << ".";
  } else {
    sentence << "must be " << entry.allowed;
    if (!entry.unit.empty() && entry.unit != "-") sentence << ", in " << entry.unit;
    sentence << ".";
  }
  return sentence.str();
}
} // namespace interlock::apps
