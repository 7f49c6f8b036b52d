#include "coupling/stones/pouring.h"

#include "coupling/stones/filled_box.h"
#include "dem/counter_stream.h"

#include <algorithm>
#include <cmath>

namespace interlock::coupling
{
namespace
{
using dem::CounterStream;
using dem::Draw;
using dem::Vector3;

// So many places in plan are tried, and the one in which the ball lies lowest is taken: enough to
// fill a layer before the next one begins, as stones from a shovel would spread.
constexpr int places_tried = 30;
// The surface is rough: the deepest pit that a stone may fall into below the highest point [m].
constexpr double pit_depth = 0.1;

int shape_of_stone(const Pouring& pouring, std::int64_t id)
{
  const std::int64_t batch = id / pouring.n_shapes;
  CounterStream random(pouring.seed, batch, Draw::order);
  return random.permutation(pouring.n_shapes)[id % pouring.n_shapes];
}

// Above `floor` and clear of the balls from index `first` on.
Vector3 lowest_place(const dem::Clumps& clumps, int first, double radius, double floor,
                     const BoxParameters& box, CounterStream random)
{
  Vector3 best(0, 0, 1e300);
  for (int attempt = 0; attempt < places_tried; ++attempt) {
    const double x =
        random.uniform(radius + pouring_clearance, box.length - radius - pouring_clearance);
    const double y =
        random.uniform(radius + pouring_clearance, box.width - radius - pouring_clearance);
    double z = floor + radius;
    for (int i = first; i < clumps.size(); ++i) {
      const double reach = radius + clumps.bounding_radius(i) + pouring_clearance;
      const double plan = std::hypot(x - clumps.position[i].x(), y - clumps.position[i].y());
      if (plan < reach)
        z = std::max(z, clumps.position[i].z() + std::sqrt(reach * reach - plan * plan));
    }
    if (z < best.z()) best = {x, y, z};
  }
  return best;
}
} // namespace

double pour(dem::Engine& engine, const BoxParameters& box, const Pouring& pouring, double mass)
{
  const dem::Clumps& clumps = engine.clumps();
  const double top = highest_ball(clumps), floor = top + pouring.drop_height;
  const int first = clumps.size();
  double highest = floor;
  for (double sum = 0; sum < mass;) {
    if (pouring.poll) pouring.poll();
    const std::int64_t id = clumps.next_id();
    const int shape = shape_of_stone(pouring, id);
    const Vector3 place = lowest_place(clumps, first, clumps.shapes()[shape].bounding_radius(),
                                       floor, box, CounterStream(pouring.seed, id, Draw::place));
    CounterStream attitude(pouring.seed, id, Draw::attitude);
    const int i = engine.add_clump(shape, pouring.density, place, attitude.rotation());
    sum += clumps.mass[i];
    highest = std::max(highest, place.z());
  }
  const double lowest_surface = std::max(0., top - pit_depth);
  return std::sqrt(2 * (highest - lowest_surface) / engine.gravity());
}
} // namespace interlock::coupling
