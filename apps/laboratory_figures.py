#!/usr/bin/python3 -I
"""Pictures of a finished laboratory test of a geogrid.

    laboratory_figures.py RUN_DIR     curves.png and TEST.png (the deformed piece) in RUN_DIR/figures

Reads history.csv, table.csv and TEST.xdmf. Ends with 2 when the folder holds no history at all.
"""

import argparse
import csv
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
import figures  # before Matplotlib, which it sets up
import matplotlib.pyplot as plt
import numpy as np


def read_rows(path):
    if not os.path.isfile(path):
        return []
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def paths_by_test(rows):
    """Test -> (name of the deformation, name of the load, deformations, loads)."""
    paths = {}
    for row in rows:
        path = paths.setdefault(row["test"], (row["deformation_name"], row["load_name"], [], []))
        path[2].append(float(row["deformation"]))
        path[3].append(float(row["load"]))
    return paths


def words(name):
    return name.replace("_", " ")


def draw_curves(paths, stated, target):
    """One plot for each kind of test; tension in both directions shares one."""
    kinds = {}
    for test, path in paths.items():
        kinds.setdefault((path[0], path[1]), []).append((test, path))
    figure, axes = plt.subplots(1, len(kinds), figsize=(4.4 * len(kinds), 3.6), squeeze=False)
    for axis, ((deformation, load), members) in zip(axes[0], kinds.items()):
        percent = deformation.startswith("strain")
        kilo = load.endswith("[N/m]")
        for colour, style, (test, path) in zip(figures.COLOURS, figures.STYLES, members):
            axis.plot(np.array(path[2]) * (100 if percent else 1),
                      np.array(path[3]) * (1e-3 if kilo else 1), color=colour, linestyle=style, label=test)
            if test in stated:
                axis.plot(*zip(*stated[test]), "o", color=colour, mfc="none", label="data sheet, " + test)
        axis.set_xlabel("strain [%]" if percent else words(deformation))
        axis.set_ylabel("force per width [kN/m]" if kilo else words(load))
        axis.legend(fontsize=8)
        axis.grid(alpha=0.3)
    save(figure, target)


def stated_forces(table):
    """Test -> [(strain in %, force in kN/m)] that the data sheet states."""
    stated = {}
    for row in table:
        parts = row["quantity"].split(", ")
        if len(parts) == 3 and parts[2].startswith("force at") and row["stated"]:
            strain = float(parts[2].split()[2])
            stated.setdefault(f"{parts[0]} {parts[1]}", []).append((strain, float(row["stated"])))
    return stated


VIEWS = {"plan": (0, 1, "x, along [mm]", "y, across [mm]"), "side": (0, 2, "x, along [mm]", "z [mm]")}


def views_of(points):
    """Plan, side or both: a view in which the piece is next to a line shows nothing."""
    size = np.ptp(points, axis=0)
    return [name for name, (_, up, _, _) in VIEWS.items() if size[up] > 0.02 * size.max()] or ["plan"]


def draw_piece(run, test, target):
    """The deformed piece over its unloaded outline, coloured by a section force; of modes the first four."""
    import field_series  # h5py is needed for this only
    from matplotlib.collections import LineCollection

    series = field_series.open_series(run, test.replace(" ", "_"))
    if series is None:
        raise FileNotFoundError(f"{run} holds no fields of the test")
    frames = range(min(4, len(series))) if test == "modes" else [0]
    views = views_of(np.concatenate([series.points(frame) for frame in frames]))
    figure, axes = plt.subplots(len(frames), len(views), squeeze=False,
                                figsize=(5.5 * len(views) + 0.5, 4.2 * len(frames)))
    field = field_series.section_force_of_test(series, 0, test)
    for row, frame in zip(axes, frames):
        points, lines = series.points(frame), series.lines(frame)
        unloaded = points - series.attribute(frame, "displacement")
        for axis, view in zip(row, views):
            across, up, x_label, y_label = VIEWS[view]
            axis.add_collection(LineCollection(1e3 * unloaded[:, (across, up)][lines], colors="#cccccc",
                                               linewidths=1))
            ribs = LineCollection(1e3 * points[:, (across, up)][lines], linewidths=2.2)
            if field is None:
                ribs.set_color(figures.COLOURS[0])
                axis.set_title(f"mode {frame + 1}", fontsize=9)
            else:
                limit = np.abs(field[1]).max() or 1
                ribs.set(array=field[1], cmap="coolwarm", clim=(-limit, limit))
                axis.set_title(f"{test}: last state, true scale (grey: unloaded)", fontsize=9)
            axis.add_collection(ribs)
            axis.autoscale()
            axis.set_aspect("equal")
            axis.set_xlabel(x_label)
            axis.set_ylabel(y_label)
    if field is not None:
        figure.colorbar(ribs, ax=list(axes.flat), label=field[0])
        figure.savefig(target, dpi=140, bbox_inches="tight")
        plt.close(figure)
        print(f"Wrote {target}.")
    else:
        save(figure, target)


def save(figure, target):
    figure.tight_layout()
    figure.savefig(target, dpi=140)
    plt.close(figure)
    print(f"Wrote {target}.")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("run", help="output folder of the experiment laboratory")
    run = parser.parse_args().run
    rows = read_rows(os.path.join(run, "history.csv"))
    if not rows:
        print(f"{run}: there is no history.csv with a record, so this is not the output folder of a run.",
              file=sys.stderr)
        return 2
    folder = os.path.join(run, "figures")
    os.makedirs(folder, exist_ok=True)
    paths = paths_by_test(rows)
    draw_curves(paths, stated_forces(read_rows(os.path.join(run, "table.csv"))),
                os.path.join(folder, "curves.png"))
    for test in paths:
        try:
            draw_piece(run, test, os.path.join(folder, test.replace(" ", "_") + ".png"))
        except (ImportError, FileNotFoundError) as error:
            print(f"{test}: left out, {error}.")
    return 0


if __name__ == "__main__":
    sys.exit(main())
