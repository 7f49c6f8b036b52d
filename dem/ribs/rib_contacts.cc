// The forces of RibContacts; its list is in rib_contact_list.cc.
#include "dem/ribs/rib_contacts.h"

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

const std::vector<RibWrench>& RibContacts::evaluate(const Clumps& clumps,
                                                    const std::vector<Rib>& ribs, double time_step,
                                                    VectorField& force, VectorField& torque,
                                                    ContactEnergy& energy)
{
  energy.elastic = 0;
  wrenches_.clear();
  touching_.clear();
  for (std::size_t n = 0; n < near_clumps_.size(); ++n)
    evaluate_clump(near_contacts_[2 * n], near_contacts_[2 * n + 1], clumps, ribs, time_step, force,
                   torque, energy);
  return wrenches_;
}

void RibContacts::evaluate_clump(int first, int last, const Clumps& clumps,
                                 const std::vector<Rib>& ribs, double time_step, VectorField& force,
                                 VectorField& torque, ContactEnergy& energy)
{
  for (int g = first; g < last; ++g) {
    RibContact& c = contacts_[g];
    const Vector3 centre = clumps.position[c.i] + clumps.member_offset(c.i, c.a);
    const double radius = clumps.shape_of(c.i).spheres[c.a].radius;
    Group group{&c, {}, -1};
    for (int k = c.first; k < c.last; ++k) {
      // Most candidates are clear of the rod; those that touched need their gap.
      if (c.overlap <= 0 && clear_of(ribs[candidate_ribs_[k]], centre, radius)) continue;
      const RibProximity p = rib_proximity(ribs[candidate_ribs_[k]], centre, radius);
      if (group.rib < 0 || p.overlap > group.nearest.overlap)
        group.nearest = p, group.rib = candidate_ribs_[k];
    }
    c.shared = group.rib < 0 ? 0 : std::clamp(group.nearest.overlap, 0., c.shared);
    if (group.rib >= 0 && group.nearest.overlap > 0)
      touching_.push_back(group);
    else if (c.overlap > 0)
      open(group, clumps, ribs, time_step, energy);
    const bool last_of_sphere = g + 1 == last || contacts_[g + 1].a != c.a;
    if (!last_of_sphere) continue;
    if (touching_.size() > 1) merge_at_junctions(ribs, energy);
    for (const Group& t : touching_) touch(t, clumps, ribs, time_step, force, torque, energy);
    touching_.clear();
  }
}

double RibContacts::elastic_energy() const
{
  double sum = 0;
  for (const RibContact& c : contacts_) sum += elastic_energy(c);
  return sum;
}

double RibContacts::elastic_energy(const RibContact& c) const
{
  if (c.overlap <= 0) return 0;
  return 0.5 * contact_.normal_stiffness * c.overlap * c.overlap +
         0.5 * contact_.tangential_stiffness * c.history.spring.squaredNorm();
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
void RibContacts::merge_at_junctions(const std::vector<Rib>& ribs, ContactEnergy& energy)
{
  for (std::size_t m = 0; m < touching_.size(); ++m)
    for (std::size_t n = m + 1; n < touching_.size();) {
      Group &a = touching_[m], &b = touching_[n];
      const double solid = std::max(1e-6, std::min(ribs[a.rib].rounding, ribs[b.rib].rounding));
      const bool shared = distance_to_core(ribs[b.rib], a.nearest.core) < solid ||
                          distance_to_core(ribs[a.rib], b.nearest.core) < solid;
      if (!shared) {
        ++n;
        continue;
      }
      if (b.nearest.overlap > a.nearest.overlap) std::swap(a, b);
      if (a.contact->overlap <= 0) {
        a.contact->history = b.contact->history;
        a.contact->shared = 0;
      } else if (b.contact->overlap >
                 0) // both touched before they became one: what b stored is lost
        energy.damping += elastic_energy(*b.contact);
      b.contact->shared = b.nearest.overlap;
      b.contact->history = ContactHistory();
      b.contact->force.setZero();
      b.contact->overlap = 0;
      touching_.erase(touching_.begin() + n);
    }
}

Vector3 RibContacts::relative_velocity(const RibContact& c, const Clumps& clumps,
                                       const Rib& rib) const
{
  const double n1 = 1 - c.xi, n2 = c.xi;
  const Vector3 clump_arm = c.point - clumps.position[c.i];
  return clumps.drift_velocity[c.i] + clumps.spin[c.i].cross(clump_arm) -
         (n1 * rib.v[0] + n2 * rib.v[1] + rod_spin(rib, c.xi).cross(c.arm));
}

void RibContacts::open(const Group& group, const Clumps& clumps, const std::vector<Rib>& ribs,
                       double time_step, ContactEnergy& energy)
{
  RibContact& c = *group.contact;
  c.xi = group.nearest.xi;
  const Vector3 relative = relative_velocity(c, clumps, ribs[group.rib]);
  end_contact(contact_, -group.nearest.overlap, relative, time_step, c.history, energy);
  c.force.setZero();
  c.overlap = 0;
}

void RibContacts::touch(const Group& group, const Clumps& clumps, const std::vector<Rib>& ribs,
                        double time_step, VectorField& force, VectorField& torque,
                        ContactEnergy& energy)
{
  RibContact& c = *group.contact;
  const Rib& rib = ribs[group.rib];
  RibProximity p = group.nearest;
  p.overlap -= c.shared;
  const double n1 = 1 - p.xi, n2 = p.xi;

  c.rib = group.rib;
  c.xi = p.xi;
  c.overlap = p.overlap;
  c.point = p.core + (rib.rounding - 0.5 * p.overlap) * p.normal;
  c.arm = c.point - p.centre;

  // Dashpots act on the reduced mass: the rib is far lighter than the stone.
  const double reduced_mass =
      1 / (1 / clumps.mass[c.i] + n1 * n1 * rib.inverse_mass[0] + n2 * n2 * rib.inverse_mass[1]);
  const Vector3 spin = 0.5 * (clumps.spin[c.i] + n1 * rib.w[0] + n2 * rib.w[1]);
  rotate_spring(c.history.spring, p.normal, spin.dot(p.normal) * time_step);
  c.force = linear_contact_force(contact_, reduced_mass, p.overlap, p.normal,
                                 relative_velocity(c, clumps, rib), time_step, c.history, energy);
  force[c.i] += c.force;
  torque[c.i] += (c.point - clumps.position[c.i]).cross(c.force);
  RibWrench wrench{group.rib, p.xi, -c.force, -c.arm.cross(c.force)};
  if (!p.lean.isZero(0)) {
    // Acts at the sphere's centre, on which the overlap depends.
    const Vector3 lean = contact_.normal_stiffness * p.overlap * p.lean;
    const Vector3 centre = p.core + p.distance * p.normal;
    force[c.i] += lean;
    torque[c.i] += (centre - clumps.position[c.i]).cross(lean);
    wrench.force -= lean;
    wrench.moment -= (centre - p.centre).cross(lean);
  }
  wrenches_.push_back(wrench);
}
} // namespace interlock::dem
