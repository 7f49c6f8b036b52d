#include "coupling/pull_out/protocol.h"
#include "coupling/pull_out/pull_out.h"
#include "coupling/stones/filled_box.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace interlock::coupling
{
namespace
{
using dem::Vector3;

dem::ClumpShape ball(double radius)
{
  dem::ClumpShape shape;
  shape.name = "surcharge sphere";
  shape.spheres = {{Vector3::Zero(), radius}};
  shape.volume = 4 * M_PI / 3 * std::pow(radius, 3);
  shape.unit_inertia = Vector3::Constant(0.4 * shape.volume * radius * radius);
  return shape;
}

// In a square pattern, clear of the stones. Returns their number.
int add_spheres(const SurchargeParameters& surcharge, const BoxParameters& box, dem::Engine& engine)
{
  const double radius = surcharge.sphere_radius, pitch = 2 * radius + protocol::surcharge_gap;
  const int nx = std::max(1, static_cast<int>(box.length / pitch));
  const int ny = std::max(1, static_cast<int>(box.width / pitch));
  const dem::ClumpShape sphere = ball(radius);
  const double density = surcharge.force / engine.gravity() / (nx * ny) / sphere.volume;
  const int shape = engine.clumps().add_shape(sphere);
  const double top = highest_ball(engine.clumps());
  for (int i = 0; i < nx; ++i)
    for (int j = 0; j < ny; ++j) {
      const Vector3 place((i + 0.5) * box.length / nx, (j + 0.5) * box.width / ny, top + radius);
      const int added = engine.add_clump(shape, density, place, dem::Quaternion::Identity());
      engine.clumps().kind[added] = dem::BodyKind::surcharge;
    }
  return nx * ny;
}

// Over the whole box; keeps the force until the end.
dem::WallId add_plate(const PullOut& experiment, dem::Engine& engine)
{
  const dem::WallId plate =
      engine.add_wall(box_plate("surcharge plate", experiment.parameters().box,
                                experiment.stone_on_box(), highest_point(engine.clumps(), 0)));
  dem::ForceControl control;
  control.axis = -Vector3::UnitZ();
  control.force = experiment.parameters().surcharge.force;
  control.largest_speed = experiment.parameters().filling.plate_speed;
  engine.control_wall(plate, control);
  return plate;
}
} // namespace

void add_surcharge(LoadStage& stage, PullOut& experiment)
{
  World& world = experiment.world();
  world.make_whole();
  experiment.end_filling();
  const SurchargeParameters& surcharge = experiment.parameters().surcharge;
  if (surcharge.kind == "plate")
    experiment.surcharge_plate = add_plate(experiment, world.engine);
  else
    stage.spheres = add_spheres(surcharge, experiment.parameters().box, world.engine);
  stage.loaded = true;
  stage.settling = begin_settling(world, settling_below_load, loosely_still);
}

StageStatus before_step(LoadStage& stage, PullOut& experiment, RunRecords& records)
{
  experiment.drop_lost_stones();
  if (!stage.loaded) add_surcharge(stage, experiment);
  if (!experiment.has_settled(stage.settling, records))
    return running(fraction_of(stage.settling, experiment.world()));
  const SurchargeParameters& surcharge = experiment.parameters().surcharge;
  if (stage.spheres > 0)
    return finished(fmt::format("{} spheres of {:.0f} mm, {:.1f} N in all", stage.spheres,
                                2e3 * surcharge.sphere_radius, surcharge.force));
  const dem::Wall& plate = experiment.world().engine.wall(experiment.surcharge_plate);
  return finished(fmt::format("plate at {:.1f} mm, presses with {:.1f} N", 1e3 * plate.corner.z(),
                              plate.force.z()));
}
} // namespace interlock::coupling
