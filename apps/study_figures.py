#!/usr/bin/python3 -I
"""Pictures of a study.

    study_figures.py STUDY_DIR      curves.png, differences.png, variance.png in STUDY_DIR/figures

Draws what `interlock study` has computed: curves.h5, differences.csv, variance.csv; it computes nothing itself. A
figure whose input is absent or empty is left out. Ends with 2 when the folder holds no study at all.
"""

import argparse
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
import figures  # before Matplotlib, which it sets up
import h5py
import matplotlib.pyplot as plt
import numpy as np
from run_files import read_rows

# More curves than colours tell nothing.
MOST_POINTS = len(figures.COLOURS)
# Measures that say most about a pull-out; of other experiments the first ones.
KNOWN = ("force_at_", "initial_stiffness", "peak_force_N", "mean_force_N", "fluctuation_N")
MOST_MEASURES = 8
KIND_COLOURS = {"filling": figures.COLOURS[0], "geogrid": figures.COLOURS[1], "set-up": figures.COLOURS[2],
                "geogrid and set-up": figures.COLOURS[2], "several": "0.7"}


def chosen_measures(rows):
    """Those of KNOWN that the rows have, in their order, else the first ones."""
    names = list(dict.fromkeys(row["measure"] for row in rows))
    known = [name for name in names if name.startswith(KNOWN)]
    return (known or names)[:MOST_MEASURES]


def number(text):
    return float(text) if text else np.nan


def words(measure):
    return measure.replace("_", " ")


def curves_figure(study, path):
    source = os.path.join(study, "curves.h5")
    if not os.path.isfile(source):
        return
    with h5py.File(source) as file:
        place, force, mean, deviation, counts = (np.array(file[name]) for name in
                                                 ("displacement", "force", "mean", "deviation", "n"))
        points = [name.decode() for name in np.array(file["points"]).ravel()]
        point_of_run = np.array(file["point_of_run"]).ravel().astype(int)
    place = 1e3 * place.ravel()
    figure, axes = plt.subplots(figsize=(7.5, 4.8), layout="constrained")
    for run, point in zip(force, point_of_run):
        colour = figures.COLOURS[point] if len(points) <= MOST_POINTS else "0.6"
        axes.plot(place, run, color=colour, linewidth=0.5, alpha=0.6)
    for p, name in enumerate(points[:MOST_POINTS] if len(points) <= MOST_POINTS else []):
        colour, style = figures.COLOURS[p], figures.STYLES[p]
        # Where a run has ended or is not to be used, a mean of the others would jump.
        mean[p][counts[p] < counts[p].max()] = np.nan
        axes.plot(place, mean[p], color=colour, linestyle=style, linewidth=2,
                  label=f"{name} ({int(counts[p].max())} fillings)")
        if np.any(np.isfinite(deviation[p])):
            axes.fill_between(place, mean[p] - deviation[p], mean[p] + deviation[p], color=colour, alpha=0.12,
                              linewidth=0)
    axes.plot([], [], color="0.4", linewidth=0.5, label="thin: each run; band: mean and standard deviation")
    axes.set_xlabel("displacement [mm]")
    axes.set_ylabel("force [N]")
    axes.grid(color="0.92")
    axes.set_axisbelow(True)
    axes.legend(fontsize=8, edgecolor="none")
    figures.save(figure, path)


