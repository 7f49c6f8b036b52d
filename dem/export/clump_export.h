// Clumps for other codes: one call writes the files that a code reads. What each format holds and
// how to load it: docs/clump_formats.md and the head of every file.
#pragma once

#include "dem/atomic_files.h"
#include "dem/bodies/clump_shape.h"

#include <string>
#include <vector>

namespace interlock::dem
{
enum class ClumpFormat { lammps, liggghts, yade, mercury, pfc, csv, vtk };

// "lammps", "liggghts", "yade", "mercury", "pfc", "csv", "vtk".
std::vector<std::string> clump_format_names();

// The format of that name. Throws InputError with the list for other names.
ClumpFormat clump_format(const std::string& name);

// What the file's name ends with by custom, dot included: ".mol", ".multisphere", ".py", ".mclump"
// (a folder), ".dat", ".csv", ".vtp".
std::string clump_extension(ClumpFormat format);

// `clump_file` without ".clump.json", or else without its last extension.
std::string clump_stem(const std::string& clump_file);

// Where the clump of `clump_file` goes: its stem plus the extension of the format:
// "out/stone_7.clump.json" becomes "out/stone_7.mol".
// Codes that load a file by name or import it as a module get identifier() of the name ("stone 7"
// becomes "stone_7.mol"); .csv and .vtp keep it.
std::string clump_export_path(const std::string& clump_file, ClumpFormat format);

// All that is written there: that path, and for LIGGGHTS also ".in" behind it.
std::vector<std::string> clump_export_paths(const std::string& clump_file, ClumpFormat format);

// The files of the clump of the density [kg/m3] under `path` in SI units and full digits: body
// frame, with the origin at the centre of mass and the axes along the principal axes of inertia.
// Mass, centre and inertia are those of the shape wherever the code takes them; where it sums its
// spheres, they carry member_volumes(). LIGGGHTS gets `path` (spheres) and `path`.in (commands);
// MercuryDPM gets a folder. Throws InputError (path or value) when the density is not above 0, or
// LIGGGHTS is to get a clump of one sphere. Writes nothing.
std::vector<FileText> clump_export_files(const std::string& path, const ClumpShape& shape,
                                         ClumpFormat format, double density);

// Writes them, all or none (atomic_files.h), into a folder that must exist. Throws InputError when
// one cannot be written.
void export_clump(const std::string& path, const ClumpShape& shape, ClumpFormat format,
                  double density);
} // namespace interlock::dem
