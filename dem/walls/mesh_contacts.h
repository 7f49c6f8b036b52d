// Contacts of stones with walls of triangles. What a contact is, and why: docs/theory/walls.md.
#pragma once

#include "dem/bodies/clumps.h"
#include "dem/contacts/contact_law.h"
#include "dem/walls/mesh_wall.h"

#include <map>
#include <utility>
#include <vector>

namespace interlock::dem
{
// Where one member sphere of a clump touches a wall: a local minimum of the distance from its
// centre to the surface. A sphere has one on a face, a convex edge or a vertex, two in a groove.
struct MeshContact {
  int i = 0, wall = 0, a = 0;
  int number = 0;                   // among the contacts of the sphere with the wall, kept for life
  ContactHistory history;           // of the clump against the wall
  Vector3 force = Vector3::Zero();  // on the clump [N]
  Vector3 point = Vector3::Zero();  // mid-overlap, world [m]
  Vector3 normal = Vector3::Zero(); // from the wall to the sphere, world
  double depth = 0;                 // of the geometry: radius less distance [m]
  // Part of the depth that makes no force [m]: what there was when this contact split off from
  // another one. It shrinks with the depth, so that no energy appears.
  double shared = 0;
};

// Contacts of one sphere with one wall are one and the same when their normals differ by less than
// this (cosine, about 15 degrees): at one time, and from one step to the next.
constexpr double same_contact_cosine = 0.965;

class MeshContacts
{
public:
  // Makes the lists complete for the present poses. Of each clump near a wall the triangles in
  // reach are kept, and of these the ones in reach of each member sphere. Both lists go by the pose
  // of the clump in the frame of the wall. Since its reference pose (x0, q0) a point of the clump
  // has moved there by at most
  //     u = |x - x0| + 2 c |vec(conj(q0) q)|,  c = distance of its farthest sphere centre,
  // and the distance of a point to a rigid surface changes by no more than the point moves. So
  //   triangles farther than R + S from the clump's centre (R: bounding radius) cannot touch it
  //   while |x - x0| <= S, and those farther than r + s from a member sphere cannot touch that one
  //   while u <= s. Here S = R/4 and s = R/50.
  // Both are checked for every clump at every call, and renewed for the clump that breaks one.
  void update_list(const Clumps& clumps, const std::vector<MeshWall>& walls);

  // Evaluates all contacts at the present poses, for which update_list must have been called, and
  // advances springs by `time_step` [s]. Adds to clumps.force, .torque and .lost; sets force and
  // torque of the walls. Returns the energy in the springs [J]. Velocities are clumps.step_velocity
  // and .step_spin, and those of the walls' last move. Each contact has the whole stiffness
  // (share_among_contacts is not heeded). Throws InputError for another model than the linear one.
  double evaluate(Clumps& clumps, std::vector<MeshWall>& walls, double time_step);

  // Those that touch, sorted by (i, wall, a), then by depth.
  const std::vector<MeshContact>& contacts() const { return contacts_; }
  // Goes on from contacts() of an earlier run, with the same digits.
  void restore(std::vector<MeshContact> contacts)
  {
    contacts_ = std::move(contacts);
    invalidate();
  }

  // After clumps were removed: drops their contacts and renumbers the others.
  void renumber_clumps(const std::vector<int>& new_index);
  // After walls were removed or exchanged: drops contacts of walls with index >= first.
  void forget_walls(int first);
  void invalidate() // the lists; springs are kept
  {
    reference_.clear();
    near_.clear();
  }
  // Energy in the springs of one contact [J], to be booked when it is dropped.
  static double elastic_energy(const MeshContact& contact, const ContactProperties& pair);

private:
  struct Member {
    int a, first, last; // sphere, range of its candidates
  };
  struct Near { // one clump near one wall
    std::vector<int> triangles, candidates;
    std::vector<Member> members;
    Vector3 x; // reference pose of the members in the frame of the wall
    Quaternion q;
    double skin = 0; // [m]
    bool fresh = false;
  };
  struct Foot { // nearest point of a triangle, frame of the wall
    MeshSurface::Nearest nearest;
    Vector3 normal;
    int triangle;
  };

  void renew_triangles(const Clumps& clumps, const MeshWall& wall, int i, int w, const Vector3& x);
  static void renew_members(const Clumps& clumps, const MeshWall& wall, int i, Near& near);
  void find_contacts(const MeshSurface& surface, const Near& near, const Member& member,
                     const Vector3& centre, double reach);
  // The contacts of one sphere at the last evaluation are old_[first] to old_[last - 1].
  void match(const MeshWall& wall, const Clumps& clumps, MeshContact sphere, std::size_t first,
             std::size_t last, double time_step, ContactEnergy& energy);
  int free_number(std::size_t first, std::size_t last, std::size_t new_first) const;
  void touch(MeshContact& contact, const Vector3& relative, Clumps& clumps, MeshWall& wall,
             double time_step, ContactEnergy& energy);
  static void lose(const MeshContact& contact, const Clumps& clumps, const MeshWall& wall,
                   double time_step, ContactEnergy& energy);

  std::map<std::pair<int, int>, Near> near_; // by (clump, wall)
  std::vector<Vector3> reference_; // of the triangles of clump i at wall w: [w * clumps + i]
  std::vector<const MeshSurface*> surfaces_;
  std::vector<int> found_;
  std::vector<Foot> feet_, kept_;
  std::vector<MeshContact> contacts_, old_;
};
} // namespace interlock::dem
