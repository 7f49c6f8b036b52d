#include "dem/engine/engine.h"

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <string>

namespace interlock::dem
{
namespace
{
using Clock = std::chrono::steady_clock;

double seconds(Clock::time_point from, Clock::time_point to)
{
  return std::chrono::duration<double>(to - from).count();
}

// Of one clump, with the half-step velocities [J]. A function of its own even in the machine code:
// in a loop that the compiler runs in vectors, the clumps of the rest behind them might be rounded
// in another way.
[[gnu::noinline]] double kinetic_energy_of(const Clumps& clumps, int i)
{
  return 0.5 * clumps.mass[i] * clumps.velocity[i].squaredNorm() +
         0.5 * clumps.angular_momentum[i].dot(clumps.spin[i]);
}

// What new lanes remember that is always the same: written here once, since writing it at every
// evaluation costs 3 % of a step. A contact that goes on under another law needs it.
void set_constants(const ContactProperties& pair, WallSegment range, ContactLanes& lanes)
{
  if (pair.crushing_pressure == 0)
    for (int k = range.begin; k < range.end; ++k) lanes.block(k).crushed[k % lane_width] = 0;
  if (pair.model != ContactModel::linear || pair.share_among_contacts) return;
  for (int k = range.begin; k < range.end; ++k)
    lanes.block(k).tangential_stiffness[k % lane_width] = pair.tangential_stiffness;
}

double energy_of(const RollingSpring& spring) // [J]
{
  return 0.5 * spring.stiffness * spring.angle.squaredNorm();
}
} // namespace

Engine::Engine(std::vector<ClumpShape> shapes, const ContactProperties& stone_on_stone,
               double gravity)
    : clumps_(std::move(shapes)), stone_on_stone_(stone_on_stone), gravity_(gravity)
{
}

void Engine::set_gravity(double gravity)
{
  for (int i = 0; i < clumps_.size(); ++i)
    inserted_ += clumps_.mass[i] * (gravity - gravity_) * clumps_.position[i].z();
  gravity_ = gravity;
  lists_.invalidate();
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
  for (const SphereContact& c : sphere_contacts())
    if (remove[c.i] || remove[c.j]) inserted_ -= elastic_energy(c);
  for (const WallContact& c : wall_contacts())
    if (remove[c.i]) inserted_ -= elastic_energy(c);
  for (const MeshContact& c : mesh_contacts_.contacts())
    if (remove[c.i]) inserted_ -= MeshContacts::elastic_energy(c, mesh_walls_[c.wall].contact);
  for (const RollingSpring& s : rolling_.springs())
    if (remove[s.key[1]] || (s.key[0] == 0 && remove[s.key[2]])) inserted_ -= energy_of(s);
  for (int i = 0; i < clumps_.size(); ++i)
    if (remove[i]) {
      lost_before_ += clumps_.lost[i];
      crushed_before_ += clumps_.lost_to_crushing[i];
    }
  const std::vector<int> new_index = clumps_.remove(remove);
  lists_.renumber_clumps(clumps_, new_index);
  mesh_contacts_.renumber_clumps(new_index);
  rolling_.renumber_clumps(new_index);
  return new_index;
}

WallId Engine::add_wall(const Wall& wall)
{
  walls_.push_back(wall);
  walls_.back().id = next_wall_id_++;
  lists_.invalidate();
  for (int i = 0; i < clumps_.size(); ++i) {
    const std::vector<Sphere>& spheres = clumps_.shape_of(i).spheres;
    for (std::size_t a = 0; a < spheres.size(); ++a) {
      const Vector3 x = clumps_.position[i] + clumps_.member_offset(i, a);
      const double depth = spheres[a].radius - (x - wall.nearest_point(x)).norm();
      if (depth > 0) inserted_ += stored_energy(wall.contact, depth, spheres[a].radius, 0, {});
    }
  }
  return walls_.back().id;
}

std::size_t Engine::wall_index(WallId id) const
{
  const auto found =
      std::lower_bound(walls_.begin(), walls_.end(), id,
                       [](const Wall& wall, WallId value) { return wall.id < value; });
  if (found == walls_.end() || found->id != id)
    throw std::invalid_argument("There is no wall with the id " + std::to_string(id) + ".");
  return static_cast<std::size_t>(found - walls_.begin());
}

void Engine::remove_walls(const std::vector<WallId>& ids)
{
  std::vector<bool> gone(walls_.size(), false);
  for (const WallId id : ids) gone[wall_index(id)] = true;
  for (const WallContact& c : wall_contacts())
    if (gone[c.wall]) inserted_ -= elastic_energy(c);
  for (const RollingSpring& s : rolling_.springs())
    if (s.key[0] == 1 && gone[s.key[2]]) inserted_ -= energy_of(s);
  std::vector<int> new_index(walls_.size(), -1);
  std::vector<Wall> kept;
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    if (gone[w]) continue;
    new_index[w] = static_cast<int>(kept.size());
    kept.push_back(walls_[w]);
  }
  walls_ = std::move(kept);
  lists_.renumber_walls(clumps_, new_index);
  rolling_.renumber_walls(1, new_index);
  const auto is_gone = [&](const ControlledWall& c) {
    return std::find(ids.begin(), ids.end(), c.wall) != ids.end();
  };
  controls_.erase(std::remove_if(controls_.begin(), controls_.end(), is_gone), controls_.end());
}

