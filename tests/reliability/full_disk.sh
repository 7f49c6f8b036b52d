#!/usr/bin/env bash
# Fills the disk under a run, just before it writes its first file, a checkpoint, a row of the history, a
# frame. The run must end with exit code 3 and one sentence that names file and reason; with more room,
# --resume must end with the same bits as the undisturbed run. Needs the right to mount a small tmpfs;
# without it, says so and ends with exit code 77 (skipped).
#   full_disk.sh [PROGRAM]
# With LAUNCHER="mpirun -n 3" in the environment the program runs on several ranks; what the launcher adds to the
# error stream is not counted then.
set -uo pipefail

here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
program="$(realpath "${1:-$here/../../build/release/bin/interlock}")"

work="$(mktemp -d)"
disk="$work/disk"
mkdir "$disk"
child=
tidy()
{
  [ -n "$child" ] && kill -KILL "$child" 2>/dev/null && wait "$child" 2>/dev/null
  mountpoint -q "$disk" && umount "$disk"
  rm -rf "$work"
}
trap tidy EXIT
if ! mount -t tmpfs -o size=16m tmpfs "$disk" 2>/dev/null; then
  echo "Skipped: no right to mount a tmpfs here; run it as root, in a container with CAP_SYS_ADMIN."
  exit 77
fi
umount "$disk"
export TMPDIR="$work" OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1
cd "$work" || exit 1

# run FOLDER OPTION...
run()
{
  ${LAUNCHER:-} "$program" run "$here/small.prm" --set Output/Report=false --output "$1" "${@:2}" >out 2>err &
  child=$!
}

finish()
{
  wait "$child"
  code=$?
  child=
}

fill()
{
  dd if=/dev/zero of="$disk/ballast" bs=64k status=none 2>/dev/null
  # The last block has left a bit of room.
  dd if=/dev/zero of="$disk/ballast.rest" bs=4k status=none 2>/dev/null
}

# Waits until $1 holds or the run has ended.
await()
{
  until eval "$1"; do
    kill -0 "$child" 2>/dev/null || return 1
    sleep 0.01
  done
}

passed=0 failed=0
# try NAME WHEN FILE OPTION...: fills the disk when WHEN (an expression) holds; the run must fail at a
# file whose name matches FILE.
try()
{
  local name="$1" when="$2" file="$3" options=("${@:4}") fault= code
  run "undisturbed" "${options[@]}"
  finish
  [ "$code" -eq 0 ] || { echo "the undisturbed run failed:"; cat err; exit 1; }
  mount -t tmpfs -o size=16m tmpfs "$disk"
  # The disk is full from the start, where there is nothing to wait for.
  [ "$when" = at-once ] && fill
  run "$disk/run" "${options[@]}"
  if [ "$when" != at-once ]; then
    await "$when" || fault="the run was over before the disk was full; "
    fill
  fi
  finish
  [ "$code" -eq 3 ] || fault+="exit code $code; "
  [ -z "${LAUNCHER:-}" ] || sed -i '/^interlock: /!d' err
  [ "$(wc -l <err)" -eq 1 ] || fault+="$(wc -l <err) lines on the error stream; "
  grep -q "$file.*No space left on device.*\.\$" err || fault+="no sentence with file and reason; "
  [ -e "$disk/run/summary.json" ] && fault+="a summary of a failed run; "
  [ -n "$(find "$disk" -name '*.part')" ] && fault+="a part of a file is left behind; "
  echo "$name: exit code $code: $(head -n 1 err | sed "s|$work|...|g")"

  mount -o remount,size=64m "$disk"
  run "$disk/run" "${options[@]}" --resume
  finish
  if [ "$code" -ne 0 ]; then
    fault+="the resumed run ends with exit code $code: $(head -n 1 err); "
  elif ! python3 "$here/compare_runs.py" undisturbed "$disk/run" >differences; then
    fault+="the resumed run differs: $(head -n 3 differences | paste -sd '|'); "
  fi
  if [ -z "$fault" ]; then
    passed=$((passed + 1))
    echo "$name: with more room, $(grep -hE '^(Going on|There is no)' out | sed "s|$work|...|g") Same bits."
  else
    failed=$((failed + 1))
    echo "$name: FAILED: $fault"
  fi
  umount "$disk"
  rm -rf undisturbed
}

run="$disk/run"
stages_only=(--set "Output/Checkpoint interval=0")
# Each with few writes of other files, so that the one meant comes first.
try "first file" at-once used.prm "${stages_only[@]}"
# A state kept for other runs is written as a checkpoint is; which comes first depends on how busy the machine is.
try checkpoint "[ -e $run/checkpoint.previous.h5 ]" '\(checkpoint\|state_before_[a-z]*\).h5' --set "Output/Checkpoint interval=0.3"
try history "[ \$(cat $run/history.csv 2>/dev/null | wc -l) -gt 3 ]" history.csv "${stages_only[@]}" \
  --set Output/Records=400 --set "Output/Field frames=1"
try frames "[ -e $run/frames/contacts_000001.vtkhdf ]" '\(frames/\|clumps\.\|geogrid\.\|contacts\.\)' "${stages_only[@]}" \
  --set Output/Records=1 --set "Output/Field frames=40"
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
