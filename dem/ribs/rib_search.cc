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
} // namespace interlock::dem
