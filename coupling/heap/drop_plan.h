// Which stone is let go where, how turned, and when: fixed before the simulation starts.
#pragma once

#include "coupling/heap/heap_parameters.h"
#include "coupling/stones/stone_shapes.h"

#include <vector>

namespace interlock::coupling
{
struct Release {
  int stone = 0;            // index of the shape
  dem::Vector3 place;       // of the stone's centre of volume, world [m]
  dem::Quaternion attitude; // scan to world
  double time = 0;          // it is at rest then and falls from then on [s]
};
template <class Archive> void exchange(Archive& archive, Release& release)
{
  archive("stone", release.stone);
  archive("place", release.place, "m");
  archive("attitude", release.attitude);
  archive("time", release.time, "s");
}

// Ferellec and McDowell (2010, section 3) let every stone of one shape start at the same point,
// which differs from shape to shape and may be eccentric, 1 m above the floor, batch after batch in
// the same sequence. So every shape gets a seeded place in the disc (uniform over its area) and in
// each batch a seeded attitude, and stones are let go one after the other, each as soon as its
// place is free. All fall the same way there, so that is a matter of free fall alone and is found
// here: the first millisecond in which no member sphere comes nearer than 1 mm to one of the stones
// above the floor that fall below. The plan is the same for all mass properties of the clumps, for
// it knows member spheres and not what they weigh.
std::vector<Release> plan_drop(const std::vector<Stone>& stones, const DropParameters& drop,
                               double gravity);

// A stone `time` [s] into the run, at or after its release, that has touched nothing since: so all
// runs of one plan drop their stones alike although the releases lie anywhere within their steps.
struct FallingStone {
  BodyPose pose;         // at `time`
  dem::Vector3 velocity; // half a step of `dt` earlier, as the leapfrog has it [m/s]
};
FallingStone falling_stone(const Stone& stone, const Release& release, double time, double dt,
                           double gravity);
} // namespace interlock::coupling
