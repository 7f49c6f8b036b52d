#include "coupling/heap/drop_plan.h"

#include "dem/engine/insertion.h"
#include "dem/counter_stream.h"

#include <algorithm>
#include <cmath>

namespace interlock::coupling
{
namespace
{
using dem::Vector3;

constexpr double clearance = 1e-3; // between the surfaces of two stones [m]
constexpr double interval = 1e-3;  // between two looks [s]

// The stones that have been let go, in free fall: their contacts are of no interest up here.
class Falling
{
public:
  Falling(const std::vector<Stone>& stones, double gravity)
      : stones_(stones), clumps_(shapes_of(stones)), gravity_(gravity)
  {
    for (const Stone& stone : stones)
      reach_ = std::max(reach_, 2 * stone.shape.bounding_radius() + clearance);
  }

  bool leaves_free(const Release& next)
  {
    move_to(next.time);
    const BodyPose pose = body_pose(stones_[next.stone], next.place, next.attitude);
    return dem::place_is_free(clumps_, {}, stones_[next.stone].shape, pose.position,
                              pose.orientation, clearance);
  }

  void add(const Release& next)
  {
    const BodyPose pose = body_pose(stones_[next.stone], next.place, next.attitude);
    clumps_.add(next.stone, 1, pose.position, pose.orientation);
    start_.push_back({next.time, pose.position.z()});
  }

private:
  struct Start {
    double time, height;
  };

  static std::vector<dem::ClumpShape> shapes_of(const std::vector<Stone>& stones)
  {
    std::vector<dem::ClumpShape> shapes;
    for (const Stone& stone : stones) shapes.push_back(stone.shape);
    return shapes;
  }

  void move_to(double time)
  {
    std::vector<bool> gone(clumps_.size());
    std::vector<Start> kept;
    for (int i = 0; i < clumps_.size(); ++i) {
      const double fallen = 0.5 * gravity_ * std::pow(time - start_[i].time, 2);
      clumps_.position[i].z() = start_[i].height - fallen;
      // Centres of mass start at about the same height, within the size of a stone.
      gone[i] = fallen > 2 * reach_;
      if (!gone[i]) kept.push_back(start_[i]);
    }
    if (kept.size() == start_.size()) return;
    clumps_.remove(gone);
    start_ = kept;
  }

  const std::vector<Stone>& stones_;
  dem::Clumps clumps_;
  std::vector<Start> start_;
  double gravity_;
  double reach_ = 0; // [m]
};

Vector3 place_in_disc(const DropParameters& drop, int shape)
{
  dem::CounterStream random(drop.seed, shape, dem::Draw::place);
  const double r = drop.disc_radius * std::sqrt(random.uniform());
  const double angle = random.uniform(0, 2 * M_PI);
  return {r * std::cos(angle), r * std::sin(angle), drop.height};
}
} // namespace

std::vector<Release> plan_drop(const std::vector<Stone>& stones, const DropParameters& drop,
                               double gravity)
{
  std::vector<Vector3> place;
  for (std::size_t s = 0; s < stones.size(); ++s)
    place.push_back(place_in_disc(drop, static_cast<int>(s)));

  std::vector<Release> plan;
  Falling falling(stones, gravity);
  double time = 0;
  for (int batch = 0; batch < drop.batches; ++batch)
    for (std::size_t s = 0; s < stones.size(); ++s) {
      const auto id = static_cast<std::int64_t>(plan.size());
      dem::CounterStream random(drop.seed, id, dem::Draw::attitude);
      Release next{static_cast<int>(s), place[s], random.rotation(), time};
      // Looks at whole multiples of the interval, so that sums do not collect rounding.
      for (long look = std::lround(time / interval); !falling.leaves_free(next);)
        next.time = interval * static_cast<double>(++look);
      falling.add(next);
      time = next.time;
      plan.push_back(next);
    }
  return plan;
}

FallingStone falling_stone(const Stone& stone, const Release& release, double time, double dt,
                           double gravity)
{
  const double since = time - release.time;
  FallingStone falling;
  falling.pose = body_pose(stone, release.place, release.attitude);
  falling.pose.position.z() -= 0.5 * gravity * since * since;
  falling.velocity = {0, 0, -gravity * (since - 0.5 * dt)};
  return falling;
}
} // namespace interlock::coupling
