// Constants of the beams of the explicit integrator, each in an array of its own, for vector lanes.
#pragma once

#include "fem/beam/beam_element.h"

#include <Eigen/Dense>

#include <array>
#include <vector>

namespace interlock::fem
{
using Lane = std::vector<double, Eigen::aligned_allocator<double>>;
using Lanes3 = std::array<Lane, 3>;
using Lanes4 = std::array<Lane, 4>;

// The members of BeamConstants. Entry s is the beam from slot s to s + 1; its inverse length is
// zero where slot s ends a line.
struct BeamLanes {
  Lane length, inverse_length;
  Lanes4 frame;
  Lanes3 force_stiffness, moment_stiffness, bowing;
  Lane softening, yield_stretch, plastic_stretch;

  // Room for `size` beams, none of them there yet.
  void resize(std::size_t size)
  {
    for (Lane* lane : {&length, &inverse_length, &softening, &yield_stretch, &plastic_stretch})
      lane->assign(size, 0.);
    for (Lanes3* lanes : {&force_stiffness, &moment_stiffness, &bowing})
      for (Lane& lane : *lanes) lane.assign(size, 0.);
    for (int c = 0; c < 4; ++c) frame[c].assign(size, c == 0 ? 1. : 0.);
  }

  void set(int s, const BeamConstants<double>& beam)
  {
    length[s] = beam.length;
    inverse_length[s] = beam.inverse_length;
    for (int c = 0; c < 4; ++c) frame[c][s] = beam.frame[c];
    for (int c = 0; c < 3; ++c) {
      force_stiffness[c][s] = beam.force_stiffness[c];
      moment_stiffness[c][s] = beam.moment_stiffness[c];
      bowing[c][s] = beam.bowing[c];
    }
    softening[s] = beam.softening;
    yield_stretch[s] = beam.yield_stretch;
    plastic_stretch[s] = beam.plastic_stretch;
  }
};
} // namespace interlock::fem
