#include "fem/gmsh/gmsh_file.h"

#include "fem/gmsh/child_process.h"

#include <gmsh.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <stdexcept>

namespace interlock::fem
{
namespace
{
std::string group_name(int dimension, int tag)
{
  std::string name;
  gmsh::model::getPhysicalName(dimension, tag, name);
  return name.empty() ? std::to_string(tag) : name;
}

std::vector<int> group_tags(int dimension)
{
  gmsh::vectorpair groups;
  gmsh::model::getPhysicalGroups(groups, dimension);
  std::vector<int> tags;
  for (const auto& [dim, tag] : groups) tags.push_back(tag);
  return tags;
}

// Gmsh opens files by their name's ending too; only this beginning makes it a mesh.
void require_mesh_header(const std::string& path)
{
  std::ifstream file(path);
  std::string word;
  if (!file) throw std::runtime_error(gmsh_file_name(path) + " cannot be opened.");
  file >> word;
  if (word != "$MeshFormat" && word != "$Comments")
    throw std::runtime_error(gmsh_file_name(path) +
                             " is no Gmsh mesh: it does not start with $MeshFormat.");
}

// One sentence of whatever Gmsh says.
std::string one_line(std::string text)
{
  std::replace(text.begin(), text.end(), '\n', ' ');
  while (!text.empty() && (text.back() == ' ' || text.back() == '.')) text.pop_back();
  return text;
}

void open_mesh(const std::string& path)
{
  std::string fault;
  try {
    gmsh::open(path);
    return;
  } catch (const std::exception& error) {
    fault = error.what();
  } catch (const std::string& text) { // thrown by older versions
    fault = text;
  } catch (int) {
    gmsh::logger::getLastError(fault);
  }
  throw std::runtime_error(gmsh_file_name(path) + " is refused by Gmsh: " + one_line(fault) + ".");
}

using NodeIndex = std::map<std::size_t, int>;

NodeIndex read_nodes(GmshFile& file)
{
  std::vector<std::size_t> tags;
  std::vector<double> x, parametric;
  gmsh::model::mesh::getNodes(tags, x, parametric, -1, -1, false, false);
  NodeIndex index;
  for (std::size_t i = 0; i < tags.size(); ++i) {
    const Eigen::Vector3d place(x[3 * i], x[3 * i + 1], x[3 * i + 2]);
    if (!place.allFinite())
      throw std::runtime_error(gmsh_file_name(file.path) + " has a node " +
                               std::to_string(tags[i]) + " whose coordinates are no numbers.");
    if (index.emplace(tags[i], static_cast<int>(file.nodes.size())).second)
      file.nodes.push_back(place);
  }
  return index;
}

int node_at(const std::string& path, const NodeIndex& index, std::size_t tag)
{
  const auto node = index.find(tag);
  if (node == index.end())
    throw std::runtime_error(gmsh_file_name(path) + " refers to node " + std::to_string(tag) +
                             ", which it does not have.");
  return node->second;
}

// Name of the one group of a curve.
std::string curve_group(const std::string& path, int curve)
{
  std::vector<int> tags;
  gmsh::model::getPhysicalGroupsForEntity(1, curve, tags);
  if (tags.empty())
    throw std::runtime_error(gmsh_file_name(path) + " has line elements, those of curve " +
                             std::to_string(curve) +
                             ", that belong to no physical group and so have no section.");
  if (tags.size() > 1)
    throw std::runtime_error(gmsh_file_name(path) + " has line elements, those of curve " +
                             std::to_string(curve) + ", that belong to the groups \"" +
                             group_name(1, tags[0]) + "\" and \"" + group_name(1, tags[1]) +
                             "\" but must belong to one.");
  return group_name(1, tags[0]);
}

// Gmsh takes all elements of a curve for the type of the first one: listed by type it counts them
// all, but it returns those of that type only.
void require_first_order(const std::string& path, int curve, int type, std::size_t listed)
{
  constexpr int two_node_line = 1;
  std::vector<std::size_t> elements, nodes;
  gmsh::model::mesh::getElementsByType(type, elements, nodes, curve);
  if (type != two_node_line || elements.size() != listed)
    throw std::runtime_error(gmsh_file_name(path) + " has line elements, those of curve " +
                             std::to_string(curve) +
                             ", of higher order, but only those with 2 nodes are read.");
}

void read_lines(const std::string& path, const NodeIndex& index, GmshFile& file)
{
  std::map<std::size_t, GmshFile::Line> by_number;
  gmsh::vectorpair curves;
  gmsh::model::getEntities(curves, 1);
  for (const auto& [dim, curve] : curves) {
    std::vector<int> types;
    std::vector<std::vector<std::size_t>> elements, nodes;
    gmsh::model::mesh::getElements(types, elements, nodes, 1, curve);
    if (types.empty()) continue;
    const std::string group = curve_group(path, curve);
    require_first_order(path, curve, types.front(), elements.front().size());
    for (std::size_t i = 0; i < elements[0].size(); ++i)
      by_number[elements[0][i]] = {
          {node_at(path, index, nodes[0][2 * i]), node_at(path, index, nodes[0][2 * i + 1])},
          group};
  }
  for (auto& [number, line] : by_number) file.lines.push_back(std::move(line));
  if (file.lines.empty()) throw std::runtime_error(gmsh_file_name(path) + " has no line elements.");
}

void read_point_groups(const std::string& path, const NodeIndex& index, GmshFile& file)
{
  for (const int tag : group_tags(0)) {
    std::vector<std::size_t> nodes;
    std::vector<double> x;
    gmsh::model::mesh::getNodesForPhysicalGroup(0, tag, nodes, x);
    std::vector<int>& group = file.point_groups[group_name(0, tag)];
    for (const std::size_t node : nodes) group.push_back(node_at(path, index, node));
    std::sort(group.begin(), group.end());
  }
}
// Gmsh is not closed again: it lives as long as the process that reads this one file.
GmshFile read_by_gmsh(const std::string& path)
{
  gmsh::initialize(0, nullptr, false);
  gmsh::option::setNumber("General.Terminal", 0);
  open_mesh(path);
  GmshFile file;
  file.path = path;
  const NodeIndex index = read_nodes(file);
  read_lines(path, index, file);
  read_point_groups(path, index, file);
  return file;
}

// Between two processes, bit by bit.
std::string to_bytes(const GmshFile& file)
{
  nlohmann::json nodes = nlohmann::json::array(), lines = nlohmann::json::array();
  for (const Eigen::Vector3d& x : file.nodes) nodes.push_back({x[0], x[1], x[2]});
  for (const GmshFile::Line& line : file.lines)
    lines.push_back({line.node[0], line.node[1], line.group});
  std::string bytes;
  nlohmann::json::to_cbor({{"path", file.path},
                           {"nodes", nodes},
                           {"lines", lines},
                           {"point_groups", file.point_groups}},
                          bytes);
  return bytes;
}

GmshFile from_bytes(const std::string& bytes)
{
  const nlohmann::json all = nlohmann::json::from_cbor(bytes);
  GmshFile file;
  file.path = all["path"];
  for (const nlohmann::json& x : all["nodes"]) file.nodes.emplace_back(x[0], x[1], x[2]);
  for (const nlohmann::json& line : all["lines"])
    file.lines.push_back({{line[0], line[1]}, line[2]});
  file.point_groups = all["point_groups"].get<std::map<std::string, std::vector<int>>>();
  return file;
}
} // namespace

std::string gmsh_file_name(const std::string& path)
{
  return "Lattice file \"" + path + "\"";
}

GmshFile read_gmsh_file(const std::string& path)
{
  require_mesh_header(path);
  const std::string bytes = in_child_process(
      [&] { return to_bytes(read_by_gmsh(path)); },
      gmsh_file_name(path) + " is damaged: Gmsh's own library crashes while it reads it.");
  return from_bytes(bytes);
}
} // namespace interlock::fem
