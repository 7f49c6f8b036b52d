#include "dem/clumps.h"

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

// Quaternion of the rotation vector `angle` (world axes). The series are exact to rounding for the
// small angles of one step, and several times faster than the library's functions.
Quaternion rotation_step(const Vector3& angle)
{
  const double h2 = 0.25 * angle.squaredNorm(); // half the angle, squared
  double cosine, sinc;
  if (h2 < 1e-4) {
    cosine = 1 - h2 / 2 * (1 - h2 / 12 * (1 - h2 / 30));
    sinc = 1 - h2 / 6 * (1 - h2 / 20 * (1 - h2 / 42));
  } else {
    const double h = std::sqrt(h2);
    cosine = std::cos(h);
    sinc = std::sin(h) / h;
  }
  Quaternion q;
  q.w() = cosine;
  q.vec() = 0.5 * sinc * angle;
  return q;
}
} // namespace

Clumps::Clumps(std::vector<ClumpShape> shapes)
{
  for (ClumpShape& shape : shapes) add_shape(std::move(shape));
}

int Clumps::add_shape(ClumpShape shape)
{
  bounding_radius_.push_back(shape.bounding_radius());
  member_reach_.push_back(largest_member_distance(shape));
  shapes_.push_back(std::move(shape));
  return static_cast<int>(shapes_.size()) - 1;
}

int Clumps::add(int new_shape, double density, const Vector3& x, const Quaternion& q)
{
  shape.push_back(new_shape);
  id.push_back(next_id_++);
  mass.push_back(density * shapes_[new_shape].volume);
  inertia.push_back(density * shapes_[new_shape].unit_inertia);
  position.push_back(x);
  orientation.push_back(q);
  rotation.push_back(q.toRotationMatrix());
  for (std::vector<Vector3>* zero : {&velocity, &angular_momentum, &spin, &drift_velocity,
                                     &drift_spin, &step_velocity, &step_spin, &force, &torque})
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
  compact(mass, remove);
  compact(orientation, remove);
  compact(rotation, remove);
  for (std::vector<Vector3>* field :
       {&inertia, &position, &velocity, &angular_momentum, &spin, &drift_velocity, &drift_spin,
        &step_velocity, &step_spin, &force, &torque})
    compact(*field, remove);
  return new_index;
}

Vector3 Clumps::spin_of(int i, const Vector3& momentum) const
{
  return rotation[i] * (rotation[i].transpose() * momentum).cwiseQuotient(inertia[i]);
}

void Clumps::kick(int i, double dt, const Vector3& f, const Vector3& t)
{
  velocity[i] += (dt / mass[i]) * f;
  angular_momentum[i] += dt * t;
  spin[i] = spin_of(i, angular_momentum[i]);
}

void Clumps::drift(int i, double dt)
{
  position[i] += dt * velocity[i];
  // Spin half a step ahead, with the angular momentum constant in the world.
  const Quaternion ahead = rotation_step(0.5 * dt * spin[i]) * orientation[i];
  const Matrix3 r = ahead.toRotationMatrix();
  spin[i] = r * (r.transpose() * angular_momentum[i]).cwiseQuotient(inertia[i]);
  orientation[i] = rotation_step(dt * spin[i]) * orientation[i];
  // One Newton step of 1/sqrt: the norm is 1 up to rounding already.
  orientation[i].coeffs() *= 1.5 - 0.5 * orientation[i].squaredNorm();
  rotation[i] = orientation[i].toRotationMatrix();
  drift_velocity[i] = step_velocity[i] = velocity[i];
  drift_spin[i] = step_spin[i] = spin[i];
}

std::int64_t Clumps::n_spheres() const
{
  std::int64_t n = 0;
  for (int i = 0; i < size(); ++i) n += shape_of(i).spheres.size();
  return n;
}
} // namespace interlock::dem
