// Junctions of a lattice: where rib lines cross, their coincident vertices are tied.
#pragma once

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>

namespace interlock::fem
{
enum class JunctionTies { displacement_and_rotation, displacement };

// Adds to `constraints` a joint at every place where vertices of several lines coincide: the
// freedoms (displacement, and with it the rotation increment) of the later vertices equal those of
// the first one, which is the vertex with the smallest freedom numbers. With
// JunctionTies::displacement every line keeps one rotation of its own. `tolerance` [m] is the
// distance below which two vertices count as one. The handler must carry a six-component linear
// element and the index of its line as material id of each cell; `constraints` must not be closed
// yet.
void tie_junctions(const dealii::DoFHandler<1, 3>& dof_handler, double tolerance, JunctionTies ties,
                   dealii::AffineConstraints<double>& constraints);
} // namespace interlock::fem
