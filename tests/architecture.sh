#!/usr/bin/env bash
# Checks the module graph python -> apps -> coupling -> {dem, fem}, the order of the folders inside the modules
# (the floor plan below), and that only apps/ prints and exits, by reading the include lines and
# calls of the sources. Fails as soon as one file breaks one rule, and names file, line and rule.
#   architecture.sh SOURCE_FOLDER     check a tree
#   architecture.sh --self-test       check that each rule catches an offender and passes a clean tree
set -uo pipefail

# Prints the offending lines of all sources in $1/$2 that match the extended expression $3, but those
# in the file $5.
offences=0
forbid()
{
  local found
  [ -d "$1/$2" ] || return 0
  # Comments may name what the code must not use.
  found="$(cd "$1" && grep -rnE --include='*.h' --include='*.cc' -- "$3" "$2" | grep -vE '^[^:]+:[0-9]+:[[:space:]]*//' |
    grep -vE "^${5:-no file}:")"
  if [ -n "$found" ]; then
    echo "$found" | sed "s|\$|    <- $4|"
    offences=$((offences + 1))
  fi
}

# The floor plan: one floor a line, the lowest first. A folder may include from lower floors only;
# folders on one floor stand beside each other and do not see each other. "." is the module's own
# folder. What each folder holds: docs/architecture.md; why it is so: docs/decisions/0003-floor-plan.md.
floors_of_dem='
.
bodies
meshes contacts
scans stones export ribs
generator walls
lanes
lists
engine
parallel'
floors_of_fem='
ribs
beam
lattice
layouts gmsh explicit statics
implicit laboratory'
floors_of_coupling='
files
parameters state
loop
output
run
stones
strength_test
pull_out heap packing laboratory shear_box triaxial'

