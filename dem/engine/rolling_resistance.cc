#include "dem/engine/rolling_resistance.h"

#include "dem/contacts/single_contact.h"
#include "dem/exact_sums.h"

#include <algorithm>
#include <cmath>

namespace interlock::dem
{
namespace
{
// About a point of its surface, for the scale of the dashpot; the mean moment stands for a clump's.
double inverse_rolling_inertia(const Clumps& clumps, int i, double radius)
{
  return 1 / (clumps.inertia[i].mean() + clumps.mass[i] * radius * radius);
}

Vector3 member_centre(const Clumps& clumps, int i, int a)
{
  return clumps.position[i] + clumps.member_offset(i, a);
}

double radius_of(const Clumps& clumps, int i, int a)
{
  return clumps.shape_of(i).spheres[a].radius;
}
} // namespace

double RollingResistance::evaluate(std::vector<RollingContact> contacts, Clumps& clumps,
                                   std::vector<MeshWall>& meshes, double time_step)
{
  std::sort(contacts.begin(), contacts.end(),
            [](const RollingContact& a, const RollingContact& b) { return a.key < b.key; });
  old_.swap(springs_);
  springs_.clear();
  auto old = old_.begin();
  double elastic = 0;
  // Half to each of two clumps, all to one at a wall.
  const auto book = [&clumps](const std::array<int, 5>& key, const ContactEnergy& energy) {
    const bool pair = key[0] == 0;
    for (const int i : {key[1], pair ? key[2] : -1}) {
      if (i < 0) continue;
      clumps.lost.row(Clumps::to_friction)[i] += (pair ? 0.5 : 1) * energy.friction;
      clumps.lost.row(Clumps::to_damping)[i] += (pair ? 0.5 : 1) * energy.damping;
    }
  };
  const auto lose = [&book](const RollingSpring& spring) {
    ContactEnergy energy;
    energy.friction = 0.5 * spring.stiffness * spring.angle.squaredNorm();
    book(spring.key, energy);
  };
  for (const RollingContact& c : contacts) {
    for (; old != old_.end() && old->key < c.key; ++old) lose(*old);
    RollingSpring spring;
    if (old != old_.end() && old->key == c.key) spring = *old++;
    spring.key = c.key;
    if (c.rolling.friction <= 0) {
      lose(spring);
      continue;
    }
    ContactEnergy energy;
    const Vector3 on_i = moment(c, clumps, meshes, time_step, spring, energy);
    clumps.torque[c.i] += on_i;
    if (c.j >= 0) clumps.torque[c.j] -= on_i;
    if (c.mesh >= 0)
      for (int k = 0; k < 3; ++k) meshes[c.mesh].torque[k] -= on_grid<force_grid>(on_i[k]);
    book(c.key, energy);
    elastic += energy.elastic;
    springs_.push_back(spring);
  }
  for (; old != old_.end(); ++old) lose(*old);
  return elastic;
}

Vector3 RollingResistance::moment(const RollingContact& c, const Clumps& clumps,
                                  const std::vector<MeshWall>& meshes, double time_step,
                                  RollingSpring& spring, ContactEnergy& energy)
{
  const double radius = 1 / (1 / c.radius_i + 1 / c.radius_j);
  const double arm = c.rolling.friction * radius;
  const double limit = arm * std::max(0., c.normal_force);
  const double stiffness = 2.25 * c.normal_stiffness * arm * arm;
  spring.stiffness = stiffness;

  Vector3 other_spin = Vector3::Zero();
  double inverse_inertia = inverse_rolling_inertia(clumps, c.i, c.radius_i);
  if (c.j >= 0) {
    other_spin = clumps.step_spin[c.j];
    inverse_inertia += inverse_rolling_inertia(clumps, c.j, c.radius_j);
  } else if (c.mesh >= 0)
    other_spin = meshes[c.mesh].spin;
  const Vector3& spin = clumps.step_spin[c.i];
  Vector3 rolling = spin - other_spin;
  rolling -= rolling.dot(c.normal) * c.normal; // twisting is free

  rotate_spring(spring.angle, c.normal, 0.5 * time_step * (spin + other_spin));
  const Vector3 before = spring.angle, trial = before + time_step * rolling;
  const double size = stiffness * trial.norm();
  Vector3 dashpot = Vector3::Zero();
  if (size > limit) {
    spring.angle = limit / size * trial;
    energy.friction += 0.5 * stiffness * (before + spring.angle).dot(trial - spring.angle);
  } else {
    spring.angle = trial;
    dashpot = 2 * c.rolling.damping_ratio * std::sqrt(stiffness / inverse_inertia) * rolling;
  }
  // A kick does the work of the mean of the moments at both ends of a step.
  energy.damping += 0.5 * time_step * (spring.dashpot + dashpot).dot(rolling);
  energy.elastic += 0.5 * stiffness * spring.angle.squaredNorm();
  spring.dashpot = dashpot;
  return -stiffness * spring.angle - dashpot;
}

void RollingResistance::renumber_clumps(const std::vector<int>& new_index)
{
  std::vector<RollingSpring> kept;
  for (RollingSpring spring : springs_) {
    spring.key[1] = new_index[spring.key[1]];
    if (spring.key[0] == 0) spring.key[2] = new_index[spring.key[2]];
    if (spring.key[1] >= 0 && spring.key[2] >= 0) kept.push_back(spring);
  }
  springs_.swap(kept); // still sorted: renumbering keeps the order
}

void RollingResistance::renumber_walls(int kind, const std::vector<int>& new_index)
{
  std::vector<RollingSpring> kept;
  for (RollingSpring spring : springs_) {
    if (spring.key[0] == kind) spring.key[2] = new_index[spring.key[2]];
    if (spring.key[0] != kind || spring.key[2] >= 0) kept.push_back(spring);
  }
  springs_.swap(kept);
}

void append_rolling(const std::vector<SphereContact>& contacts, const Clumps& clumps,
                    double normal_stiffness, const RollingProperties& rolling,
                    std::vector<RollingContact>& list)
{
  for (const SphereContact& c : contacts) {
    if (!c.touching) continue;
    RollingContact r;
    r.key = {0, c.i, c.j, c.a, c.b};
    r.i = c.i, r.j = c.j;
    r.normal = (member_centre(clumps, c.i, c.a) - member_centre(clumps, c.j, c.b)).normalized();
    r.normal_force = c.force.dot(r.normal);
    r.radius_i = radius_of(clumps, c.i, c.a), r.radius_j = radius_of(clumps, c.j, c.b);
    r.normal_stiffness = normal_stiffness;
    r.rolling = rolling;
    list.push_back(r);
  }
}

void append_rolling(const std::vector<WallContact>& contacts, const Clumps& clumps,
                    const std::vector<Wall>& walls, const RollingProperties& rolling,
                    std::vector<RollingContact>& list)
{
  for (const WallContact& c : contacts) {
    if (!c.touching) continue;
    const Vector3 centre = member_centre(clumps, c.i, c.a);
    RollingContact r;
    r.key = {1, c.i, c.wall, c.a, 0};
    r.i = c.i;
    r.normal = (centre - walls[c.wall].nearest_point(centre)).normalized();
    r.normal_force = c.force.dot(r.normal);
    r.radius_i = radius_of(clumps, c.i, c.a);
    r.normal_stiffness = walls[c.wall].contact.normal_stiffness;
    r.rolling = rolling;
    list.push_back(r);
  }
}

void append_rolling(const std::vector<MeshContact>& contacts, const Clumps& clumps,
                    const std::vector<MeshWall>& meshes, const RollingProperties& rolling,
                    std::vector<RollingContact>& list)
{
  for (const MeshContact& c : contacts) {
    RollingContact r;
    r.key = {2, c.i, c.wall, c.a, c.number};
    r.i = c.i, r.mesh = c.wall;
    r.normal = c.normal;
    r.normal_force = c.force.dot(c.normal);
    r.radius_i = radius_of(clumps, c.i, c.a);
    r.normal_stiffness = meshes[c.wall].contact.normal_stiffness;
    r.rolling = rolling;
    list.push_back(r);
  }
}
} // namespace interlock::dem
