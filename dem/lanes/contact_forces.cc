// The hot loop: the contact law over all lanes, and the sums over clumps.
#include "dem/lanes/contact_lanes.h"

#include "dem/bodies/field_rows.h"

namespace interlock::dem
{
namespace
{
// Rows of the state that contacts read.
struct BodyRows {
  explicit BodyRows(const Clumps& c)
      : positions(c.position), attitudes(c.orientation), velocities(c.step_velocity),
        spins(c.step_spin)
  {
  }
  Rows3<const double> positions;
  QuaternionRows<const double> attitudes;
  Rows3<const double> velocities, spins;

  INTERLOCK_LANE Lane3 position(std::int64_t i) const { return positions.get(i); }
  INTERLOCK_LANE LaneQuaternion attitude(std::int64_t i) const { return attitudes.get(i); }
  INTERLOCK_LANE Lane3 velocity(std::int64_t i) const { return velocities.get(i); }
  INTERLOCK_LANE Lane3 spin(std::int64_t i) const { return spins.get(i); }
};

// Rows of the lanes.
struct LaneRows {
  explicit LaneRows(ContactLanes& l)
      : i(l.i.data()), j(l.j.data()), centre1(l.centre1), centre2(l.centre2),
        radius1(l.radius1.row(0)), radius2(l.radius2.row(0)), mass(l.reduced_mass.row(0)),
        root_mass(l.root_mass.row(0)), radius(l.reduced_radius.row(0)),
        shared_depth(l.shared_depth.row(0)), gradient(l.gradient.row(0)), spring(l.spring),
        dashpot(l.dashpot), overlap(l.overlap.row(0)), stiffness(l.tangential_stiffness.row(0)),
        force(l.force), torque1(l.torque1), torque2(l.torque2), elastic(l.elastic.row(0)),
        friction(l.friction.row(0)), damping(l.damping.row(0))
  {
  }
  const std::int64_t* __restrict i, * __restrict j;
  Rows3<const double> centre1, centre2;
  const double* __restrict radius1, * __restrict radius2;
  const double* __restrict mass, * __restrict root_mass, * __restrict radius;
  const double* __restrict shared_depth, * __restrict gradient;
  Rows3<double> spring, dashpot;
  double* __restrict overlap, * __restrict stiffness;
  Rows3<double> force, torque1, torque2;
  double* __restrict elastic, * __restrict friction, * __restrict damping;

