// Contacts between stones and ribs.
#pragma once

#include "dem/bodies/clumps.h"
#include "dem/contacts/contact_memory.h"
#include "dem/ribs/ribs.h"

#include <vector>

namespace interlock::dem
{
class RibSearch;

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

// Contacts between clumps and ribs, with their own list, so that they can be evaluated at every
// sub-step of the beams.
class RibContacts
{
public:
  RibContacts() = default;
  explicit RibContacts(ContactProperties stone_on_rib) : contact_(stone_on_rib) {}

  // Makes the list complete for the present poses and chooses the near clumps (see
  // neighbour_lists.h for the rule). The ends of ribs may be refreshed by the caller at any time;
  // `time_step` chooses the skin. Call it after the clumps were kicked.
  void update_list(const Clumps& clumps, const std::vector<Rib>& ribs, double time_step);
  void invalidate() { valid_ = false; }
  void renumber_clumps(const std::vector<int>& new_index);
  void clear();
  // What the contacts remember, by ids of clumps, and going on from it with the same digits.
  std::vector<RibMemory> memory(const Clumps& clumps) const;
  void restore(const Clumps& clumps, const std::vector<RibMemory>& memory);

  // Evaluates all contacts at the present poses and advances springs by `time_step` [s]. Adds
  // forces and torques to `force` and `torque` (per clump, world) and returns the wrenches on the
  // ribs in list order. energy.elastic is overwritten; friction and damping are added to.
  const std::vector<RibWrench>& evaluate(const Clumps& clumps, const std::vector<Rib>& ribs,
                                         double time_step, VectorField& force, VectorField& torque,
                                         ContactEnergy& energy);

  // The near clumps: those that may touch a rib within the step to come, and the ribs near them:
  // those with a contact, and those with
  //     gap < 2 time_step (speed of the clump + speed of the rib) + margin,
  // where speeds bound those of any point, the factor leaves room for kicks within the step, and
  // the margin, a hundredth of the rib's half thickness, for a light rib that another stone sets
  // off. This is a function of the present state of one clump and the ribs alone. The list proposes
  // whom to look at and has no say: everybody who may be chosen is in it.
  // update_list chooses them, ascending, and evaluate looks at no others.
  const std::vector<int>& near_clumps() const { return near_clumps_; }
  const std::vector<int>& near_ribs() const { return near_ribs_; }
  const std::vector<RibContact>& contacts() const { return contacts_; }
  const ContactProperties& properties() const { return contact_; }
  ContactProperties& properties() { return contact_; }
  double elastic_energy() const; // of all of them, for the present properties [J]
  // Energy in the springs of the contacts of the marked clumps, at the last evaluation [J].
  double elastic_energy_of(const std::vector<bool>& clumps) const;

private:
  struct Group {
    RibContact* contact;
    RibProximity nearest;
    int rib;
  };

  void build(const Clumps& clumps, const std::vector<Rib>& ribs, double time_step);
  void add_candidates(int clump, const Clumps& clumps, const std::vector<Rib>& ribs,
                      const RibSearch& search);
  bool list_holds(const Clumps& clumps, const std::vector<Rib>& ribs, double time_step) const;
  void select_near(const Clumps& clumps, const std::vector<Rib>& ribs, double time_step);
  bool may_touch(const RibContact& contact, const Clumps& clumps, const std::vector<Rib>& ribs,
                 double time_step, double speed) const;
  void evaluate_clump(int first, int last, const Clumps& clumps, const std::vector<Rib>& ribs,
                      double time_step, VectorField& force, VectorField& torque,
                      ContactEnergy& energy);
  void touch(const Group& group, const Clumps& clumps, const std::vector<Rib>& ribs,
             double time_step, VectorField& force, VectorField& torque, ContactEnergy& energy);
  void open(const Group& group, const Clumps& clumps, const std::vector<Rib>& ribs,
            double time_step, ContactEnergy& energy);
  // Of the clump against the rib at the contact point [m/s].
  Vector3 relative_velocity(const RibContact& contact, const Clumps& clumps, const Rib& rib) const;
  void merge_at_junctions(const std::vector<Rib>& ribs, ContactEnergy& energy);
  double elastic_energy(const RibContact& contact) const; // [J]

  ContactProperties contact_;
  bool valid_ = false;
  double skin_ = 0; // [m]
  // What each clump could come nearer to the ribs, when the list was made, before somebody had to
  // be added to the list [m].
  std::vector<double> room_;
  VectorField clump_x_;
  QuaternionField clump_q_;
  std::vector<Vector3> rib_x_, rib_axis_;
  std::vector<RibContact> contacts_, old_contacts_;
  std::vector<int> candidate_ribs_, close_ribs_;
  std::vector<int> near_clumps_, near_ribs_;
  std::vector<int> near_contacts_; // first and one past the last contact of each near clump
  std::vector<double> rib_speed_;  // bounds [m/s]
  std::vector<char> rib_is_near_;
  std::vector<Group> touching_;
  std::vector<RibWrench> wrenches_;
};
} // namespace interlock::dem
