#include "fem/statics/lattice_system.h"

#include "fem/beam/beam_tangent.h"
#include "fem/lattice/lattice_mesh.h"
#include "fem/statics/static_elements.h"

#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>

#include <algorithm>

namespace interlock::fem
{
namespace
{
Eigen::Vector3d triple_at(const dealii::Vector<double>& x, unsigned int dof)
{
  return {x[dof], x[dof + 1], x[dof + 2]};
}

// Of the nodes of an element at the freedoms x.
template <std::size_t n> struct ElementMotion {
  std::array<Eigen::Vector3d, n> position, turn;
  std::array<Eigen::Quaterniond, n> start, now; // orientation without and with `turn`
};

template <std::size_t n>
ElementMotion<n> element_motion(const StaticState& state, const std::array<int, n>& nodes,
                                const dealii::Vector<double>& x)
{
  ElementMotion<n> motion;
  motion.start = at_nodes(state.orientation, nodes);
  for (std::size_t v = 0; v < n; ++v) {
    motion.position[v] =
        state.lattice.reference_position(nodes[v]) + triple_at(x, state.lattice.dof(nodes[v], 0));
    motion.turn[v] = triple_at(x, state.lattice.dof(nodes[v], 3));
    motion.now[v] = rotation_exponential(motion.turn[v]) * motion.start[v];
  }
  return motion;
}

std::array<Eigen::Quaterniond, 2> spring_orientations(const StaticState& state,
                                                      const RotationalSpring& spring)
{
  return {state.orientation[spring.node[0]], state.orientation[spring.node[1]]};
}

std::array<Eigen::Vector3d, 2> spring_turns(const Lattice& lattice, const RotationalSpring& spring,
                                            const dealii::Vector<double>& x)
{
  return {triple_at(x, lattice.dof(spring.node[0], 3)),
          triple_at(x, lattice.dof(spring.node[1], 3))};
}

// Rotations of both nodes.
std::vector<unsigned int> spring_dofs(const Lattice& lattice, const RotationalSpring& spring)
{
  std::vector<unsigned int> dofs;
  for (const int node : spring.node)
    for (int c = 3; c < 6; ++c) dofs.push_back(lattice.dof(node, c));
  return dofs;
}
} // namespace

LatticeSystem::LatticeSystem(const StaticState& state, bool rbf, MPI_Comm communicator)
    : state_(state), rbf_(rbf), communicator_(communicator),
      owned_(state.lattice.mesh().dof_handler().n_dofs())
{
  const LatticeMesh& mesh = state.lattice.mesh();
  const int rank = static_cast<int>(dealii::Utilities::MPI::this_mpi_process(communicator));
  const int ranks = static_cast<int>(dealii::Utilities::MPI::n_mpi_processes(communicator));
  // Parts are cut for all processes; fewer take several consecutive parts each.
  const auto is_mine = [&](int part) { return part * ranks / mesh.n_parts() == rank; };
  for (int part = 0; part < mesh.n_parts(); ++part)
    if (is_mine(part)) owned_.add_indices(mesh.freedoms_of_part(part));
  owned_.compress();
  // A quadratic element belongs to the process of its first half.
  const int cells_per_element = state.pairs.empty() ? 1 : 2;
  int cells = 0;
  for (const auto& cell : mesh.dof_handler().active_cell_iterators()) {
    if (cells % cells_per_element == 0 && is_mine(static_cast<int>(cell->subdomain_id())))
      elements_.push_back(cells / cells_per_element);
    ++cells;
  }
  for (int s = 0; s < state.lattice.n_springs(); ++s)
    if (owned_.is_element(state.lattice.dof(state.lattice.spring(s).node[0], 3)))
      springs_.push_back(s);

  VecScatter scatter = nullptr;
  Vec all = nullptr;
  check(VecScatterCreateToAll(new_vector(), &scatter, &all));
  to_all_.reset(scatter);
  all_.reset(all);
  set_supports({});
}

void LatticeSystem::set_supports(const std::vector<StaticState::Support>& supports)
{
  constraints_.clear();
  std::vector<unsigned int> prescribed;
  for (const StaticState::Support& support : supports) {
    const unsigned int dof = state_.lattice.dof(support.node, support.component);
    prescribed.push_back(dof);
    constraints_.add_line(dof);
    constraints_.set_inhomogeneity(dof, support.value);
  }
  constraints_.merge(state_.lattice.mesh().junction_ties());
  constraints_.close();
  if (matrix_.m() == 0 || prescribed != prescribed_) {
    prescribed_ = prescribed;
    make_matrix();
  }
}

void LatticeSystem::make_matrix()
{
  const dealii::DoFHandler<1, 3>& dof_handler = state_.lattice.mesh().dof_handler();
  dealii::DynamicSparsityPattern sparsity(dof_handler.n_dofs());
  dealii::DoFTools::make_sparsity_pattern(dof_handler, sparsity, constraints_, false);
  for (int s = 0; s < state_.lattice.n_springs(); ++s)
    constraints_.add_entries_local_to_global(spring_dofs(state_.lattice, state_.lattice.spring(s)),
                                             sparsity, false);
  for (const QuadraticPair& pair : state_.pairs) // the ends of a pair share no cell
    constraints_.add_entries_local_to_global(dofs_of(pair.node), sparsity, false);
  matrix_.reinit(owned_, owned_, sparsity, communicator_);
  set_rigid_body_modes();
}

// For algebraic multigrid: it coarsens well when it knows the motions that strain nothing.
void LatticeSystem::set_rigid_body_modes()
{
  std::array<dealii::PETScWrappers::MPI::Vector, 6> modes;
  for (auto& mode : modes) mode = new_vector();
  for (int i = 0; i < state_.lattice.n_nodes(); ++i) {
    const auto put = [&](int mode, int component, double value) {
      const unsigned int dof = state_.lattice.dof(i, component);
      if (owned_.is_element(dof) && !constraints_.is_constrained(dof)) modes[mode](dof) = value;
    };
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d swing = Eigen::Vector3d::Unit(axis).cross(state_.position[i]);
      put(axis, axis, 1);
      put(3 + axis, 3 + axis, 1);
      for (int c = 0; c < 3; ++c) put(3 + axis, c, swing[c]);
    }
  }
  std::array<Vec, 6> handles{};
  for (int a = 0; a < 6; ++a) {
    modes[a].compress(dealii::VectorOperation::insert);
    for (int b = 0; b < a; ++b) modes[a].add(-(modes[a] * modes[b]), modes[b]);
    const double norm = modes[a].l2_norm();
    if (norm > 0) modes[a] /= norm;
    handles[a] = modes[a];
  }
  const bool independent = std::all_of(modes.begin(), modes.end(),
                                       [](const auto& mode) { return mode.l2_norm() > 0.5; });
  if (!independent) return;
  MatNullSpace rigid = nullptr;
  check(MatNullSpaceCreate(communicator_, PETSC_FALSE, 6, handles.data(), &rigid));
  check(MatSetBlockSize(matrix_, 6));
  check(MatSetNearNullSpace(matrix_, rigid));
  check(MatNullSpaceDestroy(&rigid));
}

