// The box that holds the stones. SI units. The comment beside each member repeats the unit of the
// entry in the file.
#pragma once

namespace interlock::coupling
{
// Box with its floor at z = 0, walls at x = 0 (front, with the slot), x = length, y = 0, y = width.
struct BoxParameters {
  double length = 0;      // along x, the direction of the pull [m]
  double width = 0;       // along y [m]
  double height = 0;      // along z [m]
  double slot_height = 0; // of the gap in the front wall, centred on the geogrid [m]
};
} // namespace interlock::coupling
