#!/usr/bin/python3 -I
"""Heaps with other mass properties side by side: table, and a figure like the paper's Figure 7.

    compare.py RUN_DIR... -o FOLDER     heap.csv (one row a run), heap.md, heap.png in FOLDER

Runs of the same seed have the same drop, so differences are taken seed by seed.
"""

import argparse
import csv
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "apps"))
import figures
import heap_figures
import matplotlib.pyplot as plt
import numpy as np

SCHEMES = ("uniform", "equal-mass", "mesh")
TITLES = {"uniform": "uniform (not corrected)", "equal-mass": "equal-mass (the paper's correction)",
          "mesh": "mesh (that of the surface)"}
# Name in the table, unit, value of a summary.
MEASURES = [
    ("angle of repose", "degrees", lambda r: r["angle_of_repose_deg"]),
    ("its scatter over 8 azimuths", "degrees", lambda r: r["angle_of_repose_scatter_over_azimuths_deg"]),
    ("height", "mm", lambda r: 1e3 * r["height_m"]),
    ("r50", "mm", lambda r: 1e3 * r["r50_m"]),
    ("radius of gyration", "mm", lambda r: 1e3 * r["radius_of_gyration_m"]),
    ("the same, elongated stones", "mm", lambda r: 1e3 * r["radius_of_gyration_of_elongated_stones_m"]),
    ("the same, other stones", "mm", lambda r: 1e3 * r["radius_of_gyration_of_other_stones_m"]),
    ("mass beyond 1.5 r50", "%", lambda r: 1e2 * r["mass_share_beyond_1.5_r50"]),
    ("mass outside the given radius", "%", lambda r: 1e2 * r["mass_share_outside_radius"]),
    ("elongated stones beyond 1.5 r50", "%",
     lambda r: 1e2 * r["elongated_stones_beyond_1.5_r50"] / max(1, r["elongated_stones"])),
    ("other stones beyond 1.5 r50", "%",
     lambda r: 1e2 * r["other_stones_beyond_1.5_r50"] / max(1, r["other_stones"])),
]
# Shown as bars beside the views: indices into MEASURES.
BARS = (0, 4, 7, 9)


def read_runs(folders):
    """scheme -> seed -> (folder, summary)."""
    runs = {}
    for folder in folders:
        summary = figures.read_summary(folder)
        if summary.get("experiment") != "heap":
            raise figures.InputError(f"{folder}: there is no summary.json of a finished heap.")
        runs.setdefault(summary["results"]["mass_properties"], {})[summary["seed"]] = (folder, summary)
    return {scheme: runs[scheme] for scheme in SCHEMES if scheme in runs}


def values(runs, scheme, measure):
    return np.array([measure(summary["results"]) for _, summary in runs[scheme].values()])


def difference(runs, scheme, measure):
    """Mean over the seeds of `scheme` minus mesh and its standard error (nan for a single seed)."""
    seeds = sorted(set(runs[scheme]) & set(runs["mesh"]))
    steps = np.array([measure(runs[scheme][seed][1]["results"]) - measure(runs["mesh"][seed][1]["results"])
                      for seed in seeds])
    error = steps.std(ddof=1) / np.sqrt(len(steps)) if len(steps) > 1 else np.nan
    return steps.mean(), error


def spread(numbers):
    return numbers.std(ddof=1) if len(numbers) > 1 else np.nan


def with_error(form, value, error):
    """'1.2 ± 0.3', or the value alone where a single seed leaves no error."""
    return form.format(value) + (f" ± {error:.1f}" if np.isfinite(error) else "")


def write_csv(runs, path):
    with open(path + ".part", "w", newline="", encoding="utf-8") as file:
        table = csv.writer(file)
        table.writerow(["mass_properties", "seed"] + [f"{name} [{unit}]" for name, unit, _ in MEASURES] +
                       ["time_step [s]", "simulated_time [s]", "wall_time [s]", "ledger_error [-]", "warnings"])
        for scheme in runs:
            for seed, (_, s) in sorted(runs[scheme].items()):
                table.writerow([scheme, seed] + [f"{measure(s['results']):.6g}" for _, _, measure in MEASURES] +
                               [s["time_step_s"], s["simulated_time_s"], s["wall_time_s"],
                                s["energy"]["relative_error"], " ".join(s["warnings"])])
    os.replace(path + ".part", path)


