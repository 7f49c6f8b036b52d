#include "fem/statics/static_state.h"

#include "fem/beam/beam_tangent.h"
#include "fem/beam/section_forces.h"
#include "fem/lattice/beam_constants.h"

#include <deal.II/lac/vector.h>

#include <Eigen/Eigenvalues>

#include <map>
#include <numeric>
#include <stdexcept>

namespace interlock::fem
{
namespace
{
// Up to ten sizes away the lost digit does not count.
Eigen::Vector3d origin_of(const Lattice& lattice)
{
  const Eigen::AlignedBox3d box = lattice.box();
  const Eigen::Vector3d middle = box.center();
  return middle.norm() > 10 * box.diagonal().norm() ? middle : Eigen::Vector3d::Zero();
}
} // namespace

StaticState::StaticState(const Lattice& unloaded)
    : origin(origin_of(unloaded)), lattice(unloaded.about(origin)),
      loads(unloaded.n_nodes(), NodeLoad::Zero()), reached_loads(loads),
      orientation(unloaded.n_nodes(), Eigen::Quaterniond::Identity()),
      plastic_stretch(unloaded.n_elements(), 0.)
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

void StaticState::advance(const dealii::Vector<double>& freedoms)
{
  for (int i = 0; i < lattice.n_nodes(); ++i) {
    Eigen::Vector3d displacement, turn;
    for (int c = 0; c < 3; ++c) {
      displacement[c] = freedoms[lattice.dof(i, c)];
      turn[c] = freedoms[lattice.dof(i, 3 + c)];
    }
    position[i] = lattice.reference_position(i) + displacement;
    orientation[i] = (rotation_exponential(turn) * orientation[i]).normalized();
  }
}

void StaticState::commit_plastic_stretch(bool rbf)
{
  for (int e = 0; e < lattice.n_elements(); ++e) {
    const BeamConstants<double> beam = beam_constants(lattice, e, rbf, plastic_stretch[e]);
    plastic_stretch[e] = fem::plastic_stretch(
        beam_strains(beam_ends(end_positions(e), end_orientations(e)), beam), beam);
  }
}

namespace
{
// For each node, a node that stands for everything it hangs together with.
std::vector<int> connected_pieces(const Lattice& lattice)
{
  std::vector<int> piece(lattice.n_nodes());
  std::iota(piece.begin(), piece.end(), 0);
  const auto root = [&](int i) {
    while (piece[i] != i) i = piece[i] = piece[piece[i]];
    return i;
  };
  for (int e = 0; e < lattice.n_elements(); ++e) {
    const auto& node = lattice.element(e).node;
    piece[root(node[1])] = root(node[0]);
  }
  for (int s = 0; s < lattice.n_springs(); ++s) {
    const auto& node = lattice.spring(s).node;
    piece[root(node[1])] = root(node[0]);
  }
  for (int i = 0; i < lattice.n_nodes(); ++i) piece[i] = root(i);
  return piece;
}

// Motion of one freedom of a node under the six rigid motions of its piece: three translations, and
// three rotations about `centre` that move a point at the distance `size` by 1.
Eigen::Matrix<double, 6, 1> rigid_motion(int component, const Eigen::Vector3d& position,
                                         const Eigen::Vector3d& centre, double size)
{
  Eigen::Matrix<double, 6, 1> row = Eigen::Matrix<double, 6, 1>::Zero();
  if (component >= 3) {
    row[component] = 1;
    return row;
  }
  row[component] = 1;
  for (int axis = 0; axis < 3; ++axis)
    row[3 + axis] = Eigen::Vector3d::Unit(axis).cross((position - centre) / size)[component];
  return row;
}

struct Piece {
  Eigen::AlignedBox3d box;
  Eigen::Matrix<double, 6, 6> held = Eigen::Matrix<double, 6, 6>::Zero();
};
} // namespace

void require_held(const StaticState& state)
{
  const std::vector<int> piece_of = connected_pieces(state.lattice);
  std::map<int, Piece> pieces;
  for (int i = 0; i < state.lattice.n_nodes(); ++i)
    pieces[piece_of[i]].box.extend(state.position[i]);
  for (const StaticState::Support& support : state.supports) {
    Piece& piece = pieces[piece_of[support.node]];
    const auto row = rigid_motion(support.component, state.position[support.node],
                                  piece.box.center(), piece.box.diagonal().norm());
    piece.held += row * row.transpose();
  }
  for (const auto& [first_node, piece] : pieces) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> motions(
        piece.held, Eigen::EigenvaluesOnly);
    // Squares: supports whose levers are a millionth of the lattice's size do not hold it.
    if (!(motions.eigenvalues()[0] > 1e-12))
      throw std::runtime_error(
          "The lattice is not held: it can move as a rigid body or a mechanism.");
  }
}
} // namespace interlock::fem
