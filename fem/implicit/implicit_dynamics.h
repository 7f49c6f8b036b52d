// Implicit dynamics of a lattice: the generalised-alpha rule on the rotation group, for motion that
// is slow against the stretch waves which bound the step of the explicit integrator.
#pragma once

#include "fem/implicit/dynamic_step.h"
#include "fem/lattice/lumped_inertia.h"
#include "fem/statics/lattice_system.h"
#include "fem/statics/static_state.h"

#include <Eigen/Dense>
#include <Eigen/Geometry>

#include <array>
#include <functional>
#include <memory>
#include <vector>

namespace interlock::fem
{
struct ImplicitOptions {
  // In [0, 1]: what each step leaves of the fastest motion. 1 damps nothing, but stiff motion that
  // the step does not resolve may then grow while the lattice turns far.
  double spectral_radius = 0.8;
  Eigen::Vector3d gravity{0, 0, 0}; // world [m/s2]
  bool rbf = true;                  // residual bending flexibility in the shear stiffness
  int max_iterations = 30;          // Newton iterations in one step
  double step_tolerance = 1e-9;     // a step ends when the Newton step [m, rad] is shorter
};

// Energies [J] at the present time. Their ledger is constant up to the error of the rule: in a
// linear system to rounding with spectral radius 1; otherwise it falls by what the rule damps, and
// large turns add an error of the order of the square of the step.
struct ImplicitEnergies {
  double kinetic = 0;       // translation and rotation
  double elastic = 0;       // strain energy of all elements
  double gravitational = 0; // zero at the origin of the world frame
  double load_work = 0;     // done on the lattice by the loads since the start
  double support_work = 0;  // done on the lattice by the supports since the start
  double ledger() const { return kinetic + elastic + gravitational - load_work - support_work; }
};

// Steps the same element and lumped masses as ExplicitDynamics, with the rotary inertia of the
// sections as it is (not spherical). World frame throughout. PETSc must be running
// (dealii::Utilities::MPI::MPI_InitFinalize); every process of the communicator assembles and
// solves its part and holds the motion of all nodes.
class ImplicitDynamics
{
public:
  using Loads = std::vector<NodeLoad>; // one a node
  using LoadFunction = std::function<void(double time, Loads& loads)>;
  using MotionFunction = std::function<double(double time)>;

  // Starts at rest in `start`: unloaded, or as a StaticSolver has left it. Its supports stay where
  // they are and the loads that it is at rest under keep acting, unless the functions below say
  // otherwise. Throws std::invalid_argument when the spectral radius is outside [0, 1] or a node
  // has no mass or no rotary inertia.
  ImplicitDynamics(const StaticState& start, const ImplicitOptions& options,
                   MPI_Comm communicator = MPI_COMM_WORLD);
  ImplicitDynamics(const ImplicitDynamics&) = delete;
  ImplicitDynamics& operator=(const ImplicitDynamics&) = delete;

  // --- What acts, to be set before the first step ---
  // Replaces the loads: the function adds those of a time [s] to a list of zeros. They keep their
  // direction in the world frame.
  void set_loads(const LoadFunction& loads);
  // Prescribes freedom 0-5 of a node from time 0 on: displacement x, y, z from the unloaded state
  // [m], or rotation about the world's x, y, z [rad], of which only increments count; prescribe the
  // other two rotations of that node as well, as zero. The function should be smooth: a jump of its
  // velocity shakes the lattice, and the supports by the rule's own oscillation.
  // Throws std::runtime_error after the first step.
  void prescribe(int node, int component, const MotionFunction& value);
  // Velocity [m/s] and spin [rad/s] of a free node at the start.
  void set_motion(int node, const Eigen::Vector3d& velocity, const Eigen::Vector3d& spin);

  // --- Time ---
  // Advances by h [s]; returns the number of Newton iterations. The steps may differ, which costs
  // order while they do. Throws std::runtime_error when Newton's method does not converge; the
  // message names the time, the step and PETSc's reason.
  int step(double h);
  double time() const { return time_; } // [s]

  // --- Motion ---
  Eigen::Vector3d position(int node) const { return motion_.state.world_position(node); } // [m]
  // Rotation from the unloaded state.
  const Eigen::Quaterniond& orientation(int node) const { return motion_.state.orientation[node]; }
  // Velocity [m/s] and spin [rad/s].
  const Eigen::Vector3d& velocity(int node) const { return motion_.translation[node].velocity; }
  Eigen::Vector3d spin(int node) const
  {
    return motion_.state.orientation[node] * motion_.rotation[node].velocity;
  }
  // Force (first three) and moment that the supports exert on a node [N, N m], inertia of the node
  // included; zero at free nodes to the tolerance of the solution.
  const NodeLoad& reaction(int node) const { return reactions_[node]; }
  ImplicitEnergies energies() const;
  // Linear momentum [kg m/s] and angular momentum about the origin [kg m2/s] of all nodes.
  Eigen::Vector3d momentum() const;
  Eigen::Vector3d angular_momentum() const;

private:
  struct Support {
    int node, component;
    MotionFunction value;
  };

  Loads loads_at(double time) const;
  Loads reactions() const;
  void start(double h);
  void start_node(int node, const std::array<bool, 6>& fixed, const NodeLoad& prescribed,
                  const NodeLoad& unbalanced);
  void set_supports(double h);
  void accept(const GeneralisedAlpha& rule, const dealii::Vector<double>& x, Loads end_loads);

  ImplicitOptions options_;
  LatticeMotion motion_;
  std::vector<NodeInertia> nodes_;
  std::vector<Support> supports_;
  LoadFunction loads_at_;
  LatticeSystem system_;
  std::unique_ptr<DynamicStep> step_; // from the first step on
  double time_ = 0;
  Loads loads_, reactions_; // at the present time; loads without weight
  double load_work_ = 0, support_work_ = 0;
};
} // namespace interlock::fem
