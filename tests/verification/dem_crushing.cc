// Contacts that crush, against closed forms: the path of force and overlap, what is left of an
// impact, and the work that crushing takes. With the slope s = 2 pi R p of the limit, linear
// springs of stiffness k > s lead up with s and back with k (Walton and Braun, J. Rheol. 30 (1986)
// 949), so an impact with speed v goes sqrt(m/s) v deep, rebounds with sqrt(s/k) v and leaves d (1
// - s/k) behind. Hertz's force 4/3 E sqrt(R) d^(3/2) meets the limit at d = R (3 pi p/(2 E))^2.
// Fails when the limit, the way back, the second loading, the friction's normal force or the
// energy is wrong, when a contact with a rib crushes otherwise than one with a wall, or when the
// energy of a crowd is lost on the way.
#include "tests/dem_bodies.h"
#include "tests/dem_crowd.h"
#include "tests/rib_touch.h"

using namespace bodies;

namespace
{
constexpr double R = 4e-3, pressure = 5e8, stiffness = 3e7; // [m], [Pa], [N/m]
const double slope = 2 * M_PI * R * pressure;

ContactProperties linear()
{
  ContactProperties pair = smooth_contact(stiffness, 0, false);
  pair.crushing_pressure = pressure;
  return pair;
}
ContactProperties hertz()
{
  ContactProperties pair = hertz_mindlin_pair({5e10, 0.25}, {1e30, 0}, 0, 0);
  pair.crushing_pressure = pressure;
  return pair;
}

// Force and energies of one contact that is led along a path of overlaps, in steps of 10 nm.
template <class Law> struct Path {
  Law law;
  LaneHistory history{};
  LaneEnergy energy{};
  double force = 0, work = 0, overlap = 0;

  void go_to(double end)
  {
    constexpr double step = 1e-8;
    const int n = static_cast<int>(std::ceil(std::abs(end - overlap) / step));
    const double begin = overlap;
    for (int i = 1; i <= n; ++i) {
      const double next = begin + (end - begin) * i / n, before = force;
      energy.elastic = 0;
      force = contact_force<false, Law, double>(law, {1e-3, std::sqrt(1e-3), R}, next, {0, 0, 1},
                                                {0, 0, (overlap - next) / 1e-6}, {0, 0, 0}, {},
                                                1e-6, history, energy)
                  .z;
      work += 0.5 * (before + force) * (next - overlap);
      overlap = next;
    }
  }
};
} // namespace

TEST(Crushing, LinearSpringsGoUpWithTheLimitAndBackWithTheirOwn)
{
  Path<Crushing<LinearLaw>> path{Crushing<LinearLaw>(linear())};
  const double deep = 5e-5, left = deep * (1 - slope / stiffness);
  path.go_to(0.5 * deep);
  EXPECT_NEAR(path.force, slope * 0.5 * deep, 1e-9 * slope * deep);
  path.go_to(deep);
  EXPECT_NEAR(path.force, slope * deep, 1e-9 * slope * deep);
  EXPECT_NEAR(path.history.crushed, left, 1e-9 * deep);
  path.go_to(0.8 * deep); // back, and up again, with the spring
  const double there = stiffness * (0.8 * deep - left);
  EXPECT_NEAR(path.force, there, 1e-9 * slope * deep);
  path.go_to(0.9 * left); // open, but not apart
  EXPECT_EQ(path.force, 0);
  EXPECT_EQ(path.energy.elastic, 0);
  path.go_to(0.8 * deep);
  EXPECT_NEAR(path.force, there, 1e-9 * slope * deep);
  const double crushed = 0.5 * slope * deep * deep * (1 - slope / stiffness);
  EXPECT_NEAR(path.energy.crushing, crushed, 1e-9 * crushed);
  EXPECT_NEAR(path.work, path.energy.elastic + path.energy.crushing, 2e-4 * path.work);
  path.go_to(1.5 * deep);
  // A step leads over the limit: its mean force is not that of the limit.
  EXPECT_NEAR(path.energy.crushing, 2.25 * crushed, 1e-7 * crushed);
  path.go_to(-1e-6); // apart: forgotten
  EXPECT_EQ(path.history.crushed, 0);
  EXPECT_NEAR(path.work, path.energy.crushing, 2e-4 * path.work);
}

