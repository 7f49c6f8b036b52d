// The list of RibContacts: which spheres can touch which ribs until it expires.
#include "dem/ribs/rib_contacts.h"
#include "dem/ribs/rib_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace interlock::dem
{
namespace
{
// See select_near: steps of room for kicks, and a share of a rib's half thickness.
constexpr double near_steps = 2, near_margin = 0.01;
// A list shall last for so many steps, within these skins [m].
constexpr double list_steps = 160, smallest_skin = 1e-4;

auto key(const RibContact& c)
{
  return std::tie(c.i, c.a, c.line);
}

// A bound on the speed of any point of a rib [m/s].
double largest_speed(const RibSet& ribs, const RibShape& shape)
{
  const int e = shape.first_end;
  const double moving =
      std::max(ribs.velocity[e].squaredNorm(), ribs.velocity[e + 1].squaredNorm());
  const double turning = std::max(ribs.spin[e].squaredNorm(), ribs.spin[e + 1].squaredNorm());
  return std::sqrt(moving) + (shape.half_width + shape.half_thickness) * std::sqrt(turning);
}
} // namespace

void RibContacts::clear()
{
  contacts_.clear();
  near_clumps_.clear();
  near_contacts_.clear();
  spheres_on_lines_.clear();
  near_pairs_.resize(0);
  lanes_.resize(0);
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

void RibContacts::update_list(const Clumps& clumps, const RibSet& ribs, double time_step)
{
  // Whoever select_near may choose must be in the list.
  if (!valid_ || !watch_.holds(clumps, ribs, near_steps * time_step,
                               near_margin * ribs.largest_half_thickness())) {
    build(clumps, ribs, time_step);
    valid_ = true;
  }
  select_near(clumps, ribs, time_step);
}

void RibContacts::select_near(const Clumps& clumps, const RibSet& ribs, double time_step)
{
  measure_overlaps(clumps, ribs, pairs_);
  near_clumps_.clear();
  near_contacts_.clear();
  spheres_on_lines_.clear();
  const int n = static_cast<int>(contacts_.size());
  int n_pairs = 0;
  double speed = 0;
  for (int g = 0, clump = -1; g < n; ++g) {
    const RibContact& c = contacts_[g];
    if (c.i != clump) {
      clump = c.i;
      speed = Vector3(clumps.velocity[clump]).norm() +
              clumps.member_reach(clump) * Vector3(clumps.spin[clump]).norm();
    }
    if (!may_touch(c, speed, ribs, time_step)) continue;
    if (near_clumps_.empty() || near_clumps_.back() != clump) near_clumps_.push_back(clump);
    const int lane = static_cast<int>(near_contacts_.size());
    if (lane > 0) {
      const RibContact& before = contacts_[near_contacts_.back().contact];
      if (before.i == c.i && before.a == c.a) {
        if (spheres_on_lines_.empty() || spheres_on_lines_.back().end != lane)
          spheres_on_lines_.push_back({lane - 1, lane});
        spheres_on_lines_.back().end = lane + 1;
      }
    }
    near_contacts_.push_back({g, n_pairs, n_pairs + c.last - c.first});
    n_pairs = near_contacts_.back().last;
  }
  fill_lanes(clumps, ribs);
}

// Whether one sphere may touch one of the ribs of a line within the step; for measured pairs.
bool RibContacts::may_touch(const RibContact& c, double clump_speed, const RibSet& ribs,
                            double time_step) const
{
  if (c.overlap > 0 || c.shared > 0) return true;
  for (int k = c.first; k < c.last; ++k) {
    const RibShape& shape = ribs.shape(static_cast<int>(pairs_.rod.rib[k]));
    const double reach = near_steps * time_step * (clump_speed + largest_speed(ribs, shape)) +
                         near_margin * shape.half_thickness;
    if (pairs_.overlap[k] > -reach) return true;
  }
  return false;
}

void RibContacts::fill_lanes(const Clumps& clumps, const RibSet& ribs)
{
  near_pairs_.resize(near_contacts_.empty() ? 0 : near_contacts_.back().last);
  lanes_.resize(0); // entries beyond the last one are filler
  lanes_.resize(static_cast<int>(near_contacts_.size()));
  int place = -1, clump = -1;
  for (int lane = 0; lane < lanes_.size(); ++lane) {
    const NearContact& near = near_contacts_[lane];
    const RibContact& c = contacts_[near.contact];
    if (c.i != clump) clump = c.i, ++place;
    const Sphere& sphere = clumps.shape_of(c.i).spheres[c.a];
    lanes_.place[lane] = place;
    lanes_.centre[lane] = sphere.centre;
    lanes_.radius[lane] = sphere.radius;
    lanes_.spring[lane] = c.history.spring;
    lanes_.dashpot[lane] = c.history.dashpot;
    lanes_.overlap[lane] = c.history.overlap;
    lanes_.crushed[lane] = c.history.crushed;
    lanes_.tangential_stiffness[lane] = c.tangential_stiffness;
    lanes_.rod.set(lane, static_cast<int>(pairs_.rod.rib[c.first]), ribs);
    for (int k = near.first; k < near.last; ++k)
      near_pairs_.set(k, place, sphere, static_cast<int>(pairs_.rod.rib[c.first + k - near.first]),
                      ribs);
  }
}

// Clumps farther from the box around all ribs than any skin only need to be watched, ghosts not
// even that: their own ranks do. The others get a skin for so many steps at the speed of the
// fastest of them.
void RibContacts::build(const Clumps& clumps, const RibSet& ribs, double time_step)
{
  old_contacts_.swap(contacts_);
  contacts_.clear();
  candidates_.clear();

  RibSearch::Box around;
  double fastest = 0;
  for (const int r : ribs.present()) {
    around.extend(RibSearch::box_around(ribs[r], 0));
    fastest = std::max(fastest, largest_speed(ribs, ribs.shape(r)));
  }
  ScalarField room;
  room.resize(clumps.size());
  for (int i = 0; i < clumps.size(); ++i) {
    if (clumps.ghost[i] == 1) {
      room[i] = std::numeric_limits<double>::infinity();
      continue;
    }
    const Vector3& x = clumps.position[i];
    room[i] = around.exteriorDistance(x) - clumps.bounding_radius(i);
    if (room[i] < largest_skin)
      fastest = std::max(fastest, Vector3(clumps.velocity[i]).norm() +
                                      clumps.member_reach(i) * Vector3(clumps.spin[i]).norm());
  }
  skin_ = std::clamp(2 * fastest * time_step * list_steps, smallest_skin, largest_skin);

  const RibSearch search(ribs, skin_);
  for (int i = 0; i < clumps.size(); ++i) {
    if (room[i] >= skin_) continue;
    room[i] = skin_;
    add_candidates(i, clumps, ribs, search);
  }
  watch_.begin(clumps, ribs, std::move(room));
  pairs_.resize(0); // entries beyond the last one are filler
  pairs_.resize(static_cast<int>(candidates_.size()));
  for (int k = 0; k < pairs_.size(); ++k) {
    const PairOfList& pair = candidates_[k];
    pairs_.set(k, pair.clump, clumps.shape_of(pair.clump).spheres[pair.sphere], pair.rib, ribs);
  }

  auto old = old_contacts_.begin();
  for (RibContact& c : contacts_) {
    while (old != old_contacts_.end() && key(*old) < key(c)) ++old;
    if (old == old_contacts_.end()) break;
    if (key(*old) == key(c))
      c.history = old->history, c.force = old->force, c.rib = old->rib, c.xi = old->xi,
      c.point = old->point, c.arm = old->arm, c.overlap = old->overlap, c.shared = old->shared,
      c.tangential_stiffness = old->tangential_stiffness;
  }
}

// Of the member spheres of clump i. Ribs are ordered by line, so the candidates of one line follow
// one another.
void RibContacts::add_candidates(int i, const Clumps& clumps, const RibSet& ribs,
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
      const int line = ribs.shape(r).line;
      if (contacts_.size() == before || key(contacts_.back()) != std::tie(i, a, line)) {
        RibContact contact;
        contact.i = i, contact.a = a, contact.line = line;
        contact.radius = spheres[a].radius;
        contact.first = contact.last = static_cast<int>(candidates_.size());
        contacts_.push_back(contact);
      }
      candidates_.push_back({i, a, r});
      ++contacts_.back().last;
    }
  }
}
} // namespace interlock::dem
