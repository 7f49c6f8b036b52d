#include "dem/ribs/rib_search.h"

#include <algorithm>
#include <cmath>

namespace interlock::dem
{
namespace
{
template <class Point> boost::geometry::model::box<Point> box_of(const RibSearch::Box& box)
{
  const Vector3 &low = box.min(), &high = box.max();
  return {Point(low.x(), low.y(), low.z()), Point(high.x(), high.y(), high.z())};
}
} // namespace

double section_reach(const Rib& rib)
{
  return std::sqrt(rib.half_width * rib.half_width + rib.half_thickness * rib.half_thickness);
}

RibSearch::RibSearch(const std::vector<Rib>& ribs, double margin)
{
  std::vector<Entry> entries;
  for (const Rib& rib : ribs) {
    const Vector3 grown = Vector3::Constant(section_reach(rib) + margin);
    const Box box(rib.x[0].cwiseMin(rib.x[1]) - grown, rib.x[0].cwiseMax(rib.x[1]) + grown);
    entries.emplace_back(box_of<Point>(box), static_cast<int>(boxes_.size()));
    boxes_.push_back(box);
  }
  tree_ = decltype(tree_)(entries); // made at once: packed
}

void RibSearch::find(const Box& place, std::vector<int>& ribs) const
{
  ribs.clear();
  for (auto found = tree_.qbegin(boost::geometry::index::intersects(box_of<Point>(place)));
       found != tree_.qend(); ++found)
    ribs.push_back(found->second);
  std::sort(ribs.begin(), ribs.end());
}

RibSurroundings::RibSurroundings(std::vector<Rib> ribs, double distance)
    : ribs_(std::move(ribs)), distance_(distance), search_(ribs_, distance)
{
}

RibSearch::Box RibSurroundings::box() const
{
  RibSearch::Box box;
  for (std::size_t r = 0; r < ribs_.size(); ++r) box.extend(search_.box(static_cast<int>(r)));
  return box;
}

bool RibSurroundings::holds(const Clumps& clumps, int i) const
{
  const auto ball = [](const Vector3& x, double radius) {
    return RibSearch::Box(x.array() - radius, x.array() + radius);
  };
  std::vector<int> close;
  search_.find(ball(clumps.position[i], clumps.bounding_radius(i)), close);
  if (close.empty()) return false;
  const std::vector<Sphere>& spheres = clumps.shape_of(i).spheres;
  for (int a = 0; a < static_cast<int>(spheres.size()); ++a) {
    const Vector3 centre = clumps.position[i] + clumps.member_offset(i, a);
    const RibSearch::Box box = ball(centre, spheres[a].radius);
    for (const int r : close)
      if (search_.box(r).intersects(box) &&
          rib_proximity(ribs_[r], centre, spheres[a].radius).overlap > -distance_)
        return true;
  }
  return false;
}
} // namespace interlock::dem
