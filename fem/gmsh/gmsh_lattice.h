// Any lattice from a Gmsh file: line elements become rib lines, groups choose sections and
// supports.
#pragma once

#include "fem/gmsh/gmsh_file.h"
#include "fem/lattice/lattice.h"
#include "fem/ribs/rib_line.h"

#include <Eigen/Dense>

#include <map>
#include <string>
#include <vector>

namespace interlock::fem
{
// What the elements of one group are.
struct GmshSection {
  RibProfile profile;              // the shape may stay empty for a bare beam
  Eigen::Vector3d normal{0, 0, 1}; // direction of the section's e3, see RibLine
};

struct GmshLattice {
  std::vector<RibLine> lines;                                 // world frame [m]
  std::map<std::string, std::vector<Eigen::Vector3d>> points; // zero-dimensional groups, places [m]
};

// The lattice of the line elements of a file. `sections` has one entry for each
// one-dimensional physical group, by its name; `length_unit` is the file's unit [m], such as 1e-3
// for a drawing in millimetres. At each node, elements of equal normal that continue each other by
// less than 45 degrees, the straightest pair first, become one line; all others end there. Lines
// are in the order of their first elements in the file. Names of zero-dimensional groups are node
// sets for supports and loads.
// Throws std::runtime_error, one sentence with the file and the fact, when
// * a group has no section or a section has no group in the file,
// * a section has no stiffness, an element has no length, or the unit is not positive,
// * a point of a group is not on any line,
// * check_connected or check_overlaps finds a fault.
GmshLattice gmsh_lattice(const GmshFile& file, const std::map<std::string, GmshSection>& sections,
                         double length_unit = 1);

// Nodes of a lattice made from the lines, for each group of points; where a junction has several
// nodes, all of them. Throws std::runtime_error for a point without a node.
std::map<std::string, std::vector<int>> node_sets(const GmshLattice& file, const Lattice& lattice);
} // namespace interlock::fem
