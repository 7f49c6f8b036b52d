// What a user says about the solution of static equilibrium.
#pragma once

#include <mpi.h>

namespace interlock::fem
{
struct StaticOptions {
  bool rbf = true; // residual bending flexibility in the shear stiffness; not for order 2
  int order = 1;   // 1: two-node elements; 2: quadratic ones, two consecutive elements of a line
                   // each (elastic ribs with an even number of segments)
  int load_steps = 10;     // loads and prescribed motion grow in equal steps
  int max_iterations = 30; // Newton iterations in one load step; one that needs more is halved
  double step_tolerance = 1e-10; // a load step ends when the Newton step [m, rad] is shorter, or
                                 // when rounding is all that is left
  double reuse = 0; // a factorised tangent is kept while each Newton step is shorter than this
                    // share of the one before (some 0.1); 0: a new one in every iteration
  double longest_turn = 1; // a load step that turns a node by more [rad] may have jumped to another
                           // branch: it is halved, up to six times
  bool stable_branch = false; // look at the stability of each load step's equilibrium, and halve a
                              // step that leads to an unstable one, up to six times:
                              // StaticSolver::unstable_directions
  double largest_imbalance = 1e-8; // share of the forces; with more left between reactions and
                                   // loads a solution is refused
  MPI_Comm communicator = MPI_COMM_WORLD; // processes that share the work
};
} // namespace interlock::fem
