// Equilibrium paths by the arc-length method.
#pragma once

#include "fem/statics/arc_length_options.h"
#include "fem/statics/lattice_system.h"
#include "fem/statics/static_options.h"

#include <optional>
#include <vector>

namespace interlock::fem
{
// Cylindrical arc length (Crisfield, Computers & Structures 13 (1981) 55-62): in each step the load
// factor l is an unknown, and the increment du of the displacements has a given length,
//   f(u0 + du) = f0 + l p,   |du| = arc,
// with f the internal forces, f0 the loads already there, p the loads that the factor multiplies,
// and
// |.| the root mean square over the nodes (turns follow, but do not count). Every Newton iteration
// solves two systems with one factorised tangent K, for -K^-1 residual and for K^-1 p; the change
// of l is the root of a quadratic that keeps closest to the increment before. A step sets out to
// the side on which the last one went, so it passes limit points of load and of displacement alike.
class ArcLength
{
public:
  // The state must outlive this object; it moves along the path.
  // Throws std::invalid_argument when the first load is zero or not finite.
  ArcLength(StaticState& state, const StaticOptions& options, const ArcLengthOptions& arc_length);

  // The path from the present state on, which is its first point, with the load factor 0. Points
  // where the load factor has an extremum are found and inserted. Throws std::runtime_error when no
  // shorter arc leads on, or when `max_points` are reached before `is_last` has ended the path; the
  // state is that of the last point.
  std::vector<PathPoint> trace();

private:
  using Vector = dealii::Vector<double>; // all freedoms on every process

  // An end of a step, with the direction in which the path goes on.
  struct Place {
    std::vector<Eigen::Vector3d> position;
    std::vector<Eigen::Quaterniond> orientation;
    double load_factor;
    Vector response; // K^-1 p
    double sign;     // of the load factor's change along the path
    double slope;    // change of the load factor per arc [1/m]
  };
  struct Step {
    Vector increment;
    double load_factor;
    int iterations;
  };

  std::optional<Step> solve_step(const Place& from, double arc);
  Place place_after(const Step& step);
  Place place_at(double load_factor, double sign);
  void go_to(const Place& place);
  std::optional<Place> find_limit(const Place& from, const Place& to, double arc);
  std::optional<double> load_change(const Vector& increment, const Vector& correction,
                                    const Vector& response, double arc) const;
  void make_solver();
  // Infinite where the tangent cannot be factorised.
  Vector solve(const dealii::PETScWrappers::MPI::Vector& right_side);
  Vector response();
  double product(const Vector& a, const Vector& b) const; // of displacements, mean over the nodes
  double length(const Vector& a) const;
  PathPoint point(double load_factor, bool limit) const;

  StaticState& state_;
  const ArcLengthOptions arc_length_;
  LatticeSystem system_;
  const std::vector<NodeLoad> base_loads_;
  std::vector<NodeLoad> loads_; // those that the factor multiplies
  dealii::PETScWrappers::MPI::Vector sum_, load_vector_, solution_;
  KspOwner ksp_;
};
} // namespace interlock::fem
