#include "coupling/triaxial/triaxial.h"

#include "coupling/stones/box_walls.h"

namespace interlock::coupling
{
namespace
{
// Simulated time of the consolidation, which ends by itself, of the case [s].
constexpr double consolidating_time = 0.6;
} // namespace

void Triaxial::set_up(const std::vector<Stone>& stones)
{
  specimen.add(stones);
  const SpecimenParameters& p = specimen.parameters();
  walls = build_triaxial_box(world().engine, p.box, stone_on_box(p.contact));
}

std::vector<std::string> Triaxial::history_columns() const
{
  std::vector<std::string> columns = {"time [s]",          "axial_strain [-]", "axial_stress [Pa]",
                                      "stress_x [Pa]",     "stress_y [Pa]",    "stress_ratio [-]",
                                      "volume_change [-]", "porosity [-]",     "length [m]",
                                      "width [m]",         "height [m]",       "plate_force [N]",
                                      "floor_force [N]"};
  append_common_columns(columns);
  return columns;
}

PhysicsLimits Triaxial::limits() const
{
  const auto corner = [&](dem::WallId wall) { return world().engine.wall(wall).corner; };
  return specimen.limits({corner(walls.x_moving).x(), corner(walls.y_moving).y(),
                          walls.plate < 0 ? hopper_height : corner(walls.plate).z()});
}

Forecast forecast(const Triaxial& test)
{
  const CompressionParameters& p = test.parameters().compression;
  return forecast(test.specimen, consolidating_time, CompressStage::kind,
                  p.strain / p.strain_rate + 0.5 * p.ramp_time,
                  test.parameters().output.field_frames);
}
} // namespace interlock::coupling
