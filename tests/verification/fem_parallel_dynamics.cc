// Modes and implicit steps of a geogrid on all processes against the same on one: frequencies and
// motion must agree to rounding. Runs on one process and, by mpirun, on several. Fails when
// inertia, loads or supports are assembled twice or not at all where parts of the mesh meet.
#include "fem/implicit/implicit_dynamics.h"
#include "fem/implicit/modes.h"
#include "fem/layouts/biaxial_layout.h"

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

namespace
{
using namespace interlock::fem;

StaticState clamped_geogrid()
{
  BiaxialLayout layout;
  layout.apertures_along = layout.apertures_across = 2;
  layout.pitch_along = layout.pitch_across = 0.065;
  layout.elements_per_rib = 4;
  layout.section_along = layout.section_across = {5e-3, 2.5e-3, 2.4e9, 0.3, 910};
  StaticState state{Lattice(rib_lines(layout))};
  for (const int node : state.lattice.front_edge_nodes())
    for (int c = 0; c < 6; ++c) state.supports.push_back({node, c, 0.});
  return state;
}

TEST(ParallelDynamics, SameModes)
{
  const StaticState state = clamped_geogrid();
  const auto shared = natural_modes(state, 8, true, MPI_COMM_WORLD),
             alone = natural_modes(state, 8, true, MPI_COMM_SELF);
  for (int i = 0; i < 8; ++i) {
    EXPECT_NEAR(shared[i].frequency, alone[i].frequency, 1e-8 * alone[i].frequency);
    const double sign = shared[i].shape.back().dot(alone[i].shape.back()) > 0 ? 1 : -1;
    for (std::size_t node = 0; node < alone[i].shape.size(); ++node)
      EXPECT_LT((shared[i].shape[node] - sign * alone[i].shape[node]).norm(),
                1e-5 * alone[i].shape.back().norm());
  }
}

TEST(ParallelDynamics, SameMotion)
{
  const StaticState state = clamped_geogrid();
  const int far = state.lattice.nearest_node({0.13, 0.065, 0});
  ImplicitDynamics shared(state, {}, MPI_COMM_WORLD), alone(state, {}, MPI_COMM_SELF);
  for (ImplicitDynamics* dynamics : {&shared, &alone}) {
    dynamics->set_loads(
        [far](double t, ImplicitDynamics::Loads& loads) { loads[far][2] += 20 * t; });
    for (const int node : state.lattice.front_edge_nodes())
      dynamics->prescribe(node, 0, [](double t) { return -0.5 * t * t; });
    for (int i = 0; i < 10; ++i) dynamics->step(5e-3);
  }
  ASSERT_GT(alone.position(far).z(), 5e-3);
  for (int i = 0; i < state.lattice.n_nodes(); ++i)
    EXPECT_LT((shared.position(i) - alone.position(i)).norm(), 1e-10);
  const double work = alone.energies().load_work;
  EXPECT_NEAR(shared.energies().ledger(), alone.energies().ledger(), 1e-7 * work);
}
} // namespace

int main(int argc, char** argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
