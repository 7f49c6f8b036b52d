// A crowd of thrown clumps on a floor, for tests of what must not change a digit: lists, and clumps
// that never come near.
#pragma once

#include "dem/engine/engine.h"
#include "dem/random_stream.h"

#include <ostream>
#include <string>
#include <vector>

namespace crowd
{
using namespace interlock::dem;

// The laws that run in lanes, on bodies soft enough for a step of 2e-5 s.
struct Law {
  std::string name;
  ContactProperties pair;
};

inline void PrintTo(const Law& law, std::ostream* out)
{
  *out << law.name;
}

inline std::vector<Law> laws()
{
  ContactProperties linear;
  linear.normal_stiffness = linear.tangential_stiffness = 1e4; // [N/m]
  linear.friction = 0.5;
  linear.damping_ratio = 0.1;
  const ContactProperties hertz = hertz_mindlin_pair({2e6, 0.3}, {2e6, 0.3}, 0.5, 0.1);
  std::vector<Law> all = {{"Linear", linear}, {"HertzMindlin", hertz}};
  for (Law law : {all[0], all[1]}) {
    law.name += "Shared";
    law.pair.share_among_contacts = true;
    all.push_back(law);
  }
  // Spheres of a reduced radius of about 2.5 mm crush at once, and at 0.1 mm.
  linear.crushing_pressure = 3e5; // [Pa]
  all.push_back({"LinearCrushing", linear});
  all.push_back({"HertzMindlinCrushing", hertz});
  all.back().pair.crushing_pressure = 5e4;
  return all;
}

inline ClumpShape random_shape(RandomStream& random, int n_spheres)
{
  ClumpShape shape;
  for (int a = 0; a < n_spheres; ++a)
    shape.spheres.push_back({random.direction().cwiseProduct(Vector3(0.014, 0.010, 0.007)),
                             random.uniform(0.003, 0.007)});
  shape.volume = 2e-5;
  shape.unit_inertia = Vector3(1.2, 1.6, 2.1) * 1e-9;
  return shape;
}

// Clumps of a crowd by index; strangers are the others.
struct Crowd {
  Engine engine;
  std::vector<int> members;
};

constexpr int n_members = 60;
constexpr double time_step = 2e-5; // [s]

// Members at random places and attitudes, thrown at 1 m/s and 40 rad/s (rms), over a floor (wall
// 0). Before member n come n % 3 times `strangers` clumps that fly 100 m away.
inline Crowd thrown(std::uint64_t seed, const ContactProperties& pair, int strangers = 0)
{
  RandomStream random(seed);
  const ClumpShape first = random_shape(random, 25), second = random_shape(random, 40);
  Crowd crowd{Engine({first, second}, pair, 9.81), {}};
  Engine& engine = crowd.engine;
  for (int n = 0; n < n_members; ++n) {
    for (int k = 0; k < strangers * (n % 3); ++k)
      engine.add_clump(k % 2, 2650, Vector3(100 + n, 50 + k, 1), Quaternion::Identity(),
                       Vector3(0, 0, 7 + n));
    const Vector3 place(random.uniform(0, 0.15), random.uniform(0, 0.15),
                        random.uniform(0.03, 0.15));
    const Eigen::AngleAxisd turn(random.uniform(0, 3), random.direction());
    const int i = engine.add_clump(n % 2, 2650, place, Quaternion(turn), random.direction());
    Clumps& clumps = engine.clumps();
    clumps.angular_momentum[i] = 40 * clumps.inertia[i].mean() * random.direction();
    clumps.spin[i] = clumps.spin_of(i, clumps.angular_momentum[i]);
    crowd.members.push_back(i);
  }
  engine.add_wall(rectangle_wall("floor", {-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, pair));
  return crowd;
}
} // namespace crowd
