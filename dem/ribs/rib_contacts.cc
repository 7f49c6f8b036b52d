// The forces of RibContacts; its list is in rib_contact_list.cc.
#include "dem/ribs/rib_contacts.h"

#include "dem/exact_sums.h"

#include <algorithm>

namespace interlock::dem
{
namespace
{
// Distance from a point to the flat core of a rib.
double distance_to_core(const Rib& rib, const Vector3& p)
{
  return rib_proximity(rib, p, 0).distance;
}
} // namespace

const std::vector<RodLoads>& RibContacts::evaluate(SubcycledClumps& clumps, const RibSet& ribs,
                                                   double time_step, ContactEnergy& energy)
{
  measure_overlaps(clumps, ribs, near_pairs_);
  choose_rods(ribs);
  for (const Range& lanes : spheres_on_lines_) merge_at_junctions(lanes, clumps, ribs, energy);
  evaluate_rib_lanes(clumps, ribs, contact_, time_step, lanes_);

  energy.elastic = 0;
  loads_.clear();
  loading_contacts_.clear();
  for (int lane = 0; lane < lanes_.size(); ++lane) {
    // What a contact that has just opened lost counts, too.
    energy.elastic += lanes_.elastic[lane];
    energy.friction += on_grid<energy_grid>(lanes_.friction[lane]);
    energy.damping += on_grid<energy_grid>(lanes_.damping[lane]);
    energy.crushing += on_grid<energy_grid>(lanes_.crushing[lane]);
    if (!(lanes_.depth[lane] > 0)) continue;
    const int place = static_cast<int>(lanes_.place[lane]);
    clumps.force[place] += lanes_.push[lane];
    clumps.torque[place] += lanes_.torque[lane];
    loading_contacts_.push_back(near_contacts_[lane].contact);
    loads_.push_back({static_cast<int>(lanes_.rod.rib[lane]),
                      {lanes_.rod_force1[lane], lanes_.rod_force2[lane]},
                      {lanes_.rod_moment1[lane], lanes_.rod_moment2[lane]}});
  }
  store_lanes();
  return loads_;
}

// A contact is with the rod of its line that the sphere overlaps most.
void RibContacts::choose_rods(const RibSet& ribs)
{
  for (int lane = 0; lane < lanes_.size(); ++lane) {
    const NearContact& near = near_contacts_[lane];
    int best = near.first;
    for (int k = near.first + 1; k < near.last; ++k)
      if (near_pairs_.overlap[k] > near_pairs_.overlap[best]) best = k;
    RibContact& c = contacts_[near.contact];
    const double overlap = near_pairs_.overlap[best];
    c.shared = std::clamp(overlap, 0., c.shared);
    if (lanes_.rod.rib[lane] != near_pairs_.rod.rib[best])
      lanes_.rod.set(lane, static_cast<int>(near_pairs_.rod.rib[best]), ribs);
    lanes_.depth[lane] = overlap - c.shared;
  }
}

// What the lanes hold goes back to the list.
void RibContacts::store_lanes()
{
  for (int lane = 0; lane < lanes_.size(); ++lane) {
    RibContact& c = contacts_[near_contacts_[lane].contact];
    const bool touches = lanes_.depth[lane] > 0;
    if (!touches && c.overlap <= 0 && c.shared <= 0) continue;
    c.history = {lanes_.spring[lane], lanes_.overlap[lane], lanes_.dashpot[lane],
                 lanes_.crushed[lane]};
    c.force = lanes_.force[lane];
    c.point = lanes_.point[lane];
    c.arm = lanes_.arm[lane];
    c.overlap = lanes_.overlap[lane];
    c.tangential_stiffness = lanes_.tangential_stiffness[lane];
    c.rib = static_cast<int>(lanes_.rod.rib[lane]);
    c.xi = lanes_.xi[lane];
  }
}

std::vector<double> RibContacts::elastic_energies() const
{
  std::vector<double> energies;
  for (const RibContact& c : contacts_) energies.push_back(elastic_energy(c));
  return energies;
}

double RibContacts::elastic_energy(const RibContact& c) const
{
  const double elastic = c.overlap - (contact_.crushing_pressure > 0 ? c.history.crushed : 0);
  if (elastic <= 0) return 0;
  return stored_energy(contact_, elastic, c.radius, c.history.spring.norm(), {});
}

double RibContacts::elastic_energy_of(const std::vector<bool>& clumps) const
{
  double sum = 0;
  for (const RibContact& c : contacts_)
    if (clumps[c.i]) sum += elastic_energy(c);
  return sum;
}

// Where two lines cross, their solids share the junction. A sphere on the shared part touches one
// body, not two: the contact with less overlap is left to the other, with its history if that one
// did not touch before, and starts again from zero where they part.
void RibContacts::merge_at_junctions(Range lanes, const SubcycledClumps& clumps, const RibSet& ribs,
                                     ContactEnergy& energy)
{
  struct Touching {
    int lane;
    Rib rib;
    RibProximity nearest;
  };
  std::vector<Touching> touching;
  for (int lane = lanes.begin; lane < lanes.end; ++lane) {
    if (lanes_.depth[lane] + contacts_[near_contacts_[lane].contact].shared <= 0) continue;
    const int place = static_cast<int>(lanes_.place[lane]);
    const Vector3 centre = clumps.position[place] +
                           clumps.orientation[place]._transformVector(Vector3(lanes_.centre[lane]));
    const Rib rib = ribs[static_cast<int>(lanes_.rod.rib[lane])];
    touching.push_back({lane, rib, rib_proximity(rib, centre, lanes_.radius[lane])});
  }
  for (std::size_t m = 0; m < touching.size(); ++m)
    for (std::size_t n = m + 1; n < touching.size();) {
      Touching &a = touching[m], &b = touching[n];
      const double solid = std::max(1e-6, std::min(a.rib.rounding, b.rib.rounding));
      const bool shared = distance_to_core(b.rib, a.nearest.core) < solid ||
                          distance_to_core(a.rib, b.nearest.core) < solid;
      if (!shared) {
        ++n;
        continue;
      }
      if (b.nearest.overlap > a.nearest.overlap) std::swap(a, b);
      leave_to(a.lane, b.lane, b.nearest.overlap, energy);
      touching.erase(touching.begin() + n);
    }
}

// The contact of lane b, which overlaps by `overlap`, is left to that of lane a.
void RibContacts::leave_to(int a, int b, double overlap, ContactEnergy& energy)
{
  RibContact &kept = contacts_[near_contacts_[a].contact],
             &left = contacts_[near_contacts_[b].contact];
  if (kept.overlap <= 0) {
    lanes_.spring[a] = lanes_.spring[b];
    lanes_.dashpot[a] = lanes_.dashpot[b];
    lanes_.overlap[a] = lanes_.overlap[b];
    lanes_.crushed[a] = lanes_.crushed[b];
    lanes_.tangential_stiffness[a] = lanes_.tangential_stiffness[b];
    lanes_.depth[a] += kept.shared;
    kept.shared = 0;
  } else if (left.overlap > 0) { // both touched before they became one: what b stored is lost
    energy.damping += on_grid<energy_grid>(elastic_energy(left));
  }
  left.shared = overlap;
  lanes_.spring[b] = Vector3::Zero();
  lanes_.dashpot[b] = Vector3::Zero();
  lanes_.overlap[b] = lanes_.crushed[b] = lanes_.tangential_stiffness[b] = 0;
  lanes_.depth[b] = 0;
}
} // namespace interlock::dem
