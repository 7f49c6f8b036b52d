// Walls of triangles: a rigid surface, open or closed, that moves as prescribed. Hoppers, drums,
// belts, anything drawn elsewhere; a rectangle is cheaper as a Wall (wall.h).
#pragma once

#include "dem/contacts/contact_properties.h"
#include "dem/meshes/triangle_mesh.h"

#include <memory>
#include <string>
#include <vector>

namespace interlock::dem
{
// An immutable set of triangles with a search tree. Both sides are solid, so the order of corners
// means nothing; edges may have any number of facets, and vertices may hang on the edge of another
// triangle.
class MeshSurface
{
public:
  // Vertices [m]. Vertices at exactly the same place become one; triangles without area (height
  // below 1e-9 of the longest side) and all but the first of triangles with the same corners, in
  // whichever order, are left out and counted. Throws InputError when no triangle is left, a
  // coordinate is not finite or a corner is not a vertex.
  explicit MeshSurface(TriangleMesh mesh);
  ~MeshSurface();
  MeshSurface(const MeshSurface&) = delete;
  MeshSurface& operator=(const MeshSurface&) = delete;

  int size() const { return static_cast<int>(mesh_.triangles.size()); }
  const TriangleMesh& mesh() const { return mesh_; } // as it is used
  int degenerate_dropped() const { return degenerate_dropped_; }
  int duplicates_dropped() const { return duplicates_dropped_; }

  // The point of one triangle that is nearest to `x`. Source: Ericson, Real-Time Collision
  // Detection (2005), section 5.1.5; the foot on a face is found along the normal, for accuracy.
  struct Nearest {
    Vector3 point;      // [m]
    double distance;    // [m]
    bool inside = true; // of the face, not on an edge or a corner
  };
  Nearest nearest(int triangle, const Vector3& x) const;
  double height(int triangle, const Vector3& x) const // above its plane, signed [m]
  {
    return facets_[triangle].normal.dot(x - facets_[triangle].a);
  }
  const Vector3& normal(int triangle) const { return facets_[triangle].normal; } // unit

  // All triangles nearer to `x` than `distance` [m], ascending, into `found`.
  void triangles_within(const Vector3& x, double distance, std::vector<int>& found) const;

  // How far a point may be from a triangle that it is said to be on [m]: 1e-6 of the extent of the
  // surface, since files are often written in single precision.
  double tolerance() const { return tolerance_; }

private:
  struct Facet {
    Vector3 a, ab, ac, normal;
  };
  struct Tree;

  TriangleMesh mesh_;
  std::vector<Facet> facets_;
  std::unique_ptr<const Tree> tree_;
  int degenerate_dropped_ = 0, duplicates_dropped_ = 0;
  double tolerance_ = 0;
};

// A surface in motion. World frame.
struct MeshWall {
  std::string name;
  std::shared_ptr<const MeshSurface> surface; // vertices in the wall's own frame
  Vector3 centre = Vector3::Zero();           // of the wall's frame: it turns about this point [m]
  Quaternion orientation = Quaternion::Identity(); // wall to world
  // Prescribed, of the next move and, at contacts, of the last one: change them after the contacts
  // of a step were evaluated and before the wall moves.
  Vector3 velocity = Vector3::Zero(); // of the centre [m/s]
  Vector3 spin = Vector3::Zero();     // about the centre [rad/s]
  ContactProperties contact;          // with a stone

  // Of the stones on the wall at the last step, set by MeshContacts::evaluate; others may add to
  // them until the wall moves.
  Vector3 force = Vector3::Zero();  // [N]
  Vector3 torque = Vector3::Zero(); // about the centre [N m]

  // Mean velocity, over the last move, of the wall's material that is now at a point of the world
  // [m/s]: the chord of its way. With the velocity at the end instead, a ball that rides on a
  // turntable would creep outwards by w^2 r dt/2 a second. Before the first move: the velocity.
  Vector3 velocity_at(const Vector3& point) const
  {
    const Vector3 arm = point - centre;
    return velocity + spin.cross(arm - 0.5 * turned.cross(arm));
  }
  void move(double time_step); // [s]

  // Done by the wall on the stones since the beginning, up to the present pose [J]: a leapfrog kick
  // does the work of the mean of the forces at both ends of a step.
  double work() const { return booked_work + half_work(); }
  // Of the present forces in the last move [J].
  double half_work() const { return -0.5 * (force.dot(moved) + torque.dot(turned)); }

  // Kept by move(), for checkpoints.
  double booked_work = 0;           // [J]
  Vector3 moved = Vector3::Zero();  // in the last move, the centre [m]
  Vector3 turned = Vector3::Zero(); // in the last move, rotation vector [rad]
};

// A wall from triangles given in the world frame [m], that turns about `centre` (world).
// Throws what MeshSurface throws.
MeshWall mesh_wall(const std::string& name, TriangleMesh world_mesh,
                   const Vector3& centre = Vector3::Zero());

// The triangles of an STL, PLY or OBJ file, open surfaces allowed. `length_unit` is the length of
// one file unit [m]. Throws InputError that names the file when it is missing, of another format
// than its extension says, damaged, or has no facet, when the unit is not above 0, or when its
// coordinates are too coarse (dem/scans/resolution.h). What is only noteworthy about them is
// appended to `notes`, sentences without the file and the full stop.
TriangleMesh read_wall_mesh(const std::string& path, double length_unit,
                            std::vector<std::string>* notes = nullptr);

// The motion of a wall; its surface comes from the file that it was read from.
template <class Archive> void exchange_motion(Archive& archive, MeshWall& wall)
{
  archive("centre", wall.centre, "m");
  archive("orientation", wall.orientation);
  archive("velocity", wall.velocity, "m/s");
  archive("spin", wall.spin, "rad/s");
  archive("contact", wall.contact);
  archive("force", wall.force, "N");
  archive("torque", wall.torque, "N m");
  archive("booked_work", wall.booked_work, "J");
  archive("moved", wall.moved, "m");
  archive("turned", wall.turned, "rad");
}
} // namespace interlock::dem
