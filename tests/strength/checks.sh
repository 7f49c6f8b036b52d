#!/usr/bin/env bash
# What the strength of ballast in a test depends on and should not: its speed, and the size of the box. For each filling
# the mean friction ratio of the shear box over the whole way (mean shear over mean normal force), or the mean stress
# ratio of the triaxial test: at the speed of the case, at half of it (from the same packed stones: until the test
# begins both runs have the same digits), and in a box half as long and wide, of the triaxial test half as high, again.
# Not a test: minutes a run.
#
#   bash tests/strength/checks.sh [FOLDER] [-- OPTIONS OF interlock run]
#
# default: results/strength_checks, two runs at a time; TEST is shear_box (default) or triaxial; SEEDS (words) are the
# fillings, default: 1 2 3.
set -euo pipefail
root="$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)"
export interlock="${INTERLOCK:-$root/build/release/bin/interlock}" root
folder=results/strength_checks
if [ $# -gt 0 ] && [ "$1" != "--" ]; then folder="$1"; shift; fi
[ $# -gt 0 ] && shift
[ -x "$interlock" ] || { echo "There is no program '$interlock': run 'make build' first." >&2; exit 2; }
case "${TEST:=shear_box}" in
  shear_box) speed_entry="Shear/Speed" speed=0.03 half=0.015 measure=mean_friction_ratio sizes="Length Width" ;;
  triaxial) speed_entry="Compression/Strain rate" speed=0.1 half=0.05 measure=mean_stress_ratio
    sizes="Length Width Height" ;;
  *) echo "TEST: there is no '$TEST' (shear_box, triaxial)." >&2; exit 2 ;;
esac
export TEST speed_entry sizes

one()
{
  [ -f "$1/summary.json" ] && return
  local entries=()
  for name in $sizes; do entries+=(--set "Box/$name=$4"); done
  "$interlock" run "$root/cases/ballast/$TEST.prm" --set Output/Report=false \
    --set "Output/Field frames=0" --set "Filling/Seed=$2" --set "$speed_entry=$3" "${entries[@]}" "${@:5}" \
    --force -o "$1" >/dev/null
}
export -f one
for seed in ${SEEDS:-1 2 3}; do
  printf '%s\0' "$folder/case-$seed" "$seed" $speed 0.3 "$folder/half_speed-$seed" "$seed" $half 0.3 \
    "$folder/large_box-$seed" "$seed" $speed 0.45
done | xargs -0 -n 4 -P 2 bash -c 'one "${@: -4}" "${@:1:$#-4}"' _ "$@"

SEEDS="${SEEDS:-1 2 3}" /usr/bin/python3 -I - "$folder" "$measure" <<'PYTHON'
import json, os, statistics, sys
folder, measure, seeds = sys.argv[1], sys.argv[2], os.environ["SEEDS"].split()
ratio, peak = {}, {}
for kind in ("case", "half_speed", "large_box"):
    for seed in seeds:
        with open(f"{folder}/{kind}-{seed}/summary.json", encoding="utf-8") as file:
            results = json.load(file)["results"]
        ratio.setdefault(kind, []).append(results[measure])
        peak.setdefault(kind, []).append(results["peak_friction_angle_deg"])
case = statistics.mean(ratio["case"])
for kind, values in ratio.items():
    scatter = statistics.stdev(values) if len(values) > 1 else float("nan")
    print(f"{kind:12s} {' '.join(f'{v:.3f}' for v in values)}   mean {statistics.mean(values):.3f} +- {scatter:.3f}, "
          f"{100 * (statistics.mean(values) / case - 1):+.1f} % of the case; peak "
          f"{' '.join(f'{angle:.1f}' for angle in peak[kind])} degrees")
PYTHON
