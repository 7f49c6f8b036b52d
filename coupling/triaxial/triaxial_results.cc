// What a triaxial run leaves in its summary. Formulas: docs/theory/triaxial.md.
#include "coupling/stones/curve_measures.h"
#include "coupling/triaxial/triaxial.h"

#include <algorithm>
#include <cmath>

namespace interlock::coupling
{
namespace
{
// Axial strains over which means are taken for peaks, and slopes [-].
constexpr double filter = 0.005, slope_length = 0.02;

double degrees_of_sine(double sine)
{
  return 180 / M_PI * std::asin(std::clamp(sine, -1., 1.));
}

// Mobilised, of a material without cohesion, for the ratio of axial to lateral stress.
double friction_angle(double ratio)
{
  return degrees_of_sine((ratio - 1) / (ratio + 1));
}

std::vector<double> lateral(const CompressStage& test)
{
  std::vector<double> mean(test.strains.size());
  for (std::size_t k = 0; k < mean.size(); ++k)
    mean[k] = 0.5 * (test.across_x[k] + test.across_y[k]);
  return mean;
}

// Growth of the volume over compression, both natural strains, around a record [-].
double dilatancy(const CompressStage& test, std::size_t record)
{
  std::vector<double> compression, growth;
  for (std::size_t k = 0; k < test.strains.size(); ++k) {
    compression.push_back(std::log(test.heights.front() / test.heights[k]));
    growth.push_back(std::log(test.volumes[k] / test.volumes.front()));
  }
  return slope_around(compression, growth, compression[record], slope_length);
}

void describe_strength(const CompressStage& test, nlohmann::ordered_json& results)
{
  const std::vector<double>& strain = test.strains;
  const std::vector<double> sides = lateral(test), axial = centred_mean(strain, test.axial, filter),
                            around = centred_mean(strain, sides, filter);
  std::vector<double> deviator(axial.size());
  for (std::size_t k = 0; k < axial.size(); ++k) deviator[k] = axial[k] - around[k];
  const std::size_t peak = largest_ratio(axial, around);
  const double ratio = axial[peak] / around[peak];
  const double residual = ratio_over_end(strain, test.axial, sides, end_share);
  const double growth = dilatancy(test, peak);
  const double half = first_place_at(strain, deviator, 0.5 * deviator[peak]);
  results["peak_friction_angle_deg"] = friction_angle(ratio);
  results["residual_friction_angle_deg"] = friction_angle(residual);
  results["peak_stress_ratio"] = ratio;
  results["residual_stress_ratio"] = residual;
  results["strain_at_peak"] = strain[peak];
  results["peak_deviator_Pa"] = deviator[peak];
  results["dilatancy_at_peak"] = growth;
  results["dilation_angle_at_peak_deg"] = degrees_of_sine(growth / (2 + growth));
  results["secant_stiffness_Pa"] = half > 0 ? 0.5 * deviator[peak] / half : 0;
}

void describe_volume(const CompressStage& test, const Triaxial& experiment,
                     nlohmann::ordered_json& results)
{
  const std::vector<double>& volume = test.volumes;
  const auto [low, high] = std::minmax_element(volume.begin(), volume.end());
  results["largest_contraction"] = 1 - *low / volume.front();
  results["largest_dilation"] = *high / volume.front() - 1;
  results["volume_change_at_end"] = volume.back() / volume.front() - 1;
  results["porosity_at_end"] = experiment.porosity();
}

void describe_stresses(const CompressStage& test, const Triaxial& experiment,
                       nlohmann::ordered_json& results)
{
  const std::vector<double>& strain = test.strains;
  const double x = mean_over_end(strain, test.across_x, whole_way),
               y = mean_over_end(strain, test.across_y, whole_way), sides = 0.5 * (x + y);
  results["mean_stress_x_Pa"] = x;
  results["mean_stress_y_Pa"] = y;
  results["mean_stress_ratio"] = mean_over_end(strain, test.axial, whole_way) / sides;
  results["axial_strain_at_end"] = strain.back();
  // Rate of strain against the time that a stone needs to fall into a pore: up to some 1e-3 the
  // rate does not matter.
  const TriaxialParameters& p = experiment.parameters();
  results["inertial_number"] = p.compression.strain_rate * experiment.specimen.mean_size *
                               std::sqrt(p.specimen.stones.density / sides);
}
} // namespace

void describe_specimen(const Triaxial& test, RunRecords& records)
{
  const dem::Vector3 size = test.size(), stress = test.stresses();
  nlohmann::ordered_json& results = records.summary.results;
  results["cell_pressure_Pa"] = test.parameters().cell_pressure;
  describe_stones(test.specimen, results);
  results["length_m"] = size.x();
  results["width_m"] = size.y();
  results["height_m"] = size.z();
  results["consolidated_stress_x_Pa"] = stress.x();
  results["consolidated_stress_y_Pa"] = stress.y();
  results["consolidated_stress_z_Pa"] = stress.z();
  describe_density(test.specimen, size.prod(), results);
}

void Triaxial::finish(std::vector<Stage>& plan, RunRecords& records) const
{
  const CompressStage& test = std::get<CompressStage>(plan.back());
  nlohmann::ordered_json& results = records.summary.results;
  describe_strength(test, results);
  describe_volume(test, *this, results);
  describe_stresses(test, *this, results);
  describe_motion(test.motion, specimen, "compression", "compression", records);
}
} // namespace interlock::coupling