def markdown(runs):
    seeds = max(len(of_scheme) for of_scheme in runs.values())
    lines = [f"Number of seeds: {seeds}. Mean and standard deviation over them; differences to `mesh` seed by "
             "seed, with the standard error of their mean.", "",
             "| measure | " + " | ".join(f"`{scheme}`" for scheme in runs) + " | " +
             " | ".join(f"`{scheme}` - `mesh`" for scheme in runs if scheme != "mesh") + " |",
             "|---" * (2 * len(runs)) + "|"]
    if "mesh" not in runs:
        raise figures.InputError("No run has the mass properties mesh, to which the others are compared.")
    for name, unit, measure in MEASURES:
        cells = [with_error("{:.1f}", mine.mean(), spread(mine))
                 for mine in (values(runs, scheme, measure) for scheme in runs)]
        for scheme in runs:
            if scheme != "mesh":
                cells.append(with_error("{:+.1f}", *difference(runs, scheme, measure)))
        lines.append(f"| {name} [{unit}] | " + " | ".join(cells) + " |")
    wall = [f"{np.mean([s['wall_time_s'] for _, s in of.values()]) / 60:.1f}" for of in runs.values()]
    step = [f"{1e6 * np.mean([s['time_step_s'] for _, s in of.values()]):.2f}" for of in runs.values()]
    for name, cells in (("time step [us]", step), ("wall time of a run [min]", wall)):
        lines.append(f"| {name} | " + " | ".join(cells) + " |" + " |" * (len(runs) - 1))
    return "\n".join(lines) + "\n"


def draw_bars(axes, runs, name, unit, measure):
    """Mean of each scheme with its standard deviation, and every seed as a dot."""
    for i, scheme in enumerate(runs):
        mine = values(runs, scheme, measure)
        axes.bar(i, mine.mean(), color=figures.COLOURS[i], alpha=0.35, width=0.65)
        if len(mine) > 1:
            axes.errorbar(i, mine.mean(), spread(mine), color=figures.COLOURS[i], capsize=5, linewidth=1.5)
        axes.plot(i + np.linspace(-0.12, 0.12, len(mine)), mine, "o", color=figures.COLOURS[i], markersize=4)
    axes.set_xticks(range(len(runs)), list(runs), fontsize=8)
    axes.set_title(f"{name} [{unit}]", fontsize=9)
    axes.set_ylim(bottom=0)
    axes.grid(axis="y", color="0.92")
    axes.set_axisbelow(True)


def draw(runs, path):
    """Views of the first seed of each scheme on one scale, and bars over all seeds below."""
    seed = min(runs["mesh"])
    heaps = {scheme: heap_figures.Stones(runs[scheme][seed][0]) for scheme in runs if seed in runs[scheme]}
    reach = max(heap.reach(0.97) for heap in heaps.values())
    top = 1.15 * max((heap.centres[:, 2] + heap.radii).max() for heap in heaps.values())
    n = len(runs)
    figure = plt.figure(figsize=(3.5 * n, 3.5 * (1 + top / (2 * reach)) + 3.6), layout="constrained")
    views, below = figure.subfigures(2, 1, height_ratios=[3.5 * (1 + top / (2 * reach)) + 0.8, 2.8])
    axes = views.subplots(2, n, height_ratios=[2 * reach, top], squeeze=False, sharey="row")
    for column, (scheme, heap) in enumerate(heaps.items()):
        heap_figures.draw_view(axes[0, column], heap, "plan", reach, top, pixel=2.5e-3)
        heap_figures.draw_view(axes[1, column], heap, "side", reach, top, pixel=2.5e-3)
        outside = int(np.sum(heap.distance > reach))
        axes[0, column].set_title(f"{TITLES[scheme]}\nseed {seed}; stones farther out: {outside}", fontsize=9)
        for view in axes[:, column]:
            view.label_outer()
    bars = below.subplots(1, len(BARS))
    for panel, index in zip(bars, BARS):
        draw_bars(panel, runs, *MEASURES[index])
    below.supxlabel(f"bars: mean and standard deviation over the seeds ({len(runs['mesh'])}), dots: the seeds; "
                    "views: elongated stones in orange", fontsize=8)
    figures.save(figure, path)


def main():
    parser = argparse.ArgumentParser(description="Heaps with other mass properties side by side.")
    parser.add_argument("runs", nargs="+", metavar="RUN_DIR", help="output folders of interlock run")
    parser.add_argument("-o", "--output", required=True, metavar="FOLDER")
    arguments = parser.parse_args()
    try:
        runs = read_runs(arguments.runs)
        table = markdown(runs)
        write_csv(runs, os.path.join(arguments.output, "heap.csv"))
        with open(os.path.join(arguments.output, "heap.md"), "w", encoding="utf-8") as file:
            file.write(table)
        print(table)
        draw(runs, os.path.join(arguments.output, "heap.png"))
    except figures.InputError as error:
        print(error, file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
