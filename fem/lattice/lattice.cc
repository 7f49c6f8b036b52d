#include "fem/lattice/lattice.h"

#include "fem/lattice/lattice_mesh.h"
#include "fem/ribs/number_text.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>

namespace interlock::fem
{
namespace
{
Eigen::Quaterniond element_frame(const Eigen::Vector3d& chord, const RibLine& line, int l)
{
  const Eigen::Vector3d e1 = chord.normalized();
  const Eigen::Vector3d across = line.normal.cross(e1);
  if (!(across.norm() > 1e-6 * line.normal.norm()))
    throw std::invalid_argument(
        "The normal of rib line " + std::to_string(l) +
        " points along the line, so the axes of its section are undefined.");
  Eigen::Matrix3d axes;
  axes.col(0) = e1;
  axes.col(1) = across.normalized();
  axes.col(2) = e1.cross(axes.col(1));
  return Eigen::Quaterniond(axes).normalized();
}

void require_tension_law(const BeamSection& section, std::size_t l)
{
  const std::string line = " of rib line " + std::to_string(l) + " is ";
  if (!(section.softening >= 0))
    throw std::invalid_argument("The softening" + line + std::to_string(section.softening) +
                                " but must not be negative.");
  if (!(section.yield_force > 0))
    throw std::invalid_argument("The yield force" + line + std::to_string(section.yield_force) +
                                " N but must be positive.");
}

// The freedom that stands for `dof`: itself, or the one that a junction ties it to.
unsigned int master_dof(const dealii::AffineConstraints<double>& ties, unsigned int dof)
{
  const auto* entries = ties.get_constraint_entries(dof);
  return entries == nullptr ? dof : static_cast<unsigned int>(entries->front().first);
}

JunctionTies ties_of(const JunctionStiffness& junctions)
{
  for (const double stiffness : {junctions.in_plane, junctions.out_of_plane})
    if (!(stiffness >= 0))
      throw std::invalid_argument("The rotational stiffness of junctions is " +
                                  number_text(stiffness) + " N m/rad but must not be negative.");
  return is_rigid(junctions) ? JunctionTies::displacement_and_rotation : JunctionTies::displacement;
}
} // namespace

Lattice::Lattice(std::vector<RibLine> lines, const JunctionStiffness& junctions)
    : lines_(std::move(lines)), mesh_(std::make_shared<LatticeMesh>(lines_, ties_of(junctions)))
{
  for (std::size_t l = 0; l < lines_.size(); ++l) {
    if (lines_[l].profiles.empty()) require_tension_law(lines_[l].section, l);
    for (const RibProfile& profile : lines_[l].profiles) require_tension_law(profile.section, l);
  }
  std::map<unsigned int, int> node_of_spin_dof;
  for (const auto& cell : mesh_->dof_handler().active_cell_iterators()) {
    LatticeElement element;
    element.line = static_cast<int>(cell->material_id());
    if (!elements_.empty() && elements_.back().line == element.line)
      element.place = elements_.back().place + 1;
    std::array<Eigen::Vector3d, 2> ends;
    for (unsigned int v = 0; v < 2; ++v) {
      ends[v] = {cell->vertex(v)[0], cell->vertex(v)[1], cell->vertex(v)[2]};
      const unsigned int spin_dof =
          master_dof(mesh_->junction_ties(), cell->vertex_dof_index(v, 3));
      const auto [entry, is_new] = node_of_spin_dof.emplace(spin_dof, n_nodes());
      if (is_new) {
        positions_.push_back(ends[v]);
        first_dof_.push_back(master_dof(mesh_->junction_ties(), cell->vertex_dof_index(v, 0)));
        first_spin_dof_.push_back(spin_dof);
      }
      element.node[v] = entry->second;
    }
    element.length = (ends[1] - ends[0]).norm();
    element.frame = element_frame(ends[1] - ends[0], lines_[element.line], element.line);
    elements_.push_back(element);
  }
  if (!is_rigid(junctions)) add_springs(junctions);
}

Lattice Lattice::about(const Eigen::Vector3d& origin) const
{
  Lattice moved = *this;
  for (Eigen::Vector3d& position : moved.positions_) position -= origin;
  return moved;
}

Eigen::AlignedBox3d Lattice::box() const
{
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& position : positions_) box.extend(position);
  return box;
}

void Lattice::add_springs(const JunctionStiffness& junctions)
{
  // Of each node: a normal of its ribs and the largest stiffness of an element against turning.
  std::vector<Eigen::Vector3d> normal(n_nodes());
  std::vector<double> stiffest(n_nodes(), 0.);
  for (int e = 0; e < n_elements(); ++e)
    for (const int node : elements_[e].node) {
      const BeamSection& s = section(e);
      normal[node] = elements_[e].frame * Eigen::Vector3d::UnitZ();
      stiffest[node] = std::max(
          {stiffest[node], s.bending_2 / elements_[e].length, s.bending_3 / elements_[e].length});
    }
  std::map<unsigned int, std::vector<int>> places;
  for (int i = 0; i < n_nodes(); ++i) places[first_dof_[i]].push_back(i);

  for (const auto& [dof, nodes] : places)
    for (std::size_t b = 1; b < nodes.size(); ++b)
      for (std::size_t a = 0; a < b; ++a) {
        if (!(normal[nodes[a]].dot(normal[nodes[b]]) > std::sqrt(0.5)))
          throw std::invalid_argument(
              "Rib lines with different normals meet at " + point_text(positions_[nodes[a]]) +
              " m, so the rotational stiffness of that junction has no plane.");
        const double rigid = 1e6 * std::max(stiffest[nodes[a]], stiffest[nodes[b]]);
        springs_.push_back({{nodes[a], nodes[b]},
                            (normal[nodes[a]] + normal[nodes[b]]).normalized(),
                            std::min(junctions.in_plane, rigid),
                            std::min(junctions.out_of_plane, rigid)});
      }
}

std::vector<int> Lattice::joined_nodes(int node) const
{
  std::vector<int> nodes;
  for (int i = 0; i < n_nodes(); ++i)
    if (first_dof_[i] == first_dof_[node]) nodes.push_back(i);
  return nodes;
}

std::vector<int> Lattice::nodes_of_line(int l) const
{
  std::vector<int> nodes;
  for (const LatticeElement& element : elements_) {
    if (element.line != l) continue;
    if (nodes.empty()) nodes.push_back(element.node[0]);
    nodes.push_back(element.node[1]);
  }
  return nodes;
}

std::vector<int> Lattice::front_edge_nodes() const
{
  double front = positions_[0].x(), shortest = elements_[0].length;
  for (const Eigen::Vector3d& x : positions_) front = std::min(front, x.x());
  for (const LatticeElement& element : elements_) shortest = std::min(shortest, element.length);
  std::vector<int> nodes;
  for (int i = 0; i < n_nodes(); ++i)
    if (positions_[i].x() <= front + 1e-6 * shortest) nodes.push_back(i);
  return nodes;
}

int Lattice::nearest_node(const Eigen::Vector3d& point) const
{
  const auto nearer = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return (a - point).squaredNorm() < (b - point).squaredNorm();
  };
  return static_cast<int>(std::min_element(positions_.begin(), positions_.end(), nearer) -
                          positions_.begin());
}

double Lattice::mass() const
{
  double sum = 0;
  for (int e = 0; e < n_elements(); ++e) sum += section(e).line_density * elements_[e].length;
  return sum;
}
} // namespace interlock::fem
