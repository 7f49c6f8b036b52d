#include "coupling/shear_box/shear_box.h"
#include "coupling/stones/filled_box.h"

#include <fmt/format.h>

namespace interlock::coupling
{
namespace
{
using Phase = ConsolidateStage::Phase;

void lower_plate(ShearBox& box)
{
  dem::Engine& engine = box.world().engine;
  const SpecimenParameters& p = box.specimen.parameters();
  const double height = highest_point(engine.clumps(), 0.5 * p.box.height);
  box.walls.plate =
      engine.add_wall(dem::rectangle_wall("plate", {0, 0, height}, {p.box.length, 0, 0},
                                          {0, p.box.width, 0}, box.stone_on_floor_and_plate()));
  dem::ForceControl control;
  control.axis = -dem::Vector3::UnitZ();
  control.force = box.plate_force(box.specimen.first_stress(box.parameters().normal_stress));
  control.largest_speed = p.filling.plate_speed;
  engine.control_wall(box.walls.plate, control);
}
} // namespace

StageStatus before_step(FillStage& stage, ShearBox& box, RunRecords& records)
{
  return fill(stage, box.specimen.filling(), records);
}

StageStatus before_step(ConsolidateStage& stage, ShearBox& box, RunRecords& records)
{
  World& world = box.world();
  if (waits(stage, box.specimen, records)) return running(fraction_of(stage.settling, world));
  switch (stage.phase) {
  case Phase::begin:
    lower_plate(box);
    return enter(stage, Phase::plate, box.specimen);
  case Phase::plate:
    // Stones have gone from above the plane to below it.
    world.engine.set_controlled_force(box.walls.plate,
                                      box.plate_force(box.parameters().normal_stress));
    return enter(stage, Phase::test_friction, box.specimen);
  case Phase::test_friction:
    return enter(stage, Phase::free, box.specimen);
  default:
    break;
  }
  describe_specimen(box, records);
  return finished(fmt::format("plate at {:.1f} mm, presses with {:.1f} N; porosity {:.3f}; kinetic "
                              "energy {:.2g} J",
                              1e3 * box.plate_height(), shear_forces(world.engine, box.walls).plate,
                              box.porosity(), world.kinetic_energy()));
}
} // namespace interlock::coupling
