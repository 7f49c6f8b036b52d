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
  table.require("Ribs touch walls", geogrid.ribs_touch_walls,
                "Whether the walls of the box and the edges of its slot hold the ribs, with the "
                "smaller of the frictions of box and ribs.");
}

constexpr const char* product = "Geogrid/Product";

void declare_product_files(ParameterTable& table, GeogridParameters& geogrid)
{
  table.offer_file(
      "Product", geogrid.product_file,
      "Parameter file whose section Product says what the geogrid is, such as those in "
      "cases/geogrids, relative to this file; empty: the entries below, or a section "
      "Product of this file.");
  table.offer_input_file(
      "Lattice file", geogrid.lattice_file,
      "A Gmsh file (.msh) with the whole lattice, relative to this file: its groups of "
      "lines are named along or across and take those ribs; a group of points clamp "
      "names the nodes that are held, else those of smallest x are. Numbers of "
      "apertures and pitches are without effect then.");
  table.offer("Lattice length unit", geogrid.lattice_length_unit, 1, positive,
              "Length of one unit of that file, 0.001 for millimetres. [m]");
}

void declare_lattice(ParameterTable& table, GeogridParameters& geogrid)
{
  declare_product_files(table, geogrid);
  table.require("Apertures along", geogrid.apertures_along, {1, 1000, true},
                "Number of apertures in the direction of the pull; of triangle heights. [-]");
  table.require("Apertures across", geogrid.apertures_across, {1, 1000, true},
                "Number of apertures across the box; of sides of triangles. [-]");
  table.offer(
      "Cut width", geogrid.cut_width, 0, not_negative,
      "Ribs that run across or diagonally go on beyond the last aperture to where the sheet "
      "is cut at this width; 0: they end there. [m]");
  table.require("Overhang", geogrid.overhang, not_negative,
                "Distance of the clamped front rib outside the box from the front wall. [m]");
  table.require_unless(
      product, "Pitch along", geogrid.pitch_along, not_negative,
      "Distance of the centre lines of two transverse ribs; 0: that of the product. [m]");
  table.require_unless(
      product, "Pitch across", geogrid.pitch_across, not_negative,
      "Distance of the centre lines of two longitudinal ribs; 0: that of the product. [m]");
  table.require_unless(product, "Rib width", geogrid.rib_width, not_negative,
                       "Width of a rib in the plane of the geogrid; 0: that of the product. [m]");
  table.require_unless(product, "Rib thickness", geogrid.rib_thickness, not_negative,
                       "Thickness of a rib, out of plane; 0: that of the product. [m]");
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
  table.require_unless(
      product, "Youngs modulus", geogrid.youngs_modulus, not_negative,
      "Young's modulus of the ribs, tension along the rib; 0: that of the product. [Pa]");
  table.require_unless(product, "Poisson ratio", geogrid.poisson_ratio, {-1, 0.5, false},
                       "Poisson's ratio of the ribs; with a product 0, and that of it holds. [-]");
  table.require_unless(product, "Density", geogrid.density, not_negative,
                       "Density of the ribs; 0: that of the product. [kg/m3]");
  table.offer("Elements per rib", geogrid.elements_per_rib, 8, {1, 1000, true},
              "Beam elements between two junctions; a product has an entry of its own. [-]");
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
                   "Displacements of the front edge at which a frame for ParaView is written, too; "
                   "of a pull that is resumed, those still to come. [m]");
}
} // namespace interlock::coupling
