#include "dem/ribs.h"

#include <tuple>

namespace interlock::dem
{
namespace
{
auto key(const RibContact& c)
{
  return std::tie(c.i, c.a, c.line);
}

double distance_to_segment(const Vector3& p, const Vector3& a, const Vector3& b)
{
  const Vector3 d = b - a;
  const double t = std::clamp(d.dot(p - a) / d.squaredNorm(), 0., 1.);
  return (p - a - t * d).norm();
}

double section_reach(const Rib& rib)
{
  return std::sqrt(rib.half_width * rib.half_width + rib.half_thickness * rib.half_thickness);
}

// A bound on the speed of any point of a clump or a rib [m/s]: translation and rotation apart, so
// that one root serves all.
double fastest_point(const Clumps& clumps, const std::vector<Rib>& ribs)
{
  double moving = 0, turning = 0;
  for (int i = 0; i < clumps.size(); ++i) {
    const double reach = clumps.member_reach(i);
    moving = std::max(moving, clumps.velocity[i].squaredNorm());
    turning = std::max(turning, reach * reach * clumps.spin[i].squaredNorm());
  }
  for (const Rib& rib : ribs) {
    const double reach = section_reach(rib);
    for (int end : {0, 1}) {
      moving = std::max(moving, rib.v[end].squaredNorm());
      turning = std::max(turning, reach * reach * rib.w[end].squaredNorm());
    }
  }
  return std::sqrt(moving) + std::sqrt(turning);
}

// Whether a sphere is too far from the centre line to touch the rod. Without a root or a division.
bool clear_of(const Rib& rib, const Vector3& centre, double radius)
{
  const Vector3 chord = rib.x[1] - rib.x[0], d = centre - rib.x[0];
  const double along = chord.dot(d), square = chord.squaredNorm();
  const double reach = radius + rib.half_width + rib.half_thickness;
  if (along < 0) return d.squaredNorm() > reach * reach;
  if (along > square) return (centre - rib.x[1]).squaredNorm() > reach * reach;
  return d.squaredNorm() * square - along * along > reach * reach * square;
}

// Distance from a point to the flat core of a rib.
double distance_to_core(const Rib& rib, const Vector3& p)
{
  return rib_proximity(rib, p, 0).distance;
}
} // namespace

RibProximity rib_proximity(const Rib& rib, const Vector3& centre, double radius)
{
  RibProximity result;
  const Vector3 chord = rib.x[1] - rib.x[0];
  const double length_squared = chord.squaredNorm();
  result.xi = std::clamp(chord.dot(centre - rib.x[0]) / length_squared, 0., 1.);
  result.centre = rib.x[0] + result.xi * chord;

  // Section axes, made perpendicular to the chord so that the nearest point is exact.
  const Vector3 e1 = chord / std::sqrt(length_squared);
  const Vector3 width = (1 - result.xi) * rib.width_axis[0] + result.xi * rib.width_axis[1];
  const Vector3 across = width - width.dot(e1) * e1;
  const Vector3 e2 = across.normalized();
  const Vector3 e3 = e1.cross(e2);
  const Vector3 d = centre - result.centre;
  const double core_width = rib.half_width - rib.rounding;
  const double core_thickness = rib.half_thickness - rib.rounding;
  const double y = std::clamp(d.dot(e2), -core_width, core_width);
  const double z = std::clamp(d.dot(e3), -core_thickness, core_thickness);
  result.core = result.centre + y * e2 + z * e3;

  const Vector3 gap = centre - result.core;
  result.distance = gap.norm();
  result.overlap = radius + rib.rounding - result.distance;
  result.normal = result.distance > 1e-12 ? Vector3(gap / result.distance) : e3;
  const bool at_an_end = result.xi == 0 || result.xi == 1;
  const double twist = // of the section, per length [rad/m]
      at_an_end ? 0
                : e3.dot(rib.width_axis[1] - rib.width_axis[0]) /
                      std::sqrt(across.squaredNorm() * length_squared);
  result.lean = -twist * result.normal.dot(y * e3 - z * e2) * e1;
  return result;
}

namespace
{
// How the section at xi turns about the chord: e3 . d(e2) with e2 the width axis across the chord.
// d(e2) has the spins of both ends in it, and, where sections lean along the chord, its turn.
struct Turning {
  Vector3 spin_share[2]; // of each end's spin [-]
  Vector3 chord_share;   // of the velocity of end 2 against end 1 [1/m]
};

Turning turning_about_chord(const Rib& rib, double xi)
{
  const Vector3 chord = rib.x[1] - rib.x[0];
  const double length = chord.norm();
  const Vector3 e1 = chord / length;
  const Vector3 width = (1 - xi) * rib.width_axis[0] + xi * rib.width_axis[1];
  const double lean = width.dot(e1);
  const Vector3 across = width - lean * e1;
  const double across_length = across.norm();
  const Vector3 e3 = e1.cross(across / across_length);
  return {{(1 - xi) / across_length * rib.width_axis[0].cross(e3),
           xi / across_length * rib.width_axis[1].cross(e3)},
          -lean / (across_length * length) * e3};
}
} // namespace

Vector3 rod_spin(const Rib& rib, double xi)
{
  const Vector3 chord = rib.x[1] - rib.x[0], apart = rib.v[1] - rib.v[0];
  const Turning turning = turning_about_chord(rib, xi);
  const double roll = turning.spin_share[0].dot(rib.w[0]) + turning.spin_share[1].dot(rib.w[1]) +
                      turning.chord_share.dot(apart);
  return chord.cross(apart) / chord.squaredNorm() + roll * chord.normalized();
}

RodLoads rod_loads(const Rib& rib, const RibWrench& wrench)
{
  const Vector3 chord = rib.x[1] - rib.x[0];
  const double roll = wrench.moment.dot(chord.normalized());
  const Turning turning = turning_about_chord(rib, wrench.xi);
  const Vector3 couple =
      wrench.moment.cross(chord) / chord.squaredNorm() + roll * turning.chord_share;
  return {{(1 - wrench.xi) * wrench.force - couple, wrench.xi * wrench.force + couple},
          {roll * turning.spin_share[0], roll * turning.spin_share[1]}};
}

void RibContacts::clear()
{
  contacts_.clear();
  near_clumps_.clear();
  near_ribs_.clear();
  wrenches_.clear();
  valid_ = false;
}

void RibContacts::renumber_clumps(const std::vector<int>& new_index)
{
  contacts_.erase(std::remove_if(contacts_.begin(), contacts_.end(),
                                 [&](const RibContact& c) { return new_index[c.i] < 0; }),
                  contacts_.end());
  for (RibContact& c : contacts_) c.i = new_index[c.i];
  invalidate();
}

void RibContacts::update_list(const Clumps& clumps, const std::vector<Rib>& ribs, double time_step)
{
  // Clumps or ribs may have come since the list was made.
  if (clump_x_.size() != clumps.position.size() || rib_x_.size() != 2 * ribs.size()) valid_ = false;
  const double fastest = fastest_point(clumps, ribs);
  if (valid_) {
    double clump_moved = 0, clump_turned = 0, rib_moved = 0, rib_turned = 0;
    for (int i = 0; i < clumps.size(); ++i) {
      clump_moved = std::max(clump_moved, (clumps.position[i] - clump_x_[i]).squaredNorm());
      const double reach = clumps.member_reach(i);
      const Vector3 v = (clump_q_[i].conjugate() * clumps.orientation[i]).vec();
      clump_turned = std::max(clump_turned, reach * reach * v.squaredNorm());
    }
    for (std::size_t r = 0; r < ribs.size(); ++r) {
      const double reach = section_reach(ribs[r]);
      for (int end : {0, 1}) {
        rib_moved = std::max(rib_moved, (ribs[r].x[end] - rib_x_[2 * r + end]).squaredNorm());
        const Vector3 turn = ribs[r].width_axis[end] - rib_axis_[2 * r + end];
        rib_turned = std::max(rib_turned, reach * reach * turn.squaredNorm());
      }
    }
    const double used = std::sqrt(clump_moved) + 2 * std::sqrt(clump_turned) +
                        std::sqrt(rib_moved) + 2 * std::sqrt(rib_turned);
    // The list serves the sub-steps of the whole step to come.
    if (used + 2 * fastest * time_step <= skin_) return;
  }

  skin_ = std::clamp(2 * fastest * time_step * 40, 1e-4, 1e-3);
  build(clumps, ribs);
  valid_ = true;
}

void RibContacts::build(const Clumps& clumps, const std::vector<Rib>& ribs)
{
  clump_x_ = clumps.position;
  clump_q_ = clumps.orientation;
  rib_x_.clear();
  rib_axis_.clear();
  for (const Rib& rib : ribs) {
    rib_x_.insert(rib_x_.end(), {rib.x[0], rib.x[1]});
    rib_axis_.insert(rib_axis_.end(), {rib.width_axis[0], rib.width_axis[1]});
  }
  old_contacts_.swap(contacts_);
  contacts_.clear();
  candidate_ribs_.clear();
  near_clumps_.clear();
  std::vector<bool> rib_is_near(ribs.size(), false);
  std::vector<int> close_ribs;
  Vector3 low = Vector3::Constant(1e300), high = -low;
  for (const Vector3& x : rib_x_) low = low.cwiseMin(x), high = high.cwiseMax(x);
  double largest_section = 0;
  for (const Rib& rib : ribs) largest_section = std::max(largest_section, section_reach(rib));

  for (int i = 0; i < clumps.size(); ++i) {
    const double ball = clumps.bounding_radius(i) + skin_;
    close_ribs.clear();
    const Vector3& x = clumps.position[i];
    // Most clumps are far above or below the geogrid.
    const double margin = ball + largest_section;
    if ((x.array() < low.array() - margin).any() || (x.array() > high.array() + margin).any())
      continue;
    for (int r = 0; r < static_cast<int>(ribs.size()); ++r)
      if (distance_to_segment(x, ribs[r].x[0], ribs[r].x[1]) < ball + section_reach(ribs[r]))
        close_ribs.push_back(r);
    const std::size_t before = contacts_.size();
    const std::vector<Sphere>& spheres = clumps.shape_of(i).spheres;
    for (int a = 0; a < static_cast<int>(spheres.size()) && !close_ribs.empty(); ++a) {
      const Vector3 centre = clumps.position[i] + clumps.member_offset(i, a);
      // Ribs are ordered by line, so the candidates of one line follow one another.
      for (const int r : close_ribs) {
        if (rib_proximity(ribs[r], centre, spheres[a].radius).overlap < -skin_) continue;
        if (contacts_.size() == before || key(contacts_.back()) != std::tie(i, a, ribs[r].line)) {
          RibContact contact;
          contact.i = i, contact.a = a, contact.line = ribs[r].line;
          contact.first = contact.last = candidate_ribs_.size();
          contacts_.push_back(contact);
        }
        candidate_ribs_.push_back(r);
        contacts_.back().last = candidate_ribs_.size();
        rib_is_near[r] = true;
      }
    }
    if (contacts_.size() > before) near_clumps_.push_back(i);
  }
  near_ribs_.clear();
  for (int r = 0; r < static_cast<int>(ribs.size()); ++r)
    if (rib_is_near[r]) near_ribs_.push_back(r);

  auto old = old_contacts_.begin();
  for (RibContact& c : contacts_) {
    while (old != old_contacts_.end() && key(*old) < key(c)) ++old;
    if (old == old_contacts_.end()) break;
    if (key(*old) == key(c))
      c.history = old->history, c.force = old->force, c.rib = old->rib, c.xi = old->xi,
      c.point = old->point, c.arm = old->arm, c.overlap = old->overlap, c.shared = old->shared;
  }
}

const std::vector<RibWrench>& RibContacts::evaluate(const Clumps& clumps,
                                                    const std::vector<Rib>& ribs, double time_step,
                                                    std::vector<Vector3>& force,
                                                    std::vector<Vector3>& torque,
                                                    ContactEnergy& energy)
{
  energy.elastic = 0;
  wrenches_.clear();
  touching_.clear();
  for (std::size_t g = 0; g < contacts_.size(); ++g) {
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
    const bool last_of_sphere =
        g + 1 == contacts_.size() || contacts_[g + 1].i != c.i || contacts_[g + 1].a != c.a;
    if (!last_of_sphere) continue;
    if (touching_.size() > 1) merge_at_junctions(ribs, energy);
    for (const Group& t : touching_) touch(t, clumps, ribs, time_step, force, torque, energy);
    touching_.clear();
  }
  return wrenches_;
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
  return clumps.drift_velocity[c.i] + clumps.drift_spin[c.i].cross(clump_arm) -
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
                        double time_step, std::vector<Vector3>& force, std::vector<Vector3>& torque,
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
  const Vector3 spin = 0.5 * (clumps.drift_spin[c.i] + n1 * rib.w[0] + n2 * rib.w[1]);
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
