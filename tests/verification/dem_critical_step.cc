// The critical time step of leapfrog, 2/omega_max, through the engine.
//
// Undamped bodies, pressed together by outer forces so that no contact opens, get a push of a
// hundred-thousandth of the load's velocity: 1 % below the critical step the motion stays bounded
// (its energy at half steps may be 1/(1 - 0.99^2) = 50 times that of the push), 1 % above it grows
// by a factor of 1.33 a step. omega_max comes from closed forms, or from the eigenvalues of the
// stiffness matrix assembled here. The engine's own bound must lie below, and not absurdly far
// below. Fails when springs are stiffer or act longer than they say, when the tangential spring
// lags, or when the bound forgets rotation, shear or a contact.
#include "tests/dem_bodies.h"

using namespace bodies;

namespace
{
constexpr double k = 1e7, R = 0.01, density = 2600, load = 0.1; // [N/m], [m], [kg/m3], [N]
constexpr double overlap =
    load / k; // small, so that pressed spheres do not roll off each other soon

ContactProperties spring(double tangential, double friction)
{
  ContactProperties pair = smooth_contact(k, 0, false);
  pair.tangential_stiffness = tangential;
  pair.friction = friction;
  return pair;
}

// Loaded bodies in equilibrium, and the outer force on each.
struct Assembly {
  Engine engine;
  std::vector<Vector3> force;
};

// Largest kinetic energy within `steps` over that of a push of all bodies in all directions.
double growth(Assembly assembly, double dt, int steps)
{
  Engine& engine = assembly.engine;
  const double speed = 1e-5 * load * dt / engine.clumps().mass[0];
  for (int i = 0; i < engine.clumps().size(); ++i) {
    engine.clumps().velocity[i] = (i == 0 ? speed : -speed) * Vector3(1, 0.7, 0.8);
    set_spin(engine, i, (i == 0 ? 1. : 0.6) * speed / R * Vector3(0.9, -0.7, 0.8));
  }
  const double start = engine.kinetic_energy();
  double largest = 0;
  for (int n = 0; n < steps; ++n) {
    for (int i = 0; i < engine.clumps().size(); ++i)
      engine.clumps().velocity[i] += dt / engine.clumps().mass[i] * assembly.force[i];
    engine.step(dt);
    largest = std::max(largest, engine.kinetic_energy());
  }
  return largest / start;
}

void check(const std::string& name, const Assembly& assembly, double critical)
{
  EXPECT_LT(growth(assembly, 0.99 * critical, 400), 100) << name;
  EXPECT_GT(growth(assembly, 1.01 * critical, 25), 1e4) << name;
  Engine engine = assembly.engine;
  engine.compute_forces(0);
  const double bound = engine.stable_step().step;
  EXPECT_LT(bound, critical * (1 + 1e-6)) << name; // may be equal, but for overlap in the arms
  EXPECT_GT(bound, 0.35 * critical) << name;
  record(name + "_bound_over_exact", bound / critical);
}

Assembly sphere_on_wall(double tangential, double friction)
{
  Assembly a{Engine({ball(R)}, {}, 0), {{0, 0, -load}}};
  a.engine.add_wall(plane(spring(tangential, friction)));
  a.engine.add_clump(0, density, {0, 0, R - overlap}, Quaternion::Identity());
  return a;
}

Assembly two_spheres(double tangential, double friction)
{
  const Vector3 line = Vector3(1, 2, 2) / 3;
  Assembly a{Engine({ball(R)}, spring(tangential, friction), 0), {load * line, -load * line}};
  a.engine.add_clump(0, density, Vector3::Zero(), Quaternion::Identity());
  a.engine.add_clump(0, density, (2 * R - overlap) * line, Quaternion::Identity());
  return a;
}
const double unit = std::sqrt(density * ball(R).volume / k); // sqrt(m/k) [s]
} // namespace

TEST(CriticalStep, SphereOnAWall)
{
  check("smooth", sphere_on_wall(k, 0), 2 * unit);
  // Along the wall the surface of a solid sphere is 7/2 times as mobile.
  check("rough", sphere_on_wall(k, 1), 2 * unit / std::sqrt(3.5));
}

