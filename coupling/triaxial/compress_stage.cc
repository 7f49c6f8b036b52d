#include "coupling/stones/soft_start.h"
#include "coupling/triaxial/triaxial.h"

#include <fmt/format.h>

namespace interlock::coupling
{
namespace
{
using dem::Vector3;

bool ramping(const CompressStage& stage, const Triaxial& test)
{
  // One step more, which reaches the full speed.
  const World& world = test.world();
  return world.clock.time() - stage.begin <=
         test.parameters().compression.ramp_time + 2 * world.clock.dt;
}

double axial_strain(const CompressStage& stage, const Triaxial& test)
{
  return 1 - test.size().z() / stage.size_at_begin.z();
}

void begin_compression(CompressStage& stage, Triaxial& test)
{
  World& world = test.world();
  world.make_whole();
  stage.begun = true;
  stage.begin = world.clock.time();
  stage.size_at_begin = test.size();
  world.engine.release_wall(test.walls.plate);
  world.engine.wall(test.walls.plate).velocity = Vector3::Zero();
}

void add_means(CompressStage& stage, const Triaxial& test)
{
  // The first record has no step behind it.
  const Vector3 mean =
      stage.impulse_time > 0 ? Vector3(stage.stress_impulse / stage.impulse_time) : test.stresses();
  stage.across_x.push_back(mean.x());
  stage.across_y.push_back(mean.y());
  stage.axial.push_back(mean.z());
  stage.stress_impulse.setZero();
  stage.impulse_time = 0;
}

void record(CompressStage& stage, Triaxial& test, RunRecords& records)
{
  World& world = test.world();
  const Vector3 size = test.size();
  stage.ledger = world.ledger();
  if (stage.records == 0) stage.ledger_at_begin = stage.ledger;
  stage.strains.push_back(axial_strain(stage, test));
  stage.heights.push_back(size.z());
  stage.volumes.push_back(size.prod());
  add_means(stage, test);
  note_record(stage.watch, world, stage.size_at_begin.z() - size.z(), test.mean_sphere_radius);
  const double x = stage.across_x.back(), y = stage.across_y.back(), z = stage.axial.back();
  std::vector<History::Cell> row = {world.clock.time(),
                                    stage.strains.back(),
                                    z,
                                    x,
                                    y,
                                    x + y > 0 ? 2 * z / (x + y) : 0,
                                    size.prod() / stage.size_at_begin.prod() - 1,
                                    test.porosity(),
                                    size.x(),
                                    size.y(),
                                    size.z(),
                                    world.engine.wall(test.walls.plate).force.z(),
                                    -world.engine.wall(test.walls.floor).force.z(),
                                    static_cast<double>(world.touching_spheres()),
                                    world.largest(world.largest_overlap())};
  append_ledger(row, stage.ledger);
  records.add(row);
  ++stage.records;
}
} // namespace

StageStatus before_step(CompressStage& stage, Triaxial& test, RunRecords&)
{
  if (stage.over)
    return finished(fmt::format("axial strain {:.1f} %, {:.4g} Pa on the plate at the end, volume "
                                "{:+.2f} %",
                                100 * stage.strains.back(), stage.axial.back(),
                                100 * (stage.volumes.back() / stage.volumes.front() - 1)));
  if (!stage.begun) begin_compression(stage, test);
  const OutputParameters& output = test.parameters().output;
  const double progress = axial_strain(stage, test) / test.parameters().compression.strain;
  stage.is_last = progress >= 1;
  stage.record_due = stage.is_last || progress * output.records >= stage.records;
  stage.frame_due =
      output.field_frames > 0 && (stage.is_last || progress * output.field_frames >= stage.frames);
  if (stage.is_last || stage.frame_due) return running(progress, Look::at_everything);
  return running(progress, stage.record_due || ramping(stage, test) ? Look::at_part : Look::none);
}

void unite_notes(CompressStage& stage, Triaxial& test)
{
  stage.watch.largest_overlap = test.world().largest(stage.watch.largest_overlap);
}

void look(CompressStage& stage, Triaxial& test, RunRecords& records)
{
  World& world = test.world();
  stage.over = stage.is_last;
  if (stage.record_due) record(stage, test, records);
  if (stage.frame_due) {
    records.add_frame(world);
    ++stage.frames;
  }
  // Between forces and motion: the work of a wall is booked with the velocity that it moves with.
  if (!ramping(stage, test)) return;
  const CompressionParameters& p = test.parameters().compression;
  const double speed = p.strain_rate * stage.size_at_begin.z() *
                       soft_start(world.clock.time() - stage.begin, p.ramp_time);
  world.engine.wall(test.walls.plate).velocity = {0, 0, -speed};
}

void after_step(CompressStage& stage, Triaxial& test, RunRecords&)
{
  World& world = test.world();
  const double dt = world.clock.dt;
  note_overlap(stage.watch, world);
  stage.stress_impulse += dt * test.stresses();
  stage.impulse_time += dt;
  follow_areas(world.engine, test.walls, test.parameters().cell_pressure);
}
} // namespace interlock::coupling
