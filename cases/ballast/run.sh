#!/usr/bin/env bash
# How strong is ballast, and what decides it: the case shear_box.prm or triaxial.prm at several stresses, with clumps of
# several numbers of spheres, several friction coefficients, loose and dense, several fillings each. Writes one folder a
# run, strength.csv (one row a run), strength.md (mean and standard deviation over the fillings) and strength.png beside
# published strengths.
#
#   bash cases/ballast/run.sh [FOLDER] [-- OPTIONS OF interlock run]
#
# default: results/ballast, or results/triaxial; after `make build`. What is run is said by these variables (words,
# separated by blanks):
#   TEST      shear_box or triaxial                       default: shear_box
#   SERIES    spheres of a clump : friction between stones : filling (loose, dense; triaxial: tamped, too)
#             default: each varied by itself around 55:0.6:dense; triaxial: 55:0.6:tamped 55:0.6:dense 55:0.6:loose
#   STRESSES  normal stresses, or cell pressures [kPa]    default: 2 10 35 100, or 10 30 60
#   SEEDS     fillings                                    default: 1 2 3 4 5
#   JOBS      runs side by side                           default: 2
# A run that is complete is not run again, so more can be added later, and what was stopped goes on. Default: 140 runs,
# or 45.
set -euo pipefail
root="$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)"
export interlock="${INTERLOCK:-$root/build/release/bin/interlock}" root
# Friction while filling, -1: that of the test, and stress of the compaction. What is compacted is called dense in the
# shear box and tamped in the triaxial test, where dense is what friction alone decides.
declare -A fillings=([loose]="-1 0" [dense]="0 1e5")
case "${TEST:=shear_box}" in
  shear_box) folder=results/ballast entry="Load/Normal stress" at="2 10 35 100"
    kinds="55:0.6:dense 55:0.6:loose 55:0.4:dense 55:0.8:dense 20:0.6:dense 150:0.6:dense 500:0.6:dense" ;;
  triaxial) folder=results/triaxial entry="Load/Cell pressure" at="10 30 60"
    kinds="55:0.6:tamped 55:0.6:dense 55:0.6:loose" fillings[dense]="0.1 0" fillings[tamped]="0 1e5" ;;
  *) echo "TEST: there is no '$TEST' (shear_box, triaxial)." >&2; exit 2 ;;
esac
export TEST entry
if [ $# -gt 0 ] && [ "$1" != "--" ]; then folder="$1"; shift; fi
[ $# -gt 0 ] && shift
[ -x "$interlock" ] || { echo "There is no program '$interlock': run 'make build' first." >&2; exit 2; }
read -r -a series <<<"${SERIES:-$kinds}"
read -r -a stresses <<<"${STRESSES:-$at}"
read -r -a seeds <<<"${SEEDS:-1 2 3 4 5}"

runs=() list="$(mktemp)"
trap 'rm -f "$list"' EXIT
# All of one filling before the next: what is there can be looked at early.
for seed in "${seeds[@]}"; do
  for one in "${series[@]}"; do
    IFS=: read -r spheres friction filling <<<"$one"
    [ -n "${fillings[${filling:-none}]:-}" ] ||
      { echo "SERIES: '$one' should be spheres:friction:filling, with filling one of ${!fillings[*]}." >&2; exit 2; }
    for stress in "${stresses[@]}"; do
      run="$folder/$spheres-mu$friction-$filling-${stress}kPa-$seed"
      runs+=("$run")
      [ -f "$run/summary.json" ] && continue
      read -r at_first compaction <<<"${fillings[$filling]}"
      printf '%s\0' "$run" "$spheres" "$friction" "$at_first" "$compaction" "${stress}e3" "$seed" >>"$list"
    done
  done
done

one()
{
  echo "$1"
  # A run with code 3 says itself why it is not to be used; the table says so, too.
  "$interlock" run "$root/cases/ballast/$TEST.prm" --set "Stones/Max spheres=$2" --set "Contact/Stone friction=$3" \
    --set "Filling/Stone friction=$4" --set "Load/Compaction stress=$5" --set "$entry=$6" --set "Filling/Seed=$7" \
    --set Output/Report=false --set "Output/Field frames=0" "${@:8}" --force -o "$1" >/dev/null 2>&1 ||
    { [ $? -eq 3 ] || echo "$1 failed" >&2; }
}
export -f one
[ -s "$list" ] && xargs -0 -n 7 -P "${JOBS:-2}" bash -c 'one "${@: -7}" "${@:1:$#-7}"' _ "$@" <"$list"
/usr/bin/python3 -I "$root/cases/ballast/figure.py" "${runs[@]}" -o "$folder"
