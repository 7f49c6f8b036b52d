// Moving walls of triangles and their ledger. Belt: a body that cannot roll reaches the speed of
// the belt after V/(mu g), half of the belt's work M V^2 becomes heat; a ball rolls on with 2/7 V
// (sliding friction ends when its lowest point moves with the belt). Drum: the wall moves with w x
// r, so a ball at the bottom of a drum that turns about +y is dragged to -x with mu g and spun
// about +y with 5/2 mu g/r. Fails when a sign or an arm is wrong, work is booked twice or late, or
// the frame of the wall shows in the result.
#include "tests/dem_wall_bench.h"

#include <gtest/gtest.h>

using namespace wall_bench;

namespace
{
constexpr double r = 0.01, k = 1e6, g = 9.81;

// Three balls in a triangle: slides, but does not roll.
ClumpShape tripod()
{
  ClumpShape shape;
  shape.spheres = {{{0.02, 0, 0}, r}, {{-0.01, 0.0173, 0}, r}, {{-0.01, -0.0173, 0}, r}};
  shape.volume = 1.2e-5;
  shape.unit_inertia = shape.volume * Vector3(2.4e-4, 2.4e-4, 4e-4);
  return shape;
}

TriangleMesh drum(double radius, int facets)
{
  TriangleMesh mesh;
  for (int f = 0; f < facets; ++f) {
    const auto at = [&](double n) {
      const double a = 2 * M_PI * (n - 0.5) / facets - M_PI / 2;
      return Vector3(radius * std::cos(a), -0.05, radius * std::sin(a));
    };
    append(mesh, rectangle(at(f), {0, 0.1, 0}, at(f + 1) - at(f), 2, 1));
  }
  return mesh;
}
} // namespace

TEST(MeshMotion, BeltDragsAStone)
{
  const double mu = 0.3, V = 0.4, dt = 2e-6;
  const ContactProperties pair = springs(k, mu, 0.2);
  Stage stage({tripod()}, pair, g);
  stage.add_mesh(rectangle({-0.5, -0.1, 0}, {1, 0, 0}, {0, 0.2, 0}, 31, 7), pair);
  stage.meshes[0].velocity = {V, 0, 0};
  stage.add(0, {0, 0.001, r - 2650 * 1.2e-5 * g / (3 * k)}, Vector3::Zero());
  const double m = stage.engine.clumps().mass[0];
  stage.forces(dt);
  const double start = stage.ledger(dt);
  stage.move(dt);
  const int slip = static_cast<int>(V / (mu * g) / dt);
  for (int n = 0; n < slip / 2; ++n) stage.step(dt);
  EXPECT_NEAR(stage.engine.clumps().velocity[0].x(), V / 2, 5e-3 * V);
  for (int n = 0; n < slip; ++n) stage.step(dt);
  stage.forces(dt);
  EXPECT_NEAR(stage.engine.clumps().velocity[0].x(), V, 1e-3 * V);
  EXPECT_NEAR(stage.meshes[0].work(), m * V * V, 5e-3 * m * V * V);
  EXPECT_NEAR(stage.engine.energy(dt).contact.friction, 0.5 * m * V * V, 0.01 * m * V * V);
  EXPECT_NEAR(stage.ledger(dt), start, 1e-4 * m * V * V);
}

TEST(MeshMotion, BeltRollsABall)
{
  const double mu = 0.3, V = 0.4, dt = 2e-6;
  const ContactProperties pair = springs(k, mu, 0.2);
  Stage stage({ball(r)}, pair, g);
  stage.add_mesh(rectangle({-0.5, -0.1, 0}, {1, 0, 0}, {0, 0.2, 0}, 31, 7), pair);
  stage.meshes[0].velocity = {V, 0, 0};
  const double m = 2650 * ball(r).volume;
  stage.add(0, {0, 0.001, r - m * g / k}, Vector3::Zero());
  stage.forces(dt);
  const double start = stage.ledger(dt);
  stage.move(dt);
  // Slip ends when mu g t + 5/2 mu g t = V.
  for (int n = 0; n * dt < 1.2 * V / (3.5 * mu * g); ++n) stage.step(dt);
  stage.forces(dt);
  EXPECT_NEAR(stage.engine.clumps().velocity[0].x(), 2. / 7 * V, 2e-3 * V);
  EXPECT_NEAR(stage.engine.clumps().spin[0].y(), -5. / 7 * V / r, 5e-3 * V / r);
  EXPECT_NEAR(stage.meshes[0].work(), 2. / 7 * m * V * V, 2e-3 * m * V * V);
  EXPECT_NEAR(stage.ledger(dt), start, 1e-4 * m * V * V);
}

