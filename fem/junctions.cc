#include "fem/junctions.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace interlock::fem
{
namespace
{
struct Vertex {
  dealii::Point<3> position;
  unsigned int first_dof;
};

std::vector<Vertex> vertices_by_x(const dealii::DoFHandler<1, 3>& dof_handler)
{
  std::vector<Vertex> vertices;
  for (const auto& cell : dof_handler.active_cell_iterators())
    for (unsigned int v = 0; v < 2; ++v)
      vertices.push_back({cell->vertex(v), cell->vertex_dof_index(v, 0)});
  const auto earlier = [](const Vertex& a, const Vertex& b) {
    return a.position[0] != b.position[0] ? a.position[0] < b.position[0]
                                          : a.first_dof < b.first_dof;
  };
  std::sort(vertices.begin(), vertices.end(), earlier);
  return vertices;
}
} // namespace

void tie_junctions(const dealii::DoFHandler<1, 3>& dof_handler, double tolerance,
                   dealii::AffineConstraints<double>& constraints)
{
  const std::vector<Vertex> vertices = vertices_by_x(dof_handler);
  for (std::size_t a = 0; a < vertices.size(); ++a) {
    // The smallest freedom among all vertices at this place; only neighbours in x can be there.
    unsigned int master = vertices[a].first_dof;
    const auto look = [&](std::size_t b) {
      if (vertices[a].position.distance(vertices[b].position) <= tolerance)
        master = std::min(master, vertices[b].first_dof);
      return std::abs(vertices[a].position[0] - vertices[b].position[0]) <= tolerance;
    };
    for (std::size_t b = a + 1; b < vertices.size() && look(b);) ++b;
    for (std::size_t b = a; b-- > 0 && look(b);) {
    }
    if (master == vertices[a].first_dof || constraints.is_constrained(vertices[a].first_dof))
      continue;
    for (unsigned int c = 0; c < 6; ++c) {
      constraints.add_line(vertices[a].first_dof + c);
      constraints.add_entry(vertices[a].first_dof + c, master + c, 1.);
    }
  }
}
} // namespace interlock::fem
