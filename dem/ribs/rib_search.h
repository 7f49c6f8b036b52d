// Which ribs are near a place: for the list of RibContacts. World frame, metres.
#pragma once

#include "dem/bodies/clumps.h"
#include "dem/ribs/rib_set.h"

#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <Eigen/Geometry>

#include <utility>
#include <vector>

namespace interlock::dem
{
class RibSearch
{
public:
  using Box = Eigen::AlignedBox3d;

  // Around a rib and everything nearer to it than `margin` [m].
  static Box box_around(const Rib& rib, double margin);

  // Takes the ribs that are present where they are, each in a box with this margin [m].
  RibSearch(const RibSet& ribs, double margin);

  const Box& box(int rib) const { return boxes_[rib]; }
  // The ribs whose boxes touch this one, ascending.
  void find(const Box& place, std::vector<int>& ribs) const;

private:
  using Point = boost::geometry::model::point<double, 3, boost::geometry::cs::cartesian>;
  using Entry = std::pair<boost::geometry::model::box<Point>, int>;

  std::vector<Box> boxes_; // empty for ribs that are not present
  boost::geometry::index::rtree<Entry, boost::geometry::index::quadratic<16>> tree_;
};
} // namespace interlock::dem
