#include "dem/bodies/clumps.h"

#include "dem/bodies/rigid_motion.h"
#include "dem/bodies/wide.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace interlock::dem
{
namespace
{
double largest_member_distance(const ClumpShape& shape)
{
  double reach = 0;
  for (const Sphere& sphere : shape.spheres) reach = std::max(reach, sphere.centre.norm());
  return reach;
}

template <class T> void compact(std::vector<T>& values, const std::vector<bool>& remove)
{
  std::size_t kept = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!remove[i]) values[kept++] = values[i];
  values.resize(kept);
}

LaneVector<Wide> load(const VectorField& field, int i)
{
  return {Wide::load(field.row(0) + i), Wide::load(field.row(1) + i), Wide::load(field.row(2) + i)};
}
void store(VectorField& field, int i, LaneVector<Wide> a)
{
  a.x.store(field.row(0) + i), a.y.store(field.row(1) + i), a.z.store(field.row(2) + i);
}
LaneQuaternionOf<Wide> load(const QuaternionField& field, int i)
{
  return {Wide::load(field.row(0) + i), Wide::load(field.row(1) + i), Wide::load(field.row(2) + i),
          Wide::load(field.row(3) + i)};
}
void store(QuaternionField& field, int i, LaneQuaternionOf<Wide> q)
{
  q.x.store(field.row(0) + i), q.y.store(field.row(1) + i), q.z.store(field.row(2) + i);
  q.w.store(field.row(3) + i);
}

LaneQuaternion lane(const Quaternion& q)
{
  return {q.x(), q.y(), q.z(), q.w()};
}
} // namespace

Clumps::Clumps(std::vector<ClumpShape> shapes)
{
  for (ClumpShape& shape : shapes) add_shape(std::move(shape));
}

int Clumps::add_shape(ClumpShape shape)
{
  bounding_radius_.push_back(shape.bounding_radius());
  shapes_.push_back(std::move(shape));
  return static_cast<int>(shapes_.size()) - 1;
}

int Clumps::add(int new_shape, double density, const Vector3& x, const Quaternion& q)
{
  shape.push_back(new_shape);
  id.push_back(next_id_++);
  kind.push_back(BodyKind::stone);
  const double m = density * shapes_[new_shape].volume;
  const Vector3 moments = density * shapes_[new_shape].unit_inertia;
  mass.push_back(m * one);
  inverse_mass.push_back(1 / m * one);
  ghost.push_back(0 * one);
  inertia.push_back(moments);
  inverse_inertia.push_back(moments.cwiseInverse());
  member_reach_.push_back(largest_member_distance(shapes_[new_shape]) * one);
  position.push_back(x);
  orientation.push_back(q);
  for (VectorField* zero : {&velocity, &angular_momentum, &spin, &drift_velocity, &step_velocity,
                            &step_spin, &force, &torque, &lost})
    zero->push_back(Vector3::Zero());
  lost_to_crushing.push_back(0 * one);
  return size() - 1;
}

std::vector<int> Clumps::remove(const std::vector<bool>& remove)
{
  std::vector<int> new_index(remove.size(), -1);
  int kept = 0;
  for (std::size_t i = 0; i < remove.size(); ++i)
    if (!remove[i]) new_index[i] = kept++;
  compact(shape, remove);
  compact(id, remove);
  compact(kind, remove);
  orientation.compact(remove);
  for (ScalarField* field : {&mass, &inverse_mass, &member_reach_, &ghost, &lost_to_crushing})
    field->compact(remove);
  for (VectorField* field :
       {&inertia, &inverse_inertia, &position, &velocity, &angular_momentum, &spin, &drift_velocity,
        &step_velocity, &step_spin, &force, &torque, &lost})
    field->compact(remove);
  return new_index;
}

ClumpState Clumps::state_of(int i) const
{
  ClumpState state;
  state.id = id[i], state.shape = shape[i], state.kind = kind[i], state.mass = mass[i];
  state.inertia = inertia[i], state.position = position[i], state.orientation = orientation[i];
  state.velocity = velocity[i], state.angular_momentum = angular_momentum[i];
  state.drift_velocity = drift_velocity[i], state.spin = spin[i];
  state.step_velocity = step_velocity[i], state.step_spin = step_spin[i];
  state.force = force[i], state.torque = torque[i], state.lost = lost[i];
  state.lost_to_crushing = lost_to_crushing[i];
  state.is_ghost = ghost[i] == 1;
  return state;
}

