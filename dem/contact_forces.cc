// The hot loop: the contact law over all lanes, and the sums over clumps.
#include "dem/contact_lanes.h"

namespace interlock::dem
{
namespace
{
// Rows of the state that contacts read.
struct BodyRows {
  explicit BodyRows(const Clumps& c)
      : x(c.position.row(0)), y(c.position.row(1)), z(c.position.row(2)), qx(c.orientation.row(0)),
        qy(c.orientation.row(1)), qz(c.orientation.row(2)), qw(c.orientation.row(3)),
        vx(c.step_velocity.row(0)), vy(c.step_velocity.row(1)), vz(c.step_velocity.row(2)),
        wx(c.step_spin.row(0)), wy(c.step_spin.row(1)), wz(c.step_spin.row(2))
  {
  }
  const double* __restrict x, * __restrict y, * __restrict z;
  const double* __restrict qx, * __restrict qy, * __restrict qz, * __restrict qw;
  const double* __restrict vx, * __restrict vy, * __restrict vz;
  const double* __restrict wx, * __restrict wy, * __restrict wz;

  INTERLOCK_LANE Lane3 position(int i) const { return {x[i], y[i], z[i]}; }
  INTERLOCK_LANE LaneQuaternion attitude(int i) const { return {qx[i], qy[i], qz[i], qw[i]}; }
  INTERLOCK_LANE Lane3 velocity(int i) const { return {vx[i], vy[i], vz[i]}; }
  INTERLOCK_LANE Lane3 spin(int i) const { return {wx[i], wy[i], wz[i]}; }
};

template <class Number> struct Rows3 {
  template <class Field>
  explicit Rows3(Field& field) : x(field.row(0)), y(field.row(1)), z(field.row(2))
  {
  }
  Number* __restrict x, * __restrict y, * __restrict z;
  INTERLOCK_LANE Lane3 get(int k) const { return {x[k], y[k], z[k]}; }
  INTERLOCK_LANE void set(int k, Lane3 a) const { x[k] = a.x, y[k] = a.y, z[k] = a.z; }
};

// Rows of the lanes.
struct LaneRows {
  explicit LaneRows(ContactLanes& l)
      : i(l.i.data()), j(l.j.data()), centre1(l.centre1), centre2(l.centre2),
        radius1(l.radius1.row(0)), radius2(l.radius2.row(0)), mass(l.reduced_mass.row(0)),
        root_mass(l.root_mass.row(0)), radius(l.reduced_radius.row(0)),
        next_share(l.next_share.row(0)), spring(l.spring), dashpot(l.dashpot),
        overlap(l.overlap.row(0)), stiffness(l.tangential_stiffness.row(0)), share(l.share.row(0)),
        force(l.force), torque1(l.torque1), torque2(l.torque2), elastic(l.elastic.row(0)),
        friction(l.friction.row(0)), damping(l.damping.row(0)), sharing(l.sharing.row(0))
  {
  }
  const int* __restrict i, * __restrict j;
  Rows3<const double> centre1, centre2;
  const double* __restrict radius1, * __restrict radius2;
  const double* __restrict mass, * __restrict root_mass, * __restrict radius;
  const double* __restrict next_share;
  Rows3<double> spring, dashpot;
  double* __restrict overlap, * __restrict stiffness, * __restrict share;
  Rows3<double> force, torque1, torque2;
  double* __restrict elastic, * __restrict friction, * __restrict damping, * __restrict sharing;

