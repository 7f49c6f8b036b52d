#!/usr/bin/env bash
# Kills a pull-out run (signal 9) at a random moment and resumes it, again and again, and compares what
# comes out with the undisturbed run: state hash, history, frames, results, to the last bit. One line a
# try; exit code 1 as soon as one try differs.
#   kills.sh [-s SEED] [-n KILLS] [-k] [CASE [TRIES [PROGRAM]]]
#     CASE    quick (cases/pullout/quick.prm, hours for 50 tries), small (small.prm beside this file) or a .prm file
#     -s      seed of the moments, 1 if not given
#     -n      kills a try, each after up to two KILLS-th parts of the duration: many kills in a long run. If
#             not given, one a try at any moment of the run, and one in three resumed runs is killed once more
#     -k      keep the folder of all runs and name it
set -uo pipefail

here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
root="$(cd "$here/../.." && pwd)"
seed=1 keep= often=0
while getopts s:n:k option; do
  case "$option" in
    s) seed="$OPTARG" ;;
    n) often="$OPTARG" ;;
    k) keep=yes ;;
    *) exit 2 ;;
  esac
done
shift $((OPTIND - 1))
case="${1:-quick}" tries="${2:-50}" program="${3:-$root/build/release/bin/interlock}"
program="$(realpath "$program")"

# So that a kill comes several checkpoints after the start, whatever the length of the run.
interval=5
case "$case" in
  quick) case="$root/cases/pullout/quick.prm" ;;
  small) case="$here/small.prm" interval=0.5 ;;
  *) case="$(realpath "$case")" ;;
esac

work="$(mktemp -d)"
if [ -n "$keep" ]; then echo "The runs are in $work."; else trap 'rm -rf "$work"' EXIT; fi
# A killed process cannot tidy up after MPI.
export TMPDIR="$work" OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1
cd "$work" || exit 1
RANDOM="$seed"

# run FOLDER SECONDS [OPTION]: kills it after so many seconds; 0: never. The exit code is 137 then.
run()
{
  timeout --signal=KILL "$2" "$program" run "$case" --set Output/Report=false \
    --set "Output/Checkpoint interval=$interval" --output "$1" "${@:3}" >"$1.out" 2>"$1.err" &
  wait $! 2>/dev/null # or the shell reports each kill
}

# A random share of $1 seconds.
moment() { awk -v a="$RANDOM" -v b="$RANDOM" -v t="$1" 'BEGIN { printf "%.3f", t * (a + b / 32768) / 32768 }'; }

seconds_now() { date +%s.%N; }

# The stage in which the run of folder $1 has been killed: the first one whose end is not in its log.
stage_of()
{
  local stage
  for stage in "${stages[@]}"; do
    grep -qs "^$stage: " "$1/run.log" || { echo "${stage/#stones/preparation}"; return; }
  done
  echo "the last lines"
}

# Where the last process of folder $1 went on.
resumed_at()
{
  local line
  line="$(grep -hE '^(Going on from|There is no checkpoint)' "$1.out" | tail -n 1)"
  case "$line" in
    Going*) sed -E 's/.* at (t = [^ ]+ s), step ([0-9]+), .*/\1, step \2/' <<<"$line" ;;
    There*) echo "the beginning" ;;
    *) echo "nothing yet" ;;
  esac
}

begin="$(seconds_now)"
run undisturbed 0 || { echo "the undisturbed run failed:"; tail -n 3 undisturbed.err; exit 1; }
duration="$(awk -v a="$begin" -v b="$(seconds_now)" 'BEGIN { printf "%.3f", b - a }')"
mapfile -t stages < <(python3 -c 'import json; print(*(s["name"] for s in json.load(open("undisturbed/summary.json"))["stages"]), sep="\n")')
echo "Undisturbed: $duration s, state_hash $(python3 -c 'import json; print(json.load(open("undisturbed/summary.json"))["state_hash"])')"

passed=0 failed=0 kills=0 redrawn=0
for ((try = 1; try <= tries; ++try)); do
  folder="try_$try" text= options=()
  span="$duration"
  [ "$often" -eq 0 ] || span="$(awk -v t="$duration" -v n="$often" 'BEGIN { print 2 * t / n }')"
  after="$(moment "$span")" left="$often"
  while true; do
    run "$folder" "$after" "${options[@]}"
    code=$?
    [ "${#options[@]}" -eq 0 ] || text+="; resumed at $(resumed_at "$folder")"
    [ "$code" -eq 137 ] || break
    kills=$((kills + 1))
    text+="${text:+; }killed in $(stage_of "$folder") after $after s"
    options=(--resume)
    left=$((left - 1))
    if { [ "$often" -gt 0 ] && [ "$left" -gt 0 ]; } || { [ "$often" -eq 0 ] && ((RANDOM % 3 == 0)); }; then
      after="$(moment "$span")"
    else
      after=0
    fi
  done
  # A busy machine is not equally quick all the time: a run that was over has not been killed.
  if [ -z "$text" ] && [ "$code" -eq 0 ] && ((redrawn++ < tries)); then
    rm -rf "${folder:?}"
    ((--try))
    continue
  fi
  [ -n "$text" ] || text="was over before $after s"
  if [ "$code" -ne 0 ]; then
    verdict="FAILED, exit code $code: $(tail -n 1 "$folder.err")"
  elif found="$(python3 "$here/compare_runs.py" undisturbed "$folder")"; then
    verdict=same
  else
    verdict="DIFFERS: $(head -n 3 <<<"$found" | paste -sd '|')"
  fi
  if [ "$verdict" = same ]; then passed=$((passed + 1)); else failed=$((failed + 1)); fi
  echo "$try: $text: $verdict"
  # What differs is worth a look; what does not only fills the disk.
  [ "$verdict" = same ] && rm -rf "${folder:?}" "$folder.out" "$folder.err"
done
echo "$passed passed, $failed failed ($kills kills)"
[ "$failed" -eq 0 ]
