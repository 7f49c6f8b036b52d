// What a heap is like: how far its stones lie apart in plan, and how steep its surface is.
#pragma once

#include "dem/bodies/clump_shape.h"

#include <array>
#include <vector>

namespace interlock::coupling
{
using PlanPoint = Eigen::Vector2d; // x, y [m]

struct HeapStone {
  dem::Vector3 centre; // of volume, world [m]
  double mass = 0;     // [kg]
  bool elongated = false;
};

// Distances are those in plan from the centroid of all mass.
struct PlanSpread {
  PlanPoint centroid = PlanPoint::Zero();  // [m]
  double radius_of_gyration = 0;           // sqrt(sum m d^2 / sum m) [m]
  double elongated_radius_of_gyration = 0; // of the elongated stones alone, same centroid [m]
  double other_radius_of_gyration = 0;     // of the others [m]
  double r50 = 0;                          // smallest distance that holds half of the mass [m]
  double mass_beyond = 0;                  // share of the mass beyond 1.5 r50 [-]
  int elongated = 0;                       // stones in all
  int others = 0;
  int elongated_beyond = 0; // of them beyond 1.5 r50
  int others_beyond = 0;
};
// Zeros when there is no stone.
PlanSpread plan_spread(const std::vector<HeapStone>& stones);

// Share of the mass at a distance of more than `radius` [m] from `centre` [-].
double mass_outside(const std::vector<HeapStone>& stones, const PlanPoint& centre, double radius);

// Height of the surface over the floor under vertical rays on a square raster.
struct HeightMap {
  PlanPoint corner = PlanPoint::Zero(); // of the raster; ray (i, j) stands at corner +
                                        // spacing (i + 1/2, j + 1/2) [m]
  double spacing = 0;                   // [m]
  int nx = 0, ny = 0;
  std::vector<double> height; // of ray (i, j) at i ny + j; 0 where it meets only the floor [m]

  PlanPoint ray(int i, int j) const { return corner + spacing * PlanPoint(i + 0.5, j + 0.5); }
};
// Of spheres in the world [m], around `centre` as far as `reach` in x and y.
HeightMap height_map(const std::vector<dem::Sphere>& spheres, const PlanPoint& centre, double reach,
                     double spacing);

// Mean height of the surface in rings around a centre, for each of 8 sectors of 45 degrees, the
// first between azimuth 0 (x) and 45 degrees.
struct SurfaceProfile {
  static constexpr int n_sectors = 8;
  struct Ring {
    double radius = 0, height = 0; // means over the rays in it [m]
  };
  std::array<std::vector<Ring>, n_sectors> sector; // from the centre outwards
  std::vector<Ring> all;                           // over all azimuths
};
// Rings of the given width [m]; those without a ray are left out.
SurfaceProfile surface_profile(const HeightMap& map, const PlanPoint& centre, double ring_width);

// The angle of repose: in each sector a straight line is fitted (least squares) to the rings of the
// flank, which ends before the first ring, going outwards, below 20 % of the heap's height and
// begins behind the last one before it that is not below 80 %. A sector with fewer than three such
// rings has no angle.
struct Repose {
  double height = 0;  // of the highest ring over all azimuths [m]
  double angle = 0;   // mean over the sectors [degrees]
  double scatter = 0; // standard deviation over the sectors [degrees]
  int sectors = 0;    // that have an angle
};
Repose repose(const SurfaceProfile& profile);
} // namespace interlock::coupling
