// Beams in vector lanes: one element in each lane.
#pragma once

#include "fem/explicit/beam_lanes.h"
#include "fem/explicit/wide.h"

namespace interlock::fem
{
// The beams that start at slots s ... s + wide_lanes - 1.
inline BeamConstants<Wide> load_constants(const BeamLanes& beams, int s)
{
  return {load_wide(beams.length.data() + s),
          load_wide(beams.inverse_length.data() + s),
          load_wide(beams.frame, s),
          load_wide(beams.force_stiffness, s),
          load_wide(beams.moment_stiffness, s),
          load_wide(beams.bowing, s),
          load_wide(beams.softening.data() + s),
          load_wide(beams.yield_stretch.data() + s),
          load_wide(beams.plastic_stretch.data() + s)};
}

inline BeamEnds<Wide> load_ends(const Lanes3& position, const Lanes4& orientation, int s)
{
  return {load_wide(position, s), load_wide(position, s + 1), load_wide(orientation, s),
          load_wide(orientation, s + 1)};
}

// Zero where the slot ends a line, so that no beam leads on from it. A select, not a product: lanes
// without a beam may hold infinities.
template <std::size_t n> void drop_gaps(const Wide& inverse_length, std::array<Wide, n>& values)
{
  for (Wide& value : values) where(inverse_length == 0., value) = 0.;
}
} // namespace interlock::fem
