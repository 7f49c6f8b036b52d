// A vector of three numbers for code that runs in vector lanes: the compiler takes it apart into
// scalars, which it cannot do with Eigen's vectors. The number is a double in loops that the
// compiler runs in vectors, a bundle of lanes (bodies/wide.h), or four lanes (lanes/quads.h). World
// frame unless said otherwise.
#pragma once

#include "dem/vector.h"

#include <cmath>

namespace interlock::dem
{
#define INTERLOCK_LANE [[gnu::always_inline]] inline

// What formulas for any number of lanes need besides arithmetic; wide.h has the same for bundles.
INTERLOCK_LANE double select(bool condition, double yes, double no)
{
  return condition ? yes : no;
}
INTERLOCK_LANE double larger(double a, double b)
{
  return a > b ? a : b;
}
INTERLOCK_LANE double smaller(double a, double b)
{
  return a < b ? a : b;
}
INTERLOCK_LANE double square_root(double a)
{
  return std::sqrt(a);
}

template <class Number> struct LaneVector {
  Number x, y, z;
};
using Lane3 = LaneVector<double>;

// Keeps a parameter out of template deduction, so that plain numbers convert.
template <class Number> struct Same {
  using type = Number;
};
template <class Number> using SameAs = typename Same<Number>::type;

template <class Number>
INTERLOCK_LANE LaneVector<Number> operator+(LaneVector<Number> a, LaneVector<Number> b)
{
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class Number>
INTERLOCK_LANE LaneVector<Number> operator-(LaneVector<Number> a, LaneVector<Number> b)
{
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class Number>
INTERLOCK_LANE LaneVector<Number> operator*(SameAs<Number> s, LaneVector<Number> a)
{
  return {s * a.x, s * a.y, s * a.z};
}
template <class Number> INTERLOCK_LANE Number dot(LaneVector<Number> a, LaneVector<Number> b)
{
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class Number>
INTERLOCK_LANE LaneVector<Number> cross(LaneVector<Number> a, LaneVector<Number> b)
{
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class Number>
INTERLOCK_LANE LaneVector<Number> componentwise(LaneVector<Number> a, LaneVector<Number> b)
{
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}
template <class Condition, class Number>
INTERLOCK_LANE LaneVector<Number> select(Condition condition, LaneVector<Number> yes,
                                         LaneVector<Number> no)
{
  return {select(condition, yes.x, no.x), select(condition, yes.y, no.y),
          select(condition, yes.z, no.z)};
}

// Unit quaternion, body to world.
template <class Number> struct LaneQuaternionOf {
  Number x, y, z, w;
};
using LaneQuaternion = LaneQuaternionOf<double>;

template <class Number>
INTERLOCK_LANE LaneQuaternionOf<Number> operator*(LaneQuaternionOf<Number> a,
                                                  LaneQuaternionOf<Number> b)
{
  return {
      a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y + a.y * b.w + a.z * b.x - a.x * b.z,
      a.w * b.z + a.z * b.w + a.x * b.y - a.y * b.x, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
}
template <class Number>
INTERLOCK_LANE LaneQuaternionOf<Number> conjugate(LaneQuaternionOf<Number> q)
{
  return {-q.x, -q.y, -q.z, q.w};
}
template <class Condition, class Number>
INTERLOCK_LANE LaneQuaternionOf<Number> select(Condition condition, LaneQuaternionOf<Number> yes,
                                               LaneQuaternionOf<Number> no)
{
  return {select(condition, yes.x, no.x), select(condition, yes.y, no.y),
          select(condition, yes.z, no.z), select(condition, yes.w, no.w)};
}
template <class Number>
INTERLOCK_LANE LaneVector<Number> rotate(LaneQuaternionOf<Number> q, LaneVector<Number> a)
{
  const LaneVector<Number> u{q.x, q.y, q.z}, half = cross(u, a), t = half + half;
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
