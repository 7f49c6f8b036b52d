// Angularity of a stone as image analysers of aggregates measure it.
#pragma once

#include "dem/meshes/triangle_mesh.h"

namespace interlock::dem
{
// Angularity index of Rao, Tutumluer and Kim (2002), Quantification of coarse aggregate angularity
// based on image analysis, Transportation Research Record 1787, 117-124: the shadow's outline is
// made a polygon of 24 equal steps, beta is the change of the angle at the vertex from one vertex
// to the next [degrees], and A is the sum of beta over the vertices, rounded down to tens. The
// index is the mean of A over three shadows at right angles, weighted by their areas. A circle has
// 0. A square has 720 (two changes of 90 degrees a corner) where vertices meet its corners, 500 on
// average.
//
// The source writes shares of vertices; only their numbers give the published values of hundreds.
// Chosen here because the source leaves it open: shadows are taken along the principal axes of
// inertia; an outline is what is seen from the middle of the shadow (the farthest point on each of
// 720 rays), and A is the mean over twelve places for the first vertex.
double angularity_index(const TriangleMesh& mesh); // [degrees]
} // namespace interlock::dem
