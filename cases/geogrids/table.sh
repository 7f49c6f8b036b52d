#!/usr/bin/env bash
# Every product of this folder in the virtual laboratory; one table of what was measured beside its data sheet.
#
#   bash cases/geogrids/table.sh [FOLDER]        default: results/geogrids; after `make build`
#
# Writes one folder a product and table.md. INTERLOCK names another program than build/release/bin/interlock.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
interlock="${INTERLOCK:-$here/../../build/release/bin/interlock}"
folder="${1:-results/geogrids}"
[ -x "$interlock" ] || { echo "There is no program '$interlock': run 'make build' first." >&2; exit 2; }
runs=()
for case in "$here"/*.prm; do
  product="$(basename "$case" .prm)"
  "$interlock" run "$case" -o "$folder/$product"
  runs+=("$folder/$product")
done
/usr/bin/python3 -I "$here/table.py" "${runs[@]}" -o "$folder/table.md"
