#include "apps/result_text.h"

#include <boost/algorithm/string.hpp>
#include <fmt/format.h>

#include <cmath>
#include <utility>
#include <vector>

namespace interlock::apps
{
namespace
{
// Endings of keys and their units; the longest that fits counts.
const std::vector<std::pair<std::string, std::string>> units = {
    {"N", "N"},           {"kN", "kN"},           {"m", "m"},
    {"mm", "mm"},         {"kg", "kg"},           {"s", "s"},
    {"J", "J"},           {"Hz", "Hz"},           {"Pa", "Pa"},
    {"deg", "deg"},       {"kg_per_m3", "kg/m3"}, {"kg_per_m2", "kg/m2"},
    {"m_per_s", "m/s"},   {"N_per_m", "N/m"},     {"kN_per_m", "kN/m"},
    {"N_m", "N m"},       {"mg_cm", "mg cm"},     {"N_m_per_deg", "N m/deg"},
    {"W", "W"},           {"us", "us"},           {"m3", "m3"},
    {"Pa_per_m", "Pa/m"}, {"percent", "%"},       {"s_per_step", "s a step"}};

std::pair<std::string, std::string> name_and_unit(const std::string& key)
{
  std::pair<std::string, std::string> best{key, ""};
  for (const auto& [ending, unit] : units) {
    if (!boost::ends_with(key, "_" + ending)) continue;
    const std::string name = key.substr(0, key.size() - ending.size() - 1);
    if (best.second.empty() || name.size() < best.first.size()) best = {name, " " + unit};
  }
  boost::replace_all(best.first, "_", " ");
  return best;
}
// Units that people say for small and large values: 12.65 mm, 3.552 us, 30 kPa.
std::pair<double, std::string> readable(double value, const std::string& unit)
{
  const double size = std::abs(value);
  if (unit == " m" && size < 1 && size > 0) return {1e3 * value, " mm"};
  if ((unit == " s" || unit == " s a step") && size < 1e-3 && size > 0)
    return {1e6 * value, " us" + unit.substr(2)};
  if (unit == " N" && size >= 1e4) return {1e-3 * value, " kN"};
  if (unit == " Pa" && size >= 1e6) return {1e-6 * value, " MPa"};
  if (unit == " Pa" && size >= 1e3) return {1e-3 * value, " kPa"};
  return {value, unit};
}
} // namespace

std::string result_text(const std::string& key, const nlohmann::ordered_json& value)
{
  const auto [name, unit] = name_and_unit(key);
  if (value.is_null()) return name + " = not finite";
  if (value.is_string()) return name + " = " + value.get<std::string>();
  if (value.is_number_float()) {
    const auto [number, its_unit] = readable(value.get<double>(), unit);
    return fmt::format("{} = {:.4g}{}", name, number, its_unit);
  }
  return name + " = " + value.dump() + unit;
}
} // namespace interlock::apps
