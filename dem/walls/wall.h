// Walls: rectangles that move as prescribed. The floor, the sides of the box, the front wall above
// and below its slot, and the flattening plate are all of them.
#pragma once

#include "dem/contacts/contact_properties.h"
#include "dem/contacts/contact_memory.h"

#include <string>

namespace interlock::dem
{
// Spanned by two perpendicular edges from a corner; both sides are solid, the rim is a sharp edge.
struct Wall {
  std::string name;
  Vector3 corner;                     // world [m]
  Vector3 edge1, edge2;               // perpendicular [m]
  Vector3 velocity = Vector3::Zero(); // prescribed, translation only [m/s]
  ContactProperties contact;          // with a stone
  Vector3 force = Vector3::Zero();    // of the stones on the wall, at the last step [N]
  WallId id = -1;                     // given by the engine, ascending, kept for life

  // The point of the rectangle that is nearest to `x` (world) [m].
  Vector3 nearest_point(const Vector3& x) const
  {
    const Vector3 d = x - corner;
    const double s = std::clamp(d.dot(edge1) / edge1.squaredNorm(), 0., 1.);
    const double t = std::clamp(d.dot(edge2) / edge2.squaredNorm(), 0., 1.);
    return corner + s * edge1 + t * edge2;
  }
};

// A wall at rest.
inline Wall rectangle_wall(const std::string& name, const Vector3& corner, const Vector3& edge1,
                           const Vector3& edge2, const ContactProperties& contact)
{
  Wall wall;
  wall.name = name;
  wall.corner = corner;
  wall.edge1 = edge1;
  wall.edge2 = edge2;
  wall.contact = contact;
  return wall;
}

template <class Archive> void exchange(Archive& archive, Wall& wall)
{
  archive("name", wall.name);
  archive("id", wall.id);
  archive("corner", wall.corner, "m");
  archive("edge1", wall.edge1, "m");
  archive("edge2", wall.edge2, "m");
  archive("velocity", wall.velocity, "m/s");
  archive("contact", wall.contact);
  archive("force", wall.force, "N");
}
} // namespace interlock::dem
