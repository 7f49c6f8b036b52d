#include "dem/ribs/ribs.h"

#include "dem/ribs/rod_lanes.h"

namespace interlock::dem
{
namespace
{
RodLane lane_of(const Rib& rib)
{
  return {lane(rib.x[0]),
          lane(rib.x[1]),
          lane(rib.width_axis[0]),
          lane(rib.width_axis[1]),
          rib.half_width - rib.rounding,
          rib.half_thickness - rib.rounding,
          rib.rounding};
}

// The section at xi: of a sphere whose centre lies on the centre line there.
RodNearest section_at(const Rib& rib, double xi)
{
  return nearest_on_rod(lane_of(rib), lane((1 - xi) * rib.x[0] + xi * rib.x[1]), 0);
}
} // namespace

RibProximity rib_proximity(const Rib& rib, const Vector3& centre, double radius)
{
  const RodNearest n = nearest_on_rod(lane_of(rib), lane(centre), radius);
  return {n.distance,       n.overlap,        n.xi,          vector(n.core),
          vector(n.centre), vector(n.normal), vector(n.lean)};
}

RodLoads rod_loads(const Rib& rib, const RibWrench& wrench)
{
  const RodNearest n = section_at(rib, wrench.xi);
  const RodLoadsLane loads = loads_on_rod(n, turning_about_chord(lane_of(rib), n),
                                          lane(wrench.force), lane(wrench.moment));
  return {wrench.rib,
          {vector(loads.force1), vector(loads.force2)},
          {vector(loads.moment1), vector(loads.moment2)}};
}
} // namespace interlock::dem
