#!/usr/bin/env bash
# Both orders of the spheres on 41 stones: error of the volume and distance of the surface against the
# number of spheres, in random order, by gain, and by gain with a bulge of up to 1 mm. Writes stones, clumps
# of 55 spheres with their report, orders.csv and orders.png.
#
#   bash cases/clumps/run.sh [FOLDER]      default: results/clumps; after `make build`
#
# d_min and r_min leave the random order some 200 spheres a stone; by gain they decide little.
set -euo pipefail
root="$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)"
interlock="${INTERLOCK:-$root/build/release/bin/interlock}"
folder="${1:-results/clumps}"
[ -x "$interlock" ] || { echo "There is no program '$interlock': run 'make build' first." >&2; exit 2; }

"$interlock" stones --count 41 --seed 1 -o "$folder/stones" >/dev/null
for bulge in 0 0.001; do
  echo "Bulge of up to $bulge m"
  "$interlock" clump "$folder/stones" --sphere-order gain --d-min 0.0003 --r-min 0.001 --spheres 55 \
    --bulge "$bulge" --compare-orders 10,20,40,55,100,150,200 -o "$folder/bulge_$bulge" | sed -n '/^Both orders/,$p'
done
/usr/bin/python3 -I "$root/cases/clumps/figure.py" "$folder/bulge_0/clumps.report.json" \
  "$folder/bulge_0.001/clumps.report.json" -o "$folder"
