// Residual and tangent of a lattice, assembled on all processes of a communicator.
#pragma once

#include "fem/statics/petsc_objects.h"
#include "fem/statics/static_state.h"

#include <deal.II/base/index_set.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/petsc_sparse_matrix.h>
#include <deal.II/lac/petsc_vector.h>
#include <deal.II/lac/vector.h>

#include <vector>

namespace interlock::fem
{
// Freedoms in deal.II's numbering, first those of the first part of the mesh and so on; six a node,
// see Lattice::dof: displacement from the unloaded state [m], rotation vector on top of the state's
// orientation [rad], world frame. Each process assembles the elements of its part and the springs
// of its junctions, and owns the rows of its freedoms; vectors called x hold all freedoms on every
// process.
class LatticeSystem
{
public:
  // `state` gives the lattice and the orientations at the start of the step; it must outlive this
  // object and may advance between two calls. `rbf`: residual bending flexibility, see
  // StaticOptions. All processes of `communicator` must call, here and below.
  LatticeSystem(const StaticState& state, bool rbf, MPI_Comm communicator);

  // From now on these freedoms are prescribed, besides the ties of the junctions: displacements by
  // their value from the unloaded state, rotations by their turn in this step. A new set of
  // freedoms makes a new matrix; new values alone do not.
  void set_supports(const std::vector<StaticState::Support>& supports);
  const dealii::AffineConstraints<double>& constraints() const { return constraints_; } // closed

  MPI_Comm communicator() const { return communicator_; }
  unsigned int n_freedoms() const { return owned_.size(); }
  const dealii::IndexSet& owned() const { return owned_; } // of this process, contiguous
  dealii::PETScWrappers::MPI::SparseMatrix& matrix() { return matrix_; }
  // A vector that fits the matrix, zero.
  dealii::PETScWrappers::MPI::Vector new_vector() const
  {
    return dealii::PETScWrappers::MPI::Vector(owned_, communicator_);
  }

  // Adds the gradient of the strain energy by displacement and spin [N, N m] to `sum`, constraints
  // condensed; `sum` is not compressed yet. x obeys the constraints.
  void internal_forces(const dealii::Vector<double>& x,
                       dealii::PETScWrappers::MPI::Vector& sum) const;
  // Adds `factor` times nodal loads in the same way; prescribed freedoms stay zero.
  void add_loads(const std::vector<NodeLoad>& loads, double factor,
                 dealii::PETScWrappers::MPI::Vector& sum) const;
  // Fills the matrix with the derivative of the internal forces at x; rows and columns of
  // constrained freedoms are those of the identity.
  void tangent(const dealii::Vector<double>& x);
  int n_tangents() const { return n_tangents_; } // computed so far

  // A distributed vector on every process, as it is, and with its constrained freedoms set.
  dealii::Vector<double> gathered(Vec x) const;
  dealii::Vector<double> everywhere(Vec x) const;
  // The state's freedoms, constraints set: its displacements and no turn.
  dealii::Vector<double> present() const;

private:
  void make_matrix();
  void set_rigid_body_modes();
  template <std::size_t n> std::vector<unsigned int> dofs_of(const std::array<int, n>& nodes) const;

  const StaticState& state_;
  const bool rbf_;
  const MPI_Comm communicator_;
  dealii::IndexSet owned_;
  std::vector<int> elements_, springs_; // of this process
  std::vector<unsigned int> prescribed_;
  dealii::AffineConstraints<double> constraints_;
  dealii::PETScWrappers::MPI::SparseMatrix matrix_;
  int n_tangents_ = 0;
  ScatterOwner to_all_;
  VecOwner all_;
};
} // namespace interlock::fem
