// A lattice of beams in compact arrays, free of deal.II: what dynamics, contacts and output read.
#pragma once

#include "fem/beam/rotational_spring.h"
#include "fem/ribs/rib_line.h"

#include <Eigen/Dense>
#include <Eigen/Geometry>

#include <array>
#include <memory>
#include <vector>

namespace interlock::fem
{
class LatticeMesh;

// A beam between two nodes, in the unloaded state.
struct LatticeElement {
  std::array<int, 2> node{}; // e1 points from node[0] to node[1]
  int line = 0;              // rib line that it belongs to
  int place = 0;             // its number along the line
  double length = 0;         // [m]
  // Element frame to world: columns e1 (along the rib), e2 (in the plane of the lattice, the
  // direction of the rib's width), e3 (out of plane, the direction of its thickness).
  Eigen::Quaterniond frame = Eigen::Quaterniond::Identity();
};

// Nodes, elements and rib lines. A rigid junction is one node, shared by the elements of all lines
// that meet there. At a junction with rotational stiffness every line has a node of its own; these
// nodes share their displacements, and a rotational spring acts between each two of them. Elements
// are numbered line by line, along each line, so that the elements of a line are consecutive and
// element i of a line ends where element i + 1 starts. Copies share the mesh.
class Lattice
{
public:
  // Lines are joined wherever they share a vertex position, rigidly or by springs. Springs are at
  // most a million times as stiff as the ribs at the junction: that is what infinite stiffness in
  // one direction only becomes.
  // Throws std::invalid_argument when there is no line, or one with fewer than two points, with a
  // coordinate that is not finite, with an element shorter than a millionth of the lattice's size,
  // with too few profiles, a normal along its direction, a negative
  // softening or a yield force that is not positive; when a stiffness of the junctions is negative;
  // or when lines whose normals differ by more than 45 degrees meet at a junction with rotational
  // stiffness.
  explicit Lattice(std::vector<RibLine> lines, const JunctionStiffness& junctions = {});
  // The same lattice with `origin` [m] as its origin: positions of nodes are less by it. Rib lines
  // and mesh stay where they were drawn.
  Lattice about(const Eigen::Vector3d& origin) const;
  // The smallest box with edges along the axes that holds all nodes [m].
  Eigen::AlignedBox3d box() const;

  int n_nodes() const { return static_cast<int>(positions_.size()); }
  int n_elements() const { return static_cast<int>(elements_.size()); }
  int n_lines() const { return static_cast<int>(lines_.size()); }

  // Position of a node in the unloaded state, world frame [m].
  const Eigen::Vector3d& reference_position(int node) const { return positions_[node]; }
  const LatticeElement& element(int e) const { return elements_[e]; }
  const RibLine& line(int l) const { return lines_[l]; }
  // Outer shape of an element's rib, for contacts and pictures.
  const RibSection& shape(int e) const
  {
    return shape_of_element(lines_[elements_[e].line], elements_[e].place);
  }
  const BeamSection& section(int e) const
  {
    return section_of_element(lines_[elements_[e].line], elements_[e].place);
  }

  // Springs of the junctions; none where they are rigid.
  int n_springs() const { return static_cast<int>(springs_.size()); }
  const RotationalSpring& spring(int s) const { return springs_[s]; }

  // Nodes of one line, from its first vertex to its last.
  std::vector<int> nodes_of_line(int l) const;
  // Nodes with the smallest x of the unloaded state: the front transverse rib of a biaxial lattice.
  std::vector<int> front_edge_nodes() const;
  // The node nearest to a point of the unloaded state [m].
  int nearest_node(const Eigen::Vector3d& point) const;
  // All nodes at the place of this one, itself included: more than one at junctions with rotational
  // stiffness.
  std::vector<int> joined_nodes(int node) const;
  // Mass of all ribs [kg].
  double mass() const;

  // Freedom 0-5 of a node (displacement, rotation) in deal.II's numbering; joined nodes have the
  // same displacement freedoms.
  unsigned int dof(int node, int component) const
  {
    return component < 3 ? first_dof_[node] + component : first_spin_dof_[node] + component - 3;
  }
  const LatticeMesh& mesh() const { return *mesh_; }

private:
  void add_springs(const JunctionStiffness& junctions);

  std::vector<RibLine> lines_;
  std::shared_ptr<const LatticeMesh> mesh_;
  std::vector<Eigen::Vector3d> positions_;
  std::vector<LatticeElement> elements_;
  std::vector<RotationalSpring> springs_;
  std::vector<unsigned int> first_dof_, first_spin_dof_;
};
} // namespace interlock::fem
