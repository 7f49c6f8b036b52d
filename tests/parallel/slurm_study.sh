#!/usr/bin/env bash
# A study as job arrays under a real Slurm on this machine: the tables must be those of the same study on one job. One of
# the array's tasks is told to stop while it runs, as at its time limit; submitted again, the study goes on. Needs root and
#     apt-get install slurmctld slurmd slurm-client munge
#
#     tests/parallel/slurm_study.sh [PROGRAM]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
program=$(realpath "${1:-$here/../../build/release/bin/interlock}")
study=$here/../reliability/study.prm
folder=$(mktemp -d)
chmod 755 "$folder"
. "$here/start_slurm.sh"

# The end of all jobs, and how many tasks of arrays ended how.
wait_for_jobs()
{
  for _ in $(seq 1200); do [ -z "$(squeue -h)" ] && return; sleep 0.5; done
  echo 'The jobs did not end:' >&2; squeue >&2; exit 1
}

"$program" study "$study" -o "$folder/alone" >"$folder/alone.log" 2>&1 || [ $? -eq 3 ]
"$program" study "$study" -o "$folder/slurm" --slurm --jobs 2 >"$folder/slurm.log"
bash "$folder/slurm/slurm/submit.sh"
# The first state is being made: the signal that comes a minute before the time limit.
for _ in $(seq 600); do [ -e "$folder/slurm/states/filling-1/checkpoint.h5" ] && break; sleep 0.05; done
first=$(squeue -h -r -n states -o %i | head -n 1)
[ -z "$first" ] || scancel --signal=TERM --batch "$first"
wait_for_jobs
grep -h '' "$folder"/slurm/slurm/states_*.txt || true
bash "$folder/slurm/slurm/submit.sh"
wait_for_jobs
failed=0
for file in runs.csv means.csv differences.csv variance.csv curves.h5; do
  if cmp -s "$folder/alone/$file" "$folder/slurm/$file"; then
    echo "ok: $file: the same bytes from job arrays"
  else
    echo "FAILED: $file differs"; failed=1
  fi
done
[ "$failed" = 0 ] || tail -n 5 "$folder"/slurm/slurm/*.txt >&2
exit $failed
