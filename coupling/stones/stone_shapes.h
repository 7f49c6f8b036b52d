// The stones of a run as clump shapes: from scans in a folder, or synthetic.
#pragma once

#include "coupling/output/monitor.h"
#include "coupling/parameters/stone_parameters.h"
#include "dem/bodies/clump_shape.h"

#include <vector>

namespace interlock::coupling
{
// A clump and what its stone is, whichever mass properties the clump was given. The body frame of a
// clump depends on them (dem/bodies/clump_shape.h): another centre of mass, other principal axes.
// The centre and the axes of the scan do not.
struct Stone {
  dem::ClumpShape shape;
  dem::Vector3 centre;     // of volume of the closed surface, body frame of the clump [m]
  dem::Quaternion axes;    // of the clump, body to scan: x_scan = axes * (x_body - centre), where
                           // the origin of x_scan is the centre of volume
  double elongation = 0;   // I/L of Zingg (1935): 1 for a cube, small for a rod (stone_size.h) [-]
  double longest = 0;      // L [m]
  int groups = 1;          // of spheres that touch each other; 1: the clump is in one piece
  double volume_error = 0; // of the union of the spheres, over the stone's volume [-]

  static constexpr bool stored_as_groups = true;
};
template <class Archive> void exchange(Archive& archive, Stone& stone)
{
  archive("shape", stone.shape);
  archive("centre", stone.centre, "m");
  archive("axes", stone.axes);
  archive("elongation", stone.elongation);
  archive("longest", stone.longest, "m");
  archive("groups", stone.groups);
  archive("volume_error", stone.volume_error);
}

// One stone a file, in the order of names, or the synthetic batch; what the reader notes goes to
// monitor.message. A folder of clumps that `interlock clump` has made (*.clump.json) is taken as it
// is: their scans are not there, so the centre of a stone is that of mass, and its axes are
// measured on the spheres, along the principal ones. Throws InputError when a file is not a closed
// stone or makes no clump.
std::vector<Stone> make_stones(const StoneParameters& parameters, const Monitor& monitor);

// Whether the folder of scans holds such clumps.
bool holds_clumps(const StoneParameters& parameters);

// Where the centre of mass of the clump lies [m] and how it is turned (body to world) when the
// centre of its stone is at `place` [m] and the scan is turned by `attitude` (scan to world): the
// member spheres lie at the same places whichever mass properties the clump has.
struct BodyPose {
  dem::Vector3 position;
  dem::Quaternion orientation;
};
BodyPose body_pose(const Stone& stone, const dem::Vector3& place, const dem::Quaternion& attitude);
} // namespace interlock::coupling