# Prints the include lines in $1/$2 that do not lead down the floors $3, and folders of sources that
# have no floor.
climbs()
{
  (cd "$1" && {
    find "$2" \( -name '*.h' -o -name '*.cc' \) -printf '%p:\n'
    grep -rnE --include='*.h' --include='*.cc' -- "$(include_of "$2/")" "$2"
  }) | FLOORS="$3" awk '
      function folder(path,  part) { return split(path, part, "/") > 2 ? part[2] : "." }
      BEGIN {
        n_floors = split(ENVIRON["FLOORS"], floors, "\n")
        for (i = 1; i <= n_floors; ++i) {
          n = split(floors[i], names, " ")
          for (j = 1; j <= n; ++j) floor_of[names[j]] = i
        }
      }
      {
        split($0, field, ":")
        from = folder(field[1])
        if (!(from in floor_of)) print field[1] "    <- the floor plan has no folder " from
        if (split($0, quoted, /[<"]/) < 2) next
        to = folder(quoted[2])
        if (from != to && !(to in floor_of && floor_of[to] < floor_of[from]))
          print $0 "    <- " from " does not see " to " (floor plan in tests/architecture.sh)"
      }'
}

check_floors()
{
  local found
  [ -d "$1/$2" ] || return 0
  found="$(climbs "$@")"
  if [ -n "$found" ]; then
    echo "$found"
    offences=$((offences + 1))
  fi
}

include_of() { echo "^[[:space:]]*#[[:space:]]*include[[:space:]]*[<\"]($1)"; }
# The characters in front keep names such as snprintf or on_exit out.
printing='std::(cout|cerr|clog|puts|printf)|(^|[^A-Za-z0-9_:])(f|v|vf)?(printf|puts) *\('
exiting='std::(exit|quick_exit|_Exit|abort|terminate) *\(|(^|[^A-Za-z0-9_:.>])(exit|_exit|abort) *\('

check_tree()
{
  offences=0
  forbid "$1" dem "$(include_of 'deal\.II/|petsc|slepc|fem/|coupling/|apps/|python/')" \
    "dem sees neither deal.II, PETSc nor any other module"
  forbid "$1" fem "$(include_of 'dem/|coupling/|apps/|python/')" "fem sees no other module"
  forbid "$1" coupling "$(include_of 'apps/|python/')" "coupling does not see apps"
  forbid "$1" apps "$(include_of 'python/|pybind11|Python\.h')" "apps does not see python"
  forbid "$1" python "$printing" "python prints through the text streams of Python"
  forbid "$1" python "$exiting" "only apps/ ends the program"
  check_floors "$1" dem "$floors_of_dem"
  check_floors "$1" fem "$floors_of_fem"
  check_floors "$1" coupling "$floors_of_coupling"
  for module in dem fem coupling; do
    forbid "$1" "$module" '^[[:space:]]*#[[:space:]]*include[[:space:]]*"([^/"]*"|\.)' \
      "an include names its file from the root of the project"
    forbid "$1" "$module" "$printing" "only apps/ prints"
    # That of a copy of the process which it has made itself.
    forbid "$1" "$module" "$exiting" "only apps/ ends the program" fem/gmsh/child_process.cc
  done
  for folder in utils common; do
    if [ -n "$(find "$1" -type d -name "$folder" -not -path '*/.git/*' -not -path '*/build*' -print -quit)" ]; then
      echo "$folder/    <- a folder is named after a concept, not after what is left over"
      offences=$((offences + 1))
    fi
  done
  [ "$offences" -eq 0 ]
}

# One offender at a time in an otherwise clean tree; each must be caught.
self_test()
{
  local tree missed=0
  tree="$(mktemp -d)"
  trap 'rm -rf "$tree"' RETURN
  mkdir -p "$tree"/{dem/walls,dem/lists,fem/ribs,fem/statics,fem/explicit,coupling/loop,coupling/heap,coupling/packing,apps}
  printf '#include "dem/engine/engine.h"\n#include "coupling/parameters/time_step.h"\n#include <cmath>\n// std::cout << is not for this module\nstd::snprintf(a, 2, "b"); solver.exit(1);\n' >"$tree/coupling/loop/loop.cc"
  printf '#include "dem/walls/wall.h"\n#include "dem/lists/pairs.h"\n#include "dem/vector.h"\n' >"$tree/dem/lists/pairs.cc"
  printf '#include "coupling/loop/loop.h"\nstd::cout << 1; std::exit(2);\n' >"$tree/apps/main.cc"
  check_tree "$tree" || { echo "a clean tree was refused"; missed=1; }
  while IFS='|' read -r file line; do
    mkdir -p "$(dirname "$tree/$file")"
    printf '%s\n' "$line" >"$tree/$file"
    if check_tree "$tree" >/dev/null; then
      echo "not caught in $file: $line"
      missed=1
    fi
    rm "$tree/$file"
  done <<'OFFENDERS'
dem/a.h|#include <deal.II/base/point.h>
dem/a.h|#include <petscvec.h>
dem/a.cc|#include "fem/lattice/lattice.h"
dem/a.cc|# include "coupling/loop/loop.h"
dem/a.cc|#include "apps/report.h"
fem/ribs/a.cc|#include "dem/bodies/clumps.h"
fem/ribs/a.h|#include "coupling/loop/loop.h"
coupling/loop/a.cc|#include "apps/report.h"
apps/a.cc|#include "python/moment.h"
apps/a.h|#include <pybind11/numpy.h>
python/a.cc|  std::cout << force;
coupling/loop/a.cc|  std::cout << force;
fem/ribs/a.cc|  std::cerr << force;
dem/a.cc|  printf("%g", force);
dem/a.cc|  std::exit(2);
fem/ribs/a.cc|  if (bad) exit(2);
coupling/loop/a.cc|  std::abort();
dem/a.h|#include "dem/bodies/clumps.h"
dem/walls/a.cc|#include "dem/lists/pairs.h"
dem/walls/a.h|# include <dem/engine/engine.h>
dem/walls/a.h|#include "dem/attic/clumps.h"
dem/walls/a.h|#include "wall.h"
dem/walls/a.h|#include "../lists/pairs.h"
dem/attic/a.cc|int unused;
fem/a.h|int unused;
fem/ribs/a.h|#include "fem/beam/beam_element.h"
fem/explicit/a.cc|#include "fem/statics/static_state.h"
coupling/loop/a.cc|#include "coupling/output/history.h"
coupling/heap/a.h|#include "coupling/packing/packing.h"
OFFENDERS
  return "$missed"
}

if [ "${1:-}" = --self-test ]; then
  self_test
else
  check_tree "${1:?usage: architecture.sh SOURCE_FOLDER | --self-test}"
fi
