#!/usr/bin/python3 -I
"""Error of the principal moments of clumps against their number of spheres, as CSV and figure.

    figure.py clumps.report.json... -o FOLDER

Reads reports of `interlock clump`; writes FOLDER/inertia.csv (one row a clump) and
FOLDER/inertia.png, and prints the means.
"""

import argparse
import csv
import json
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "apps"))
import plain_matplotlib  # before Matplotlib
import matplotlib.pyplot as plt
import numpy as np

# Okabe and Ito's colours, which colour-blind readers can tell apart.
SCHEMES = {"uniform": "#D55E00", "equal-mass": "#0072B2", "mesh": "#009E73"}
LABELS = {
    "uniform": "uniform: one density",
    "equal-mass": "equal-mass: the paper's correction",
    "mesh": "mesh: from the surface",
}
HEAD = ["limit", "stone", "spheres"] + [
    f"{scheme} {what}"
    for scheme in SCHEMES
    for what in ("moments [%]", "axes [deg]", "centre [mm]")
]


def read(path):
    """One row a clump of the report at `path`."""
    with open(path, encoding="utf-8") as file:
        report = json.load(file)
    rows = []
    for clump in report["clumps"]:
        row = [report["parameters"]["max_spheres"], clump["name"], clump["spheres"]]
        for scheme in SCHEMES:
            errors = clump["errors"][scheme]
            row += [
                100 * errors["principal_moments"],
                errors["principal_axes_degrees"],
                1e3 * errors["centre_m"],
            ]
        rows.append(row)
    return rows


def draw(rows, path):
    figure, axes = plt.subplots(figsize=(7.5, 4.7), dpi=150)
    axes.axvspan(100, 200, color="0.94", zorder=0)
    limits = sorted({row[0] for row in rows})
    for scheme, colour in SCHEMES.items():
        column = HEAD.index(f"{scheme} moments [%]")
        axes.plot([r[2] for r in rows], [r[column] for r in rows], ".", ms=3, alpha=0.4, color=colour)
        batches = [[r for r in rows if r[0] == limit] for limit in limits]
        axes.plot(
            [np.mean([r[2] for r in batch]) for batch in batches],
            [np.mean([r[column] for r in batch]) for batch in batches],
            "o-",
            color=colour,
            label=LABELS[scheme],
        )
    axes.plot([100, 200], [45, 45], "--", color="0.3", lw=1)
    axes.plot([100, 200], [10, 10], "--", color="0.3", lw=1, label="paper, Fig. 6, 100-200 spheres")
    axes.set_xscale("log")
    axes.set_xticks(limits, [str(limit) for limit in limits])
    axes.minorticks_off()
    axes.set_ylim(-2, 70)
    axes.set_xlabel("spheres in a clump")
    axes.set_ylabel("mean error of the principal moments [%]")
    axes.legend(frameon=False, ncol=2)
    axes.spines[["top", "right"]].set_visible(False)
    figure.tight_layout()
    figure.savefig(path)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("reports", nargs="+")
    parser.add_argument("-o", "--output", required=True, help="folder for inertia.csv and inertia.png")
    arguments = parser.parse_args()
    rows = [row for path in arguments.reports for row in read(path)]
    table = os.path.join(arguments.output, "inertia.csv")
    with open(table, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(HEAD)
        writer.writerows([[f"{x:.4g}" if isinstance(x, float) else x for x in row] for row in rows])
    picture = os.path.join(arguments.output, "inertia.png")
    draw(rows, picture)
    print(f"\n{'spheres':>8} {'uniform':>9} {'equal-mass':>11} {'mesh':>7} {'axes, uniform':>14}  (means: %, degrees)")
    for limit in sorted({row[0] for row in rows}):
        batch = np.array([row[2:] for row in rows if row[0] == limit], dtype=float).mean(axis=0)
        print(f"{batch[0]:8.1f} {batch[1]:9.1f} {batch[4]:11.1f} {batch[7]:7.1f} {batch[2]:14.1f}")
    print(f"Table: {table}\nFigure: {picture}")


if __name__ == "__main__":
    main()
