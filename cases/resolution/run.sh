#!/usr/bin/env bash
# Table 4 and Figure 5 of Ferellec and McDowell (2010): one stone as four clumps of falling resolution.
# Writes the stone, the clumps with their reports, and resolution.png.
#
#   bash cases/resolution/run.sh [FOLDER]        default: results/resolution; after `make build`
#
# The paper's 800 spheres at p_max = 1 % mean a scan of about 80,000 nodes; its stone is not public,
# this one is synthetic, so the numbers of spheres agree in kind only.
set -euo pipefail
root="$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)"
interlock="${INTERLOCK:-$root/build/release/bin/interlock}"
folder="${1:-results/resolution}"
[ -x "$interlock" ] || { echo "There is no program '$interlock': run 'make build' first." >&2; exit 2; }

"$interlock" stones --count 1 --seed 6 --spacing 0.000245 -o "$folder/stone"
sets=("0.0001 0.002 10" "0.0001 0.0005 1" "0.00114 0.001 1" "0.0018 0.003 1")
clumps=()
for number in 1 2 3 4; do
  read -r d_min r_min p_max <<<"${sets[number - 1]}"
  echo
  "$interlock" clump "$folder/stone/stone_001.stl" --d-min "$d_min" --r-min "$r_min" --p-max "$p_max" \
    -o "$folder/set_$number.clump.json" --report "$folder/set_$number.report.json"
  clumps+=("$folder/set_$number.clump.json")
done
/usr/bin/python3 -I "$root/cases/resolution/figure.py" "$folder/stone/stone_001.stl" "${clumps[@]}" \
  -o "$folder/resolution.png"
