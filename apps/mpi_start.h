// MPI and PETSc, started where they are needed only: `--version`, `template`, `clump` and the like
// run wherever a program can be run.
#pragma once

namespace interlock::apps
{
// Whether a launcher (mpirun, srun with PMI) started this process as one of several ranks or of
// one. Looks at the environment, changes nothing.
bool started_by_launcher();

// Initialises MPI and PETSc on the first call; later calls do nothing. A process that no launcher
// started needs neither a daemon nor ssh, a folder for the session or Slurm's permission. Throws
// InputError when somebody else has initialised MPI, and when Slurm started several that know
// nothing of each other, on all but the first with an empty sentence: one of them speaks.
void start_mpi();
bool mpi_runs(); // between start_mpi and stop_mpi

// Ends what start_mpi() began. To be called before main() returns.
void stop_mpi();
} // namespace interlock::apps
