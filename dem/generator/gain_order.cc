#include "dem/generator/gain_order.h"

#include "dem/generator/sphere_groups.h"
#include "dem/generator/stop_rules.h"
#include "dem/generator/surface_gain.h"
#include "dem/random_stream.h"

#include <algorithm>
#include <queue>

namespace interlock::dem
{
namespace
{
// Ascending, so that sums over them do not depend on the seed when all nodes are candidates.
std::vector<int> candidate_nodes(int nodes, std::uint64_t seed)
{
  std::vector<int> chosen = RandomStream(seed).permutation(nodes);
  if (nodes > most_candidates) chosen.resize(most_candidates);
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

SurfaceGain gain_at(const std::vector<int>& chosen, const ClumpSurface& surface)
{
  const std::vector<double> all_areas = surface.areas();
  std::vector<Vector3> points;
  std::vector<double> areas;
  for (const int node : chosen) {
    points.push_back(surface.nodes[node]);
    areas.push_back(all_areas[node]);
  }
  return SurfaceGain(points, areas);
}

struct Candidate {
  double gain; // when the clump had `spheres` spheres; now at most this [m3]
  int spheres;
  int point; // of the gain: the index in the list of candidates
  Sphere ball;
};

// Of the queue: the largest gain is on top, of equal ones that of the first node.
bool operator<(const Candidate& a, const Candidate& b)
{
  return a.gain != b.gain ? a.gain < b.gain : a.point > b.point;
}

bool touches(const Sphere& ball, const std::vector<Sphere>& clump)
{
  return clump.empty() || std::any_of(clump.begin(), clump.end(),
                                      [&](const Sphere& s) { return spheres_touch(s, ball); });
}
} // namespace

std::vector<Sphere> spheres_in_gain_order(const ClumpSurface& surface,
                                          const ClumpParameters& parameters, ClumpReport& report)
{
  const int nodes = static_cast<int>(surface.nodes.size());
  const Eigen::AlignedBox3d box = surface.box();
  const std::vector<int> chosen = candidate_nodes(nodes, parameters.seed);
  SurfaceGain shape = gain_at(chosen, surface);
  StopRules rules(parameters, surface.mass, box);
  const double nearest = parameters.d_min - rounding_length(box);
  const double no_gain = rounding_length(box) * shape.area();

  std::priority_queue<Candidate> queue;
  for (int i = 0; i < static_cast<int>(chosen.size()); ++i)
    if (const auto ball = surface.ball_at(chosen[i], parameters.r_min))
      queue.push({shape.gain(*ball), 0, i, *ball});
    else
      ++report.rejected;

  std::vector<Sphere> spheres;
  std::vector<Candidate> apart; // that touch no sphere yet
  report.stop = Stop::no_gain;
  while (!queue.empty()) {
    Candidate best = queue.top();
    queue.pop();
    const int count = static_cast<int>(spheres.size());
    if (best.spheres < count) { // gains only fall: it stays the best, or another one is
      best.gain = shape.gain(best.ball);
      best.spheres = count;
      if (best.gain > no_gain && shape.distance(best.point) >= nearest) queue.push(best);
      continue;
    }
    if (!touches(best.ball, spheres)) {
      apart.push_back(best);
      continue;
    }
    spheres.push_back(best.ball);
    shape.add(best.ball);
    report.nodes_used = count + 1;
    if (const auto stop = rules.after(spheres)) {
      report.stop = *stop;
      break;
    }
    if (parameters.p_max < 100 && report.nodes_used >= parameters.p_max / 100 * nodes) {
      report.stop = Stop::p_max;
      break;
    }
    const auto joined = std::stable_partition(apart.begin(), apart.end(), [&](const Candidate& c) {
      return !spheres_touch(c.ball, best.ball);
    });
    std::for_each(joined, apart.end(), [&](const Candidate& c) { queue.push(c); });
    apart.erase(joined, apart.end());
  }
  return spheres;
}
} // namespace interlock::dem
