// Filling the box: pouring stones from the hopper region above it, and measuring the surface.
#pragma once

#include "coupling/parameters/box_parameters.h"
#include "coupling/parameters/filling_parameters.h"
#include "dem/engine/engine.h"
#include "dem/random_stream.h"

namespace interlock::coupling
{
// The box walls in the engine's list, in this order; they go on above the box as the hopper.
struct BoxWalls {
  static constexpr int floor = 0, back = 1, right = 2, left = 3, front = 4;
  static constexpr int first_extra = 5; // flattening plate; or the front wall above its slot
};

// Adds floor, back, sides and a front wall without a slot.
void build_box(dem::Engine& engine, const BoxParameters& box,
               const dem::ContactProperties& stone_on_box);
// Opens the slot: the front wall becomes a part below and a part above it. `height` is the middle
// of the slot [m]. A flattening plate, if there is one, goes.
void open_slot(dem::Engine& engine, const BoxParameters& box,
               const dem::ContactProperties& stone_on_box, double height);

class Filling
{
public:
  // Stones are drawn in batches: every shape once, in random order, before any comes again.
  Filling(dem::Engine& engine, const BoxParameters& box, const FillingParameters& filling,
          double stone_density);

  // Puts stones of at least `mass` [kg] in the hopper above everything that is in the box, at rest,
  // with random attitudes, each as low as its bounding ball fits: nothing overlaps. Returns the
  // time that the highest one needs to fall [s].
  double pour(double mass);

  // Mean height of the surface of the stones over the plan of the box: highest point under a raster
  // of vertical rays 5 mm apart, floor where a ray meets no stone [m].
  double surface_height() const;

  // Marks what has fallen out of the box, through the slot.
  std::vector<bool> lost() const;

  // Marks stones whose centre of mass is above `height` [m].
  std::vector<bool> above(double height) const;

  double mass_in_box() const;             // stones with their centre inside the box [kg]
  double mass_above(double height) const; // the same, with their centre above `height` [kg]

  bool is_stone(int clump) const; // false for a sphere of the surcharge

private:
  dem::Vector3 lowest_place(double radius, double floor, const std::vector<int>& poured);
  bool in_box(int clump) const;

  dem::Engine& engine_;
  BoxParameters box_;
  FillingParameters filling_;
  double density_;
  int n_shapes_;
  dem::RandomStream random_;
  std::vector<int> batch_;
};
} // namespace interlock::coupling