TEST(Crushing, HertzUpToTheLimitThenStraight)
{
  const double modulus = hertz().effective_modulus,
               yield = R * std::pow(1.5 * M_PI * pressure / modulus, 2), deep = 4 * yield;
  const auto force = [&](double elastic) {
    return 4. / 3 * modulus * std::sqrt(R) * std::pow(elastic, 1.5);
  };
  Path<Crushing<HertzMindlinLaw>> path{Crushing<HertzMindlinLaw>(hertz())};
  path.go_to(0.99 * yield);
  EXPECT_NEAR(path.force, force(0.99 * yield), 1e-9 * path.force);
  EXPECT_EQ(path.history.crushed, 0);
  path.go_to(deep);
  EXPECT_NEAR(path.force, slope * deep, 1e-6 * path.force);
  // force(e) = slope deep
  const double elastic = std::pow(0.75 * slope * deep / (modulus * std::sqrt(R)), 2. / 3);
  EXPECT_NEAR(path.history.crushed, deep - elastic, 1e-6 * deep);
  const double work = 0.4 * force(yield) * yield + 0.5 * slope * (deep * deep - yield * yield),
               crushed = work - 0.4 * slope * deep * elastic;
  EXPECT_NEAR(path.energy.crushing, crushed, 1e-4 * crushed);
  EXPECT_NEAR(path.work, path.energy.elastic + path.energy.crushing, 1e-4 * path.work);
  const double back = deep - 0.5 * elastic;
  path.go_to(back);
  EXPECT_NEAR(path.force, force(0.5 * elastic), 1e-6 * path.force);
}

// Through the engine: a ball on a plane, and two balls, whose reduced radius is half.
TEST(Crushing, ImpactLeavesWhatTheClosedFormSays)
{
  constexpr double v = 0.3;
  for (const bool pair : {false, true}) {
    const double s = pair ? 0.5 * slope : slope;
    Engine engine({ball(R)}, linear(), 0);
    const double density = 2650, mass = density * ball(R).volume, m = pair ? 0.5 * mass : mass;
    const double dt = 1e-3 * std::sqrt(m / stiffness);
    engine.add_clump(0, density, {0, 0, R + 0.5 * dt * v}, Quaternion::Identity(), {0, 0, -v});
    if (pair)
      engine.add_clump(0, density, {0, 0, -R}, Quaternion::Identity());
    else
      engine.add_wall(plane(linear()));
    const Impact impact = run_impact(engine, dt);
    EXPECT_NEAR(impact.peak_overlap, v * std::sqrt(m / s), 1e-4 * impact.peak_overlap);
    EXPECT_NEAR(impact.peak_force, v * std::sqrt(m * s), 1e-4 * impact.peak_force);
    const Vector3 after = engine.clumps().velocity[0] -
                          (pair ? Vector3(engine.clumps().velocity[1]) : Vector3::Zero());
    EXPECT_NEAR(after.z(), v * std::sqrt(s / stiffness), 1e-4 * v);
    engine.compute_forces(dt);
    const EngineEnergy energy = engine.energy(dt);
    const double crushed = 0.5 * m * v * v * (1 - s / stiffness);
    EXPECT_NEAR(energy.contact.crushing, crushed, 2e-4 * crushed);
    EXPECT_NEAR(energy.kinetic + energy.contact.crushing, energy.inserted, 1e-6 * energy.inserted);
    record("crushed_energy_error", energy.contact.crushing / crushed - 1);
  }
}

// A packing that has crushed goes on under a law that does not: what was permanent is forgotten, in
// the force and wherever contacts are asked for.
TEST(Crushing, GoesOnWithoutIt)
{
  Engine engine({ball(R)}, linear(), 0);
  const double overlap = 1e-4, dt = 1e-7;
  engine.add_clump(0, 2650, {0, 0, 0}, Quaternion::Identity());
  engine.add_clump(0, 2650, {0, 0, 2 * R - overlap}, Quaternion::Identity());
  engine.compute_forces(dt);
  const double crushing = engine.clumps().force[1].z();
  EXPECT_LT(crushing, 0.6 * stiffness * overlap);
  engine.stone_contact().crushing_pressure = 0;
  engine.replace_clumps({engine.clumps().state_of(0), engine.clumps().state_of(1)},
                        engine.memory());
  engine.compute_forces(dt);
  EXPECT_NEAR(engine.clumps().force[1].z(), stiffness * overlap, 1e-9 * stiffness * overlap);
  EXPECT_EQ(engine.stable_step().contacts, 1);
  EXPECT_NEAR(engine.energy(dt).contact.elastic, 0.5 * stiffness * overlap * overlap, 1e-9);
}

