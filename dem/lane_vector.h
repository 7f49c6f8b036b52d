// A vector of three plain numbers for code that runs in vector lanes: the compiler takes it apart
// into scalars, which it cannot do with Eigen's vectors. World frame unless said otherwise.
#pragma once

#include "dem/vector.h"

namespace interlock::dem
{
struct Lane3 {
  double x, y, z;
};

#define INTERLOCK_LANE [[gnu::always_inline]] inline

INTERLOCK_LANE Lane3 operator+(Lane3 a, Lane3 b)
{
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
INTERLOCK_LANE Lane3 operator-(Lane3 a, Lane3 b)
{
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
INTERLOCK_LANE Lane3 operator*(double s, Lane3 a)
{
  return {s * a.x, s * a.y, s * a.z};
}
INTERLOCK_LANE double dot(Lane3 a, Lane3 b)
{
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
INTERLOCK_LANE Lane3 cross(Lane3 a, Lane3 b)
{
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// Unit quaternion, body to world.
struct LaneQuaternion {
  double x, y, z, w;
};
INTERLOCK_LANE LaneQuaternion operator*(LaneQuaternion a, LaneQuaternion b)
{
  return {
      a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y + a.y * b.w + a.z * b.x - a.x * b.z,
      a.w * b.z + a.z * b.w + a.x * b.y - a.y * b.x, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
}
INTERLOCK_LANE LaneQuaternion conjugate(LaneQuaternion q)
{
  return {-q.x, -q.y, -q.z, q.w};
}
INTERLOCK_LANE Lane3 rotate(LaneQuaternion q, Lane3 a)
{
  const Lane3 u{q.x, q.y, q.z};
  const Lane3 t = 2 * cross(u, a);
  return a + q.w * t + cross(u, t);
}

INTERLOCK_LANE Lane3 lane(const Vector3& a)
{
  return {a[0], a[1], a[2]};
}
INTERLOCK_LANE Vector3 vector(Lane3 a)
{
  return {a.x, a.y, a.z};
}
} // namespace interlock::dem
