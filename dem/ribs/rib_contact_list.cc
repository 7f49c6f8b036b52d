// The list of RibContacts: which spheres can touch which ribs until it expires.
#include "dem/ribs/rib_contacts.h"
#include "dem/ribs/rib_search.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace interlock::dem
{
namespace
{
// See select_near: steps of room for kicks, and a share of a rib's half thickness.
constexpr double near_steps = 2, near_margin = 0.01;
// A list shall last for so many steps, within these skins [m].
constexpr double list_steps = 40, smallest_skin = 1e-4, largest_skin = 1e-3;

auto key(const RibContact& c)
{
  return std::tie(c.i, c.a, c.line);
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
  rib_speed_.clear();
  for (const Rib& rib : ribs) rib_speed_.push_back(rib_speed(rib));
  if (!list_holds(clumps, ribs, time_step)) {
    build(clumps, ribs, time_step);
    valid_ = true;
  }
  select_near(clumps, ribs, time_step);
}

// Whoever select_near may choose must be in the list: what a clump and the ribs have moved, and
// what it looks ahead, is within the room that the clump had when the list was made.
bool RibContacts::list_holds(const Clumps& clumps, const std::vector<Rib>& ribs,
                             double time_step) const
{
  // Clumps or ribs may have come since the list was made.
  if (!valid_ || clump_x_.size() != clumps.size() || rib_x_.size() != 2 * ribs.size()) return false;
  double moved = 0, turned = 0, thickest = 0, fastest = 0;
  for (std::size_t r = 0; r < ribs.size(); ++r) {
    const double reach = section_reach(ribs[r]);
    thickest = std::max(thickest, ribs[r].half_thickness);
    fastest = std::max(fastest, rib_speed_[r]);
    for (int end : {0, 1}) {
      moved = std::max(moved, (ribs[r].x[end] - rib_x_[2 * r + end]).squaredNorm());
      const Vector3 turn = ribs[r].width_axis[end] - rib_axis_[2 * r + end];
      turned = std::max(turned, reach * reach * turn.squaredNorm());
    }
  }
  const double ahead = near_steps * time_step;
  const double by_ribs =
      std::sqrt(moved) + 2 * std::sqrt(turned) + ahead * fastest + near_margin * thickest;
  for (int i = 0; i < clumps.size(); ++i) {
    const double left = room_[i] - by_ribs, reach = clumps.member_reach(i);
    if (left < 0) return false;
    const double way = (clumps.position[i] - clump_x_[i]).squaredNorm();
    const double turn =
        4 * reach * reach * (clump_q_[i].conjugate() * clumps.orientation[i]).vec().squaredNorm();
    const double speed = ahead * ahead * clumps.velocity[i].squaredNorm();
    const double spin = ahead * ahead * reach * reach * clumps.spin[i].squaredNorm();
    // A sum of four is at most twice the root of the sum of their squares: most need no root.
    if (4 * (way + turn + speed + spin) <= left * left) continue;
    if (std::sqrt(way) + std::sqrt(turn) + std::sqrt(speed) + std::sqrt(spin) > left) return false;
  }
  return true;
}

void RibContacts::select_near(const Clumps& clumps, const std::vector<Rib>& ribs, double time_step)
{
  near_clumps_.clear();
  near_contacts_.clear();
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

// Clumps farther from the box around all ribs than any skin only need to be watched. The others get
// a skin for some forty steps at the speed of the fastest of them.
void RibContacts::build(const Clumps& clumps, const std::vector<Rib>& ribs, double time_step)
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
  room_.clear();

  RibSearch::Box around;
  for (const Rib& rib : ribs) {
    const Vector3 reach = Vector3::Constant(section_reach(rib));
    for (const Vector3& x : rib.x) around.extend(x - reach), around.extend(x + reach);
  }
  double fastest = 0;
  for (const double speed : rib_speed_) fastest = std::max(fastest, speed);
  for (int i = 0; i < clumps.size(); ++i) {
    const Vector3& x = clumps.position[i];
    room_.push_back(around.exteriorDistance(x) - clumps.bounding_radius(i));
    if (room_[i] < largest_skin)
      fastest = std::max(fastest, Vector3(clumps.velocity[i]).norm() +
                                      clumps.member_reach(i) * Vector3(clumps.spin[i]).norm());
  }
  skin_ = std::clamp(2 * fastest * time_step * list_steps, smallest_skin, largest_skin);

  const RibSearch search(ribs, skin_);
  for (int i = 0; i < clumps.size(); ++i) {
    if (room_[i] >= skin_) continue;
    room_[i] = skin_;
    add_candidates(i, clumps, ribs, search);
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

// Of the member spheres of clump i. Ribs are ordered by line, so the candidates of one line follow
// one another.
void RibContacts::add_candidates(int i, const Clumps& clumps, const std::vector<Rib>& ribs,
                                 const RibSearch& search)
{
  const auto ball = [](const Vector3& x, double radius) {
    return RibSearch::Box(x.array() - radius, x.array() + radius);
  };
  search.find(ball(clumps.position[i], clumps.bounding_radius(i)), close_ribs_);
  if (close_ribs_.empty()) return;
  RibSearch::Box close;
  for (const int r : close_ribs_) close.extend(search.box(r));
  const std::size_t before = contacts_.size();
  const std::vector<Sphere>& spheres = clumps.shape_of(i).spheres;
  for (int a = 0; a < static_cast<int>(spheres.size()); ++a) {
    const Vector3 centre = clumps.position[i] + clumps.member_offset(i, a);
    const RibSearch::Box box = ball(centre, spheres[a].radius);
    if (!close.intersects(box)) continue;
    for (const int r : close_ribs_) {
      if (!search.box(r).intersects(box)) continue;
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
} // namespace interlock::dem
