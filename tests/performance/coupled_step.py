#!/usr/bin/env python3
"""Time of one coupled step of the quick pull-out on one core, in turn: flexible with the paper's contact
stiffness, flexible with Hertz contacts of the ribs' material, rigid; all from the same packed state.

    python3 tests/performance/coupled_step.py [--rounds 5] [--core 0] [--folder results/coupled_step]
    python3 tests/performance/coupled_step.py --spheres 40,135,500,2000      cost against spheres a stone

Ratios are of neighbours in time, because the speed of a machine drifts. The packed state is made once a folder (one
to two minutes, more with more spheres). INTERLOCK names another program than build/release/bin/interlock.
"""
import argparse
import json
import os
import statistics
import subprocess
import sys

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
INTERLOCK = os.environ.get("INTERLOCK", os.path.join(ROOT, "build", "release", "bin", "interlock"))
CASE = os.path.join(ROOT, "tests", "performance", "quick_loose.prm")
PAPER, MATERIAL = "Contact/Geogrid stiffness=9.76e8", "Contact/Geogrid stiffness=0"
VARIANTS = {"paper": [PAPER, "Geogrid/Rigid=false"], "material": [MATERIAL, "Geogrid/Rigid=false"],
            "rigid": [PAPER, "Geogrid/Rigid=true"]}
QUIET = ["Output/Report=false", "Output/Field frames=0"]


def fine_stones(folder):
    """The case's stones on meshes of some 20,000 nodes, enough for 2000 spheres."""
    if not os.path.exists(folder):
        done = subprocess.run([INTERLOCK, "stones", "--count", "41", "--spacing", "0.0005", "-o", folder],
                              capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit("interlock failed: " + done.stderr.strip())
    return os.path.abspath(folder)


def spheres(count, stones):
    """Entries that give stones of about this many spheres, whole ones."""
    return ["Stones/Folder=" + stones, "Stones/Length unit=1", "Stones/D min=0.00005", "Stones/R min=0.0004",
            "Stones/P max=100", "Stones/Max spheres=%d" % count]


def run(folder, core, settings):
    command = ["taskset", "-c", core, INTERLOCK, "run", CASE, "--force", "-o", folder]
    for setting in settings:
        command += ["--set", setting]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode not in (0, 3):  # 3: a result outside its bounds, timed all the same
        sys.exit("interlock failed: " + done.stderr.strip())
    with open(os.path.join(folder, "summary.json")) as file:
        return json.load(file)


def packed(folder, core, more):
    """The state before the pull, made where it is not there yet."""
    state = os.path.join(folder, "packed", "state_before_pull.h5")
    if not os.path.exists(state):
        print("Packing the box: %s" % os.path.dirname(state), flush=True)
        run(os.path.dirname(state), core, more + QUIET + ["Pull/Distance=0.001"])
    return state


def step(folder, core, state, variant, more):
    """Microseconds a step of the pull, sub-steps, spheres a stone."""
    summary = run(os.path.join(folder, variant), core,
                  more + QUIET + VARIANTS[variant] + ["Start from=" + state, "Pull/Distance=0.006"])
    pull = [stage for stage in summary["stages"] if stage["name"] == "pull"][0]
    return (1e6 * pull["wall_time_s"] / pull["steps"], summary["results"]["substeps"],
            summary["spheres"] / summary["clumps"])


def text(values):
    return "%.3g (%.3g-%.3g)" % (statistics.median(values), min(values), max(values))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--core", default="0")
    parser.add_argument("--folder", default="results/coupled_step")
    parser.add_argument("--spheres", help="numbers of spheres a stone, with commas between")
    arguments = parser.parse_args()
    if not os.access(INTERLOCK, os.X_OK):
        sys.exit("There is no program '%s': run 'make build' first." % INTERLOCK)
    if arguments.spheres:
        stones = fine_stones(os.path.join(arguments.folder, "stones"))
        cases = [(n, os.path.join(arguments.folder, str(n)), spheres(n, stones))
                 for n in map(int, arguments.spheres.split(","))]
    else:
        cases = [("case's", os.path.join(arguments.folder, "case"), [])]
    states = {n: packed(folder, arguments.core, more) for n, folder, more in cases}
    variants = list(VARIANTS) if not arguments.spheres else ["material"]

    times, substeps, mean = {}, {}, {}
    for k in range(arguments.rounds):
        for n, folder, more in cases:
            for variant in variants:
                time, substeps[n, variant], mean[n] = step(folder, arguments.core, states[n], variant, more)
                times.setdefault((n, variant), []).append(time)
        print("round %d of %d: " % (k + 1, arguments.rounds) +
              ", ".join("%s %.1f us" % (" ".join(map(str, key)), values[-1]) for key, values in times.items()),
              flush=True)

    base = (cases[0][0], variants[-1])
    print("\n%-10s %-10s %-9s %-22s %s" % ("spheres", "ribs", "sub-steps", "us a step",
                                           "over %s %s" % base))
    for key, values in times.items():
        ratios = [a / b for a, b in zip(values, times[base])]
        print("%-10.0f %-10s %-9d %-22s %s" % (mean[key[0]], key[1], substeps[key], text(values), text(ratios)))


if __name__ == "__main__":
    main()
