#include "coupling/stones/filled_box.h"
#include "coupling/triaxial/triaxial.h"

#include <fmt/format.h>

#include <algorithm>

namespace interlock::coupling
{
namespace
{
using Phase = IsotropicStage::Phase;

bool compacts(Phase phase)
{
  return phase == Phase::plate || phase == Phase::cell;
}

// Of plate and sides [Pa].
double pressure_in(Phase phase, const TriaxialParameters& p)
{
  return compacts(phase) ? std::max(p.compaction_stress, p.cell_pressure) : p.cell_pressure;
}

void keep_pressure_of(Phase phase, Triaxial& test, dem::WallId wall)
{
  const TriaxialParameters& p = test.parameters();
  keep_pressure(test.world().engine, test.walls, wall, pressure_in(phase, p),
                p.filling.plate_speed);
}

// The phase that follows; what begins it is done here.
Phase next_phase(Phase phase, Triaxial& test)
{
  dem::Engine& engine = test.world().engine;
  const BoxParameters& box = test.parameters().box;
  switch (phase) {
  case Phase::begin:
    add_plate(engine, test.walls, box, highest_point(engine.clumps(), 0.5 * box.height));
    keep_pressure_of(Phase::plate, test, test.walls.plate);
    return Phase::plate;
  case Phase::plate:
    engine.set_gravity(0);
    keep_pressure_of(Phase::cell, test, test.walls.x_moving);
    keep_pressure_of(Phase::cell, test, test.walls.y_moving);
    return Phase::cell;
  case Phase::cell:
    engine.stone_contact().friction = test.parameters().contact.stone_friction;
    return Phase::test_friction;
  default:
    engine.set_local_damping(0);
    return Phase::free;
  }
}

Settling wait_in(Phase phase, const World& world)
{
  return begin_settling(world, compacts(phase) ? settling_below_load : settling_after_removal,
                        compacts(phase) ? loosely_still : still);
}
} // namespace

StageStatus before_step(FillStage& stage, Triaxial& test, RunRecords& records)
{
  return fill(stage, test.filling(), records);
}

StageStatus before_step(IsotropicStage& stage, Triaxial& test, RunRecords& records)
{
  World& world = test.world();
  const bool waits = stage.phase != Phase::begin;
  if (waits && !has_settled(stage.settling, world, test.filling().settling, records))
    return running(fraction_of(stage.settling, world));
  world.make_whole();
  if (stage.phase != Phase::free) {
    stage.phase = next_phase(stage.phase, test);
    stage.settling = wait_in(stage.phase, world);
    return running(0);
  }
  describe_specimen(test, records);
  const dem::Vector3 size = 1e3 * test.size(), stress = test.stresses();
  return finished(fmt::format("{:.1f} x {:.1f} x {:.1f} mm at {:.4g}, {:.4g} and {:.4g} Pa; "
                              "porosity {:.3f}; kinetic energy {:.2g} J",
                              size.x(), size.y(), size.z(), stress.x(), stress.y(), stress.z(),
                              test.porosity(), world.kinetic_energy()));
}

void after_step(IsotropicStage& stage, Triaxial& test, RunRecords&)
{
  if (stage.phase != Phase::begin)
    follow_areas(test.world().engine, test.walls, pressure_in(stage.phase, test.parameters()));
}
} // namespace interlock::coupling