TEST(MeshMotion, DrumDragsABall)
{
  // Facets are bumps: R (pi/facets)^2/2 = 0.2 um here, a fifth of the overlap under the weight.
  const double mu = 0.25, R = 0.1, spin = 8, dt = 5e-6, soft = 1e5;
  const int facets = 1600;
  const ContactProperties pair = springs(soft, mu, 0.2);
  Stage stage({ball(r)}, pair, g);
  stage.add_mesh(drum(R, facets), pair);
  stage.meshes[0].spin = {0, spin, 0};
  const double m = 2650 * ball(r).volume, inner = R * std::cos(M_PI / facets);
  stage.add(0, {0, 0, -inner + r - m * g / soft}, Vector3::Zero());
  stage.forces(dt);
  const double start = stage.ledger(dt);
  stage.move(dt);
  const double t = 0.02;
  const int steps = static_cast<int>(t / dt);
  double torque = 0; // mean
  for (int n = 0; n < steps; ++n) {
    stage.step(dt);
    torque += stage.meshes[0].torque.y() / steps;
  }
  EXPECT_NEAR(stage.engine.clumps().velocity[0].x(), -mu * g * t, 0.02 * mu * g * t);
  EXPECT_NEAR(stage.engine.clumps().spin[0].y(), 2.5 * mu * g * t / r, 0.02 * 2.5 * mu * g * t / r);
  EXPECT_NEAR(torque, -mu * m * g * R, 0.03 * mu * m * g * R); // the ball brakes the drum
  // Later it rolls without slip: its lowest point moves with the drum.
  for (int n = 0; n < 40000; ++n) stage.step(dt);
  stage.forces(dt);
  ASSERT_EQ(stage.contacts.contacts().size(), 1u);
  const Clumps& c = stage.engine.clumps();
  const Vector3 point = stage.contacts.contacts()[0].point;
  const Vector3 slip =
      c.velocity[0] + c.spin[0].cross(point - c.position[0]) - stage.meshes[0].velocity_at(point);
  EXPECT_LT(slip.norm(), 0.01 * spin * R);
  EXPECT_GT(c.spin[0].y(), 0);
  EXPECT_NEAR(stage.ledger(dt), start, 2e-3 * stage.meshes[0].work());
}

// The same world, described in a wall frame that is shifted and turned; and seen from a train.
TEST(MeshMotion, FramesDoNotShow)
{
  const double dt = 2e-6;
  const ContactProperties pair = springs(k, 0.4, 0.1);
  const auto run = [&](bool turned_frame, const Vector3& train) {
    Stage stage({ball(r)}, pair, g);
    TriangleMesh mesh = rectangle({-0.1, -0.1, 0}, {0.2, 0, 0}, {0, 0.2, 0.02}, 5, 5);
    if (turned_frame) {
      const Quaternion q(Eigen::AngleAxisd(0.8, Vector3(1, -2, 0.5).normalized()));
      const Vector3 centre(0.3, 0.1, -0.2);
      for (Vector3& v : mesh.vertices) v = q.conjugate() * (v - centre);
      stage.add_mesh(mesh, pair);
      stage.meshes[0].centre = centre;
      stage.meshes[0].orientation = q;
    } else
      stage.add_mesh(mesh, pair);
    stage.meshes[0].velocity = train;
    stage.add(0, {0, 0, 0.02}, Vector3(0.5, 0.2, -1) + train, {3, -8, 2});
    const int steps = 30000;
    for (int n = 0; n < steps; ++n) stage.step(dt);
    return Vector3(stage.engine.clumps().position[0] - steps * dt * train);
  };
  const Vector3 plain = run(false, Vector3::Zero());
  EXPECT_LT((run(true, Vector3::Zero()) - plain).norm(), 1e-11);
  EXPECT_LT((run(false, {0.7, -0.3, 0.4}) - plain).norm(), 1e-10);
}

