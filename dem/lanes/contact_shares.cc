// How contacts of the same two bodies share one stiffness (docs/theory/engine.md).
//
// With overlaps d_c the shared contact is as deep as the smooth maximum
//     M = sum d_c^p / sum d_c^(p-1),
// which is d for any number of equal overlaps d, and nearly the deepest one otherwise. The
// potential k M^2/2 gives contact c the force k M g_c, g_c = dM/dd_c; the g_c of a pair sum to 1
// when overlaps are equal, and sum(g_c d_c) = M always.
//
// The contacts of a pair lie in any lanes, between any number of idle ones, and neither may change
// a digit. Idle contacts add exact zeros, the sums run in list order, and every product is rounded
// before it is added: this file is compiled without fused operations (dem/CMakeLists.txt), because
// the compiler uses them for some lanes and not for others.
#include "dem/lanes/contact_lanes.h"

namespace interlock::dem
{
namespace
{
// p: sharp enough for restitution and duration to agree within 3 % between 20 and 500 spheres; the
// sharper, the stiffer is rocking between contacts, about p stiffnesses.
constexpr double exponent = 40;

struct Powers {
  double low, high; // x^38, x^39
};
Powers powers(double x)
{
  const double x2 = x * x, x4 = x2 * x2, x8 = x4 * x4, x16 = x8 * x8, x32 = x16 * x16;
  const double low = x32 * x4 * x2;
  return {low, low * x};
}
} // namespace

void share_contacts(int begin, int end, ContactLanes& lanes)
{
  const auto overlap = [&](int k) { return lanes.block(k).shared_depth[k % lane_width]; };
  const auto same_bodies = [&](int k, int l) {
    return lanes.key(k).i == lanes.key(l).i && lanes.key(k).j == lanes.key(l).j;
  };
  for (int k = begin; k < end;) {
    int last = k;
    double deepest = 0;
    for (; last < end && same_bodies(last, k); ++last) deepest = std::max(deepest, overlap(last));
    double upper = 0, lower = 0; // sums of x^p and x^(p-1), x: overlap over the deepest one
    for (int c = k; c < last && deepest > 0; ++c) {
      const double x = std::max(0., overlap(c)) / deepest, high = powers(x).high;
      lower += high;
      upper += high * x;
    }
    for (; k < last; ++k) {
      double gradient = 1;
      if (overlap(k) > 0) {
        const double x = overlap(k) / deepest;
        const Powers power = powers(x);
        gradient = (exponent * power.high - upper / lower * (exponent - 1) * power.low) / lower;
      }
      lanes.block(k).gradient[k % lane_width] = gradient;
      lanes.block(k).shared_depth[k % lane_width] = lower > 0 ? deepest * upper / lower : 0;
    }
  }
}
} // namespace interlock::dem