def differences_figure(study, path):
    rows = [row for row in read_rows(study, "differences.csv") if number(row["n"]) > 0]
    if not rows:
        return
    measures = chosen_measures(rows)
    pairs = list(dict.fromkeys((row["factor"], row["level"], row["less"]) for row in rows))
    figure, axes = plt.subplots(figsize=(7.5, 1.5 + 0.22 * len(measures) * len(pairs)), layout="constrained")
    labels = []
    for m, measure in enumerate(measures):
        for k, pair in enumerate(pairs):
            row = next((row for row in rows if row["measure"] == measure
                        and (row["factor"], row["level"], row["less"]) == pair), None)
            at = -(m * (len(pairs) + 1) + k)
            labels.append((at, f"{words(measure)}, {pair[1]}"))
            if row is None or not number(row["mean_of_reference"]):
                continue
            scale = 100 / abs(number(row["mean_of_reference"]))
            half = number(row["half_width_of_interval"])
            axes.errorbar(scale * number(row["mean_difference"]), at,
                          xerr=None if np.isnan(half) else scale * half, fmt="o", markersize=4, capsize=3,
                          color=figures.COLOURS[k % len(figures.COLOURS)])
    axes.axvline(0, color="0.3", linewidth=0.8)
    axes.set_yticks([at for at, _ in labels], [text for _, text in labels], fontsize=7)
    axes.set_xlabel("paired difference from the first level, in % of its mean; bar: confidence interval", fontsize=9)
    axes.set_title("; ".join(dict.fromkeys(f"{factor}: less {less}" for factor, _, less in pairs)), fontsize=9)
    axes.grid(color="0.92", axis="x")
    figures.save(figure, path)


def variance_figure(study, path):
    rows = read_rows(study, "variance.csv")
    if not rows:
        return
    measures = chosen_measures(rows)
    figure, axes = plt.subplots(figsize=(7.5, 1.5 + 0.45 * len(measures)), layout="constrained")
    if "share" in rows[0]:
        draw_shares(axes, rows, measures)
    else:
        draw_indices(axes, rows, measures)
    axes.set_yticks(range(len(measures)), [words(measure) for measure in measures], fontsize=8)
    axes.invert_yaxis()
    axes.legend(fontsize=8, edgecolor="none", ncols=4, loc="upper center", bbox_to_anchor=(0.5, -0.16))
    axes.grid(color="0.92", axis="x")
    axes.set_axisbelow(True)
    figures.save(figure, path)


def draw_shares(axes, rows, measures):
    left = np.zeros(len(measures))
    for kind, colour in KIND_COLOURS.items():
        shares = np.array([sum(number(row["share"]) for row in rows if row["measure"] == measure
                               and row["term"] == "all of " + kind) for measure in measures])
        if np.any(shares > 0):
            label = "several together" if kind == "several" else kind
            axes.barh(range(len(measures)), shares, left=left, color=colour, label=label, height=0.6)
            left += shares
    axes.set_xlim(0, 1)
    axes.set_xlabel("share of the variance")


def draw_indices(axes, rows, measures):
    factors = list(dict.fromkeys(row["factor"] for row in rows))
    height = 0.8 / len(factors)
    for k, factor in enumerate(factors):
        of_factor = {row["measure"]: row for row in rows if row["factor"] == factor}
        at = np.arange(len(measures)) - 0.4 + (k + 0.5) * height
        colour = figures.COLOURS[k % len(figures.COLOURS)]
        for name, style in (("total", {"alpha": 0.35}), ("first", {"label": factor})):
            axes.barh(at, [number(of_factor[m][f"{name}_index"]) for m in measures], height=0.9 * height,
                      color=colour, xerr=[number(of_factor[m][f"standard_error_of_{name}"]) for m in measures],
                      ecolor="0.4", **style)
    axes.set_xlabel("index of Sobol: first (dark), total (light); bar: standard error")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("study", metavar="STUDY_DIR", help="output folder of interlock study")
    study = parser.parse_args().study
    if not os.path.isfile(os.path.join(study, "runs.csv")):
        print(f"{study}: there is no runs.csv, so this is not the folder of a study.", file=sys.stderr)
        return 2
    folder = os.path.join(study, "figures")
    curves_figure(study, os.path.join(folder, "curves.png"))
    differences_figure(study, os.path.join(folder, "differences.png"))
    variance_figure(study, os.path.join(folder, "variance.png"))
    return 0


if __name__ == "__main__":
    sys.exit(main())
