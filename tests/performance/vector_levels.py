#!/usr/bin/python3
"""What a program for any processor costs, on this one: a packed box with the build for this machine and with that of the
packages, once for each kind of processor that it has code for, all in turn.

    vector_levels.py [--case CASE] [--rounds N] [--native PROGRAM] [--package PROGRAM]

After `make build` and `make deb`. Prints us a step (fastest round and ratio to the build for this machine, median over
rounds), and the state hash: the packages' three must be one."""

import argparse
import json
import os
import statistics
import subprocess
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.realpath(__file__))))
# Name, program, and what the loader of the C library is not to use.
KINDS = [("this machine", "native", ""), ("packages, AVX-512", "package", ""), ("packages, AVX2", "package", "-AVX512F"),
         ("packages, SSE2", "package", "-AVX512F,-AVX2")]


def run(program, case, without, folder):
    environment = dict(os.environ, GLIBC_TUNABLES="glibc.cpu.hwcaps=" + without)
    subprocess.run([program, "run", case, "-o", folder, "--force"], check=True, env=environment, stdout=subprocess.DEVNULL)
    with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
        summary = json.load(file)
    return 1e6 * summary["wall_time_per_step_s"], summary["state_hash"]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--case", default=os.path.join(ROOT, "cases/benchmark/w1.prm"))
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--native", default=os.path.join(ROOT, "build/release/bin/interlock"))
    parser.add_argument("--package", default=os.path.join(ROOT, "build/package/bin/interlock"))
    arguments = parser.parse_args()
    times, hashes = {name: [] for name, _, _ in KINDS}, {}
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(arguments.rounds):
            for name, which, without in KINDS:
                time, hashes[name] = run(getattr(arguments, which), arguments.case, without, os.path.join(folder, "run"))
                times[name].append(time)
    first = times[KINDS[0][0]]
    for name, mine in times.items():
        ratio = statistics.median(a / b for a, b in zip(mine, first))
        print(f"{name:<20} {min(mine):8.2f} us a step {ratio:6.2f} times   {hashes[name]}")


if __name__ == "__main__":
    main()
