#include "coupling/run/physics_limits.h"

#include "coupling/loop/rib_names.h"
#include "coupling/run/run_failure.h"

#include <fmt/format.h>

namespace interlock::coupling
{
namespace
{
using dem::Vector3;

std::string at(const Vector3& x)
{
  return fmt::format("({:.4g}, {:.4g}, {:.4g}) m", x.x(), x.y(), x.z());
}

std::string when(const World& world)
{
  return fmt::format("at t = {:.6g} s (step {})", world.clock.time(), world.clock.step);
}

void check_stones(const World& world, const PhysicsLimits& limits)
{
  const dem::Clumps& clumps = world.engine.clumps();
  for (int i = 0; i < clumps.size(); ++i) {
    const Vector3 x = clumps.position[i], v = clumps.velocity[i], l = clumps.angular_momentum[i];
    if (!x.allFinite() || !v.allFinite() || !l.allFinite() ||
        !clumps.orientation[i].coeffs().allFinite())
      throw RunFailure(
          fmt::format("The simulation became unstable {}: the motion of stone {} is not "
                      "a number; lower Time/Safety factor.",
                      when(world), clumps.id[i]));
    if (limits.region.exteriorDistance(x) > clumps.bounding_radius(i))
      throw RunFailure(fmt::format(
          "Stone {} is outside the box {}, at {}, with {:.3g} m/s: it was pushed through a wall; "
          "lower Time/Safety factor, or raise the stiffness of the walls.",
          clumps.id[i], when(world), at(x), v.norm()));
  }
}

void check_overlaps(const World& world, const PhysicsLimits& limits)
{
  if (world.largest_overlap() <= limits.largest_overlap) return;
  const dem::Clumps& clumps = world.engine.clumps();
  double overlap = 0;
  std::string who;
  const auto consider = [&](double depth, const Vector3& point, const std::string& text) {
    if (depth <= overlap) return;
    overlap = depth;
    who = text + " at " + at(point);
  };
  for (const dem::SphereContact& c : world.engine.sphere_contacts())
    consider(c.overlap, c.point, fmt::format("stones {} and {}", clumps.id[c.i], clumps.id[c.j]));
  for (const dem::WallContact& c : world.engine.wall_contacts())
    consider(c.overlap, c.point,
             fmt::format("stone {} and the wall \"{}\"", clumps.id[c.i],
                         world.engine.walls()[c.wall].name));
  for (const dem::MeshContact& c : world.engine.mesh_contacts())
    consider(c.depth, c.point, fmt::format("stone {} and a wall of triangles", clumps.id[c.i]));
  for (const dem::RibContact& c : world.ribs.rib_contacts().contacts())
    consider(c.overlap, c.point, fmt::format("stone {} and a rib", clumps.id[c.i]));
  throw RunFailure(fmt::format("The overlap of {} is {:.3g} mm {}, above the limit of {:.3g} mm: a "
                               "wedged stone, or contacts too soft for this load; raise the "
                               "stiffness, or end the pull before.",
                               who, 1e3 * overlap, when(world), 1e3 * limits.largest_overlap));
}

void check_geogrid(const World& world, const PhysicsLimits& limits)
{
  if (!world.geogrid() || !world.moves_geogrid()) return;
  const fem::ExplicitDynamics& dynamics = world.geogrid()->dynamics();
  for (int node = 0; node < dynamics.lattice().n_nodes(); ++node)
    if (!dynamics.position(node).allFinite() || !dynamics.velocity(node).allFinite())
      throw RunFailure(
          fmt::format("The simulation became unstable {}: the motion of node {} of the "
                      "geogrid is not a number; lower Time/Safety factor.",
                      when(world), node));
  if (limits.break_strain <= 0 || world.geogrid()->rigid()) return;
  const Stretch stretch = largest_stretch(world);
  if (stretch.strain <= limits.break_strain) return;
  const Vector3 x =
      0.5 * (dynamics.end_position(stretch.element, 0) + dynamics.end_position(stretch.element, 1));
  const fem::Lattice& lattice = dynamics.lattice();
  throw RunFailure(
      fmt::format("A rib breaks {}: {}, element {} at {}, is stretched by {:.3g} %, "
                  "above Geogrid/Break strain of {:.3g} %. What was pulled up to here "
                  "is in history.csv.",
                  when(world), name_of_line(lattice, lattice.element(stretch.element).line),
                  stretch.element, at(x), 100 * stretch.strain, 100 * limits.break_strain));
}

void check_step(const World& world)
{
  const dem::StableStep live = world.engine.stable_step(&world.ribs.rib_contacts());
  if (live.step == 0 || world.clock.dt <= live.step) return;
  throw RunFailure(
      fmt::format("The time step of {:.3g} us is above the live stable step of {:.3g} us "
                  "{}: stone {} of {:.3g} g has {} contacts; lower Time/Safety factor.",
                  1e6 * world.clock.dt, 1e6 * live.step, when(world), live.clump_id,
                  1e3 * live.mass, live.contacts));
}
} // namespace

Stretch largest_stretch(const World& world)
{
  Stretch largest;
  if (!world.geogrid() || world.geogrid()->rigid()) return largest;
  const fem::ExplicitDynamics& dynamics = world.geogrid()->dynamics();
  const fem::Lattice& lattice = dynamics.lattice();
  for (int e = 0; e < lattice.n_elements(); ++e) {
    const double strain =
        dynamics.section_forces(e).axial / lattice.section(e).axial + dynamics.plastic_stretch(e);
    if (strain > largest.strain) largest = {strain, e};
  }
  return largest;
}

void check_physics(const World& world, const PhysicsLimits& limits)
{
  check_stones(world, limits);
  check_overlaps(world, limits);
  check_geogrid(world, limits);
  if (limits.live_stable_step) check_step(world);
}
} // namespace interlock::coupling
