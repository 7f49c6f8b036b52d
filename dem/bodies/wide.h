// Wide::lanes lanes as one number: two registers side by side, so that the processor finds one whose
// operands are ready; more of them would not fit (docs/performance.md). Formulas written for any number type
// (lane_vector.h, contacts/contact_law.h) run with it; every lane is rounded as every other one.
#pragma once

#include "dem/bodies/component_arrays.h"
#include "dem/lane_vector.h"

#include <experimental/simd>

namespace interlock::dem
{
using Register = std::experimental::native_simd<double>;

class Wide
{
public:
  static constexpr int registers = 2, lanes = registers * static_cast<int>(Register::size());
  static_assert(lane_width % lanes == 0);

  struct Mask {
    Register::mask_type part[registers];
  };

  Wide() = default;
  INTERLOCK_LANE Wide(double same)
  {
    for (Register& p : part) p = same;
  }

  INTERLOCK_LANE static Wide load(const double* numbers)
  {
    Wide w;
    for (int r = 0; r < registers; ++r)
      w.part[r].copy_from(numbers + r * Register::size(), std::experimental::element_aligned);
    return w;
  }
  INTERLOCK_LANE void store(double* numbers) const
  {
    for (int r = 0; r < registers; ++r)
      part[r].copy_to(numbers + r * Register::size(), std::experimental::element_aligned);
  }

  INTERLOCK_LANE friend Wide operator+(Wide a, Wide b)
  {
    for (int r = 0; r < registers; ++r) a.part[r] = a.part[r] + b.part[r];
    return a;
  }
  INTERLOCK_LANE friend Wide operator-(Wide a, Wide b)
  {
    for (int r = 0; r < registers; ++r) a.part[r] = a.part[r] - b.part[r];
    return a;
  }
  INTERLOCK_LANE friend Wide operator*(Wide a, Wide b)
  {
    for (int r = 0; r < registers; ++r) a.part[r] = a.part[r] * b.part[r];
    return a;
  }
  INTERLOCK_LANE friend Wide operator/(Wide a, Wide b)
  {
    for (int r = 0; r < registers; ++r) a.part[r] = a.part[r] / b.part[r];
    return a;
  }
  INTERLOCK_LANE friend Wide operator-(Wide a)
  {
    for (Register& p : a.part) p = -p;
    return a;
  }
  INTERLOCK_LANE friend Mask operator>(Wide a, Wide b)
  {
    Mask m;
    for (int r = 0; r < registers; ++r) m.part[r] = a.part[r] > b.part[r];
    return m;
  }
  INTERLOCK_LANE friend Wide select(Mask condition, Wide yes, Wide no)
  {
    for (int r = 0; r < registers; ++r) where(condition.part[r], no.part[r]) = yes.part[r];
    return no;
  }
  INTERLOCK_LANE friend Wide larger(Wide a, Wide b)
  {
    for (int r = 0; r < registers; ++r) a.part[r] = max(a.part[r], b.part[r]);
    return a;
  }
  INTERLOCK_LANE friend Wide smaller(Wide a, Wide b)
  {
    for (int r = 0; r < registers; ++r) a.part[r] = min(a.part[r], b.part[r]);
    return a;
  }
  INTERLOCK_LANE friend Wide square_root(Wide a)
  {
    for (Register& p : a.part) p = sqrt(p);
    return a;
  }

private:
  Register part[registers];
};
} // namespace interlock::dem
