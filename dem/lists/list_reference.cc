#include "dem/lists/list_reference.h"

#include "dem/lane_vector.h"

namespace interlock::dem
{
namespace
{
// Of one clump since its reference: squares of the displacement and of the chord of the rotation at
// the farthest member centre.
struct Motion {
  Motion(const Clumps& clumps, const ListReference& reference)
      : x(clumps.position.row(0)), y(clumps.position.row(1)), z(clumps.position.row(2)),
        qx(clumps.orientation.row(0)), qy(clumps.orientation.row(1)), qz(clumps.orientation.row(2)),
        qw(clumps.orientation.row(3)), reach(clumps.member_reach().row(0)),
        x0(reference.position.row(0)), y0(reference.position.row(1)), z0(reference.position.row(2)),
        px(reference.orientation.row(0)), py(reference.orientation.row(1)),
        pz(reference.orientation.row(2)), pw(reference.orientation.row(3))
  {
  }
  const double *x, *y, *z, *qx, *qy, *qz, *qw, *reach, *x0, *y0, *z0, *px, *py, *pz, *pw;

  INTERLOCK_LANE double moved_square(int i) const
  {
    const Lane3 d{x[i] - x0[i], y[i] - y0[i], z[i] - z0[i]};
    return dot(d, d);
  }
  INTERLOCK_LANE double turned_square(int i) const
  {
    const LaneQuaternion turn = conjugate(LaneQuaternion{px[i], py[i], pz[i], pw[i]}) *
                                LaneQuaternion{qx[i], qy[i], qz[i], qw[i]};
    return 4 * reach[i] * reach[i] * (turn.x * turn.x + turn.y * turn.y + turn.z * turn.z);
  }
};
} // namespace

void ListReference::resize(int n)
{
  position.resize(n);
  orientation.resize(n);
  skin.resize(n);
}

void ListReference::take(const Clumps& clumps, int i, double new_skin)
{
  position[i] = clumps.position[i];
  orientation.set(i, clumps.orientation[i]);
  skin[i] = new_skin;
}

void ListReference::measure(const Clumps& clumps, ScalarField& used) const
{
  used.resize(clumps.size());
  const Motion motion(clumps, *this);
  double* u = used.row(0);
  const int n = used.padded_size();
#pragma GCC ivdep
  for (int i = 0; i < n; ++i)
    u[i] = std::sqrt(motion.moved_square(i)) + std::sqrt(motion.turned_square(i));
}

bool ListReference::holds(const Clumps& clumps)
{
  const Motion motion(clumps, *this);
  const double* s = skin.row(0);
  excess_.resize(position.size());
  double* excess = excess_.row(0);
  const int n = position.padded_size();
  // (a + b)^2 <= 2 a^2 + 2 b^2.
#pragma GCC ivdep
  for (int i = 0; i < n; ++i)
    excess[i] = 2 * (motion.moved_square(i) + motion.turned_square(i)) - s[i] * s[i];
  constexpr double rest = 1 - 0.93 * 0.93;
  double largest = -1, largest_of_most = -1;
#pragma omp simd reduction(max : largest, largest_of_most)
  for (int i = 0; i < n; ++i) {
    const double of_most = excess[i] + rest * s[i] * s[i];
    largest = largest > excess[i] ? largest : excess[i];
    largest_of_most = largest_of_most > of_most ? largest_of_most : of_most;
  }
  nearly_used_up_ = largest_of_most > 0;
  return largest <= 0;
}
} // namespace interlock::dem
