#!/usr/bin/env bash
# Flips single bits of a state at random places and asks the program to go on from it: by --resume, and
# by Start from. Each must be refused: exit code 2, one sentence, no result. A quarter of the flips lies
# in the block of text at the head of the file, which a uniform choice would hardly meet.
#   bit_flips.sh [-s SEED] [FLIPS [PROGRAM]]
set -uo pipefail

here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
seed=1
if [ "${1:-}" = -s ]; then seed="$2"; shift 2; fi
flips="${1:-200}" program="$(realpath "${2:-$here/../../build/release/bin/interlock}")"

work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
export TMPDIR="$work" OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1
cd "$work" || exit 1
RANDOM="$seed"

# run FOLDER OPTION...; an accepted state would run on, for a while.
run()
{
  timeout --signal=KILL 300 "$program" run "$here/small.prm" --set Output/Report=false \
    --output "$1" "${@:2}" >out 2>err
}

flip() # FILE BYTE BIT
{
  local value
  value="$(od -An -tu1 -j "$2" -N 1 "$1")"
  printf "\\x$(printf %02x $((value ^ (1 << $3))))" | dd of="$1" bs=1 seek="$2" conv=notrunc status=none
}

run run || { echo "the undisturbed run failed:"; tail -n 3 err; exit 1; }
cp run/checkpoint.h5 good.h5
cp run/state_before_pull.h5 good_start.h5
rm run/summary.json

passed=0 failed=0
for ((k = 1; k <= flips; ++k)); do
  # Half of them each; the good file goes back afterwards.
  if ((k % 2)); then good=good.h5 file=run/checkpoint.h5 folder=run options=(--resume)
  else good=good_start.h5 file=start.h5 folder=other options=(--set "Start from=$work/start.h5"); fi
  cp "$good" "$file"
  size="$(stat -c %s "$file")"
  range="$size"
  ((k % 8 < 2)) && range=512
  byte=$(((RANDOM * 32768 + RANDOM) % range)) bit=$((RANDOM % 8))
  flip "$file" "$byte" "$bit"
  run "$folder" "${options[@]}"
  code=$?
  fault=
  [ "$code" -eq 2 ] || fault="exit code $code"
  [ "$(wc -l <err)" -eq 1 ] || fault+=", $(wc -l <err) lines on the error stream"
  grep -q "^interlock: error: .*$(basename "$file").*\.\$" err || fault+=", no sentence that names the file"
  [ -e "$folder/summary.json" ] && fault+=", results"
  if [ -z "$fault" ]; then
    passed=$((passed + 1))
  else
    failed=$((failed + 1))
    echo "bit $bit of byte $byte of $size (${options[0]}): $fault: $(head -n 1 err)"
    rm -f "$folder/summary.json"
  fi
done
echo "$passed refused, $failed failed"
[ "$failed" -eq 0 ]
