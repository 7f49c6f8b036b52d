// Tables 1 to 3 of Ferellec and McDowell (2010): number of spheres in a regular octahedron against
// d_min, r_min and p_max. Size and mesh of the paper's octahedron are unknown, so exact counts
// cannot be expected: the bounds are 25 % a cell, 10 % where p_max limits. Mean of six meshes and
// node orders. Fails when the order of the tests (d_min, grow, r_min), what p_max counts, the sign
// of a distance or the meaning of the largest ball is changed.
#include "dem/generator/octahedron_tables.h"
#include "dem/meshes/mass_properties.h"

#include <gtest/gtest.h>

namespace
{
using namespace interlock::dem;

TEST(OctahedronTables, MeshIsTheOctahedron)
{
  const TriangleMesh mesh = irregular_octahedron(1);
  EXPECT_EQ(mesh.vertices.size(), 3602u);
  EXPECT_EQ(count_open_edges(mesh), 0);
  const double exact = std::sqrt(2.) / 3 * std::pow(octahedron_edge, 3);
  EXPECT_NEAR(mass_properties(mesh).volume, exact, 1e-12 * exact);
}

TEST(OctahedronTables, CountsAndTrends)
{
  for (const OctahedronTable& table : published_octahedron_tables()) {
    std::vector<double> counts;
    for (const OctahedronCell& cell : table.cells) {
      counts.push_back(mean_sphere_count(cell));
      const double tolerance = cell.p_max < 100 ? 0.10 : 0.25;
      EXPECT_NEAR(counts.back() / cell.published, 1, tolerance)
          << table.title << ": d_min " << cell.d_min << ", r_min " << cell.r_min << ", p_max "
          << cell.p_max;
    }
    const bool falling = table.cells.front().published > table.cells.back().published;
    for (std::size_t i = 1; i < counts.size(); ++i)
      EXPECT_EQ(counts[i] < counts[i - 1], falling) << table.title << ", cell " << i;
  }
}

// A ball of radius r leaves nodes nearer than d_min within a cap of radius sqrt(2 r d_min) around
// the point where it touches, so the count goes as 1/d_min between the limits of the node spacing
// and of few caps.
TEST(OctahedronTables, CountIsInverseToDistance)
{
  for (const double d_min : {0.1, 0.2, 0.3, 0.5}) {
    const double product = d_min * mean_sphere_count({d_min, 2, 100, 0});
    EXPECT_GT(product, 85) << d_min;
    EXPECT_LT(product, 110) << d_min;
  }
}
} // namespace
