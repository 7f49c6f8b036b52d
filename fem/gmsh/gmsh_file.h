// The line elements and groups of a Gmsh file, as they stand there.
#pragma once

#include <Eigen/Dense>

#include <array>
#include <map>
#include <string>
#include <vector>

namespace interlock::fem
{
struct GmshFile {
  struct Line {
    std::array<int, 2> node{}; // in the order of the file
    std::string group;         // name of its one-dimensional physical group
  };
  std::string path;
  std::vector<Eigen::Vector3d> nodes;                   // in the file's unit of length
  std::vector<Line> lines;                              // by increasing element number
  std::map<std::string, std::vector<int>> point_groups; // zero-dimensional groups: their nodes
};

// Reads .msh files, versions 2.2 and 4.1, text or binary, by Gmsh's own library, in a process of
// its own: the library crashes on many a damaged file. A group without a name is called by its
// number. Elements of higher dimension are left out. Throws std::runtime_error, one sentence that
// starts with the file, when the file cannot be read, is no Gmsh file, is refused by Gmsh or makes
// it crash, has a node that is nowhere, no line element, or line elements that belong to none or to
// several groups or have more than two nodes each.
GmshFile read_gmsh_file(const std::string& path);

// The beginning of every such sentence: Lattice file "path"
std::string gmsh_file_name(const std::string& path);
} // namespace interlock::fem
