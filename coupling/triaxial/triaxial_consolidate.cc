#include "coupling/stones/filled_box.h"
#include "coupling/triaxial/triaxial.h"

#include <fmt/format.h>

namespace interlock::coupling
{
namespace
{
using Phase = ConsolidateStage::Phase;

// Of plate and sides [Pa].
double pressure_in(Phase phase, const Triaxial& test)
{
  const double cell = test.parameters().cell_pressure;
  return compacts(phase) ? test.specimen.first_stress(cell) : cell;
}

void compact_with(Triaxial& test, dem::WallId wall)
{
  keep_pressure(test.world().engine, test.walls, wall, pressure_in(Phase::plate, test),
                test.specimen.parameters().filling.plate_speed);
}
} // namespace

StageStatus before_step(FillStage& stage, Triaxial& test, RunRecords& records)
{
  return fill(stage, test.specimen.filling(), records);
}

StageStatus before_step(ConsolidateStage& stage, Triaxial& test, RunRecords& records)
{
  World& world = test.world();
  const BoxParameters& box = test.specimen.parameters().box;
  if (waits(stage, test.specimen, records)) return running(fraction_of(stage.settling, world));
  switch (stage.phase) {
  case Phase::begin:
    add_plate(world.engine, test.walls, box,
              highest_point(world.engine.clumps(), 0.5 * box.height));
    compact_with(test, test.walls.plate);
    return enter(stage, Phase::plate, test.specimen);
  case Phase::plate:
    world.engine.set_gravity(0);
    compact_with(test, test.walls.x_moving);
    compact_with(test, test.walls.y_moving);
    return enter(stage, Phase::sides, test.specimen);
  case Phase::sides:
    return enter(stage, Phase::test_friction, test.specimen);
  case Phase::test_friction:
    return enter(stage, Phase::free, test.specimen);
  case Phase::free:
    break;
  }
  describe_specimen(test, records);
  const dem::Vector3 size = 1e3 * test.size(), stress = test.stresses();
  return finished(fmt::format("{:.1f} x {:.1f} x {:.1f} mm at {:.4g}, {:.4g} and {:.4g} Pa; "
                              "porosity {:.3f}; kinetic energy {:.2g} J",
                              size.x(), size.y(), size.z(), stress.x(), stress.y(), stress.z(),
                              test.porosity(), world.kinetic_energy()));
}

void after_step(ConsolidateStage& stage, Triaxial& test, RunRecords&)
{
  if (stage.phase != Phase::begin)
    follow_areas(test.world().engine, test.walls, pressure_in(stage.phase, test));
}
} // namespace interlock::coupling
