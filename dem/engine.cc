#include "dem/engine.h"

#include <chrono>

namespace interlock::dem
{
namespace
{
using Clock = std::chrono::steady_clock;

double seconds(Clock::duration duration)
{
  return std::chrono::duration<double>(duration).count();
}

struct Overlap {
  double depth;   // > 0 when touching [m]
  Vector3 normal; // from the second body to the first
  Vector3 point;  // mid-overlap, world [m]
};

inline Overlap sphere_overlap(const Vector3& xa, double ra, const Vector3& xb, double rb)
{
  const Vector3 d = xa - xb;
  const double distance = d.norm();
  const double depth = ra + rb - distance;
  const Vector3 normal = d / distance;
  return {depth, normal, xb + (rb - 0.5 * depth) * normal};
}

Overlap wall_overlap(const Vector3& x, double r, const Wall& wall)
{
  const Vector3 nearest = wall.nearest_point(x);
  const Vector3 d = x - nearest;
  const double distance = d.norm();
  const double depth = r - distance;
  return {depth, d / distance, nearest - 0.5 * depth * d / distance};
}

double largest_stiffness(const ContactProperties& pair)
{
  return std::max(pair.normal_stiffness, pair.tangential_stiffness);
}

// The most that a unit impulse at `arm` from the centre of mass can move the body's own material
// there, over all directions: 1/m + the largest eigenvalue of [r]x I^-1 [r]x^T; principal axes
// [1/kg].
double largest_mobility(const Vector3& arm, double mass, const Vector3& inertia)
{
  Matrix3 cross;
  cross << 0, -arm[2], arm[1], arm[2], 0, -arm[0], -arm[1], arm[0], 0;
  const Matrix3 turning = cross * inertia.cwiseInverse().asDiagonal() * cross.transpose();
  Eigen::SelfAdjointEigenSolver<Matrix3> solver;
  solver.computeDirect(turning, Eigen::EigenvaluesOnly);
  return 1 / mass + solver.eigenvalues()[2];
}
} // namespace

Engine::Engine(std::vector<ClumpShape> shapes, const ContactProperties& stone_on_stone,
               double gravity)
    : clumps_(std::move(shapes)), stone_on_stone_(stone_on_stone), gravity_(gravity),
      gravity_vector_(0, 0, gravity)
{
}

int Engine::add_clump(int shape, double density, const Vector3& position,
                      const Quaternion& orientation, const Vector3& velocity)
{
  const int i = clumps_.add(shape, density, position, orientation);
  clumps_.velocity[i] = clumps_.drift_velocity[i] = clumps_.step_velocity[i] = velocity;
  inserted_ += body_energy(i);
  lists_.invalidate();
  return i;
}

std::vector<int> Engine::remove_clumps(const std::vector<bool>& remove)
{
  for (int i = 0; i < clumps_.size(); ++i)
    if (remove[i]) inserted_ -= body_energy(i);
  for (const SphereContact& c : lists_.sphere_contacts())
    if (remove[c.i] || remove[c.j]) inserted_ -= contact_elastic_energy(c);
  for (const WallContact& c : lists_.wall_contacts())
    if (remove[c.i]) inserted_ -= contact_elastic_energy(c);
  const std::vector<int> new_index = clumps_.remove(remove);
  lists_.renumber_clumps(new_index);
  return new_index;
}

int Engine::add_wall(const Wall& wall)
{
  walls_.push_back(wall);
  lists_.invalidate();
  return static_cast<int>(walls_.size()) - 1;
}

void Engine::replace_walls(int first, const std::vector<Wall>& walls)
{
  for (const WallContact& c : lists_.wall_contacts())
    if (c.wall >= first) inserted_ -= contact_elastic_energy(c);
  lists_.forget_walls(first);
  walls_.resize(first);
  for (const Wall& wall : walls) walls_.push_back(wall);
  // What the new walls store from the start was put in by nobody's work: book it.
  for (int i = 0; i < clumps_.size(); ++i)
    for (const Wall& wall : walls) {
      const std::vector<Sphere>& spheres = clumps_.shape_of(i).spheres;
      for (std::size_t a = 0; a < spheres.size(); ++a) {
        const Vector3 x = clumps_.position[i] + clumps_.member_offset(i, a);
        const double depth = wall_overlap(x, spheres[a].radius, wall).depth;
        if (depth > 0) inserted_ += 0.5 * wall.contact.normal_stiffness * depth * depth;
      }
    }
}

void Engine::compute_forces(double dt)
{
  const Clock::time_point start = Clock::now();
  lists_.update(clumps_, walls_, dt);
  const Clock::time_point listed = Clock::now();
  profile_.lists += seconds(listed - start);
  const int n = clumps_.size();
  for (int i = 0; i < n; ++i) {
    clumps_.force[i].setZero();
    clumps_.torque[i].setZero();
  }
  for (Wall& wall : walls_) wall.force.setZero();
  contact_energy_.elastic = 0;
  n_touching_ = 0;
  largest_overlap_ = 0;

  for (SphereContact& c : lists_.sphere_contacts()) touch(c, dt);
  for (WallContact& c : lists_.wall_contacts()) touch(c, dt);
  for (const Wall& wall : walls_) wall_work_ -= dt * wall.force.dot(wall.velocity);
  profile_.contacts += seconds(Clock::now() - listed);
}

void Engine::touch(SphereContact& c, double dt)
{
  const Sphere &sa = clumps_.shape_of(c.i).spheres[c.a], &sb = clumps_.shape_of(c.j).spheres[c.b];
  const Vector3 xa = clumps_.position[c.i] + clumps_.rotation[c.i] * sa.centre;
  const Vector3 xb = clumps_.position[c.j] + clumps_.rotation[c.j] * sb.centre;
  const double reach = sa.radius + sb.radius;
  const bool was_touching = c.touching;
  c.touching = (xa - xb).squaredNorm() < reach * reach;
  if (!c.touching && !was_touching) return;

  const Overlap o = sphere_overlap(xa, sa.radius, xb, sb.radius);
  const Vector3 ri = o.point - clumps_.position[c.i], rj = o.point - clumps_.position[c.j];
  const Vector3 relative = clumps_.step_velocity[c.i] + clumps_.step_spin[c.i].cross(ri) -
                           clumps_.step_velocity[c.j] - clumps_.step_spin[c.j].cross(rj);
  if (!c.touching) {
    end_contact(stone_on_stone_, -o.depth, relative, dt, c.history, contact_energy_);
    c.force.setZero();
    return;
  }
  const double reduced_mass =
      clumps_.mass[c.i] * clumps_.mass[c.j] / (clumps_.mass[c.i] + clumps_.mass[c.j]);
  rotate_spring(c.history.spring, o.normal,
                0.5 * dt * (clumps_.step_spin[c.i] + clumps_.step_spin[c.j]).dot(o.normal));
  c.force = linear_contact_force(stone_on_stone_, reduced_mass, o.depth, o.normal, relative, dt,
                                 c.history, contact_energy_);
  c.point = o.point;
  clumps_.force[c.i] += c.force;
  clumps_.force[c.j] -= c.force;
  clumps_.torque[c.i] += ri.cross(c.force);
  clumps_.torque[c.j] -= rj.cross(c.force);
  ++n_touching_;
  largest_overlap_ = std::max(largest_overlap_, o.depth);
}

void Engine::touch(WallContact& c, double dt)
{
  Wall& wall = walls_[c.wall];
  const Sphere& sphere = clumps_.shape_of(c.i).spheres[c.a];
  const Overlap o = wall_overlap(clumps_.position[c.i] + clumps_.rotation[c.i] * sphere.centre,
                                 sphere.radius, wall);
  const bool was_touching = c.touching;
  c.touching = o.depth > 0;
  if (!c.touching && !was_touching) return;

  const Vector3 ri = o.point - clumps_.position[c.i];
  const Vector3 relative =
      clumps_.step_velocity[c.i] + clumps_.step_spin[c.i].cross(ri) - wall.velocity;
  if (!c.touching) {
    end_contact(wall.contact, -o.depth, relative, dt, c.history, contact_energy_);
    c.force.setZero();
    return;
  }
  rotate_spring(c.history.spring, o.normal, 0.5 * dt * clumps_.step_spin[c.i].dot(o.normal));
  c.force = linear_contact_force(wall.contact, clumps_.mass[c.i], o.depth, o.normal, relative, dt,
                                 c.history, contact_energy_);
  c.point = o.point;
  clumps_.force[c.i] += c.force;
  clumps_.torque[c.i] += ri.cross(c.force);
  wall.force -= c.force;
  largest_overlap_ = std::max(largest_overlap_, o.depth);
}

void Engine::kick(int i, double dt, const Vector3& other_force, const Vector3& other_torque)
{
  Vector3 force = clumps_.force[i] - clumps_.mass[i] * gravity_vector_;
  Vector3 torque = clumps_.torque[i];
  if (local_damping_ > 0 && clumps_.force[i] + other_force != Vector3::Zero()) {
    // Signs and work are those of the velocity before the kick.
    const Vector3 damping_force =
        local_damping_ *
        (force + other_force).cwiseAbs().cwiseProduct(clumps_.velocity[i].cwiseSign());
    const Vector3 damping_torque =
        local_damping_ *
        (torque + other_torque).cwiseAbs().cwiseProduct(clumps_.spin[i].cwiseSign());
    force -= damping_force;
    torque -= damping_torque;
    const Vector3 v = clumps_.velocity[i], w = clumps_.spin[i];
    clumps_.kick(i, dt, force, torque);
    local_damping_loss_ +=
        0.5 * dt *
        (damping_force.dot(v + clumps_.velocity[i]) + damping_torque.dot(w + clumps_.spin[i]));
    return;
  }
  clumps_.kick(i, dt, force, torque);
}

void Engine::move_walls(double dt)
{
  for (Wall& wall : walls_) wall.corner += dt * wall.velocity;
}

void Engine::step(double dt)
{
  compute_forces(dt);
  const Clock::time_point start = Clock::now();
  for (int i = 0; i < clumps_.size(); ++i) {
    kick(i, dt);
    clumps_.drift(i, dt);
  }
  move_walls(dt);
  profile_.integration += seconds(Clock::now() - start);
}

double Engine::body_energy(int i) const
{
  return 0.5 * clumps_.mass[i] * clumps_.velocity[i].squaredNorm() +
         0.5 * clumps_.angular_momentum[i].dot(clumps_.spin[i]) +
         clumps_.mass[i] * gravity_ * clumps_.position[i].z();
}

double Engine::contact_elastic_energy(const SphereContact& c) const
{
  const Sphere &sa = clumps_.shape_of(c.i).spheres[c.a], &sb = clumps_.shape_of(c.j).spheres[c.b];
  const double depth =
      sphere_overlap(clumps_.position[c.i] + clumps_.member_offset(c.i, c.a), sa.radius,
                     clumps_.position[c.j] + clumps_.member_offset(c.j, c.b), sb.radius)
          .depth;
  if (depth <= 0) return 0;
  return 0.5 * stone_on_stone_.normal_stiffness * depth * depth +
         0.5 * stone_on_stone_.tangential_stiffness * c.history.spring.squaredNorm();
}

double Engine::contact_elastic_energy(const WallContact& c) const
{
  const Wall& wall = walls_[c.wall];
  const double depth = wall_overlap(clumps_.position[c.i] + clumps_.member_offset(c.i, c.a),
                                    clumps_.shape_of(c.i).spheres[c.a].radius, wall)
                           .depth;
  if (depth <= 0) return 0;
  return 0.5 * wall.contact.normal_stiffness * depth * depth +
         0.5 * wall.contact.tangential_stiffness * c.history.spring.squaredNorm();
}

EngineEnergy Engine::energy(double dt) const
{
  EngineEnergy e;
  for (int i = 0; i < clumps_.size(); ++i) {
    // Velocities half a step on, so that they belong to the present positions.
    const Vector3 v =
        clumps_.velocity[i] + 0.5 * dt * (clumps_.force[i] / clumps_.mass[i] - gravity_vector_);
    const Vector3 l = clumps_.angular_momentum[i] + 0.5 * dt * clumps_.torque[i];
    e.kinetic += 0.5 * clumps_.mass[i] * v.squaredNorm() + 0.5 * l.dot(clumps_.spin_of(i, l));
    e.gravitational += clumps_.mass[i] * gravity_ * clumps_.position[i].z();
  }
  e.contact = contact_energy_;
  e.local_damping = local_damping_loss_;
  e.wall_work = wall_work_;
  e.inserted = inserted_;
  return e;
}

double Engine::kinetic_energy() const
{
  double kinetic = 0;
  for (int i = 0; i < clumps_.size(); ++i)
    kinetic += 0.5 * clumps_.mass[i] * clumps_.velocity[i].squaredNorm() +
               0.5 * clumps_.angular_momentum[i].dot(clumps_.spin[i]);
  return kinetic;
}

StableStep Engine::stable_step(const RibContacts* ribs) const
{
  std::vector<double> rate(clumps_.size(), 0.); // bound of omega^2 [1/s2]
  std::vector<int> contacts(clumps_.size(), 0);
  auto add = [&](int i, const Vector3& point, const ContactProperties& pair) {
    const Vector3 arm = clumps_.rotation[i].transpose() * (point - clumps_.position[i]);
    rate[i] += largest_stiffness(pair) * largest_mobility(arm, clumps_.mass[i], clumps_.inertia[i]);
    ++contacts[i];
  };
  for (const SphereContact& c : lists_.sphere_contacts())
    if (c.touching) {
      add(c.i, c.point, stone_on_stone_);
      add(c.j, c.point, stone_on_stone_);
    }
  for (const WallContact& c : lists_.wall_contacts())
    if (c.touching) add(c.i, c.point, walls_[c.wall].contact);
  if (ribs)
    for (const RibContact& c : ribs->contacts())
      if (c.overlap > 0) add(c.i, c.point, ribs->properties());

  StableStep limit;
  double largest = 0;
  for (int i = 0; i < clumps_.size(); ++i)
    if (rate[i] > largest) {
      largest = rate[i];
      limit = {2 / std::sqrt(2 * rate[i]), clumps_.id[i], clumps_.mass[i], contacts[i]};
    }
  return limit;
}

StableStep Engine::expected_stable_step(const std::vector<double>& densities, int n_contacts) const
{
  StableStep limit;
  double largest = 0;
  for (std::size_t s = 0; s < clumps_.shapes().size(); ++s) {
    const ClumpShape& shape = clumps_.shapes()[s];
    const double mass = densities[s] * shape.volume;
    double mobility = 0;
    for (const Sphere& sphere : shape.spheres) {
      // Where a sphere is farthest from the centre of mass, and its poles along the axes.
      const auto consider = [&](const Vector3& direction) {
        mobility = std::max(mobility, largest_mobility(sphere.centre + sphere.radius * direction,
                                                       mass, densities[s] * shape.unit_inertia));
      };
      consider(sphere.centre.stableNormalized());
      for (int k = 0; k < 3; ++k) consider(Vector3::Unit(k)), consider(-Vector3::Unit(k));
    }
    const double rate = n_contacts * largest_stiffness(stone_on_stone_) * mobility;
    if (rate > largest) {
      largest = rate;
      limit = {2 / std::sqrt(2 * rate), static_cast<std::int64_t>(s), mass, n_contacts};
    }
  }
  return limit;
}

int Engine::count_overlaps_brute_force() const
{
  int count = 0;
  for (int i = 0; i < clumps_.size(); ++i)
    for (int j = i + 1; j < clumps_.size(); ++j)
      for (std::size_t a = 0; a < clumps_.shape_of(i).spheres.size(); ++a)
        for (std::size_t b = 0; b < clumps_.shape_of(j).spheres.size(); ++b) {
          const Vector3 d = clumps_.position[i] + clumps_.member_offset(i, a) -
                            clumps_.position[j] - clumps_.member_offset(j, b);
          const double reach =
              clumps_.shape_of(i).spheres[a].radius + clumps_.shape_of(j).spheres[b].radius;
          if (d.squaredNorm() < reach * reach) ++count;
        }
  return count;
}
} // namespace interlock::dem
