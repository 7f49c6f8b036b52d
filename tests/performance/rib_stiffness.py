#!/usr/bin/env python3
"""What the stiffness of rib contacts changes in the quick pull-out: force, penetration, sub-steps, time. Every
filling is pulled with each stiffness from the same packed state; differences are paired.

    python3 tests/performance/rib_stiffness.py [--seeds 5] [--core 0] [--folder results/rib_stiffness]

Takes about two minutes a seed. INTERLOCK names another program than build/release/bin/interlock.
"""
import argparse
import csv
import json
import os
import statistics
import subprocess
import sys

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
INTERLOCK = os.environ.get("INTERLOCK", os.path.join(ROOT, "build", "release", "bin", "interlock"))
CASE = os.path.join(ROOT, "tests", "performance", "quick_loose.prm")
STIFFNESSES = {"paper": 9.76e8, "3e6": 3e6, "material": 0}


def run(folder, core, settings):
    if not os.path.exists(os.path.join(folder, "summary.json")):
        command = ["taskset", "-c", core, INTERLOCK, "run", CASE, "--force", "-o", folder]
        for setting in settings + ["Output/Report=false", "Output/Field frames=0"]:
            command += ["--set", setting]
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode not in (0, 3):  # 3: a result outside its bounds
            sys.exit("interlock failed: " + done.stderr.strip())
    with open(os.path.join(folder, "summary.json")) as file:
        return json.load(file)


def mean_force(folder, begin, end):
    """Mean pull force between two displacements [N]."""
    with open(os.path.join(folder, "history.csv")) as file:
        rows = [row for row in csv.DictReader(file) if begin <= float(row["displacement [m]"]) <= end]
    return statistics.mean(float(row["pull_force [N]"]) for row in rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seeds", type=int, default=5)
    parser.add_argument("--core", default="0")
    parser.add_argument("--folder", default="results/rib_stiffness")
    arguments = parser.parse_args()
    print("seed stiffness  5-10 mm [N]  10-20 mm [N]  overlap [um]  sub-steps  pull [us a step]")
    means = {}
    for seed in range(1, arguments.seeds + 1):
        folder = os.path.join(arguments.folder, str(seed))
        packed = os.path.join(folder, "packed")
        run(packed, arguments.core, ["Filling/Seed=%d" % seed, "Pull/Distance=0.001"])
        for name, stiffness in STIFFNESSES.items():
            out = os.path.join(folder, name)
            summary = run(out, arguments.core,
                          ["Filling/Seed=%d" % seed, "Contact/Geogrid stiffness=%g" % stiffness,
                           "Start from=" + os.path.join(packed, "state_before_pull.h5")])
            pull = [stage for stage in summary["stages"] if stage["name"] == "pull"][0]
            early, late = mean_force(out, 0.005, 0.01), mean_force(out, 0.01, 0.02)
            means.setdefault(name, []).append((early, late))
            print("%4d %-9s %12.1f %13.1f %13.1f %10d %10.1f" % (
                seed, name, early, late, 1e6 * summary["results"]["largest_overlap_m"],
                summary["results"]["substeps"], 1e6 * pull["wall_time_s"] / pull["steps"]), flush=True)
    n = arguments.seeds
    for name in list(STIFFNESSES)[1:]:
        for k, what in enumerate(("5-10 mm", "10-20 mm")):
            d = [a[k] - b[k] for a, b in zip(means[name], means["paper"])]
            error = statistics.stdev(d) / n ** 0.5 if n > 1 else float("nan")
            print("%s - paper, %s: %+.1f +- %.1f N (mean of %d fillings and its standard error; paper %.1f N)" %
                  (name, what, statistics.mean(d), error, n, statistics.mean(b[k] for b in means["paper"])))


if __name__ == "__main__":
    main()
