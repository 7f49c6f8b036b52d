// The bound on the sub-step against the coupled system itself: lattice and stone in contact,
// linearised, with its stability limit from the eigenvalues of one leapfrog step. Fails when the
// bound leaves out a contact, a lever arm, the turning of sections or the dashpot, so that the
// sub-step would be unstable, or when it asks for several times more sub-steps than are needed.
#include "tests/cross_of_ribs.h"
#include "tests/rib_touch.h"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

using namespace cross_of_ribs;
using Eigen::MatrixXd;

namespace
{
constexpr double density = 2650; // of the stones [kg/m3]

// A ball that overlaps the rib along x: where it is, and which way the contact pushes it.
struct Place {
  double x;     // along the rib [m]
  double y;     // of the nearest point of the core, across it [m]
  double slope; // of the normal, 0 up, pi/2 along +y [rad]
  double radius;
};

// Ball and lattice in contact, and the coupled system linearised about this state: unknowns are
// displacement and rotation of each free node, then of the ball.
class Coupled
{
public:
  Coupled(const Place& place, double damping_ratio)
      : geogrid_(cross(8)), clumps_({ball(place.radius)}), contacts_(contact(damping_ratio))
  {
    const Vector3 normal(0, std::sin(place.slope), std::cos(place.slope));
    const Vector3 core(place.x, place.y, 0.5 * rib_section().thickness - edge_rounding);
    const double overlap = 1e-6;
    clumps_.add(0, density, core + (place.radius + edge_rounding - overlap) * normal,
                dem::Quaternion::Identity());
    dem::ContactEnergy energy;
    touch_ribs(contacts_, clumps_, geogrid_.ribs(), 1e-9, energy);
    for (int node = 0; node < geogrid_.lattice().n_nodes(); ++node)
      if (geogrid_.lattice().reference_position(node).norm() < half_length - 1e-9)
        free_nodes_.push_back(node);
    n_ = 6 * (static_cast<int>(free_nodes_.size()) + 1);
    fill_mass();
    fill_beams();
    fill_contacts();
  }

  int touching() const { return touching_; }
  double bound(double dt)
  {
    const coupling::SubstepNeeds needs = geogrid_.substep_needs(geogrid_.contact_rates(contacts_));
    return dt / geogrid_.required_substeps(dt, needs, contacts_.properties().damping_ratio);
  }

  // 2 / omega of the beams alone, and of the whole without dashpots [s].
  double beam_limit() const { return 2 / std::sqrt(fastest(beams_)); }
  double undamped_limit() const { return 2 / std::sqrt(fastest(beams_ + springs_)); }

  // The largest step at which one leapfrog step, whose dashpots see the velocities half a step
  // back, makes nothing grow [s].
  double limit() const
  {
    double stable = 0.05 * undamped_limit(), unstable = 1.05 * undamped_limit();
    for (int n = 0; n < 12; ++n) {
      const double h = 0.5 * (stable + unstable);
      (growth(h) < 1 + 1e-5 ? stable : unstable) = h;
    }
    return stable;
  }

private:
  double fastest(const MatrixXd& stiffness) const // omega^2 [1/s2]
  {
    const Eigen::VectorXd root = mass_.cwiseSqrt().cwiseInverse();
    const MatrixXd scaled = root.asDiagonal() * stiffness * root.asDiagonal();
    return Eigen::SelfAdjointEigenSolver<MatrixXd>(scaled, Eigen::EigenvaluesOnly)
        .eigenvalues()
        .maxCoeff();
  }

  double growth(double h) const
  {
    // In coordinates times the root of the mass, and velocities times h.
    const Eigen::VectorXd root = mass_.cwiseSqrt().cwiseInverse();
    const MatrixXd k = h * h * (root.asDiagonal() * (beams_ + springs_) * root.asDiagonal()),
                   c = h * (root.asDiagonal() * dashpots_ * root.asDiagonal());
    const MatrixXd one = MatrixXd::Identity(n_, n_);
    MatrixXd step(2 * n_, 2 * n_);
    step << one - k, one - c, -k, one - c;
    return step.eigenvalues().cwiseAbs().maxCoeff();
  }

  void fill_mass()
  {
    mass_.resize(n_);
    const fem::ExplicitDynamics& d = geogrid_.dynamics();
    for (std::size_t f = 0; f < free_nodes_.size(); ++f) {
      mass_.segment<3>(6 * f).setConstant(d.mass(free_nodes_[f]));
      mass_.segment<3>(6 * f + 3).setConstant(d.inertia(free_nodes_[f]));
    }
    mass_.segment<3>(n_ - 6).setConstant(clumps_.mass[0]);
    mass_.segment<3>(n_ - 3) = clumps_.inertia[0];
  }

  // Force and moment on the free nodes in this state, from what one short step does to nodes at
  // rest.
  Eigen::VectorXd beam_forces(const fem::LatticeState& state)
  {
    fem::ExplicitDynamics& d = geogrid_.dynamics();
    const double h = 1e-10;
    d.set_state(state);
    d.clear_loads();
    d.step(h);
    Eigen::VectorXd f = Eigen::VectorXd::Zero(n_);
    for (std::size_t k = 0; k < free_nodes_.size(); ++k) {
      f.segment<3>(6 * k) = d.mass(free_nodes_[k]) / h * d.velocity(free_nodes_[k]);
      f.segment<3>(6 * k + 3) = d.inertia(free_nodes_[k]) / h * d.spin(free_nodes_[k]);
    }
    return f;
  }

