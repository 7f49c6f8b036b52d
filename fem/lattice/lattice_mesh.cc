#include "fem/lattice/lattice_mesh.h"

#include "fem/ribs/number_text.h"

#include <Eigen/Geometry>

#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_renumbering.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <algorithm>
#include <map>
#include <stdexcept>

namespace interlock::fem
{
namespace
{
void check_line(const RibLine& line, std::size_t l)
{
  const std::string name = "Rib line " + std::to_string(l);
  const std::size_t n = line.points.size();
  if (n < 2)
    throw std::invalid_argument(name + " has " + std::to_string(n) +
                                " points but needs at least 2.");
  for (const Eigen::Vector3d& point : line.points)
    if (!point.allFinite())
      throw std::invalid_argument(name + " has a vertex at " + point_text(point) +
                                  " m, but coordinates must be finite.");
  for (std::size_t p = 1; p < n; ++p)
    if (!((line.points[p] - line.points[p - 1]).norm() > 0))
      throw std::invalid_argument(name + " has an element without length at " +
                                  point_text(line.points[p]) + " m.");
  if (!line.profiles.empty() && line.profiles.size() != n - 1)
    throw std::invalid_argument(name + " has " + std::to_string(line.profiles.size()) +
                                " profiles but needs none or one for each of its " +
                                std::to_string(n - 1) + " elements.");
}

// Such a short element has no direction but rounding, and its stiffness drowns that of the others.
void require_no_speck(const std::vector<RibLine>& lines)
{
  Eigen::AlignedBox3d box;
  for (const RibLine& line : lines)
    for (const Eigen::Vector3d& point : line.points) box.extend(point);
  const double size = box.diagonal().norm();
  for (std::size_t l = 0; l < lines.size(); ++l)
    for (std::size_t p = 1; p < lines[l].points.size(); ++p) {
      const double length = (lines[l].points[p] - lines[l].points[p - 1]).norm();
      if (!(length > 1e-6 * size))
        throw std::invalid_argument(
            "Rib line " + std::to_string(l) + " has an element of " + number_text(length) +
            " m at " + point_text(lines[l].points[p]) +
            " m, but an element must be longer than a millionth of the lattice's size, " +
            number_text(size) + " m: make its two vertices one.");
    }
}

void fill(dealii::Triangulation<1, 3>& triangulation, const std::vector<RibLine>& lines)
{
  std::vector<dealii::Point<3>> vertices;
  std::vector<dealii::CellData<1>> cells;
  for (std::size_t l = 0; l < lines.size(); ++l) check_line(lines[l], l);
  require_no_speck(lines);
  for (std::size_t l = 0; l < lines.size(); ++l) {
    for (std::size_t p = 0; p < lines[l].points.size(); ++p) {
      const Eigen::Vector3d& x = lines[l].points[p];
      vertices.emplace_back(x[0], x[1], x[2]);
      if (p == 0) continue;
      cells.emplace_back();
      cells.back().vertices = {static_cast<unsigned int>(vertices.size() - 2),
                               static_cast<unsigned int>(vertices.size() - 1)};
      cells.back().material_id = static_cast<dealii::types::material_id>(l);
    }
  }
  triangulation.create_triangulation(vertices, cells, dealii::SubCellData());
}

// Well below any element length, well above rounding of coordinates.
double coincidence_tolerance(const dealii::Triangulation<1, 3>& triangulation)
{
  return 1e-6 * dealii::GridTools::minimal_cell_diameter(triangulation);
}

// Which cells share a vertex or a junction.
dealii::SparsityPattern neighbours(const dealii::DoFHandler<1, 3>& dof_handler,
                                   const dealii::AffineConstraints<double>& ties)
{
  std::map<dealii::types::global_dof_index, std::vector<unsigned int>> cells_at;
  for (const auto& cell : dof_handler.active_cell_iterators())
    for (unsigned int v = 0; v < 2; ++v) {
      const auto dof = cell->vertex_dof_index(v, 0);
      const auto* master = ties.get_constraint_entries(dof);
      cells_at[master == nullptr ? dof : master->front().first].push_back(
          cell->active_cell_index());
    }
  const unsigned int n_cells = dof_handler.get_triangulation().n_active_cells();
  dealii::DynamicSparsityPattern graph(n_cells);
  for (const auto& [dof, cells] : cells_at)
    for (const unsigned int a : cells)
      for (const unsigned int b : cells) graph.add(a, b);
  dealii::SparsityPattern pattern;
  pattern.copy_from(graph);
  return pattern;
}
} // namespace

LatticeMesh::LatticeMesh(const std::vector<RibLine>& lines, JunctionTies ties)
    : element_(dealii::FE_Q<1, 3>(1), 6), dof_handler_(triangulation_)
{
  if (lines.empty()) throw std::invalid_argument("A lattice needs at least one rib line.");
  fill(triangulation_, lines);
  dof_handler_.distribute_dofs(element_);
  const double tolerance = coincidence_tolerance(triangulation_);
  tie_junctions(dof_handler_, tolerance, ties, junction_ties_);
  junction_ties_.close();

  // Programs without MPI hold lattices too.
  const unsigned int n_processes = dealii::Utilities::MPI::job_supports_mpi()
                                       ? dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD)
                                       : 1;
  const unsigned int n_parts = std::min(n_processes, triangulation_.n_active_cells());
  if (n_parts > 1) {
    cut_into_parts(n_parts);
    junction_ties_.clear();
    tie_junctions(dof_handler_, tolerance, ties, junction_ties_);
    junction_ties_.close();
  }
  part_freedoms_ = dealii::DoFTools::locally_owned_dofs_per_subdomain(dof_handler_);
}

void LatticeMesh::cut_into_parts(unsigned int n_parts)
{
  dealii::GridTools::partition_triangulation(n_parts, neighbours(dof_handler_, junction_ties_),
                                             triangulation_);
  dealii::DoFRenumbering::subdomain_wise(dof_handler_);
}
} // namespace interlock::fem