// A ball bounces and slides: the ledger of the mesh closes to what the rectangle's reaches.
TEST(MeshMotion, LedgerOfABouncingBall)
{
  const double dt = 1e-5; // 20 steps an impact
  const ContactProperties pair = springs(2e5, 0.3, 0.05);
  const auto error = [&](int cells) {
    Stage stage({ball(r)}, pair, g);
    const Vector3 corner(-0.3, -0.3, 0), e1(0.6, 0, 0), e2(0, 0.6, 0);
    if (cells == 0)
      stage.engine.add_wall(rectangle_wall(corner, e1, e2, pair));
    else
      stage.add_mesh(rectangle(corner, e1, e2, cells, cells), pair);
    stage.add(0, {-0.2, -0.1, 0.05}, {0.4, 0.2, 0}, {5, 0, -9});
    stage.forces(dt);
    const double start = stage.ledger(dt), m = stage.engine.clumps().mass[0];
    double largest = 0;
    for (int n = 0; n < 60000; ++n) {
      stage.move(dt);
      stage.forces(dt);
      largest = std::max(largest, std::abs(stage.ledger(dt) - start));
    }
    return largest / (0.5 * m * 0.2 + m * g * 0.04);
  };
  const double plane = error(0);
  EXPECT_LT(plane, 5e-3);
  for (const int cells : {1, 30}) EXPECT_NEAR(error(cells), plane, 1e-10);
}

// Clumps in a turning drum with few facets and a beam across: corners, convex edges, contacts that
// split and merge. With soft springs and deep overlaps, to try the bookkeeping.
TEST(MeshMotion, LedgerOfATumblingDrum)
{
  const double dt = 5e-6;
  for (const int facets : {6, 20, 40}) {
    const ContactProperties pair = springs(5e4, 0.4, 0.05);
    Stage stage({tripod(), ball(r)}, pair, g);
    TriangleMesh mesh = drum(0.08, facets);
    const double reach = 0.08;
    for (const double y : {-0.05, 0.05})
      append(mesh, rectangle({-reach, y, -reach}, {2 * reach, 0, 0}, {0, 0, 2 * reach}));
    append(mesh, rectangle({-0.06, -0.05, 0.04}, {0.02, 0, 0}, {0, 0.1, 0}, 1, 3));
    stage.add_mesh(mesh, pair);
    stage.meshes[0].spin = {0, 6, 0};
    for (int n = 0; n < 4; ++n)
      stage.add(n % 2, {0.03 - 0.02 * n, 0.01 * n - 0.02, 0.03 * (n % 2) - 0.02}, {0.3, -0.2, 0},
                {10, 20, -30});
    stage.forces(dt);
    const double start = stage.ledger(dt);
    for (int n = 0; n < 120000; ++n) {
      stage.move(dt);
      stage.forces(dt);
    }
    const EngineEnergy e = stage.engine.energy(dt);
    const double turnover = e.contact.friction + e.contact.damping + stage.meshes[0].work();
    EXPECT_NEAR(stage.ledger(dt), start, 2e-3 * turnover) << facets << " facets";
  }
}

// Pressed by a tenth of its radius, a ball slides to and fro in a groove of 17 degrees. The contact
// with the other side appears when it is deep already, and goes while it is pressed: neither may
// make energy or lose any that is not booked.
TEST(MeshMotion, LedgerOfContactsThatSplitAndMerge)
{
  const double dt = 5e-6, angle = 8.5 * M_PI / 180, heavy = 1000;
  for (const double friction : {0., 0.2}) {
    const ContactProperties pair = springs(1e4, friction);
    Stage stage({ball(r)}, pair, heavy);
    TriangleMesh groove = rectangle({0, -0.1, 0}, {0, 0.2, 0},
                                    0.1 * Vector3(std::cos(angle), 0, std::sin(angle)), 7, 7);
    append(groove, rectangle({0, -0.1, 0}, {0, 0.2, 0},
                             0.1 * Vector3(-std::cos(angle), 0, std::sin(angle)), 5, 5));
    stage.add_mesh(groove, pair);
    const double depth = stage.add(0, {0, 0, 1}, Vector3::Zero()) +
                         stage.engine.clumps().mass[0] * heavy * std::cos(angle) / 1e4;
    ASSERT_GT(depth, 0.09 * r);
    stage.engine.clumps().position[0] = 0.02 * Vector3(std::cos(angle), 0, std::sin(angle)) +
                                        (r - depth) * Vector3(-std::sin(angle), 0, std::cos(angle));
    stage.forces(dt);
    const double start = stage.ledger(dt), stored = stage.stored;
    std::size_t split = 0;
    double largest = 0;
    for (int n = 0; n < 20000; ++n) {
      stage.move(dt);
      stage.forces(dt);
      for (const MeshContact& c : stage.contacts.contacts()) split += c.shared > 0.01 * r;
      largest = std::max(largest, std::abs(stage.ledger(dt) - start));
    }
    EXPECT_GT(split, 10u);
    EXPECT_LT(largest, 2e-3 * stored) << friction;
  }
}
