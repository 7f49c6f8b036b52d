#!/usr/bin/env bash
# How strong is ballast: fillings of the case shear_box.prm or triaxial.prm at several stresses, loose and dense, with
# several clumps and friction coefficients. Writes one folder a run, strength.csv (one row a run), strength.md (mean
# and standard deviation over the fillings) and strength.png beside published strengths.
#
#   bash cases/ballast/run.sh [FOLDER] [-- OPTIONS OF interlock run]
#
# default: results/ballast, or results/triaxial; after `make build`. What is run is said by these variables (words,
# separated by blanks):
#   TEST      shear_box or triaxial                default: shear_box
#   SEEDS     fillings                             default: 1 2 3 4 5
#   STRESSES  normal stresses, or cell pressures [kPa]      default: 2 10 35 100, or 10 30 60
#   FILLINGS  loose, dense                         default: loose dense
#   FRICTIONS between stones                       default: 0.6
#   CLUMPS    coarse, middle, fine: about 20, 55, 135 spheres in random order; gain: 55 in the order of their gain
#                                                  default: fine, or gain
#   JOBS      runs side by side                    default: 2
# A run that is complete is not run again, so more can be added later. Default: 40 runs, or 30.
set -euo pipefail
root="$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)"
export interlock="${INTERLOCK:-$root/build/release/bin/interlock}" root
case "${TEST:=shear_box}" in
  shear_box) folder=results/ballast stresses="2 10 35 100" clump_names=fine entry="Load/Normal stress" ;;
  triaxial) folder=results/triaxial stresses="10 30 60" clump_names=gain entry="Load/Cell pressure" ;;
  *) echo "TEST: there is no '$TEST' (shear_box, triaxial)." >&2; exit 2 ;;
esac
export TEST entry
if [ $# -gt 0 ] && [ "$1" != "--" ]; then folder="$1"; shift; fi
[ $# -gt 0 ] && shift
[ -x "$interlock" ] || { echo "There is no program '$interlock': run 'make build' first." >&2; exit 2; }

# d_min, r_min, largest number of spheres of a clump, order, bulge.
declare -A clumps=([coarse]="0.002 0.003 20 random 0" [middle]="0.002 0.0015 55 random 0"
  [fine]="0.001 0.0015 0 random 0" [gain]="0 0.0015 55 gain 0.001")
declare -A fillings=([loose]=-1 [dense]=0.1)

runs=() list="$(mktemp)"
trap 'rm -f "$list"' EXIT
for clump in ${CLUMPS:-$clump_names}; do
  for friction in ${FRICTIONS:-0.6}; do
    for filling in ${FILLINGS:-loose dense}; do
      for stress in ${STRESSES:-$stresses}; do
        for seed in ${SEEDS:-1 2 3 4 5}; do
          [ -n "${clumps[$clump]:-}" ] ||
            { echo "CLUMPS: there is no '$clump' (coarse, middle, fine, gain)." >&2; exit 2; }
          [ -n "${fillings[$filling]:-}" ] || { echo "FILLINGS: there is no '$filling' (loose, dense)." >&2; exit 2; }
          run="$folder/$clump-mu$friction-$filling-${stress}kPa-$seed"
          runs+=("$run")
          [ -f "$run/summary.json" ] && continue
          printf '%s\0' "$run" "${clumps[$clump]}" "$friction" "${fillings[$filling]}" "${stress}e3" "$seed" >>"$list"
        done
      done
    done
  done
done

one()
{
  local d_min r_min most order bulge
  echo "$1"
  read -r d_min r_min most order bulge <<<"$2"
  # A run with code 3 says itself why it is not to be used; the table says so, too.
  "$interlock" run "$root/cases/ballast/$TEST.prm" --set "Stones/D min=$d_min" --set "Stones/R min=$r_min" \
    --set "Stones/Max spheres=$most" --set "Stones/Sphere order=$order" --set "Stones/Bulge=$bulge" \
    --set "Contact/Stone friction=$3" --set "Filling/Stone friction=$4" --set "$entry=$5" --set "Filling/Seed=$6" \
    --set Output/Report=false --set "Output/Field frames=0" "${@:7}" --force -o "$1" >/dev/null 2>&1 ||
    { [ $? -eq 3 ] || echo "$1 failed" >&2; }
}
export -f one
[ -s "$list" ] && xargs -0 -n 6 -P "${JOBS:-2}" bash -c 'one "${@: -6}" "${@:1:$#-6}"' _ "$@" <"$list"
/usr/bin/python3 -I "$root/cases/ballast/figure.py" "${runs[@]}" -o "$folder"
