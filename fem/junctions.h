// Junctions of a lattice: where rib lines cross, their coincident vertices are tied.
#pragma once

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>

namespace interlock::fem
{
// Adds to `constraints` a rigid joint at every place where vertices of several lines coincide: all
// six freedoms (displacement, rotation increment) of the later vertices equal those of the first
// one, which is the vertex with the smallest freedom numbers. `tolerance` [m] is the distance below
// which two vertices count as one. The handler must carry a six-component linear element;
// `constraints` must not be closed yet. Replace this function to give junctions a stiffness of
// their own.
void tie_junctions(const dealii::DoFHandler<1, 3>& dof_handler, double tolerance,
                   dealii::AffineConstraints<double>& constraints);
} // namespace interlock::fem
