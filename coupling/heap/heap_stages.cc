#include "coupling/heap/heap_stages.h"

#include "coupling/heap/heap.h"
#include "coupling/run/run_failure.h"
#include "dem/engine/insertion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace interlock::coupling
{
namespace
{
// So many steps between two looks at the kinetic energy and at stones that rolled away.
constexpr int steps_between_looks = 200;

// False when the stone is not due yet or another one is in its place.
bool let_go(const Release& planned, Heap& heap)
{
  World& world = heap.world();
  const double time = world.clock.time(), dt = world.clock.dt;
  Release release = planned;
  if (release.time > time) return false;
  // The plan's time lies within the last step, unless another stone was in the way.
  const double delay = time - release.time;
  const bool late = delay > 1.5 * dt;
  if (late) release.time = time;
  const Stone& stone = heap.stones[release.stone];
  const FallingStone falling = falling_stone(stone, release, time, dt, heap.parameters().gravity);
  // A stone of any rank may be in the way.
  if (world.any(!dem::place_is_free(world.engine.clumps(), world.engine.walls(), stone.shape,
                                    falling.pose.position, falling.pose.orientation)))
    return false;
  world.make_whole();
  if (late) heap.longest_delay = std::max(heap.longest_delay, delay);
  world.engine.add_clump(release.stone, heap.parameters().stones.density, falling.pose.position,
                         falling.pose.orientation, falling.velocity);
  return true;
}

bool is_time_to_look(const Heap& heap)
{
  return heap.world().clock.step % steps_between_looks == 0;
}
} // namespace

StageStatus before_step(DropStage& stage, Heap& heap, RunRecords&)
{
  const int all = static_cast<int>(heap.releases.size());
  if (is_time_to_look(heap)) heap.drop_lost_stones();
  while (stage.released < all && let_go(heap.releases[stage.released], heap)) ++stage.released;
  if (stage.released == all) return finished(fmt::format("{} stones let go", all));
  // Twice the planned time and a while: the planned drop has long been over.
  constexpr double patience = 10; // [s]
  if (heap.world().clock.time() > 2 * heap.releases.back().time + patience)
    throw RunFailure(
        fmt::format("The place of the next stone does not become free until t = {:.3g} "
                    "s: the heap has grown up to Drop/Height.",
                    heap.world().clock.time()));
  return running(static_cast<double>(stage.released) / all,
                 heap.is_record_due() ? Look::at_everything : Look::none);
}

void after_step(DropStage&, Heap& heap, RunRecords&)
{
  heap.note_overlap();
}

void unite_notes(DropStage&, Heap& heap)
{
  heap.unite_notes();
}

void unite_notes(HeapSettleStage&, Heap& heap)
{
  heap.unite_notes();
}

void look(DropStage&, Heap& heap, RunRecords& records)
{
  heap.record_when_due(records);
}

StageStatus before_step(HeapSettleStage& stage, Heap& heap, RunRecords& records)
{
  World& world = heap.world();
  const DropParameters& drop = heap.parameters().drop;
  if (!stage.begun) stage.begun = true, stage.begin = world.clock.time();
  if (stage.recorded)
    return finished(fmt::format("kinetic energy {:.2g} J {:.2f} s after the last stone was let go",
                                world.kinetic_energy(), heap.at_rest_time));
  const double fall = std::sqrt(2 * drop.height / heap.parameters().gravity);
  const double limit = fall + drop.settling_time_limit;
  const double waited = world.clock.time() - stage.begin;
  if (is_time_to_look(heap)) heap.drop_lost_stones();
  if (is_time_to_look(heap) && waited >= fall) {
    const double target = drop.kinetic_energy_ratio * world.weight() * heap.mean_size;
    stage.kinetic = world.kinetic_energy();
    stage.still = stage.kinetic < target;
    if (!stage.still && waited >= limit)
      records.warn(fmt::format("The heap was not at rest {:.3g} s after the last stone was let go: "
                               "its kinetic energy is {:.2g} J, at rest means below {:.2g} J.",
                               waited, stage.kinetic, target));
    if (stage.still || waited >= limit) {
      // One more step, for its record.
      stage.still = true;
      heap.at_rest_time = waited;
    }
  }
  return running(std::min(0.99, waited / limit),
                 stage.still || heap.is_record_due() ? Look::at_everything : Look::none);
}

void after_step(HeapSettleStage&, Heap& heap, RunRecords&)
{
  heap.note_overlap();
}

void look(HeapSettleStage& stage, Heap& heap, RunRecords& records)
{
  heap.record_when_due(records, stage.still);
  stage.recorded = stage.still;
}
} // namespace interlock::coupling
