#include "apps/clump_warnings.h"

#include <cmath>
#include <cstdio>

namespace interlock::apps
{
namespace
{
// The setting that ended the work before all nodes were drawn; empty if none did.
std::string stop_setting(dem::Stop stop)
{
  switch (stop) {
  case dem::Stop::max_spheres:
    return "a larger --max-spheres";
  case dem::Stop::p_max:
    return "a larger --p-max";
  case dem::Stop::volume_error:
    return "a smaller --target-volume-error";
  case dem::Stop::inertia_error:
    return "a smaller --target-inertia-error";
  case dem::Stop::all_nodes:
  case dem::Stop::no_gain:
    break;
  }
  return "";
}

// Balls smaller than the gap that D min keeps around a sphere have room beside it without reaching
// it. Of eight synthetic stones seven or all came out in pieces with --d-min from 1 to 8 mm and
// --r-min half of it; one did with both at 2 mm, none with both at 1 or at 4 mm, and none with
// --d-min below --r-min.
std::string joining_setting(const ClumpResult& result)
{
  const double d_min = result.parameters.d_min, r_min = result.parameters.r_min;
  const std::string stop = stop_setting(result.report.stop);
  // By gain a few spheres hang together, too.
  const std::string or_by_gain =
      result.report.stop == dem::Stop::max_spheres ? ", or --sphere-order gain" : "";
  if (d_min > r_min)
    return (stop.empty() ? "" : stop + " and ") + "--d-min not above --r-min" + or_by_gain;
  if (!or_by_gain.empty()) return stop + or_by_gain;
  if (!stop.empty()) return stop;
  return d_min > 0 ? "a smaller --d-min or a larger --r-min" : "a larger --r-min";
}

// On the same stones the union misses 8, 18 and 38 % of the volume with --d-min at 1, 2 and 4 mm,
// whatever --r-min below it; without --d-min 7 and 16 % with --r-min at 4 and 6 mm.
std::string filling_setting(const ClumpResult& result)
{
  const double d_min = result.parameters.d_min, r_min = result.parameters.r_min;
  if (const std::string stop = stop_setting(result.report.stop); !stop.empty()) return stop;
  if (d_min > 0 && d_min >= r_min) return "a smaller --d-min";
  if (d_min > 0) return "a smaller --d-min or --r-min";
  return result.report.rejected > 0 ? "a smaller --r-min" : "a scan with more nodes";
}

std::string smaller_spheres(const ClumpResult& result)
{
  if (result.facets == 0) return "a cloud with more points";
  if (result.parameters.touching_radius == dem::TouchingRadius::nodes)
    return "--touching-radius surface";
  return "a scan with more nodes";
}
} // namespace

std::string clump_warnings(const ClumpResult& result)
{
  const dem::ClumpReport& report = result.report;
  std::string text;
  char line[400];
  if (report.groups > 1) {
    std::snprintf(
        line, sizeof(line),
        "Warning: the spheres of '%s' are in %d groups that do not touch each other: choose %s.\n",
        result.name.c_str(), report.groups, joining_setting(result).c_str());
    text += line;
  }
  const bool was_asked_for = report.stop == dem::Stop::volume_error;
  if (std::abs(report.volume_error) > largest_volume_error && !was_asked_for) {
    const bool too_small = report.volume_error < 0;
    std::snprintf(line, sizeof(line),
                  "Warning: the union of the spheres of '%s' has %.0f %% %s volume than the stone: "
                  "choose %s.\n",
                  result.name.c_str(), 100 * std::abs(report.volume_error),
                  too_small ? "less" : "more",
                  (too_small ? filling_setting(result) : smaller_spheres(result)).c_str());
    text += line;
  }
  return text;
}
} // namespace interlock::apps
