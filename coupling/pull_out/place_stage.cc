#include "coupling/pull_out/protocol.h"
#include "coupling/pull_out/pull_out.h"

#include <fmt/format.h>

#include <algorithm>

namespace interlock::coupling
{
namespace
{
using dem::Vector3;

bool overlaps(const dem::Clumps& clumps, int i, const std::vector<dem::Rib>& ribs)
{
  const std::vector<dem::Sphere>& spheres = clumps.shape_of(i).spheres;
  for (std::size_t a = 0; a < spheres.size(); ++a) {
    const Vector3 x = clumps.position[i] + clumps.member_offset(i, static_cast<int>(a));
    if (std::any_of(ribs.begin(), ribs.end(), [&](const dem::Rib& rib) {
          return dem::rib_proximity(rib, x, spheres[a].radius).overlap > 0;
        }))
      return true;
  }
  return false;
}

// Stones that overlap a rib.
std::vector<bool> in_the_way(const PullOut& experiment, const RibTransfer& geogrid)
{
  const dem::Clumps& clumps = experiment.world().engine.clumps();
  const std::vector<dem::Rib> ribs = geogrid.ribs().all();
  std::vector<bool> result(clumps.size());
  for (int i = 0; i < clumps.size(); ++i) {
    const double reach = clumps.bounding_radius(i) + experiment.sheet().thickness;
    const bool near = std::abs(clumps.position[i].z() - experiment.geogrid_height()) <= reach;
    result[i] = near && overlaps(clumps, i, ribs);
  }
  return result;
}

void place(PlaceStage& stage, PullOut& experiment)
{
  World& world = experiment.world();
  world.make_whole();
  std::unique_ptr<RibTransfer> geogrid = experiment.make_geogrid();
  const std::vector<bool> removed = in_the_way(experiment, *geogrid);
  stage.taken_out = static_cast<int>(std::count(removed.begin(), removed.end(), true));
  world.remove(removed);
  open_slot(world.engine, experiment.parameters().box, experiment.stone_on_box(),
            experiment.geogrid_height(), experiment.walls);
  world.place_geogrid(std::move(geogrid));
  experiment.first_above = world.engine.clumps().next_id();
  stage.placed = true;
  stage.settling = begin_settling(world, settling_after_removal, loosely_still);
}

std::string description(const RibTransfer& geogrid)
{
  if (geogrid.rigid()) return "rigid";
  return fmt::format("stable step of the beams alone {:.2f} us",
                     1e6 * geogrid.dynamics().stable_step());
}
} // namespace

StageStatus before_step(PlaceStage& stage, PullOut& experiment, RunRecords& records)
{
  experiment.drop_lost_stones();
  if (!stage.placed) place(stage, experiment);
  if (!experiment.has_settled(stage.settling, records))
    return running(fraction_of(stage.settling, experiment.world()));
  experiment.world().make_whole();
  const RibTransfer& geogrid = *experiment.world().geogrid();
  return finished(fmt::format("{} beam elements, {:.1f} g, {}; {} stones in the way of ribs were "
                              "taken out",
                              geogrid.lattice().n_elements(), 1e3 * geogrid.mass(),
                              description(geogrid), stage.taken_out));
}
} // namespace interlock::coupling