  INTERLOCK_LANE ContactConstants constants(std::int64_t k) const
  {
    return {mass[k], root_mass[k], radius[k]};
  }
  template <bool shared> INTERLOCK_LANE ContactShare share(std::int64_t k) const
  {
    if constexpr (shared)
      return {shared_depth[k], gradient[k]};
    else
      return {};
  }
  INTERLOCK_LANE LaneHistory history(std::int64_t k) const
  {
    return {spring.get(k), dashpot.get(k), overlap[k], stiffness[k]};
  }
  INTERLOCK_LANE void keep(std::int64_t k, const LaneHistory& h) const
  {
    spring.set(k, h.spring);
    dashpot.set(k, h.dashpot);
    overlap[k] = h.overlap;
    stiffness[k] = h.tangential_stiffness;
  }
  INTERLOCK_LANE void energy(std::int64_t k, const LaneEnergy& e) const
  {
    elastic[k] = e.elastic;
    friction[k] = e.friction;
    damping[k] = e.damping;
  }
};

// Of a sphere against another one, world frame: returns the overlap, negative for a gap [m]; sets
// `normal`, from the second body to the first, and `arm`, from the centre of mass of clump i to the
// contact point in the middle of the overlap [m]. Plain numbers, since the compiler does not take
// returned structures apart.
INTERLOCK_LANE double pair_geometry(const BodyRows& bodies, const LaneRows& rows, std::int64_t k,
                                    Lane3& normal, Lane3& arm)
{
  const std::int64_t i = rows.i[k], j = rows.j[k];
  const Lane3 arm1 = rotate(bodies.attitude(i), rows.centre1.get(k));
  const Lane3 arm2 = rotate(bodies.attitude(j), rows.centre2.get(k));
  const Lane3 between = bodies.position(i) - bodies.position(j);
  const Lane3 d = between + (arm1 - arm2);
  const double square = dot(d, d);
  const double distance = std::sqrt(square + 1e-300);
  const double overlap = rows.radius1[k] + rows.radius2[k] - distance;
  const double inverse = 1 / distance, depth = rows.radius1[k] - 0.5 * overlap;
  normal.x = inverse * d.x, normal.y = inverse * d.y, normal.z = inverse * d.z;
  arm.x = arm1.x - depth * normal.x, arm.y = arm1.y - depth * normal.y;
  arm.z = arm1.z - depth * normal.z;
  return overlap;
}

// A wall's rectangle, worked out once for all its lanes.
struct WallPlane {
  explicit WallPlane(const Wall& wall)
      : corner(lane(wall.corner)), e1(lane(wall.edge1)), e2(lane(wall.edge2)), s1(1 / dot(e1, e1)),
        s2(1 / dot(e2, e2))
  {
  }
  Lane3 corner, e1, e2;
  double s1, s2;
};

// The same of a sphere against a wall.
INTERLOCK_LANE double wall_geometry(const BodyRows& bodies, const LaneRows& rows,
                                    const WallPlane& wall, std::int64_t k, Lane3& normal,
                                    Lane3& arm)
{
  const std::int64_t i = rows.i[k];
  const Lane3 arm1 = rotate(bodies.attitude(i), rows.centre1.get(k));
  const Lane3 from_corner = (bodies.position(i) - wall.corner) + arm1;
  double s = wall.s1 * dot(from_corner, wall.e1), t = wall.s2 * dot(from_corner, wall.e2);
  s = s > 0 ? s : 0;
  s = s < 1 ? s : 1;
  t = t > 0 ? t : 0;
  t = t < 1 ? t : 1;
  const Lane3 d = from_corner - s * wall.e1 - t * wall.e2;
  const double square = dot(d, d);
  const double distance = std::sqrt(square + 1e-300);
  const double overlap = rows.radius1[k] - distance;
  const double inverse = 1 / distance, depth = rows.radius1[k] - 0.5 * overlap;
  normal.x = inverse * d.x, normal.y = inverse * d.y, normal.z = inverse * d.z;
  arm.x = arm1.x - depth * normal.x, arm.y = arm1.y - depth * normal.y;
  arm.z = arm1.z - depth * normal.z;
  return overlap;
}

template <bool shared, class Law>
void pairs(const Clumps& clumps, const Law& law_of_pair, double dt, ContactLanes& lanes)
{
  const BodyRows bodies(clumps);
  const LaneRows rows(lanes);
  const Law law = law_of_pair;
  const int n = lanes.overlap.padded_size();
#pragma GCC ivdep
  for (std::int64_t k = 0; k < n; ++k) {
    const std::int64_t i = rows.i[k], j = rows.j[k];
    Lane3 normal, r1;
    const double overlap = pair_geometry(bodies, rows, k, normal, r1);
    // The contact point is the same for both.
    const Lane3 r2 = r1 + (bodies.position(i) - bodies.position(j));
    const Lane3 w1 = bodies.spin(i), w2 = bodies.spin(j);
    const Lane3 relative =
        (bodies.velocity(i) - bodies.velocity(j)) + (cross(w1, r1) - cross(w2, r2));
    const double twist = 0.5 * dt * dot(w1 + w2, normal);

    LaneHistory history = rows.history(k);
    LaneEnergy energy;
    const Lane3 force = contact_force<shared>(law, rows.constants(k), overlap, normal, relative,
                                              twist, rows.share<shared>(k), dt, history, energy);
    rows.keep(k, history);
    rows.force.set(k, force);
    rows.torque1.set(k, cross(r1, force));
    rows.torque2.set(k, cross(force, r2));
    rows.energy(k, energy);
  }
}

template <bool shared, class Law>
void wall_lanes(const Clumps& clumps, const Law& law_of_wall, const Wall& wall, double dt,
                WallSegment segment, ContactLanes& lanes)
{
  const BodyRows bodies(clumps);
  const LaneRows rows(lanes);
  const Law law = law_of_wall;
  const WallPlane plane(wall);
  const Lane3 velocity = lane(wall.velocity);
  const int end = padded(segment.end); // whole registers, see component_arrays.h
#pragma GCC ivdep
  for (std::int64_t k = segment.begin; k < end; ++k) {
    const std::int64_t i = rows.i[k];
    Lane3 normal, r;
    const double overlap = wall_geometry(bodies, rows, plane, k, normal, r);
    const Lane3 w = bodies.spin(i);
    const Lane3 relative = (bodies.velocity(i) - velocity) + cross(w, r);

    LaneHistory history = rows.history(k);
    LaneEnergy energy;
    const Lane3 force = contact_force<shared>(law, rows.constants(k), overlap, normal, relative,
                                              0.5 * dt * dot(w, normal), rows.share<shared>(k), dt,
                                              history, energy);
    rows.keep(k, history);
    rows.force.set(k, force);
    rows.torque1.set(k, cross(r, force));
    rows.energy(k, energy);
  }
}

// Overlaps now, before the law, into lanes.elastic.
template <class Overlap>
void measure(ContactLanes& lanes, int begin, int end, const Overlap& overlap)
{
  double* __restrict result = lanes.elastic.row(0);
#pragma GCC ivdep
  for (std::int64_t k = begin; k < end; ++k) result[k] = overlap(k);
}

// Calls f with the law that the properties name.
template <class Function> void with_law(const ContactProperties& pair, const Function& f)
{
  using Shared = std::true_type;
  using Plain = std::false_type;
  const bool shared = pair.share_among_contacts;
  if (pair.model == ContactModel::linear && !shared) f(Plain(), LinearLaw(pair));
  if (pair.model == ContactModel::linear && shared) f(Shared(), LinearLaw(pair));
  if (pair.model == ContactModel::hertz_mindlin && !shared) f(Plain(), HertzMindlinLaw(pair));
  if (pair.model == ContactModel::hertz_mindlin && shared) f(Shared(), HertzMindlinLaw(pair));
}
} // namespace

void evaluate_pairs(const Clumps& clumps, const ContactProperties& pair, double dt,
                    ContactLanes& lanes)
{
  if (pair.share_among_contacts) {
    measure(lanes, 0, lanes.overlap.padded_size(),
            [bodies = BodyRows(clumps), rows = LaneRows(lanes)](std::int64_t k) {
              Lane3 normal, arm;
              return pair_geometry(bodies, rows, k, normal, arm);
            });
    share_contacts(0, lanes.size(), lanes);
  }
  with_law(pair, [&](auto shared, const auto& law) {
    pairs<decltype(shared)::value>(clumps, law, dt, lanes);
  });
}

void evaluate_wall(const Clumps& clumps, const Wall& wall, double dt, WallSegment segment,
                   ContactLanes& lanes)
{
  if (wall.contact.share_among_contacts) {
    measure(lanes, segment.begin, padded(segment.end),
            [bodies = BodyRows(clumps), rows = LaneRows(lanes),
             plane = WallPlane(wall)](std::int64_t k) {
              Lane3 normal, arm;
              return wall_geometry(bodies, rows, plane, k, normal, arm);
            });
    share_contacts(segment.begin, segment.end, lanes);
  }
  with_law(wall.contact, [&](auto shared, const auto& law) {
    wall_lanes<decltype(shared)::value>(clumps, law, wall, dt, segment, lanes);
  });
}

namespace
{
// What a contact that has just opened lost counts, too.
INTERLOCK_LANE void add_energy(const ContactLanes& lanes, int k, ContactEnergy& energy)
{
  energy.elastic += lanes.elastic[k];
  energy.friction += lanes.friction[k];
  energy.damping += lanes.damping[k];
}

int count_touching(const ContactLanes& lanes, int begin, int end)
{
  const double* overlap = lanes.overlap.row(0);
  int touching = 0;
  for (int k = begin; k < end; ++k) touching += overlap[k] > 0;
  return touching;
}
} // namespace

// Without branches: a lane that does not touch adds zeros, so that lanes which are only about to
// touch change no digit. Runs of one clump, kept in registers, cost more in mispredicted ends than
// they save.
int add_pair_forces(const ContactLanes& lanes, WrenchSums& sums, ContactEnergy& energy)
{
  const int n = lanes.overlap.padded_size();
  ContactEnergy all = energy;
  for (int k = 0; k < n; k += 4) {
    const auto force = quads(lanes.force, k), torque1 = quads(lanes.torque1, k),
               torque2 = quads(lanes.torque2, k);
    for (int l = 0; l < 4; ++l) {
      sums.add(lanes.i[k + l], force[l], torque1[l]);
      sums.add(lanes.j[k + l], -force[l], torque2[l]);
      add_energy(lanes, k + l, all);
    }
  }
  energy = all;
  return count_touching(lanes, 0, n);
}

int add_wall_forces(const ContactLanes& lanes, WallSegment segment, WrenchSums& sums, Wall& wall,
                    ContactEnergy& energy)
{
  const int end = padded(segment.end);
  Quad on_stones{};
  for (int k = segment.begin; k < end; k += 4) {
    const auto force = quads(lanes.force, k), torque = quads(lanes.torque1, k);
    for (int l = 0; l < 4; ++l) {
      sums.add(lanes.i[k + l], force[l], torque[l]);
      on_stones += force[l];
      add_energy(lanes, k + l, energy);
    }
  }
  wall.force = {-on_stones[0], -on_stones[1], -on_stones[2]};
  return count_touching(lanes, segment.begin, end);
}

double largest_overlap(const ContactLanes& lanes)
{
  return lanes.size() > 0 ? *std::max_element(lanes.overlap.begin(), lanes.overlap.end()) : 0;
}
} // namespace interlock::dem
