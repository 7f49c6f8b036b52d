#!/usr/bin/env bash
# Exports clumps, lets the codes that are installed load them, and compares the mass, inertia, centre
# and axes that these codes report with those of the clump file. Not part of `make test`, because
# the codes are not in packages.txt: apt-get install --no-install-recommends lammps liggghts yade
#   tests/peers/round_trip.sh [PROGRAM]      (default build/release/bin/interlock)
# Ends with 1 when a number is off by more than its tolerance or a code fails, with 77 when no code
# is there.
set -uo pipefail

here="$(cd "$(dirname "$0")" && pwd)"
interlock="$(realpath "${1:-$here/../../build/release/bin/interlock}")"
density=2650
# Open MPI refuses root, and Debian's LAMMPS wants to know its threads.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMP_NUM_THREADS=1

work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1

# The first of the named programs that is installed.
find_program() { for name in "$@"; do command -v "$name" && return; done; }
lammps="$(find_program lmp lammps lmp_mpi lmp_serial)"
liggghts="$(find_program liggghts lmp_auto)"
yade="$(find_program yade yadedaily)"

failures=0
checked=0
# check CLUMP LABEL TABLE COMMAND...: runs COMMAND in silence, which writes its TABLE.
check()
{
  local clump="$1" label="$2" table="$3"
  shift 3
  rm -f "$table"
  if ! timeout 300 "$@" >"$clump.log" 2>&1 </dev/null || [ ! -s "$table" ]; then
    echo "$label failed to load clump '$clump'; its last words:"
    tail -n 5 "$clump.log"
    failures=$((failures + 1))
    return
  fi
  checked=$((checked + 1))
  python3 "$here/compare.py" "$clump.clump.json" "$density" "$label" "$table" ||
    failures=$((failures + 1))
}

# make_clump NAME D_MIN R_MIN P_MAX
make_clump()
{
  "$interlock" clump stones/stone_001.stl --d-min "$2" --r-min "$3" --p-max "$4" \
    --density "$density" --format lammps,liggghts,yade -o "$1.clump.json" >"$1.log" 2>&1 ||
    { echo "interlock clump failed:"; tail -n 3 "$1.log"; exit 1; }
}

# Many spheres, whose masses can carry mass, centre and inertia; and a few, whose cannot.
"$interlock" stones --count 1 --seed 7 -o stones >/dev/null || exit 1
make_clump fine 0.001 0.002 100
make_clump coarse 0.006 0.006 2

python3 "$here/compare.py" --head
for clump in fine coarse; do
  if [ -n "$lammps" ]; then
    check "$clump" "LAMMPS mol" bodies.txt \
      "$lammps" -log none -in "$here/lammps.in" -var clump "$clump" -var way deposit
    # Few spheres cannot carry the inertia, so LAMMPS's own sums are checked on the fine clump.
    [ "$clump" = coarse ] || check "$clump" "LAMMPS sums" bodies.txt \
      "$lammps" -log none -in "$here/lammps.in" -var clump "$clump" -var way create
  fi
  [ -z "$liggghts" ] || check "$clump" "LIGGGHTS" bodies.txt \
    "$liggghts" -log none -in "$here/liggghts.in" -var clump "$clump"
  [ -z "$yade" ] || CLUMP="$clump" check "$clump" "YADE" bodies.txt "$yade" -n -x "$here/load_in_yade.py"
done

for code in lammps liggghts yade; do
  [ -n "${!code}" ] || echo "SKIPPED: $code is not installed."
done
[ "$checked" -gt 0 ] || [ "$failures" -gt 0 ] || exit 77
echo "$checked comparisons, $failures failed."
[ "$failures" -eq 0 ]
