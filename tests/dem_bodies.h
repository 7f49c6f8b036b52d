// Simple bodies, walls and impacts for the tests of contacts.
#pragma once

#include "dem/engine/engine.h"

#include <gtest/gtest.h>
#include <map>
#include <sstream>

namespace bodies
{
using namespace interlock::dem;

// A solid sphere.
inline ClumpShape ball(double radius) // [m]
{
  ClumpShape shape;
  shape.spheres = {{Vector3::Zero(), radius}};
  shape.volume = 4. / 3 * M_PI * std::pow(radius, 3);
  shape.unit_inertia = 0.4 * shape.volume * radius * radius * Vector3::Ones();
  return shape;
}

// A wide plane through the origin, turned about y by `slope` so that it falls towards +x [rad].
inline Wall plane(const ContactProperties& contact, double slope = 0, double half_width = 10)
{
  Wall wall;
  wall.name = "plane";
  wall.edge1 = 2 * half_width * Vector3(std::cos(slope), 0, -std::sin(slope));
  wall.edge2 = 2 * half_width * Vector3::UnitY();
  wall.corner = -0.5 * (wall.edge1 + wall.edge2);
  wall.contact = contact;
  return wall;
}

// Spring and dashpot without friction.
inline ContactProperties smooth_contact(double stiffness, double damping_ratio, bool tension)
{
  ContactProperties pair;
  pair.normal_stiffness = pair.tangential_stiffness = stiffness;
  pair.damping_ratio = damping_ratio;
  pair.tension = tension;
  return pair;
}

inline void set_spin(Engine& engine, int clump, const Vector3& spin) // world [rad/s]
{
  Clumps& clumps = engine.clumps();
  const Matrix3 r = clumps.orientation[clump].toRotationMatrix();
  clumps.angular_momentum[clump] = r * clumps.inertia[clump].asDiagonal() * (r.transpose() * spin);
  clumps.spin[clump] = spin;
}

// Keeps the largest of the measured values in the report of the test (--gtest_output), for
// docs/verification.md.
inline void record(const std::string& what, double value)
{
  static std::map<std::string, double> largest;
  const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
  double& kept = largest[std::string(test->name()) + what];
  if (std::abs(value) >= std::abs(kept)) kept = value;
  std::ostringstream text;
  text << kept;
  ::testing::Test::RecordProperty(what, text.str());
}

// What is seen of one impact: until nothing overlaps any more.
struct Impact {
  double peak_overlap = 0, peak_force = 0; // at whole steps [m], [N]
  double duration = 0;                     // with a force on the first clump [s]
};

inline Impact run_impact(Engine& engine, double dt, int most_steps = 1000000)
{
  Impact impact;
  bool touched = false;
  for (int n = 0; n < most_steps; ++n) {
    engine.step(dt);
    const double overlap = engine.largest_overlap(), force = engine.clumps().force[0].norm();
    if (touched && overlap <= 0) return impact;
    touched = touched || overlap > 0;
    impact.peak_overlap = std::max(impact.peak_overlap, overlap);
    impact.peak_force = std::max(impact.peak_force, force);
    if (force > 0) impact.duration += dt;
  }
  throw std::runtime_error("the bodies never parted");
}
} // namespace bodies
