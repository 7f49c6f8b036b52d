#include "coupling/triaxial/triaxial.h"

#include <fmt/format.h>

namespace interlock::coupling
{
namespace
{
using dem::Vector3;

double axial_strain(const CompressStage& stage, const Triaxial& test)
{
  return 1 - test.size().z() / stage.size_at_begin.z();
}

void begin_compression(CompressStage& stage, Triaxial& test)
{
  dem::Engine& engine = test.world().engine;
  stage.size_at_begin = test.size();
  engine.release_wall(test.walls.plate);
  engine.wall(test.walls.plate).velocity = Vector3::Zero();
}

void record(CompressStage& stage, Triaxial& test, RunRecords& records)
{
  const World& world = test.world();
  const Vector3 size = test.size();
  const Vector3 mean = begin_record(stage.motion, test.specimen, test.stresses(),
                                    stage.size_at_begin.z() - size.z());
  const double x = mean.x(), y = mean.y(), z = mean.z();
  stage.strains.push_back(axial_strain(stage, test));
  stage.heights.push_back(size.z());
  stage.volumes.push_back(size.prod());
  stage.across_x.push_back(x);
  stage.across_y.push_back(y);
  stage.axial.push_back(z);
  end_record(stage.motion, world,
             {world.clock.time(), stage.strains.back(), z, x, y, x + y > 0 ? 2 * z / (x + y) : 0,
              size.prod() / stage.size_at_begin.prod() - 1, test.porosity(), size.x(), size.y(),
              size.z(), world.engine.wall(test.walls.plate).force.z(),
              -world.engine.wall(test.walls.floor).force.z()},
             records);
}
} // namespace

StageStatus before_step(CompressStage& stage, Triaxial& test, RunRecords&)
{
  if (stage.motion.over)
    return finished(fmt::format("axial strain {:.1f} %, {:.4g} Pa on the plate at the end, volume "
                                "{:+.2f} %",
                                100 * stage.strains.back(), stage.axial.back(),
                                100 * (stage.volumes.back() / stage.volumes.front() - 1)));
  if (begins(stage.motion, test.world())) begin_compression(stage, test);
  const CompressionParameters& p = test.parameters().compression;
  return go_on(stage.motion, test.world(), axial_strain(stage, test) / p.strain, p.ramp_time,
               test.parameters().output);
}

void unite_notes(CompressStage& stage, Triaxial& test)
{
  unite_overlaps(stage.motion, test.world());
}

void look(CompressStage& stage, Triaxial& test, RunRecords& records)
{
  World& world = test.world();
  const CompressionParameters& p = test.parameters().compression;
  if (stage.motion.record_due) record(stage, test, records);
  const double share = end_look(stage.motion, world, p.ramp_time, records);
  if (share < 0) return;
  const double speed = p.strain_rate * stage.size_at_begin.z() * share;
  world.engine.wall(test.walls.plate).velocity = {0, 0, -speed};
}

void after_step(CompressStage& stage, Triaxial& test, RunRecords&)
{
  World& world = test.world();
  const double dt = world.clock.dt;
  note_overlap(stage.motion, world);
  stage.motion.impulse += dt * test.stresses();
  stage.motion.impulse_time += dt;
  follow_areas(world.engine, test.walls, test.parameters().cell_pressure);
}
} // namespace interlock::coupling
