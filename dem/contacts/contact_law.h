// Contact laws with Coulomb friction: pure functions of one contact, for any number type: bundles
// of lanes for stones and walls (lanes/contact_forces.cc), plain numbers in vector lanes for ribs,
// one by one for walls of triangles (single_contact.h).
//
// Normal: spring and dashpot. Tangential: spring with history and dashpot, limited by the Coulomb
// cone; the spring turns with the contact. Linear: springs of two bodies act in series (Ferellec
// and McDowell 2010, Table 6, read with the usual k = k1 k2 / (k1 + k2)). Hertz-Mindlin: Hertz's
// normal force, Mindlin's no-slip stiffness at the present overlap (Johnson, Contact Mechanics,
// 1985, sections 4.2 and 7.2), dashpots of Antypov and Elliott, EPL 94 (2011) 50004. Either can
// crush: the elastic force is at most a pressure times the area of the cut, 2 pi R d
// (docs/theory/crushing.md).
#pragma once

#include "dem/contacts/contact_properties.h"
#include "dem/lane_vector.h"
#include "dem/vector.h"

#include <algorithm>
#include <cmath>

namespace interlock::dem
{
// What one contact has of a contact that the same two bodies share (contact_shares.cc).
template <class Number> struct ShareOf {
  Number depth = 0;    // overlap of the shared contact [m]
  Number gradient = 1; // of the depth by this contact's overlap: its part of the force [-]
};
using ContactShare = ShareOf<double>;

// Energy in the springs of one contact [J]: normal elastic `overlap` > 0 [m], tangential `spring`
// [m]. The share counts if contacts of this pair share anything.
double stored_energy(const ContactProperties& pair, double overlap, double reduced_radius,
                     double spring, const ContactShare& share);

// What one contact is made of; constant while it is on a list.
template <class Number> struct ConstantsOf {
  Number reduced_mass = 0;   // scales the dashpots [kg]
  Number root_mass = 0;      // its square root
  Number reduced_radius = 0; // r1 r2/(r1 + r2), of Hertz's law; the sphere's own at a plane [m]
};
using ContactConstants = ConstantsOf<double>;

// What a contact remembers, world frame, of body 1 against body 2. Zero while the contact is open.
template <class Number> struct HistoryOf {
  // Tangential displacement since it formed, less what slipped [m].
  LaneVector<Number> spring{0, 0, 0};
  LaneVector<Number> dashpot{0, 0, 0}; // dissipative part of the last force [N]
  Number overlap = 0;                  // of the geometry [m]
  Number tangential_stiffness = 0;     // of the last step [N/m]
  Number crushed = 0;                  // permanent part of the overlap, which makes no force [m]
};
using LaneHistory = HistoryOf<double>;

// The same with Eigen's vectors.
struct ContactHistory {
  Vector3 spring = Vector3::Zero();  // see LaneHistory [m]
  double overlap = 0;                // [m]
  Vector3 dashpot = Vector3::Zero(); // [N]
  double crushed = 0;                // see LaneHistory [m]
};

// What a law makes of an overlap: elastic force [N], tangential stiffness [N/m], dashpots [N s/m].
template <class Number> struct ResponseOf {
  Number force, tangential_stiffness, normal_dashpot, tangential_dashpot;
};

// The law of a pair with everything that is the same for all its contacts worked out.
struct LinearLaw {
  explicit LinearLaw(const ContactProperties& p)
      : k_n(p.normal_stiffness), k_t(p.tangential_stiffness),
        root_n(2 * p.damping_ratio * std::sqrt(k_n)), root_t(2 * p.damping_ratio * std::sqrt(k_t)),
        rate_n(p.normal_damping_rate), rate_t(p.tangential_damping_rate), friction(p.friction),
        lowest_force(p.tension ? -1e300 : 0), softness(k_t > 0 ? 1 / k_t : 0)
  {
  }
  double k_n, k_t, root_n, root_t, rate_n, rate_t, friction, lowest_force;
  double softness; // of the tangential spring [m/N]
  // Stored energy = this times force times overlap.
  static constexpr double energy_factor = 0.5;
  static constexpr double exponent = 1; // of the overlap
  static constexpr bool stiffness_changes = false;
  static constexpr bool crushes = false;

