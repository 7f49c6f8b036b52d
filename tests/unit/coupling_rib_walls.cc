// Where ribs meet the box, and that a sheet can be laid against its walls. Fails when a sheet that
// was cut at the width of the box starts with a force, when a section reaches another way than its
// rectangle, or when the overlap jumps where a rib passes the edge of the slot.
#include "coupling/loop/rib_walls.h"

#include "coupling/pull_out/geogrid_sheet.h"
#include "coupling/pull_out/rib_contact.h"
#include "tests/geogrid_products.h"
#include "tests/laid_geogrid.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace interlock;
using namespace interlock::coupling;
using dem::Vector3;

namespace
{
constexpr double half_width = 2.5e-3, half_thickness = 1.25e-3, bottom = 0.04, top = 0.06;

RibBox box()
{
  RibBox box;
  box.length = 0.2, box.width = 0.1;
  box.slot_bottom = bottom, box.slot_top = top;
  return box;
}

// One flat rod in the middle plane of the slot, with its width in that plane.
dem::RibSet rod(const Vector3& from, const Vector3& to)
{
  dem::Rib rib;
  rib.half_width = half_width, rib.half_thickness = half_thickness;
  rib.x[0] = from, rib.x[1] = to;
  const Vector3 width_axis = Vector3::UnitZ().cross(to - from).normalized();
  rib.width_axis[0] = rib.width_axis[1] = width_axis;
  return dem::RibSet(std::vector<dem::Rib>{rib});
}

// Overlap of the first vertex, or the rod, when it is moved to where it begins at `from`.
double overlap(const dem::RibSet& laid, BoxSide side, const Vector3& from)
{
  const RibWallPoints points(box(), laid);
  dem::RibSet moved = laid;
  const Vector3 way = from - Vector3(laid.position[0]);
  for (int end : {0, 1}) moved.position[end] = Vector3(laid.position[end]) + way;
  return points.gap(moved, 0, side).overlap;
}

void expect_no_overlap(const GeogridParameters& geogrid, const BoxParameters& inside)
{
  PullOutParameters p;
  p.geogrid = geogrid, p.box = inside;
  p.contact.box_stiffness = 6e7;
  const RibTransfer laid = laid_geogrid(geogrid, front_of_geogrid(geogrid, inside), 0);
  const RibWalls walls(box_of_ribs(p), laid.ribs(), laid.dynamics());
  EXPECT_EQ(walls.largest_overlap(laid.ribs()), 0);
}
} // namespace

// Tails of transverse and diagonal ribs end at the side walls, to the last digit.
TEST(RibWalls, SheetAsWideAsTheBoxStartsWithoutAForce)
{
  BoxParameters inside;
  inside.length = 0.4, inside.width = 0.2, inside.height = 0.3, inside.slot_height = 0.02;
  GeogridParameters biaxial = test_products::of(test_products::biaxial(), 6, 3);
  biaxial.cut_width = inside.width;
  expect_no_overlap(biaxial, inside);
  GeogridParameters triaxial = test_products::of(test_products::triaxial(), 6, 4);
  triaxial.cut_width = inside.width;
  expect_no_overlap(triaxial, inside);
}

// Longitudinal ribs against the side walls, and a slot that is only just higher than the ribs.
TEST(RibWalls, SheetThatFillsTheBoxStartsWithoutAForce)
{
  BoxParameters inside;
  inside.length = 0.4, inside.width = 3 * 0.065 + 0.004, inside.height = 0.3;
  inside.slot_height = 0.0018;
  expect_no_overlap(test_products::of(test_products::biaxial(), 6, 3), inside);
}

