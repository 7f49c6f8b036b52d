// Ribs: moving convex rods that stones touch. dem knows their motion and returns contact wrenches;
// what makes them move (beams, a rigid frame) is not its business.
//
// A rib is a segment swept by a rounded rectangle: a flat core of half sizes (half_width -
// rounding) and (half_thickness - rounding) around the centre line, grown by `rounding`. A capsule
// is the special case in which both half sizes equal the rounding.
#pragma once

#include "dem/clumps.h"
#include "dem/contact_law.h"

namespace interlock::dem
{
// One rod, from end 1 to end 2. World frame. Rods of the same `line` follow one another without a
// gap; a sphere has at most one contact with a line, on the rod that it overlaps most.
struct Rib {
  int line = 0;
  double half_width = 0, half_thickness = 0, rounding = 0; // [m]
  double inverse_mass[2] = {0, 0}; // of the rib at its ends, 0 when its motion is prescribed [1/kg]

  Vector3 x[2];                                      // ends of the centre line [m]
  Vector3 v[2] = {Vector3::Zero(), Vector3::Zero()}; // [m/s]
  Vector3 w[2] = {Vector3::Zero(), Vector3::Zero()}; // spin of the section [rad/s]
  Vector3 width_axis[2]; // of the section at the ends, unit, about normal to the centre line
};

// What a stone does to a rib.
struct RibWrench {
  int rib = 0;
  double xi = 0;  // place along the rod, 0 at end 1, 1 at end 2
  Vector3 force;  // on the rib, world [N]
  Vector3 moment; // about the point of the centre line at xi, world [N m]
};

// Spin [rad/s] of the rod at xi as contacts see it: the rod turns with its chord, and about the
// chord with the width axis, interpolated between the ends and made perpendicular to the chord.
Vector3 rod_spin(const Rib& rib, double xi);

// The wrench as loads on both ends of the rod, world frame: dual to the linear velocity of the
// centre line and to rod_spin, so the power is the same, and forces and moments balance.
struct RodLoads {
  Vector3 force[2];  // [N]
  Vector3 moment[2]; // about the ends [N m]
};
RodLoads rod_loads(const Rib& rib, const RibWrench& wrench);

// One member sphere of a clump against one line of ribs.
struct RibContact {
  int i = 0, a = 0, line = 0;
  int first = 0, last = 0;         // range of its candidate ribs in the list
  ContactHistory history;          // of the clump against the rib
  Vector3 force = Vector3::Zero(); // on the clump, zero when not touching [N]
  Vector3 point = Vector3::Zero(); // mid-overlap, world [m]
  Vector3 arm = Vector3::Zero();   // from the centre line to the point [m]
  double overlap = 0;              // that makes force [m]
  // Overlap that makes no force [m]: what the sphere had when this contact was left to another line
  // at a junction. It shrinks with the overlap, so that no energy appears when the lines part.
  double shared = 0;
  int rib = -1; // touched last
  double xi = 0;
};

// Signed geometry of a sphere against one rod.
struct RibProximity {
  double distance; // from the sphere's centre to the core [m]
  double overlap;  // sphere radius + rounding - distance; negative: gap [m]
  double xi;       // of the nearest point of the centre line
  Vector3 core;    // nearest point of the core, world [m]
  Vector3 centre;  // nearest point of the centre line, world [m]
  Vector3 normal;  // unit, from the rib to the sphere
  // Where the section turns along the rod, the overlap changes along it too: minus its gradient by
  // the sphere's centre is normal + lean.
  Vector3 lean;
};
RibProximity rib_proximity(const Rib& rib, const Vector3& sphere_centre, double sphere_radius);

// Contacts between clumps and ribs, with their own list, so that they can be evaluated at every
// sub-step of the beams.
class RibContacts
{
public:
  RibContacts() = default;
  explicit RibContacts(ContactProperties stone_on_rib) : contact_(stone_on_rib) {}

  // Makes the list complete for the present poses (see neighbour_lists.h for the rule). The ends of
  // ribs may be refreshed by the caller at any time; `time_step` chooses the skin.
  void update_list(const Clumps& clumps, const std::vector<Rib>& ribs, double time_step);
  void invalidate() { valid_ = false; }
  void renumber_clumps(const std::vector<int>& new_index);
  void clear();

  // Evaluates all contacts at the present poses and advances springs by `time_step` [s]. Adds
  // forces and torques to `force` and `torque` (per clump, world) and returns the wrenches on the
  // ribs in list order. energy.elastic is overwritten; friction and damping are added to.
  const std::vector<RibWrench>& evaluate(const Clumps& clumps, const std::vector<Rib>& ribs,
                                         double time_step, std::vector<Vector3>& force,
                                         std::vector<Vector3>& torque, ContactEnergy& energy);

  // Clumps that can touch a rib before the list expires, ascending; and the ribs that they can
  // touch.
  const std::vector<int>& near_clumps() const { return near_clumps_; }
  const std::vector<int>& near_ribs() const { return near_ribs_; }
  const std::vector<RibContact>& contacts() const { return contacts_; }
  const ContactProperties& properties() const { return contact_; }
  // Energy in the springs of the contacts of the marked clumps, at the last evaluation [J].
  double elastic_energy_of(const std::vector<bool>& clumps) const;

private:
  struct Group {
    RibContact* contact;
    RibProximity nearest;
    int rib;
  };

  void build(const Clumps& clumps, const std::vector<Rib>& ribs);
  void touch(const Group& group, const Clumps& clumps, const std::vector<Rib>& ribs,
             double time_step, std::vector<Vector3>& force, std::vector<Vector3>& torque,
             ContactEnergy& energy);
  void open(const Group& group, const Clumps& clumps, const std::vector<Rib>& ribs,
            double time_step, ContactEnergy& energy);
  // Of the clump against the rib at the contact point [m/s].
  Vector3 relative_velocity(const RibContact& contact, const Clumps& clumps, const Rib& rib) const;
  void merge_at_junctions(const std::vector<Rib>& ribs, ContactEnergy& energy);
  double elastic_energy(const RibContact& contact) const; // [J]

  ContactProperties contact_;
  bool valid_ = false;
  double skin_ = 0; // [m]
  std::vector<Vector3> clump_x_, rib_x_, rib_axis_;
  std::vector<Quaternion> clump_q_;
  std::vector<RibContact> contacts_, old_contacts_;
  std::vector<int> candidate_ribs_;
  std::vector<int> near_clumps_, near_ribs_;
  std::vector<Group> touching_;
  std::vector<RibWrench> wrenches_;
};
} // namespace interlock::dem
