#include "dem/bodies/subcycled_clumps.h"

#include "dem/bodies/field_rows.h"
#include "dem/bodies/rigid_motion.h"
#include "dem/exact_sums.h"

#include <algorithm>

namespace interlock::dem
{
namespace
{
void clear(VectorField& field)
{
  for (int c = 0; c < 3; ++c) std::fill_n(field.row(c), field.padded_size(), 0.0);
}
} // namespace

void SubcycledClumps::resize(int n)
{
  inverse_mass.resize(n);
  work_.resize(n);
  orientation.resize(n);
  for (VectorField* field : {&inverse_inertia, &position, &velocity, &angular_momentum,
                             &drift_velocity, &spin, &force, &torque})
    field->resize(n);
  for (VectorField* sum : {&velocity_sum_, &spin_sum_, &force_sum_, &torque_sum_}) {
    sum->resize(n);
    clear(*sum);
  }
}

void SubcycledClumps::take(const Clumps& clumps, const std::vector<int>& which)
{
  which_ = which;
  n_moves_ = 0;
  resize(0); // entries beyond the last one are filler
  resize(static_cast<int>(which.size()));
  for (std::size_t place = 0; place < which.size(); ++place) {
    const int i = which[place], p = static_cast<int>(place);
    inverse_mass[p] = clumps.inverse_mass[i];
    inverse_inertia[p] = clumps.inverse_inertia[i];
    position[p] = clumps.position[i];
    orientation.set(p, clumps.orientation[i]);
    velocity[p] = clumps.velocity[i];
    angular_momentum[p] = clumps.angular_momentum[i];
    drift_velocity[p] = clumps.drift_velocity[i];
    spin[p] = clumps.spin[i];
  }
}

void SubcycledClumps::put_back(Clumps& clumps) const
{
  for (std::size_t place = 0; place < which_.size(); ++place) {
    const int i = which_[place], p = static_cast<int>(place);
    clumps.position[i] = position[p];
    clumps.orientation.set(i, orientation[p]);
    clumps.velocity[i] = velocity[p];
    clumps.angular_momentum[i] = angular_momentum[p];
    clumps.drift_velocity[i] = drift_velocity[p];
    clumps.spin[i] = spin[p];
    clumps.step_velocity[i] = velocity_sum_[p] / n_moves_;
    clumps.step_spin[i] = spin_sum_[p] / n_moves_;
  }
}

void SubcycledClumps::clear_loads()
{
  clear(force);
  clear(torque);
}

double SubcycledClumps::move(double h)
{
  ++n_moves_;
  const int n = position.padded_size();
  double* __restrict work = work_.row(0);
  const double* __restrict inverse = inverse_mass.row(0);
  std::fill_n(work, n, 0.0);
  for (int c = 0; c < 3; ++c) {
    const double* __restrict f = force.row(c);
    const double* __restrict t = torque.row(c);
    double* __restrict v = velocity.row(c);
    double* __restrict l = angular_momentum.row(c);
    double* __restrict x = position.row(c);
    double* __restrict before = drift_velocity.row(c);
    double* __restrict v_sum = velocity_sum_.row(c);
    double* __restrict f_sum = force_sum_.row(c);
    double* __restrict t_sum = torque_sum_.row(c);
#pragma GCC ivdep
    for (int i = 0; i < n; ++i) {
      const double after = v[i] + h * inverse[i] * f[i];
      work[i] += 0.5 * h * f[i] * (before[i] + after);
      v[i] = before[i] = after;
      x[i] += h * after;
      l[i] += h * t[i];
      v_sum[i] += after;
      f_sum[i] += f[i];
      t_sum[i] += t[i];
    }
  }
  const Rows3<const double> momentum(angular_momentum), inertia(inverse_inertia), moment(torque);
  const QuaternionRows<double> attitude(orientation);
  const Rows3<double> spins(spin), spin_sums(spin_sum_);
#pragma GCC ivdep
  for (int i = 0; i < n; ++i) {
    const auto step = advance_attitude(attitude.get(i), momentum.get(i), inertia.get(i), h);
    work[i] += 0.5 * h * dot(moment.get(i), spins.get(i) + step.spin);
    attitude.set(i, step.attitude);
    spins.set(i, step.spin);
    spin_sums.add(i, step.spin);
  }
  double sum = 0;
  for (int i = 0; i < size(); ++i) sum += on_grid<energy_grid>(work[i]);
  return sum;
}
} // namespace interlock::dem