TEST(RibWalls, SectionsReachWithTheirSidesAndNotThroughTheWall)
{
  const dem::RibSet along = rod({0.01, 0.05, 0.05}, {0.02, 0.05, 0.05});
  const double d = 1e-6;
  EXPECT_NEAR(overlap(along, BoxSide::floor, {0.01, 0.05, half_thickness - d}), d, 1e-15);
  EXPECT_NEAR(overlap(along, BoxSide::right, {0.01, half_width - d, 0.05}), d, 1e-15);
  EXPECT_NEAR(overlap(along, BoxSide::left, {0.01, 0.1 - half_width + d, 0.05}), d, 1e-15);
  const dem::RibSet across = rod({0.01, 0.05, 0.05}, {0.01, 0.06, 0.05});
  EXPECT_NEAR(overlap(across, BoxSide::back, {0.2 - half_width + d, 0.05, 0.05}), d, 1e-15);
  // The face at the end of the rod.
  EXPECT_NEAR(overlap(across, BoxSide::right, {0.01, -d, 0.05}), d, 1e-15);
  // Laid with less room than the section has.
  const dem::RibSet near = rod({0.01, 1e-3, 0.05}, {0.02, 1e-3, 0.05});
  EXPECT_EQ(overlap(near, BoxSide::right, {0.01, 1e-3, 0.05}), 0);
  EXPECT_NEAR(overlap(near, BoxSide::right, {0.01, 1e-3 - d, 0.05}), d, 1e-15);
  // They go on outside of the box.
  EXPECT_NEAR(overlap(along, BoxSide::floor, {-0.01, 0.05, half_thickness - d}), d, 1e-15);
}

// Down the face of the front wall, over the edge, and onto it: at the edge the overlap is that of
// the face on one side and that of a bar lying on it on the other; in between it never jumps.
TEST(RibWalls, TransverseRibsPassTheEdgeWithoutAJump)
{
  const dem::RibSet across = rod({0.05, 0.05, 0.05}, {0.05, 0.06, 0.05});
  const double d = 1e-6;
  for (const double z : {0.01, 0.03, bottom})
    EXPECT_NEAR(overlap(across, BoxSide::front_below, {half_width - d, 0.05, z}), d, 1e-15);
  EXPECT_NEAR(overlap(across, BoxSide::front_below, {0, 0.05, bottom + half_thickness - d}), d,
              1e-15);
  EXPECT_NEAR(overlap(across, BoxSide::front_above, {0, 0.05, top - half_thickness + d}), d, 1e-15);
  EXPECT_NEAR(overlap(across, BoxSide::front_above, {half_width - d, 0.05, top}), d, 1e-15);
  const double step = 1e-5;
  double last = overlap(across, BoxSide::front_below, {half_width, 0.05, bottom - 1e-3});
  for (double z = bottom - 1e-3; z < bottom + 2e-3; z += step)
    for (const double x : {half_width, half_width + step, half_width}) {
      const double now = overlap(across, BoxSide::front_below, {x, 0.05, z});
      EXPECT_LT(std::abs(now - last), 2.01 * step);
      last = now;
    }
}

// The line through the edge's nearest point is square to the rib; beyond its ends the vertex
// counts.
TEST(RibWalls, LongitudinalRibsLieOnTheEdge)
{
  const dem::RibSet along = rod({-0.01, 0.05, 0.05}, {0.01, 0.05, 0.05});
  const RibWallPoints points(box(), along);
  dem::RibSet tilted = along;
  const double slope = 0.1, lift = 1.2e-3;
  tilted.position[0] = Vector3(-0.01, 0.05, bottom + lift - 0.01 * slope);
  tilted.position[1] = Vector3(0.01, 0.05, bottom + lift + 0.01 * slope);
  const WallGap gap = points.gap(tilted, 0, BoxSide::edge_below);
  const double cosine = 1 / std::sqrt(1 + slope * slope);
  EXPECT_NEAR(gap.overlap, half_thickness - lift * cosine, 1e-15);
  EXPECT_NEAR((gap.n - cosine * Vector3(-slope, 0, 1)).norm(), 0, 1e-12);
  EXPECT_NEAR(gap.xi, 0.5 * (1 - slope * lift / 0.01 * cosine * cosine), 1e-12);
  const WallGap beyond =
      points.gap(rod({-0.02, 0.05, bottom}, {-1e-3, 0.05, bottom}), 0, BoxSide::edge_below);
  EXPECT_EQ(beyond.xi, 1);
  EXPECT_NEAR(beyond.overlap, half_thickness - 1e-3, 1e-15);
  EXPECT_FALSE(points.can_touch(0, BoxSide::front_below));
}
