// Sliding, sticking and rolling on a plane, through the engine, against rigid-body mechanics.
//
// A block (a plate of 3 x 3 spheres) stops after v0/(mu g) and v0^2/(2 mu g); on a slope it sticks
// where tan <= mu, after a creep of m g sin over the stiffness, and slides with g (sin - mu cos)
// where tan > mu. A sphere that is set down sliding rolls after 2 v0/(7 mu g) and 12 v0^2/(49 mu g)
// with 5/7 v0. On a slope it rolls with 5/7 g sin where mu >= 2/7 tan, and slips with g (sin - mu
// cos) below. Springs are stiff and the bodies flat, so what is left of compliance is below the
// tolerances. Fails when friction, its history, its lever arm or the gravity on a tilted plane is
// wrong.
#include "tests/dem_bodies.h"

using namespace bodies;

namespace
{
constexpr double g = 9.81, R = 0.01, density = 2600;

ContactProperties rough_contact(double friction, double damping_ratio = 0.3)
{
  ContactProperties pair = smooth_contact(2e6, damping_ratio, false);
  pair.tangential_stiffness = 1e6;
  pair.friction = friction;
  return pair;
}

// 3 x 3 spheres, with the mass and inertia of a flat plate around them: low, so that it does not
// rock when friction stops it.
ClumpShape block()
{
  const double radius = 1e-3, spacing = 0.02, side = 0.05, height = 2 * radius;
  ClumpShape shape;
  for (int i : {-1, 0, 1})
    for (int j : {-1, 0, 1}) shape.spheres.push_back({{i * spacing, j * spacing, 0}, radius});
  shape.volume = side * side * height;
  const double tilt = shape.volume * (side * side + height * height) / 12;
  shape.unit_inertia = {tilt, tilt, shape.volume * side * side / 6};
  return shape;
}

// One body resting on a plane that falls by `slope` towards +x, in equilibrium across the plane.
struct Slope {
  Engine engine;
  Vector3 along, normal;
  double dt;

  Slope(const ClumpShape& shape, double slope, double friction, double step, double v0 = 0)
      : engine({shape}, {}, g), along(std::cos(slope), 0, -std::sin(slope)),
        normal(std::sin(slope), 0, std::cos(slope)), dt(step)
  {
    const ContactProperties contact = rough_contact(friction);
    engine.add_wall(plane(contact, slope));
    const double overlap = density * shape.volume * g * std::cos(slope) /
                           (contact.normal_stiffness * shape.spheres.size());
    const Quaternion lean(Eigen::AngleAxisd(slope, Vector3::UnitY()));
    engine.add_clump(0, density, (shape.spheres[0].radius - overlap) * normal, lean, v0 * along);
  }
  double travelled() const { return engine.clumps().position[0].dot(along); }
  double speed() const { return engine.clumps().velocity[0].dot(along); }
  double rolling_speed() const { return R * engine.clumps().spin[0].y(); }
  void run(double time)
  {
    for (int n = 0; n < std::lround(time / dt); ++n) engine.step(dt);
  }
};
constexpr double fine = 2e-6; // [s]
} // namespace

TEST(FrictionAndRolling, BlockStops)
{
  const double mu = 0.4, v0 = 0.3, time = v0 / (mu * g), way = v0 * v0 / (2 * mu * g);
  Slope slope(block(), 0, mu, fine, v0);
  slope.run(0.5 * time);
  EXPECT_NEAR(slope.speed(), 0.5 * v0, 2e-3 * v0);
  slope.run(0.5 * time);
  EXPECT_NEAR(slope.speed(), 0, 2e-3 * v0);
  slope.run(0.5 * time); // the dashpots calm the last springing
  EXPECT_NEAR(slope.travelled(), way, 1e-3 * way);
  EXPECT_NEAR(slope.speed(), 0, 1e-6 * v0);
  record("way_error", slope.travelled() / way - 1);
}

