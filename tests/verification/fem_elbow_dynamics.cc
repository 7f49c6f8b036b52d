// Right-angle cantilever of Simo & Vu-Quoc, CMAME 66 (1988) 125-161, by the explicit integrator.
// The paper shows curves; the extremes below are those of an independent geometrically exact code
// (Exudyn, 40 elements a leg). Fails when large rotations, gyroscopic terms, junction or load are
// wrong.
#include "fem/explicit/explicit_dynamics.h"
#include "tests/elbow_cantilever.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace interlock::fem;
using Eigen::Vector3d;

struct Extreme {
  double value = 0, time = 0;
  void look(double v, double t, double sign)
  {
    if (sign * v <= sign * value) return;
    value = v;
    time = t;
  }
};

struct History {
  Extreme tip_up, tip_down, elbow_down;
  double energy_low = 1e300, energy_high = -1e300; // after the load is gone
};

History run(int elements)
{
  const Lattice lattice = elbow_lattice(elements);
  DynamicsOptions options;
  options.rbf = false;
  options.spherical_inertia = false;
  ExplicitDynamics dynamics(lattice, options);
  dynamics.clamp({lattice.nearest_node({0, 0, 0})});
  const int elbow = lattice.nearest_node({0, 10, 0}), tip = lattice.nearest_node({10, 10, 0});

  History history;
  const double h =
      0.9 * (10. / elements) / 1e3; // of the time in which a stretch wave crosses an element
  const int steps = static_cast<int>(30 / h), record = steps / 6000;
  for (int i = 0; i < steps; ++i) {
    const double t = i * h;
    dynamics.clear_loads();
    dynamics.add_nodal_load(elbow, {0, 0, elbow_force(t)}, {0, 0, 0});
    dynamics.step(h);
    if (i % record != 0) continue;
    history.tip_up.look(dynamics.position(tip).z(), t, 1);
    history.tip_down.look(dynamics.position(tip).z(), t, -1);
    if (t > 5) history.elbow_down.look(dynamics.position(elbow).z(), t, -1);
    if (t < 2.01) continue;
    const LatticeEnergies energies = dynamics.energies();
    const double energy = energies.kinetic + energies.elastic;
    history.energy_low = std::min(history.energy_low, energy);
    history.energy_high = std::max(history.energy_high, energy);
  }
  return history;
}

TEST(ElbowDynamics, ExtremesMatchTheReference)
{
  const History history = run(40);
  EXPECT_NEAR(history.tip_up.value, 8.25, 0.01);
  EXPECT_NEAR(history.tip_up.time, 7.44, 0.02);
  EXPECT_NEAR(history.tip_down.value, -9.73, 0.01);
  EXPECT_NEAR(history.tip_down.time, 15.87, 0.02);
  EXPECT_NEAR(history.elbow_down.value, -4.06, 0.01);
  EXPECT_NEAR(history.elbow_down.time, 10.87, 0.03);
}

// Nothing acts after t = 2; the leapfrog rule has no drift, only a bounded error of order h^2.
TEST(ElbowDynamics, EnergyStaysAfterTheLoadIsGone)
{
  const History history = run(10);
  EXPECT_GT(history.energy_low, 50);
  EXPECT_LT(history.energy_high - history.energy_low, 1e-6 * history.energy_high);
}
} // namespace