void Clumps::assign(const std::vector<ClumpState>& states)
{
  const int n = static_cast<int>(states.size());
  id.resize(n), shape.resize(n), kind.resize(n);
  orientation.resize(n);
  for (ScalarField* field : {&mass, &inverse_mass, &ghost, &lost_to_crushing}) field->resize(n);
  for (VectorField* field :
       {&inertia, &inverse_inertia, &position, &velocity, &angular_momentum, &spin, &drift_velocity,
        &step_velocity, &step_spin, &force, &torque, &lost})
    field->resize(n);
  for (int i = 0; i < n; ++i) {
    const ClumpState& s = states[i];
    id[i] = s.id, shape[i] = s.shape, kind[i] = s.kind;
    mass[i] = s.mass, inverse_mass[i] = 1 / s.mass, ghost[i] = s.is_ghost ? 1 : 0;
    inertia[i] = s.inertia, inverse_inertia[i] = s.inertia.cwiseInverse();
    position[i] = s.position;
    orientation.set(i, s.orientation);
    velocity[i] = s.velocity, angular_momentum[i] = s.angular_momentum;
    drift_velocity[i] = s.drift_velocity, spin[i] = s.spin;
    step_velocity[i] = s.step_velocity, step_spin[i] = s.step_spin;
    force[i] = s.force, torque[i] = s.torque, lost[i] = s.lost;
    lost_to_crushing[i] = s.lost_to_crushing;
  }
  derive_from_shapes();
}

int Clumps::index_of(std::int64_t wanted) const
{
  const auto found = std::lower_bound(id.begin(), id.end(), wanted);
  return found != id.end() && *found == wanted ? static_cast<int>(found - id.begin()) : -1;
}

void Clumps::set_motion(int i, const Vector3& v, const Vector3& w)
{
  const Quaternion q = orientation[i];
  const Vector3 moments = inertia[i];
  angular_momentum[i] = q * moments.cwiseProduct(q.conjugate() * w).eval();
  velocity[i] = drift_velocity[i] = step_velocity[i] = v;
  spin[i] = step_spin[i] = w;
}

// What is kept for speed and follows from the shapes.
void Clumps::derive_from_shapes()
{
  bounding_radius_.clear();
  for (const ClumpShape& s : shapes_) bounding_radius_.push_back(s.bounding_radius());
  ghost.resize(size());
  member_reach_.resize(0);
  for (const int s : shape) {
    if (s < 0 || s >= static_cast<int>(shapes_.size()))
      throw std::logic_error("A clump has the shape " + std::to_string(s) + " of " +
                             std::to_string(shapes_.size()) + ".");
    member_reach_.push_back(largest_member_distance(shapes_[s]) * one);
  }
}

void Clumps::validate() const
{
  const auto require = [](bool good, const std::string& what) {
    if (!good) throw std::logic_error("The clumps are inconsistent: " + what + ".");
  };
  const int n = size();
  for (const std::size_t length : {shape.size(), id.size(), kind.size()})
    require(length == static_cast<std::size_t>(n), "their arrays differ in length");
  for (const VectorField* field :
       {&inertia, &inverse_inertia, &velocity, &angular_momentum, &spin, &drift_velocity,
        &step_velocity, &step_spin, &force, &torque, &lost})
    require(field->size() == n, "their arrays differ in length");
  require(mass.size() == n && inverse_mass.size() == n && orientation.size() == n &&
              member_reach_.size() == n && lost_to_crushing.size() == n,
          "their arrays differ in length");
  for (int i = 0; i < n; ++i) {
    const std::string who = "clump " + std::to_string(id[i]);
    require(i == 0 || id[i - 1] < id[i], "ids do not ascend at " + who);
    require(id[i] < next_id_, who + " has an id that is still to be given");
    require(shape[i] >= 0 && shape[i] < static_cast<int>(shapes_.size()), who + " has no shape");
    require(mass[i] > 0 && std::isfinite(mass[i]), who + " has no positive mass");
    require(Vector3(position[i]).allFinite() && Vector3(velocity[i]).allFinite() &&
                Vector3(angular_momentum[i]).allFinite(),
            who + " has a motion that is not finite");
    require(std::abs(orientation[i].norm() - 1) < 1e-6,
            who + " has an attitude that is no rotation");
  }
}

Vector3 Clumps::spin_of(int i, const Vector3& momentum) const
{
  return vector(
      spin_from_momentum(lane(orientation[i]), dem::lane(momentum), dem::lane(inverse_inertia[i])));
}

void Clumps::drift_all(double dt, const ScalarField& held_clumps)
{
  for (int i = 0; i < position.padded_size(); i += Wide::lanes) {
    const auto held = Wide::load(held_clumps.row(0) + i) > 0;
    const LaneQuaternionOf<Wide> q = load(orientation, i);
    const AttitudeStep<Wide> step =
        advance_attitude(q, load(angular_momentum, i), load(inverse_inertia, i), dt);
    store(orientation, i, select(held, q, step.attitude));
    const LaneVector<Wide> w = select(held, load(spin, i), step.spin);
    store(spin, i, w);
    store(step_spin, i, w);

    const LaneVector<Wide> x = load(position, i), now = load(velocity, i);
    const LaneVector<Wide> v = select(held, load(drift_velocity, i), now);
    store(position, i, select(held, x, x + dt * now));
    store(drift_velocity, i, v);
    store(step_velocity, i, v);
  }
}

std::int64_t Clumps::n_spheres() const
{
  std::int64_t n = 0;
  for (int i = 0; i < size(); ++i) n += shape_of(i).spheres.size();
  return n;
}
} // namespace interlock::dem
