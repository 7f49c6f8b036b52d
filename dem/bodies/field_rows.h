// The rows of fields as plain pointers, for loops that run in vector lanes: the compiler may take
// it that they do not overlap.
#pragma once

#include "dem/bodies/component_arrays.h"
#include "dem/lane_vector.h"

#include <cstdint>

namespace interlock::dem
{
template <class Number> struct Rows3 {
  template <class Field>
  explicit Rows3(Field& field) : x(field.row(0)), y(field.row(1)), z(field.row(2))
  {
  }
  INTERLOCK_LANE Lane3 get(std::int64_t k) const { return {x[k], y[k], z[k]}; }
  INTERLOCK_LANE void set(std::int64_t k, Lane3 a) const { x[k] = a.x, y[k] = a.y, z[k] = a.z; }
  INTERLOCK_LANE void add(std::int64_t k, Lane3 a) const { x[k] += a.x, y[k] += a.y, z[k] += a.z; }

  Number* __restrict x, * __restrict y, * __restrict z;
};

template <class Number> struct QuaternionRows {
  template <class Field>
  explicit QuaternionRows(Field& field)
      : x(field.row(0)), y(field.row(1)), z(field.row(2)), w(field.row(3))
  {
  }
  INTERLOCK_LANE LaneQuaternion get(std::int64_t k) const { return {x[k], y[k], z[k], w[k]}; }
  INTERLOCK_LANE void set(std::int64_t k, LaneQuaternion q) const
  {
    x[k] = q.x, y[k] = q.y, z[k] = q.z, w[k] = q.w;
  }

  Number* __restrict x, * __restrict y, * __restrict z, * __restrict w;
};
} // namespace interlock::dem
