// The free asymmetric body (Euler top). Reference: order-8 integration of Euler's equations for
// principal moments (1, 2, 3), body-frame spin at t = 10, 50, 100. Expected order of the attitude
// step: 2; the spatial angular momentum is exact. Fails when the gyroscopic term is missing or the
// step is of first order.
#include "dem/bodies/clumps.h"

#include <gtest/gtest.h>

using namespace interlock::dem;

namespace
{
void drift(Clumps& clumps, double dt)
{
  ScalarField held;
  held.resize(clumps.size());
  clumps.drift_all(dt, held);
}

Clumps top(const Vector3& spin)
{
  ClumpShape shape;
  shape.spheres = {{Vector3::Zero(), 1}};
  shape.volume = 1;
  shape.unit_inertia = {1, 2, 3};
  Clumps clumps({shape});
  clumps.add(0, 1, Vector3::Zero(), Quaternion::Identity());
  clumps.angular_momentum[0] = spin.cwiseProduct(Vector3(1, 2, 3));
  clumps.spin[0] = spin;
  return clumps;
}

Vector3 body_spin(const Clumps& clumps)
{
  return clumps.orientation[0].conjugate() * clumps.spin_of(0, clumps.angular_momentum[0]);
}

// Body-frame spin after `time`.
Vector3 spin_after(const Vector3& spin, double time, int steps)
{
  Clumps clumps = top(spin);
  for (int n = 0; n < steps; ++n) {
    drift(clumps, time / steps);
  }
  return body_spin(clumps);
}
} // namespace

// Spin about near the middle axis (at first next to the unstable state, where errors in phase grow
// the most), anything, and near the axis of least inertia; at t = 10, 50, 100.
TEST(FreeTop, SpinFollowsTheReference)
{
  const Vector3 rows[][4] = {
      {{0.01, 1, 0.01},
       {-0.8745734379, 0.4849961873, 0.5050012205},
       {-0.9999644886, 0.0130775204, 0.5773875009},
       {0.0095504132, -1.0000043948, 0.0098524175}},
      {{0.2, 1, 0.3},
       {0.7248492566, -0.7173517653, 0.5017989122},
       {-0.0667517872, -1.0176169215, 0.2795566735},
       {-0.0628242572, 1.0178669425, 0.2792531034}},
      {{1, 0.01, 0.01},
       {1.0000499618, 0.0002717014, 0.0115459398},
       {0.9998886927, -0.0179611281, -0.0050793004},
       {0.9998536774, 0.0198147344, -0.0015680454}},
  };
  for (const auto& row : rows)
    for (const int column : {1, 2, 3}) {
      const int time = column == 1 ? 10 : column == 2 ? 50 : 100;
      const double error = (spin_after(row[0], time, 4000 * time) - row[column]).norm();
      EXPECT_LT(error, 1e-6) << "from " << row[0].transpose() << ", t = " << time;
    }
}

TEST(FreeTop, OrderTwo)
{
  const Vector3 start(0.2, 1, 0.3), exact(0.7248492566, -0.7173517653, 0.5017989122);
  const double coarse = (spin_after(start, 10, 1000) - exact).norm();
  const double fine = (spin_after(start, 10, 2000) - exact).norm();
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.1);
}

// Spin about the middle axis turns over again and again: two flips in each period of 39.10573420 s
// of the spin.
TEST(FreeTop, MiddleAxisFlips)
{
  Clumps clumps = top({0.01, 1, 0.01});
  const double period = 39.1057342, dt = 1e-3;
  int flips = 0;
  double old = 1;
  for (int n = 0; n * dt < 3 * period; ++n) {
    drift(clumps, dt);
    const double middle = body_spin(clumps).y();
    if (middle * old < 0) ++flips;
    old = middle;
  }
  EXPECT_EQ(flips, 6);
}

TEST(FreeTop, EnergyIsBoundedAndMomentumExact)
{
  const Vector3 start(0.2, 1, 0.3);
  Clumps clumps = top(start);
  const Vector3 momentum = clumps.angular_momentum[0];
  double largest = 0;
  for (int n = 0; n < 100000; ++n) {
    drift(clumps, 5e-3);
    const double energy = 0.5 * momentum.dot(clumps.spin_of(0, momentum));
    largest = std::max(largest, std::abs(energy / 1.155 - 1));
  }
  EXPECT_LT(largest, 1e-4); // 500 time units, no drift
  EXPECT_EQ(clumps.angular_momentum[0], momentum);
  EXPECT_NEAR(clumps.orientation[0].norm(), 1, 1e-14);
}
