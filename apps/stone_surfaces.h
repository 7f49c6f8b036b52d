// The surfaces of a run's stones for its report.
#pragma once

#include <filesystem>
#include <string>

namespace interlock::apps
{
// Makes or reads the stones of the run in `folder` once more, as its used.prm says, and writes
// their closed surfaces, decimated (dem/meshes/decimation.h), into `file` as JSON: a list by shape
// with `name`, `volume` [m3], and `fine` and `coarse`, each with `vertices` (x, y, z in the body
// frame of the clump [m], one after the other) and `triangles`: about 300 and 80. A state holds
// clumps alone, and frames their spheres.
//
// Returns why not, one full sentence, where there is none to write: an experiment without stones of
// its own, clumps that came without scans, scans that are not there any more.
std::string write_stone_surfaces(const std::filesystem::path& folder,
                                 const std::filesystem::path& file);
} // namespace interlock::apps
