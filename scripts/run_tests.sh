#!/usr/bin/env bash
# Runs ctest in a build folder and closes with one line `N passed, N failed[, N skipped]`, taken from
# ctest's own closing lines. Usage: run_tests.sh BUILD_FOLDER JOBS [options of ctest]...
set -uo pipefail

build="$1"
jobs="$2"
shift 2
log="$(mktemp)"
trap 'rm -f "$log"' EXIT

ctest --test-dir "$build" --output-on-failure --no-tests=error --parallel "$jobs" "$@" 2>&1 | tee "$log"
status=${PIPESTATUS[0]}

# `99% tests passed, 1 tests failed out of 120`; a test that could not be started has failed, too. The
# list below that line names the skipped ones.
read -r failed total < <(sed -n 's/^[0-9]*% tests passed, \([0-9]*\) tests failed out of \([0-9]*\)$/\1 \2/p' "$log" | tail -n 1)
failed="${failed:-0}"
skipped="$(grep -cE '^[[:space:]]+[0-9]+ - .* \((Skipped|Disabled)\)$' "$log")"
passed=$((${total:-0} - failed - skipped))
# A ctest that broke off before it counted has failed.
if [ "$status" -ne 0 ] && [ "$failed" -eq 0 ]; then
  failed=1
fi

line="$passed passed, $failed failed"
if [ "$skipped" -gt 0 ]; then
  line="$line, $skipped skipped"
fi
echo "$line"
exit "$status"
