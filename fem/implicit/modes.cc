#include "fem/implicit/modes.h"

#include "fem/implicit/eigenvalues.h"
#include "fem/lattice/lumped_inertia.h"
#include "fem/statics/lattice_system.h"
#include "fem/statics/resting_supports.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace interlock::fem
{
namespace
{
using IsOwner = std::unique_ptr<IS, PetscDeleter<IS, ISDestroy>>;

IsOwner free_freedoms(const LatticeSystem& system)
{
  std::vector<PetscInt> free;
  for (const auto dof : system.owned())
    if (!system.constraints().is_constrained(dof)) free.push_back(static_cast<PetscInt>(dof));
  IS set = nullptr;
  check(ISCreateGeneral(system.communicator(), static_cast<PetscInt>(free.size()), free.data(),
                        PETSC_COPY_VALUES, &set));
  return IsOwner(set);
}

// Rows and columns of the free freedoms.
MatOwner free_part(Mat matrix, IS free)
{
  Mat part = nullptr;
  check(MatCreateSubMatrix(matrix, free, free, MAT_INITIAL_MATRIX, &part));
  return MatOwner(part);
}

MatOwner stiffness(LatticeSystem& system, IS free)
{
  system.tangent(system.present());
  MatOwner part = free_part(system.matrix(), free);
  Mat transposed = nullptr;
  check(MatTranspose(part.get(), MAT_INITIAL_MATRIX, &transposed));
  const MatOwner transposed_owner(transposed);
  check(MatAXPY(part.get(), 1, transposed, SAME_NONZERO_PATTERN));
  check(MatScale(part.get(), 0.5));
  return part;
}

// In the sparsity of the stiffness.
MatOwner mass(LatticeSystem& system, const StaticState& state, IS free)
{
  system.matrix() = 0;
  const std::vector<NodeInertia> nodes = lump_inertia(state.lattice, false);
  for (int i = 0; i < state.lattice.n_nodes(); ++i) {
    const Lattice& lattice = state.lattice;
    if (!system.owned().is_element(lattice.dof(i, 0))) continue;
    const Eigen::Matrix3d turn = state.orientation[i].toRotationMatrix();
    const Eigen::Matrix3d tensor = turn * nodes[i].tensor * turn.transpose();
    Eigen::Matrix<double, 6, 6> inertia = Eigen::Matrix<double, 6, 6>::Zero();
    inertia.topLeftCorner<3, 3>().diagonal().setConstant(nodes[i].mass);
    inertia.bottomRightCorner<3, 3>() = 0.5 * (tensor + tensor.transpose());
    for (int a = 0; a < 6; ++a)
      for (int b = 0; b < 6; ++b) {
        const unsigned int row = lattice.dof(i, a), column = lattice.dof(i, b);
        const bool is_free = !system.constraints().is_constrained(row) &&
                             !system.constraints().is_constrained(column);
        if (is_free && inertia(a, b) != 0) system.matrix().add(row, column, inertia(a, b));
      }
  }
  system.matrix().compress(dealii::VectorOperation::add);
  return free_part(system.matrix(), free);
}

// Free freedoms that have mass or rotary inertia: there are as many modes.
int n_with_inertia(Mat mass)
{
  Vec vec = nullptr;
  check(MatCreateVecs(mass, &vec, nullptr));
  const VecOwner diagonal(vec);
  check(MatGetDiagonal(mass, vec));
  PetscInt first = 0, end = 0;
  check(VecGetOwnershipRange(vec, &first, &end));
  const PetscScalar* values = nullptr;
  check(VecGetArrayRead(vec, &values));
  const auto mine = static_cast<int>(
      std::count_if(values, values + (end - first), [](PetscScalar value) { return value > 0; }));
  check(VecRestoreArrayRead(vec, &values));
  return dealii::Utilities::MPI::sum(mine, PetscObjectComm(reinterpret_cast<PetscObject>(mass)));
}

// Below zero, so that the shifted stiffness of an unsupported lattice can be inverted, by the
// square of a bending frequency of a beam as long as the lattice [rad2/s2].
double shift(const StaticState& state)
{
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& x : state.position) box.extend(x);
  double softest = 1e300, heaviest = 0;
  for (int e = 0; e < state.lattice.n_elements(); ++e) {
    const BeamSection& section = state.lattice.section(e);
    softest = std::min({softest, section.bending_2, section.bending_3});
    heaviest = std::max(heaviest, section.line_density);
  }
  return -std::pow(M_PI / box.diagonal().norm(), 4) * softest / heaviest;
}

// A distributed vector of the free freedoms, and what it says of the nodes.
class ShapeReader
{
public:
  ShapeReader(const Lattice& lattice, const LatticeSystem& system, Mat stiffness)
      : lattice_(lattice), all_(system.n_freedoms())
  {
    for (unsigned int dof = 0; dof < system.n_freedoms(); ++dof)
      if (!system.constraints().is_constrained(dof)) free_.push_back(dof);
    Vec vec = nullptr, everywhere = nullptr;
    VecScatter scatter = nullptr;
    check(MatCreateVecs(stiffness, &vec, nullptr));
    vector_.reset(vec);
    check(VecScatterCreateToAll(vec, &scatter, &everywhere));
    scatter_.reset(scatter);
    everywhere_.reset(everywhere);
  }

  Vec vector() const { return vector_.get(); }

  std::vector<Eigen::Matrix<double, 6, 1>> shape()
  {
    Vec all = everywhere_.get();
    check(VecScatterBegin(scatter_.get(), vector(), all, INSERT_VALUES, SCATTER_FORWARD));
    check(VecScatterEnd(scatter_.get(), vector(), all, INSERT_VALUES, SCATTER_FORWARD));
    const PetscScalar* values = nullptr;
    check(VecGetArrayRead(all, &values));
    for (std::size_t i = 0; i < free_.size(); ++i) all_[free_[i]] = values[i];
    check(VecRestoreArrayRead(all, &values));
    std::vector<Eigen::Matrix<double, 6, 1>> shape(lattice_.n_nodes());
    for (int i = 0; i < lattice_.n_nodes(); ++i)
      for (int c = 0; c < 6; ++c) shape[i][c] = all_[lattice_.dof(i, c)];
    return shape;
  }

private:
  const Lattice& lattice_;
  std::vector<unsigned int> free_;
  std::vector<double> all_; // zero at the supports
  VecOwner vector_, everywhere_;
  ScatterOwner scatter_;
};
} // namespace

