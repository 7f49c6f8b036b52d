#include "fem/statics/last_correction.h"

#include "fem/beam/beam_tangent.h"
#include "fem/statics/lattice_system.h"
#include "fem/statics/resting_supports.h"
#include "fem/statics/static_elements.h"

#include <algorithm>
#include <cmath>

namespace interlock::fem
{
namespace
{
// K^-1 of minus what is unbalanced, on every process; empty where K is singular.
dealii::Vector<double> newton_step(LatticeSystem& system, const StaticState& state)
{
  system.set_supports(resting_supports(state));
  auto right = system.new_vector(), step = system.new_vector();
  const dealii::Vector<double> present = system.present();
  system.internal_forces(present, right);
  system.add_loads(state.reached_loads, -1, right);
  right.compress(dealii::VectorOperation::add);
  right *= -1;
  system.tangent(present);
  KSP ksp = nullptr;
  check(KSPCreate(system.communicator(), &ksp));
  const KspOwner owner(ksp);
  check(KSPSetOptionsPrefix(ksp, statics_prefix));
  check(KSPSetOperators(ksp, system.matrix(), system.matrix()));
  use_direct_solver(ksp);
  check(KSPSetFromOptions(ksp));
  KSPConvergedReason reason = KSP_DIVERGED_NULL;
  {
    const QuietPetsc quiet;
    if (KSPSolve(ksp, right, step) != 0) return {};
  }
  check(KSPGetConvergedReason(ksp, &reason));
  if (reason <= 0 || !std::isfinite(step.l2_norm())) return {};
  return system.gathered(step);
}
} // namespace

LastCorrection last_correction(LatticeSystem& system, const StaticState& state, bool rbf)
{
  const dealii::Vector<double> step = newton_step(system, state);
  LastCorrection correction;
  if (step.size() == 0) return correction;
  const auto at = [&](int node, int first) {
    const unsigned int dof = state.lattice.dof(node, first);
    return Eigen::Vector3d(step[dof], step[dof + 1], step[dof + 2]);
  };
  for (int i = 0; i < state.lattice.n_nodes(); ++i)
    correction.displacement = std::max(correction.displacement, at(i, 0).norm());
  correction.forces.assign(state.lattice.n_nodes(), NodeLoad::Zero());
  for (int e = 0; e < n_elements(state); ++e)
    with_element(state, rbf, e, [&](const auto& beam, const auto& nodes) {
      auto turn = at_nodes(state.position, nodes);
      std::fill(turn.begin(), turn.end(), Eigen::Vector3d::Zero());
      const auto tangent = beam_tangent(beam, at_nodes(state.position, nodes),
                                        at_nodes(state.orientation, nodes), turn);
      auto motion = tangent.force;
      for (std::size_t v = 0; v < nodes.size(); ++v)
        motion.template segment<6>(6 * v) << at(nodes[v], 0), at(nodes[v], 3);
      const decltype(motion) change = tangent.stiffness * motion;
      for (std::size_t v = 0; v < nodes.size(); ++v)
        correction.forces[nodes[v]] += change.template segment<6>(6 * v);
    });
  for (int s = 0; s < state.lattice.n_springs(); ++s) {
    const RotationalSpring& spring = state.lattice.spring(s);
    const auto zero = Eigen::Vector3d::Zero();
    const SpringTangent tangent = spring_tangent(
        spring, {state.orientation[spring.node[0]], state.orientation[spring.node[1]]},
        {zero, zero});
    NodeLoad turns;
    turns << at(spring.node[0], 3), at(spring.node[1], 3);
    const NodeLoad change = tangent.stiffness * turns;
    for (const int v : {0, 1})
      correction.forces[spring.node[v]].tail<3>() += change.segment<3>(3 * v);
  }
  return correction;
}
} // namespace interlock::fem
