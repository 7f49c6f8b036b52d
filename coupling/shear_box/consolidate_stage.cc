#include "coupling/shear_box/shear_box.h"
#include "coupling/stones/filled_box.h"

#include <fmt/format.h>

#include <algorithm>

namespace interlock::coupling
{
namespace
{
using Phase = ConsolidateStage::Phase;

void lower_plate(ShearBox& box)
{
  dem::Engine& engine = box.world().engine;
  const BoxParameters& size = box.parameters().box;
  const double height = highest_point(engine.clumps(), 0.5 * size.height);
  box.walls.plate =
      engine.add_wall(dem::rectangle_wall("plate", {0, 0, height}, {size.length, 0, 0},
                                          {0, size.width, 0}, box.stone_on_floor_and_plate()));
  dem::ForceControl control;
  control.axis = -dem::Vector3::UnitZ();
  const ShearBoxParameters& p = box.parameters();
  control.force = box.plate_force(std::max(p.normal_stress, p.compaction_stress));
  control.largest_speed = box.parameters().filling.plate_speed;
  engine.control_wall(box.walls.plate, control);
}
} // namespace

StageStatus before_step(FillStage& stage, ShearBox& box, RunRecords& records)
{
  return fill(stage, box.filling(), records);
}

StageStatus before_step(ConsolidateStage& stage, ShearBox& box, RunRecords& records)
{
  World& world = box.world();
  const auto wait = [&](Phase phase, double least, double looseness) {
    stage.phase = phase;
    stage.settling = begin_settling(world, least, looseness);
  };
  if (stage.phase == Phase::begin) {
    world.make_whole();
    lower_plate(box);
    wait(Phase::loading, settling_below_load, loosely_still);
  }
  if (!has_settled(stage.settling, world, box.filling().settling, records))
    return running(fraction_of(stage.settling, world));
  world.make_whole();
  if (stage.phase == Phase::loading) {
    // Stones have gone from above the plane to below it.
    world.engine.set_controlled_force(box.walls.plate,
                                      box.plate_force(box.parameters().normal_stress));
    world.engine.stone_contact().friction = box.parameters().contact.stone_friction;
    wait(Phase::test_friction, settling_after_removal, still);
    return running(0.3);
  }
  if (stage.phase == Phase::test_friction) {
    world.engine.set_local_damping(0);
    wait(Phase::free, settling_after_removal, still);
    return running(0.6);
  }
  describe_specimen(box, records);
  return finished(fmt::format("plate at {:.1f} mm, presses with {:.1f} N; porosity {:.3f}; kinetic "
                              "energy {:.2g} J",
                              1e3 * box.plate_height(), shear_forces(world.engine, box.walls).plate,
                              box.porosity(), world.kinetic_energy()));
}
} // namespace interlock::coupling
