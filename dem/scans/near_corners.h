// Corners of a surface that should be one and differ in their last digits.
#pragma once

#include "dem/meshes/triangle_mesh.h"

namespace interlock::dem
{
// A surface whose corners were joined over small gaps.
struct JoinedSurface {
  TriangleMesh mesh;
  int joined = 0;                                  // corners that gave way to another one
  int degenerate_facets = 0, duplicate_facets = 0; // dropped, since they became so
  double largest_gap = 0;                          // between corners that were joined
  EdgeDiagnosis edges;                             // of `mesh`
};

// Joins corners on open edges that are at most `tolerance` apart: writers of STL files that compute
// the corners of each facet anew, or print few digits, leave such surfaces open everywhere, by
// units in the last place. Sound edges are not touched, and neither is any corner inside the
// surface. A corner joins the nearest of those that came before it in the file and joined none, so
// that no chain of small gaps makes a large one, and the result depends on nothing but the file.
// Facets whose corners all lie within the tolerance vanish.
JoinedSurface join_near_corners(const TriangleMesh& mesh, double tolerance);

// In shares of the largest extent: what is joined without a question (60 nm of a stone of 60 mm;
// the rounding of single precision is a sixteenth of it, and no scan has facets so small), and the
// largest gap over which corners are said to nearly meet, for the user to judge.
constexpr double joined_gap = 1e-6, largest_near_gap = 1e-3; // [-]

// A gap that closes the whole surface when corners are joined over it, and no facet vanishes (or it
// is a small hole); 0 if none up to largest_near_gap does.
double closing_gap(const TriangleMesh& mesh);
} // namespace interlock::dem
