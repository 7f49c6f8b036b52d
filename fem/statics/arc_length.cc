#include "fem/statics/arc_length.h"

#include "fem/ribs/number_text.h"
#include "fem/statics/resting_supports.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace interlock::fem
{
namespace
{
// A step ends when the last Newton correction is this share of its increment; since Newton's method
// doubles the digits, the next one would be at rounding.
constexpr double correction_tolerance = 1e-8;
} // namespace

ArcLength::ArcLength(StaticState& state, const StaticOptions& options,
                     const ArcLengthOptions& arc_length)
    : state_(state), arc_length_(arc_length), system_(state, options.rbf, options.communicator),
      base_loads_(state.reached_loads), loads_(state.loads), sum_(system_.new_vector()),
      load_vector_(system_.new_vector()), solution_(system_.new_vector())
{
  const double first = arc_length.first_load;
  if (first == 0 || !std::isfinite(first))
    throw std::invalid_argument("The first load factor of an equilibrium path is " +
                                number_text(first) + " but must be finite and not zero.");
  for (std::size_t i = 0; i < loads_.size(); ++i) loads_[i] -= base_loads_[i];
  system_.set_supports(resting_supports(state));
  system_.add_loads(loads_, 1, load_vector_);
  load_vector_.compress(dealii::VectorOperation::add);
  if (load_vector_.l2_norm() == 0)
    throw std::runtime_error(
        "The arc-length method needs a load on a free node, added since the last solution.");

  make_solver();
}

void ArcLength::make_solver()
{
  KSP ksp = nullptr;
  check(KSPCreate(system_.communicator(), &ksp));
  ksp_.reset(ksp);
  use_direct_solver(ksp);
  check(KSPSetOptionsPrefix(ksp, statics_prefix));
  check(KSPSetFromOptions(ksp));
  check(KSPSetOperators(ksp, system_.matrix(), system_.matrix()));
}

double ArcLength::product(const Vector& a, const Vector& b) const
{
  double sum = 0;
  for (int i = 0; i < state_.lattice.n_nodes(); ++i) {
    for (int c = 0; c < 3; ++c) {
      const unsigned int dof = state_.lattice.dof(i, c);
      sum += a[dof] * b[dof];
    }
  }
  return sum / state_.lattice.n_nodes();
}

double ArcLength::length(const Vector& a) const
{
  return std::sqrt(product(a, a));
}

ArcLength::Vector ArcLength::solve(const dealii::PETScWrappers::MPI::Vector& right_side)
{
  const QuietPetsc quiet;
  KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
  const PetscErrorCode error = KSPSolve(ksp_.get(), right_side, solution_);
  check(KSPGetConvergedReason(ksp_.get(), &reason));
  if (error == 0 && reason > 0) return system_.gathered(solution_);
  make_solver(); // PETSc would leave out the next factorisation
  solution_ = std::numeric_limits<double>::infinity();
  return system_.gathered(solution_);
}

ArcLength::Vector ArcLength::response()
{
  system_.tangent(system_.present());
  return solve(load_vector_);
}

PathPoint ArcLength::point(double load_factor, bool limit) const
{
  PathPoint point{load_factor, limit, {}};
  for (const int node : arc_length_.watched)
    point.displacement.push_back(state_.position.at(node) -
                                 state_.lattice.reference_position(node));
  return point;
}

// The change of the load factor with which the increment keeps its length: of both roots the one
// that turns the increment less. None when the correction leads too far away.
std::optional<double> ArcLength::load_change(const Vector& increment, const Vector& correction,
                                             const Vector& response, double arc) const
{
  Vector corrected = increment;
  corrected += correction;
  const double a = product(response, response), b = product(response, corrected);
  const double c = product(corrected, corrected) - arc * arc;
  const double discriminant = b * b - a * c;
  if (!(discriminant >= 0)) return std::nullopt;
  const double sign = product(response, increment) < 0 ? -1 : 1;
  return (-b + sign * std::sqrt(discriminant)) / a;
}

std::optional<ArcLength::Step> ArcLength::solve_step(const Place& from, double arc)
{
  go_to(from);
  const Vector start = system_.present();
  const double predicted = from.sign * arc / length(from.response);
  Step step{from.response, from.load_factor + predicted, 0};
  step.increment *= predicted;
  while (++step.iterations <= arc_length_.max_iterations) {
    Vector x = start;
    x += step.increment;
    system_.constraints().distribute(x);
    sum_ = 0;
    system_.internal_forces(x, sum_);
    system_.add_loads(base_loads_, -1, sum_);
    system_.add_loads(loads_, -step.load_factor, sum_);
    sum_.compress(dealii::VectorOperation::add);
    system_.tangent(x);
    Vector correction = solve(sum_);
    correction *= -1;
    const Vector response = solve(load_vector_);
    const std::optional<double> change = load_change(step.increment, correction, response, arc);
    if (!change) return std::nullopt;
    correction.add(*change, response);
    step.increment += correction;
    step.load_factor += *change;
    if (!(correction.l2_norm() < 1e3 * step.increment.l2_norm())) return std::nullopt;
    if (correction.l2_norm() <= correction_tolerance * step.increment.l2_norm()) return step;
  }
  return std::nullopt;
}

void ArcLength::go_to(const Place& place)
{
  state_.position = place.position;
  state_.orientation = place.orientation;
}

ArcLength::Place ArcLength::place_at(double load_factor, double sign)
{
  Place place{state_.position, state_.orientation, load_factor, response(), sign, 0};
  place.slope = sign / length(place.response);
  return place;
}

ArcLength::Place ArcLength::place_after(const Step& step)
{
  Vector x = system_.present();
  x += step.increment;
  state_.advance(x);
  Place place = place_at(step.load_factor, 1);
  if (product(place.response, step.increment) < 0) {
    place.sign = -1;
    place.slope *= -1;
  }
  return place;
}

// Illinois' variant of the secant method for the arc at which the load factor stands still.
std::optional<ArcLength::Place> ArcLength::find_limit(const Place& from, const Place& to,
                                                      double arc)
{
  double low = 0, high = arc, low_slope = from.slope, high_slope = to.slope;
  std::optional<Place> limit;
  for (int trial = 0; trial < 12 && high - low > 1e-5 * arc; ++trial) {
    const double between = (low * high_slope - high * low_slope) / (high_slope - low_slope);
    const std::optional<Step> step = solve_step(from, between);
    if (!step) return limit;
    limit = place_after(*step);
    if (std::abs(limit->slope) < 1e-5 * std::abs(from.slope - to.slope)) return limit;
    if ((limit->slope < 0) == (high_slope < 0)) {
      high = between;
      high_slope = limit->slope;
      low_slope *= 0.5;
    } else {
      low = between;
      low_slope = limit->slope;
      high_slope *= 0.5;
    }
  }
  return limit;
}

std::vector<PathPoint> ArcLength::trace()
{
  std::vector<PathPoint> path;
  const auto add = [&](double load_factor, bool limit) {
    path.push_back(point(load_factor, limit));
    return arc_length_.is_last && arc_length_.is_last(path.back());
  };
  Place here = place_at(0, arc_length_.first_load < 0 ? -1 : 1);
  const double first_arc = std::abs(arc_length_.first_load) * length(here.response);
  if (!(first_arc < 1e100))
    throw std::runtime_error(
        "The lattice is not held: it can move as a rigid body or a mechanism.");
  double arc = std::min(first_arc, arc_length_.largest_arc);
  const double smallest_arc = 1e-6 * arc;
  bool done = add(0, false);
  while (!done && static_cast<int>(path.size()) < arc_length_.max_points) {
    const std::optional<Step> step = solve_step(here, arc);
    if (!step) {
      go_to(here);
      arc *= 0.5;
      if (arc < smallest_arc)
        throw std::runtime_error("The equilibrium path cannot be followed beyond load factor " +
                                 std::to_string(here.load_factor) + ".");
      continue;
    }
    const Place next = place_after(*step);
    if (here.slope * next.slope < 0)
      if (const std::optional<Place> limit = find_limit(here, next, arc)) {
        go_to(*limit);
        done = add(limit->load_factor, true);
        if (done) break;
      }
    go_to(next);
    done = add(next.load_factor, false);
    here = next;
    const double factor =
        std::sqrt(static_cast<double>(arc_length_.wanted_iterations) / step->iterations);
    arc = std::min(arc * std::clamp(factor, 0.5, 2.), arc_length_.largest_arc);
  }
  for (std::size_t i = 0; i < loads_.size(); ++i)
    state_.reached_loads[i] = base_loads_[i] + path.back().load_factor * loads_[i];
  if (arc_length_.is_last && !done)
    throw std::runtime_error("The equilibrium path has come to load factor " +
                             number_text(path.back().load_factor) + " with " +
                             std::to_string(path.size()) +
                             " points, as many as max_points allows, before its end.");
  return path;
}
} // namespace interlock::fem
