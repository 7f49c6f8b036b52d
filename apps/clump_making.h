// One stone made into a clump, with all that reports say about it.
#pragma once

#include "apps/clump_options.h"
#include "apps/clump_table.h"

#include <string>

namespace interlock::apps
{
// `parameters` are those of the options (clump_options.h), which say how the file is to be read: a
// mesh, or a cloud of points. Throws InputError when the stone is refused.
ClumpResult clump_of_file(const std::string& file, const std::string& name,
                          const ClumpOptions& options, const dem::ClumpParameters& parameters);

// The same of a surface in memory (dem/scans/stone_file.h: closed_stone_mesh).
ClumpResult clump_of_surface(dem::TriangleMesh surface, const std::string& name,
                             const ClumpOptions& options, const dem::ClumpParameters& parameters);
} // namespace interlock::apps
