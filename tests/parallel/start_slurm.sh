# Starts a Slurm of one machine, this one, for the script that sources this file: in a temporary folder, on ports of its
# own, and ends it with the script, which may name a folder of its own to be removed too (`folder`). One that runs here
# already is left alone. Needs root and
#     apt-get install slurmctld slurmd slurm-client munge
for tool in slurmctld slurmd srun munged; do
  command -v "$tool" >/dev/null || { echo "$0 needs $tool: apt-get install slurmctld slurmd slurm-client munge" >&2; exit 2; }
done
# Slurm's daemons run as root here, so mpirun does, too.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
slurm_folder=$(mktemp -d)
daemons=()
trap 'kill "${daemons[@]}" 2>/dev/null || true; wait 2>/dev/null || true; rm -rf "$slurm_folder" "${folder:-}"' EXIT

mkdir -p "$slurm_folder/state" "$slurm_folder/spool"
chmod 755 "$slurm_folder"
dd if=/dev/urandom of="$slurm_folder/munge.key" bs=128 count=1 status=none
chmod 400 "$slurm_folder/munge.key"
munged --foreground --force --key-file "$slurm_folder/munge.key" --socket "$slurm_folder/munge.socket" --pid-file "$slurm_folder/munge.pid" \
  --seed-file "$slurm_folder/munge.seed" --log-file "$slurm_folder/munge.log" \
  >"$slurm_folder/munged.log" 2>&1 &
daemons+=($!)
cat >"$slurm_folder/slurm.conf" <<END
ClusterName=test
SlurmctldHost=$(hostname -s)(127.0.0.1)
SlurmUser=root
SlurmctldPort=16817
SlurmdPort=16818
AuthType=auth/munge
AuthInfo=socket=$slurm_folder/munge.socket
CredType=cred/munge
StateSaveLocation=$slurm_folder/state
SlurmdSpoolDir=$slurm_folder/spool
SlurmctldPidFile=$slurm_folder/slurmctld.pid
SlurmdPidFile=$slurm_folder/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
ReturnToService=2
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
NodeName=$(hostname -s) NodeAddr=127.0.0.1 CPUs=$(nproc) RealMemory=$(free -m | awk '/^Mem/ { print $2 }') State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
END
export SLURM_CONF=$slurm_folder/slurm.conf
for _ in $(seq 50); do [ -S "$slurm_folder/munge.socket" ] && break; sleep 0.1; done
slurmctld -D >"$slurm_folder/slurmctld.log" 2>&1 &
daemons+=($!)
slurmd -D >"$slurm_folder/slurmd.log" 2>&1 &
daemons+=($!)
for _ in $(seq 100); do sinfo -h -o %t 2>/dev/null | grep -q idle && break; sleep 0.2; done
sinfo -h -o %t | grep -q idle || { echo 'The Slurm of this test did not start:' >&2; tail -5 "$slurm_folder"/slurm*.log >&2; exit 1; }