  void fill_beams()
  {
    fem::LatticeState rest = geogrid_.dynamics().state();
    rest.previous_step = 1e-10; // or the first step would kick by half
    beams_ = MatrixXd::Zero(n_, n_);
    for (int j = 0; j < n_ - 6; ++j) {
      const int node = free_nodes_[j / 6];
      const Vector3 axis = Vector3::Unit(j % 3);
      const auto moved = [&](double amount) {
        fem::LatticeState state = rest;
        if (j % 6 < 3)
          state.position[node] += amount * axis;
        else
          state.orientation[node] = Eigen::AngleAxisd(amount, axis) * rest.orientation[node];
        return beam_forces(state);
      };
      const double amount = j % 6 < 3 ? 1e-7 : 1e-5;
      beams_.col(j) = (moved(-amount) - moved(amount)) / (2 * amount);
    }
    geogrid_.dynamics().set_state(rest);
    const MatrixXd asymmetry = beams_ - beams_.transpose();
    EXPECT_LT(asymmetry.cwiseAbs().maxCoeff(), 1e-4 * beams_.cwiseAbs().maxCoeff());
    beams_ = 0.5 * (beams_ + beams_.transpose()).eval();
  }

  // What a unit force along `direction` at the contact does to all unknowns: on the ball, and the
  // opposite on the rib.
  Eigen::VectorXd unit_force(const dem::RibContact& c, const Vector3& direction) const
  {
    Eigen::VectorXd b = Eigen::VectorXd::Zero(n_);
    b.segment<3>(n_ - 6) = direction;
    b.segment<3>(n_ - 3) = Vector3(c.point - clumps_.position[0]).cross(direction);
    const dem::RodLoads loads =
        dem::rod_loads(geogrid_.ribs()[c.rib], {c.rib, c.xi, -direction, -c.arm.cross(direction)});
    for (const int end : {0, 1}) {
      const int node = geogrid_.lattice().element(c.rib).node[end];
      const auto found = std::find(free_nodes_.begin(), free_nodes_.end(), node);
      if (found == free_nodes_.end()) continue;
      const auto f = found - free_nodes_.begin();
      b.segment<3>(6 * f) += loads.force[end];
      b.segment<3>(6 * f + 3) += loads.moment[end];
    }
    return b;
  }

  void fill_contacts()
  {
    springs_ = dashpots_ = MatrixXd::Zero(n_, n_);
    const dem::ContactProperties& pair = contacts_.properties();
    for (const dem::RibContact& c : contacts_.contacts()) {
      if (c.overlap <= 0) continue;
      ++touching_;
      const dem::Rib rib = geogrid_.ribs()[c.rib];
      const double reduced_mass =
          1 / (1 / clumps_.mass[0] + (1 - c.xi) * (1 - c.xi) * rib.inverse_mass[0] +
               c.xi * c.xi * rib.inverse_mass[1]);
      const Vector3 normal = (Vector3(clumps_.position[0]) - c.point).normalized();
      const Vector3 across = normal.unitOrthogonal();
      for (const Vector3& direction : {normal, across, Vector3(normal.cross(across))}) {
        const double k = direction == normal ? pair.normal_stiffness : pair.tangential_stiffness;
        const Eigen::VectorXd b = unit_force(c, direction);
        springs_ += k * b * b.transpose();
        dashpots_ += 2 * pair.damping_ratio * std::sqrt(k * reduced_mass) * b * b.transpose();
      }
    }
  }

  coupling::RibTransfer geogrid_;
  dem::Clumps clumps_;
  dem::RibContacts contacts_;
  std::vector<int> free_nodes_;
  int n_ = 0, touching_ = 0;
  Eigen::VectorXd mass_;
  MatrixXd beams_, springs_, dashpots_;
};

const Place on_top = {0.02, 0, 0, 0.012}, at_a_node = {0.0325, 0, 0, 0.012},
            on_the_edge = {0.02, 2e-3, 0.4, 0.012}, beside = {0.025, 2e-3, 1.5, 0.012},
            on_the_crossing = {1e-3, 0, 0, 0.012}, at_the_clamp = {0.06, 1e-3, 0, 0.012};
constexpr double whole_step = 1e-3; // long, so that rounding up to whole numbers does not blur
} // namespace

// The linearisation is right: its limit without a dashpot is 2 / omega, however it is found, and
// that of the beams alone is the one that fem bounds.
TEST(Substeps, LinearisedSystemIsConsistent)
{
  Coupled system(on_top, 0);
  EXPECT_EQ(system.touching(), 1);
  EXPECT_NEAR(system.limit(), system.undamped_limit(), 1e-3 * system.undamped_limit());
  const double beams = cross(8).dynamics().stable_step();
  EXPECT_LE(beams, system.beam_limit());
  EXPECT_GT(beams, 0.5 * system.beam_limit());
  // The contact matters: with the bound of the beams alone the step would be unstable.
  EXPECT_LT(system.undamped_limit(), 0.6 * beams);
}

// Half of the limit and more is used, but next to a clamp: there the bound takes the held node for
// a free one.
TEST(Substeps, BoundIsOnTheSafeSideAndNotFar)
{
  for (const double damping_ratio : {0., 0.1, 0.3})
    for (const Place& place :
         {on_top, at_a_node, on_the_edge, beside, on_the_crossing, at_the_clamp}) {
      Coupled system(place, damping_ratio);
      ASSERT_GE(system.touching(), 1);
      const double used = system.bound(whole_step) / system.limit();
      EXPECT_LT(used, 1) << place.x << ' ' << place.slope << ' ' << damping_ratio;
      EXPECT_GT(used, place.x == at_the_clamp.x ? 0.2 : 0.5)
          << place.x << ' ' << place.slope << ' ' << damping_ratio;
    }
}
