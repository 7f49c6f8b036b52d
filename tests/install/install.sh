#!/usr/bin/env bash
# Installs a build into a folder of its own, moves that elsewhere, and uses it as a stranger does. It takes a path of
# this machine in an installed file, a program that misses its scripts, cases, manual or completion, or an outside project
# that find_package(Interlock) does not serve, to fail.
#   install.sh BUILD_FOLDER SOURCE_FOLDER
set -euo pipefail

build="$(cd "$1" && pwd -P)"
sources="$(cd "$2" && pwd -P)"
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
fail() { echo "$*" >&2; exit 1; }

cmake --install "$build" --prefix "$folder/first" --strip >"$folder/log" || fail "$(tail -5 "$folder/log")"
mv "$folder/first" "$folder/moved"
prefix="$folder/moved"

# --- No path of the machine that built it ---
for path in "$sources" "$build" "$folder"; do
  if grep -rlaF -- "$path" "$prefix" >"$folder/found"; then
    fail "The path $path is in $(tr '\n' ' ' <"$folder/found")"
  fi
done

# Nor of another checkout, from which ccache has taken what it had.
if grep -raohE -- '/[A-Za-z0-9_./-]*/(dem|fem|coupling|apps)/[a-z_/]+\.(h|cc)\b' "$prefix/bin" "$prefix/lib" |
  sort -u >"$folder/found" && [ -s "$folder/found" ]; then
  fail "Names of source files: $(head -3 "$folder/found" | tr '\n' ' ')"
fi

# --- The program, from another folder ---
mkdir "$folder/work"
cd "$folder/work"
"$prefix/bin/interlock" --version >/dev/null
"$prefix/bin/interlock" run "$prefix/share/interlock/cases/geogrids/bx1100.prm" -o sheet \
  --set "Laboratory/Test=wide-width tension" >out 2>err || fail "The run failed: $(cat err)"
[ ! -s err ] || fail "The run said: $(cat err)"
[ -s sheet/report.html ] || fail "There is no page: $(tail -3 out)"
grep -q 'cff-version' sheet/report.html || fail "The page does not say how to cite."
# A plain name is a product of the library that came with the program.
"$prefix/bin/interlock" check "$prefix/share/interlock/cases/pullout/quick.prm" \
  --set Geogrid/Product=assumed_5x2.5.prm >out 2>err || fail "The library of geogrids is not found: $(cat err)"

# --- Manual and completion ---
man --warnings -l "$prefix/share/man/man1/interlock.1" >manual 2>complaints || true
[ ! -s complaints ] || fail "The manual has mistakes: $(head -3 complaints)"
grep -q -- '--resume' "$prefix/share/man/man1/interlock.1" && fail "A dash of the manual is no minus."
grep -q 'Go on from the checkpoint' "$prefix/share/man/man1/interlock.1" || fail "The manual lacks an option."
complete_with()
{
  # shellcheck disable=SC1091
  bash -c 'source "$1/share/bash-completion/completions/interlock"; shift
    COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _interlock; echo "${COMPREPLY[*]}"' bash "$prefix" "$@"
}
touch case.prm
for expected in "interlock ch=check" "interlock run --re=--resume" "interlock run ca=case.prm" \
  "interlock template tri=triaxial" "interlock report sh=sheet" "interlock help stu=study"; do
  # shellcheck disable=SC2086
  said="$(complete_with ${expected%%=*})"
  [ "$said" = "${expected#*=}" ] || fail "\"${expected%%=*}\" is completed to \"$said\"."
done

# --- Somebody else's project ---
cp -r "$sources/tests/install/outside" "$folder/outside"
cmake -S "$folder/outside" -B "$folder/outside/build" -DCMAKE_PREFIX_PATH="$prefix" >"$folder/log" 2>&1 ||
  fail "$(tail -20 "$folder/log")"
cmake --build "$folder/outside/build" >"$folder/log" 2>&1 || fail "$(tail -20 "$folder/log")"
"$folder/outside/build/bounce"
echo "Installed, moved and used."
