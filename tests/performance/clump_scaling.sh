#!/usr/bin/env bash
# Time and memory of `interlock clump` against the number of nodes of the scan, on one core: one stone
# meshed finer and finer, 500 spheres each. Writes FOLDER/clump_scaling.csv and .png.
#
#   bash tests/performance/clump_scaling.sh [FOLDER]      default: results/clump_scaling
set -euo pipefail
root="$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)"
interlock="${INTERLOCK:-$root/build/release/bin/interlock}"
folder="${1:-results/clump_scaling}"
[ -x "$interlock" ] || { echo "There is no program '$interlock': run 'make build' first." >&2; exit 2; }
command -v /usr/bin/time >/dev/null || { echo "GNU time is needed: apt-get install time" >&2; exit 2; }

mkdir -p "$folder"
echo "nodes,time [s],memory [MB]" >"$folder/clump_scaling.csv"
for spacing in 0.0016 0.0008 0.0004 0.0002 0.0001 0.00008; do
  "$interlock" stones --count 1 --seed 6 --spacing "$spacing" -o "$folder/$spacing" >/dev/null
  clump="$folder/$spacing/stone"
  run=("$interlock" clump "$folder/$spacing/stone_001.stl" --d-min 0.0002 --r-min 0.0005 --max-spheres 500
    -o "$clump.clump.json" --report "$clump.report.json")
  for _ in 1 2 3; do
    { /usr/bin/time -f '%e,%M' taskset -c 0 "${run[@]}" >/dev/null; } 2>&1
  done | sort -g | head -1 >"$clump.time" # the fastest of three
  nodes="$(grep -o '"nodes": [0-9]*' "$clump.report.json" | head -1 | cut -d' ' -f2)"
  awk -F, -v OFS=, -v nodes="$nodes" '{print nodes, $1, $2 / 1024}' "$clump.time" |
    tee -a "$folder/clump_scaling.csv"
done
/usr/bin/python3 - "$folder" <<'PYTHON'
import sys
import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
folder = sys.argv[1]
nodes, seconds, _ = np.loadtxt(f"{folder}/clump_scaling.csv", delimiter=",", skiprows=1).T
figure, axes = plt.subplots(figsize=(6, 4), dpi=150)
axes.loglog(nodes, seconds, "o-", color="#0072B2", label="interlock clump, 500 spheres, one core")
axes.loglog(nodes, nodes * seconds[-1] / nodes[-1], "--", color="0.5", label="proportional to the nodes")
axes.set_xlabel("nodes of the scan (facets: twice as many)")
axes.set_ylabel("time, from start to written clump [s]")
axes.legend(frameon=False)
axes.grid(color="0.92")
figure.tight_layout()
figure.savefig(f"{folder}/clump_scaling.png")
slope = np.polyfit(np.log(nodes[-3:]), np.log(seconds[-3:]), 1)[0]
print(f"time grows as nodes^{slope:.2f} over the last three; {folder}/clump_scaling.png")
PYTHON
