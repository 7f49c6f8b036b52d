// A ball pressed on the edge of a rib that is twisted along its length. Reference: energy alone.
// What leaves the ball must reach the rib, although overlap, contact point and section change along
// the rod. Fails when contact forces are not the gradient of the energy in the contacts, or when
// the rib's loads are not dual to the motion that the contacts see.
#include "coupling/loop/staggered_step.h"

#include <gtest/gtest.h>

using namespace interlock;
using dem::Vector3;

namespace
{
constexpr double half_length = 0.0325, ball_radius = 0.012;

dem::ContactProperties contact(double stiffness, double friction, double damping_ratio)
{
  dem::ContactProperties pair;
  pair.normal_stiffness = pair.tangential_stiffness = stiffness;
  pair.friction = friction;
  pair.damping_ratio = damping_ratio;
  return pair;
}

// One rib of 8 elements, both ends clamped, twisted by `twist` an element [rad].
coupling::RibTransfer twisted_rib(double twist)
{
  const fem::RibSection section{5e-3, 2.5e-3, 2.4e9, 0.3, 910};
  std::vector<fem::RibLine> lines = {
      fem::straight_line({-half_length, 0, 0}, {half_length, 0, 0}, 8, fem::beam_section(section))};
  lines.back().shape = section;
  fem::DynamicsOptions options;
  options.mass_damping = 100;
  coupling::RibTransfer geogrid(fem::Lattice(lines), options, {0, 8}, false, 5e-4);
  fem::LatticeState state = geogrid.dynamics().state();
  for (int node = 0; node <= 8; ++node)
    state.orientation[node] = Eigen::AngleAxisd(twist * (node - 4), Vector3::UnitX());
  geogrid.dynamics().set_state(state);
  geogrid.refresh_ribs();
  return geogrid;
}

// Wall through `corner`, spanned by two directions, 0.1 m square about it.
int add_wall(dem::Engine& engine, const Vector3& middle, int normal)
{
  const Vector3 a = 0.1 * Vector3::Unit((normal + 1) % 3),
                b = 0.1 * Vector3::Unit((normal + 2) % 3);
  dem::Wall wall;
  wall.corner = middle - 0.5 * (a + b);
  wall.edge1 = a;
  wall.edge2 = b;
  wall.contact = contact(3e7, 0, 0.3);
  return engine.add_wall(wall);
}

class TwistedRib : public testing::TestWithParam<double>
{
};

TEST_P(TwistedRib, TakesTheEnergyThatTheBallGives)
{
  coupling::RibTransfer geogrid = twisted_rib(GetParam());
  dem::ClumpShape ball;
  ball.spheres = {{Vector3::Zero(), ball_radius}};
  ball.volume = 4 * M_PI / 3 * std::pow(ball_radius, 3);
  ball.unit_inertia = Vector3::Constant(0.4 * ball.volume * ball_radius * ball_radius);
  dem::Engine engine({ball}, contact(3e7, 0, 0.3), 0);
  const Vector3 centre(4e-3, 1.8e-3, 1.25e-3 + ball_radius + 8e-4);
  engine.add_clump(0, 2650, centre, dem::Quaternion::Identity());
  // A frictionless shaft, and a plate that comes down in it for a while.
  for (const int side : {-1, 1}) {
    add_wall(engine, centre + side * ball_radius * Vector3::UnitX(), 0);
    add_wall(engine, centre + side * ball_radius * Vector3::UnitY(), 1);
  }
  const int plate = add_wall(engine, centre + ball_radius * Vector3::UnitZ(), 2);
  engine.walls()[plate].velocity = {0, 0, -0.3};

  coupling::StaggeredStep loop(engine, contact(5.65e7, 0.6, 0.1));
  loop.place_geogrid(geogrid);
  const double dt = 2.3e-6;
  coupling::EnergyLedger begin, end;
  loop.advance(dt, Vector3::Zero(), &begin);
  for (int step = 0; step < 8000; ++step) {
    if (step == 4000) engine.walls()[plate].velocity.setZero();
    loop.advance(dt, Vector3::Zero());
  }
  loop.advance(dt, Vector3::Zero(), &end);
  const coupling::EnergyLedger change = coupling::difference(end, begin);
  ASSERT_GT(change.wall_work, 0.03);
  EXPECT_LT(std::abs(change.interface_residual()), 2e-4 * change.wall_work);
  EXPECT_LT(std::abs(change.residual()), 1e-3 * change.wall_work);
}

INSTANTIATE_TEST_SUITE_P(Twist, TwistedRib, testing::Values(0., 0.1, 0.3));
} // namespace
