// A ball on the crossing of two clamped ribs, through the whole staggered loop. Reference: two
// clamped beams under a central load, deflection P / (2 * 192 EI / L^3), and the energy ledger.
// Fails when contact forces do not reach the beams in full, when sub-cycling makes or loses energy,
// or when ribs do not carry the ball back.
#include "coupling/loop/staggered_step.h"

#include <gtest/gtest.h>

using namespace interlock;
using dem::Vector3;

namespace
{
constexpr double half_length = 0.065, ball_radius = 0.012, gravity = 9.81;

fem::RibSection rib_section()
{
  fem::RibSection section;
  section.width = 5e-3;
  section.thickness = 2.5e-3;
  section.youngs_modulus = 2.4e9;
  section.poisson_ratio = 0.3;
  section.density = 910;
  return section;
}

coupling::RibTransfer cross(double mass_damping)
{
  std::vector<fem::RibLine> lines;
  for (const Vector3& direction : {Vector3(half_length, 0, 0), Vector3(0, half_length, 0)}) {
    lines.push_back(
        fem::straight_line(-direction, direction, 16, fem::beam_section(rib_section())));
    lines.back().shape = rib_section();
  }
  fem::Lattice lattice(lines);
  std::vector<int> ends;
  for (int node = 0; node < lattice.n_nodes(); ++node)
    if (lattice.reference_position(node).norm() > half_length - 1e-9) ends.push_back(node);
  fem::DynamicsOptions options; // weightless ribs
  options.mass_damping = mass_damping;
  return coupling::RibTransfer(std::move(lattice), options, ends, false, 5e-4);
}

dem::ContactProperties contact(double damping_ratio)
{
  dem::ContactProperties pair;
  pair.normal_stiffness = pair.tangential_stiffness = 5.65e7;
  pair.friction = 0.6;
  pair.damping_ratio = damping_ratio;
  return pair;
}

dem::ClumpShape ball()
{
  dem::ClumpShape shape;
  shape.spheres = {{Vector3::Zero(), ball_radius}};
  shape.volume = 4 * M_PI / 3 * std::pow(ball_radius, 3);
  shape.unit_inertia = Vector3::Constant(0.4 * shape.volume * ball_radius * ball_radius);
  return shape;
}

// Ball above the ribs by `gap`, over the place (x, y).
dem::Engine ball_above(double gap, double damping_ratio, double x = 0, double y = 0)
{
  dem::Engine engine({ball()}, contact(damping_ratio), gravity);
  engine.add_clump(0, 2650, {x, y, 0.5 * rib_section().thickness + ball_radius + gap},
                   dem::Quaternion::Identity());
  return engine;
}

double ball_mass()
{
  return 2650 * ball().volume;
}

// Of the crossing against a vertical force: two clamped beams, shear adds P L / (4 GA) [N/m].
double cross_stiffness()
{
  const double length = 2 * half_length;
  const double bending = 2.4e9 * fem::second_moment_2(rib_section());
  const double shear = 2.4e9 / 2.6 * fem::shear_area(rib_section());
  return 2 / (std::pow(length, 3) / (192 * bending) + length / (4 * shear));
}

double impact_energy()
{
  return ball_mass() * gravity * 0.02;
}

struct Drop {
  double lowest = 0, highest_speed = 0;                  // [m], [m/s]
  double largest_error = 0, largest_interface_error = 0; // [J]
};

// Drops the ball from 20 mm and watches 0.15 s.
Drop drop_at(double x, double y, double damping_ratio)
{
  coupling::RibTransfer geogrid = cross(0);
  dem::Engine engine = ball_above(0.02, damping_ratio, x, y);
  coupling::StaggeredStep loop(engine, contact(damping_ratio));
  loop.place_geogrid(geogrid);
  Drop result;
  for (int n = 0; n < 60000; ++n) {
    coupling::EnergyLedger ledger;
    loop.advance(2.5e-6, Vector3::Zero(), &ledger);
    result.highest_speed = std::max(result.highest_speed, engine.clumps().velocity[0].z());
    result.lowest = std::min(result.lowest, engine.clumps().position[0].z() - ball_radius);
    result.largest_error = std::max(result.largest_error, std::abs(ledger.residual()));
    result.largest_interface_error =
        std::max(result.largest_interface_error, std::abs(ledger.interface_residual()));
  }
  EXPECT_GE(loop.substeps(), 2);
  return result;
}

} // namespace

TEST(BallOnCross, StaticDeflectionIsThatOfTwoBeams)
{
  coupling::RibTransfer geogrid = cross(2000);
  dem::Engine engine = ball_above(0, 0.1);
  coupling::StaggeredStep loop(engine, contact(0.1));
  loop.place_geogrid(geogrid);
  const double dt = 2.5e-6;
  for (int n = 0; n < 100000; ++n) loop.advance(dt, Vector3::Zero());

  const int centre = geogrid.lattice().nearest_node(Vector3::Zero());
  const double exact = ball_mass() * gravity / cross_stiffness();
  EXPECT_NEAR(-geogrid.dynamics().position(centre).z(), exact, 5e-3 * exact);
  EXPECT_LT(engine.kinetic_energy(), 1e-9);
}

// On the crossing, hardly damped: the ball must come back, and the ledger must close at every
// moment.
TEST(BallOnCross, LedgerClosesOverACentralImpact)
{
  const Drop drop = drop_at(0, 0, 0.1);
  const double impact_speed = std::sqrt(2 * gravity * 0.02);
  // The ball alone on the two beams would go down by v sqrt(m/k); the ribs' mass takes a little of
  // it.
  const double deepest = impact_speed * std::sqrt(ball_mass() / cross_stiffness());
  EXPECT_NEAR(0.5 * rib_section().thickness - drop.lowest, deepest, 0.1 * deepest);
  EXPECT_GT(drop.highest_speed, 0.8 * impact_speed);
  EXPECT_LT(drop.highest_speed, impact_speed);
  EXPECT_LT(drop.largest_error, 1e-2 * impact_energy());
  EXPECT_LT(drop.largest_interface_error, 1e-2 * impact_energy());
}

// On the edge of a rib between two nodes: the rib twists under the ball and rattles against it.
TEST(BallOnCross, LedgerClosesOverAnEccentricImpact)
{
  for (const double damping_ratio : {0., 0.1, 0.3}) {
    const Drop drop = drop_at(0.0187, 2e-3, damping_ratio);
    EXPECT_LT(drop.largest_error, 1e-2 * impact_energy()) << "damping ratio " << damping_ratio;
    EXPECT_LT(drop.largest_interface_error, 1e-2 * impact_energy())
        << "damping ratio " << damping_ratio;
  }
}
