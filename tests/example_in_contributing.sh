#!/usr/bin/env bash
# Checks that the experiment shown in CONTRIBUTING.md is the one that is compiled and run, line by line.
#   example_in_contributing.sh SOURCE_FOLDER
set -uo pipefail
cd "${1:?usage: example_in_contributing.sh SOURCE_FOLDER}" || exit 1

compiled="$(sed -n '\#^// \[example\]$#,\#^// \[example\]$#p' tests/unit/coupling_example_experiment.cc | grep -v '^// \[example\]$')"
shown="$(sed -n '/^## To add an experiment/,/^## To add a case/p' CONTRIBUTING.md | sed -n '/^```cpp$/,/^```$/p' | sed '1d;$d')"
[ -n "$compiled" ] || { echo "there is no example in tests/unit/coupling_example_experiment.cc"; exit 1; }
diff <(echo "$compiled") <(echo "$shown") || { echo "CONTRIBUTING.md shows another example than the one that is compiled"; exit 1; }
