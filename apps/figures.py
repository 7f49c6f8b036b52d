#!/usr/bin/python3
"""Pictures of finished or running pull-out tests.

    figures.py RUN_DIR                         all figures of one run, in RUN_DIR/figures
    figures.py RUN_DIR OTHER_RUN_DIR... -o FILE
               [--label TEXT]...               force over displacement of several runs in one figure

Reads history.csv and summary.json of each run and, where there are any, the fields written for
ParaView. A figure whose input is absent is left out with a sentence that says so. Ends with 2 when a
folder holds no history at all.
"""

import argparse
import csv
import json
import os
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

# Okabe and Ito's colours, which colour-blind readers can tell apart.
COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000"]
LABORATORY = "laboratory, 10 mm/s, Ferellec and McDowell 2010"
# Plateau of the measured pull-out force by surcharge, read from the text of the paper [N].
LABORATORY_PLATEAU = {0: 1000.0, 500: 2500.0}


class InputError(Exception):
    """The folder that the user named cannot be drawn; the text is one full sentence."""


def read_history(run):
    """Columns of history.csv as name -> array, names without unit; text columns stay text."""
    path = os.path.join(run, "history.csv")
    if not os.path.isfile(path):
        raise InputError(f"{run}: there is no history.csv, so this is not the output folder of a run.")
    with open(path, newline="", encoding="utf-8") as file:
        rows = [row for row in csv.reader(file) if row]
    if len(rows) < 2:
        raise InputError(f"{path}: the file has no record yet.")
    names = [name.split("[")[0].strip() for name in rows[0]]
    # The last line of a running case may be half written.
    rows = [row for row in rows[1:] if len(row) == len(names)]
    return {name: as_numbers([row[i] for row in rows]) for i, name in enumerate(names)}


def as_numbers(texts):
    try:
        return np.array([float(text) if text else np.nan for text in texts])
    except ValueError:
        return np.array(texts)


def read_summary(run):
    """summary.json as a dictionary, empty while the run has not written it."""
    path = os.path.join(run, "summary.json")
    if not os.path.isfile(path):
        return {}
    with open(path, encoding="utf-8") as file:
        return json.load(file)


def during_pull(history):
    """The records of the pull: those of its stage where stages are named, else all."""
    stage = history.get("stage")
    if stage is None or stage.dtype.kind != "U" or not np.any(stage == "pull"):
        return history
    return {name: values[stage == "pull"] for name, values in history.items()}


def find_result(summary, name):
    """A value of the summary's results, under its bare name or with a unit behind it."""
    for key, value in summary.get("results", {}).items():
        if key == name or key.startswith(name + "_"):
            return value
    return None


def title_of(run, summary):
    rigid = find_result(summary, "rigid")
    kind = "" if rigid is None else ("rigid geogrid" if rigid else "flexible geogrid")
    name = os.path.basename(os.path.normpath(run))
    return f"{kind} ({name})" if kind else name


def draw_force(axes, history, colour, label):
    """Pull force over displacement: thin as recorded, thick as filtered."""
    pull = during_pull(history)
    displacement = 1e3 * pull["displacement"]
    filtered = pull.get("pull_force_filtered")
    if filtered is None:
        axes.plot(displacement, pull["pull_force"], color=colour, linewidth=1.2, label=label)
        return
    axes.plot(displacement, pull["pull_force"], color=colour, linewidth=0.5, alpha=0.45)
    axes.plot(displacement, filtered, color=colour, linewidth=2.0, label=label)


def draw_laboratory(axes, surcharges):
    """Dotted line at the measured plateau of every surcharge that the paper has."""
    drawn = sorted({load for load in LABORATORY_PLATEAU for mine in surcharges if abs(mine - load) < 1})
    for load in drawn:
        plateau = LABORATORY_PLATEAU[load]
        axes.axhline(plateau, color="0.35", linestyle=":", linewidth=1.2)
        text = LABORATORY if len(drawn) == 1 else f"{LABORATORY}, {load} N surcharge"
        axes.annotate(text, (0.99, plateau), xycoords=("axes fraction", "data"), xytext=(0, 3),
                      textcoords="offset points", ha="right", va="bottom", fontsize=8, color="0.35")


def save(figure, path):
    """Under a temporary name first, so that a reader never finds half a picture."""
    os.makedirs(os.path.dirname(os.path.abspath(path)), exist_ok=True)
    temporary = path + ".part"
    figure.savefig(temporary, dpi=150, format=os.path.splitext(path)[1][1:] or "png")
    os.replace(temporary, path)
    plt.close(figure)
    print(f"Wrote {path}.")