// The creep is F/k_t and, as friction attacks R below the centre and leans the block forwards on
// its outer rows, F R^2/(k_n times the sum of the squared distances of the spheres from the middle
// row). The hind row carries the less for it and would slip alone at once near the threshold; it
// hands its share to the others. So the creep is measured with much friction, then the friction
// lowered.
TEST(FrictionAndRolling, BlockOnSlopeSticksBelowTheThreshold)
{
  const double mu = 0.5, angle = std::atan(mu) - 0.01;
  const ClumpShape shape = block();
  Slope slope(shape, angle, 2, fine);
  slope.run(0.05);
  const double pull = density * shape.volume * g * std::sin(angle);
  const double creep = pull * (1 / (9 * 1e6) + 1e-6 / (6 * 2e6 * 4e-4));
  EXPECT_NEAR(slope.travelled(), creep, 1e-4 * creep);
  record("creep_error", slope.travelled() / creep - 1);
  slope.engine.walls()[0].contact.friction = mu;
  slope.run(0.1);
  const double settled = slope.travelled();
  EXPECT_LT(settled, 1.02 * creep);
  slope.run(0.1);
  EXPECT_NEAR(slope.travelled(), settled, 1e-6 * creep);
}

TEST(FrictionAndRolling, BlockOnSlopeSlidesAboveTheThreshold)
{
  const double mu = 0.5;
  for (const double above : {0.01, 0.1}) {
    const double angle = std::atan(mu) + above;
    const double a = g * (std::sin(angle) - mu * std::cos(angle));
    Slope slope(block(), angle, mu, fine);
    slope.run(0.1);
    const double early = slope.speed();
    slope.run(0.2);
    EXPECT_NEAR((slope.speed() - early) / 0.2, a, 1e-3 * a);
    record("acceleration_error", (slope.speed() - early) / 0.2 / a - 1);
  }
}

TEST(FrictionAndRolling, SlidingSphereComesToRoll)
{
  const double mu = 0.3, v0 = 0.5, time = 2 * v0 / (7 * mu * g);
  const double way = 12 * v0 * v0 / (49 * mu * g);
  Slope slope(ball(R), 0, mu, fine, v0);
  slope.run(0.5 * time);
  EXPECT_NEAR(slope.speed(), v0 - mu * g * 0.5 * time, 1e-3 * v0);
  EXPECT_NEAR(slope.rolling_speed(), 2.5 * mu * g * 0.5 * time, 1e-3 * v0);
  slope.run(0.5 * time);
  EXPECT_NEAR(slope.travelled(), way, 1e-3 * way);
  slope.run(time);
  EXPECT_NEAR(slope.speed(), 5. / 7 * v0, 1e-3 * v0);
  EXPECT_NEAR(slope.rolling_speed(), slope.speed(), 1e-3 * v0);
  record("speed_error", slope.speed() / (5. / 7 * v0) - 1);
}

// Friction above and below 2/7 tan.
TEST(FrictionAndRolling, SphereOnSlopeRollsOrSlips)
{
  const double angle = 0.5, threshold = 2. / 7 * std::tan(angle), time = 0.2;
  for (const double mu : {1.05 * threshold, 0.95 * threshold, 0.5 * threshold}) {
    Slope slope(ball(R), angle, mu, fine);
    const double friction = std::min(2. / 7 * std::sin(angle), mu * std::cos(angle)) * g;
    const double a = g * std::sin(angle) - friction;
    slope.run(0.1);
    const double v = slope.speed(), w = slope.rolling_speed();
    slope.run(time);
    EXPECT_NEAR((slope.speed() - v) / time, a, 1e-3 * a) << mu / threshold;
    EXPECT_NEAR((slope.rolling_speed() - w) / time, 2.5 * friction, 2e-3 * a) << mu / threshold;
    if (mu > threshold) {
      EXPECT_NEAR(slope.rolling_speed(), slope.speed(), 1e-3 * slope.speed());
    } else {
      EXPECT_LT(slope.rolling_speed(), 0.97 * slope.speed());
    }
    record("acceleration_error", (slope.speed() - v) / time / a - 1);
  }
}
