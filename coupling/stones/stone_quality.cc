#include "coupling/stones/stone_quality.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace interlock::coupling
{
namespace
{
auto by_volume_error(const Stone& a, const Stone& b)
{
  return a.volume_error < b.volume_error;
}

auto by_groups(const Stone& a, const Stone& b)
{
  return a.groups < b.groups;
}

int in_pieces(const std::vector<Stone>& stones)
{
  return static_cast<int>(std::count_if(stones.begin(), stones.end(),
                                        [](const Stone& stone) { return stone.groups > 1; }));
}
} // namespace

std::string quality_text(const std::vector<Stone>& stones)
{
  const auto [least, most] = std::minmax_element(stones.begin(), stones.end(), by_volume_error);
  const int pieces = in_pieces(stones);
  return fmt::format("volume of the spheres {:+.1f} to {:+.1f} % of that of their stones, {}",
                     100 * least->volume_error, 100 * most->volume_error,
                     pieces == 0 ? std::string("all in one piece")
                                 : fmt::format("{} in pieces", pieces));
}

std::vector<std::string> quality_warnings(const std::vector<Stone>& stones)
{
  std::vector<std::string> warnings;
  const int n = static_cast<int>(stones.size()), pieces = in_pieces(stones);
  if (pieces > 0) {
    const Stone& worst = *std::max_element(stones.begin(), stones.end(), by_groups);
    warnings.push_back(fmt::format(
        "{} of {} clumps {} in pieces, groups of spheres that do not touch each other (\"{}\" in "
        "{}): ribs and corners of other stones pass between them; set Stones/Sphere order to gain, "
        "or Stones/D min below Stones/R min, P max to 100 and Max spheres to 0.",
        pieces, n, pieces == 1 ? "is" : "are", worst.shape.name, worst.groups));
  }
  const auto off = std::count_if(stones.begin(), stones.end(), [](const Stone& stone) {
    return std::abs(stone.volume_error) > largest_volume_error;
  });
  if (off > 0) {
    const Stone& worst =
        *std::max_element(stones.begin(), stones.end(), [](const Stone& a, const Stone& b) {
          return std::abs(a.volume_error) < std::abs(b.volume_error);
        });
    warnings.push_back(fmt::format(
        "The spheres of {} of {} clumps are off by more than {:.0f} % of their stone's volume "
        "(\"{}\" by {:+.0f} %): the packing is not that of the stones; Stones/Bulge "
        "meets the volume, and more spheres come with smaller Stones/D min and R min, P max of 100 "
        "and Max spheres of 0.",
        off, n, 100 * largest_volume_error, worst.shape.name, 100 * worst.volume_error));
  }
  return warnings;
}
} // namespace interlock::coupling
