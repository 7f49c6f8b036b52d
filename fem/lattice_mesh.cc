#include "fem/lattice_mesh.h"

#include "fem/number_text.h"

#include <deal.II/fe/fe_q.h>
#include <deal.II/grid/grid_tools.h>

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
  for (std::size_t p = 1; p < n; ++p)
    if (!((line.points[p] - line.points[p - 1]).norm() > 0))
      throw std::invalid_argument(name + " has an element without length at " +
                                  point_text(line.points[p]) + " m.");
  if (!line.profiles.empty() && line.profiles.size() != n - 1)
    throw std::invalid_argument(name + " has " + std::to_string(line.profiles.size()) +
                                " profiles but needs none or one for each of its " +
                                std::to_string(n - 1) + " elements.");
}

void fill(dealii::Triangulation<1, 3>& triangulation, const std::vector<RibLine>& lines)
{
  std::vector<dealii::Point<3>> vertices;
  std::vector<dealii::CellData<1>> cells;
  for (std::size_t l = 0; l < lines.size(); ++l) {
    check_line(lines[l], l);
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
} // namespace

LatticeMesh::LatticeMesh(const std::vector<RibLine>& lines, JunctionTies ties)
    : element_(dealii::FE_Q<1, 3>(1), 6), dof_handler_(triangulation_)
{
  if (lines.empty()) throw std::invalid_argument("A lattice needs at least one rib line.");
  fill(triangulation_, lines);
  dof_handler_.distribute_dofs(element_);
  tie_junctions(dof_handler_, coincidence_tolerance(triangulation_), ties, junction_ties_);
  junction_ties_.close();
}
} // namespace interlock::fem
