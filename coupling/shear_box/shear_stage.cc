#include "coupling/shear_box/shear_box.h"
#include "coupling/stones/soft_start.h"

#include <fmt/format.h>

namespace interlock::coupling
{
namespace
{
bool ramping(const ShearStage& stage, const ShearBox& box)
{
  // One step more, which reaches the full speed.
  const World& world = box.world();
  return world.clock.time() - stage.begin <= box.parameters().shear.ramp_time + 2 * world.clock.dt;
}

// On the plane between the halves, from the balance of the stones above it [N].
double normal_force(const ShearForces& forces, const ShearStage& stage)
{
  return forces.plate + stage.weight_above + forces.friction;
}

void add_means(ShearStage& stage, const ShearForces& now)
{
  const double time = stage.impulse_time;
  // The first record has no step behind it.
  const bool first = time == 0;
  stage.shear_forces.push_back(first ? now.shear : stage.shear_impulse / time);
  stage.normal_forces.push_back(first ? normal_force(now, stage) : stage.normal_impulse / time);
  stage.plate_forces.push_back(first ? now.plate : stage.plate_impulse / time);
  stage.shear_impulse = stage.normal_impulse = stage.plate_impulse = stage.impulse_time = 0;
}

void record(ShearStage& stage, ShearBox& box, RunRecords& records)
{
  World& world = box.world();
  stage.ledger = world.ledger();
  if (stage.records == 0) stage.ledger_at_begin = stage.ledger;
  stage.displacements.push_back(displacement(world.engine, box.walls));
  stage.heights.push_back(box.plate_height());
  add_means(stage, shear_forces(world.engine, box.walls));
  note_record(stage.watch, world, stage.displacements.back(), box.mean_sphere_radius);
  const double shear = stage.shear_forces.back(), normal = stage.normal_forces.back(),
               plate = stage.plate_forces.back();
  std::vector<History::Cell> row = {world.clock.time(),
                                    stage.displacements.back(),
                                    shear,
                                    normal,
                                    plate,
                                    normal > 0 ? shear / normal : 0,
                                    stage.heights.back() - stage.plate_at_begin,
                                    box.porosity(),
                                    normal - plate - stage.weight_above,
                                    static_cast<double>(world.touching_spheres()),
                                    world.largest(world.largest_overlap())};
  append_ledger(row, stage.ledger);
  records.add(row);
  ++stage.records;
}
} // namespace

StageStatus before_step(ShearStage& stage, ShearBox& box, RunRecords&)
{
  World& world = box.world();
  if (stage.over)
    return finished(fmt::format("{:.1f} mm, shear force at the end {:.0f} N, plate {:+.2f} mm",
                                1e3 * stage.displacements.back(), stage.shear_forces.back(),
                                1e3 * (stage.heights.back() - stage.plate_at_begin)));
  if (!stage.begun) {
    world.make_whole();
    stage.begun = true;
    stage.begin = world.clock.time();
    stage.plate_at_begin = box.plate_height();
    stage.weight_above = box.weight_above_plane();
  }
  const OutputParameters& output = box.parameters().output;
  const double progress = displacement(world.engine, box.walls) / box.parameters().shear.distance;
  stage.is_last = progress >= 1;
  stage.record_due = stage.is_last || progress * output.records >= stage.records;
  stage.frame_due =
      output.field_frames > 0 && (stage.is_last || progress * output.field_frames >= stage.frames);
  if (stage.is_last || stage.frame_due) return running(progress, Look::at_everything);
  return running(progress, stage.record_due || ramping(stage, box) ? Look::at_part : Look::none);
}

void unite_notes(ShearStage& stage, ShearBox& box)
{
  stage.watch.largest_overlap = box.world().largest(stage.watch.largest_overlap);
}

void look(ShearStage& stage, ShearBox& box, RunRecords& records)
{
  World& world = box.world();
  const ShearParameters& p = box.parameters().shear;
  stage.over = stage.is_last;
  if (stage.record_due) record(stage, box, records);
  if (stage.frame_due) {
    records.add_frame(world);
    ++stage.frames;
  }
  // Between forces and motion: the work of a wall is booked with the velocity that it moves with.
  if (ramping(stage, box))
    set_speed(world.engine, box.walls,
              p.speed * soft_start(world.clock.time() - stage.begin, p.ramp_time));
}

void after_step(ShearStage& stage, ShearBox& box, RunRecords&)
{
  const World& world = box.world();
  const double dt = world.clock.dt;
  const ShearForces forces = shear_forces(world.engine, box.walls);
  note_overlap(stage.watch, world);
  stage.shear_impulse += forces.shear * dt;
  stage.normal_impulse += normal_force(forces, stage) * dt;
  stage.plate_impulse += forces.plate * dt;
  stage.impulse_time += dt;
}
} // namespace interlock::coupling
