#!/usr/bin/python3 -I
"""Equal spheres in the triaxial test (beads.prm), several fillings: without friction, and with 0.3, poured with that (loose) or without
(dense). How densely they lie before the compression in the whole block, and before and after it in the part that is two spheres away from every
wall ("core"). Writes one folder a run, and beads.md.

    beads.py [FOLDER] [--seeds 1,2,3,4,5] [--jobs 2] [--program PROGRAM]

default: results/beads; after `make build`. Runs that are complete are not made again.
"""

import argparse
import concurrent.futures
import csv
import json
import pathlib
import statistics
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent.parent / "apps"))
import field_figures  # noqa: E402
import numpy as np  # noqa: E402
from scipy.spatial import cKDTree  # noqa: E402

# Name -> friction between spheres in the test, and until then (-1: the same).
KINDS = {"no friction": (0, 0), "0.3, loose": (0.3, -1), "0.3, dense": (0.3, 0)}
MARGIN = 2  # from the walls, in diameters
# Column -> value of the results.
COLUMNS = {"solid fraction": lambda r: 1 - r["porosity"], "core": lambda r: r["core"][0],
           "core at the end": lambda r: r["core"][1], "phi, peak": lambda r: r["peak_friction_angle_deg"],
           "phi, last fifth": lambda r: r["residual_friction_angle_deg"],
           "volume change [%]": lambda r: 1e2 * r["volume_change_at_end"]}


def core_fractions(run):
    """Share of a raster of points away from the walls that lie in a sphere, at the begin and the end."""
    series = field_figures.open_series(str(run), "clumps")
    with open(run / "history.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    fractions = []
    for frame, row in ((0, rows[0]), (len(series) - 1, rows[-1])):
        radius = series.attribute(frame, "radius")[0]
        margin = 2 * MARGIN * radius
        ranges = [np.arange(margin, float(row[f"{name} [m]"]) - margin, radius / 10)
                  for name in ("length", "width", "height")]
        points = np.stack(np.meshgrid(*ranges, indexing="ij"), axis=-1).reshape(-1, 3)
        distance, _ = cKDTree(series.points(frame)).query(points)
        fractions.append(float(np.mean(distance < radius)))
    return fractions


def make(run, friction, first, seed, program):
    if not (run / "summary.json").exists():
        entries = [f"Contact/Stone friction={friction}", f"Filling/Stone friction={first}", f"Filling/Seed={seed}",
                   "Output/Report=false"]
        words = [word for entry in entries for word in ("--set", entry)]
        done = subprocess.run([program, "run", HERE / "beads.prm", *words, "--force", "-o", run],
                              stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        print(run.name, flush=True)
        if done.returncode:
            raise SystemExit(f"{run}: {done.stderr.strip()}")
    results = json.loads((run / "summary.json").read_text())["results"]
    results["core"] = core_fractions(run)
    return results


def cell(values, digits):
    spread = f" ± {statistics.stdev(values):.{digits}f}" if len(values) > 1 else ""
    return f"{statistics.mean(values):.{digits}f}{spread}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", nargs="?", default="results/beads", type=pathlib.Path)
    parser.add_argument("--seeds", default="1,2,3,4,5")
    parser.add_argument("--jobs", default=2, type=int)
    parser.add_argument("--program", default=HERE.parent.parent / "build/release/bin/interlock")
    arguments = parser.parse_args()
    lines = ["| friction | fillings | " + " | ".join(COLUMNS) + " |", "|" + "---|" * (2 + len(COLUMNS))]
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        runs = {name: [pool.submit(make, arguments.folder / f"friction{friction}-filling{first}-{seed}", friction, first, seed,
                                   arguments.program) for seed in arguments.seeds.split(",")]
                for name, (friction, first) in KINDS.items()}
        for name, futures in runs.items():
            results = [future.result() for future in futures]
            cells = [cell([value(r) for r in results], 1 if column.startswith(("phi", "volume")) else 3)
                     for column, value in COLUMNS.items()]
            lines.append(f"| {name} | {len(results)} | " + " | ".join(cells) + " |")
    (arguments.folder / "beads.md").write_text("\n".join(lines) + "\n")
    print("\n".join(lines))


if __name__ == "__main__":
    main()
