// A small packed state for tests: plates of four spheres, stacked in a box with gaps of a tenth of
// a millimetre between them. They come to rest within milliseconds.
#pragma once

#include "coupling/packing/packed_state.h"

// Plates lie flat: centres 8 mm from the axis along x and y, radius 10 mm.
inline interlock::coupling::PackedState packed_plates(int n)
{
  namespace dem = interlock::dem;
  interlock::coupling::PackedState state;
  state.box = {0.06, 0.05, 0.1};
  state.density = 2500;
  dem::ClumpShape plate;
  plate.name = "plate";
  for (const double x : {-0.008, 0.008})
    for (const double y : {-0.008, 0.008}) plate.spheres.push_back({{x, y, 0}, 0.01});
  plate.volume = 1.4e-5;
  // Of four points at the centres and a ball of 1 cm radius at each; the exact values do not
  // matter.
  plate.unit_inertia = plate.volume * dem::Vector3(6.4e-5 + 4e-5, 6.4e-5 + 4.1e-5, 12.8e-5 + 4e-5);
  state.shapes = {plate};
  for (int k = 0; k < n; ++k)
    state.clumps.push_back({0,
                            {0.03, 0.025, 0.0101 + 0.0201 * k},
                            dem::Quaternion::Identity(),
                            dem::Vector3::Zero(),
                            dem::Vector3::Zero()});
  return state;
}
