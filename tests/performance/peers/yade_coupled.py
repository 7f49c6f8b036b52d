#!/usr/bin/env python3
"""One coupled step of the quick pull-out, in turn with YADE's clumps and its net of GridConnections (Debian
packages yade, python3-h5py) on the same packed box, one core.

    python3 tests/performance/peers/yade_coupled.py STATE [--rounds 3] [--core 0] [--folder results/yade_coupled]

STATE is a state_before_pull.h5 of `interlock run tests/performance/quick_loose.prm`. YADE steps stones and ribs together,
at the sub-step of the ribs; interlock steps the stones at their own. So two ratios are printed: of a step, and of
the time for the same simulated time. Differences: YADE's ribs are round, with the area of ours; it has one stiffness
for all contacts, no dashpots but local damping.
"""
import argparse
import json
import math
import os
import re
import statistics
import subprocess
import sys

import h5py
import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.join(HERE, "..", "..", "..")
INTERLOCK = os.environ.get("INTERLOCK", os.path.join(ROOT, "build", "release", "bin", "interlock"))
CASE = os.path.join(ROOT, "tests", "performance", "quick_loose.prm")
RIB_WIDTH, RIB_THICKNESS, ELEMENT = 5e-3, 2.5e-3, 0.065 / 8  # of the case [m]
PAPER = "Contact/Geogrid stiffness=9.76e8"


def state_of(path):
    """Stones and lattice of a checkpoint as plain numbers."""
    with h5py.File(path) as file:
        world = file["state/world"]
        clumps, walls = world["engine/clumps"], world["engine/walls"]
        shapes = [{"spheres": [[*c, r] for c, r in zip(s["spheres/centre"][()].tolist(), s["spheres/radius"][()])]}
                  for s in (clumps["shapes/%d" % k] for k in range(clumps["shapes/count"][0]))]
        rows = zip(clumps["shape"][()].tolist(), clumps["position"][()].tolist(),
                   np.roll(clumps["orientation"][()], 1, axis=1).tolist(),  # x, y, z, w to w, x, y, z
                   clumps["mass"][()].tolist(), clumps["inertia"][()].tolist())
        edges = np.abs(walls["edge1"][()] + walls["edge2"][()]) + np.abs(walls["corner"][()])
        nodes = world["geogrid/position"][()]
    apart = np.linalg.norm(nodes[:, None] - nodes[None, :], axis=2)
    elements = np.argwhere(np.triu(apart < 1.2 * ELEMENT, 1)).tolist()
    clamped = np.flatnonzero(nodes[:, 0] < nodes[:, 0].min() + 1e-4).tolist()
    return {"shapes": shapes, "density": 2650, "box": edges.max(axis=0).tolist(),
            "clumps": [dict(shape=s, pos=x, quat=q, mass=m, inertia=j) for s, x, q, m, j in rows],
            "ribs": {"nodes": nodes.tolist(), "elements": elements, "clamped": clamped,
                     "radius": math.sqrt(RIB_WIDTH * RIB_THICKNESS / math.pi), "youngs_modulus": 2.4e9,
                     "poisson_ratio": 0.3, "density": 910}}


def interlock(path, folder, core):
    """Seconds a step, time step, sub-steps."""
    command = ["taskset", "-c", core, INTERLOCK, "run", CASE, "--force", "-o", os.path.join(folder, "interlock")]
    for entry in (PAPER, "Start from=" + path, "Pull/Distance=0.005", "Output/Report=false", "Output/Field frames=0"):
        command += ["--set", entry]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode not in (0, 3):
        sys.exit("interlock failed: " + done.stderr.strip())
    with open(os.path.join(folder, "interlock", "summary.json")) as file:
        summary = json.load(file)
    pull = [stage for stage in summary["stages"] if stage["name"] == "pull"][0]
    return (pull["wall_time_s"] / pull["steps"], pull["simulated_time_s"] / pull["steps"],
            summary["results"]["substeps"])


def yade(state, folder, core, dt, steps):
    settings = dict(state=state, scripts=HERE, k_n=3e7, k_t=3e7, friction=0.6, gravity=9.81, dt=dt, warm=steps // 3,
                    steps=steps, skin=2e-4)
    done = subprocess.run(["taskset", "-c", core, "yade", "-n", "-x", "-j1", os.path.join(HERE, "yade_coupled_case.py")],
                          cwd=folder, capture_output=True, text=True,
                          env=dict(os.environ, PEER_SETTINGS=json.dumps(settings)))
    found = re.search(r"^RESULT (\S+) (\d+) (\d+) (\d+)$", done.stdout, re.M)
    if not found:
        sys.exit("YADE failed: " + (done.stdout + done.stderr)[-1500:])
    return float(found[1]), [int(found[k]) for k in (2, 3, 4)]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("state")
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--steps", type=int, default=150)
    parser.add_argument("--core", default="0")
    parser.add_argument("--folder", default="results/yade_coupled")
    arguments = parser.parse_args()
    os.makedirs(arguments.folder, exist_ok=True)
    state = os.path.abspath(os.path.join(arguments.folder, "state.json"))
    content = state_of(arguments.state)
    with open(state, "w") as file:
        json.dump(content, file)
    print("%d clumps, %d spheres, %d elements" % (
        len(content["clumps"]), sum(len(content["shapes"][c["shape"]]["spheres"]) for c in content["clumps"]),
        len(content["ribs"]["elements"])), flush=True)
    of_a_step, of_simulated_time = [], []
    for k in range(arguments.rounds):
        ours, dt, substeps = interlock(os.path.abspath(arguments.state), arguments.folder, arguments.core)
        theirs, touching = yade(state, arguments.folder, arguments.core, dt / substeps, arguments.steps)
        of_a_step.append(theirs / ours)
        of_simulated_time.append(theirs * substeps / ours)
        print("interlock %.4g ms a step of %.3g us with %d sub-steps; YADE %.4g ms a step of %.3g us, %d contacts of stones, "
              "%d with ribs, %d beams; %.0f times a step, %.0f times the simulated time" %
              (1e3 * ours, 1e6 * dt, substeps, 1e3 * theirs, 1e6 * dt / substeps, *touching, of_a_step[-1],
               of_simulated_time[-1]), flush=True)
    print("medians: %.0f times a step, %.0f times for the same simulated time" %
          (statistics.median(of_a_step), statistics.median(of_simulated_time)))


if __name__ == "__main__":
    main()
