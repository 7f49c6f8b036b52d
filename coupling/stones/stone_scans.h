// The closed surfaces that the stones of a run are made from.
#pragma once

#include "coupling/output/monitor.h"
#include "coupling/parameters/stone_parameters.h"
#include "dem/generator/clump_generator.h"
#include "dem/meshes/triangle_mesh.h"

#include <string>
#include <vector>

namespace interlock::coupling
{
struct StoneScan {
  std::string name;
  dem::TriangleMesh mesh; // [m]
};

// One a file of the folder of scans, in the order of names, or the synthetic batch; what the reader
// notes goes to monitor.message. Throws InputError when a file is not a closed stone.
std::vector<StoneScan> stone_scans(const StoneParameters& parameters, const Monitor& monitor);

// How the clump of the scan with this index is made.
dem::ClumpParameters clump_parameters(const StoneParameters& parameters, std::size_t index);

// The same surfaces in the body frames of the clumps that make_stones (stone_shapes.h) makes of
// them. Clumps are made again only where their frame depends on their spheres, which with
// Mass properties = mesh it does not. None of a folder of clumps.
std::vector<StoneScan> scans_in_body_frames(const StoneParameters& parameters);
} // namespace interlock::coupling
