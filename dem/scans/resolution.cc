#include "dem/scans/resolution.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace interlock::dem
{
namespace
{
// The coordinates along the axis on which the largest one lies.
struct Farthest {
  std::vector<double> values; // different ones, ascending
  double largest = 0;
};

Farthest farthest_axis(const std::vector<Vector3>& points, const Eigen::AlignedBox3d& box)
{
  const Vector3 reach = box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs());
  Farthest result;
  int axis = 0;
  result.largest = reach.maxCoeff(&axis);
  for (const Vector3& x : points) result.values.push_back(x[axis]);
  std::sort(result.values.begin(), result.values.end());
  result.values.erase(std::unique(result.values.begin(), result.values.end()), result.values.end());
  return result;
}

double spacing_of_floats(double at)
{
  const float value = static_cast<float>(at);
  return static_cast<double>(std::nextafter(value, INFINITY)) - value;
}

bool are_floats(const std::vector<double>& values)
{
  constexpr std::size_t fewest = 30; // by chance one in six doubles is one to nine digits
  return values.size() >= fewest && std::all_of(values.begin(), values.end(), [](double x) {
           return std::abs(x - static_cast<double>(static_cast<float>(x))) <= 5e-9 * std::abs(x);
         });
}

// The largest power of ten of which all are multiples; 0 if there is none that a double can tell.
double decimal_step(const std::vector<double>& values, double largest)
{
  constexpr std::size_t fewest = 12; // the corners of a drawing lie on round numbers
  if (values.size() < fewest) return 0;
  const int exponent = static_cast<int>(std::floor(std::log10(largest)));
  for (int k = exponent; k > exponent - 11; --k) {
    const double step = std::pow(10, k);
    const double rounding = 1e-15 * largest;
    if (std::all_of(values.begin(), values.end(), [&](double x) {
          return std::abs(x - step * std::round(x / step)) <= rounding;
        }))
      return step;
  }
  return 0;
}
} // namespace

std::string check_resolution(const InputFile& file, const std::vector<Vector3>& points,
                             bool single_precision, double length_unit)
{
  Eigen::AlignedBox3d box;
  for (const Vector3& x : points) box.extend(x);
  if (box.isEmpty()) return "";
  const double extent = box.sizes().maxCoeff();
  const double largest = box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff();
  if (!(extent > 0)) return "";
  const double single_step = spacing_of_floats(largest);
  const auto facts = [&](double step) {
    std::ostringstream text;
    text.precision(2);
    text << 1e3 * length_unit * step << " mm, " << 100 * step / extent << " % of its length";
    return text.str();
  };
  std::ostringstream far;
  far << "so far from the origin (" << length_unit * largest << " m)";
  const std::string cure =
      "move it to the origin before it is written in single precision, or write doubles";
  if (single_precision && single_step > coarsest_step * extent)
    file.refuse("is written in single precision, whose steps are ", facts(single_step), " ",
                far.str(), ", but at most ", 100 * coarsest_step, " % are taken: ", cure, ".");
  if (single_precision)
    return single_step > noted_step * extent
               ? "it is written in single precision, whose steps are " + facts(single_step) + " " +
                     far.str() + ": " + cure
               : "";
  if (largest < 10 * extent) return "";
  const Farthest farthest = farthest_axis(points, box);
  if (single_step > noted_step * extent && are_floats(farthest.values))
    return "its coordinates are numbers of single precision, whose steps are " +
           facts(single_step) + " " + far.str() + ": " + cure;
  const double step = decimal_step(farthest.values, largest);
  if (step > noted_step * extent)
    return "its coordinates are whole multiples of " + facts(step) + ", " + far.str() +
           ": if they were rounded to that, write more digits or move it to the origin";
  return "";
}
} // namespace interlock::dem