// Freedoms of the nodes, so those that junctions tie others to.
template <std::size_t n>
std::vector<unsigned int> LatticeSystem::dofs_of(const std::array<int, n>& nodes) const
{
  std::vector<unsigned int> dofs;
  for (const int node : nodes)
    for (unsigned int c = 0; c < 6; ++c) dofs.push_back(state_.lattice.dof(node, c));
  return dofs;
}

void LatticeSystem::internal_forces(const dealii::Vector<double>& x,
                                    dealii::PETScWrappers::MPI::Vector& sum) const
{
  for (const int e : elements_)
    with_element(state_, rbf_, e, [&](const auto& beam, const auto& nodes) {
      const auto motion = element_motion(state_, nodes, x);
      const auto force = beam_force(beam, motion.position, motion.now);
      const dealii::Vector<double> local(force.begin(), force.end());
      constraints_.distribute_local_to_global(local, dofs_of(nodes), sum);
    });
  dealii::Vector<double> local(6);
  for (const int s : springs_) {
    const RotationalSpring& spring = state_.lattice.spring(s);
    const Eigen::Matrix<double, 6, 1> moment =
        spring_tangent(spring, spring_orientations(state_, spring),
                       spring_turns(state_.lattice, spring, x))
            .moment;
    std::copy(moment.begin(), moment.end(), local.begin());
    constraints_.distribute_local_to_global(local, spring_dofs(state_.lattice, spring), sum);
  }
}

