#include "apps/clump_table.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>

namespace interlock::apps
{
namespace
{
constexpr const char* scheme_names[] = {"uniform", "equal-mass", "mesh"};

const char* stop_text(dem::Stop stop)
{
  switch (stop) {
  case dem::Stop::no_gain:
    return "no sphere left that adds to the shape";
  case dem::Stop::p_max:
    return "p_max";
  case dem::Stop::max_spheres:
    return "max_spheres";
  case dem::Stop::volume_error:
    return "target_volume_error";
  case dem::Stop::inertia_error:
    return "target_inertia_error";
  case dem::Stop::all_nodes:
    break;
  }
  return "all nodes drawn";
}

// Noise of a cloud that is worth a sentence [-].
constexpr double noted_volume_excess = 0.01;

double used(const dem::ClumpReport& report)
{
  return 100. * report.nodes_used / report.nodes;
}

double equivalent_diameter(double volume)
{
  return std::cbrt(6 * volume / M_PI);
}
} // namespace

void print_clump(const ClumpResult& result)
{
  const dem::StoneSize& size = result.size;
  const dem::ClumpReport& report = result.report;
  if (result.facets > 0)
    std::printf("Stone '%s': %zu nodes, %zu facets\n", result.file.c_str(), result.nodes,
                result.facets);
  else
    std::printf(
        "Stone '%s': cloud of %zu points, gap in its surface %.2f %%, scatter %.1f %% of the "
        "spacing\n",
        result.file.c_str(), result.nodes, 100 * result.cloud.closure,
        100 * result.cloud.scatter / result.cloud.spacing);
  std::printf("%s", remarks(result).c_str());
  std::printf("  size %.2f x %.2f x %.2f mm, sieve size %.2f mm, equivalent diameter %.2f mm\n",
              1e3 * size.longest, 1e3 * size.intermediate, 1e3 * size.shortest, 1e3 * size.sieve,
              1e3 * equivalent_diameter(result.volume));
  std::printf("  volume %.4g cm3", 1e6 * result.volume);
  if (result.density > 0)
    std::printf(", mass %.2f g at %.0f kg/m3", 1e3 * result.density * result.volume,
                result.density);
  std::printf("; flatness %.3f, elongation %.3f, sphericity %.3f\n", size.flatness(),
              size.elongation(), size.sphericity);
  std::printf("Clump: %zu spheres, radius %.3f to %.3f mm; stopped by: %s\n",
              result.shape.spheres.size(), 1e3 * result.shape.spheres.back().radius,
              1e3 * result.shape.spheres.front().radius, stop_text(report.stop));
  std::printf("  nodes used %d of %d (%.2f %%), rejected below r_min %d\n", report.nodes_used,
              report.nodes, used(report), report.rejected);
  std::printf("  distance of the stone's surface: mean %.3f mm, 95 %% below %.3f mm, max %.3f mm\n",
              1e3 * report.surface_distance_mean, 1e3 * report.surface_distance_95,
              1e3 * report.surface_distance_max);
  std::printf("  volume of the spheres' union against the stone: %+.2f %% +- %.2f %%\n",
              100 * report.volume_error, 100 * report.volume_uncertainty);
  if (result.parameters.bulge > 0)
    std::printf("  spheres made larger by %.3f mm of %.3f mm allowed, to meet the volume\n",
                1e3 * report.bulge, 1e3 * result.parameters.bulge);
  std::printf("  groups of spheres that touch or overlap: %d\n", report.groups);
  std::printf("  %-16s %20s %20s %20s\n", "mass properties", "error of moments [%]",
              "axes off by [deg]", "centre off by [mm]");
  for (int k = 0; k < 3; ++k)
    std::printf("%s %-16s %20.2f %20.2f %20.3f\n",
                int(result.parameters.mass_scheme) == k ? " *" : "  ", scheme_names[k],
                100 * report.inertia_error[k], report.axis_error[k], 1e3 * report.centre_offset[k]);
  std::printf("  * used; the mass is that of the stone under each of them\n");
}

std::string remarks(const ClumpResult& result)
{
  std::string text;
  const auto add = [&](bool holds, const std::string& sentence) {
    if (holds) text += "  '" + result.name + "': " + sentence + ".\n";
  };
  const auto number = [](auto n) { return std::to_string(n); };
  const dem::MeshDiagnosis& mesh = result.mesh;
  add(mesh.degenerate_facets_dropped > 0, number(mesh.degenerate_facets_dropped) +
                                              " facets with two corners at one place were dropped");
  add(mesh.duplicate_facets_dropped > 0,
      number(mesh.duplicate_facets_dropped) + " facets that were there twice were dropped");
  add(mesh.facets_without_area > 0,
      number(mesh.facets_without_area) + " facets without area were kept");
  add(mesh.crossings.pairs > 0,
      "accepted although " + number(mesh.crossings.pairs) + " pairs of facets cross each other");
  add(!mesh.crossings.complete && result.facets > 0,
      "the search for facets that cross each other was given up: too many lie close together");
  for (const std::string& note : mesh.notes) add(true, note);
  const dem::PointCloudDiagnosis& cloud = result.cloud;
  for (const std::string& note : cloud.notes) add(true, note);
  add(cloud.duplicates_dropped > 0,
      number(cloud.duplicates_dropped) + " points that were there twice were dropped");
  add(cloud.disagreeing_normals > 0,
      number(cloud.disagreeing_normals) + " normals disagree with those of most neighbours");
  if (cloud.volume_excess > noted_volume_excess) {
    char sentence[250];
    std::snprintf(sentence, sizeof(sentence),
                  "its points scatter by %.3g mm along their normals, %.1f %% of their spacing, "
                  "which makes the volume too large by about %.1f %% (more if the normals were "
                  "fitted to these points)",
                  1e3 * cloud.scatter, 100 * cloud.scatter / cloud.spacing,
                  100 * cloud.volume_excess);
    add(true, sentence);
  }
  add(mesh.flipped || cloud.flipped, "turned inside out, as asked");
  add(!result.report.axes_are_distinct,
      "two principal moments differ by less than 5 %, so that its axes, and with them sieve size, "
      "flatness and elongation, depend on how the file is turned");
  return text;
}

void print_clump_table_head()
{
  std::printf("%-16s %7s %7s %6s %13s %20s %17s %10s\n", "", "", "", "nodes", "union volume",
              "surface off by [mm]", "moments off by [%]", "axes [deg]");
  std::printf("%-16s %7s %7s %6s %13s %6s %6s %6s %8s %9s %10s\n", "stone", "nodes", "spheres",
              "[%]", "off by [%]", "mean", "95 %", "max", "uniform", "eq.-mass", "uniform");
}

void print_clump_table_row(const ClumpResult& result)
{
  const dem::ClumpReport& r = result.report;
  std::printf("%-16s %7zu %7zu %6.2f %6.2f+-%5.2f %6.3f %6.3f %6.3f %8.1f %9.1f %10.1f\n",
              result.name.c_str(), result.nodes, result.shape.spheres.size(), used(r),
              100 * r.volume_error, 100 * r.volume_uncertainty, 1e3 * r.surface_distance_mean,
              1e3 * r.surface_distance_95, 1e3 * r.surface_distance_max, 100 * r.inertia_error[0],
              100 * r.inertia_error[1], r.axis_error[0]);
}

void print_clump_table_means(const std::vector<ClumpResult>& results)
{
  const auto mean = [&](auto value) {
    double sum = 0;
    for (const ClumpResult& result : results) sum += value(result, result.report);
    return sum / results.size();
  };
  using C = const ClumpResult&;
  using R = const dem::ClumpReport&;
  std::printf(
      "%-16s %7.0f %7.1f %6.2f %13.2f %6.3f %6.3f %6.3f %8.1f %9.1f %10.1f\n", "mean",
      mean([](C c, R) { return c.nodes; }), mean([](C c, R) { return c.shape.spheres.size(); }),
      mean([](C, R r) { return used(r); }), mean([](C, R r) { return 100 * r.volume_error; }),
      mean([](C, R r) { return 1e3 * r.surface_distance_mean; }),
      mean([](C, R r) { return 1e3 * r.surface_distance_95; }),
      mean([](C, R r) { return 1e3 * r.surface_distance_max; }),
      mean([](C, R r) { return 100 * r.inertia_error[0]; }),
      mean([](C, R r) { return 100 * r.inertia_error[1]; }),
      mean([](C, R r) { return r.axis_error[0]; }));
}

std::string missed_targets(const ClumpResult& result)
{
  const dem::ClumpReport& report = result.report;
  const dem::ClumpParameters& p = result.parameters;
  const auto sentence = [&](const char* what, double reached, double target) {
    char text[200];
    std::snprintf(text, sizeof(text),
                  "The target for the error of the %s of '%s' was not met: %.2f %% instead of "
                  "%.2f %% (stopped by: %s).\n",
                  what, result.name.c_str(), 100 * reached, 100 * target, stop_text(report.stop));
    return std::string(text);
  };
  std::string missed;
  const double volume_error = std::abs(report.volume_error);
  if (p.target_volume_error > 0 && report.stop != dem::Stop::volume_error &&
      volume_error > p.target_volume_error)
    missed += sentence("volume", volume_error, p.target_volume_error);
  const double inertia_error = report.inertia_error[static_cast<std::size_t>(p.mass_scheme)];
  if (p.target_inertia_error > 0 && inertia_error > p.target_inertia_error)
    missed += sentence("inertia", inertia_error, p.target_inertia_error);
  return missed;
}

nlohmann::ordered_json clump_json(const ClumpResult& result)
{
  const dem::StoneSize& size = result.size;
  const dem::ClumpReport& report = result.report;
  nlohmann::ordered_json entry{
      {"name", result.name},
      {"file", result.file},
      {"stone",
       {{"nodes", result.nodes},
        {"facets", result.facets},
        {"volume_m3", result.volume},
        {"longest_m", size.longest},
        {"intermediate_m", size.intermediate},
        {"shortest_m", size.shortest},
        {"sieve_size_m", size.sieve},
        {"equivalent_diameter_m", equivalent_diameter(result.volume)},
        {"flatness", size.flatness()},
        {"elongation", size.elongation()},
        {"sphericity", size.sphericity}}},
      {"spheres", result.shape.spheres.size()},
      {"smallest_radius_m", result.shape.spheres.back().radius},
      {"largest_radius_m", result.shape.spheres.front().radius},
      {"nodes_used", report.nodes_used},
      {"rejected", report.rejected},
      {"stopped_by", stop_text(report.stop)},
      {"volume_error", report.volume_error},
      {"volume_error_uncertainty", report.volume_uncertainty},
      {"bulge_m", report.bulge},
      {"groups", report.groups},
      {"surface_distance_mean_m", report.surface_distance_mean},
      {"surface_distance_95_m", report.surface_distance_95},
      {"surface_distance_max_m", report.surface_distance_max},
      {"mass_properties", scheme_names[static_cast<int>(result.parameters.mass_scheme)]},
      {"unit_inertia_m5",
       {result.shape.unit_inertia[0], result.shape.unit_inertia[1], result.shape.unit_inertia[2]}},
      {"body_frame",
       {{"origin_m", {report.origin[0], report.origin[1], report.origin[2]}},
        {"rotation_w_x_y_z",
         {report.rotation.w(), report.rotation.x(), report.rotation.y(), report.rotation.z()}}}},
      {"axes_are_distinct", report.axes_are_distinct}};
  const dem::MeshDiagnosis& mesh = result.mesh;
  const dem::PointCloudDiagnosis& cloud = result.cloud;
  if (result.facets > 0)
    entry["diagnosis"] = {{"facets_read", mesh.facets_read},
                          {"vertices_merged", mesh.vertices_merged},
                          {"degenerate_facets_dropped", mesh.degenerate_facets_dropped},
                          {"duplicate_facets_dropped", mesh.duplicate_facets_dropped},
                          {"facets_without_area", mesh.facets_without_area},
                          {"crossing_pairs", mesh.crossings.pairs},
                          {"crossings_complete", mesh.crossings.complete},
                          {"corners_joined", mesh.corners_joined},
                          {"corners_parted", mesh.corners_parted},
                          {"flipped", mesh.flipped},
                          {"notes", mesh.notes}};
  else
    entry["diagnosis"] = {{"points_read", cloud.points_read},
                          {"duplicates_dropped", cloud.duplicates_dropped},
                          {"disagreeing_normals", cloud.disagreeing_normals},
                          {"closure", cloud.closure},
                          {"spacing_m", cloud.spacing},
                          {"scatter_m", cloud.scatter},
                          {"scatter_over_spacing", cloud.scatter / cloud.spacing},
                          {"volume_excess_from_scatter", cloud.volume_excess},
                          {"flipped", cloud.flipped},
                          {"notes", cloud.notes}};
  if (result.density > 0) {
    entry["density_kg_per_m3"] = result.density;
    entry["mass_kg"] = result.density * result.volume;
  }
  for (int k = 0; k < 3; ++k)
    entry["errors"][scheme_names[k]] = {{"principal_moments", report.inertia_error[k]},
                                        {"principal_axes_degrees", report.axis_error[k]},
                                        {"centre_m", report.centre_offset[k]}};
  return entry;
}
} // namespace interlock::apps
