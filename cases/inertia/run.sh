#!/usr/bin/env bash
# Figure 6 of Ferellec and McDowell (2010): error of the principal moments of inertia against the
# number of spheres, for a batch of 41 stones, with one density, with equal masses (the correction
# of the paper), and from the surface. Writes stones, clumps, inertia.csv and inertia.png.
#
#   bash cases/inertia/run.sh [FOLDER [R_MIN]]   default: results/inertia 0.0025 (m); after `make build`
#
# d_min is that of the first sets of Table 4; r_min, which the paper does not give for this figure, lies
# between those of Table 4 (0.5 to 3 mm). The numbers of spheres are set directly. 41 stones of some
# 20,000 nodes, of the sizes of Table 5.
set -euo pipefail
root="$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)"
interlock="${INTERLOCK:-$root/build/release/bin/interlock}"
folder="${1:-results/inertia}"
r_min="${2:-0.0025}"
[ -x "$interlock" ] || { echo "There is no program '$interlock': run 'make build' first." >&2; exit 2; }

"$interlock" stones --count 41 --seed 1 --spacing 0.0005 -o "$folder/stones"
reports=()
for spheres in 10 20 50 100 150 200 300 500; do
  echo
  echo "At most $spheres spheres a stone"
  "$interlock" clump "$folder/stones" --d-min 0.0001 --r-min "$r_min" --max-spheres "$spheres" \
    -o "$folder/clumps_$spheres"
  reports+=("$folder/clumps_$spheres/clumps.report.json")
done
/usr/bin/python3 -I "$root/cases/inertia/figure.py" "${reports[@]}" -o "$folder"
