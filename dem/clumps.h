// The state of all clumps: rigid bodies that share shapes. World frame, SI units.
#pragma once

#include "dem/clump_shape.h"

#include <cstdint>

namespace interlock::dem
{
// One array a quantity; index = clump. Velocities and angular momenta live at half steps
// (leapfrog): after a kick they belong to the middle of the step that the next drift makes.
class Clumps
{
public:
  explicit Clumps(std::vector<ClumpShape> shapes);

  // Adds a clump at rest and returns its index. `density` in kg/m3. `id` is kept for life; indices
  // shift when clumps are removed.
  int add(int shape, double density, const Vector3& position, const Quaternion& orientation);

  // Adds one more shape (for example the sphere of a surcharge) and returns its index.
  int add_shape(ClumpShape shape);

  // Removes the clumps with remove[i] true; the others keep their order. Returns for every old
  // index the new one, or -1.
  std::vector<int> remove(const std::vector<bool>& remove);

  int size() const { return static_cast<int>(position.size()); }
  const ClumpShape& shape_of(int clump) const { return shapes_[shape[clump]]; }
  const std::vector<ClumpShape>& shapes() const { return shapes_; }
  double bounding_radius(int clump) const { return bounding_radius_[shape[clump]]; } // [m]
  double member_reach(int clump) const
  {
    return member_reach_[shape[clump]];
  } // largest |centre| [m]

  // Centre of member sphere `a` from the clump's centre of mass, world axes [m].
  Vector3 member_offset(int clump, int a) const
  {
    return rotation[clump] * shape_of(clump).spheres[a].centre;
  }
  // World spin from the angular momentum at the present attitude [rad/s].
  Vector3 spin_of(int clump, const Vector3& momentum) const;

  // Adds dt times force and torque to the momenta and refreshes the spin.
  void kick(int clump, double dt, const Vector3& force, const Vector3& torque);

  // Moves one clump by dt. The attitude takes one midpoint step of the free asymmetric body: half a
  // step to find the spin there, then a full step with it (second order, spatial angular momentum
  // exact).
  void drift(int clump, double dt);

  std::int64_t n_spheres() const; // of all clumps together

  std::vector<int> shape;
  std::vector<std::int64_t> id;
  std::vector<double> mass;              // [kg]
  std::vector<Vector3> inertia;          // principal, body frame [kg m2]
  std::vector<Vector3> position;         // of the centre of mass [m]
  std::vector<Quaternion> orientation;   // body to world
  std::vector<Matrix3> rotation;         // the same as a matrix
  std::vector<Vector3> velocity;         // [m/s]
  std::vector<Vector3> angular_momentum; // [kg m2/s]
  std::vector<Vector3> spin;             // [rad/s]
  // Of the last drift: what the contacts of a sub-step saw move. The momenta may have been kicked
  // since.
  std::vector<Vector3> drift_velocity, drift_spin; // [m/s], [rad/s]
  // Mean over the last whole step: what the contacts of the step saw move. Equal to that of the
  // drift, unless the step was made of several drifts and the caller wrote their mean here.
  std::vector<Vector3> step_velocity, step_spin;
  std::vector<Vector3> force;  // of this step, without gravity [N]
  std::vector<Vector3> torque; // about the centre of mass [N m]

private:
  std::vector<ClumpShape> shapes_;
  std::vector<double> bounding_radius_, member_reach_;
  std::int64_t next_id_ = 0;
};
} // namespace interlock::dem
