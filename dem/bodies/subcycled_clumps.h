// Clumps that move in sub-steps while all others make whole steps.
#pragma once

#include "dem/bodies/clumps.h"

#include <vector>

namespace interlock::dem
{
// A copy of a few clumps, side by side, so that vector lanes are full. A clump's index in it is its
// place. World frame, SI units; the fields mean what those of Clumps mean.
class SubcycledClumps
{
public:
  // Takes copies of these clumps. Sums start from zero.
  void take(const Clumps& clumps, const std::vector<int>& which);
  // Writes their poses, momenta and the motion of the last sub-step back to the clumps that they
  // were taken from. The motion of the whole step is the mean over the sub-steps.
  void put_back(Clumps& clumps) const;

  int size() const { return position.size(); }

  void clear_loads();
  // Kicks and drifts by h [s] with force and torque. Returns the work that they did [J], force
  // times the mean of the velocities of the drifts before and after the kick, as a sum of numbers
  // on the energy grid (dem/exact_sums.h).
  double move(double h);

  // Means over the sub-steps since they were taken.
  Vector3 mean_force(int place) const { return force_sum_[place] / n_moves_; }   // [N]
  Vector3 mean_torque(int place) const { return torque_sum_[place] / n_moves_; } // [N m]

  ScalarField inverse_mass{one};                // [1/kg]
  VectorField inverse_inertia{Vector3::Ones()}; // principal, body frame [1/(kg m2)]
  VectorField position;                         // of the centre of mass [m]
  QuaternionField orientation;                  // body to world
  VectorField velocity, angular_momentum;       // [m/s], [kg m2/s]
  VectorField drift_velocity, spin;             // of the last drift [m/s], [rad/s]
  VectorField force, torque;                    // of this sub-step, about the centre of mass

private:
  inline static const Eigen::Matrix<double, 1, 1> one = Eigen::Matrix<double, 1, 1>::Ones();

  void resize(int n);

  std::vector<int> which_;
  VectorField velocity_sum_, spin_sum_, force_sum_, torque_sum_;
  ScalarField work_;
  int n_moves_ = 0;
};
} // namespace interlock::dem
