// A packed box of clumps in a file: the format `clump-workload-1` (JSON, SI units), plain or
// compressed with gzip. cases/benchmark/README.md describes it.
#pragma once

#include "dem/bodies/clump_shape.h"

#include <filesystem>
#include <vector>

namespace interlock::coupling
{
struct PackedClump {
  int shape = 0;               // index in `shapes`
  dem::Vector3 position;       // of the centre of mass, world [m]
  dem::Quaternion orientation; // body to world
  dem::Vector3 velocity;       // world [m/s]
  dem::Vector3 spin;           // world [rad/s]
};

struct PackedState {
  dem::Vector3 box;   // inner lengths; walls at 0 and at the length in x and y, floor at z = 0 [m]
  double density = 0; // [kg/m3]
  std::vector<dem::ClumpShape> shapes;
  std::vector<PackedClump> clumps;
};

// .json or .json.gz
bool is_packed_state_name(const std::filesystem::path& file);

// Throws InputError, one full sentence (file, entry, value, what is allowed), for a file that
// cannot be read or unpacked, is no JSON, has another format, lacks an entry, or holds a value that
// no packed box can have: a mass that is not density times volume, moments of inertia that no body
// has, a radius that is not above 0, a shape that is not there, a quaternion that is not of length
// 1, a centre outside the box.
PackedState read_packed_state(const std::filesystem::path& file);

// Writes numbers that are read back to the same digits, compressed when the name ends with .gz,
// under a temporary name first. Throws std::runtime_error when the file cannot be written.
void write_packed_state(const std::filesystem::path& file, const PackedState& state);

// Shrinks the box and all positions by `share`; shapes and attitudes stay as they are, so stones
// overlap more.
void squeeze(PackedState& state, double share);
} // namespace interlock::coupling