// At a rib the same, with the radius of the sphere, and what it remembers goes on with the same
// digits.
TEST(Crushing, AtARibAndAfterARestart)
{
  Rib rib;
  rib.half_width = 2.5e-3, rib.half_thickness = 1.5e-3, rib.rounding = 0.5e-3;
  rib.x[0] = {-0.02, 0, 0}, rib.x[1] = {0.02, 0, 0};
  rib.width_axis[0] = rib.width_axis[1] = Vector3::UnitY();
  const RibSet ribs(std::vector<Rib>{rib});
  Clumps clumps({ball(R)});
  clumps.add(0, 2650, Vector3::Zero(), Quaternion::Identity());
  RibContacts contacts(linear());
  ContactEnergy energy;
  constexpr double deep = 5e-5, step = 1e-6;
  const auto press = [&](RibContacts& at, double overlap, ContactEnergy& spent) {
    clumps.position[0] = Vector3(0.003, 0, 1.5e-3 + R - overlap);
    return Vector3(touch_ribs(at, clumps, ribs, step, spent).clumps.force[0]).z();
  };
  for (int n = 1; n <= 50; ++n)
    EXPECT_NEAR(press(contacts, deep * n / 50, energy), slope * deep * n / 50, 1e-9 * slope * deep);
  RibContacts restarted(linear());
  restarted.restore(clumps, contacts.memory(clumps));
  ContactEnergy later;
  const double left = deep * (1 - slope / stiffness);
  for (const double overlap : {0.9 * deep, 0.5 * left, 0.95 * deep, deep, 1.2 * deep}) {
    const double before = energy.crushing, force = press(contacts, overlap, energy);
    const double expected = std::min(slope * overlap, stiffness * std::max(0., overlap - left));
    EXPECT_NEAR(force, expected, 1e-9 * slope * deep);
    const double crushed = later.crushing;
    EXPECT_EQ(press(restarted, overlap, later), force);
    EXPECT_EQ(later.crushing - crushed, energy.crushing - before);
    EXPECT_EQ(restarted.elastic_energies(), contacts.elastic_energies());
  }
  const double crushed = 0.5 * slope * 1.44 * deep * deep * (1 - slope / stiffness);
  EXPECT_NEAR(energy.crushing, crushed, 1e-6 * crushed);
}

// Thrown clumps of many spheres, some of them pressed together at the begin: motion, springs and
// what is booked as lost add up to the same at any time, as well as without crushing, to a factor
// of 2 for chance.
TEST(Crushing, LedgerOfACrowdClosesAsBefore)
{
  const auto total = [](const EngineEnergy& e) {
    return e.kinetic + e.gravitational + e.contact.elastic + e.contact.friction +
           e.contact.damping + e.contact.crushing - e.wall_work;
  };
  std::map<std::string, double> error;
  for (const crowd::Law& law : crowd::laws()) {
    if (law.pair.share_among_contacts) continue;
    Engine engine = crowd::thrown(5, law.pair).engine;
    engine.compute_forces(crowd::time_step);
    const EngineEnergy begin = engine.energy(crowd::time_step);
    engine.kick_all(crowd::time_step);
    engine.drift_all(crowd::time_step);
    for (int n = 0; n < 3000; ++n) engine.step(crowd::time_step);
    engine.compute_forces(crowd::time_step);
    const EngineEnergy end = engine.energy(crowd::time_step);
    const double work =
        begin.kinetic + begin.contact.elastic + begin.gravitational - end.gravitational;
    EXPECT_EQ(end.contact.crushing > 0.05 * work, law.pair.crushing_pressure > 0) << law.name;
    error[law.name] = std::abs(total(end) - total(begin)) / work;
    record("error_" + law.name, error[law.name]);
  }
  for (const std::string law : {"Linear", "HertzMindlin"})
    EXPECT_LT(error[law + "Crushing"], 2 * error[law] + 1e-4) << law;
}
