// Tables 1 to 3 of Ferellec and McDowell (2010): number of spheres in a regular octahedron against
// d_min, r_min and p_max. The paper gives neither the size of the octahedron nor its mesh; an edge
// of 40 mm with 3602 nodes (each face cut into 30^2 triangles, nodes moved by up to 10 % of their
// spacing) fits all three tables best, so exact counts cannot be expected: the bounds are 25 % a
// cell, 10 % where p_max limits. Mean of six meshes and node orders. Fails when the order of the
// tests (d_min, grow, r_min), what p_max counts, the sign of a distance or the meaning of the
// largest ball is changed.
#include "dem/clump_generator.h"
#include "tests/dem_solids.h"

#include <gtest/gtest.h>

namespace
{
using namespace interlock::dem;

struct Cell {
  double d_min, r_min, p_max; // mm, mm, %
  double spheres;             // published
};

double mean_count(const Cell& cell)
{
  double sum = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    RandomStream generator(seed);
    const TriangleMesh mesh = solids::subdivide(solids::octahedron(0.040), 30, 0.1, &generator);
    EXPECT_EQ(mesh.vertices.size(), 3602u);
    ClumpParameters parameters;
    parameters.d_min = 1e-3 * cell.d_min;
    parameters.r_min = 1e-3 * cell.r_min;
    parameters.p_max = cell.p_max;
    parameters.touching_radius = TouchingRadius::nodes; // the paper's
    parameters.seed = seed;
    sum += make_clump(mesh, parameters).spheres.size() / 6.;
  }
  return sum;
}

void compare(const std::vector<Cell>& cells, double tolerance)
{
  for (const Cell& cell : cells) {
    const double count = mean_count(cell);
    std::printf("d_min %3.1f mm, r_min %1.0f mm, p_max %3.0f %%: %6.1f spheres, published %4.0f "
                "(%+.1f %%)\n",
                cell.d_min, cell.r_min, cell.p_max, count, cell.spheres,
                100 * (count / cell.spheres - 1));
    EXPECT_NEAR(count / cell.spheres, 1, tolerance)
        << "d_min " << cell.d_min << ", r_min " << cell.r_min << ", p_max " << cell.p_max;
  }
}

TEST(OctahedronTables, NearestDistance)
{
  compare({{0, 2, 100, 2312},
           {0.1, 2, 100, 952},
           {0.2, 2, 100, 546},
           {0.3, 2, 100, 332},
           {0.5, 2, 100, 188},
           {1, 2, 100, 87}},
          0.25);
}

TEST(OctahedronTables, SmallestRadius)
{
  compare({{0.1, 0, 100, 1439},
           {0.1, 4, 100, 702},
           {0.1, 5, 100, 485},
           {0.1, 7, 100, 264},
           {0.1, 9, 100, 125}},
          0.25);
}

TEST(OctahedronTables, ShareOfNodesUsed)
{
  compare(
      {{0.1, 2, 3, 73}, {0.1, 2, 5, 123}, {0.1, 2, 10, 239}, {0.1, 2, 20, 460}, {0.1, 2, 30, 668}},
      0.10);
}

// A ball of radius r leaves nodes nearer than d_min within a cap of radius sqrt(2 r d_min) around
// the point where it touches, so the count goes as 1/d_min between the limits of the node spacing
// and of few caps.
TEST(OctahedronTables, CountIsInverseToDistance)
{
  for (const double d_min : {0.1, 0.2, 0.3, 0.5}) {
    const double product = d_min * mean_count({d_min, 2, 100, 0});
    EXPECT_GT(product, 85) << d_min;
    EXPECT_LT(product, 110) << d_min;
  }
}
} // namespace
