#include "fem/statics/balance.h"

#include "fem/beam/beam_tangent.h"
#include "fem/statics/static_elements.h"

#include <algorithm>
#include <map>

namespace interlock::fem
{
std::vector<NodeLoad> unbalanced_forces(const StaticState& state, bool rbf,
                                        const std::vector<NodeLoad>& correction)
{
  std::vector<NodeLoad> forces;
  for (const NodeLoad& load : state.reached_loads) forces.push_back(-load);
  for (int e = 0; e < n_elements(state); ++e)
    with_element(state, rbf, e, [&](const auto& beam, const auto& nodes) {
      const auto force =
          beam_force(beam, at_nodes(state.position, nodes), at_nodes(state.orientation, nodes));
      for (std::size_t v = 0; v < nodes.size(); ++v)
        forces[nodes[v]] += force.template segment<6>(6 * v);
    });
  for (int s = 0; s < state.lattice.n_springs(); ++s) {
    const RotationalSpring& spring = state.lattice.spring(s);
    const Eigen::Vector3d moment = spring_moment(
        spring, {state.orientation[spring.node[0]], state.orientation[spring.node[1]]});
    forces[spring.node[0]].tail<3>() -= moment;
    forces[spring.node[1]].tail<3>() += moment;
  }
  for (std::size_t i = 0; i < correction.size(); ++i) forces[i] += correction[i];
  return forces;
}

Balance balance(const StaticState& state, bool rbf, const std::vector<NodeLoad>& correction)
{
  const Lattice& lattice = state.lattice;
  std::map<unsigned int, double> at_freedom; // joined nodes share their displacements
  const std::vector<NodeLoad> forces = unbalanced_forces(state, rbf, correction);
  for (int i = 0; i < lattice.n_nodes(); ++i)
    for (int c = 0; c < 6; ++c) at_freedom[lattice.dof(i, c)] += forces[i][c];
  std::vector<NodeLoad> acting = state.reached_loads;
  for (const StaticState::Support& support : state.supports) {
    double& reaction = at_freedom[lattice.dof(support.node, support.component)];
    acting[support.node][support.component] += reaction;
    reaction = 0; // once
  }
  const Eigen::AlignedBox3d box = lattice.box();
  const double size = box.diagonal().norm();
  Balance balance;
  Eigen::Vector3d force = Eigen::Vector3d::Zero(), moment = force;
  for (int i = 0; i < lattice.n_nodes(); ++i) {
    const Eigen::Vector3d own = acting[i].head<3>();
    force += own;
    moment += (state.position[i] - box.center()).cross(own) + acting[i].tail<3>();
    balance.scale += own.norm() + acting[i].tail<3>().norm() / size;
  }
  balance.error = std::max(force.norm(), moment.norm() / size);
  return balance;
}
} // namespace interlock::fem
