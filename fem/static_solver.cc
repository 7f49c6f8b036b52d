#include "fem/static_solver.h"

#include "fem/beam_constants.h"
#include "fem/beam_tangent.h"
#include "fem/load_step.h"

#include <petscsys.h>

#include <stdexcept>

namespace interlock::fem
{
namespace
{
void require_petsc()
{
  PetscBool running = PETSC_FALSE;
  PetscInitialized(&running);
  if (running == PETSC_FALSE)
    throw std::runtime_error(
        "The static solver needs PETSc: create a dealii::Utilities::MPI::MPI_InitFinalize first.");
}
} // namespace

StaticState::StaticState(const Lattice& unloaded)
    : lattice(unloaded), loads(unloaded.n_nodes(), Eigen::Matrix<double, 6, 1>::Zero()),
      orientation(unloaded.n_nodes(), Eigen::Quaterniond::Identity())
{
  for (int i = 0; i < lattice.n_nodes(); ++i) position.push_back(lattice.reference_position(i));
}

std::array<Eigen::Vector3d, 2> StaticState::end_positions(int e) const
{
  const auto& node = lattice.element(e).node;
  return {position[node[0]], position[node[1]]};
}

std::array<Eigen::Quaterniond, 2> StaticState::end_orientations(int e) const
{
  const auto& node = lattice.element(e).node;
  return {orientation[node[0]], orientation[node[1]]};
}

StaticSolver::StaticSolver(const Lattice& lattice, const StaticOptions& options)
    : state_(lattice), options_(options)
{
}

void StaticSolver::clamp(const std::vector<int>& nodes)
{
  for (const int node : nodes)
    for (int c = 0; c < 6; ++c) prescribe(node, c, 0);
}

void StaticSolver::pin(const std::vector<int>& nodes)
{
  for (const int node : nodes)
    for (int c = 0; c < 3; ++c) prescribe(node, c, 0);
}

void StaticSolver::prescribe(int node, int component, double value)
{
  for (StaticState::Support& support : state_.supports)
    if (support.node == node && support.component == component) {
      support.value = value;
      return;
    }
  state_.supports.push_back({node, component, value});
}

void StaticSolver::add_load(int node, const Eigen::Vector3d& force, const Eigen::Vector3d& moment)
{
  state_.loads.at(node).head<3>() += force;
  state_.loads[node].tail<3>() += moment;
}

int StaticSolver::solve()
{
  require_petsc();
  int iterations = 0;
  for (int k = 1; k <= options_.load_steps; ++k) {
    LoadStep step(state_, options_, static_cast<double>(k) / options_.load_steps,
                  1. / options_.load_steps);
    iterations += step.solve();
    for (int i = 0; i < state_.lattice.n_nodes(); ++i) {
      state_.position[i] = state_.lattice.reference_position(i) + step.displacement(i);
      state_.orientation[i] =
          (rotation_exponential(step.turn(i)) * state_.orientation[i]).normalized();
    }
  }
  return iterations;
}

SectionForces StaticSolver::section_forces(int e) const
{
  return fem::section_forces(beam_constants(state_.lattice, e, options_.rbf),
                             state_.end_positions(e), state_.end_orientations(e));
}

double StaticSolver::strain_energy() const
{
  double sum = 0;
  for (int e = 0; e < state_.lattice.n_elements(); ++e) {
    const BeamConstants<double> beam = beam_constants(state_.lattice, e, options_.rbf);
    sum += fem::strain_energy(
        beam_strains(beam_ends(state_.end_positions(e), state_.end_orientations(e)), beam), beam);
  }
  for (int s = 0; s < state_.lattice.n_springs(); ++s) {
    const RotationalSpring& spring = state_.lattice.spring(s);
    sum += spring_energy(spring,
                         {state_.orientation[spring.node[0]], state_.orientation[spring.node[1]]});
  }
  return sum;
}

Eigen::Matrix<double, 6, 1> StaticSolver::reaction(int node) const
{
  const Lattice& lattice = state_.lattice;
  Eigen::Matrix<double, 6, 1> sum = Eigen::Matrix<double, 6, 1>::Zero();
  // Joined nodes take the force together, each its own moment.
  for (const int joined : lattice.joined_nodes(node)) {
    Eigen::Matrix<double, 6, 1> own = -state_.loads.at(joined);
    for (int e = 0; e < lattice.n_elements(); ++e)
      for (int v = 0; v < 2; ++v)
        if (lattice.element(e).node[v] == joined)
          own += beam_force(beam_constants(lattice, e, options_.rbf), state_.end_positions(e),
                            state_.end_orientations(e))
                     .segment<6>(6 * v);
    sum.head<3>() += own.head<3>();
    if (joined == node) sum.tail<3>() += own.tail<3>();
  }
  for (int s = 0; s < lattice.n_springs(); ++s) {
    const RotationalSpring& spring = lattice.spring(s);
    const Eigen::Vector3d moment = spring_moment(
        spring, {state_.orientation[spring.node[0]], state_.orientation[spring.node[1]]});
    if (spring.node[0] == node) sum.tail<3>() -= moment;
    if (spring.node[1] == node) sum.tail<3>() += moment;
  }
  return sum;
}
} // namespace interlock::fem