  INTERLOCK_LANE ContactConstants constants(int k) const
  {
    return {mass[k], root_mass[k], radius[k]};
  }
  INTERLOCK_LANE LaneHistory history(int k) const
  {
    return {spring.get(k), dashpot.get(k), overlap[k], stiffness[k], share[k]};
  }
  INTERLOCK_LANE void keep(int k, const LaneHistory& h) const
  {
    spring.set(k, h.spring);
    dashpot.set(k, h.dashpot);
    overlap[k] = h.overlap;
    stiffness[k] = h.tangential_stiffness;
    share[k] = h.share;
  }
  INTERLOCK_LANE void energy(int k, const LaneEnergy& e) const
  {
    elastic[k] = e.elastic;
    friction[k] = e.friction;
    damping[k] = e.damping;
    sharing[k] = e.sharing;
  }
};

template <bool shared, class Law>
void pairs(const Clumps& clumps, const Law& law_of_pair, double dt, ContactLanes& lanes)
{
  const BodyRows bodies(clumps);
  const LaneRows rows(lanes);
  const Law law = law_of_pair;
  const int n = lanes.overlap.padded_size();
#pragma GCC ivdep
  for (int k = 0; k < n; ++k) {
    const int i = rows.i[k], j = rows.j[k];
    const Lane3 x1 = bodies.position(i), x2 = bodies.position(j);
    const Lane3 arm1 = rotate(bodies.attitude(i), rows.centre1.get(k));
    const Lane3 arm2 = rotate(bodies.attitude(j), rows.centre2.get(k));
    const Lane3 between = x1 - x2;
    const Lane3 d = between + (arm1 - arm2);
    const double square = dot(d, d);
    const double distance = std::sqrt(square > 1e-300 ? square : 1e-300);
    const double overlap = rows.radius1[k] + rows.radius2[k] - distance;
    const Lane3 normal = (1 / distance) * d;
    // The contact point is in the middle of the overlap, for both.
    const Lane3 r2 = arm2 + (rows.radius2[k] - 0.5 * overlap) * normal;
    const Lane3 r1 = r2 - between;
    const Lane3 w1 = bodies.spin(i), w2 = bodies.spin(j);
    const Lane3 relative =
        (bodies.velocity(i) - bodies.velocity(j)) + (cross(w1, r1) - cross(w2, r2));
    const double twist = 0.5 * dt * dot(w1 + w2, normal);

    LaneHistory history = rows.history(k);
    LaneEnergy energy;
    const Lane3 force =
        contact_force<shared>(law, rows.constants(k), overlap, normal, relative, twist,
                              shared ? rows.next_share[k] : 1, dt, history, energy);
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
  const Lane3 corner = lane(wall.corner), e1 = lane(wall.edge1), e2 = lane(wall.edge2),
              velocity = lane(wall.velocity);
  const double s1 = 1 / dot(e1, e1), s2 = 1 / dot(e2, e2);
#pragma GCC ivdep
  for (int k = segment.begin; k < segment.end; ++k) {
    const int i = rows.i[k];
    const Lane3 arm = rotate(bodies.attitude(i), rows.centre1.get(k));
    const Lane3 from_corner = (bodies.position(i) - corner) + arm;
    double s = s1 * dot(from_corner, e1), t = s2 * dot(from_corner, e2);
    s = s > 0 ? s : 0;
    s = s < 1 ? s : 1;
    t = t > 0 ? t : 0;
    t = t < 1 ? t : 1;
    const Lane3 d = from_corner - s * e1 - t * e2;
    const double square = dot(d, d);
    const double distance = std::sqrt(square > 1e-300 ? square : 1e-300);
    const double overlap = rows.radius1[k] - distance;
    const Lane3 normal = (1 / distance) * d;
    const Lane3 r = arm - (rows.radius1[k] - 0.5 * overlap) * normal;
    const Lane3 w = bodies.spin(i);
    const Lane3 relative = (bodies.velocity(i) - velocity) + cross(w, r);

    LaneHistory history = rows.history(k);
    LaneEnergy energy;
    const Lane3 force = contact_force<shared>(law, rows.constants(k), overlap, normal, relative,
                                              0.5 * dt * dot(w, normal),
                                              shared ? rows.next_share[k] : 1, dt, history, energy);
    rows.keep(k, history);
    rows.force.set(k, force);
    rows.torque1.set(k, cross(r, force));
    rows.energy(k, energy);
  }
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
  with_law(pair, [&](auto shared, const auto& law) {
    pairs<decltype(shared)::value>(clumps, law, dt, lanes);
  });
}

void evaluate_wall(const Clumps& clumps, const Wall& wall, double dt, WallSegment segment,
                   ContactLanes& lanes)
{
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
  energy.sharing += lanes.sharing[k];
}
} // namespace

int add_pair_forces(const ContactLanes& lanes, Clumps& clumps, ContactEnergy& energy)
{
  const double *overlap = lanes.overlap.row(0), *damping = lanes.damping.row(0);
  const Rows3<const double> f(lanes.force), t1(lanes.torque1), t2(lanes.torque2);
  const Rows3<double> force(clumps.force), torque(clumps.torque);
  const int n = lanes.size();
  int touching = 0;
  ContactEnergy all = energy;
  for (int k = 0; k < n;) {
    // The lanes of clump i follow one another.
    const int i = lanes.i[k];
    Lane3 sum{0, 0, 0}, moment{0, 0, 0};
    for (; k < n && lanes.i[k] == i; ++k) {
      if (overlap[k] <= 0 && damping[k] == 0) continue;
      add_energy(lanes, k, all);
      touching += overlap[k] > 0;
      const int j = lanes.j[k];
      sum = sum + f.get(k);
      moment = moment + t1.get(k);
      force.set(j, force.get(j) - f.get(k));
      torque.set(j, torque.get(j) + t2.get(k));
    }
    force.set(i, force.get(i) + sum);
    torque.set(i, torque.get(i) + moment);
  }
  energy = all;
  return touching;
}

int add_wall_forces(const ContactLanes& lanes, WallSegment segment, Clumps& clumps, Wall& wall,
                    ContactEnergy& energy)
{
  const double *overlap = lanes.overlap.row(0), *damping = lanes.damping.row(0);
  const Rows3<const double> f(lanes.force), t(lanes.torque1);
  const Rows3<double> force(clumps.force), torque(clumps.torque);
  int touching = 0;
  Lane3 sum{0, 0, 0};
  for (int k = segment.begin; k < segment.end; ++k) {
    if (overlap[k] <= 0 && damping[k] == 0) continue;
    add_energy(lanes, k, energy);
    touching += overlap[k] > 0;
    const int i = lanes.i[k];
    force.set(i, force.get(i) + f.get(k));
    torque.set(i, torque.get(i) + t.get(k));
    sum = sum - f.get(k);
  }
  wall.force = vector(sum);
  return touching;
}

double largest_overlap(const ContactLanes& lanes)
{
  return lanes.size() > 0 ? *std::max_element(lanes.overlap.begin(), lanes.overlap.end()) : 0;
}

void update_shares(int begin, int end, ContactLanes& lanes)
{
  for (int k = begin; k < end;) {
    double sum = 0, squares = 0;
    int last = k;
    for (; last < end && lanes.i[last] == lanes.i[k] && lanes.j[last] == lanes.j[k]; ++last) {
      sum += lanes.overlap[last];
      squares += lanes.overlap[last] * lanes.overlap[last];
    }
    const double share = sum > 0 ? squares / (sum * sum) : 1;
    for (; k < last; ++k) lanes.next_share[k] = share;
  }
}
} // namespace interlock::dem
