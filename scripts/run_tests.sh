#!/usr/bin/env bash
# Runs ctest in a build folder and closes with one line `N passed, N failed[, N skipped]`, which counts
# from ctest's own record. Usage: run_tests.sh BUILD_FOLDER JOBS [options of ctest]...
set -uo pipefail

build="$1"
jobs="$2"
shift 2
record="$(realpath "$build")/tests.xml"
rm -f "$record"

ctest --test-dir "$build" --output-on-failure --no-tests=error --parallel "$jobs" \
  --output-junit "$record" "$@"
status=$?

# The number in one attribute of the record's <testsuite> element; 0 when there is no record.
count()
{
  local value
  value="$(sed -n "s/^[[:space:]]*$1=\"\([0-9]*\)\".*/\1/p" "$record" 2>/dev/null | head -n 1)"
  echo "${value:-0}"
}
failed="$(count failures)"
skipped=$(($(count skipped) + $(count disabled)))
passed=$(($(count tests) - failed - skipped))
# A ctest that broke off before it wrote its record has failed, whatever was counted.
if [ "$status" -ne 0 ] && [ "$failed" -eq 0 ]; then
  failed=1
fi

line="$passed passed, $failed failed"
if [ "$skipped" -gt 0 ]; then
  line="$line, $skipped skipped"
fi
echo "$line"
exit "$status"
