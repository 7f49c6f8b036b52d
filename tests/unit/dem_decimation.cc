// Coarser surfaces. It takes one that is open, turned inside out, has nodes of its own, is coarser
// or finer than asked for, or misses a tenth of the stone's size or volume, to fail.
#include "dem/meshes/decimation.h"
#include "dem/meshes/mass_properties.h"
#include "dem/stones/synthetic_stone.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace interlock::dem;

TEST(Decimation, StonesStayClosedAndKeepTheirSize)
{
  for (const TriangleMesh& stone : make_stones(8, 3))
    for (const int triangles : {300, 80}) {
      const TriangleMesh coarse = decimated(stone, triangles);
      EXPECT_LE(coarse.triangles.size(), 1.3 * triangles);
      EXPECT_GT(coarse.triangles.size(), 0.9 * triangles);
      EXPECT_EQ(count_open_edges(coarse), 0);
      const double allowed = triangles == 300 ? 0.03 : 0.1;
      EXPECT_NEAR(mass_properties(coarse).volume / mass_properties(stone).volume, 1, allowed);
      EXPECT_LT((extents(coarse) - extents(stone)).norm(), allowed * extents(stone).norm());
      for (const Vector3& x : coarse.vertices)
        EXPECT_TRUE(std::find(stone.vertices.begin(), stone.vertices.end(), x) !=
                    stone.vertices.end());
    }
}

// Euler: a closed surface without holes through it has V - E + F = 2, and E = 3 F / 2.
TEST(Decimation, NoNodeIsLeftOver)
{
  const TriangleMesh coarse = decimated(make_stones(1, 1).front(), 200);
  EXPECT_EQ(2 * coarse.vertices.size(), coarse.triangles.size() + 4);
}

TEST(Decimation, WhatIsCoarseAlreadyStays)
{
  const TriangleMesh stone = make_stones(1, 1).front();
  const TriangleMesh same = decimated(stone, static_cast<int>(stone.triangles.size()));
  EXPECT_EQ(same.triangles, stone.triangles);
  EXPECT_EQ(same.vertices.size(), stone.vertices.size());
}
