// A pull-out in a small box with 12 shapes and a geogrid of 2 x 2 apertures: 2 mm of fast pull,
// seconds on one core.
#pragma once

#include "coupling/pull_out/pull_out.h"

inline interlock::coupling::PullOutParameters small_pull_out_case()
{
  interlock::coupling::PullOutParameters p;
  p.stones.count = 12;
  p.stones.density = 2650;
  p.stones.d_min = 1e-3;
  p.stones.r_min = 2e-3;
  p.stones.p_max = 100;
  p.stones.max_spheres = 40;
  p.box.length = 0.16;
  p.box.width = 0.14;
  p.box.height = 0.12;
  p.box.slot_height = 0.02;
  p.contact.stone_stiffness = p.contact.box_stiffness = 1e7;
  p.geogrid_contact.stiffness = 1e8;
  p.contact.stone_friction = 0.6;
  p.geogrid_contact.friction = 0.7;
  p.contact.tangential_ratio = 1;
  p.contact.damping_ratio = 0.3;
  p.geogrid_contact.damping_ratio = 0.1;
  p.geogrid.placement = "not flattened";
  p.geogrid.apertures_along = p.geogrid.apertures_across = 2;
  p.geogrid.pitch_along = p.geogrid.pitch_across = 0.065;
  p.geogrid.overhang = 5e-3;
  p.geogrid.rib_width = 5e-3;
  p.geogrid.rib_thickness = 2.5e-3;
  p.geogrid.edge_rounding = 5e-4;
  p.geogrid.youngs_modulus = 2.4e9;
  p.geogrid.poisson_ratio = 0.3;
  p.geogrid.density = 910;
  p.geogrid.elements_per_rib = 4;
  p.geogrid.mass_damping = 100;
  p.filling.drop_height = 0.01;
  p.filling.plate_speed = 0.1;
  p.filling.plate_force_limit = 500;
  p.filling.local_damping = 0.5;
  p.filling.kinetic_energy_ratio = 1e-3;
  p.filling.settling_time_limit = 1;
  p.pull.speed = 0.2;
  p.pull.distance = 2e-3;
  p.pull.ramp_time = 2e-3;
  p.time.safety_factor = 0.6;
  p.output.records = 80; // fine enough for the sum of force times way to be the work
  p.output.field_frames = 1;
  return p;
}