def force_figure(runs, labels, path, with_laboratory):
    figure, axes = plt.subplots(figsize=(7.5, 4.8), layout="constrained")
    surcharges = []
    for i, run in enumerate(runs):
        history, summary = read_history(run), read_summary(run)
        if "displacement" not in history or "pull_force" not in history:
            raise InputError(f"{run}/history.csv: the columns displacement and pull_force are missing, "
                             "so this is not a pull-out test.")
        label = labels[i] if i < len(labels) else title_of(run, summary)
        draw_force(axes, history, COLOURS[i % len(COLOURS)], label)
        # The laboratory pulled at 10 mm/s; a pull many times faster is not to be held against it. Without
        # a surcharge entry the plain test is what the paper compares first.
        if (find_result(summary, "pull_speed") or 0) < 0.015:
            surcharges.append(find_result(summary, "surcharge") or 0)
    if with_laboratory:
        draw_laboratory(axes, surcharges)
    axes.set_xlabel("displacement of the pulled edge [mm]")
    axes.set_ylabel("pull-out force [N]")
    axes.set_xlim(left=0)
    axes.set_ylim(bottom=min(0.0, axes.get_ylim()[0]))
    axes.grid(color="0.92")
    axes.set_axisbelow(True)
    if len(runs) > 1:
        axes.legend(frameon=False, loc="best")
    else:
        text = labels[0] if labels else title_of(runs[0], read_summary(runs[0]))
        axes.set_title("Pull-out test, " + text, fontsize=11)
    save(figure, path)


def energy_figure(run, path):
    """Change of every ledger entry since the first record; entries too small to be seen are left out."""
    history = read_history(run)
    entries = {name: values - values[0] for name, values in history.items()
               if name.startswith("energy_") and not name.startswith("energy_interface")
               and name != "energy_relative_error" and values.dtype.kind == "f"}
    if not entries or "time" not in history:
        print(f"Left out {path}: history.csv has no energy_* columns.")
        return
    figure, axes = plt.subplots(figsize=(8.5, 4.8), layout="constrained")
    swing = {name: np.nanmax(np.abs(values)) for name, values in entries.items()}
    shown = [name for name in entries if swing[name] > 0.005 * max(swing.values())]
    for i, name in enumerate(shown):
        axes.plot(history["time"], entries[name], linewidth=1.4, color=COLOURS[i % len(COLOURS)],
                  linestyle="-" if i < len(COLOURS) else "--",
                  label=name[len("energy_"):].replace("_", " "))
    axes.set_xlabel("time [s]")
    axes.set_ylabel("change since the first record [J]")
    error = history.get("energy_relative_error")
    closing = "" if error is None else f", relative error {error[-1]:.1e}"
    axes.set_title(f"Energy ledger, {title_of(run, read_summary(run))}{closing}", fontsize=11)
    axes.grid(color="0.92")
    if shown:
        axes.legend(frameon=False, fontsize=8, loc="center left", bbox_to_anchor=(1.0, 0.5))
    save(figure, path)


def pulled_at(run):
    """A function that says for a time how far the geogrid has been pulled then."""
    history = read_history(run)
    if "time" not in history:
        return lambda time: f"at {time:.3f} s"
    return lambda time: f"pulled {1e3 * np.interp(time, history['time'], history['displacement']):.1f} mm"


def main():
    parser = argparse.ArgumentParser(description="Pictures of finished or running pull-out tests.")
    parser.add_argument("runs", nargs="+", metavar="RUN_DIR", help="output folder of interlock run")
    parser.add_argument("-o", "--output", metavar="FILE",
                        help="file of the force-displacement figure (default: in the first run's figures/)")
    parser.add_argument("--label", action="append", default=[], metavar="TEXT",
                        help="name of a run in the legend, once for each run in the same order")
    parser.add_argument("--no-laboratory", action="store_true",
                        help="leave out the laboratory's plateau, for a box or a pull unlike the paper's")
    arguments = parser.parse_args()
    folder = os.path.join(arguments.runs[0], "figures")
    single = len(arguments.runs) == 1
    default = os.path.join(folder, "force_displacement.png" if single else "comparison.png")
    try:
        force_figure(arguments.runs, arguments.label, arguments.output or default,
                     not arguments.no_laboratory)
        if single:
            energy_figure(arguments.runs[0], os.path.join(folder, "energy.png"))
            import field_figures  # h5py is needed for these only
            field_figures.draw_all(arguments.runs[0], folder, save, pulled_at(arguments.runs[0]))
    except InputError as error:
        print(error, file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
