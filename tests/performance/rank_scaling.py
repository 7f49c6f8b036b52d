#!/usr/bin/env python3
"""What several ranks make of a case: time of a step on each number of ranks, in turn, as medians, and what the
ranks did with their time. Prints a table for docs/performance.md.

    rank_scaling.py [CASE]... [--ranks 1,2] [--rounds 3] [--program PROGRAM]

CASE is w1, w2 (cases/benchmark), w3 (16 copies of W2 side by side, 26,240 stones), quick or pullout
(cases/pullout, loose), w1 and w2 if not given. Each rank gets a core of its own; more ranks than cores measure nothing.
"""
import argparse
import gzip
import json
import os
import pathlib
import re
import statistics
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
# The pull-outs whose times are in docs/theory/parallel.md.
CASES = {"quick": "tests/performance/quick_loose.prm", "pullout": "cases/pullout/loose.prm"}
STEPS = {"w3": ["Time/Warm-up steps=300", "Time/Timed steps=1000", "Output/Records=2"]}


def tiled(file, copies, target):
    """`copies` x `copies` packed states side by side."""
    state = json.load(gzip.open(file))
    x, y, _ = state["box"]
    clumps = []
    for m in range(copies):
        for n in range(copies):
            for clump in state["clumps"]:
                place = clump["pos"]
                clumps.append(dict(clump, pos=[place[0] + m * x, place[1] + n * y, place[2]]))
    state["clumps"] = clumps
    state["box"] = [copies * x, copies * y, state["box"][2]]
    with gzip.open(target, "wt") as out:
        json.dump(state, out)


def environment():
    return dict(os.environ, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1", OMPI_ALLOW_RUN_AS_ROOT="1",
                OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1", OMPI_MCA_btl_vader_single_copy_mechanism="none",
                OMPI_MCA_btl_base_warn_component_unused="0", OMPI_MCA_hwloc_base_binding_policy="core",
                OMPI_MCA_mpi_yield_when_idle="0")


PARTS = re.compile(r"rank (\d+): (\d+) stones and (\d+) ghosts in the mean; a step took ([\d.]+) us for forces, ([\d.]+) us "
                   r"for contacts with ribs, ([\d.]+) us for the lattice, ([\d.]+) us for messages and waiting, ([\d.]+) us for dealing \((\d+) times\) and "
                   r"gathering \((\d+) times\)")


class Case:
    def __init__(self, name, folder):
        self.name, self.entries = name, STEPS.get(name, [])
        if name in ("quick", "pullout"):
            self.file, self.entries = ROOT / CASES[name], ["Output/Report=false"]
        else:
            self.file = ROOT / f"cases/benchmark/{'w2' if name == 'w3' else name}.prm"
        if name == "w3":
            tiled(ROOT / "cases/benchmark/w2_settled.json.gz", 4, folder / "w3.json.gz")
            self.entries = [*self.entries, f"Packing/State file={folder / 'w3.json.gz'}"]

    def run(self, program, ranks, folder):
        """Time of a step, that of the whole run [s], its state hash, and the parts of each rank."""
        # One rank through mpirun, too, for a core of its own.
        command = ["mpirun", "-n", str(ranks), str(program), "run", str(self.file), "--force", "--output", str(folder / "run")]
        for entry in self.entries:
            command += ["--set", entry]
        subprocess.run(command, check=True, env=environment(), stdout=subprocess.DEVNULL)
        summary = json.loads((folder / "run/summary.json").read_text())
        parts = [[float(number) for number in match] for match in PARTS.findall((folder / "run/run.log").read_text())]
        return summary["wall_time_per_step_s"], summary["wall_time_s"], summary["state_hash"], parts


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("cases", nargs="*", default=["w1", "w2"])
    parser.add_argument("--ranks", default="1,2")
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build/release/bin/interlock")
    arguments = parser.parse_args()
    numbers = [int(word) for word in arguments.ranks.split(",")]
    print("| case | ranks | a step | times faster | forces | ribs | lattice | messages and waiting | dealing and gathering | "
          "imbalance | ghosts over stones |\n|---|---|---|---|---|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for case in [Case(word, folder) for word in arguments.cases or ["w1", "w2"]]:
            rounds = [{n: case.run(arguments.program, n, folder) for n in numbers} for _ in range(arguments.rounds)]
            assert len({run[2] for one in rounds for run in one.values()}) == 1, "the digits differ"
            for n in numbers:
                step = statistics.median(one[n][0] for one in rounds)
                gain = statistics.median(one[numbers[0]][0] / one[n][0] for one in rounds)
                parts = sorted(rounds, key=lambda one: one[n][0])[len(rounds) // 2][n][3]
                text = f"| {case.name} | {n} | {1e6 * step:.1f} us | {gain:.2f} |"
                if not parts:
                    print(text + " | | | | | | |")
                    continue
                columns = list(zip(*parts))
                us = [" to ".join(f"{value:.1f}" for value in sorted({min(column), max(column)})) + " us"
                      for column in columns[3:8]]
                busy = [sum(parts) for parts in zip(*columns[3:6])]
                print(text + f" {us[0]} | {us[1]} | {us[2]} | {us[3]} | {us[4]} | {max(busy) / statistics.mean(busy) - 1:.0%} | "
                      f"{sum(columns[2]) / sum(columns[1]):.2f} |", flush=True)


if __name__ == "__main__":
    main()
