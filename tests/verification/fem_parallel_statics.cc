// The static solver on all processes against itself on one. CTest runs it on 1, 2 and 4 processes.
// Fails when parts lose elements, freedoms or junctions between them, or when an iterative solver
// chosen by options does not work.
#include "fem/statics/static_solver.h"

#include "fem/lattice/lattice_mesh.h"
#include "fem/layouts/biaxial_layout.h"
#include "fem/statics/lattice_system.h"

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

#include <petscsys.h>

namespace
{
using namespace interlock::fem;
using Eigen::Vector3d;

// Three by three apertures of a geogrid of polypropylene, 0.2 m long.
Lattice geogrid()
{
  BiaxialLayout layout;
  layout.apertures_along = layout.apertures_across = 3;
  layout.pitch_along = layout.pitch_across = 0.065;
  layout.elements_per_rib = 4;
  layout.section_along = layout.section_across = {5e-3, 2.5e-3, 2.4e9, 0.4, 910};
  return Lattice(rib_lines(layout));
}

// Held at one edge, pulled at the other, and pushed out of its plane in the middle.
StaticSolver pulled(const Lattice& lattice, const StaticOptions& options)
{
  StaticSolver solver(lattice, options);
  solver.clamp(lattice.front_edge_nodes());
  for (int i = 0; i < lattice.n_nodes(); ++i)
    if (lattice.reference_position(i).x() > 0.194) solver.add_load(i, {5, 0, 0}, {0, 0, 0});
  solver.add_load(lattice.nearest_node({0.13, 0.03, 0}), {0, 0.5, 1}, {0, 0, 0.01});
  return solver;
}

StaticOptions on(MPI_Comm communicator)
{
  StaticOptions options;
  options.load_steps = 2;
  options.communicator = communicator;
  return options;
}

void expect_same(const StaticSolver& a, const StaticSolver& b, const Lattice& lattice)
{
  for (int i = 0; i < lattice.n_nodes(); ++i) {
    EXPECT_LT((a.position(i) - b.position(i)).norm(), 1e-9 * 0.2) << "node " << i;
    EXPECT_LT(a.orientation(i).angularDistance(b.orientation(i)), 1e-9 * 10) << "node " << i;
  }
}

TEST(ParallelStatics, EveryProcessHasItsPart)
{
  const Lattice lattice = geogrid();
  const StaticState state(lattice);
  const LatticeSystem system(state, true, MPI_COMM_WORLD);
  const auto ranks = dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  const auto mine = system.owned().n_elements();
  EXPECT_GT(mine, system.n_freedoms() / ranks / 2);
  EXPECT_LT(mine, 2 * system.n_freedoms() / ranks);
  EXPECT_TRUE(system.owned().is_contiguous());
  EXPECT_EQ(dealii::Utilities::MPI::sum(mine, MPI_COMM_WORLD), system.n_freedoms());
}

TEST(ParallelStatics, SameAnswerAsOnOneProcess)
{
  const Lattice lattice = geogrid();
  StaticSolver alone = pulled(lattice, on(MPI_COMM_SELF)),
               together = pulled(lattice, on(MPI_COMM_WORLD));
  alone.solve();
  together.solve();
  EXPECT_GT(alone.displacement(lattice.nearest_node({0.13, 0.0325, 0})).z(), 1e-3);
  expect_same(together, alone, lattice);
}

TEST(ParallelStatics, SamePathByArcLength)
{
  const Lattice lattice = geogrid();
  StaticSolver alone = pulled(lattice, on(MPI_COMM_SELF)),
               together = pulled(lattice, on(MPI_COMM_WORLD));
  ArcLengthOptions options;
  options.max_points = 4;
  const std::vector<PathPoint> one = alone.trace_path(options), all = together.trace_path(options);
  ASSERT_EQ(one.size(), all.size());
  for (std::size_t i = 0; i < one.size(); ++i)
    EXPECT_NEAR(all[i].load_factor, one[i].load_factor, 1e-8);
  expect_same(together, alone, lattice);
}

// Conjugate gradients take the tangent for symmetric, which it is but for the part that turns
// within one Newton step add; GMRES does not care.
TEST(ParallelStatics, IterativeSolversGiveTheSameAnswer)
{
  const Lattice lattice = geogrid();
  StaticSolver direct = pulled(lattice, on(MPI_COMM_WORLD));
  direct.solve();
  for (const auto& [ksp, pc] : {std::pair{"cg", "gamg"}, {"gmres", "hypre"}}) {
    PetscOptionsSetValue(nullptr, "-statics_ksp_type", ksp);
    PetscOptionsSetValue(nullptr, "-statics_pc_type", pc);
    StaticSolver iterative = pulled(lattice, on(MPI_COMM_WORLD));
    iterative.solve();
    PetscOptionsClearValue(nullptr, "-statics_ksp_type");
    PetscOptionsClearValue(nullptr, "-statics_pc_type");
    expect_same(iterative, direct, lattice);
  }
}

// Keeping a factorised tangent while it serves: fewer factorisations, the same answer.
TEST(ParallelStatics, ReusedFactorsGiveTheSameAnswer)
{
  const Lattice lattice = geogrid();
  StaticOptions options = on(MPI_COMM_WORLD);
  StaticSolver fresh = pulled(lattice, options);
  options.reuse = 0.3;
  StaticSolver reused = pulled(lattice, options);
  fresh.solve();
  reused.solve();
  EXPECT_LT(reused.factorisations(), fresh.factorisations());
  expect_same(reused, fresh, lattice);
}
} // namespace

int main(int argc, char** argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
