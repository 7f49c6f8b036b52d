#include "apps/mpi_start.h"

#include "dem/input_error.h"

#include <deal.II/base/mpi.h>

#include <cstdlib>
#include <memory>
#include <string>

namespace interlock::apps
{
namespace
{
std::unique_ptr<dealii::Utilities::MPI::MPI_InitFinalize> session;

// Tasks of an srun step that nobody tells of each other would all run the same case into the same
// folder.
void refuse_strangers()
{
  const char* tasks = std::getenv("SLURM_STEP_NUM_TASKS");
  const char* rank = std::getenv("SLURM_PROCID");
  if (!tasks || !rank || std::atoi(tasks) <= 1) return;
  throw InputError(std::atoi(rank) > 0
                       ? std::string()
                       : std::string("srun starts ") + tasks +
                             " tasks that know nothing of each other; start one with "
                             "\"srun -n 1\", or several with \"mpirun\" or \"srun "
                             "--mpi=pmix\".");
}

// Open MPI (4.1) makes a lone process a job of one rank. By default it starts a daemon for that,
// which looks for ssh, makes a folder in TMPDIR, and inside an srun step insists on Slurm's PMI.
void prepare_lone_process()
{
  refuse_strangers();
  setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
  setenv("OMPI_MCA_orte_create_session_dirs", "0", 0);
  unsetenv("SLURM_STEP_ID"); // what it takes for `started by srun`
}
} // namespace

bool started_by_launcher()
{
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK"})
    if (std::getenv(name)) return true;
  return false;
}

void start_mpi()
{
  if (session) return;
  int runs = 0;
  MPI_Initialized(&runs);
  if (runs)
    throw InputError(
        "Another module of this process has started MPI already, which interlock has to "
        "do itself: start it later, or (mpi4py) set mpi4py.rc.initialize = False.");
  if (!started_by_launcher()) prepare_lone_process();
  // Ghosts of two ranks on one machine are some 10 kB. From 4 kB on, Open MPI would first ask the
  // receiver, who is busy, and nothing would travel meanwhile (docs/theory/parallel.md).
  setenv("OMPI_MCA_btl_vader_eager_limit", "32768", 0);
  // No arguments: PETSc would answer --help and --version itself. One thread.
  int n = 1;
  std::string name = "interlock";
  char* words[] = {name.data(), nullptr};
  char** argv = words;
  session = std::make_unique<dealii::Utilities::MPI::MPI_InitFinalize>(n, argv, 1);
}

bool mpi_runs()
{
  return session != nullptr;
}

void stop_mpi()
{
  session.reset();
}
} // namespace interlock::apps
