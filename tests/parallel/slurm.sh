#!/usr/bin/env bash
# Runs a small pull-out under a real Slurm on this machine: as a step of srun (PMIx), by mpirun inside an allocation, and
# alone. All must write the same state hash; a bad input must be refused by one sentence with exit code 2. Needs root and
#     apt-get install slurmctld slurmd slurm-client munge
# The Slurm of this script lives in a temporary folder and ends with it; one that runs here already is left alone.
#
#     tests/parallel/slurm.sh [PROGRAM]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
program=$(realpath "${1:-$here/../../build/release/bin/interlock}")
case_file=$here/../reliability/small.prm
for tool in slurmctld slurmd srun munged; do
  command -v "$tool" >/dev/null || { echo "slurm.sh needs $tool: apt-get install slurmctld slurmd slurm-client munge" >&2; exit 2; }
done
folder=$(mktemp -d)
daemons=()
trap 'kill "${daemons[@]}" 2>/dev/null || true; wait 2>/dev/null || true; rm -rf "$folder"' EXIT

mkdir -p "$folder/state" "$folder/spool"
chmod 755 "$folder"
dd if=/dev/urandom of="$folder/munge.key" bs=128 count=1 status=none
chmod 400 "$folder/munge.key"
munged --foreground --force --key-file "$folder/munge.key" --socket "$folder/munge.socket" --pid-file "$folder/munge.pid" \
  --seed-file "$folder/munge.seed" --log-file "$folder/munge.log" \
  >"$folder/munged.log" 2>&1 &
daemons+=($!)
cat >"$folder/slurm.conf" <<END
ClusterName=test
SlurmctldHost=$(hostname -s)(127.0.0.1)
SlurmUser=root
SlurmctldPort=16817
SlurmdPort=16818
AuthType=auth/munge
AuthInfo=socket=$folder/munge.socket
CredType=cred/munge
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
ReturnToService=2
SelectType=select/linear
NodeName=$(hostname -s) NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
END
export SLURM_CONF=$folder/slurm.conf
for _ in $(seq 50); do [ -S "$folder/munge.socket" ] && break; sleep 0.1; done
slurmctld -D >"$folder/slurmctld.log" 2>&1 &
daemons+=($!)
slurmd -D >"$folder/slurmd.log" 2>&1 &
daemons+=($!)
for _ in $(seq 100); do sinfo -h -o %t 2>/dev/null | grep -q idle && break; sleep 0.2; done
sinfo -h -o %t | grep -q idle || { echo 'The Slurm of this test did not start:' >&2; tail -5 "$folder"/slurm*.log >&2; exit 1; }

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
