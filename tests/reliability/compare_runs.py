#!/usr/bin/env python3
"""Whether two output folders hold the same run: every file byte for byte but run.log, used.prm and the
kept states, and summary.json but for what a clock measured. Prints each difference; exit code 1 when
there is one.

    compare_runs.py FOLDER OTHER
"""
import json
import pathlib
import sys

NOT_COMPARED = {"run.log", "used.prm", "summary.json"}


def results(folder):
    files = {}
    for path in sorted(folder.rglob("*")):
        name = str(path.relative_to(folder))
        kept_state = name.startswith(("checkpoint", "state_")) and path.suffix == ".h5"
        figure = name.startswith("figures/")
        if path.is_file() and not kept_state and not figure and name not in NOT_COMPARED:
            files[name] = path.read_bytes()
    return files


def without_wall_times(value):
    if isinstance(value, list):
        return [without_wall_times(entry) for entry in value]
    if isinstance(value, dict):
        return {key: without_wall_times(entry) for key, entry in value.items()
                if not key.startswith("wall_time") and key not in ("origin", "parameters_hash")}
    return value


def summary(folder):
    file = folder / "summary.json"
    return without_wall_times(json.loads(file.read_text())) if file.is_file() else {}


def differences(one, other):
    a, b = summary(one), summary(other)
    if not a or not b:
        yield "a summary.json is missing"
    for key in sorted(set(a) | set(b)):
        if a.get(key) != b.get(key):
            yield f"{key} of summary.json: {a.get(key)} and {b.get(key)}"
    files, others = results(one), results(other)
    for needed in ("history.csv", "frames/clumps_000000.vtkhdf"):
        if needed not in files:
            yield f"{needed} is missing in {one}"
    for name in sorted(set(files) | set(others)):
        if name not in files or name not in others:
            yield f"{name} is in one of them only"
        elif files[name] != others[name]:
            yield f"{name} differs"


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    found = list(differences(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])))
    for line in found:
        print(line)
    sys.exit(1 if found else 0)
