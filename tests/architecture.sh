#!/usr/bin/env bash
# Checks the module graph apps -> coupling -> {dem, fem} and that only apps/ prints and exits, by
# reading the include lines and calls of the sources. Fails as soon as one file breaks one rule, and
# names file, line and rule.
#   architecture.sh SOURCE_FOLDER     check a tree
#   architecture.sh --self-test       check that each rule catches an offender and passes a clean tree
set -uo pipefail

# Prints the offending lines of all sources in $1/$2 that match the extended expression $3.
offences=0
forbid()
{
  local found
  [ -d "$1/$2" ] || return 0
  # Comments may name what the code must not use.
  found="$(cd "$1" && grep -rnE --include='*.h' --include='*.cc' -- "$3" "$2" | grep -vE '^[^:]+:[0-9]+:[[:space:]]*//')"
  if [ -n "$found" ]; then
    echo "$found" | sed "s|\$|    <- $4|"
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
  forbid "$1" dem "$(include_of 'deal\.II/|petsc|slepc|fem/|coupling/|apps/')" \
    "dem sees neither deal.II, PETSc nor any other module"
  forbid "$1" fem "$(include_of 'dem/|coupling/|apps/')" "fem sees no other module"
  forbid "$1" coupling "$(include_of 'apps/')" "coupling does not see apps"
  for module in dem fem coupling; do
    forbid "$1" "$module" "$printing" "only apps/ prints"
    forbid "$1" "$module" "$exiting" "only apps/ ends the program"
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
  mkdir "$tree"/{dem,fem,coupling,apps}
  printf '#include "dem/bodies/clumps.h"\n#include "fem/lattice/lattice.h"\n// std::cout << is not for this module\nstd::snprintf(a, 2, "b"); solver.exit(1);\n' >"$tree/coupling/loop.cc"
  printf '#include "coupling/loop.h"\nstd::cout << 1; std::exit(2);\n' >"$tree/apps/main.cc"
  check_tree "$tree" || { echo "a clean tree was refused"; missed=1; }
  while IFS='|' read -r file line; do
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
dem/a.cc|# include "coupling/loop.h"
dem/a.cc|#include "apps/report.h"
fem/a.cc|#include "dem/bodies/clumps.h"
fem/a.h|#include "coupling/loop.h"
coupling/a.cc|#include "apps/report.h"
coupling/a.cc|  std::cout << force;
fem/a.cc|  std::cerr << force;
dem/a.cc|  printf("%g", force);
dem/a.cc|  std::exit(2);
fem/a.cc|  if (bad) exit(2);
coupling/a.cc|  std::abort();
OFFENDERS
  return "$missed"
}

if [ "${1:-}" = --self-test ]; then
  self_test
else
  check_tree "${1:?usage: architecture.sh SOURCE_FOLDER | --self-test}"
fi
