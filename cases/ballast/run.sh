#!/usr/bin/env bash
# How strong is ballast in the shear box: fillings of the case shear_box.prm at several normal stresses, loose and
# dense, with several clumps and friction coefficients. Writes one folder a run, strength.csv (one row a run),
# strength.md (mean and standard deviation over the fillings) and strength.png beside published strengths.
#
#   bash cases/ballast/run.sh [FOLDER] [-- OPTIONS OF interlock run]
#
# default: results/ballast; after `make build`. What is run is said by these variables (words, separated by blanks):
#   SEEDS     fillings                             default: 1 2 3 4 5
#   STRESSES  normal stresses [kPa]                default: 2 10 35 100
#   FILLINGS  loose, dense                         default: loose dense
#   FRICTIONS between stones                       default: 0.6
#   CLUMPS    coarse, middle, fine: about 20, 55, 135 spheres       default: fine
#   JOBS      runs side by side                    default: 2
# A run that is complete is not run again, so more can be added later. Default: 40 runs.
set -euo pipefail
root="$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)"
export interlock="${INTERLOCK:-$root/build/release/bin/interlock}" root
folder=results/ballast
if [ $# -gt 0 ] && [ "$1" != "--" ]; then folder="$1"; shift; fi
[ $# -gt 0 ] && shift
[ -x "$interlock" ] || { echo "There is no program '$interlock': run 'make build' first." >&2; exit 2; }

# d_min, r_min and the largest number of spheres of a clump.
declare -A clumps=([coarse]="0.002 0.003 20" [middle]="0.002 0.0015 55" [fine]="0.001 0.0015 0")
declare -A fillings=([loose]=-1 [dense]=0.1)

runs=() list="$(mktemp)"
trap 'rm -f "$list"' EXIT
for clump in ${CLUMPS:-fine}; do
  for friction in ${FRICTIONS:-0.6}; do
    for filling in ${FILLINGS:-loose dense}; do
      for stress in ${STRESSES:-2 10 35 100}; do
        for seed in ${SEEDS:-1 2 3 4 5}; do
          [ -n "${clumps[$clump]:-}" ] || { echo "CLUMPS: there is no '$clump' (coarse, middle, fine)." >&2; exit 2; }
          [ -n "${fillings[$filling]:-}" ] || { echo "FILLINGS: there is no '$filling' (loose, dense)." >&2; exit 2; }
          run="$folder/$clump-mu$friction-$filling-${stress}kPa-$seed"
          runs+=("$run")
          [ -f "$run/summary.json" ] && continue
          read -r d_min r_min most <<<"${clumps[$clump]}"
          printf '%s\0' "$run" "$d_min" "$r_min" "$most" "$friction" "${fillings[$filling]}" "${stress}e3" "$seed" \
            >>"$list"
        done
      done
    done
  done
done

one()
{
  echo "$1"
  # A run with code 3 says itself why it is not to be used; the table says so, too.
  "$interlock" run "$root/cases/ballast/shear_box.prm" --set "Stones/D min=$2" --set "Stones/R min=$3" \
    --set "Stones/Max spheres=$4" --set "Contact/Stone friction=$5" --set "Filling/Stone friction=$6" \
    --set "Load/Normal stress=$7" --set "Filling/Seed=$8" --set Output/Report=false --set "Output/Field frames=0" \
    "${@:9}" --force -o "$1" >/dev/null 2>&1 || { [ $? -eq 3 ] || echo "$1 failed" >&2; }
}
export -f one
[ -s "$list" ] && xargs -0 -n 8 -P "${JOBS:-2}" bash -c 'one "${@: -8}" "${@:1:$#-8}"' _ "$@" <"$list"
/usr/bin/python3 -I "$root/cases/ballast/figure.py" "${runs[@]}" -o "$folder"
