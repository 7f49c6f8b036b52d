// Reading the surface of a stone from a scan or a drawing.
#pragma once

#include "dem/scans/input_file.h"
#include "dem/scans/mesh_diagnosis.h"

namespace interlock::dem
{
struct StoneFileOptions {
  double length_unit = 1;        // length of one file unit [m]: 0.001 for millimetres
  bool flip = false;             // the file is inside out: turn each facet (or normal) round
  bool accept_crossings = false; // take a surface that crosses itself
};

// Reads an STL, PLY or OBJ file, merges vertices at the same place and drops degenerate and
// duplicate facets (mesh_cleaning.h). Where that leaves open edges, corners nearer than 1e-6 of the
// largest extent are joined (near_corners.h); corners in which the surface touches itself are
// parted (touching_corners.h); coordinates too coarse so far from the origin are noted or refused
// (resolution.h). The result is one closed surface with a positive volume in
// metres. Throws InputError with one sentence that names the file and the numbers when it is
// missing, no file, empty, of another format than its extension says, cut short or damaged (line,
// facet or bytes), without facets, with a coordinate that is not a finite number, with a largest
// extent that is not between smallest_stone and largest_stone (and which unit would fit), or when
// fault_of has something to say. `diagnosis` gets what was found, also when it throws. Counts in
// a file are compared with its bytes before anything is allocated for them; 1.5 million facets in a
// binary STL file take 3 s and 0.3 GB. docs/decisions/0001-reading-scans.md says why the readers
// are own ones.
TriangleMesh read_stone_mesh(const std::string& path, const StoneFileOptions& options,
                             MeshDiagnosis* diagnosis = nullptr);

// The same of a surface in memory, whose triangles are indices into its vertices; the sentences
// begin with "The stone".
TriangleMesh closed_stone_mesh(TriangleMesh mesh, const StoneFileOptions& options,
                               MeshDiagnosis* diagnosis = nullptr);

// The length of a unit by its name: m, cm, mm or inch [m]. Throws InputError for any other.
double length_of_unit(const std::string& name);

// For files of stones: throws InputError unless the unit is finite and above 0.
void check_length_unit(const InputFile& file, double length_unit);

// For files of stones: throws InputError unless `extent`, the largest one [m], is that of a stone,
// and says which other unit would make it one.
void check_stone_size(const InputFile& file, double extent, double length_unit);
} // namespace interlock::dem
