// Small Gmsh files for tests, put together from nodes, line elements and points.
#pragma once

#include <array>
#include <sstream>
#include <string>
#include <vector>

// Elements refer to nodes by their place in the list, groups by their place in the list of names;
// group -1 is none. One-dimensional groups are numbered before the zero-dimensional ones.
struct GmshText {
  std::vector<std::array<double, 3>> nodes;
  std::vector<std::string> line_groups, point_groups;
  struct Line {
    int a, b, group;
  };
  struct Point {
    int node, group;
  };
  std::vector<Line> lines;
  std::vector<Point> points;

  std::string names() const
  {
    std::ostringstream out;
    out.precision(17);
    out << "$PhysicalNames\n" << line_groups.size() + point_groups.size() << '\n';
    for (std::size_t g = 0; g < line_groups.size(); ++g)
      out << "1 " << g + 1 << " \"" << line_groups[g] << "\"\n";
    for (std::size_t g = 0; g < point_groups.size(); ++g)
      out << "0 " << line_groups.size() + g + 1 << " \"" << point_groups[g] << "\"\n";
    out << "$EndPhysicalNames\n";
    return out.str();
  }
  int point_group(int group) const { return static_cast<int>(line_groups.size()) + group + 1; }

  std::string version_2() const
  {
    std::ostringstream out;
    out.precision(17);
    out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
        << names() << "$Nodes\n"
        << nodes.size() << '\n';
    for (std::size_t i = 0; i < nodes.size(); ++i)
      out << i + 1 << ' ' << nodes[i][0] << ' ' << nodes[i][1] << ' ' << nodes[i][2] << '\n';
    out << "$EndNodes\n$Elements\n" << lines.size() + points.size() << '\n';
    int number = 0;
    for (const Line& line : lines)
      out << ++number << " 1 2 " << line.group + 1 << ' ' << line.group + 1 << ' ' << line.a + 1
          << ' ' << line.b + 1 << '\n';
    for (const Point& point : points) {
      ++number;
      out << number << " 15 2 " << point_group(point.group) << ' ' << number << ' '
          << point.node + 1 << '\n';
    }
    out << "$EndElements\n";
    return out.str();
  }

  // Every line group is one curve, every point an entity of its own; all nodes belong to the first
  // curve.
  std::string version_4() const
  {
    std::ostringstream out;
    out.precision(17);
    out << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n"
        << names() << "$Entities\n"
        << points.size() << ' ' << line_groups.size() << " 0 0\n";
    for (std::size_t p = 0; p < points.size(); ++p) {
      const auto& x = nodes[points[p].node];
      out << p + 1 << ' ' << x[0] << ' ' << x[1] << ' ' << x[2] << " 1 "
          << point_group(points[p].group) << '\n';
    }
    for (std::size_t g = 0; g < line_groups.size(); ++g)
      out << g + 1 << " -1e3 -1e3 -1e3 1e3 1e3 1e3 1 " << g + 1 << " 0\n";
    out << "$EndEntities\n$Nodes\n1 " << nodes.size() << " 1 " << nodes.size() << "\n1 1 0 "
        << nodes.size() << '\n';
    for (std::size_t i = 0; i < nodes.size(); ++i) out << i + 1 << '\n';
    for (const auto& x : nodes) out << x[0] << ' ' << x[1] << ' ' << x[2] << '\n';
    const std::size_t total = lines.size() + points.size();
    out << "$EndNodes\n$Elements\n"
        << points.size() + line_groups.size() << ' ' << total << " 1 " << total << '\n';
    int number = 0;
    for (std::size_t g = 0; g < line_groups.size(); ++g) {
      std::ostringstream block;
      int count = 0;
      for (std::size_t l = 0; l < lines.size(); ++l)
        if (lines[l].group == static_cast<int>(g)) {
          block << l + 1 << ' ' << lines[l].a + 1 << ' ' << lines[l].b + 1 << '\n';
          ++count;
        }
      out << "1 " << g + 1 << " 1 " << count << '\n' << block.str();
      number += count;
    }
    for (std::size_t p = 0; p < points.size(); ++p)
      out << "0 " << p + 1 << " 15 1\n" << ++number << ' ' << points[p].node + 1 << '\n';
    out << "$EndElements\n";
    return out.str();
  }
};