void Engine::compute_forces(double dt)
{
  const auto start = Clock::now();
  if (lists_.update(clumps_, walls_, dt, gravity_)) {
    sums_.clear(clumps_.size());
    set_constants(stone_on_stone_, {0, lists_.pair_lanes().size()}, lists_.pair_lanes());
    for (std::size_t w = 0; w < walls_.size(); ++w)
      set_constants(walls_[w].contact, lists_.wall_segments()[w], lists_.wall_lanes());
  }
  const auto listed = Clock::now();
  records_.take(clumps_);
  evaluate_pairs(records_, stone_on_stone_, dt, lists_.pair_lanes(), sums_);
  std::vector<Vector3> before;
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    before.push_back(walls_[w].force);
    evaluate_wall(records_, dt, lists_.wall_segments()[w], lists_.wall_lanes(), sums_, walls_[w]);
  }
  sums_.write(clumps_);
  if (!mesh_walls_.empty()) {
    mesh_contacts_.update_list(clumps_, mesh_walls_);
    mesh_contacts_.evaluate(clumps_, mesh_walls_, dt);
  }
  if (rolling_properties_.friction > 0) resist_rolling(dt);
  wall_forces_are_whole_ = !ranks_.sum;
  if (a_wall_moves()) complete_wall_forces();
  // A leapfrog kick does the work of the mean of the forces at both ends of a step.
  for (std::size_t w = 0; w < walls_.size(); ++w)
    wall_work_ -= 0.5 * dt * (before[w] + walls_[w].force).dot(walls_[w].velocity);
  profile_.lists += seconds(start, listed);
  profile_.contacts += seconds(listed, Clock::now());
}

void Engine::resist_rolling(double dt)
{
  std::vector<RollingContact> contacts;
  append_rolling(sphere_contacts(), clumps_, stone_on_stone_.normal_stiffness, rolling_properties_,
                 contacts);
  append_rolling(wall_contacts(), clumps_, walls_, rolling_properties_, contacts);
  append_rolling(mesh_contacts_.contacts(), clumps_, mesh_walls_, rolling_properties_, contacts);
  rolling_.evaluate(std::move(contacts), clumps_, mesh_walls_, dt);
}

bool Engine::a_wall_moves() const
{
  const auto moves = [](const Wall& wall) { return wall.velocity != Vector3::Zero(); };
  const auto turns = [](const MeshWall& wall) {
    return wall.velocity != Vector3::Zero() || wall.spin != Vector3::Zero();
  };
  return !controls_.empty() || std::any_of(walls_.begin(), walls_.end(), moves) ||
         std::any_of(mesh_walls_.begin(), mesh_walls_.end(), turns);
}