  template <class Number>
  INTERLOCK_LANE ResponseOf<Number> at(Number overlap, const ConstantsOf<Number>& c) const
  {
    return {k_n * overlap, k_t, root_n * c.root_mass + rate_n * c.reduced_mass,
            root_t * c.root_mass + rate_t * c.reduced_mass};
  }
};

struct HertzMindlinLaw {
  explicit HertzMindlinLaw(const ContactProperties& p)
      : modulus(p.effective_modulus), shear(p.effective_shear_modulus), ratio(p.damping_ratio),
        rate_n(p.normal_damping_rate), rate_t(p.tangential_damping_rate), friction(p.friction),
        lowest_force(p.tension ? -1e300 : 0)
  {
  }
  double modulus, shear, ratio, rate_n, rate_t, friction, lowest_force;
  static constexpr double energy_factor = 0.4;
  static constexpr double exponent = 1.5; // of the overlap
  static constexpr bool stiffness_changes = true;
  static constexpr bool crushes = false;

  template <class Number>
  INTERLOCK_LANE ResponseOf<Number> at(Number overlap, const ConstantsOf<Number>& c) const
  {
    const Number root = square_root(c.reduced_radius * overlap); // radius of the contact's circle
    const Number k_t = 8 * shear * root;
    // 2 sqrt(5/6) beta sqrt(S m), S: tangent stiffness.
    const Number damping = 2 * 0.91287092917527686 * ratio * c.root_mass;
    return {4. / 3 * modulus * root * overlap, k_t,
            damping * square_root(2 * modulus * root) + rate_n * c.reduced_mass,
            damping * square_root(k_t) + rate_t * c.reduced_mass};
  }
};

// A law whose contacts keep a part of their overlap for good, so that the elastic force stays
// within pressure times 2 pi R d, R: reduced radius, d: the whole overlap.
template <class Law> struct Crushing : Law {
  explicit Crushing(const ContactProperties& p)
      : Law(p), limit_per_area(2 * M_PI * p.crushing_pressure)
  {
  }
  double limit_per_area; // [Pa]
  static constexpr bool crushes = true;

  // The elastic part of an overlap > 0 of which `elastic` > 0 was elastic before this step. Exact
  // for linear springs; else one step of Newton's method, from the side of too large a force.
  template <class Number>
  INTERLOCK_LANE Number elastic_part(Number overlap, Number elastic,
                                     const ConstantsOf<Number>& c) const
  {
    const Number force = this->at(elastic, c).force,
                 limit = limit_per_area * (c.reduced_radius * overlap);
    const Number kept = 1 - (1 / Law::exponent) * (1 - limit / (force + 1e-200));
    return select(force > limit, kept * elastic, elastic);
  }
};

template <class Number> struct EnergyOf {
  Number elastic = 0, friction = 0, damping = 0;
  Number crushing = 0;
};
using LaneEnergy = EnergyOf<double>;

// Force on body 1, world frame [N]; exact zero, and the history cleared, when `overlap` is not
// positive. `normal` points from body 2 to body 1; `relative_velocity` is that of body 1 against
// body 2 at the contact point, in the middle of the step that led here [m/s]; `overlap`: negative
// is a gap [m]; `turn`: mean spin of the two bodies times the step [rad]; `share`: see
// ContactShare. Advances the history over `dt` [s]; adds to `energy`.
//
// The tangential spring first turns with the contact: by `turn`, then out of its plane into the one
// normal to `normal`, keeping its length. Where the stiffness changes, a
// growing one keeps the force and a falling one keeps the spring; either loses energy, none gains
// (the incremental no-slip law unloaded as Thornton, Cummins and Cleary, Powder Technology 233
// (2013) 30-46, demand).
//
// Energy: a leapfrog kick does the work of the mean of the forces at both ends of a step. So
// dashpots dissipate the mean of their old and new force times the relative motion, friction the
// mean spring force times the slip, and neither has an error of first order in the step. A contact
// that has opened fades its last dashpot force over the part of the step in which it still touched,
// and what its spring still holds is lost to friction. In a step in which a contact crushes, what
// the mean elastic force does over the whole overlap and the springs do not store is crushed; a
// contact that has been crushed opens where its elastic part ends, and forgets when the surfaces
// part.
template <bool shared, class Law, class Number>
INTERLOCK_LANE LaneVector<Number>
contact_force(const Law& law, const ConstantsOf<Number>& c, Number overlap,
              LaneVector<Number> normal, LaneVector<Number> relative_velocity,
              LaneVector<Number> turn, ShareOf<Number> share, double dt, HistoryOf<Number>& history,
              EnergyOf<Number>& energy)
{
  using Vector = LaneVector<Number>;
  constexpr bool stiffness_changes = shared || Law::stiffness_changes;
  const Number zero = 0;
  [[maybe_unused]] const Number whole = larger(overlap, zero);
  Number old_depth = history.overlap;
  if constexpr (Law::crushes) {
    old_depth = larger(history.overlap - history.crushed, zero);
    const Number before = select(overlap > zero, history.crushed, zero), elastic = overlap - before;
    overlap = select(elastic > zero, law.elastic_part(whole, larger(elastic, zero), c), elastic);
    const Number now = select(elastic > overlap, whole - overlap, before),
                 now_depth = larger(overlap, zero), old_force = law.at(old_depth, c).force,
                 new_force = law.at(now_depth, c).force,
                 work = 0.5 * ((old_force + new_force) * (whole - history.overlap)),
                 stored = Law::energy_factor * (new_force * now_depth - old_force * old_depth);
    energy.crushing = energy.crushing + select(now > before, work - stored, zero);
    history.crushed = now;
  }
  const auto touching = overlap > zero;
  const Number depth = larger(overlap, zero);
  Number law_depth = depth;
  if constexpr (shared) law_depth = select(touching, share.depth, depth);
  const ResponseOf<Number> response = law.at(law_depth, c);
  Number elastic_n = response.force, k_t = response.tangential_stiffness,
         c_t = response.tangential_dashpot;
  if constexpr (shared) {
    const Number rest = larger(share.gradient, zero);
    k_t = rest * k_t;
    c_t = rest * c_t;
  }
  Number softness = 0; // of the spring [m/N]
  if constexpr (stiffness_changes)
    softness = select(k_t > zero, 1 / k_t, zero);
  else
    softness = law.softness;
  // All forces of an open contact vanish with these.
  k_t = select(touching, k_t, zero);
  c_t = select(touching, c_t, zero);
  const Number c_n = select(touching, response.normal_dashpot, zero);

  // Turn the spring. One division serves its length and the time of opening; nothing here is so
  // small that the guards against 0/0 matter.
  const Number gap = depth - overlap;
  const Number old_square = dot(history.spring, history.spring);
  Vector spring = history.spring + cross(turn, history.spring);
  spring = spring - dot(normal, spring) * normal;
  const Number d1 = dot(spring, spring) + 1e-60, d2 = old_depth + gap + 1e-30;
  const Number inverse = 1 / (d1 * d2);
  // sqrt(1 + x) of a small x; whoever turns a contact by a right angle in one step has other
  // worries.
  const Number x = smaller(old_square * (d2 * inverse) - 1, 1);
  const Number stretch = 1 + x * (0.5 + x * (-0.125 + x * 0.0625));
  spring = stretch * spring;

  Number lost;
  if constexpr (stiffness_changes) {
    const Number before = history.tangential_stiffness;
    const Number keep = select(k_t > before, before / k_t, Number(1));
    lost = 0.5 * old_square * (before - k_t * keep * keep);
    spring = keep * spring;
  } else {
    lost = select(touching, zero, 0.5 * law.k_t * old_square);
  }

  const Number v_n = dot(relative_velocity, normal);
  Number f_n = larger(elastic_n - c_n * v_n, law.lowest_force);
  if constexpr (shared) {
    elastic_n = share.gradient * elastic_n;
    f_n = share.gradient * f_n;
  }
  const Vector v_t = relative_velocity - v_n * normal;
  const Vector trial = spring + dt * v_t;
  const Vector viscous = c_t * v_t;
  const Vector resisted = k_t * trial + viscous; // the tangential force is against it
  const Number limit = law.friction * larger(f_n, zero);
  const Number square = dot(resisted, resisted);
  const auto slides = square > limit * limit; // only where it touches
  // Sliding: the whole force is friction, and the spring is what holds it.
  const Number scale = select(slides, limit / square_root(square + 1e-200), Number(1));
  const Vector against = scale * resisted;
  const Vector held =
      select(slides, softness * against, select(touching, trial, Vector{zero, zero, zero}));
  const Number away = elastic_n - f_n;
  const Vector dashpot = away * normal + select(slides, Vector{zero, zero, zero}, viscous);

  // Over the share of the step in which the contact touched.
  const Number part = select(touching, Number(1), old_depth * (d1 * inverse));
  energy.damping =
      energy.damping + 0.5 * dt * (part * dot(history.dashpot + dashpot, relative_velocity));
  energy.friction = energy.friction + (0.5 * (k_t * dot(spring + held, trial - held)) + lost);
  energy.elastic =
      energy.elastic + (Law::energy_factor * (elastic_n * depth) + 0.5 * (k_t * dot(held, held)));

  history.spring = held;
  history.dashpot = dashpot;
  if constexpr (Law::crushes)
    history.overlap = whole;
  else
    history.overlap = depth;
  history.tangential_stiffness = k_t; // of every law: the next one may be another
  return f_n * normal - against;
}
} // namespace interlock::dem
