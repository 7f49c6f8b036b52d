"""Runs interlock and its peers in turn on one packed state; see compare.sh.

The state that the peers get is written by interlock itself ("Packing/Write state"), refined or squeezed,
so all codes start from the same spheres with the same masses and moments. The contact law comes from the parameters that interlock used.
"""
import argparse
import json
import os
import re
import shutil
import statistics
import subprocess
import sys

import lammps_peer
import liggghts_peer
import yade_peer
from job import Job, Law, Result

HERE = os.path.dirname(os.path.abspath(__file__))
CASES = os.path.join(HERE, "..", "..", "..", "cases", "benchmark")
INTERLOCK = os.environ["INTERLOCK"]
PEERS = {"lammps": ("lmp", lammps_peer.run), "liggghts": ("liggghts", liggghts_peer.run),
         "yade": ("yade", yade_peer.run)}

# Steps before and in the timing, and the skin with which the peer is fastest [m]. Interlock runs the same
# steps, so both codes count contacts at the same instant; slower codes get fewer.
STEPS = {
    ("w1", "lammps"): (2000, 5000, 0.0005), ("w1", "liggghts"): (2000, 5000, 0.0005),
    ("w1", "yade"): (200, 500, 0.0002),
    ("w2", "lammps"): (1000, 2000, 0.001), ("w2", "liggghts"): (1000, 2000, 0.001),
    ("w2", "yade"): (80, 150, 0.0002),
    ("w1-fine", "lammps"): (500, 1000, 0.0005), ("w1-fine", "liggghts"): (500, 1000, 0.0005),
    ("w1-fine", "yade"): (40, 80, 0.0002),
    ("w1-squeezed", "lammps"): (500, 3000, 0.0005), ("w1-squeezed", "liggghts"): (500, 3000, 0.0005),
    ("w1-squeezed", "yade"): (100, 300, 0.0002),
}
# A squeezed box would burst. Every code runs whole steps, but so short that no stone moves [s].
STILL = {"w1-squeezed": 1e-12}


def interlock(case, folder, warm, steps, core, *settings):
    """Runs the case and returns its summary."""
    settings = ["Time/Warm-up steps=%d" % warm, "Time/Timed steps=%d" % steps, *settings]
    if case in STILL:
        settings += ["Packing/Hold still=false", "Time/Step=%g" % STILL[case]]
    command = ["taskset", "-c", core, INTERLOCK, "run", os.path.join(CASES, case + ".prm"), "--force", "-o", folder]
    command += ["--unusual"] if case in STILL else []  # the step
    for setting in settings:
        command += ["--set", setting]
    run = subprocess.run(command, capture_output=True, text=True)
    if run.returncode != 0:
        sys.exit("interlock failed: " + run.stderr.strip())
    with open(os.path.join(folder, "summary.json")) as file:
        return json.load(file)


def used_law(folder):
    """Contact law, gravity and time step from used.prm, as {"Section/Name": value}."""
    values, section = {}, ""
    for line in open(os.path.join(folder, "used.prm")):
        line = line.strip()
        if line.startswith("subsection "):
            section = line[11:] + "/"
        elif line == "end":
            section = ""
        elif match := re.fullmatch(r"set (.*?)\s*= ?(.*)", line):
            values[section + match[1]] = match[2]
    number = lambda key: float(values[key])
    k_n = number("Contact/Normal stiffness")
    return Law(k_n=k_n, k_t=k_n * number("Contact/Tangential ratio"), friction=number("Contact/Friction"),
               rate_n=number("Contact/Normal damping rate"), rate_t=number("Contact/Tangential damping rate"),
               gravity=number("Gravity"), dt=number("Time/Step"))


def mine(summary):
    return Result(seconds=summary["wall_time_per_step_s"], contacts=summary["results"]["touching_sphere_pairs"])


def compare(peer, arguments, state, law):
    """All rounds with one peer; prints their table."""
    warm, steps, skin = STEPS[arguments.case, peer]
    folder = os.path.join(arguments.folder, peer)
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    job = Job(state=state, law=law, warm=warm, steps=steps, skin=skin, core=arguments.core, folder=folder)
    print("\n%s against interlock, case %s: %d steps timed after %d, core %s, load %.2f" %
          (peer, arguments.case, steps, warm, arguments.core, os.getloadavg()[0]))
    print("  %-8s %14s %14s %9s" % ("round", "interlock, ms", peer + ", ms", "ratio"), flush=True)
    ours, theirs = [], []
    for k in range(arguments.rounds):
        ours.append(mine(interlock(arguments.case, os.path.join(folder, "interlock"), warm, steps, arguments.core)))
        theirs.append(PEERS[peer][1](job))
        print("  %-8d %14.4f %14.4f %9.2f" % (k + 1, 1e3 * ours[-1].seconds, 1e3 * theirs[-1].seconds,
                                             theirs[-1].seconds / ours[-1].seconds), flush=True)
    median = lambda results: 1e3 * statistics.median(r.seconds for r in results)
    ratios = [b.seconds / a.seconds for a, b in zip(ours, theirs)]
    print("  %-8s %14.4f %14.4f %9.2f   (%.2f to %.2f)" % ("median", median(ours), median(theirs),
                                                          statistics.median(ratios), min(ratios), max(ratios)))
    a, b = ours[-1].contacts, theirs[-1].contacts
    print("  touching sphere pairs: interlock %d, %s %d, difference %+.1f %%" % (a, peer, b, 100 * (a - b) / b))


def main():
    parser = argparse.ArgumentParser(prog="compare.sh")
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--case", choices=["w1", "w2", "w1-fine", "w1-squeezed"], default="w1")
    parser.add_argument("--peers", default="lammps,liggghts,yade")
    parser.add_argument("--core", default="0")
    parser.add_argument("--folder", default="results/peers")
    arguments = parser.parse_args()
    peers = arguments.peers.split(",")
    for peer in peers:
        if peer not in PEERS:
            parser.error("there is no peer '%s'; known are %s" % (peer, ", ".join(PEERS)))
    if arguments.rounds < 1:
        parser.error("--rounds is %d, but must be 1 or more" % arguments.rounds)
    arguments.folder = os.path.abspath(arguments.folder)
    os.makedirs(arguments.folder, exist_ok=True)
    written = os.path.join(arguments.folder, arguments.case + ".json")
    first = os.path.join(arguments.folder, "first")
    interlock(arguments.case, first, 0, 2, arguments.core, "Output/Records=1", "Packing/Write state=" + written)
    with open(written) as file:
        state = json.load(file)
    for peer in peers:
        if shutil.which(PEERS[peer][0]) is None:
            print("\n%s is not installed (no program '%s'): left out." % (peer, PEERS[peer][0]))
        else:
            compare(peer, arguments, state, used_law(first))


if __name__ == "__main__":
    main()