void Engine::complete_wall_forces()
{
  if (wall_forces_are_whole_) return;
  std::vector<Vector3*> sums;
  for (Wall& wall : walls_) sums.push_back(&wall.force);
  for (MeshWall& wall : mesh_walls_) sums.insert(sums.end(), {&wall.force, &wall.torque});
  std::vector<double> numbers;
  for (const Vector3* sum : sums) numbers.insert(numbers.end(), sum->data(), sum->data() + 3);
  ranks_.sum(numbers);
  const double* number = numbers.data();
  for (Vector3* sum : sums) *sum = Eigen::Map<const Vector3>(number), number += 3;
  wall_forces_are_whole_ = true;
}

int Engine::add_mesh_wall(const MeshWall& wall)
{
  mesh_walls_.push_back(wall);
  // A look at the new wall alone, for what it stores at once.
  MeshContacts look;
  std::vector<MeshWall> alone = {wall};
  Clumps clumps = clumps_;
  look.update_list(clumps, alone);
  inserted_ += look.evaluate(clumps, alone, 0);
  mesh_contacts_.invalidate();
  return static_cast<int>(mesh_walls_.size()) - 1;
}

void Engine::kick_all(double dt, const VectorField* other_force, const VectorField* other_torque)
{
  const auto start = Clock::now();
  if (local_damping_.share > 0)
    local_damping_.damp(clumps_, gravity_, dt, other_force, other_torque);
  const int n = clumps_.position.padded_size();
  const double* __restrict inverse_mass = clumps_.inverse_mass.row(0);
  for (int c = 0; c < 3; ++c) {
    double* __restrict v = clumps_.velocity.row(c), * __restrict l =
                                                        clumps_.angular_momentum.row(c);
    const double* __restrict f = clumps_.force.row(c), * __restrict t = clumps_.torque.row(c);
    const double fall = c == 2 ? dt * gravity_ : 0;
#pragma omp simd
    for (int i = 0; i < n; ++i) {
      v[i] += dt * inverse_mass[i] * f[i] - fall;
      l[i] += dt * t[i];
    }
  }
  profile_.integration += seconds(start, Clock::now());
}

void Engine::drift_all(double dt, const ScalarField* held)
{
  const auto start = Clock::now();
  nothing_held_.resize(clumps_.size());
  clumps_.drift_all(dt, held ? *held : nothing_held_);
  profile_.integration += seconds(start, Clock::now());
}

void Engine::move_walls(double dt)
{
  for (auto& [id, control] : controls_) {
    const std::size_t w = wall_index(id);
    Wall& wall = walls_[w];
    std::vector<double> response = {
        contact_response(wall_contacts(), static_cast<int>(w), wall.contact, clumps_, dt)};
    if (ranks_.sum) ranks_.sum(response);
    control_force(control, response[0], wall);
  }
  for (Wall& wall : walls_) wall.corner += dt * wall.velocity;
  for (MeshWall& wall : mesh_walls_) wall.move(dt);
}

void Engine::step(double dt)
{
  compute_forces(dt);
  kick_all(dt);
  drift_all(dt);
  move_walls(dt);
}

StepProfile Engine::profile() const
{
  StepProfile profile = profile_;
  profile.counts = lists_.counts();
  profile.broad_phase = lists_.broad_phase_time() - broad_phase_before_;
  profile.lists -= profile.broad_phase;
  return profile;
}

void Engine::reset_profile()
{
  profile_ = StepProfile();
  broad_phase_before_ = lists_.broad_phase_time();
}

double Engine::largest_overlap() const
{
  double largest = std::max(dem::largest_overlap(lists_.pair_lanes()),
                            dem::largest_overlap(lists_.wall_lanes()));
  for (const MeshContact& c : mesh_contacts_.contacts()) largest = std::max(largest, c.depth);
  return largest;
}

double Engine::body_energy(int i) const
{
  const Vector3 l = clumps_.angular_momentum[i];
  return 0.5 * clumps_.mass[i] * clumps_.velocity[i].squaredNorm() +
         0.5 * l.dot(clumps_.spin_of(i, l)) + clumps_.mass[i] * gravity_ * clumps_.position[i].z();
}

