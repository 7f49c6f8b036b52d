#include "fem/lattice/lattice_checks.h"

#include "fem/lattice/segment_distance.h"
#include "fem/ribs/number_text.h"

#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <vector>

namespace interlock::fem
{
namespace
{
namespace bg = boost::geometry;
using Corner = bg::model::point<double, 3, bg::cs::cartesian>;
using Box = bg::model::box<Corner>;
using Entry = std::pair<Box, int>;

// An element as a straight segment, with what the checks ask of it.
struct Segment {
  std::array<Eigen::Vector3d, 2> end;
  std::array<unsigned int, 2> place; // equal numbers where elements are joined
  Eigen::Vector3d along;             // unit
  Eigen::Matrix3d axes;
  RibSection shape;
  int line;
};

Segment segment_of(const Lattice& lattice, int e)
{
  const LatticeElement& element = lattice.element(e);
  Segment s;
  for (int v = 0; v < 2; ++v) {
    s.end[v] = lattice.reference_position(element.node[v]);
    s.place[v] = lattice.dof(element.node[v], 0);
  }
  s.axes = element.frame.toRotationMatrix();
  s.along = s.axes.col(0);
  s.shape = lattice.shape(e);
  s.line = element.line;
  return s;
}

// Half the size of a rib along a unit direction across it [m].
double half_size(const Segment& s, const Eigen::Vector3d& direction)
{
  return 0.5 * (std::abs(s.axes.col(1).dot(direction)) * s.shape.width +
                std::abs(s.axes.col(2).dot(direction)) * s.shape.thickness);
}

std::string names(const Segment& a, const Segment& b)
{
  if (a.line == b.line) return "Two elements of rib line " + std::to_string(a.line);
  return "Elements of rib lines " + std::to_string(std::min(a.line, b.line)) + " and " +
         std::to_string(std::max(a.line, b.line));
}

[[noreturn]] void throw_covering(const Segment& a, const Segment& b, const Eigen::Vector3d& place)
{
  throw std::invalid_argument(names(a, b) + " lie over each other near " + point_text(place) +
                              " m.");
}

// Elements with one common end, which must not leave it in the same direction.
void check_neighbours(const Segment& a, int end_a, const Segment& b, int end_b)
{
  const double sign = end_a == end_b ? 1 : -1;
  if (sign * a.along.dot(b.along) > 0 && a.along.cross(b.along).norm() < 1e-3)
    throw_covering(a, b, a.end[end_a]);
}

// Length over which parallel segments run side by side [m]; zero or negative when they do not.
double common_length(const Segment& a, const Segment& b)
{
  const double length = (a.end[1] - a.end[0]).norm();
  double low = a.along.dot(b.end[0] - a.end[0]), high = a.along.dot(b.end[1] - a.end[0]);
  if (low > high) std::swap(low, high);
  return std::min(high, length) - std::max(low, 0.);
}

void check_strangers(const Segment& a, const Segment& b, double tolerance)
{
  const bool parallel = a.along.cross(b.along).norm() < 0.02;
  const ClosestPoints closest = closest_points(a.end[0], a.end[1], b.end[0], b.end[1]);
  const double distance = closest.distance();
  if (distance < tolerance) {
    if (parallel) throw_covering(a, b, closest.first);
    throw std::invalid_argument(names(a, b) + " cross at " + point_text(closest.first) +
                                " m without a junction: both lines need a vertex there.");
  }
  if (!parallel || common_length(a, b) < tolerance) return;
  const Eigen::Vector3d across = (closest.second - closest.first) / distance;
  const double sizes = half_size(a, across) + half_size(b, across);
  if (distance < sizes)
    throw std::invalid_argument(names(a, b) + " run side by side at a distance of " +
                                number_text(distance) + " m near " + point_text(closest.first) +
                                " m but must be more than " + number_text(sizes) +
                                " m apart for their size, or they overlap.");
}

void check_pair(const Segment& a, const Segment& b, double tolerance)
{
  int common = 0, end_a = 0, end_b = 0;
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j)
      if (a.place[i] == b.place[j]) {
        ++common;
        end_a = i;
        end_b = j;
      }
  if (common == 2)
    throw_covering(a, b, 0.5 * (a.end[0] + a.end[1]));
  else if (common == 1)
    check_neighbours(a, end_a, b, end_b);
  else
    check_strangers(a, b, tolerance);
}

Box box_of(const Segment& s, double tolerance)
{
  const double margin = tolerance + 0.5 * std::hypot(s.shape.width, s.shape.thickness);
  const Eigen::Vector3d low = s.end[0].cwiseMin(s.end[1]).array() - margin;
  const Eigen::Vector3d high = s.end[0].cwiseMax(s.end[1]).array() + margin;
  return {Corner(low.x(), low.y(), low.z()), Corner(high.x(), high.y(), high.z())};
}
} // namespace

void check_connected(const Lattice& lattice)
{
  boost::disjoint_sets_with_storage<> sets(lattice.n_nodes());
  for (int e = 0; e < lattice.n_elements(); ++e)
    sets.union_set(lattice.element(e).node[0], lattice.element(e).node[1]);
  for (int s = 0; s < lattice.n_springs(); ++s)
    sets.union_set(lattice.spring(s).node[0], lattice.spring(s).node[1]);

  std::map<std::size_t, std::vector<int>> pieces;
  for (int i = 0; i < lattice.n_nodes(); ++i) pieces[sets.find_set(i)].push_back(i);
  if (pieces.size() == 1) return;
  std::string sentence = "The lattice falls into " + std::to_string(pieces.size()) +
                         " pieces that no junction connects";
  int listed = 0;
  for (const auto& [root, nodes] : pieces) {
    if (++listed > 3) break;
    sentence += std::string(listed == 1 ? ": " : ", ") + "one of " + std::to_string(nodes.size()) +
                " nodes at " + point_text(lattice.reference_position(nodes.front())) + " m";
  }
  if (pieces.size() > 3) sentence += " and " + std::to_string(pieces.size() - 3) + " more";
  throw std::invalid_argument(sentence + ".");
}

void check_overlaps(const Lattice& lattice)
{
  double shortest = lattice.element(0).length;
  std::vector<Segment> segments;
  for (int e = 0; e < lattice.n_elements(); ++e) {
    shortest = std::min(shortest, lattice.element(e).length);
    segments.push_back(segment_of(lattice, e));
  }
  const double tolerance = 1e-3 * shortest;
  std::vector<Entry> boxes;
  for (int e = 0; e < lattice.n_elements(); ++e)
    boxes.emplace_back(box_of(segments[e], tolerance), e);
  const bg::index::rtree<Entry, bg::index::quadratic<16>> tree(boxes);

  for (const auto& [box, e] : boxes) {
    std::vector<int> near;
    for (auto it = tree.qbegin(bg::index::intersects(box)); it != tree.qend(); ++it)
      if (it->second > e) near.push_back(it->second);
    std::sort(near.begin(), near.end()); // the same fault first whatever the tree looks like
    for (const int other : near) check_pair(segments[e], segments[other], tolerance);
  }
}

void check_sections(const Lattice& lattice)
{
  for (int e = 0; e < lattice.n_elements(); ++e) {
    try {
      given_section(lattice.section(e));
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument("Rib line " + std::to_string(lattice.element(e).line) +
                                  " has no valid section: " + error.what());
    }
  }
}

void check_lattice(const Lattice& lattice)
{
  check_sections(lattice);
  check_connected(lattice);
  check_overlaps(lattice);
}
} // namespace interlock::fem
