#include "fem/lattice/junctions.h"

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
  unsigned int line;
};

std::vector<Vertex> vertices_by_x(const dealii::DoFHandler<1, 3>& dof_handler)
{
  std::vector<Vertex> vertices;
  for (const auto& cell : dof_handler.active_cell_iterators())
    for (unsigned int v = 0; v < 2; ++v)
      vertices.push_back({cell->vertex(v), cell->vertex_dof_index(v, 0), cell->material_id()});
  const auto earlier = [](const Vertex& a, const Vertex& b) {
    return a.position[0] != b.position[0] ? a.position[0] < b.position[0]
                                          : a.first_dof < b.first_dof;
  };
  std::sort(vertices.begin(), vertices.end(), earlier);
  return vertices;
}

// The smallest first freedom among the vertices at the place of vertex a, of all lines or of its
// own; `vertices` are sorted by x, so only neighbours can be there.
unsigned int master_of(const std::vector<Vertex>& vertices, std::size_t a, double tolerance,
                       bool own_line)
{
  unsigned int master = vertices[a].first_dof;
  const auto look = [&](std::size_t b) {
    if (vertices[a].position.distance(vertices[b].position) <= tolerance &&
        (!own_line || vertices[a].line == vertices[b].line))
      master = std::min(master, vertices[b].first_dof);
    return std::abs(vertices[a].position[0] - vertices[b].position[0]) <= tolerance;
  };
  for (std::size_t b = a + 1; b < vertices.size() && look(b);) ++b;
  for (std::size_t b = a; b-- > 0 && look(b);) {
  }
  return master;
}

// Ties three freedoms in sequence to three others.
void tie(unsigned int first_dof, unsigned int master,
         dealii::AffineConstraints<double>& constraints)
{
  if (master == first_dof || constraints.is_constrained(first_dof)) return;
  for (unsigned int c = 0; c < 3; ++c) {
    constraints.add_line(first_dof + c);
    constraints.add_entry(first_dof + c, master + c, 1.);
  }
}
} // namespace

void tie_junctions(const dealii::DoFHandler<1, 3>& dof_handler, double tolerance, JunctionTies ties,
                   dealii::AffineConstraints<double>& constraints)
{
  const bool own_rotations = ties == JunctionTies::displacement;
  const std::vector<Vertex> vertices = vertices_by_x(dof_handler);
  for (std::size_t a = 0; a < vertices.size(); ++a) {
    const unsigned int dof = vertices[a].first_dof;
    tie(dof, master_of(vertices, a, tolerance, false), constraints);
    tie(dof + 3, master_of(vertices, a, tolerance, own_rotations) + 3, constraints);
  }
}
} // namespace interlock::fem
