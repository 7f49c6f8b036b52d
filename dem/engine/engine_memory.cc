// The state of an engine that lies in its caches and privates: taken out by ids, and put back.
#include "dem/engine/engine.h"

#include <stdexcept>
#include <string>

namespace interlock::dem
{
namespace
{
int index_of(const Clumps& clumps, std::int64_t id)
{
  const int i = clumps.index_of(id);
  if (i < 0)
    throw std::logic_error("A contact belongs to clump " + std::to_string(id) +
                           ", which is not there.");
  return i;
}

void require_member(const Clumps& clumps, int i, int a)
{
  if (a < 0 || a >= static_cast<int>(clumps.shape_of(i).spheres.size()))
    throw std::logic_error("A contact belongs to member " + std::to_string(a) + " of clump " +
                           std::to_string(clumps.id[i]) + ", which is not there.");
}
} // namespace

ContactMemory Engine::memory() const
{
  ContactMemory memory;
  const ContactLanes& pairs = lists_.pair_lanes();
  for (int k = 0; k < pairs.size(); ++k)
    if (pairs.holds_something(k))
      memory.pairs.push_back({clumps_.id[pairs.key(k).i], clumps_.id[pairs.key(k).j],
                              pairs.key(k).a, pairs.key(k).b, pairs.memory(k)});
  const ContactLanes& at_walls = lists_.wall_lanes();
  for (std::size_t w = 0; w < lists_.wall_segments().size() && w < walls_.size(); ++w) {
    const WallSegment segment = lists_.wall_segments()[w];
    for (int k = segment.begin; k < segment.end; ++k)
      if (at_walls.holds_something(k))
        memory.walls.push_back(
            {clumps_.id[at_walls.key(k).i], walls_[w].id, at_walls.key(k).a, at_walls.memory(k)});
  }
  for (const MeshContact& c : mesh_contacts_.contacts())
    memory.meshes.push_back({clumps_.id[c.i], c.wall, c.a, c.number, c.history, c.force, c.point,
                             c.normal, c.depth, c.shared});
  for (const RollingSpring& s : rolling_.springs()) {
    std::int64_t second = s.key[2];
    if (s.key[0] == 0) second = clumps_.id[s.key[2]];
    if (s.key[0] == 1) second = walls_[s.key[2]].id;
    memory.rolling.push_back({s.key[0], clumps_.id[s.key[1]], second, s.key[3], s.key[4], s.angle,
                              s.dashpot, s.stiffness});
  }
  return memory;
}

void Engine::restore(const ContactMemory& memory)
{
  using Remembered = NeighbourLists::Remembered;
  std::vector<Remembered> pairs, at_walls;
  for (const PairMemory& c : memory.pairs) {
    const int i = index_of(clumps_, c.first), j = index_of(clumps_, c.second);
    require_member(clumps_, i, c.a);
    require_member(clumps_, j, c.b);
    pairs.push_back({{i, j, c.a, c.b}, c.lane});
  }
  for (const WallMemory& c : memory.walls) {
    const int i = index_of(clumps_, c.clump);
    require_member(clumps_, i, c.a);
    at_walls.push_back({{i, static_cast<int>(wall_index(c.wall)), c.a, 0}, c.lane});
  }
  lists_.restore(clumps_, static_cast<int>(walls_.size()), pairs, at_walls);

  std::vector<MeshContact> meshes;
  for (const MeshMemory& c : memory.meshes) {
    MeshContact contact;
    contact.i = index_of(clumps_, c.clump);
    contact.wall = c.wall, contact.a = c.a, contact.number = c.number;
    contact.history = c.history;
    contact.force = c.force, contact.point = c.point, contact.normal = c.normal;
    contact.depth = c.depth, contact.shared = c.shared;
    require_member(clumps_, contact.i, contact.a);
    meshes.push_back(contact);
  }
  mesh_contacts_.restore(std::move(meshes));

  std::vector<RollingSpring> springs;
  for (const RollingMemory& s : memory.rolling) {
    int second = static_cast<int>(s.second);
    if (s.kind == 0) second = index_of(clumps_, s.second);
    if (s.kind == 1) second = static_cast<int>(wall_index(s.second));
    springs.push_back(
        {{s.kind, index_of(clumps_, s.first), second, s.a, s.b}, s.angle, s.dashpot, s.stiffness});
  }
  rolling_.restore(std::move(springs));
}

void Engine::replace_clumps(const std::vector<ClumpState>& states, const ContactMemory& memory)
{
  clumps_.assign(states);
  lists_.invalidate();
  mesh_contacts_.invalidate();
  restore(memory);
}

std::vector<Engine::MeshWallMotion> Engine::mesh_wall_motions() const
{
  std::vector<MeshWallMotion> motions;
  for (const MeshWall& wall : mesh_walls_) motions.push_back({wall});
  return motions;
}

void Engine::set_mesh_wall_motions(const std::vector<MeshWallMotion>& motions)
{
  if (motions.size() != mesh_walls_.size())
    throw std::logic_error("A state has " + std::to_string(motions.size()) +
                           " walls of triangles, but the case has " +
                           std::to_string(mesh_walls_.size()) + ".");
  for (std::size_t w = 0; w < motions.size(); ++w) {
    MeshWall wall = motions[w].wall;
    wall.name = mesh_walls_[w].name;
    wall.surface = mesh_walls_[w].surface;
    mesh_walls_[w] = wall;
  }
}
} // namespace interlock::dem
