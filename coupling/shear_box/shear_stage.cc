#include "coupling/shear_box/shear_box.h"

#include <fmt/format.h>

namespace interlock::coupling
{
namespace
{
// On the plane between the halves, from the balance of the stones above it [N].
double normal_force(const ShearForces& forces, const ShearStage& stage)
{
  return forces.plate + stage.weight_above + forces.friction;
}

void record(ShearStage& stage, ShearBox& box, RunRecords& records)
{
  const World& world = box.world();
  const double moved = displacement(world.engine, box.walls), height = box.plate_height();
  const ShearForces now = shear_forces(world.engine, box.walls);
  const dem::Vector3 mean = begin_record(stage.motion, box.specimen,
                                         {now.shear, normal_force(now, stage), now.plate}, moved);
  const double shear = mean.x(), normal = mean.y(), plate = mean.z();
  stage.displacements.push_back(moved);
  stage.heights.push_back(height);
  stage.shear_forces.push_back(shear);
  stage.normal_forces.push_back(normal);
  stage.plate_forces.push_back(plate);
  end_record(stage.motion, world,
             {world.clock.time(), moved, shear, normal, plate, normal > 0 ? shear / normal : 0,
              height - stage.plate_at_begin, box.porosity(), normal - plate - stage.weight_above},
             records);
}
} // namespace

StageStatus before_step(ShearStage& stage, ShearBox& box, RunRecords&)
{
  World& world = box.world();
  if (stage.motion.over)
    return finished(fmt::format("{:.1f} mm, shear force at the end {:.0f} N, plate {:+.2f} mm",
                                1e3 * stage.displacements.back(), stage.shear_forces.back(),
                                1e3 * (stage.heights.back() - stage.plate_at_begin)));
  if (begins(stage.motion, world)) {
    stage.plate_at_begin = box.plate_height();
    stage.weight_above = box.weight_above_plane();
  }
  const ShearParameters& p = box.parameters().shear;
  return go_on(stage.motion, world, displacement(world.engine, box.walls) / p.distance, p.ramp_time,
               box.parameters().output);
}

void unite_notes(ShearStage& stage, ShearBox& box)
{
  unite_overlaps(stage.motion, box.world());
}

void look(ShearStage& stage, ShearBox& box, RunRecords& records)
{
  World& world = box.world();
  const ShearParameters& p = box.parameters().shear;
  if (stage.motion.record_due) record(stage, box, records);
  const double share = end_look(stage.motion, world, p.ramp_time, records);
  if (share >= 0) set_speed(world.engine, box.walls, p.speed * share);
}

void after_step(ShearStage& stage, ShearBox& box, RunRecords&)
{
  const World& world = box.world();
  const double dt = world.clock.dt;
  const ShearForces forces = shear_forces(world.engine, box.walls);
  dem::Vector3& impulse = stage.motion.impulse;
  note_overlap(stage.motion, world);
  impulse.x() += forces.shear * dt;
  impulse.y() += normal_force(forces, stage) * dt;
  impulse.z() += forces.plate * dt;
  stage.motion.impulse_time += dt;
}
} // namespace interlock::coupling
