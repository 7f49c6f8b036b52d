// The deal.II side of a lattice: mesh, element, numbering, junction ties.
#pragma once

#include "fem/junctions.h"
#include "fem/rib_line.h"

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/affine_constraints.h>

#include <vector>

namespace interlock::fem
{
// One cell is one beam element; cells are in the order of the lines, and along each line. The
// material id of a cell is the index of its line. deal.II allows only two cells at a vertex of a
// one-dimensional mesh, so every line has its own vertices, and the ties of `junction_ties` join
// lines. Six components: displacement [m], then rotation increment [rad], both in the world frame.
class LatticeMesh
{
public:
  // Throws std::invalid_argument for a line with fewer than two points, one with two successive
  // points at the same place, or one whose profiles are not one an element.
  LatticeMesh(const std::vector<RibLine>& lines, JunctionTies ties);

  const dealii::DoFHandler<1, 3>& dof_handler() const { return dof_handler_; }

  // Closed constraints that hold only the ties of the junctions.
  const dealii::AffineConstraints<double>& junction_ties() const { return junction_ties_; }

private:
  dealii::Triangulation<1, 3> triangulation_;
  dealii::FESystem<1, 3> element_;
  dealii::DoFHandler<1, 3> dof_handler_;
  dealii::AffineConstraints<double> junction_ties_;
};
} // namespace interlock::fem
