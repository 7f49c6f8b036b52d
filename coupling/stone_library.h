// The stones of a run as clump shapes: from scans in a folder, or synthetic.
#pragma once

#include "coupling/monitor.h"
#include "coupling/pull_out_parameters.h"
#include "dem/clump_shape.h"

#include <vector>

namespace interlock::coupling
{
// One shape a stone, in the order of the files' names or of the synthetic batch. Throws InputError
// when a file is not a closed stone or a clump cannot be made of it.
std::vector<dem::ClumpShape> make_stone_shapes(const StoneParameters& parameters,
                                               const Monitor& monitor);
} // namespace interlock::coupling