void LatticeSystem::add_loads(const std::vector<NodeLoad>& loads, double factor,
                              dealii::PETScWrappers::MPI::Vector& sum) const
{
  for (int i = 0; i < state_.lattice.n_nodes(); ++i)
    for (int c = 0; c < 6; ++c) {
      const unsigned int dof = state_.lattice.dof(i, c);
      if (owned_.is_element(dof) && !constraints_.is_constrained(dof))
        sum(dof) += factor * loads[i][c];
    }
}

void LatticeSystem::tangent(const dealii::Vector<double>& x)
{
  matrix_ = 0;
  for (const int e : elements_)
    with_element(state_, rbf_, e, [&](const auto& beam, const auto& nodes) {
      const auto motion = element_motion(state_, nodes, x);
      const auto stiffness =
          beam_tangent(beam, motion.position, motion.start, motion.turn).stiffness;
      dealii::FullMatrix<double> local(stiffness.rows(), stiffness.cols());
      for (int i = 0; i < stiffness.rows(); ++i)
        for (int j = 0; j < stiffness.cols(); ++j) local(i, j) = stiffness(i, j);
      constraints_.distribute_local_to_global(local, dofs_of(nodes), matrix_);
    });
  dealii::FullMatrix<double> local(6, 6);
  for (const int s : springs_) {
    const RotationalSpring& spring = state_.lattice.spring(s);
    const SpringTangent tangent = spring_tangent(spring, spring_orientations(state_, spring),
                                                 spring_turns(state_.lattice, spring, x));
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j) local(i, j) = tangent.stiffness(i, j);
    constraints_.distribute_local_to_global(local, spring_dofs(state_.lattice, spring), matrix_);
  }
  matrix_.compress(dealii::VectorOperation::add);
  for (const auto dof : owned_)
    if (constraints_.is_constrained(dof)) matrix_.set(dof, dof, 1.);
  matrix_.compress(dealii::VectorOperation::insert);
  ++n_tangents_;
}

dealii::Vector<double> LatticeSystem::gathered(Vec x) const
{
  check(VecScatterBegin(to_all_.get(), x, all_.get(), INSERT_VALUES, SCATTER_FORWARD));
  check(VecScatterEnd(to_all_.get(), x, all_.get(), INSERT_VALUES, SCATTER_FORWARD));
  const PetscScalar* values = nullptr;
  check(VecGetArrayRead(all_.get(), &values));
  dealii::Vector<double> copy(values, values + n_freedoms());
  check(VecRestoreArrayRead(all_.get(), &values));
  return copy;
}

dealii::Vector<double> LatticeSystem::everywhere(Vec x) const
{
  dealii::Vector<double> copy = gathered(x);
  constraints_.distribute(copy);
  return copy;
}

dealii::Vector<double> LatticeSystem::present() const
{
  dealii::Vector<double> x(n_freedoms());
  const Lattice& lattice = state_.lattice;
  for (int i = 0; i < lattice.n_nodes(); ++i)
    for (int c = 0; c < 3; ++c)
      x[lattice.dof(i, c)] = (state_.position[i] - lattice.reference_position(i))[c];
  constraints_.distribute(x);
  return x;
}
} // namespace interlock::fem
