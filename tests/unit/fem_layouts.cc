// Triaxial and uniaxial layouts and thick junction zones against counting and measuring by hand.
// Fails when ribs are lost, doubled or outside the rectangle, when junctions are not joined, or
// when a family has the wrong section or direction.
#include "fem/lattice/lattice_checks.h"
#include "fem/layouts/junction_zones.h"
#include "fem/layouts/triaxial_layout.h"
#include "fem/layouts/uniaxial_layout.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numeric>
#include <set>

namespace
{
using namespace interlock::fem;
using Eigen::Vector3d;

RibSection rectangle(double width, double thickness)
{
  return {width, thickness, 2.4e9, 0.4, 910};
}

TriaxialLayout triangles(double length, double width, int elements)
{
  TriaxialLayout layout;
  layout.length = length;
  layout.width = width;
  layout.side = 0.046;
  layout.elements_per_rib = elements;
  layout.section_across = rectangle(1.3e-3, 1.5e-3);
  layout.section_rising = rectangle(1.1e-3, 1.8e-3);
  layout.section_falling = rectangle(1.2e-3, 1.7e-3);
  layout.origin = {0.1, 0.2, 0.3};
  return layout;
}

// Rows of 4 and 3 junctions in turn, five rows: 18 junctions, 13 transverse and 24 diagonal ribs,
// which enclose 20 triangles (Euler: 18 - 37 + 20 = 1).
TEST(TriaxialLayout, CountsAndMass)
{
  const int n = 3;
  const double height = 0.046 * std::sqrt(3.) / 2;
  const Lattice lattice(rib_lines(triangles(4.9 * height, 3.9 * 0.046, n)));
  EXPECT_EQ(lattice.n_elements(), 37 * n);
  EXPECT_EQ(lattice.n_nodes(), 18 + 37 * (n - 1));
  const double mass =
      910 * 0.046 * (13 * 1.3e-3 * 1.5e-3 + 12 * 1.1e-3 * 1.8e-3 + 12 * 1.2e-3 * 1.7e-3);
  EXPECT_NEAR(lattice.mass(), mass, 1e-12 * mass);
  EXPECT_NO_THROW(check_lattice(lattice));
  // A rectangle of exactly four heights and three sides holds as much.
  EXPECT_EQ(Lattice(rib_lines(triangles(4 * height, 3 * 0.046, n))).n_elements(), 37 * n);
}

TEST(TriaxialLayout, LiesInTheRectangleWithTheFrontRibAtTheOrigin)
{
  const double length = 0.2, width = 0.21;
  const Lattice lattice(rib_lines(triangles(length, width, 2)));
  for (int i = 0; i < lattice.n_nodes(); ++i) {
    const Vector3d x = lattice.reference_position(i) - Vector3d(0.1, 0.2, 0.3);
    EXPECT_TRUE(x.x() >= 0 && x.x() <= length && std::abs(x.y()) <= width / 2) << x.transpose();
    EXPECT_EQ(x.z(), 0);
  }
  // Four ribs of two elements along the front, in the middle of the width.
  const std::vector<int> front = lattice.front_edge_nodes();
  EXPECT_EQ(front.size(), 9u);
  double sum = 0;
  for (const int node : front) sum += lattice.reference_position(node).y();
  EXPECT_NEAR(sum / 9, 0.2, 1e-15);
}

TEST(TriaxialLayout, DirectionsAndSectionsOfTheFamilies)
{
  const Lattice lattice(rib_lines(triangles(0.2, 0.21, 1)));
  std::map<int, int> elements_at;
  for (int e = 0; e < lattice.n_elements(); ++e) {
    const LatticeElement& element = lattice.element(e);
    EXPECT_NEAR(element.length, 0.046, 1e-16);
    const Vector3d along = element.frame * Vector3d::UnitX();
    const double degrees = std::atan2(along.y(), along.x()) * 180 / M_PI;
    const double width = lattice.shape(e).width;
    EXPECT_NEAR(degrees, width == 1.3e-3 ? 90 : width == 1.1e-3 ? 30 : -30, 1e-10);
    for (const int node : element.node) ++elements_at[node];
  }
  int inner = 0;
  for (const auto& [node, count] : elements_at) {
    EXPECT_LE(count, 6);
    inner += count == 6;
  }
  // Rows of 5, 4, 5, 4, 5, 4 junctions, or one row less; all but the rim have six ribs.
  EXPECT_EQ(lattice.n_nodes(), 27);
  EXPECT_EQ(inner, 2 + 3 + 2 + 3);
}

// TX160: 80 mm between alternate parallel ribs.
TEST(TriaxialLayout, HexagonPitchIsTwoHeights)
{
  const double side = side_of_hexagon_pitch(0.080);
  EXPECT_NEAR(side, 0.0462, 5e-5);
  EXPECT_NEAR(2 * side * std::sin(M_PI / 3), 0.080, 1e-15);
}

TEST(UniaxialLayout, CountsSectionsAndJunctions)
{
  UniaxialLayout layout;
  layout.apertures_along = 2;
  layout.apertures_across = 5;
  layout.bar_pitch = 0.235;
  layout.rib_pitch = 0.022;
  layout.elements_per_rib = 7;
  layout.elements_per_bar = 2;
  layout.rib = rectangle(6e-3, 1e-3);
  layout.bar = rectangle(16e-3, 3e-3);
  layout.origin = {1, 2, 3};
  const Lattice lattice(rib_lines(layout));
  const int ribs = 6 * 2, pieces = 3 * 5;
  EXPECT_EQ(lattice.n_elements(), 7 * ribs + 2 * pieces);
  EXPECT_EQ(lattice.n_nodes(), 18 + 6 * ribs + pieces);
  const double mass = 910 * (6 * 0.47 * 6e-6 + 3 * 0.11 * 48e-6);
  EXPECT_NEAR(lattice.mass(), mass, 1e-12 * mass);
  EXPECT_EQ(lattice.front_edge_nodes().size(), 11u);
  EXPECT_NO_THROW(check_lattice(lattice));
  for (int e = 0; e < lattice.n_elements(); ++e) {
    const bool along = std::abs((lattice.element(e).frame * Vector3d::UnitX()).x()) > 0.5;
    EXPECT_EQ(lattice.shape(e).width, along ? 6e-3 : 16e-3);
  }
}

// Two ribs that cross at their middles: four arms of 30 mm with 5 mm each in the zone.
TEST(JunctionZones, ThickenTheReachAndNothingElse)
{
  std::vector<RibLine> lines;
  for (int i = 0; i < 2; ++i) {
    const Vector3d half = 0.03 * Vector3d::Unit(i);
    lines.push_back(straight_line(-half, half, 4, beam_section(rectangle(3e-3, 2e-3))));
    lines.back().shape = rectangle(3e-3, 2e-3);
  }
  const Lattice lattice(thicken_junctions(lines, {5e-3, 4e-3}));
  EXPECT_EQ(lattice.n_lines(), 2);
  EXPECT_EQ(lattice.n_elements(), 2 * 6);
  EXPECT_EQ(lattice.n_nodes(), 2 * 7 - 1);
  double thick = 0, thin = 0;
  const BeamSection inside = beam_section(rectangle(3e-3, 4e-3)), outside = lines[0].section;
  for (int e = 0; e < lattice.n_elements(); ++e) {
    const bool is_thick = lattice.shape(e).thickness == 4e-3;
    (is_thick ? thick : thin) += lattice.element(e).length;
    const BeamSection &is = lattice.section(e), &must = is_thick ? inside : outside;
    EXPECT_NEAR(is.axial, must.axial, 1e-12 * must.axial);
    EXPECT_NEAR(is.torsion, must.torsion, 1e-12 * must.torsion);
    EXPECT_NEAR(is.bending_2, must.bending_2, 1e-12 * must.bending_2);
    EXPECT_NEAR(is.bending_3, must.bending_3, 1e-12 * must.bending_3);
    EXPECT_NEAR(is.line_density, must.line_density, 1e-12 * must.line_density);
  }
  EXPECT_NEAR(thick, 4 * 5e-3, 1e-15);
  EXPECT_NEAR(thin, 4 * 25e-3, 1e-15);
}

// A stiffness given directly is thickened by the ratio of the shapes: t, t, t^3.
TEST(JunctionZones, ScaleGivenSections)
{
  BeamSection given = beam_section(rectangle(3e-3, 2e-3));
  given.axial *= 0.7;
  std::vector<RibLine> lines = {straight_line({0, 0, 0}, {0.05, 0, 0}, 1, given),
                                straight_line({0, -0.01, 0}, {0, 0.01, 0}, 2, given)};
  for (RibLine& line : lines) line.shape = rectangle(3e-3, 2e-3);
  const std::vector<RibLine> thick = thicken_junctions(lines, {0.01, 3e-3});
  ASSERT_EQ(thick[0].profiles.size(), 2u);
  EXPECT_NEAR(thick[0].profiles[0].section.axial, 1.5 * given.axial, 1e-9);
  EXPECT_NEAR(thick[0].profiles[0].section.bending_2 / given.bending_2, std::pow(1.5, 3), 1e-12);
  EXPECT_NEAR(thick[0].profiles[0].section.bending_3 / given.bending_3, 1.5, 1e-12);
  EXPECT_EQ(thick[0].profiles[1].section.axial, given.axial);
}

TEST(JunctionZones, RoundRibsGrowInBothDirections)
{
  const RibSection bar = round_section(3e-3, 2.4e9, 0.4, 910);
  std::vector<RibLine> lines = {straight_line({0, 0, 0}, {0.05, 0, 0}, 1, beam_section(bar)),
                                straight_line({0, -0.01, 0}, {0, 0.01, 0}, 2, beam_section(bar))};
  for (RibLine& line : lines) line.shape = bar;
  const RibProfile zone = thicken_junctions(lines, {0.01, 6e-3})[0].profiles[0];
  EXPECT_EQ(zone.shape.width, 6e-3);
  EXPECT_NEAR(zone.section.axial, 4 * beam_section(bar).axial, 1e-9);
}
} // namespace
