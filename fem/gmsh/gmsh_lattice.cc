#include "fem/gmsh/gmsh_lattice.h"

#include "fem/gmsh/line_chains.h"
#include "fem/lattice/lattice_checks.h"
#include "fem/ribs/number_text.h"

#include <set>
#include <stdexcept>

namespace interlock::fem
{
namespace
{
using Sections = std::map<std::string, GmshSection>;

std::string quoted_list(const std::set<std::string>& names)
{
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "\"" : ", \"") + name + "\"";
  return list.empty() ? "none" : list;
}

void check_groups(const GmshFile& file, const Sections& sections)
{
  std::set<std::string> groups, given;
  for (const GmshFile::Line& line : file.lines) groups.insert(line.group);
  for (const auto& [name, section] : sections) given.insert(name);
  for (const std::string& group : groups)
    if (given.count(group) == 0)
      throw std::runtime_error("the group \"" + group + "\" of lines has no section; given are " +
                               quoted_list(given) + ".");
  for (const auto& [name, section] : sections) {
    if (groups.count(name) == 0)
      throw std::runtime_error("there are no lines of group \"" + name +
                               "\", for which a section is given; groups are " +
                               quoted_list(groups) + ".");
    try {
      given_section(section.profile.section);
    } catch (const std::invalid_argument& error) {
      throw std::runtime_error("the section of group \"" + name +
                               "\" is not valid: " + error.what());
    }
  }
}

std::vector<ChainLink> links_of(const GmshFile& file, const Sections& sections)
{
  std::vector<ChainLink> links;
  for (const GmshFile::Line& line : file.lines) {
    const Eigen::Vector3d& start = file.nodes[line.node[0]];
    if (!((file.nodes[line.node[1]] - start).norm() > 0))
      throw std::runtime_error("a line element of group \"" + line.group + "\" has no length at " +
                               point_text(start) + " in the file's unit.");
    links.push_back({line.node, sections.at(line.group).normal});
  }
  return links;
}

RibLine line_of(const GmshFile& file, const Sections& sections, const Chain& chain, double unit)
{
  RibLine line;
  const std::string& group = file.lines[chain.links.front()].group;
  line.normal = sections.at(group).normal;
  line.shape = sections.at(group).profile.shape;
  line.section = sections.at(group).profile.section;
  for (const int node : chain.nodes) line.points.push_back(unit * file.nodes[node]);
  bool uniform = true;
  for (const int link : chain.links) {
    uniform = uniform && file.lines[link].group == group;
    line.profiles.push_back(sections.at(file.lines[link].group).profile);
  }
  if (uniform) line.profiles.clear();
  return line;
}

GmshLattice lattice_of(const GmshFile& file, const Sections& sections, double unit)
{
  if (!(unit > 0))
    throw std::runtime_error("its unit of length is given as " + number_text(unit) +
                             " m but must be positive.");
  check_groups(file, sections);
  GmshLattice result;
  std::set<int> used;
  for (const Chain& chain : straightest_chains(file.nodes, links_of(file, sections))) {
    result.lines.push_back(line_of(file, sections, chain, unit));
    used.insert(chain.nodes.begin(), chain.nodes.end());
  }
  for (const auto& [name, nodes] : file.point_groups)
    for (const int node : nodes) {
      if (used.count(node) == 0)
        throw std::runtime_error("the group \"" + name + "\" has a point at " +
                                 point_text(file.nodes[node]) + " that is on no line element.");
      result.points[name].push_back(unit * file.nodes[node]);
    }
  const Lattice lattice(result.lines);
  check_connected(lattice);
  check_overlaps(lattice);
  return result;
}
} // namespace

GmshLattice gmsh_lattice(const GmshFile& file, const Sections& sections, double length_unit)
{
  try {
    return lattice_of(file, sections, length_unit);
  } catch (const std::exception& error) {
    throw std::runtime_error(gmsh_file_name(file.path) + ": " + error.what());
  }
}

std::map<std::string, std::vector<int>> node_sets(const GmshLattice& file, const Lattice& lattice)
{
  std::map<std::string, std::vector<int>> sets;
  for (const auto& [name, points] : file.points)
    for (const Eigen::Vector3d& point : points) {
      const int nearest = lattice.nearest_node(point);
      if ((lattice.reference_position(nearest) - point).norm() > 1e-6 * lattice.element(0).length)
        throw std::runtime_error("The point at " + point_text(point) + " m of group \"" + name +
                                 "\" has no node in the lattice.");
      const std::vector<int> nodes = lattice.joined_nodes(nearest);
      sets[name].insert(sets[name].end(), nodes.begin(), nodes.end());
    }
  return sets;
}
} // namespace interlock::fem
