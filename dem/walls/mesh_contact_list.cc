// The lists of MeshContacts: which triangles can touch which spheres until they expire.
#include "dem/walls/mesh_contacts.h"

#include <algorithm>
#include <limits>

namespace interlock::dem
{
namespace
{
constexpr double triangle_skin = 0.25, member_skin = 0.02; // shares of the bounding radius

Vector3 in_wall_frame(const MeshWall& wall, const Vector3& x)
{
  return wall.orientation.conjugate() * (x - wall.centre);
}
} // namespace

void MeshContacts::update_list(const Clumps& clumps, const std::vector<MeshWall>& walls)
{
  const std::size_t n = clumps.size();
  std::vector<const MeshSurface*> surfaces;
  for (const MeshWall& wall : walls) surfaces.push_back(wall.surface.get());
  if (reference_.size() != n * walls.size() || surfaces != surfaces_) {
    // Not a number: expired, whatever the pose.
    reference_.assign(n * walls.size(),
                      Vector3::Constant(std::numeric_limits<double>::quiet_NaN()));
    near_.clear();
    surfaces_ = surfaces;
  }

  for (std::size_t w = 0; w < walls.size(); ++w) {
    const Matrix3 to_wall = walls[w].orientation.conjugate().toRotationMatrix();
    for (std::size_t i = 0; i < n; ++i) {
      if (clumps.ghost[static_cast<int>(i)] == 1) continue; // another rank's
      const Vector3 x = to_wall * (clumps.position[i] - walls[w].centre);
      const double skin = triangle_skin * clumps.bounding_radius(i);
      if (!((x - reference_[w * n + i]).squaredNorm() <= skin * skin))
        renew_triangles(clumps, walls[w], i, w, x);
    }
  }
  for (auto& [key, near] : near_) {
    const auto [i, w] = key;
    const Vector3 x = in_wall_frame(walls[w], clumps.position[i]);
    const Quaternion q = walls[w].orientation.conjugate() * clumps.orientation[i];
    const double moved = near.fresh
                             ? (x - near.x).norm() + 2 * clumps.member_reach(i) *
                                                         (near.q.conjugate() * q).vec().norm()
                             : std::numeric_limits<double>::infinity();
    if (moved > near.skin) renew_members(clumps, walls[w], i, near);
  }
}

void MeshContacts::renew_triangles(const Clumps& clumps, const MeshWall& wall, int i, int w,
                                   const Vector3& x)
{
  reference_[static_cast<std::size_t>(w) * clumps.size() + i] = x;
  const double reach = 1 + triangle_skin + 2 * member_skin;
  wall.surface->triangles_within(x, reach * clumps.bounding_radius(i), found_);
  if (found_.empty()) {
    near_.erase({i, w});
    return;
  }
  Near& near = near_[{i, w}];
  near.triangles = found_;
  near.fresh = false;
}

void MeshContacts::renew_members(const Clumps& clumps, const MeshWall& wall, int i, Near& near)
{
  near.x = in_wall_frame(wall, clumps.position[i]);
  near.q = wall.orientation.conjugate() * clumps.orientation[i];
  near.skin = member_skin * clumps.bounding_radius(i);
  near.fresh = true;
  near.members.clear();
  near.candidates.clear();
  const std::vector<Sphere>& spheres = clumps.shape_of(i).spheres;
  for (int a = 0; a < static_cast<int>(spheres.size()); ++a) {
    const Vector3 centre = in_wall_frame(wall, clumps.position[i] + clumps.member_offset(i, a));
    // Twice the skin: contacts are looked for up to a skin beyond the surface (evaluate), so that
    // one which opens is booked alike whenever the list was made.
    const double reach = spheres[a].radius + 2 * near.skin;
    const int first = static_cast<int>(near.candidates.size());
    for (const int t : near.triangles)
      if (std::abs(wall.surface->height(t, centre)) < reach &&
          wall.surface->nearest(t, centre).distance < reach)
        near.candidates.push_back(t);
    const int last = static_cast<int>(near.candidates.size());
    if (last > first) near.members.push_back({a, first, last});
  }
}

void MeshContacts::renumber_clumps(const std::vector<int>& new_index)
{
  contacts_.erase(std::remove_if(contacts_.begin(), contacts_.end(),
                                 [&](const MeshContact& c) { return new_index[c.i] < 0; }),
                  contacts_.end());
  for (MeshContact& c : contacts_) c.i = new_index[c.i];
  invalidate();
}

void MeshContacts::forget_walls(int first)
{
  contacts_.erase(std::remove_if(contacts_.begin(), contacts_.end(),
                                 [&](const MeshContact& c) { return c.wall >= first; }),
                  contacts_.end());
  invalidate();
}
} // namespace interlock::dem
