#!/usr/bin/env bash
# Time of one step of a packed box, in turn with other DEM codes on one core: interlock, peer,
# interlock, peer, ... The ratio is taken of neighbours in time, because the speed of a machine drifts.
#
#   bash tests/performance/peers/compare.sh [--rounds 5] [--case w1|w2|w1-fine|w1-squeezed]
#     [--peers lammps,liggghts,yade] [--core 0] [--folder results/peers]
#
# Peers that are not installed are named and left out (Debian: lammps liggghts yade python3-numpy).
# INTERLOCK names another program than build/release/bin/interlock.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
export INTERLOCK="${INTERLOCK:-$here/../../../build/release/bin/interlock}"
[ -x "$INTERLOCK" ] || { echo "There is no program '$INTERLOCK': run 'make build' first." >&2; exit 2; }
command -v taskset >/dev/null || { echo "taskset is needed: apt-get install util-linux" >&2; exit 2; }
exec /usr/bin/python3 "$here/compare.py" "$@"
