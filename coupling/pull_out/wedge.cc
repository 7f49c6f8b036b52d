#include "coupling/pull_out/wedge.h"

#include "coupling/loop/rib_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <utility>

namespace interlock::coupling
{
namespace
{
using dem::Vector3;

// A line of ribs, a wall or a stone, by line, id of the wall or id of the clump.
enum class Kind { line, wall, stone };
using Partner = std::pair<Kind, std::int64_t>;

struct Squeezed {
  double deepest = 0; // overlap [m]
  std::map<Partner, Vector3> forces;
  void add(double overlap, Partner partner, const Vector3& force)
  {
    deepest = std::max(deepest, overlap);
    forces.try_emplace(partner, Vector3::Zero()).first->second += force;
  }
  // Strongest first.
  std::vector<std::pair<double, Partner>> strengths() const
  {
    std::vector<std::pair<double, Partner>> found;
    for (const auto& [partner, force] : forces) found.emplace_back(force.norm(), partner);
    std::stable_sort(found.begin(), found.end(),
                     [](const auto& p, const auto& q) { return p.first > q.first; });
    return found;
  }
};

// Of the clumps that this rank moves: all their contacts are here.
std::map<int, Squeezed> squeezed_stones(const World& world)
{
  const dem::Engine& engine = world.engine;
  const dem::Clumps& clumps = engine.clumps();
  std::map<int, Squeezed> stones;
  const auto add = [&](int i, double overlap, Partner partner, const Vector3& force) {
    if (clumps.ghost[i] == 0) stones[i].add(overlap, partner, force);
  };
  for (const dem::SphereContact& c : engine.sphere_contacts()) {
    if (!c.touching) continue;
    add(c.i, c.overlap, {Kind::stone, clumps.id[c.j]}, c.force);
    add(c.j, c.overlap, {Kind::stone, clumps.id[c.i]}, -c.force);
  }
  for (const dem::WallContact& c : engine.wall_contacts())
    if (c.touching) add(c.i, c.overlap, {Kind::wall, engine.walls()[c.wall].id}, c.force);
  for (const dem::RibContact& c : world.ribs.rib_contacts().contacts())
    if (c.overlap > 0) add(c.i, c.overlap, {Kind::line, c.line}, c.force);
  return stones;
}

std::string name_of(const World& world, Partner partner)
{
  if (partner.first == Kind::line)
    return name_of_line(world.geogrid()->lattice(), static_cast<int>(partner.second));
  if (partner.first == Kind::wall)
    return "the wall '" + world.engine.wall(partner.second).name + "'";
  return fmt::format("stone {}", partner.second);
}
} // namespace

std::string wedged_stone(const World& world, double bound)
{
  double most = 0; // force of the second strongest partner [N]
  int stone = -1;
  const std::map<int, Squeezed> stones = squeezed_stones(world);
  for (const auto& [i, squeezed] : stones) {
    if (squeezed.deepest <= bound || squeezed.forces.size() < 2) continue;
    const double second = squeezed.strengths()[1].first;
    if (second > most) most = second, stone = i;
  }
  std::string sentence;
  if (world.largest(most) == most && stone >= 0) {
    const auto partners = stones.at(stone).strengths();
    const Vector3 x = 1e3 * world.engine.clumps().position[stone];
    sentence = fmt::format("stone {} (centre at x = {:.0f}, y = {:.0f}, z = {:.0f} mm) between {} "
                           "({:.2f} kN) and {} ({:.2f} kN)",
                           world.engine.clumps().id[stone], x.x(), x.y(), x.z(),
                           name_of(world, partners[0].second), 1e-3 * partners[0].first,
                           name_of(world, partners[1].second), 1e-3 * partners[1].first);
  }
  return world.first_sentence(sentence);
}
} // namespace interlock::coupling
