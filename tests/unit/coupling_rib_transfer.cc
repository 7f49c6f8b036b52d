// From contact wrenches to nodal loads and back. Fails when force, moment or power is lost between
// the ribs of dem and the elements of fem.
#include "coupling/loop/rib_transfer.h"

#include "dem/random_stream.h"
#include "tests/laid_geogrid.h"

#include <gtest/gtest.h>

using namespace interlock;
using dem::Vector3;

namespace
{
coupling::GeogridParameters small_geogrid()
{
  coupling::GeogridParameters p;
  p.apertures_along = p.apertures_across = 2;
  p.pitch_along = p.pitch_across = 0.065;
  p.rib_width = 5e-3;
  p.rib_thickness = 2.5e-3;
  p.edge_rounding = 5e-4;
  p.youngs_modulus = 2.4e9;
  p.poisson_ratio = 0.3;
  p.density = 910;
  p.elements_per_rib = 4;
  return p;
}
} // namespace

// The rigid geogrid held still: the reaction of its clamp is minus the sum of the wrenches' forces.
TEST(RibTransfer, ClampCarriesTheForcesOfTheStones)
{
  coupling::GeogridParameters p = small_geogrid();
  p.rigid = true;
  coupling::RibTransfer geogrid = laid_geogrid(p, Vector3::Zero(), 0);
  dem::RandomStream random(2);
  Vector3 sum = Vector3::Zero();
  std::vector<dem::RodLoads> loads;
  for (int n = 0; n < 100; ++n) {
    dem::RibWrench w;
    w.rib = random.index(geogrid.lattice().n_elements());
    w.xi = random.uniform();
    w.force = random.uniform(0, 10) * random.direction();
    w.moment = random.uniform(0, 0.1) * random.direction();
    sum += w.force;
    loads.push_back(dem::rod_loads(geogrid.ribs()[w.rib], w));
  }
  geogrid.apply(loads);
  geogrid.dynamics().step(1e-6);
  EXPECT_LT((geogrid.dynamics().clamp_reaction() + sum).norm(), 1e-12 * sum.norm());
}

// A free lattice hit by wrenches from rest: its momentum and its angular momentum about the origin
// are those of the impulses, to rounding.
TEST(RibTransfer, ForceAndMomentReachTheNodes)
{
  coupling::RibTransfer geogrid = laid_geogrid(small_geogrid(), Vector3(-0.05, 0.01, 0.02), 0);
  fem::ExplicitDynamics& d = geogrid.dynamics();
  d.clamp({});
  dem::RandomStream random(3);
  Vector3 force = Vector3::Zero(), moment = Vector3::Zero();
  std::vector<dem::RodLoads> loads;
  for (int n = 0; n < 100; ++n) {
    dem::RibWrench w;
    w.rib = random.index(geogrid.lattice().n_elements());
    w.xi = random.uniform();
    w.force = random.direction();
    w.moment = 0.01 * random.direction();
    const Vector3 place = (1 - w.xi) * d.end_position(w.rib, 0) + w.xi * d.end_position(w.rib, 1);
    force += w.force;
    moment += place.cross(w.force) + w.moment;
    loads.push_back(dem::rod_loads(geogrid.ribs()[w.rib], w));
  }
  geogrid.apply(loads);
  const double h = 1e-9; // too short for the beams to answer
  std::vector<Vector3> before;
  for (int node = 0; node < geogrid.lattice().n_nodes(); ++node) before.push_back(d.position(node));
  d.step(h);
  Vector3 momentum = Vector3::Zero(), angular = Vector3::Zero();
  for (int node = 0; node < geogrid.lattice().n_nodes(); ++node) {
    momentum += d.mass(node) * d.velocity(node);
    angular += before[node].cross(d.mass(node) * d.velocity(node)) + d.inertia(node) * d.spin(node);
  }
  // The first kick is half a step.
  EXPECT_LT((momentum - 0.5 * h * force).norm(), 1e-12 * h * force.norm());
  EXPECT_LT((angular - 0.5 * h * moment).norm(), 1e-12 * h * moment.norm());
}

// Every node is given a place, an attitude, a velocity and a spin of its own; the ribs must show
// exactly these at their ends. The width axes turn with the sections, from where they lay unloaded:
// in the plane of the geogrid, square to the rib.
TEST(RibTransfer, RibsFollowTheLattice)
{
  coupling::RibTransfer geogrid = laid_geogrid(small_geogrid(), Vector3::Zero(), 9.81);
  const fem::Lattice& lattice = geogrid.lattice();
  const std::vector<dem::Rib> unloaded = geogrid.ribs().all();
  ASSERT_EQ(static_cast<int>(unloaded.size()), lattice.n_elements());
  fem::LatticeState state = geogrid.dynamics().state();
  dem::RandomStream random(7);
  for (int node = 0; node < lattice.n_nodes(); ++node) {
    state.position[node] = lattice.reference_position(node) + 2e-3 * random.direction();
    state.orientation[node] = Eigen::AngleAxisd(random.uniform(0.05, 0.3), random.direction());
    state.velocity[node] = random.uniform(0.1, 1) * random.direction();
    state.spin[node] = random.uniform(1, 10) * random.direction();
  }
  geogrid.dynamics().set_state(state);

  const double rounding = 1e-14;
  const auto follows = [&](int r) {
    for (const int end : {0, 1}) {
      const dem::Rib rib = geogrid.ribs()[r];
      const int node = lattice.element(r).node[end];
      const Vector3 rest = unloaded[r].width_axis[end];
      const Vector3 along = lattice.reference_position(lattice.element(r).node[1]) -
                            lattice.reference_position(lattice.element(r).node[0]);
      EXPECT_NEAR(rest.norm(), 1, rounding);
      EXPECT_NEAR(rest.z(), 0, rounding);
      EXPECT_NEAR(rest.dot(along), 0, rounding);
      if ((rib.x[end] - state.position[node]).norm() > rounding ||
          (rib.v[end] - state.velocity[node]).norm() > rounding ||
          (rib.w[end] - state.spin[node]).norm() > 10 * rounding ||
          (rib.width_axis[end] - state.orientation[node] * rest).norm() > rounding)
        return false;
    }
    return true;
  };
  for (int r = 0; r < lattice.n_elements(); ++r) EXPECT_FALSE(follows(r)) << r;
  geogrid.refresh_ribs();
  for (int r = 0; r < lattice.n_elements(); ++r) EXPECT_TRUE(follows(r)) << r;
}
