// Where ribs can touch the box: how near their vertices and centre lines are to its walls and to
// the edges of its slot. The geometry alone; docs/theory/geogrid.md has the formulas.
//
// Frame of the pull-out: x along the pull, the front wall at x = 0 and the inside of the box at
// x > 0; y across, from 0 to the width; z up from the floor.
#pragma once

#include "dem/contacts/contact_properties.h"
#include "dem/ribs/rib_set.h"

#include <array>
#include <vector>

namespace interlock::coupling
{
// The box as ribs meet it. SI units.
struct RibBox {
  double length = 0, width = 0;         // inside, along x and y [m]
  double slot_bottom = 0, slot_top = 0; // heights of the edges of the slot [m]
  dem::ContactProperties contact;       // of a rib with a wall; linear springs
};

// What a rib may touch. Vertices touch planes and the front wall below and above its slot; elements
// touch the edges of the slot.
enum class BoxSide { floor, right, left, back, front_below, front_above, edge_below, edge_above };
constexpr int n_box_sides = 8;

// One vertex or element against one side. The planes go on outside the box.
struct WallGap {
  double overlap; // negative: gap [m]
  dem::Vector3 n; // unit, from the wall to the rib
  double xi;      // where on the element that begins at the vertex; 0 where the vertex touches
};

class RibWallPoints
{
public:
  // `unloaded`: the ribs where the sheet is laid. Sections reach as far as they do there, and not
  // through a plane.
  RibWallPoints(const RibBox& box, const dem::RibSet& unloaded);

  // Whether the vertex, or the rib that begins there, can ever touch that side. A vertex is an end
  // of the RibSet; a rib follows its first end.
  bool can_touch(int vertex, BoxSide side) const;
  bool is_edge(BoxSide side) const { return side >= BoxSide::edge_below; }
  // Where the ribs are now. Only if it can touch.
  WallGap gap(const dem::RibSet& ribs, int vertex, BoxSide side) const;
  // The rib that begins at the vertex, -1 where its line ends.
  int rib_from(int vertex) const { return vertices_[static_cast<std::size_t>(vertex)].rib; }
  int n_vertices() const { return static_cast<int>(vertices_.size()); }

private:
  struct Vertex {
    int rib = -1;                            // that begins here
    bool along = false;                      // its line: within 45 degrees of x
    std::array<double, 4> reach{0, 0, 0, 0}; // towards the planes [m]
    double reach_x = 0, reach_z = 0;         // of the section [m]
    double half_thickness = 0;               // of the rib that begins here [m]
  };
  void add_rib(const dem::Rib& rib, int first_end, int number);
  double distance(const dem::Vector3& x, BoxSide plane) const; // from the inside of a plane [m]
  WallGap gap_at_front(const Vertex& vertex, const dem::Vector3& x, bool below) const;
  WallGap gap_at_edge(const Vertex& vertex, const dem::Vector3& a, const dem::Vector3& b,
                      double height) const;

  RibBox box_;
  std::vector<Vertex> vertices_;
};
} // namespace interlock::coupling
