// Where the spheres of a block of lanes are and how their clumps move, out of the records of the
// clumps: four lanes at a time, since four quads become four lanes.
#pragma once

#include "dem/lanes/contact_lanes.h"

namespace interlock::dem
{
// Of one block, world frame.
struct alignas(64) LaneGeometry {
  LaneBlock::Row between[3];         // from the second centre to the first [m]
  LaneBlock::Row centre[3];          // of the first sphere [m]
  LaneBlock::Row velocity[3];        // difference of BodyRecord::velocity [m/s]
  LaneBlock::Row spin_difference[3]; // first less second [rad/s]
  LaneBlock::Row spin_sum[3];        // [rad/s]
};

using QuadVector = LaneVector<Quad>;

INTERLOCK_LANE QuadVector load_rows(const LaneBlock::Row (&rows)[3], int l)
{
  return {load_quad(rows[0] + l), load_quad(rows[1] + l), load_quad(rows[2] + l)};
}
INTERLOCK_LANE void store_rows(LaneBlock::Row (&rows)[3], int l, QuadVector a)
{
  store_quad(rows[0] + l, a.x), store_quad(rows[1] + l, a.y), store_quad(rows[2] + l, a.z);
}

// Four numbers at the same place of four records.
struct FourQuads {
  Quad a, b, c, d;
  INTERLOCK_LANE FourQuads(const BodyRecords& bodies, const std::int32_t* i,
                           const double (BodyRecord::*member)[4])
      : a(load_quad(bodies[i[0]].*member)), b(load_quad(bodies[i[1]].*member)),
        c(load_quad(bodies[i[2]].*member)), d(load_quad(bodies[i[3]].*member))
  {
  }
  INTERLOCK_LANE FourQuads(Quad first, Quad second, Quad third, Quad fourth)
      : a(first), b(second), c(third), d(fourth)
  {
  }
  INTERLOCK_LANE friend FourQuads operator-(const FourQuads& p, const FourQuads& q)
  {
    return {p.a - q.a, p.b - q.b, p.c - q.c, p.d - q.d};
  }
  INTERLOCK_LANE friend FourQuads operator+(const FourQuads& p, const FourQuads& q)
  {
    return {p.a + q.a, p.b + q.b, p.c + q.c, p.d + q.d};
  }
  INTERLOCK_LANE QuadVector vector() const
  {
    const auto rows = transposed(a, b, c, d);
    return {rows[0], rows[1], rows[2]};
  }
  INTERLOCK_LANE LaneQuaternionOf<Quad> quaternion() const
  {
    const auto rows = transposed(a, b, c, d);
    return {rows[0], rows[1], rows[2], rows[3]};
  }
};

// All lanes of a block of pairs. Differences are taken before the transposition, which then serves
// both clumps.
INTERLOCK_LANE void place_pairs(const BodyRecords& bodies, const LaneBlock& block,
                                LaneGeometry& out)
{
  for (int l = 0; l < lane_width; l += 4) {
    const std::int32_t *i = block.i + l, *j = block.j + l;
    {
      const FourQuads first(bodies, i, &BodyRecord::spin), second(bodies, j, &BodyRecord::spin);
      store_rows(out.spin_difference, l, (first - second).vector());
      store_rows(out.spin_sum, l, (first + second).vector());
    }
    {
      const FourQuads first(bodies, i, &BodyRecord::velocity),
          second(bodies, j, &BodyRecord::velocity);
      store_rows(out.velocity, l, (first - second).vector());
    }
    const QuadVector arm1 = rotate(FourQuads(bodies, i, &BodyRecord::attitude).quaternion(),
                                   load_rows(block.centre1, l));
    const QuadVector arm2 = rotate(FourQuads(bodies, j, &BodyRecord::attitude).quaternion(),
                                   load_rows(block.centre2, l));
    const FourQuads first(bodies, i, &BodyRecord::position),
        second(bodies, j, &BodyRecord::position);
    store_rows(out.between, l, (first - second).vector() + (arm1 - arm2));
    store_rows(out.centre, l, first.vector() + arm1);
  }
}

// A wall's rectangle, worked out once for all its lanes.
struct WallPlane {
  explicit WallPlane(const Wall& wall)
      : corner(same(wall.corner)), e1(same(wall.edge1)), e2(same(wall.edge2)),
        velocity(same(wall.velocity)), s1(same(1 / wall.edge1.squaredNorm())),
        s2(same(1 / wall.edge2.squaredNorm()))
  {
  }
  QuadVector corner, e1, e2, velocity;
  Quad s1, s2;

private:
  static Quad same(double a) { return Quad{a, a, a, a}; }
  static QuadVector same(const Vector3& a) { return {same(a[0]), same(a[1]), same(a[2])}; }
};

INTERLOCK_LANE Quad between_0_and_1(Quad a)
{
  const Quad zero{}, one = {1, 1, 1, 1};
  a = a > zero ? a : zero;
  return a < one ? a : one;
}

// The same at a wall, whose nearest point takes the place of the second centre.
INTERLOCK_LANE void place_at_wall(const BodyRecords& bodies, const WallPlane& wall,
                                  const LaneBlock& block, LaneGeometry& out)
{
  for (int l = 0; l < lane_width; l += 4) {
    const std::int32_t* i = block.i + l;
    const QuadVector spin = FourQuads(bodies, i, &BodyRecord::spin).vector();
    store_rows(out.spin_difference, l, spin);
    store_rows(out.spin_sum, l, spin);
    store_rows(out.velocity, l,
               FourQuads(bodies, i, &BodyRecord::velocity).vector() - wall.velocity);
    const QuadVector position = FourQuads(bodies, i, &BodyRecord::position).vector();
    const QuadVector arm = rotate(FourQuads(bodies, i, &BodyRecord::attitude).quaternion(),
                                  load_rows(block.centre1, l));
    const QuadVector from_corner = (position - wall.corner) + arm;
    const Quad s = between_0_and_1(wall.s1 * dot(from_corner, wall.e1)),
               t = between_0_and_1(wall.s2 * dot(from_corner, wall.e2));
    store_rows(out.between, l, from_corner - s * wall.e1 - t * wall.e2);
    store_rows(out.centre, l, position + arm);
  }
}
} // namespace interlock::dem