EngineEnergy Engine::energy(double dt) const
{
  std::vector<double> kinetic, gravitational, friction, damping, local_damping, crushing;
  for (int i = 0; i < clumps_.size(); ++i) {
    if (clumps_.ghost[i] == 1) continue;
    // Velocities half a step on, so that they belong to the present positions.
    const Vector3 v = clumps_.velocity[i] +
                      0.5 * dt * (clumps_.force[i] / clumps_.mass[i] - gravity_ * Vector3::UnitZ());
    const Vector3 l = clumps_.angular_momentum[i] + 0.5 * dt * clumps_.torque[i];
    kinetic.push_back(0.5 * clumps_.mass[i] * v.squaredNorm() + 0.5 * l.dot(clumps_.spin_of(i, l)));
    gravitational.push_back(clumps_.mass[i] * gravity_ * clumps_.position[i].z());
    friction.push_back(clumps_.lost.row(Clumps::to_friction)[i]);
    damping.push_back(clumps_.lost.row(Clumps::to_damping)[i]);
    local_damping.push_back(clumps_.lost.row(Clumps::to_local_damping)[i]);
    crushing.push_back(clumps_.lost_to_crushing[i]);
  }
  EngineEnergy e;
  e.kinetic = order_free_sum(kinetic, ranks_);
  e.gravitational = order_free_sum(gravitational, ranks_);
  e.contact.elastic = order_free_sum(stored_energies(), ranks_);
  e.contact.friction = lost_before_[Clumps::to_friction] + order_free_sum(friction, ranks_);
  e.contact.damping = lost_before_[Clumps::to_damping] + order_free_sum(damping, ranks_);
  e.contact.crushing = crushed_before_ + order_free_sum(crushing, ranks_);
  e.local_damping = lost_before_[Clumps::to_local_damping] + order_free_sum(local_damping, ranks_);
  e.wall_work = wall_work_;
  for (const MeshWall& wall : mesh_walls_) e.wall_work += wall.work();
  e.inserted = inserted_;
  return e;
}

// Of contacts, as the last compute_forces left them [J]; one that two ranks evaluate is that of the
// first clump's.
std::vector<double> Engine::stored_energies() const
{
  std::vector<double> energies;
  const ContactLanes &pairs = lists_.pair_lanes(), &at_walls = lists_.wall_lanes();
  for (int k = 0; k < pairs.size(); ++k)
    if (clumps_.ghost[pairs.key(k).i] == 0)
      energies.push_back(pairs.stored_energy(k, stone_on_stone_));
  for (std::size_t w = 0; w < lists_.wall_segments().size() && w < walls_.size(); ++w) {
    const WallSegment segment = lists_.wall_segments()[w];
    for (int k = segment.begin; k < segment.end; ++k)
      energies.push_back(at_walls.stored_energy(k, walls_[w].contact));
  }
  for (const MeshContact& c : mesh_contacts_.contacts())
    energies.push_back(MeshContacts::elastic_energy(c, mesh_walls_[c.wall].contact));
  for (const RollingSpring& s : rolling_.springs())
    if (clumps_.ghost[s.key[1]] == 0) energies.push_back(energy_of(s));
  return energies;
}

int Engine::n_touching_spheres() const
{
  int count = 0;
  const ContactLanes& pairs = lists_.pair_lanes();
  for (int k = 0; k < pairs.size(); ++k)
    count += pairs.holds_something(k) && clumps_.ghost[pairs.key(k).i] == 0;
  return count;
}

double Engine::kinetic_energy() const
{
  std::vector<double> energies;
  for (int i = 0; i < clumps_.size(); ++i)
    if (clumps_.ghost[i] == 0) energies.push_back(kinetic_energy_of(clumps_, i));
  return order_free_sum(energies, ranks_);
}

double Engine::mass() const
{
  std::vector<double> masses;
  for (int i = 0; i < clumps_.size(); ++i)
    if (clumps_.ghost[i] == 0) masses.push_back(clumps_.mass[i]);
  return order_free_sum(masses, ranks_);
}
} // namespace interlock::dem
