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

RibSearch::Box RibSearch::box_around(const Rib& rib, double margin)
{
  const double half_diagonal = std::hypot(rib.half_width, rib.half_thickness);
  const Vector3 grown = Vector3::Constant(half_diagonal + margin);
  return {rib.x[0].cwiseMin(rib.x[1]) - grown, rib.x[0].cwiseMax(rib.x[1]) + grown};
}

RibSearch::RibSearch(const RibSet& ribs, double margin) : boxes_(ribs.size())
{
  std::vector<Entry> entries;
  for (const int r : ribs.present()) {
    boxes_[r] = box_around(ribs[r], margin);
    entries.emplace_back(box_of<Point>(boxes_[r]), r);
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
