// What is wrong with a surface that should enclose one stone.
#pragma once

#include "dem/meshes/triangle_mesh.h"
#include "dem/scans/self_intersection.h"

namespace interlock::dem
{
struct MeshDiagnosis {
  // What was read and mended: filled by the reader of the file.
  int facets_read = 0;               // triangles in the file
  int vertices_merged = 0;           // an STL file brings three for each facet
  int degenerate_facets_dropped = 0; // two corners at one place
  int duplicate_facets_dropped = 0;  // the same corners in the same sense
  int corners_joined = 0;            // that nearly met (near_corners.h)
  int corners_parted = 0;            // in which parts of the surface touch (touching_corners.h)
  bool flipped = false;              // turned inside out, as asked
  // What else the reader has to say, each the end of a sentence without the full stop.
  std::vector<std::string> notes;

  // What the surface is: filled by diagnose_surface.
  EdgeDiagnosis edges;
  int facets_without_area = 0; // corners on one line; kept, since a crack would open without them
  double largest_gap = 0;      // of an open surface that closes when corners are joined over it [m]
  int shells = 0;              // parts of the surface that share no vertex, once they are parted
  int groups_of_shells = 0;    // those that touch in corners taken as one
  double largest_shell_share = 0; // its volume in that of all shells, each taken as positive [-]
  double volume = 0;              // [m3]; negative if inside out, meaningless if open
  SelfIntersection crossings;     // not complete where the search gave up; that is no fault

  bool closed() const { return edges.open + edges.flipped + edges.branching == 0; }
};

// `touching` pairs vertices that are one place of the surface (touching_corners.h). Looks for
// crossings only where the surface is closed and of one shell: otherwise that is said
// first, and 1.5 million facets take a second or two.
void diagnose_surface(const TriangleMesh& mesh, MeshDiagnosis& diagnosis,
                      const std::vector<std::array<int, 2>>& touching = {});

// The first of these that is wrong as the end of a sentence ("is open: ..."), with its numbers;
// empty for a sound surface. In this order: open, branching, not consistently oriented, several
// shells, inside out, without volume, crossing itself.
std::string fault_of(const MeshDiagnosis& diagnosis);
} // namespace interlock::dem
