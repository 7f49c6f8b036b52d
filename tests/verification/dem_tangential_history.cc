// The tangential spring over loading cycles and rigid rotations, through the engine.
//
// Cycle: F = min(k_t u, mu N) with history, so a closed loop of amplitude u_a > mu N/k_t has the
// area 4 mu N (u_a - mu N/k_t). Rotation: a loaded contact that turns rigidly carries its force
// along and stores and loses nothing, and nothing creeps. Fails when the spring is not kept, not
// turned with the contact, turned about a wrong axis, or slips inside the cone. Expected: exact to
// the sampling of the corners of the loop (first order in the step); second order in the rotation
// per step.
#include "tests/dem_bodies.h"

using namespace bodies;

// A slanted wall is moved to and fro under a sphere that stands still.
TEST(TangentialHistory, AreaOfTheLoop)
{
  ContactProperties contact = smooth_contact(1e7, 0, false);
  contact.tangential_stiffness = 2e6;
  contact.friction = 0.5;
  const double overlap = 1e-5, R = 0.01, limit = 0.5 * 1e7 * overlap, slope = 0.7;
  const double amplitude = 3 * limit / 2e6, dt = 1e-3;
  Engine engine({ball(R)}, {}, 0);
  engine.add_wall(plane(contact, slope));
  const Vector3 normal(std::sin(slope), 0, std::cos(slope));
  const Vector3 along = Vector3(0.6 * std::cos(slope), 0.8, -0.6 * std::sin(slope));
  engine.add_clump(0, 2600, (R - overlap) * normal, Quaternion::Identity());

  Wall& wall = engine.walls()[0];
  const int steps = 4000; // in a quarter of a loop
  double area = 0, old_force = 0, largest = 0;
  engine.compute_forces(dt);
  const auto move = [&](int direction, int quarters) {
    wall.velocity = direction * amplitude / (steps * dt) * along;
    for (int n = 0; n < quarters * steps; ++n) {
      engine.move_walls(dt);
      engine.compute_forces(dt);
      const double force = -wall.force.dot(along);
      area += 0.5 * (force + old_force) * dt * wall.velocity.dot(along);
      old_force = force;
      largest = std::max(largest, std::abs(force));
      ASSERT_NEAR(wall.force.dot(normal), -1e7 * overlap, 1e-6 * limit);
    }
  };
  move(1, 1);
  move(-1, 2);
  const double friction_before = engine.energy(dt).contact.friction,
               exact = 4 * limit * (amplitude - limit / 2e6);
  for (int loop = 1; loop <= 3; ++loop) {
    area = 0;
    move(1, 2);
    move(-1, 2);
    EXPECT_NEAR(area, exact, 1e-3 * exact);
    EXPECT_NEAR(engine.energy(dt).contact.friction - friction_before, loop * exact,
                1e-3 * loop * exact);
  }
  EXPECT_NEAR(largest, limit, 1e-9 * limit);
  record("area_error", area / exact - 1);
}

namespace
{
// A sphere between the two jaws of a clump. The jaws stand `squeeze` below its middle (angle of the
// contacts), so that they would press it out if friction did not hold it: both contacts are loaded
// with a tangential force of tan(squeeze) times the normal one, in equilibrium with each other.
// Both bodies have the same moments about all axes and may spin freely as one.
Engine gripped_sphere(double squeeze, double overlap)
{
  const double R = 0.01;
  ClumpShape jaws = ball(2 * R);
  jaws.spheres.clear();
  for (const int side : {-1, 1})
    jaws.spheres.push_back(
        {(2 * R - overlap) * Vector3(side * std::cos(squeeze), 0, -std::sin(squeeze)), R});
  ContactProperties pair = smooth_contact(1e6, 0.5, false);
  pair.tangential_stiffness = 5e5;
  pair.friction = 0.5;
  Engine engine({jaws, ball(R)}, pair, 0);
  engine.add_clump(0, 2600, Vector3::Zero(), Quaternion::Identity());
  engine.add_clump(1, 2600, Vector3::Zero(), Quaternion::Identity());
  return engine;
}
} // namespace

TEST(TangentialHistory, LoadTurnsWithAStuckPair)
{
  const double squeeze = std::atan(0.3), dt = 5e-6, turn_time = 0.2, overlap = 2e-6;
  for (const Vector3& axis : {Vector3(1, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1),
                              Vector3(Vector3(1, -2, 0.5).normalized())}) {
    Engine engine = gripped_sphere(squeeze, overlap);
    for (int n = 0; n < 4000; ++n) engine.step(dt);
    const Clumps& clumps = engine.clumps();
    const auto contact_force = [&] { // on the sphere, frame of the jaws, of one contact
      const Vector3 force = engine.sphere_contacts()[0].force;
      return Vector3(clumps.orientation[0].conjugate() * force);
    };
    // Equilibrium alone would keep this force: a spring that is left behind shows as a creep. Of
    // place and attitude of the sphere in the frame of the jaws, all but the turn about the line
    // between the contacts (along x), which nothing resists.
    const auto place = [&] {
      const Quaternion back = clumps.orientation[0].conjugate();
      const Vector3 x = clumps.position[1] - clumps.position[0];
      const Quaternion turn = back * Quaternion(clumps.orientation[1]);
      const Vector3 moved = back * x, turned = 2 * 0.01 * turn.vec();
      return Eigen::Vector4d(moved.x(), moved.z(), turned.y(), turned.z());
    };
    const Vector3 at_rest = contact_force();
    const Eigen::Vector4d first_place = place();
    EXPECT_NEAR(std::abs(at_rest.x()), at_rest.norm(), 1e-3 * at_rest.norm()); // from jaw to jaw

    engine.stone_contact().damping_ratio = 0;
    const Vector3 spin = 2 * M_PI / turn_time * axis;
    const Vector3 centre =
        (clumps.mass[0] * clumps.position[0] + clumps.mass[1] * clumps.position[1]) /
        (clumps.mass[0] + clumps.mass[1]);
    for (const int i : {0, 1}) {
      set_spin(engine, i, spin);
      engine.clumps().velocity[i] = spin.cross(clumps.position[i] - centre);
    }
    engine.compute_forces(dt);
    const EngineEnergy before = engine.energy(dt);
    double worst = 0, creep = 0;
    for (int n = 0; n < std::lround(turn_time / dt); ++n) {
      engine.step(dt);
      worst = std::max(worst, (contact_force() - at_rest).norm() / at_rest.norm());
      creep = std::max(creep, (place() - first_place).norm());
    }
    const EngineEnergy after = engine.energy(dt);
    EXPECT_LT(worst, 1e-3) << axis.transpose();
    EXPECT_LT(creep, 1e-3 * overlap) << axis.transpose();
    EXPECT_EQ(after.contact.friction, before.contact.friction);
    EXPECT_NEAR(after.contact.elastic, before.contact.elastic, 1e-3 * before.contact.elastic);
    EXPECT_NEAR(after.kinetic, before.kinetic, 1e-6 * before.kinetic);
    record("force_error", worst);
    record("creep_over_overlap", creep / overlap);
  }
}
