// What a shear box run leaves in its summary.
#include "coupling/shear_box/shear_box.h"
#include "coupling/stones/curve_measures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace interlock::coupling
{
namespace
{
// Peaks are those of means over this share of a mean stone, slopes are taken over that one [-].
constexpr double filter_share = 0.05, slope_share = 0.25;
// Where the rims of the upper half bear more than this share of the normal force on the plane, a
// stone is wedged under one of them, and what is measured is not the strength of the stones [-].
constexpr double wedging_share = 0.5;

// Where the curve stops to be that of the stones: number of records until then, and why.
struct Usable {
  std::size_t records = 0;
  std::string reason; // empty: all of it
};

Usable usable_part(const ShearStage& shear, const ShearBox& box)
{
  const std::vector<double>& u = shear.displacements;
  const double filter = filter_share * box.specimen.mean_size;
  const std::vector<double> n = centred_mean(u, shear.normal_forces, filter),
                            p = centred_mean(u, shear.plate_forces, filter);
  for (std::size_t k = 0; k < u.size(); ++k) {
    if (shear.motion.overlap_left_at >= 0 && u[k] >= shear.motion.overlap_left_at)
      return {k, overlap_reason};
    if (n[k] - p[k] - shear.weight_above > wedging_share * n[k])
      return {k, "the sides of the upper half bear more than half of the normal force (a stone is "
                 "wedged under their rim, or they rub)"};
  }
  return {u.size(), ""};
}

// The curve up to there, at least its first two records.
ShearStage part_of(ShearStage shear, std::size_t records)
{
  const std::size_t n = std::min(std::max<std::size_t>(2, records), shear.displacements.size());
  for (std::vector<double>* curve : {&shear.displacements, &shear.heights, &shear.shear_forces,
                                     &shear.normal_forces, &shear.plate_forces})
    curve->resize(n);
  return shear;
}

double degrees(double tangent)
{
  return 180 / M_PI * std::atan(tangent);
}

// Shear force over plate and weight: all that a laboratory knows of the normal force. The rims of
// the upper half hold stones down besides [-].
double peak_of_applied_load(const ShearStage& shear, double filter)
{
  const std::vector<double> t = centred_mean(shear.displacements, shear.shear_forces, filter),
                            p = centred_mean(shear.displacements, shear.plate_forces, filter);
  double peak = 0;
  for (std::size_t k = 0; k < t.size(); ++k)
    peak = std::max(peak, t[k] / (p[k] + shear.weight_above));
  return peak;
}

void describe_strength(const ShearStage& shear, const ShearBox& box,
                       nlohmann::ordered_json& results)
{
  const std::vector<double>& u = shear.displacements;
  const double filter = filter_share * box.specimen.mean_size;
  const std::vector<double> t = centred_mean(u, shear.shear_forces, filter),
                            n = centred_mean(u, shear.normal_forces, filter);
  const std::size_t peak = largest_ratio(t, n);
  const double residual = ratio_over_end(u, shear.shear_forces, shear.normal_forces, end_share);
  const double half = first_place_at(u, t, 0.5 * t[peak]);
  results["peak_friction_angle_deg"] = degrees(t[peak] / n[peak]);
  results["residual_friction_angle_deg"] = degrees(residual);
  results["peak_friction_ratio"] = t[peak] / n[peak];
  results["residual_friction_ratio"] = residual;
  results["peak_friction_angle_of_applied_load_deg"] = degrees(peak_of_applied_load(shear, filter));
  results["displacement_at_peak_m"] = u[peak];
  results["peak_shear_stress_Pa"] = t[peak] / box.area();
  results["dilation_angle_at_peak_deg"] =
      degrees(slope_around(u, shear.heights, u[peak], slope_share * box.specimen.mean_size));
  // At half the peak.
  results["secant_stiffness_Pa_per_m"] = half > 0 ? 0.5 * t[peak] / box.area() / half : 0;
  const double h = shear.plate_at_begin;
  const auto [low, high] = std::minmax_element(shear.heights.begin(), shear.heights.end());
  results["largest_contraction"] = (h - *low) / h; // of the specimen's volume
  results["largest_dilation"] = (*high - h) / h;
  results["volume_change_at_end"] = (shear.heights.back() - h) / h;
  results["porosity_at_end"] = box.porosity();
}

void describe_forces(const ShearStage& shear, const ShearBox& box, nlohmann::ordered_json& results)
{
  const ShearBoxParameters& p = box.parameters();
  const std::vector<double>& u = shear.displacements;
  const double normal = mean_over_end(u, shear.normal_forces, whole_way);
  results["mean_normal_stress_Pa"] = normal / box.area();
  results["mean_friction_ratio"] =
      ratio_over_end(u, shear.shear_forces, shear.normal_forces, whole_way);
  results["mean_plate_force_N"] = mean_over_end(u, shear.plate_forces, whole_way);
  results["shear_distance_m"] = u.back();
  // Rate of shear over the whole height against the time that a stone needs to fall into a pore:
  // below some 1e-3 the rate does not matter.
  results["inertial_number"] = p.shear.speed / shear.plate_at_begin * box.specimen.mean_size *
                               std::sqrt(p.specimen.stones.density * box.area() / normal);
}

// After what the contacts say: the earlier of the two counts.
void describe_usability(const Usable& usable, double from, Summary& summary)
{
  if (usable.reason.empty()) return;
  summary.results["not_usable_from_mm"] = 1e3 * from;
  summary.results["not_usable_because"] = usable.reason;
  summary.not_usable =
      fmt::format("From {:.1f} mm on the shearing is not to be used, and nothing was measured "
                  "there: {}.",
                  1e3 * from, usable.reason);
}
} // namespace

void describe_specimen(const ShearBox& box, RunRecords& records)
{
  nlohmann::ordered_json& results = records.summary.results;
  results["normal_stress_Pa"] = box.parameters().normal_stress;
  describe_stones(box.specimen, results);
  results["weight_above_plane_N"] = box.weight_above_plane();
  results["height_m"] = box.plate_height();
  describe_density(box.specimen, box.volume(), results);
}

void ShearBox::finish(std::vector<Stage>& plan, RunRecords& records) const
{
  const ShearStage& shear = std::get<ShearStage>(plan.back());
  const Usable usable = usable_part(shear, *this);
  const ShearStage measured = part_of(shear, usable.records);
  describe_strength(measured, *this, records.summary.results);
  describe_forces(measured, *this, records.summary.results);
  describe_motion(shear.motion, specimen, "shear", "shearing", records);
  describe_usability(usable, measured.displacements.back(), records.summary);
}
} // namespace interlock::coupling
