// Thick zones of ribs around their junctions.
#pragma once

#include "fem/ribs/rib_line.h"

#include <vector>

namespace interlock::fem
{
struct JunctionZone {
  double reach = 0;     // distance from the junction along each rib [m]
  double thickness = 0; // of the ribs there, at least their own [m]
};

// The same lines with thicker ribs wherever a vertex shared with another line is at most `reach`
// away. Elements are cut at the borders of the zones. Stiffnesses, line density and rotary inertia
// of a zone are those of the rib times the ratio that the thicker shape gives by beam_section, so
// that sections given directly are thickened too; a round rib grows in both directions. Short
// pieces at the borders shorten the stable step of the explicit integrator.
// Throws std::invalid_argument when reach or thickness is not positive, a rib has no valid shape,
// or a rib is thicker than the zone.
std::vector<RibLine> thicken_junctions(const std::vector<RibLine>& lines, const JunctionZone& zone);
} // namespace interlock::fem
