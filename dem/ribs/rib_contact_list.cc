// The list of RibContacts: which spheres can touch which ribs until it expires.
#include "dem/ribs/rib_contacts.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace interlock::dem
{
namespace
{
// See select_near: steps of room for kicks, and a share of a rib's half thickness.
constexpr double near_steps = 2, near_margin = 0.01;

auto key(const RibContact& c)
{
  return std::tie(c.i, c.a, c.line);
}

double distance_to_segment(const Vector3& p, const Vector3& a, const Vector3& b)
{
  const Vector3 d = b - a;
  const double t = std::clamp(d.dot(p - a) / d.squaredNorm(), 0., 1.);
  return (p - a - t * d).norm();
}

double section_reach(const Rib& rib)
{
  return std::sqrt(rib.half_width * rib.half_width + rib.half_thickness * rib.half_thickness);
}

// A bound on the speed of any point of a clump or a rib [m/s]: translation and rotation apart, so
// that one root serves all.
double fastest_point(const Clumps& clumps, const std::vector<Rib>& ribs)
{
  double moving = 0, turning = 0;
  for (int i = 0; i < clumps.size(); ++i) {
    const double reach = clumps.member_reach(i);
    moving = std::max(moving, clumps.velocity[i].squaredNorm());
    turning = std::max(turning, reach * reach * clumps.spin[i].squaredNorm());
  }
  for (const Rib& rib : ribs) {
    const double reach = section_reach(rib);
    for (int end : {0, 1}) {
      moving = std::max(moving, rib.v[end].squaredNorm());
      turning = std::max(turning, reach * reach * rib.w[end].squaredNorm());
    }
  }
  return std::sqrt(moving) + std::sqrt(turning);
}

// A bound on the speed of any point of a rib [m/s].
double rib_speed(const Rib& rib)
{
  double moving = 0, turning = 0;
  for (int end : {0, 1}) {
    moving = std::max(moving, rib.v[end].squaredNorm());
    turning = std::max(turning, rib.w[end].squaredNorm());
  }
  return std::sqrt(moving) + section_reach(rib) * std::sqrt(turning);
}
} // namespace

void RibContacts::clear()
{
  contacts_.clear();
  near_clumps_.clear();
  near_ribs_.clear();
  near_contacts_.clear();
  wrenches_.clear();
  valid_ = false;
}

void RibContacts::renumber_clumps(const std::vector<int>& new_index)
{
  contacts_.erase(std::remove_if(contacts_.begin(), contacts_.end(),
                                 [&](const RibContact& c) { return new_index[c.i] < 0; }),
                  contacts_.end());
  for (RibContact& c : contacts_) c.i = new_index[c.i];
  invalidate();
}

void RibContacts::update_list(const Clumps& clumps, const std::vector<Rib>& ribs, double time_step)
{
  const double fastest = fastest_point(clumps, ribs);
  if (!list_holds(clumps, ribs, fastest, time_step)) {
    skin_ = std::clamp(2 * fastest * time_step * 40, 1e-4, 1e-3);
    build(clumps, ribs);
    valid_ = true;
  }
  select_near(clumps, ribs, time_step);
}

bool RibContacts::list_holds(const Clumps& clumps, const std::vector<Rib>& ribs, double fastest,
                             double time_step) const
{
  // Clumps or ribs may have come since the list was made.
  if (!valid_ || clump_x_.size() != clumps.size() || rib_x_.size() != 2 * ribs.size()) return false;
  double clump_moved = 0, clump_turned = 0, rib_moved = 0, rib_turned = 0;
  for (int i = 0; i < clumps.size(); ++i) {
    clump_moved = std::max(clump_moved, (clumps.position[i] - clump_x_[i]).squaredNorm());
    const double reach = clumps.member_reach(i);
    const Vector3 v = (clump_q_[i].conjugate() * clumps.orientation[i]).vec();
    clump_turned = std::max(clump_turned, reach * reach * v.squaredNorm());
  }
  double thickest = 0;
  for (std::size_t r = 0; r < ribs.size(); ++r) {
    const double reach = section_reach(ribs[r]);
    thickest = std::max(thickest, ribs[r].half_thickness);
    for (int end : {0, 1}) {
      rib_moved = std::max(rib_moved, (ribs[r].x[end] - rib_x_[2 * r + end]).squaredNorm());
      const Vector3 turn = ribs[r].width_axis[end] - rib_axis_[2 * r + end];
      rib_turned = std::max(rib_turned, reach * reach * turn.squaredNorm());
    }
  }
  const double used = std::sqrt(clump_moved) + 2 * std::sqrt(clump_turned) + std::sqrt(rib_moved) +
                      2 * std::sqrt(rib_turned);
  // Whoever select_near may choose is in the list: a clump and a rib are each as fast as the
  // fastest point at most.
  return used + near_steps * 2 * fastest * time_step + near_margin * thickest <= skin_;
}

void RibContacts::select_near(const Clumps& clumps, const std::vector<Rib>& ribs, double time_step)
{
  near_clumps_.clear();
  near_contacts_.clear();
  rib_speed_.clear();
  for (const Rib& rib : ribs) rib_speed_.push_back(rib_speed(rib));
  rib_is_near_.assign(ribs.size(), 0);
  const int n = static_cast<int>(contacts_.size());
  for (int first = 0, last = 0; first < n; first = last) {
    const int i = contacts_[first].i;
    const double speed = Vector3(clumps.velocity[i]).norm() +
                         clumps.member_reach(i) * Vector3(clumps.spin[i]).norm();
    bool near = false;
    for (last = first; last < n && contacts_[last].i == i; ++last)
      near = near || may_touch(contacts_[last], clumps, ribs, time_step, speed);
    if (!near) continue;
    near_clumps_.push_back(i);
    near_contacts_.insert(near_contacts_.end(), {first, last});
    for (int k = contacts_[first].first; k < contacts_[last - 1].last; ++k)
      rib_is_near_[candidate_ribs_[k]] = 1;
  }
  near_ribs_.clear();
  for (int r = 0; r < static_cast<int>(ribs.size()); ++r)
    if (rib_is_near_[r]) near_ribs_.push_back(r);
}

// Whether one sphere may touch one of the ribs of a line within the step.
bool RibContacts::may_touch(const RibContact& c, const Clumps& clumps, const std::vector<Rib>& ribs,
                            double time_step, double speed) const
{
  if (c.overlap > 0 || c.shared > 0) return true;
  const Vector3 centre = clumps.position[c.i] + clumps.member_offset(c.i, c.a);
  const double radius = clumps.shape_of(c.i).spheres[c.a].radius;
  for (int k = c.first; k < c.last; ++k) {
    const int r = candidate_ribs_[k];
    const double reach =
        near_steps * time_step * (speed + rib_speed_[r]) + near_margin * ribs[r].half_thickness;
    if (clear_of(ribs[r], centre, radius + reach)) continue;
    if (rib_proximity(ribs[r], centre, radius).overlap > -reach) return true;
  }
  return false;
}

void RibContacts::build(const Clumps& clumps, const std::vector<Rib>& ribs)
{
  clump_x_ = clumps.position;
  clump_q_ = clumps.orientation;
  rib_x_.clear();
  rib_axis_.clear();
  for (const Rib& rib : ribs) {
    rib_x_.insert(rib_x_.end(), {rib.x[0], rib.x[1]});
    rib_axis_.insert(rib_axis_.end(), {rib.width_axis[0], rib.width_axis[1]});
  }
  old_contacts_.swap(contacts_);
  contacts_.clear();
  candidate_ribs_.clear();
  std::vector<int> close_ribs;
  Vector3 low = Vector3::Constant(1e300), high = -low;
  for (const Vector3& x : rib_x_) low = low.cwiseMin(x), high = high.cwiseMax(x);
  double largest_section = 0;
  for (const Rib& rib : ribs) largest_section = std::max(largest_section, section_reach(rib));

  for (int i = 0; i < clumps.size(); ++i) {
    const double ball = clumps.bounding_radius(i) + skin_;
    close_ribs.clear();
    const Vector3& x = clumps.position[i];
    // Most clumps are far above or below the geogrid.
    const double margin = ball + largest_section;
    if ((x.array() < low.array() - margin).any() || (x.array() > high.array() + margin).any())
      continue;
    for (int r = 0; r < static_cast<int>(ribs.size()); ++r)
      if (distance_to_segment(x, ribs[r].x[0], ribs[r].x[1]) < ball + section_reach(ribs[r]))
        close_ribs.push_back(r);
    const std::size_t before = contacts_.size();
    const std::vector<Sphere>& spheres = clumps.shape_of(i).spheres;
    for (int a = 0; a < static_cast<int>(spheres.size()) && !close_ribs.empty(); ++a) {
      const Vector3 centre = clumps.position[i] + clumps.member_offset(i, a);
      // Ribs are ordered by line, so the candidates of one line follow one another.
      for (const int r : close_ribs) {
        if (rib_proximity(ribs[r], centre, spheres[a].radius).overlap < -skin_) continue;
        if (contacts_.size() == before || key(contacts_.back()) != std::tie(i, a, ribs[r].line)) {
          RibContact contact;
          contact.i = i, contact.a = a, contact.line = ribs[r].line;
          contact.first = contact.last = candidate_ribs_.size();
          contacts_.push_back(contact);
        }
        candidate_ribs_.push_back(r);
        contacts_.back().last = candidate_ribs_.size();
      }
    }
  }

  auto old = old_contacts_.begin();
  for (RibContact& c : contacts_) {
    while (old != old_contacts_.end() && key(*old) < key(c)) ++old;
    if (old == old_contacts_.end()) break;
    if (key(*old) == key(c))
      c.history = old->history, c.force = old->force, c.rib = old->rib, c.xi = old->xi,
      c.point = old->point, c.arm = old->arm, c.overlap = old->overlap, c.shared = old->shared;
  }
}
} // namespace interlock::dem
