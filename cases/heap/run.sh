#!/usr/bin/env bash
# The heap of Ferellec and McDowell (2010), section 3 and Figure 7, with uncorrected inertia (`uniform`),
# with the paper's correction (`equal-mass`) and with that of the surface (`mesh`): the same places,
# attitudes and times of release, so that only the inertia differs, for several seeds of them.
# Writes one folder a run, heap.csv, heap.md and heap.png.
#
#   bash cases/heap/run.sh [FOLDER [SEEDS]] [-- OPTIONS OF interlock run]
#
# default: results/heap 3; after `make build`. A run that is complete is not run again, so that more seeds
# can be added. Example of a smaller heap: bash cases/heap/run.sh /tmp/heap 2 -- --set Drop/Batches=3
set -euo pipefail
root="$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)"
interlock="${INTERLOCK:-$root/build/release/bin/interlock}"
positional=()
while [ $# -gt 0 ] && [ "$1" != "--" ]; do positional+=("$1"); shift; done
[ $# -gt 0 ] && shift
folder="${positional[0]:-results/heap}"
seeds="${positional[1]:-3}"
[ -x "$interlock" ] || { echo "There is no program '$interlock': run 'make build' first." >&2; exit 2; }
[[ "$seeds" =~ ^[1-9][0-9]*$ ]] ||
  { echo "The number of seeds is '$seeds', but must be a whole number of 1 or more." >&2; exit 2; }

runs=()
for seed in $(seq "$seeds"); do
  for scheme in uniform equal-mass mesh; do
    run="$folder/$scheme-$seed"
    runs+=("$run")
    [ -f "$run/summary.json" ] && continue
    echo
    echo "Seed $seed, $scheme"
    "$interlock" run "$root/cases/heap/heap.prm" --set "Drop/Seed=$seed" \
      --set "Stones/Mass properties=$scheme" "$@" -o "$run"
  done
done
/usr/bin/python3 -I "$root/cases/heap/compare.py" "${runs[@]}" -o "$folder"
