#include "dem/ribs/rib_list_watch.h"

#include "dem/bodies/field_rows.h"

#include <algorithm>
#include <cmath>

namespace interlock::dem
{
namespace
{
INTERLOCK_LANE double square(Lane3 a)
{
  return dot(a, a);
}

// Of a turn from one attitude to the other: the square of the sine of half its angle.
INTERLOCK_LANE double half_turn_squared(LaneQuaternion from, LaneQuaternion to)
{
  const LaneQuaternion turn = conjugate(from) * to;
  return turn.x * turn.x + turn.y * turn.y + turn.z * turn.z;
}

// Of numbers that are not negative. One maximum a lane: the compiler may not reorder a single one.
double largest(const ScalarField& field, const std::vector<EndRange>& ranges)
{
  double most[lane_width] = {}, rest = 0;
  const double* number = field.row(0);
  for (const EndRange& range : ranges) {
    int i = range.begin;
    for (; i + lane_width <= range.end; i += lane_width)
      for (int l = 0; l < lane_width; ++l)
        most[l] = number[i + l] > most[l] ? number[i + l] : most[l];
    for (; i < range.end; ++i) rest = std::max(rest, number[i]);
  }
  return std::max(rest, *std::max_element(most, most + lane_width));
}
} // namespace

void RibListWatch::begin(const Clumps& clumps, const RibSet& ribs, ScalarField room)
{
  x_ = clumps.position;
  q_ = clumps.orientation;
  rib_x_.resize(ribs.position.size());
  rib_q_.resize(ribs.rotation.size());
  for (const EndRange& there : ribs.present_ends()) {
    const auto copy = [&](const double* from, double* to) {
      std::copy(from + there.begin, from + there.end, to + there.begin);
    };
    for (int c = 0; c < 3; ++c) copy(ribs.position.row(c), rib_x_.row(c));
    for (int c = 0; c < 4; ++c) copy(ribs.rotation.row(c), rib_q_.row(c));
  }
  room_ = std::move(room);
  beyond_.resize(clumps.size());
  for (ScalarField* field : {&way_, &turn_, &speed_, &spin_}) field->resize(ribs.position.size());
}

// Of any point of a rib, past and to come: with an end of its centre line, and with the turn of the
// section there [m].
double RibListWatch::largest_way(const RibSet& ribs, double ahead)
{
  const Rows3<const double> x(ribs.position), x0(rib_x_), v(ribs.velocity), w(ribs.spin);
  const QuaternionRows<const double> q(ribs.rotation), q0(rib_q_);
  double* __restrict way = way_.row(0);
  double* __restrict turn = turn_.row(0);
  double* __restrict speed = speed_.row(0);
  double* __restrict spin = spin_.row(0);
  const std::vector<EndRange>& there = ribs.present_ends();
  for (const EndRange& range : there) {
    const std::int64_t end = range.end;
#pragma GCC ivdep
    for (std::int64_t e = range.begin; e < end; ++e) {
      way[e] = square(x.get(e) - x0.get(e));
      turn[e] = half_turn_squared(q0.get(e), q.get(e));
      speed[e] = square(v.get(e));
      spin[e] = square(w.get(e));
    }
  }
  const double reach = ribs.largest_half_girth(); // of a point of a section from the centre line
  return std::sqrt(largest(way_, there)) + ahead * std::sqrt(largest(speed_, there)) +
         reach * (2 * std::sqrt(largest(turn_, there)) + ahead * std::sqrt(largest(spin_, there)));
}

bool RibListWatch::holds(const Clumps& clumps, const RibSet& ribs, double ahead, double margin)
{
  if (x_.size() != clumps.size() || rib_x_.size() != ribs.position.size()) return false;
  const double by_ribs = largest_way(ribs, ahead) + margin;

  const Rows3<const double> x(clumps.position), x0(x_), v(clumps.velocity), w(clumps.spin);
  const QuaternionRows<const double> q(clumps.orientation), q0(q_);
  const double* __restrict room = room_.row(0);
  const double* __restrict member_reach = clumps.member_reach().row(0);
  double* __restrict beyond = beyond_.row(0);
  const int n = beyond_.padded_size();
#pragma GCC ivdep
  for (std::int64_t i = 0; i < n; ++i) {
    const double way = std::sqrt(square(x.get(i) - x0.get(i))) +
                       ahead * std::sqrt(square(v.get(i))) +
                       member_reach[i] * (2 * std::sqrt(half_turn_squared(q0.get(i), q.get(i))) +
                                          ahead * std::sqrt(square(w.get(i))));
    beyond[i] = way + by_ribs - room[i];
  }
  return std::none_of(beyond_.begin(), beyond_.end(), [](double b) { return b > 0; });
}
} // namespace interlock::dem
