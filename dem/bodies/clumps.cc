#include "dem/bodies/clumps.h"

#include "dem/bodies/rigid_motion.h"

#include <cmath>

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
  const double m = density * shapes_[new_shape].volume;
  const Vector3 moments = density * shapes_[new_shape].unit_inertia;
  mass.push_back(m * one);
  inverse_mass.push_back(1 / m * one);
  inertia.push_back(moments);
  inverse_inertia.push_back(moments.cwiseInverse());
  member_reach_.push_back(largest_member_distance(shapes_[new_shape]) * one);
  position.push_back(x);
  orientation.push_back(q);
  for (VectorField* zero : {&velocity, &angular_momentum, &spin, &drift_velocity, &step_velocity,
                            &step_spin, &force, &torque})
    zero->push_back(Vector3::Zero());
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
  orientation.compact(remove);
  for (ScalarField* field : {&mass, &inverse_mass, &member_reach_}) field->compact(remove);
  for (VectorField* field : {&inertia, &inverse_inertia, &position, &velocity, &angular_momentum,
                             &spin, &drift_velocity, &step_velocity, &step_spin, &force, &torque})
    field->compact(remove);
  return new_index;
}

Vector3 Clumps::spin_of(int i, const Vector3& momentum) const
{
  return vector(
      spin_from_momentum(lane(orientation[i]), dem::lane(momentum), dem::lane(inverse_inertia[i])));
}

void Clumps::kick(int i, double dt, const Vector3& f, const Vector3& t)
{
  velocity[i] += (dt * inverse_mass[i]) * f;
  angular_momentum[i] += dt * t;
}

void Clumps::drift(int i, double dt)
{
  position[i] += dt * velocity[i];
  const AttitudeStep step = advance_attitude(lane(orientation[i]), dem::lane(angular_momentum[i]),
                                             dem::lane(inverse_inertia[i]), dt);
  const LaneQuaternion q = step.attitude;
  orientation.set(i, Quaternion(q.w, q.x, q.y, q.z));
  spin[i] = step_spin[i] = vector(step.spin);
  drift_velocity[i] = step_velocity[i] = velocity[i];
}

void Clumps::drift_all(double dt, const ScalarField& held_clumps)
{
  const double* __restrict held = held_clumps.row(0);
  const double *__restrict lx = angular_momentum.row(0), *__restrict ly = angular_momentum.row(1),
                           *__restrict lz = angular_momentum.row(2);
  const double *__restrict ix = inverse_inertia.row(0), *__restrict iy = inverse_inertia.row(1),
                           *__restrict iz = inverse_inertia.row(2);
  double *__restrict qx = orientation.row(0), *__restrict qy = orientation.row(1),
                     *__restrict qz = orientation.row(2), *__restrict qw = orientation.row(3);
  double* __restrict wx = spin.row(0), * __restrict wy = spin.row(1), * __restrict wz = spin.row(2);
  double *__restrict sx = step_spin.row(0), *__restrict sy = step_spin.row(1),
                     *__restrict sz = step_spin.row(2);
  const int n = position.padded_size();
#pragma GCC ivdep
  for (int i = 0; i < n; ++i) {
    const AttitudeStep step = advance_attitude({qx[i], qy[i], qz[i], qw[i]}, {lx[i], ly[i], lz[i]},
                                               {ix[i], iy[i], iz[i]}, dt);
    const bool moves = held[i] == 0;
    qx[i] = moves ? step.attitude.x : qx[i];
    qy[i] = moves ? step.attitude.y : qy[i];
    qz[i] = moves ? step.attitude.z : qz[i];
    qw[i] = moves ? step.attitude.w : qw[i];
    wx[i] = sx[i] = moves ? step.spin.x : wx[i];
    wy[i] = sy[i] = moves ? step.spin.y : wy[i];
    wz[i] = sz[i] = moves ? step.spin.z : wz[i];
  }
  for (int component = 0; component < 3; ++component) {
    const double* __restrict v = velocity.row(component);
    double* __restrict x = position.row(component);
    double* __restrict drift = drift_velocity.row(component);
    double* __restrict mean = step_velocity.row(component);
#pragma GCC ivdep
    for (int i = 0; i < n; ++i) {
      x[i] += held[i] == 0 ? dt * v[i] : 0;
      drift[i] = mean[i] = held[i] == 0 ? v[i] : drift[i];
    }
  }
}

std::int64_t Clumps::n_spheres() const
{
  std::int64_t n = 0;
  for (int i = 0; i < size(); ++i) n += shape_of(i).spheres.size();
  return n;
}
} // namespace interlock::dem
