#!/usr/bin/python3 -I
"""What better clumps and the paper's filling change in a pull-out: the cases before (loose.prm: clumps in random order, halves levelled by
taking stones off) and after (pullout.prm: clumps by gain, halves weighed in and pressed level), the quick one (100 mm/s) and the paper's
(10 mm/s), both with the ribs of loose.prm: masses, and forces at given displacements, as mean and standard deviation over fillings. Writes one folder a run and
stones_and_filling.md.

    stones_and_filling.py [FOLDER] [--seeds 1,2,3,4,5] [--cases quick,paper] [--jobs 2] [--program PROGRAM] [-- OPTIONS OF interlock run]

default: results/stones_and_filling; after `make build`. Runs that are complete are not made again.
"""
import concurrent.futures
import csv
import json
import pathlib
import statistics
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
from filling import ASSUMED_RIBS, cell, read_arguments  # noqa: E402

QUICK = ["Pull/Speed=0.1", "Pull/Distance=0.02", "Pull/Ramp time=0.01", "Filling/Kinetic energy ratio=4e-4"]
PAPER = ["Pull/Distance=0.021"]  # the last displacement of the table, and half a window more
CASES = {
    "quick": {"before": ("loose.prm", QUICK), "after": ("pullout.prm", QUICK)},
    "paper": {"before": ("loose.prm", PAPER), "after": ("pullout.prm", PAPER)},
}
PLACES = [2, 5, 10, 20]  # [mm]
WINDOW = 1  # means over +- half of it [mm]
# Row of the table: value of the results, digits.
ROWS = {"mass in the box [kg]": ("mass_in_box_kg", 2), "above the geogrid [kg]": ("mass_above_geogrid_kg", 2),
        "porosity of the stones": ("porosity_of_stones", 3), "porosity of the clumps": ("porosity_of_clumps", 3),
        "geogrid off its plane, r.m.s. [mm]": ("geogrid_rms_deviation_m", 1)}


def force_at(run, place):
    """Mean pull force over the window around a displacement [N]."""
    with open(run / "history.csv", encoding="utf-8") as file:
        rows = [(1e3 * float(row["displacement [m]"]), float(row["pull_force [N]"])) for row in csv.DictReader(file)]
    return statistics.mean(force for at, force in rows if abs(at - place) <= WINDOW / 2)


def make(run, file, entries, program, options):
    if (run / "summary.json").exists():
        return
    words = [word for entry in [ASSUMED_RIBS, *entries, "Output/Field frames=0", "Output/Report=false"] for word in ("--set", entry)]
    done = subprocess.run([program, "run", HERE / file, *words, *options, "--force", "-o", run],
                          stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    print(run.name, flush=True)
    if done.returncode not in (0, 3):  # 3: a part of the pull is not to be used, which the table says
        raise SystemExit(f"{run}: {done.stderr.strip()}")


def values_of(run):
    results = json.loads((run / "summary.json").read_text())["results"]
    values = {name: results[key] * (1e3 if name.endswith("[mm]") else 1) for name, (key, _) in ROWS.items()}
    values.update({f"force at {place} mm [N]": force_at(run, place) for place in PLACES})
    values["not usable from [mm]"] = results.get("not_usable_from_mm")
    return values


def table(columns):
    digits = {name: number for name, (_, number) in ROWS.items()}
    lines = ["| | " + " | ".join(columns) + " |", "|---|" + "---|" * len(columns)]
    for name in next(iter(columns.values()))[0]:
        if name.startswith("not usable"):
            cells = [", ".join(f"{v[name]:.1f}" for v in runs if v[name] is not None) for runs in columns.values()]
        else:
            cells = [cell([v[name] for v in runs], digits.get(name, 0)) for runs in columns.values()]
        lines.append(f"| {name} | " + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n"


def main():
    def add(parser):
        parser.add_argument("--cases", default="quick,paper")
        parser.add_argument("--jobs", type=int, default=2)
    arguments, options = read_arguments(__doc__.splitlines()[0], "results/stones_and_filling", add)
    seeds, runs, waiting = arguments.seeds.split(","), {}, []
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        for seed in seeds:
            for case in arguments.cases.split(","):
                for kind, (file, entries) in CASES[case].items():
                    run = arguments.folder / f"{case}-{kind}-{seed}"
                    runs.setdefault(f"{case}, {kind}", []).append(run)
                    waiting.append(pool.submit(make, run, file, [*entries, f"Filling/Seed={seed}"], arguments.program, options))
        for one in waiting:
            one.result()
    text = table({name: [values_of(run) for run in folders] for name, folders in runs.items()})
    (arguments.folder / "stones_and_filling.md").write_text(text)
    print(text, end="")


if __name__ == "__main__":
    main()