int n_free_freedoms(const StaticState& state, MPI_Comm communicator)
{
  LatticeSystem system(state, true, communicator);
  system.set_supports(resting_supports(state));
  PetscInt size = 0;
  check(ISGetSize(free_freedoms(system).get(), &size));
  return static_cast<int>(size);
}

std::vector<NaturalMode> natural_modes(const StaticState& state, int count, bool rbf,
                                       MPI_Comm communicator)
{
  LatticeSystem system(state, rbf, communicator);
  system.set_supports(resting_supports(state));
  const IsOwner free = free_freedoms(system);
  const MatOwner k = stiffness(system, free.get()), m = mass(system, state, free.get());
  const int size = n_with_inertia(m.get());
  if (count < 1 || count > size)
    throw std::invalid_argument("The number of natural modes is " + std::to_string(count) +
                                " but must be between 1 and " + std::to_string(size) +
                                ", the number of free freedoms with mass or rotary inertia.");
  const LowestEigenvalues lowest(k.get(), m.get(), count, shift(state));

  ShapeReader reader(state.lattice, system, k.get());
  std::vector<NaturalMode> modes;
  const double rounding = 1e-6 * std::abs(shift(state));
  for (int i = 0; i < count; ++i) {
    double square = lowest.values()[i];          // (2 pi f)^2
    if (std::abs(square) < rounding) square = 0; // a rigid motion
    lowest.vector(i, reader.vector());
    modes.push_back(
        {std::copysign(std::sqrt(std::abs(square)), square) / (2 * M_PI), reader.shape()});
  }
  return modes;
}
} // namespace interlock::fem
