// A ball falls on a floor: 0.1 s of free fall from 49.05 mm without a contact, so that it moves at g t.
#include "dem/engine/engine.h"

#include <cmath>
#include <cstdio>

using namespace interlock::dem;

int main()
{
  constexpr double radius = 0.01, gravity = 9.81, dt = 1e-5;
  ClumpShape ball;
  ball.spheres = {{Vector3::Zero(), radius}};
  ball.volume = 4 * M_PI / 3 * std::pow(radius, 3);
  ball.unit_inertia = Vector3::Constant(0.4 * ball.volume * radius * radius);
  ContactProperties contact;
  contact.normal_stiffness = contact.tangential_stiffness = 1e6;
  Engine engine({ball}, contact, gravity);
  engine.add_wall(rectangle_wall("floor", {-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, contact));
  engine.add_clump(0, 2650, {0, 0, 2 * radius + 0.04905}, Quaternion::Identity());
  for (int n = 0; n < 10000; ++n) engine.step(dt);
  const double speed = -engine.clumps().velocity[0].z();
  std::printf("%.4f m/s\n", speed);
  return std::abs(speed - gravity * 0.1) < 1e-3 ? 0 : 1;
}
