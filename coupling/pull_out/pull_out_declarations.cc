#include "coupling/pull_out/pull_out_declarations.h"

#include "coupling/parameters/filling_declarations.h"
#include "coupling/parameters/stone_declarations.h"

namespace interlock::coupling
{
namespace
{

void declare_box(ParameterTable& table, BoxParameters& box)
{
  table.open_section("Box");
  table.require("Length", box.length, positive,
                "Inner length along x, the direction of the pull. [m]");
  table.require("Width", box.width, positive, "Inner width along y. [m]");
  table.require("Height", box.height, positive, "Inner height along z. [m]");
  table.require("Slot height", box.slot_height, positive,
                "Height of the gap in the front wall, centred on the geogrid. [m]");
}

void declare_contact(ParameterTable& table, PullOutParameters& parameters)
{
  declare_stone_contact(table, parameters.contact);
  GeogridContactParameters& geogrid = parameters.geogrid_contact;
  table.require("Geogrid stiffness", geogrid.stiffness, not_negative,
                "Normal contact stiffness of a rib's surface; 0: Hertz's and Mindlin's, of the "
                "ribs' material. [N/m]");
  table.require("Geogrid friction", geogrid.friction, friction_range,
                "Friction coefficient of the ribs. [-]");
  table.offer("Stone on geogrid friction", geogrid.stone_friction, -1, pair_friction_range,
              "Friction coefficient between stones and ribs; -1: the smaller of the two. [-]");
  table.require("Geogrid damping ratio", geogrid.damping_ratio, damping_ratio_range,
                "The dashpots between a stone and a rib, on their reduced mass. [-]");
}

void declare_lattice(ParameterTable& table, GeogridParameters& geogrid)
{
  table.require("Apertures along", geogrid.apertures_along, {1, 1000, true},
                "Number of apertures in the direction of the pull. [-]");
  table.require("Apertures across", geogrid.apertures_across, {1, 1000, true},
                "Number of apertures across the box. [-]");
  table.require("Overhang", geogrid.overhang, not_negative,
                "Distance of the clamped front rib outside the box from the front wall. [m]");
  table.require("Pitch along", geogrid.pitch_along, positive,
                "Distance of the centre lines of two transverse ribs. [m]");
  table.require("Pitch across", geogrid.pitch_across, positive,
                "Distance of the centre lines of two longitudinal ribs. [m]");
  table.require("Rib width", geogrid.rib_width, positive,
                "Width of a rib in the plane of the geogrid. [m]");
  table.require("Rib thickness", geogrid.rib_thickness, positive,
                "Thickness of a rib, out of plane. [m]");
  table.require("Edge rounding", geogrid.edge_rounding, not_negative,
                "Radius of the rounded edges of a rib, at most half its thickness. [m]");
}

void declare_geogrid(ParameterTable& table, GeogridParameters& geogrid)
{
  table.open_section("Geogrid");
  table.require("Rigid", geogrid.rigid,
                "Prescribe every freedom, so that the geogrid moves as one rigid body.");
  table.require_choice("Placement", geogrid.placement, {"flattened", "not flattened"},
                       "A plate flattens the surface below the geogrid first, or the stones in the "
                       "way of the ribs are removed.");
  declare_lattice(table, geogrid);
  table.require("Youngs modulus", geogrid.youngs_modulus, positive,
                "Young's modulus of the ribs, tension along the rib. [Pa]");
  table.require("Poisson ratio", geogrid.poisson_ratio, {-1, 0.5, false},
                "Poisson's ratio of the ribs. [-]");
  table.require("Density", geogrid.density, positive, "Density of the ribs. [kg/m3]");
  table.offer("Elements per rib", geogrid.elements_per_rib, 8, {1, 1000, true},
              "Beam elements between two junctions. [-]");
  table.require("Mass damping", geogrid.mass_damping, not_negative,
                "Damping of the ribs' motion: force = mass damping x mass x velocity. [1/s]");
  table.offer("Break strain", geogrid.break_strain, 0, {0, 10, true},
              "Stretch at which a rib breaks and the run ends; 0: ribs do not break. [-]");
}

void declare_loading(ParameterTable& table, PullOutParameters& parameters)
{
  table.open_section("Surcharge");
  table.require_choice("Kind", parameters.surcharge.kind, {"spheres", "plate"},
                       "Heavy spheres of this weight together, or a plate that keeps the force "
                       "and moves with at most Filling/Plate speed.");
  table.require(
      "Force", parameters.surcharge.force, not_negative,
      "Load on top: total weight of the heavy spheres, or force of the plate; 0: none. [N]");
  table.require("Sphere radius", parameters.surcharge.sphere_radius, not_negative,
                "Radius of the heavy spheres. [m]");

  table.open_section("Pull");
  table.require("Speed", parameters.pull.speed, positive,
                "Speed of the front edge of the geogrid. [m/s]");
  table.require("Distance", parameters.pull.distance, positive,
                "Displacement of the front edge at the end. [m]");
  table.require("Ramp time", parameters.pull.ramp_time, not_negative,
                "Time from rest to full speed. [s]");
}
} // namespace

void declare_pull_out(ParameterTable& table, PullOutParameters& parameters)
{
  table.open_section("");
  table.require("Gravity", parameters.gravity, positive,
                "Acceleration of gravity, downwards along z. [m/s2]");
  table.offer_file("Start from", parameters.start_from,
                   "State that another run has left (state_before_geogrid.h5 or "
                   "state_before_pull.h5) to start from; empty: pour the stones.");
  declare_stones(table, parameters.stones);
  declare_box(table, parameters.box);
  declare_contact(table, parameters);
  declare_geogrid(table, parameters.geogrid);
  declare_filling(table, parameters.filling);
  table.require("Plate force limit", parameters.filling.plate_force_limit, positive,
                "The plate that presses a surface level stops pressing at this force. [N]");
  const auto offer_density = [&](const char* name, double& density, const char* text) {
    table.offer(name, density, 0, not_negative, text);
  };
  offer_density("Lower bulk density", parameters.filling.lower_bulk_density,
                "Mass poured for the lower half of the box over its volume; 0: as much as fills "
                "it, and stones that stand out are taken off. [kg/m3]");
  offer_density("Upper bulk density", parameters.filling.upper_bulk_density,
                "The same of the upper half; a plate then presses its surface level. [kg/m3]");
  declare_loading(table, parameters);
  declare_time(table, parameters.time);
  declare_limits_and_output(table, parameters.limits, parameters.output);
  table.offer_list("Frames at", parameters.frames_at,
                   "Displacements of the front edge at which a frame for ParaView is written, too. "
                   "[m]");
}
} // namespace interlock::coupling
