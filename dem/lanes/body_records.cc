#include "dem/lanes/body_records.h"

#include "dem/bodies/field_rows.h"

#include <algorithm>

namespace interlock::dem
{
namespace
{
INTERLOCK_LANE LaneVector<Quad> load(const Rows3<const double>& rows, int i)
{
  return {load_quad(rows.x + i), load_quad(rows.y + i), load_quad(rows.z + i)};
}

INTERLOCK_LANE void store(const Rows3<double>& rows, int i, LaneVector<Quad> a)
{
  store_quad(rows.x + i, a.x), store_quad(rows.y + i, a.y), store_quad(rows.z + i, a.z);
}

// The vectors of four bodies into their records.
INTERLOCK_LANE void put(BodyRecord* records, double (BodyRecord::*member)[4], LaneVector<Quad> a,
                        Quad fourth = Quad{})
{
  const auto quads = transposed(a.x, a.y, a.z, fourth);
  for (int k = 0; k < 4; ++k) store_quad(records[k].*member, quads[k]);
}
} // namespace

void BodyRecords::take(const Clumps& clumps)
{
  const int n = clumps.position.padded_size();
  records_.resize(n);
  const Rows3<const double> position(clumps.position), velocity(clumps.step_velocity),
      spin(clumps.step_spin);
  const QuaternionRows<const double> attitude(clumps.orientation);
  for (int i = 0; i < n; i += 4) {
    BodyRecord* to = &records_[i];
    const LaneVector<Quad> x = load(position, i), w = load(spin, i);
    put(to, &BodyRecord::position, x);
    put(to, &BodyRecord::attitude,
        {load_quad(attitude.x + i), load_quad(attitude.y + i), load_quad(attitude.z + i)},
        load_quad(attitude.w + i));
    put(to, &BodyRecord::velocity, load(velocity, i) - cross(w, x));
    put(to, &BodyRecord::spin, w);
  }
}

void BodySums::clear(int n)
{
  sums_.assign(padded(n), Sum());
  crushing_.assign(padded(n), 0.);
}

void BodySums::write(Clumps& clumps)
{
  const Rows3<const double> position(clumps.position);
  const Rows3<double> force(clumps.force), torque(clumps.torque);
  double* friction = clumps.lost.row(Clumps::to_friction);
  double* damping = clumps.lost.row(Clumps::to_damping);
  for (int i = 0; i < clumps.position.padded_size(); i += 4) {
    Sum* s = &sums_[i];
    Quad f[4], m[4];
    for (int k = 0; k < 4; ++k) {
      friction[i + k] += 0.5 * (s[k].first_force[3] - s[k].other_force[3]);
      damping[i + k] += 0.5 * (s[k].first_moment[3] - s[k].other_moment[3]);
      f[k] = s[k].first_force + s[k].other_force;
      m[k] = s[k].first_moment + s[k].other_moment;
      s[k].other_force = s[k].other_moment = Quad{};
    }
    const auto force_rows = transposed(f[0], f[1], f[2], f[3]),
               moment_rows = transposed(m[0], m[1], m[2], m[3]);
    const LaneVector<Quad> on_body{force_rows[0], force_rows[1], force_rows[2]},
        about_origin{moment_rows[0], moment_rows[1], moment_rows[2]},
        about_centre = about_origin - cross(load(position, i), on_body);
    store(force, i, on_body);
    store(torque, i, about_centre);
  }
  if (!crushes_) return;
  for (int i = 0; i < clumps.size(); ++i) clumps.lost_to_crushing[i] += crushing_[i];
  std::fill(crushing_.begin(), crushing_.end(), 0.);
  crushes_ = false;
}
} // namespace interlock::dem
