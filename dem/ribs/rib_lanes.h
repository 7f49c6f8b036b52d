// Member spheres against rods as flat arrays, one lane each, padded to whole registers: the hot
// loops of RibContacts. World frame unless said otherwise, SI units.
#pragma once

#include "dem/bodies/subcycled_clumps.h"
#include "dem/contacts/contact_law.h"
#include "dem/ribs/rib_set.h"

#include <cstdint>
#include <vector>

namespace interlock::dem
{
// The rod of each lane, copied side by side.
struct RodRows {
  void resize(int n);
  void set(int k, int rod, const RibSet& ribs);

  std::vector<std::int64_t> rib, end;               // end: the first one
  VectorField axis1, axis2;                         // RibShape::width_axis
  ScalarField core_width, core_thickness, rounding; // half sizes of the flat core [m]
  ScalarField inverse_mass1, inverse_mass2;         // [1/kg]
};

// One sphere and one rod a lane.
struct RodPairs {
  int size() const { return radius.size(); }
  void resize(int n);
  void set(int k, int body_of_sphere, const Sphere& sphere, int rod_of_lane, const RibSet& ribs);

  std::vector<std::int64_t> body; // index of the clump in the arrays that are read
  RodRows rod;
  VectorField centre;  // of the sphere, body frame [m]
  ScalarField radius;  // [m]
  ScalarField overlap; // measured; negative: gap [m]
};

void measure_overlaps(const Clumps& clumps, const RibSet& ribs, RodPairs& pairs);
void measure_overlaps(const SubcycledClumps& clumps, const RibSet& ribs, RodPairs& pairs);

// One contact a lane: a sphere against the rod of a line that it is nearest to. Entries that do not
// touch make no force and no energy.
struct RibLanes {
  int size() const { return radius.size(); }
  void resize(int n);

  std::vector<std::int64_t> place; // of the clump among the subcycled ones
  RodRows rod;
  VectorField centre; // of the sphere, body frame [m]
  ScalarField radius; // [m]
  // The overlap that makes force from now on; not positive: none [m].
  ScalarField depth{-Eigen::Matrix<double, 1, 1>::Ones()};

  // LaneHistory; overlap: the depth of the last evaluation [m].
  VectorField spring, dashpot;
  ScalarField overlap, tangential_stiffness, crushed;

  // Results: xi, contact point and arm as in RibContact; the force of the contact law on the clump
  // [N]; all of the force on the clump, with the part that comes from the turn of the section along
  // the rod, and its torque about the centre of mass [N], [N m]; loads on the ends of the rod as in
  // RodLoads; energies of this evaluation as in LaneEnergy [J].
  ScalarField xi;
  VectorField point, arm, force, push, torque;
  VectorField rod_force1, rod_force2, rod_moment1, rod_moment2;
  ScalarField elastic, friction, damping, crushing;
};

// Forces and loads of all lanes at their depths, over a sub-step of h [s]. Dashpots act on the
// reduced mass of clump and rod: the rod is far lighter than the stone. Hertz-Mindlin contacts take
// the rib for flat. Contacts with ribs never share what they have (ContactProperties).
void evaluate_rib_lanes(const SubcycledClumps& clumps, const RibSet& ribs,
                        const ContactProperties& pair, double h, RibLanes& lanes);
} // namespace interlock::dem
