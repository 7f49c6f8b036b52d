// Contacts between stones and ribs.
#pragma once

#include "dem/bodies/clumps.h"
#include "dem/contacts/contact_memory.h"
#include "dem/ribs/rib_lanes.h"
#include "dem/ribs/rib_list_watch.h"

#include <vector>

namespace interlock::dem
{
class RibSearch;

// One member sphere of a clump against one line of ribs.
struct RibContact {
  int i = 0, a = 0, line = 0;
  int first = 0, last = 0;         // range of its pairs with ribs in the list
  ContactHistory history;          // of the clump against the rib
  Vector3 force = Vector3::Zero(); // on the clump, zero when not touching [N]
  Vector3 point = Vector3::Zero(); // mid-overlap, world [m]
  Vector3 arm = Vector3::Zero();   // from the centre line to the point [m]
  double overlap = 0;              // that makes force [m]
  // Overlap that makes no force [m]: what the sphere had when this contact was left to another line
  // at a junction. It shrinks with the overlap, so that no energy appears when the lines part.
  double shared = 0;
  double tangential_stiffness = 0; // of the last evaluation [N/m]
  double radius = 0;               // of the sphere [m]
  int rib = -1;                    // touched last
  double xi = 0;
};

// Contacts between clumps and ribs, with their own list, so that they can be evaluated at every
// sub-step of the beams.
class RibContacts
{
public:
  // No list reaches farther from a rib than that [m].
  static constexpr double largest_skin = 1e-3;

  RibContacts() = default;
  explicit RibContacts(ContactProperties stone_on_rib) : contact_(stone_on_rib) {}

  // Makes the list complete for the present poses of all clumps but ghosts and chooses the near
  // contacts. The motion of the ribs may be renewed by the caller at any time; `time_step` chooses
  // the skin. Call it after the clumps were kicked.
  void update_list(const Clumps& clumps, const RibSet& ribs, double time_step);
  void invalidate() { valid_ = false; }
  void renumber_clumps(const std::vector<int>& new_index);
  void clear();
  // What the contacts remember, by ids of clumps, and going on from it with the same digits.
  std::vector<RibMemory> memory(const Clumps& clumps) const;
  void restore(const Clumps& clumps, const std::vector<RibMemory>& memory);

  // Evaluates the near contacts at the present poses of the near clumps, which `clumps` holds in
  // the order of near_clumps(), and advances springs by `time_step` [s]. Adds to the clumps' forces
  // and torques and returns the loads on the ribs, in the order of the contacts; `loading_contacts`
  // are the indices of these. energy.elastic is overwritten; friction, damping and crushing,
  // numbers on the energy grid (dem/exact_sums.h), are added to.
  const std::vector<RodLoads>& evaluate(SubcycledClumps& clumps, const RibSet& ribs,
                                        double time_step, ContactEnergy& energy);
  const std::vector<int>& loading_contacts() const { return loading_contacts_; }

  // The near contacts: those that may touch within the step to come, that is, those that touch and
  // those with
  //     gap < 2 time_step (speed of the clump + speed of the rib) + margin,
  // where speeds bound those of any point, the factor leaves room for kicks within the step, and
  // the margin, a hundredth of the rib's half thickness, for a light rib that another stone sets
  // off. This is a function of the present state of one clump and the ribs alone. The list proposes
  // whom to look at and has no say: everybody who may be chosen is in it.
  // update_list chooses them, and evaluate looks at no others. Their clumps are the near ones,
  // ascending.
  const std::vector<int>& near_clumps() const { return near_clumps_; }
  const std::vector<RibContact>& contacts() const { return contacts_; }
  const ContactProperties& properties() const { return contact_; }
  ContactProperties& properties() { return contact_; }
  // In the springs of each of them, for the present properties [J].
  std::vector<double> elastic_energies() const;
  // Energy in the springs of the contacts of the marked clumps, at the last evaluation [J].
  double elastic_energy_of(const std::vector<bool>& clumps) const;

private:
  // One of the contacts that may touch: its index in the list, and its range of near_pairs_.
  struct NearContact {
    int contact, first, last;
  };
  struct Range {
    int begin, end;
  };
  struct PairOfList {
    int clump, sphere, rib;
  };

  void build(const Clumps& clumps, const RibSet& ribs, double time_step);
  void add_candidates(int clump, const Clumps& clumps, const RibSet& ribs, const RibSearch& search);
  void select_near(const Clumps& clumps, const RibSet& ribs, double time_step);
  void fill_lanes(const Clumps& clumps, const RibSet& ribs);
  bool may_touch(const RibContact& contact, double clump_speed, const RibSet& ribs,
                 double time_step) const;
  void choose_rods(const RibSet& ribs);
  void merge_at_junctions(Range lanes, const SubcycledClumps& clumps, const RibSet& ribs,
                          ContactEnergy& energy);
  void leave_to(int a, int b, double overlap, ContactEnergy& energy);
  void store_lanes();
  double elastic_energy(const RibContact& contact) const; // [J]

  ContactProperties contact_;
  bool valid_ = false;
  double skin_ = 0; // [m]
  RibListWatch watch_;
  std::vector<RibContact> contacts_, old_contacts_;
  std::vector<PairOfList> candidates_;
  std::vector<int> close_ribs_;
  RodPairs pairs_; // of the list; body: the clump

  std::vector<int> near_clumps_;
  std::vector<NearContact> near_contacts_; // one a lane
  std::vector<Range> spheres_on_lines_;    // lanes of spheres that are near several lines
  RodPairs near_pairs_;                    // body: the place among the near clumps
  RibLanes lanes_;
  std::vector<RodLoads> loads_;
  std::vector<int> loading_contacts_;
};
} // namespace interlock::dem
