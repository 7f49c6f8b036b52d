// The contacts of MeshContacts and their forces; the lists are in mesh_contact_list.cc.
#include "dem/walls/mesh_contacts.h"

#include "dem/contacts/single_contact.h"
#include "dem/exact_sums.h"
#include "dem/input_error.h"

#include <algorithm>
#include <tuple>

namespace interlock::dem
{
namespace
{
auto key(const MeshContact& c)
{
  return std::tie(c.i, c.wall, c.a);
}

Vector3 relative_velocity(const MeshContact& c, const Clumps& clumps, const MeshWall& wall)
{
  return clumps.step_velocity[c.i] + clumps.step_spin[c.i].cross(c.point - clumps.position[c.i]) -
         wall.velocity_at(c.point);
}

// What contacts of clump i lost.
void book(const ContactEnergy& energy, int i, Clumps& clumps)
{
  clumps.lost.row(Clumps::to_friction)[i] += energy.friction;
  clumps.lost.row(Clumps::to_damping)[i] += energy.damping;
}
} // namespace

double MeshContacts::elastic_energy(const MeshContact& c, const ContactProperties& pair)
{
  const double overlap = c.depth - c.shared;
  return 0.5 * pair.normal_stiffness * overlap * overlap +
         0.5 * pair.tangential_stiffness * c.history.spring.squaredNorm();
}

double MeshContacts::evaluate(Clumps& clumps, std::vector<MeshWall>& walls, double time_step)
{
  for (MeshWall& wall : walls) {
    if (wall.contact.model != ContactModel::linear)
      throw InputError("Wall '" + wall.name +
                       "' of triangles has the Hertz-Mindlin contact model, but walls of triangles "
                       "know the linear one only.");
    wall.force.setZero();
    wall.torque.setZero();
  }
  old_.swap(contacts_);
  contacts_.clear();
  std::size_t first = 0, last = 0; // of the old contacts of the sphere
  double elastic = 0;
  const auto lose_all = [&](std::size_t end) {
    for (; first < end; ++first) {
      ContactEnergy energy;
      lose(old_[first], clumps, walls[old_[first].wall], time_step, energy);
      book(energy, old_[first].i, clumps);
    }
  };
  for (const auto& [clump_and_wall, near] : near_) {
    MeshContact sphere;
    std::tie(sphere.i, sphere.wall) = clump_and_wall;
    MeshWall& wall = walls[sphere.wall];
    const Matrix3 to_wall = wall.orientation.conjugate().toRotationMatrix();
    for (const Member& member : near.members) {
      sphere.a = member.a;
      for (last = first; last < old_.size() && key(old_[last]) < key(sphere);) ++last;
      lose_all(last); // spheres that left every list within one step
      while (last < old_.size() && key(old_[last]) == key(sphere)) ++last;

      const Vector3 x = clumps.position[sphere.i] + clumps.member_offset(sphere.i, sphere.a);
      const double radius = clumps.shape_of(sphere.i).spheres[sphere.a].radius;
      // A sphere that touched needs its gap.
      const double reach = radius + (last > first ? near.skin : 0);
      find_contacts(*wall.surface, near, member, to_wall * (x - wall.centre), reach);
      if (kept_.empty() && first == last) continue;
      const std::size_t before = contacts_.size();
      ContactEnergy energy;
      match(wall, clumps, sphere, first, last, time_step, energy);
      first = last;
      for (std::size_t c = before; c < contacts_.size(); ++c)
        touch(contacts_[c], relative_velocity(contacts_[c], clumps, wall), clumps, wall, time_step,
              energy);
      book(energy, sphere.i, clumps);
      elastic += energy.elastic;
    }
  }
  lose_all(old_.size());
  return elastic;
}

// Leaves in kept_ the local minima of the distance from `centre` (frame of the wall) that are
// nearer than `reach`, nearest first, one for each direction.
void MeshContacts::find_contacts(const MeshSurface& surface, const Near& near, const Member& member,
                                 const Vector3& centre, double reach)
{
  feet_.clear();
  kept_.clear();
  for (int k = member.first; k < member.last; ++k) {
    const int t = near.candidates[k];
    if (std::abs(surface.height(t, centre)) >= reach) continue;
    const MeshSurface::Nearest nearest = surface.nearest(t, centre);
    if (nearest.distance >= reach) continue;
    const Vector3 normal = nearest.distance > 0
                               ? Vector3((centre - nearest.point) / nearest.distance)
                               : surface.normal(t);
    feet_.push_back({nearest, normal, t});
  }
  std::sort(feet_.begin(), feet_.end(), [](const Foot& a, const Foot& b) {
    return std::tie(a.nearest.distance, a.triangle) < std::tie(b.nearest.distance, b.triangle);
  });

  // Rounding may tell neighbours apart that are the same point: those have one direction.
  constexpr double nearer = 1 - 1e-9;
  for (const Foot& foot : feet_) {
    const auto is_same = [&](const Foot& k) {
      return k.normal.dot(foot.normal) > same_contact_cosine;
    };
    const auto passes_nearer = [&](const Foot& f) {
      return f.nearest.distance < nearer * foot.nearest.distance &&
             surface.nearest(f.triangle, foot.nearest.point).distance <= surface.tolerance();
    };
    if (std::any_of(kept_.begin(), kept_.end(), is_same)) continue;
    if (!foot.nearest.inside && std::any_of(feet_.begin(), feet_.end(), passes_nearer)) continue;
    kept_.push_back(foot);
  }
}

// The smallest number that no contact of the sphere has, old or new.
int MeshContacts::free_number(std::size_t first, std::size_t last, std::size_t new_first) const
{
  const auto is_free = [&](int number) {
    const auto has = [number](const MeshContact& c) { return c.number == number; };
    return std::none_of(old_.begin() + first, old_.begin() + last, has) &&
           std::none_of(contacts_.begin() + new_first, contacts_.end(), has);
  };
  int number = 0;
  while (!is_free(number)) ++number;
  return number;
}

// Appends the contacts of kept_ that touch, each with the history of the old one of its direction,
// and ends the old ones that have opened or vanished.
void MeshContacts::match(const MeshWall& wall, const Clumps& clumps, MeshContact sphere,
                         std::size_t first, std::size_t last, double time_step,
                         ContactEnergy& energy)
{
  const double radius = clumps.shape_of(sphere.i).spheres[sphere.a].radius;
  const std::size_t had = last - first, new_first = contacts_.size();
  for (const Foot& foot : kept_) {
    const double depth = radius - foot.nearest.distance;
    MeshContact c = sphere;
    c.normal = wall.orientation * foot.normal;
    std::size_t mine = last;
    double closest = same_contact_cosine;
    for (std::size_t k = first; k < last; ++k) {
      const double cosine = old_[k].normal.dot(c.normal);
      if (old_[k].i >= 0 && cosine > closest) mine = k, closest = cosine;
    }
    if (mine < last) {
      c.history = old_[mine].history;
      c.shared = old_[mine].shared;
      c.number = old_[mine].number;
    } else
      c.number = free_number(first, last, new_first);
    c.depth = depth;
    c.point = wall.orientation * foot.nearest.point + wall.centre - 0.5 * depth * c.normal;
    const Vector3 relative = relative_velocity(c, clumps, wall);
    if (depth > 0) {
      // Beside another contact, and deeper than it can have become in one step: it has split off.
      const bool is_split =
          mine == last && had > 0 && depth > -2 * time_step * relative.dot(c.normal);
      c.shared = is_split ? depth : std::min(c.shared, depth);
      contacts_.push_back(c);
    } else if (mine < last && c.history.overlap - depth > 0)
      end_contact(wall.contact, -depth, relative, time_step, c.history, energy);
    if (mine < last) old_[mine].i = -1; // has a successor, or was ended
  }
  for (std::size_t k = first; k < last; ++k)
    if (old_[k].i >= 0) lose(old_[k], clumps, wall, time_step, energy);
}

void MeshContacts::touch(MeshContact& c, const Vector3& relative, Clumps& clumps, MeshWall& wall,
                         double time_step, ContactEnergy& energy)
{
  rotate_spring(c.history.spring, c.normal, 0.5 * time_step * (clumps.step_spin[c.i] + wall.spin));
  c.force = linear_contact_force(wall.contact, clumps.mass[c.i], c.depth - c.shared, c.normal,
                                 relative, time_step, c.history, energy);
  clumps.force[c.i] += c.force;
  clumps.torque[c.i] += (c.point - clumps.position[c.i]).cross(c.force);
  // Exact sums, as those of other walls.
  for (int k = 0; k < 3; ++k) {
    wall.force[k] -= on_grid<force_grid>(c.force[k]);
    wall.torque[k] -= on_grid<force_grid>((c.point - wall.centre).cross(c.force)[k]);
  }
}

// A pressed contact that is no local minimum any more. What it stored is lost, less what its last
// force still does in its half of the step.
void MeshContacts::lose(const MeshContact& c, const Clumps& clumps, const MeshWall& wall,
                        double time_step, ContactEnergy& energy)
{
  energy.damping += elastic_energy(c, wall.contact) -
                    0.5 * time_step * c.force.dot(relative_velocity(c, clumps, wall));
}
} // namespace interlock::dem
