// A study as job arrays of Slurm.
#pragma once

#include "apps/study/outlook.h"

namespace interlock::apps
{
// Writes into the study's folder slurm/states.sh (an array with one task for each packed state),
// slurm/runs.sh (one for each run, after all states), slurm/collect.sh (the results, after all
// runs) and slurm/submit.sh, which submits them. A task does the run of its number in the plan
// (`interlock study FILE --task K`), so that a script that is submitted again goes on. `at_once`:
// how many tasks of an array may run at a time; 0: any number. Returns submit.sh.
std::filesystem::path write_slurm_scripts(const Plan& plan, const Outlook& outlook, int at_once);
} // namespace interlock::apps
