// Whether a list of clumps near ribs is still complete.
#pragma once

#include "dem/bodies/clumps.h"
#include "dem/ribs/rib_set.h"

namespace interlock::dem
{
// Remembers where clumps and ribs were when the list was made, and what each clump could come
// nearer to the ribs before somebody is missing in it.
class RibListWatch
{
public:
  // `room`: of each clump [m].
  void begin(const Clumps& clumps, const RibSet& ribs, ScalarField room);

  // Whether what each clump and the ribs have moved since, and may move within `ahead` [s] at the
  // velocities that they have, is within the clump's room; the ribs may move by `margin` [m]
  // besides. False when clumps or ribs have come or gone.
  bool holds(const Clumps& clumps, const RibSet& ribs, double ahead, double margin);

private:
  double largest_way(const RibSet& ribs, double ahead);

  VectorField x_, rib_x_;
  QuaternionField q_, rib_q_;
  ScalarField room_, beyond_;
  // Of the ends of ribs, squared: way, turn, speed, spin.
  ScalarField way_, turn_, speed_, spin_;
};
} // namespace interlock::dem
