// The rotational spring of junctions against its definition. Fails when its moment is not k theta,
// when moments do not follow from the energy, when the tangent is not their derivative, or when
// rigid rotation matters.
#include "fem/beam/rotational_spring.h"
#include "fem/explicit/explicit_dynamics.h"
#include "fem/lattice/lattice.h"
#include "fem/lattice/lattice_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace
{
using namespace interlock::fem;
using Eigen::Quaterniond;
using Eigen::Vector3d;

std::mt19937 generator(5);

Vector3d random_vector(double size)
{
  std::uniform_real_distribution<double> uniform(-size, size);
  return {uniform(generator), uniform(generator), uniform(generator)};
}

RotationalSpring random_spring()
{
  return {{0, 1}, random_vector(1).normalized(), 3, 7};
}

// Relative rotation theta on top of any rotation of the first node.
std::array<Quaterniond, 2> turned_by(const Vector3d& theta)
{
  const Quaterniond first = rotation_exponential(random_vector(1.5));
  return {first, first * rotation_exponential(theta)};
}

TEST(RotationalSpring, MomentAndEnergyAboutItsAxes)
{
  for (const double angle : {0., 1e-6, 0.1, 1.2, 2.}) {
    const RotationalSpring spring = random_spring();
    const Vector3d in_plane = spring.normal.unitOrthogonal();
    for (const auto& [axis, stiffness] : {std::pair{spring.normal, 3.}, {in_plane, 7.}}) {
      const auto q = turned_by(angle * axis);
      const Vector3d moment = q[0] * (stiffness * angle * axis);
      EXPECT_LT((spring_moment(spring, q) - moment).norm(), 1e-12);
      EXPECT_NEAR(spring_energy(spring, q), 0.5 * stiffness * angle * angle, 1e-12);
    }
  }
}

TEST(RotationalSpring, RigidRotationChangesNothing)
{
  const RotationalSpring spring = random_spring();
  auto q = turned_by({0.3, -0.5, 0.7});
  const double before = spring_energy(spring, q);
  const Quaterniond turn = rotation_exponential({2, 1, -3});
  for (Quaterniond& one : q) one = turn * one;
  EXPECT_NEAR(spring_energy(spring, q), before, 1e-14);
}

TEST(RotationalSpring, MomentIsTheGradientAndTangentItsDerivative)
{
  for (int trial = 0; trial < 10; ++trial) {
    const RotationalSpring spring = random_spring();
    const auto start = turned_by(random_vector(0.8));
    const std::array<Vector3d, 2> turn{random_vector(0.02), random_vector(0.4)};
    const auto at = [&](const std::array<Vector3d, 2>& t) {
      return std::array<Quaterniond, 2>{rotation_exponential(t[0]) * start[0],
                                        rotation_exponential(t[1]) * start[1]};
    };
    const SpringTangent tangent = spring_tangent(spring, start, turn);
    const Vector3d on_first = tangent.moment.head<3>(), on_second = tangent.moment.tail<3>();
    EXPECT_LT((on_first + spring_moment(spring, at(turn))).norm(), 1e-13);
    EXPECT_LT((on_first + on_second).norm(), 1e-13);
    const double step = 1e-5;
    for (int freedom = 0; freedom < 6; ++freedom) {
      const int node = freedom / 3, c = freedom % 3;
      std::array<Vector3d, 2> up = turn, down = turn;
      up[node][c] += step;
      down[node][c] -= step;
      const Vector3d slope =
          (spring_moment(spring, at(up)) - spring_moment(spring, at(down))) / (2 * step);
      EXPECT_LT((tangent.stiffness.col(freedom).head<3>() + slope).norm(), 1e-8);
      EXPECT_LT((tangent.stiffness.col(freedom).tail<3>() - slope).norm(), 1e-8);

      auto forward = at(turn), back = at(turn); // spin on top of the orientation
      forward[node] = rotation_exponential(step * Vector3d::Unit(c)) * forward[node];
      back[node] = rotation_exponential(-step * Vector3d::Unit(c)) * back[node];
      const double power =
          (spring_energy(spring, forward) - spring_energy(spring, back)) / (2 * step);
      EXPECT_NEAR(tangent.moment[freedom], power, 1e-8);
    }
  }
}

std::vector<RibLine> star(int lines)
{
  const BeamSection section = beam_section({5e-3, 2.5e-3, 2.4e9, 0.4, 910});
  std::vector<RibLine> star;
  for (int i = 0; i < lines; ++i) {
    const Vector3d arm(std::cos(i * M_PI / lines), std::sin(i * M_PI / lines), 0);
    star.push_back(straight_line(-arm, arm, 4, section));
  }
  return star;
}

// Three lines through one point: three nodes there, three springs, displacements shared and
// rotations not.
TEST(RotationalSpring, LatticeHasOneForEachTwoLinesOfAJunction)
{
  const Lattice lattice(star(3), {2, 5});
  EXPECT_EQ(lattice.n_nodes(), 15);
  const std::vector<int> centre = lattice.joined_nodes(lattice.nearest_node({0, 0, 0}));
  ASSERT_EQ(centre.size(), 3u);
  ASSERT_EQ(lattice.n_springs(), 3);
  for (int s = 0; s < 3; ++s) {
    const RotationalSpring& spring = lattice.spring(s);
    EXPECT_EQ(spring.in_plane, 2);
    EXPECT_EQ(spring.out_of_plane, 5);
    EXPECT_LT((spring.normal - Vector3d(0, 0, 1)).norm(), 1e-14);
    for (int c = 0; c < 6; ++c)
      EXPECT_EQ(lattice.dof(spring.node[0], c) == lattice.dof(spring.node[1], c), c < 3);
  }
  const auto& mesh = lattice.mesh();
  EXPECT_EQ(mesh.dof_handler().n_dofs() - mesh.junction_ties().n_constraints(), 6u * 15 - 3 * 2);

  const Lattice rigid(star(3), {});
  EXPECT_EQ(rigid.n_springs(), 0);
  EXPECT_EQ(rigid.n_nodes(), 13);
}

TEST(RotationalSpring, ExplicitIntegratorRefusesThem)
{
  EXPECT_THROW(ExplicitDynamics(Lattice(star(2), {1, 1}), {}), std::invalid_argument);
  EXPECT_NO_THROW(ExplicitDynamics(Lattice(star(2)), {}));
}
} // namespace
