// The files of one clump in each format; clump_export.h chooses and writes them. Pure functions.
#pragma once

#include "dem/export/clump_export_text.h"

namespace interlock::dem
{
// Molecule file of LAMMPS (29 Sep 2021): mass, com and inertia for fix rigid/small with `mol`, and
// member masses for everything else, with what their sums miss at the head.
ExportedFiles lammps_files(const ClumpExport& clump);

// LIGGGHTS-PUBLIC 3.8: "x y z r" lines, and in ".in" the command
// fix particletemplate/multisphere with mass and inertia_tensor. Throws InputError below two
// spheres, which LIGGGHTS refuses.
ExportedFiles liggghts_files(const ClumpExport& clump);

// Python module for YADE (2023.02a): add_stone(position, orientation, material).
ExportedFiles yade_files(const ClumpExport& clump);

// The folder that MercuryDPM's MClump tool leaves for one clump: Clump/Clump.txt,
// Inertia/Mass.txt, Inertia/TOI.txt, Inertia/PD.txt, and readme.txt with what those cannot hold.
ExportedFiles mercury_files(const ClumpExport& clump);

// Data file for PFC3D 6 and later: `clump template create`, moments for unit density as it asks.
ExportedFiles pfc_files(const ClumpExport& clump);

// Comment lines, a header, then one sphere a line.
ExportedFiles csv_files(const ClumpExport& clump);

// VTK polydata (XML, ASCII): a point a sphere with its radius, mass properties as field data.
ExportedFiles vtk_files(const ClumpExport& clump);
} // namespace interlock::dem
