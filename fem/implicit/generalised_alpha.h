// The generalised-alpha rule on a Lie group, for one node: Bruels, Cardona & Arnold, Mechanism and
// Machine Theory 48 (2012) 121-137, eqs. (16)-(21); coefficients of Chung & Hulbert, J. Appl. Mech.
// 60 (1993) 371-375. Second order; high frequencies shrink by the spectral radius each step.
#pragma once

#include <Eigen/Dense>

namespace interlock::fem
{
struct GeneralisedAlpha {
  // `spectral_radius` in [0, 1]: 1 is the trapezoidal rule, which keeps all frequencies; 0 takes
  // those that the step does not resolve out at once. `step` [s].
  GeneralisedAlpha(double spectral_radius, double step) : h(step)
  {
    alpha_m = (2 * spectral_radius - 1) / (spectral_radius + 1);
    alpha_f = spectral_radius / (spectral_radius + 1);
    gamma = 0.5 + alpha_f - alpha_m;
    beta = 0.25 * (gamma + 0.5) * (gamma + 0.5);
  }
  // Derivatives of the velocity [1/s] and acceleration [1/s2] at the end of the step by its
  // increment.
  double velocity_slope() const { return gamma / (beta * h); }
  double acceleration_slope() const { return (1 - alpha_m) / ((1 - alpha_f) * beta * h * h); }

  double h, alpha_m, alpha_f, gamma, beta;
};

// What the rule carries from step to step: of the displacement in the world frame [m/s, m/s2], or
// of the rotation in the frame of the body [rad/s, rad/s2].
struct Rates {
  Eigen::Vector3d velocity{0, 0, 0};
  Eigen::Vector3d acceleration{0, 0, 0}; // satisfies the equation of motion at this time
  Eigen::Vector3d averaged{0, 0, 0};     // the rule's own acceleration, which lags behind it
};

// Rates at the end of a step whose increment [m or rad] is given: a displacement, or the rotation
// vector in the frame that the body has at the start of the step.
inline Rates advanced(const GeneralisedAlpha& rule, const Rates& start,
                      const Eigen::Vector3d& increment)
{
  const double h = rule.h;
  Rates end;
  end.averaged =
      (increment / h - start.velocity - (0.5 - rule.beta) * h * start.averaged) / (rule.beta * h);
  end.velocity =
      start.velocity + h * ((1 - rule.gamma) * start.averaged + rule.gamma * end.averaged);
  end.acceleration = ((1 - rule.alpha_m) * end.averaged + rule.alpha_m * start.averaged -
                      rule.alpha_f * start.acceleration) /
                     (1 - rule.alpha_f);
  return end;
}

// Increment with unchanged acceleration: where Newton's method starts.
inline Eigen::Vector3d predicted_increment(const GeneralisedAlpha& rule, const Rates& start)
{
  return rule.h * start.velocity + 0.5 * rule.h * rule.h * start.averaged;
}
} // namespace interlock::fem