TEST(CriticalStep, TwoSpheres)
{
  check("smooth", two_spheres(k, 0), std::sqrt(2) * unit);
  check("rough", two_spheres(k, 1), 2 * unit / std::sqrt(7));
  check("soft_along", two_spheres(0.2 * k, 1), std::sqrt(2) * unit);
}

// Between six walls: a translation is held by 2 k_n + 4 k_t = 6 k, a rotation by 4 k_t R^2 = 10 k
// I/m. The bound is that of one contact as an element with its share of mass and inertia, 2/sqrt(7
// N).
TEST(CriticalStep, SphereWithSixContacts)
{
  Assembly a{Engine({ball(R)}, {}, 0), {Vector3::Zero()}};
  for (int axis = 0; axis < 3; ++axis)
    for (const int side : {-1, 1}) {
      Wall wall = plane(spring(k, 1));
      wall.edge1 = 0.1 * Vector3::Unit((axis + 1) % 3);
      wall.edge2 = 0.1 * Vector3::Unit((axis + 2) % 3);
      wall.corner = side * (R - overlap) * Vector3::Unit(axis) - 0.5 * (wall.edge1 + wall.edge2);
      a.engine.add_wall(wall);
    }
  a.engine.add_clump(0, density, Vector3::Zero(), Quaternion::Identity());
  check("six_walls", a, 2 * unit / std::sqrt(10));
  a.engine.compute_forces(0);
  EXPECT_NEAR(a.engine.stable_step().step, 0.309 * unit, 5e-4 * unit);
  EXPECT_NEAR(a.engine.stable_step().step, 2 / std::sqrt(7 * 6) * unit, 1e-4 * unit);
}

namespace
{
// A clump of five spheres in a square with one in the middle pressed flat onto the wall. Mass and
// moments as of a plate of some thickness.
ClumpShape tile(double spacing)
{
  ClumpShape shape;
  shape.spheres = {{Vector3::Zero(), R}};
  for (const int i : {-1, 1})
    for (const int j : {-1, 1}) shape.spheres.push_back({{i * spacing, j * spacing, 0}, R});
  shape.volume = 5 * ball(R).volume;
  const double square = 4 * spacing * spacing / 12;
  shape.unit_inertia =
      shape.volume * (Vector3(square, square, 2 * square) + R * R / 3 * Vector3(1, 1, 0));
  return shape;
}

// Largest frequency of the clump against the wall, arms and springs of all its spheres.
double largest_frequency(const ClumpShape& shape, double k_n, double k_t)
{
  using Matrix6 = Eigen::Matrix<double, 6, 6>;
  Matrix6 stiffness = Matrix6::Zero(), mass = Matrix6::Zero();
  mass.diagonal() << density * shape.volume * Vector3::Ones(), density * shape.unit_inertia;
  for (const Sphere& sphere : shape.spheres) {
    const Vector3 arm = sphere.centre - sphere.radius * Vector3::UnitZ();
    Eigen::Matrix<double, 3, 6> motion; // of the contact, per translation and rotation
    motion.leftCols<3>().setIdentity();
    for (int axis = 0; axis < 3; ++axis) motion.col(3 + axis) = Vector3::Unit(axis).cross(arm);
    stiffness += motion.transpose() * Vector3(k_t, k_t, k_n).asDiagonal() * motion;
  }
  return std::sqrt(
      Eigen::GeneralizedSelfAdjointEigenSolver<Matrix6>(stiffness, mass).eigenvalues()[5]);
}
} // namespace

TEST(CriticalStep, ClumpWithFiveContacts)
{
  for (const double spacing : {0.008, 0.02})
    for (const double ratio : {0.3, 1.}) {
      const ClumpShape shape = tile(spacing);
      Assembly a{Engine({shape}, {}, 0), {{0, 0, -5 * load}}};
      a.engine.add_wall(plane(spring(ratio * k, 1)));
      a.engine.add_clump(0, density, {0, 0, R - overlap}, Quaternion::Identity());
      check("tile_" + std::to_string(spacing) + "_" + std::to_string(ratio), a,
            2 / largest_frequency(shape, k, ratio * k));
    }
}
