#include "dem/neighbour_lists.h"

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <tuple>

namespace interlock::dem
{
namespace
{
namespace bg = boost::geometry;
using BoostPoint = bg::model::point<double, 3, bg::cs::cartesian>;
using BoostBox = bg::model::box<BoostPoint>;

BoostBox box_around(const Vector3& x, double r)
{
  return {BoostPoint(x[0] - r, x[1] - r, x[2] - r), BoostPoint(x[0] + r, x[1] + r, x[2] + r)};
}

auto key(const SphereContact& c)
{
  return std::tie(c.i, c.j, c.a, c.b);
}
auto key(const WallContact& c)
{
  return std::tie(c.i, c.wall, c.a);
}

// Carries the history from the old list to the new one; both are sorted by key.
template <class Contact>
void carry_history(const std::vector<Contact>& old_contacts, std::vector<Contact>& contacts)
{
  auto old = old_contacts.begin();
  for (Contact& contact : contacts) {
    while (old != old_contacts.end() && key(*old) < key(contact)) ++old;
    if (old == old_contacts.end()) return;
    if (key(*old) == key(contact)) {
      contact.history = old->history;
      contact.touching = old->touching;
      contact.force = old->force;
      contact.point = old->point;
    }
  }
}
} // namespace

void NeighbourLists::Reference::take(const Clumps& clumps, const std::vector<Wall>& walls, double s)
{
  x = clumps.position;
  q = clumps.orientation;
  wall.clear();
  for (const Wall& w : walls) wall.push_back(w.corner);
  skin = s;
}

double NeighbourLists::Reference::used(const Clumps& clumps, const std::vector<Wall>& walls,
                                       bool with_rotation) const
{
  double moved = 0, turned = 0;
  for (int i = 0; i < clumps.size(); ++i) {
    moved = std::max(moved, (clumps.position[i] - x[i]).squaredNorm());
    if (!with_rotation) continue;
    const double reach = clumps.member_reach(i);
    const Vector3 v = (q[i].conjugate() * clumps.orientation[i]).vec();
    turned = std::max(turned, reach * reach * v.squaredNorm());
  }
  double used = std::sqrt(moved) + 2 * std::sqrt(turned);
  for (std::size_t w = 0; w < walls.size(); ++w)
    used = std::max(used, (walls[w].corner - wall[w]).norm());
  return used;
}

void NeighbourLists::update(const Clumps& clumps, const std::vector<Wall>& walls, double time_step)
{
  const double slack = inner_.skin;
  if (valid_ && 2 * inner_.used(clumps, walls, true) <= slack) return;

  double fastest = 0;
  for (int i = 0; i < clumps.size(); ++i)
    fastest = std::max(fastest,
                       clumps.velocity[i].norm() + clumps.spin[i].norm() * clumps.member_reach(i));
  for (const Wall& wall : walls) fastest = std::max(fastest, wall.velocity.norm());
  // Twice the way of the fastest clump in a number of steps that balances building against testing.
  double inner_skin = std::clamp(2 * fastest * time_step * 12, 2e-5, 2e-4);
  double middle_skin = std::clamp(2 * fastest * time_step * 80, 3e-4, 2e-3);
  if (settings_.inner_skin > 0) inner_skin = settings_.inner_skin;
  if (settings_.middle_skin > 0) middle_skin = settings_.middle_skin;
  middle_skin = std::max(middle_skin, 2 * inner_skin);
  const double outer_skin = 4e-3;

  const bool middle_lasts =
      valid_ && inner_skin + 2 * middle_.used(clumps, walls, true) <= middle_.skin;
  if (!middle_lasts) {
    if (!valid_ || middle_skin + 2 * outer_.used(clumps, walls, false) > outer_.skin) {
      outer_.take(clumps, walls, outer_skin + middle_skin);
      build_outer(clumps, walls);
    }
    middle_.take(clumps, walls, middle_skin);
    build_middle(clumps, walls);
  }
  inner_.take(clumps, walls, inner_skin);
  build_inner(clumps, walls);
  valid_ = true;
}

void NeighbourLists::build_outer(const Clumps& clumps, const std::vector<Wall>&)
{
  using Entry = std::pair<BoostBox, int>;
  std::vector<Entry> boxes;
  boxes.reserve(clumps.size());
  for (int i = 0; i < clumps.size(); ++i)
    boxes.emplace_back(box_around(clumps.position[i], clumps.bounding_radius(i)), i);
  const bg::index::rtree<Entry, bg::index::quadratic<16>> tree(boxes);

  clump_pairs_.clear();
  std::vector<Entry> hits;
  for (int i = 0; i < clumps.size(); ++i) {
    const double reach = clumps.bounding_radius(i) + outer_.skin;
    hits.clear();
    tree.query(bg::index::intersects(box_around(clumps.position[i], reach)),
               std::back_inserter(hits));
    const std::size_t first = clump_pairs_.size();
    for (const Entry& hit : hits) {
      const int j = hit.second;
      const double limit = reach + clumps.bounding_radius(j);
      if (j > i && (clumps.position[j] - clumps.position[i]).squaredNorm() < limit * limit)
        clump_pairs_.push_back({i, j});
    }
    std::sort(clump_pairs_.begin() + first, clump_pairs_.end(),
              [](const ClumpPair& a, const ClumpPair& b) { return a.j < b.j; });
  }
}

void NeighbourLists::place_members(const Clumps& clumps)
{
  first_member_.resize(clumps.size() + 1);
  member_centre_.resize(clumps.n_spheres());
  int next = 0;
  for (int i = 0; i < clumps.size(); ++i) {
    first_member_[i] = next;
    for (const Sphere& sphere : clumps.shape_of(i).spheres)
      member_centre_[next++] = clumps.position[i] + clumps.rotation[i] * sphere.centre;
  }
  first_member_[clumps.size()] = next;
}

void NeighbourLists::build_middle(const Clumps& clumps, const std::vector<Wall>& walls)
{
  place_members(clumps);
  member_pairs_.clear();
  for (const ClumpPair& pair : clump_pairs_) {
    const double limit =
        clumps.bounding_radius(pair.i) + clumps.bounding_radius(pair.j) + middle_.skin;
    if ((clumps.position[pair.j] - clumps.position[pair.i]).squaredNorm() < limit * limit)
      add_member_pairs(clumps, pair.i, pair.j);
  }

  wall_members_.clear();
  for (int i = 0; i < clumps.size(); ++i)
    for (int w = 0; w < static_cast<int>(walls.size()); ++w) {
      const Vector3 to_clump = clumps.position[i] - walls[w].nearest_point(clumps.position[i]);
      if (to_clump.norm() > clumps.bounding_radius(i) + middle_.skin) continue;
      const std::vector<Sphere>& spheres = clumps.shape_of(i).spheres;
      for (int a = 0; a < static_cast<int>(spheres.size()); ++a) {
        const Vector3& centre = member_centre_[first_member_[i] + a];
        const double reach = spheres[a].radius + middle_.skin;
        if ((centre - walls[w].nearest_point(centre)).squaredNorm() < reach * reach)
          wall_members_.push_back({i, w, a});
      }
    }
}

// A slab filter along the line of centres leaves few spheres of either clump; those are tested in
// pairs.
void NeighbourLists::add_member_pairs(const Clumps& clumps, int i, int j)
{
  const std::vector<Sphere>&si = clumps.shape_of(i).spheres, &sj = clumps.shape_of(j).spheres;
  const Vector3 *xi = &member_centre_[first_member_[i]], *xj = &member_centre_[first_member_[j]];
  const Vector3 axis = (clumps.position[j] - clumps.position[i]).normalized();
  const double skin = middle_.skin;

  double front_i = -1e300, front_j = 1e300;
  for (std::size_t a = 0; a < si.size(); ++a)
    front_i = std::max(front_i, axis.dot(xi[a]) + si[a].radius);
  for (std::size_t b = 0; b < sj.size(); ++b)
    front_j = std::min(front_j, axis.dot(xj[b]) - sj[b].radius);
  if (front_i + skin < front_j) return;

  candidates_i_.clear();
  candidates_j_.clear();
  for (std::size_t a = 0; a < si.size(); ++a)
    if (axis.dot(xi[a]) + si[a].radius + skin >= front_j) candidates_i_.push_back(a);
  for (std::size_t b = 0; b < sj.size(); ++b)
    if (axis.dot(xj[b]) - sj[b].radius - skin <= front_i) candidates_j_.push_back(b);
  for (const int a : candidates_i_)
    for (const int b : candidates_j_) {
      const double reach = si[a].radius + sj[b].radius + skin;
      if ((xi[a] - xj[b]).squaredNorm() < reach * reach) member_pairs_.push_back({i, j, a, b});
    }
}

void NeighbourLists::build_inner(const Clumps& clumps, const std::vector<Wall>& walls)
{
  const double skin = inner_.skin;
  old_sphere_contacts_.swap(sphere_contacts_);
  sphere_contacts_.clear();
  for (const MemberPair& p : member_pairs_) {
    const Sphere &sa = clumps.shape_of(p.i).spheres[p.a], &sb = clumps.shape_of(p.j).spheres[p.b];
    const Vector3 d = clumps.position[p.i] + clumps.rotation[p.i] * sa.centre -
                      clumps.position[p.j] - clumps.rotation[p.j] * sb.centre;
    const double reach = sa.radius + sb.radius + skin;
    if (d.squaredNorm() >= reach * reach) continue;
    SphereContact contact;
    contact.i = p.i, contact.j = p.j, contact.a = p.a, contact.b = p.b;
    sphere_contacts_.push_back(contact);
  }
  carry_history(old_sphere_contacts_, sphere_contacts_);

  old_wall_contacts_.swap(wall_contacts_);
  wall_contacts_.clear();
  for (const WallMember& m : wall_members_) {
    const Vector3 x = clumps.position[m.i] + clumps.member_offset(m.i, m.a);
    const double reach = clumps.shape_of(m.i).spheres[m.a].radius + skin;
    if ((x - walls[m.wall].nearest_point(x)).squaredNorm() >= reach * reach) continue;
    WallContact contact;
    contact.i = m.i, contact.wall = m.wall, contact.a = m.a;
    wall_contacts_.push_back(contact);
  }
  carry_history(old_wall_contacts_, wall_contacts_);
}

void NeighbourLists::renumber_clumps(const std::vector<int>& new_index)
{
  // Order is kept by the renumbering, so the lists stay sorted.
  auto gone = [&](int i) { return new_index[i] < 0; };
  auto& s = sphere_contacts_;
  s.erase(std::remove_if(s.begin(), s.end(), [&](auto& c) { return gone(c.i) || gone(c.j); }),
          s.end());
  for (SphereContact& c : s) c.i = new_index[c.i], c.j = new_index[c.j];
  auto& w = wall_contacts_;
  w.erase(std::remove_if(w.begin(), w.end(), [&](auto& c) { return gone(c.i); }), w.end());
  for (WallContact& c : w) c.i = new_index[c.i];
  invalidate();
}

void NeighbourLists::forget_walls(int first)
{
  auto& w = wall_contacts_;
  w.erase(std::remove_if(w.begin(), w.end(), [&](auto& c) { return c.wall >= first; }), w.end());
  invalidate();
}
} // namespace interlock::dem
