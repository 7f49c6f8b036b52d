#!/usr/bin/env bash
# Runs a small pull-out under a real Slurm on this machine: as a step of srun (PMIx), by mpirun inside an allocation, and
# alone. All must write the same state hash; a bad input must be refused by one sentence with exit code 2. Needs root and
#     apt-get install slurmctld slurmd slurm-client munge
#
#     tests/parallel/slurm.sh [PROGRAM]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
program=$(realpath "${1:-$here/../../build/release/bin/interlock}")
case_file=$here/../reliability/small.prm
folder=$(mktemp -d)
chmod 755 "$folder"
. "$here/start_slurm.sh"

arguments=(run "$case_file" --set Output/Report=false --output)
hash_of() { python3 -c "import json, sys; print(json.load(open(sys.argv[1] + '/summary.json'))['state_hash'])" "$1"; }
"$program" "${arguments[@]}" "$folder/alone" >/dev/null
alone=$(hash_of "$folder/alone")
failed=0
check() { # name, folder
  local hash
  hash=$(hash_of "$2")
  if [ "$hash" == "$alone" ]; then echo "ok: $1: $hash"; else echo "FAILED: $1: $hash, alone $alone"; failed=1; fi
}
if srun --mpi=list 2>&1 | grep -q pmix; then
  srun --mpi=pmix -n 2 "$program" "${arguments[@]}" "$folder/srun" >"$folder/srun.log" 2>&1 || { cat "$folder/srun.log" >&2; exit 1; }
  check 'srun -n 2 --mpi=pmix' "$folder/srun"
  code=0
  srun --mpi=pmix -n 2 "$program" run "$case_file" --set Box/Length=-1 --output "$folder/bad" >"$folder/bad.log" 2>&1 || code=$?
  sentences=$(grep -c 'Box/Length' "$folder/bad.log" || true)
  if [ "$code" == 2 ] && [ "$sentences" == 1 ] && [ ! -e "$folder/bad" ]; then
    echo 'ok: a bad input: one sentence, exit code 2'
  else
    echo "FAILED: a bad input: exit code $code, $sentences sentences"; cat "$folder/bad.log"; failed=1
  fi
else
  echo 'not tried: srun --mpi=pmix (this Slurm has no PMIx plugin)'
fi
salloc -Q -n 2 mpirun -n 2 "$program" "${arguments[@]}" "$folder/mpirun" >"$folder/mpirun.log" 2>&1 || { cat "$folder/mpirun.log" >&2; exit 1; }
check 'salloc, mpirun -n 2' "$folder/mpirun"
exit $failed
