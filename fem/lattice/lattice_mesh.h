// The deal.II side of a lattice: mesh, element, numbering, junction ties.
#pragma once

#include "fem/lattice/junctions.h"
#include "fem/ribs/rib_line.h"

#include <deal.II/base/index_set.h>
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
//
// Every process holds the whole mesh. Where the program runs on several, METIS cuts it into one
// part for each of them (of MPI_COMM_WORLD); it knows that crossing ribs hang together. The
// freedoms of a part are numbered consecutively.
class LatticeMesh
{
public:
  // Throws std::invalid_argument for a line with fewer than two points, a coordinate that is not
  // finite, two successive points at the same place or closer than a millionth of the lattice's
  // size, or one whose profiles are not one an element.
  LatticeMesh(const std::vector<RibLine>& lines, JunctionTies ties);

  const dealii::DoFHandler<1, 3>& dof_handler() const { return dof_handler_; }

  // Closed constraints that hold only the ties of the junctions.
  const dealii::AffineConstraints<double>& junction_ties() const { return junction_ties_; }

  int n_parts() const { return static_cast<int>(part_freedoms_.size()); }
  const dealii::IndexSet& freedoms_of_part(int part) const { return part_freedoms_[part]; }

private:
  void cut_into_parts(unsigned int n_parts);

  dealii::Triangulation<1, 3> triangulation_;
  dealii::FESystem<1, 3> element_;
  dealii::DoFHandler<1, 3> dof_handler_;
  dealii::AffineConstraints<double> junction_ties_;
  std::vector<dealii::IndexSet> part_freedoms_;
};
} // namespace interlock::fem
