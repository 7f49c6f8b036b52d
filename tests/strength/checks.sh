#!/usr/bin/env bash
# What the strength of the shear box depends on and should not: the speed of the shearing, and the size of the box.
# For each filling the mean friction ratio over the whole way (mean shear over mean normal force): at the speed of the
# case, at half of it (from the same packed stones: until the shearing begins both runs have the same digits), and in
# a box half as long and wide again. Not a test: minutes a run.
#
#   bash tests/strength/checks.sh [FOLDER] [-- OPTIONS OF interlock run]
#
# default: results/strength_checks, two runs at a time; SEEDS (words) are the fillings, default: 1 2 3.
set -euo pipefail
root="$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)"
export interlock="${INTERLOCK:-$root/build/release/bin/interlock}" root
folder=results/strength_checks
if [ $# -gt 0 ] && [ "$1" != "--" ]; then folder="$1"; shift; fi
[ $# -gt 0 ] && shift
[ -x "$interlock" ] || { echo "There is no program '$interlock': run 'make build' first." >&2; exit 2; }

one()
{
  [ -f "$1/summary.json" ] && return
  "$interlock" run "$root/cases/ballast/shear_box.prm" --set "Filling/Stone friction=0.1" --set Output/Report=false \
    --set "Output/Field frames=0" --set "Filling/Seed=$2" --set "Shear/Speed=$3" --set "Box/Length=$4" \
    --set "Box/Width=$4" "${@:5}" --force -o "$1" >/dev/null
}
export -f one
for seed in ${SEEDS:-1 2 3}; do
  printf '%s\0' "$folder/case-$seed" "$seed" 0.03 0.3 "$folder/half_speed-$seed" "$seed" 0.015 0.3 \
    "$folder/large_box-$seed" "$seed" 0.03 0.45
done | xargs -0 -n 4 -P 2 bash -c 'one "${@: -4}" "${@:1:$#-4}"' _ "$@"

SEEDS="${SEEDS:-1 2 3}" /usr/bin/python3 -I - "$folder" <<'PYTHON'
import json, os, statistics, sys
folder, seeds = sys.argv[1], os.environ["SEEDS"].split()
ratio = {}
for kind in ("case", "half_speed", "large_box"):
    for seed in seeds:
        with open(f"{folder}/{kind}-{seed}/summary.json", encoding="utf-8") as file:
            ratio.setdefault(kind, []).append(json.load(file)["results"]["mean_friction_ratio"])
case = statistics.mean(ratio["case"])
for kind, values in ratio.items():
    scatter = statistics.stdev(values) if len(values) > 1 else float("nan")
    print(f"{kind:12s} {' '.join(f'{v:.3f}' for v in values)}   mean {statistics.mean(values):.3f} +- {scatter:.3f}, "
          f"{100 * (statistics.mean(values) / case - 1):+.1f} % of the case")
PYTHON
