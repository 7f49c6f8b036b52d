#include "dem/generator/random_order.h"

#include "dem/generator/stop_rules.h"
#include "dem/random_stream.h"

#include <algorithm>

namespace interlock::dem
{
std::vector<Sphere> spheres_in_random_order(const ClumpSurface& surface,
                                            const ClumpParameters& parameters, ClumpReport& report)
{
  const int nodes = static_cast<int>(surface.nodes.size());
  const Eigen::AlignedBox3d box = surface.box();
  const double threshold = parameters.d_min - rounding_length(box);
  const double allowed = parameters.p_max / 100 * nodes;
  StopRules rules(parameters, surface.mass, box);

  std::vector<Sphere> spheres;
  for (const int node : RandomStream(parameters.seed).permutation(nodes)) {
    if (report.nodes_used >= allowed) {
      if (parameters.p_max < 100) report.stop = Stop::p_max;
      break;
    }
    const Vector3& p = surface.nodes[node];
    if (std::any_of(spheres.begin(), spheres.end(), [&](const Sphere& s) {
          const double reach = std::max(0., s.radius + threshold);
          return (p - s.centre).squaredNorm() < reach * reach;
        }))
      continue;
    ++report.nodes_used;
    const auto ball = surface.ball_at(node, parameters.r_min);
    if (!ball) {
      ++report.rejected;
      continue;
    }
    spheres.push_back(*ball);
    if (const auto stop = rules.after(spheres)) {
      report.stop = *stop;
      break;
    }
  }
  return spheres;
}
} // namespace interlock::dem
