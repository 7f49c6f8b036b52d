// What contacts remember from step to step, keyed by the ids of the bodies: how histories are kept
// in a checkpoint and how they travel with a clump that changes ranks. Only contacts that hold
// something are in it; all others start from zero.
#pragma once

#include "dem/contacts/contact_law.h"

#include <cstdint>
#include <vector>

namespace interlock::dem
{
using WallId = std::int64_t; // of a Wall, kept for life

// Of one lane (contact_lanes.h): of body 1 against body 2, world frame.
struct LaneMemory {
  Vector3 spring = Vector3::Zero();  // [m]
  Vector3 dashpot = Vector3::Zero(); // [N]
  Vector3 force = Vector3::Zero();   // of the last evaluation [N]
  double overlap = 0;                // [m]
  double crushed = 0;                // permanent part of the overlap [m]
  double tangential_stiffness = 0;   // [N/m]
  double shared_depth = 0;           // ContactShare [m]
  double gradient = 1;               // [-]
};

// Member a of one clump with member b of another one of higher id.
struct PairMemory {
  std::int64_t first = 0, second = 0;
  int a = 0, b = 0;
  LaneMemory lane;
};

// Member a of a clump with a plane wall.
struct WallMemory {
  std::int64_t clump = 0;
  WallId wall = 0;
  int a = 0;
  LaneMemory lane;
};

// The fields of MeshContact; `wall`: its number among the walls of triangles.
struct MeshMemory {
  std::int64_t clump = 0;
  int wall = 0, a = 0, number = 0;
  ContactHistory history;
  Vector3 force = Vector3::Zero(), point = Vector3::Zero(), normal = Vector3::Zero();
  double depth = 0, shared = 0; // [m]
};

// The fields of RollingSpring. `second`: clump id, WallId or number of the wall of triangles, by
// `kind` (0, 1, 2); a, b: as in RollingContact::key.
struct RollingMemory {
  int kind = 0;
  std::int64_t first = 0, second = 0;
  int a = 0, b = 0;
  Vector3 angle = Vector3::Zero();   // [rad]
  Vector3 dashpot = Vector3::Zero(); // [N m]
  double stiffness = 0;              // [N m/rad]
};

// The fields of RibContact.
struct RibMemory {
  std::int64_t clump = 0;
  int a = 0, line = 0;
  ContactHistory history;
  Vector3 force = Vector3::Zero(), point = Vector3::Zero(), arm = Vector3::Zero();
  double overlap = 0, shared = 0;  // [m]
  double tangential_stiffness = 0; // of the last step [N/m]
  int rib = -1;
  double xi = 0;
};

// Of all contacts of an engine. Pairs are sorted by (first, second, a, b), walls by (wall, clump,
// a), meshes by (clump, wall, a) and then as the engine found them, rolling by (kind, first,
// second, a, b).
struct ContactMemory {
  std::vector<PairMemory> pairs;
  std::vector<WallMemory> walls;
  std::vector<MeshMemory> meshes;
  std::vector<RollingMemory> rolling;
};

template <class Archive> void exchange(Archive& archive, ContactHistory& history)
{
  archive("spring", history.spring, "m");
  archive("overlap", history.overlap, "m");
  archive("dashpot", history.dashpot, "N");
  archive("crushed", history.crushed, "m");
}
template <class Archive> void exchange(Archive& archive, LaneMemory& lane)
{
  archive("spring", lane.spring, "m");
  archive("dashpot", lane.dashpot, "N");
  archive("force", lane.force, "N");
  archive("overlap", lane.overlap, "m");
  archive("crushed", lane.crushed, "m");
  archive("tangential_stiffness", lane.tangential_stiffness, "N/m");
  archive("shared_depth", lane.shared_depth, "m");
  archive("gradient", lane.gradient);
}
template <class Archive> void exchange(Archive& archive, PairMemory& pair)
{
  archive("first", pair.first);
  archive("second", pair.second);
  archive("a", pair.a);
  archive("b", pair.b);
  exchange(archive, pair.lane);
}
template <class Archive> void exchange(Archive& archive, WallMemory& contact)
{
  archive("clump", contact.clump);
  archive("wall", contact.wall);
  archive("a", contact.a);
  exchange(archive, contact.lane);
}
template <class Archive> void exchange(Archive& archive, MeshMemory& contact)
{
  archive("clump", contact.clump);
  archive("wall", contact.wall);
  archive("a", contact.a);
  archive("number", contact.number);
  archive("history", contact.history);
  archive("force", contact.force, "N");
  archive("point", contact.point, "m");
  archive("normal", contact.normal);
  archive("depth", contact.depth, "m");
  archive("shared", contact.shared, "m");
}
template <class Archive> void exchange(Archive& archive, RollingMemory& spring)
{
  archive("kind", spring.kind);
  archive("first", spring.first);
  archive("second", spring.second);
  archive("a", spring.a);
  archive("b", spring.b);
  archive("angle", spring.angle, "rad");
  archive("dashpot", spring.dashpot, "N m");
  archive("stiffness", spring.stiffness, "N m/rad");
}
template <class Archive> void exchange(Archive& archive, RibMemory& contact)
{
  archive("clump", contact.clump);
  archive("a", contact.a);
  archive("line", contact.line);
  archive("history", contact.history);
  archive("force", contact.force, "N");
  archive("point", contact.point, "m");
  archive("arm", contact.arm, "m");
  archive("overlap", contact.overlap, "m");
  archive("shared", contact.shared, "m");
  archive("tangential_stiffness", contact.tangential_stiffness, "N/m");
  archive("rib", contact.rib);
  archive("xi", contact.xi);
}
template <class Archive> void exchange(Archive& archive, ContactMemory& memory)
{
  archive("pairs", memory.pairs);
  archive("walls", memory.walls);
  archive("meshes", memory.meshes);
  archive("rolling", memory.rolling);
}
} // namespace interlock::dem
