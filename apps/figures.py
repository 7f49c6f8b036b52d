#!/usr/bin/python3 -I
"""Pictures of finished or running pull-out tests.

    figures.py RUN_DIR                         all figures of one run, in RUN_DIR/figures
    figures.py RUN_DIR OTHER_RUN_DIR... -o FILE
               [--label TEXT]...               force over displacement of several runs in one figure

Reads history.csv, used.prm and summary.json of each run and, where there are any, the fields written for
ParaView. A figure whose input is absent is left out with a sentence that says so. Ends with 2 when a
folder holds no history at all.
"""

import argparse
import os
import sys
import textwrap

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
import plain_matplotlib  # before Matplotlib
import matplotlib.pyplot as plt
import numpy as np
from line_styles import COLOURS, ENERGIES, STYLES
from run_files import (InputError, centred_mean, during_pull, find_result, number, of_ribs, read_history,
                       read_parameters, read_summary, unusable_part)

# The thick line: the force is averaged over so much displacement [m].
MEAN_LENGTH = 1e-3

LABORATORY = "laboratory, 10 mm/s, Ferellec and McDowell 2010"
# Plateau of the measured pull-out force by surcharge, read from the text of the paper [N].
LABORATORY_PLATEAU = {0: 1000.0, 500: 2500.0}
# What the laboratory tested, as far as used.prm says it: section/name -> value, to 1 %.
LABORATORY_CASE = {
    "Box/Length": 0.4, "Box/Width": 0.2, "Box/Height": 0.3,
    "Geogrid/Apertures along": 6, "Geogrid/Apertures across": 3,
}
# Its geogrid is a product of 30 kN/m with this pitch [m] that bears some 11 kN/m at 2 % strain: stiffness [N/m], to
# 20 %. It was pulled at 10 mm/s; a pull many times faster is not to be held against it.
LABORATORY_PITCH, LABORATORY_STIFFNESS, LABORATORY_FASTEST = 0.065, 550e3, 0.015


def title_of(run, summary):
    rigid = find_result(summary, "rigid")
    kind = "" if rigid is None else ("rigid geogrid" if rigid else "flexible geogrid")
    name = os.path.basename(os.path.normpath(run))
    return f"{kind} ({name})" if kind else name


def geogrid_width(parameters):
    """From outer edge to outer edge [m]; not a number where the run does not say."""
    cut = number(parameters, "Geogrid/Cut width")
    if cut > 0:
        return cut
    apertures, pitch = number(parameters, "Geogrid/Apertures across"), of_ribs(parameters, "Pitch across")
    return apertures * pitch + of_ribs(parameters, "Rib width", "along")


def geogrid_stiffness(parameters):
    """Force per width over strain along the pull, at 2 % strain or of linear ribs [N/m]."""
    stiffness = number(parameters, "Product/Stiffness at 2 % along")
    if stiffness > 0:
        return stiffness
    modulus, width, thickness = (of_ribs(parameters, name, "along")
                                 for name in ("Youngs modulus", "Rib width", "Rib thickness"))
    return modulus * width * thickness / of_ribs(parameters, "Pitch across")


def surcharge_of_laboratory(parameters):
    """The surcharge [N] of the paper's laboratory test that this run repeats; None where it is another case.

    It must be the box and the geogrid of LABORATORY_CASE, a flexible one must be about as stiff as the
    laboratory's, the pull about as slow, and the surcharge one of the paper's. A run that has no used.prm may
    be anything and is not held against the laboratory."""
    for name, value in LABORATORY_CASE.items():
        if not abs(number(parameters, name) / value - 1) < 0.01:
            return None
    if parameters.get("Geogrid/Lattice file") or parameters.get("Product/Pattern", "biaxial") != "biaxial":
        return None
    for name in ("Pitch along", "Pitch across"):
        if not abs(of_ribs(parameters, name) / LABORATORY_PITCH - 1) < 0.01:
            return None
    if not number(parameters, "Pull/Speed") <= LABORATORY_FASTEST:
        return None
    if parameters.get("Geogrid/Rigid") != "true":
        if not abs(geogrid_stiffness(parameters) / LABORATORY_STIFFNESS - 1) < 0.2:
            return None
    return next((load for load in LABORATORY_PLATEAU if abs(number(parameters, "Surcharge/Force") - load) < 1), None)


def draw_force(axes, history, colour, style, label):
    """Pull force over displacement: thin the means between records, thick the mean over a millimetre."""
    pull = during_pull(history)
    place, force = pull["displacement"], pull["pull_force"]
    # A mean between two records belongs to the middle between them; the first one has none before it.
    middle = np.concatenate([place[:1], 0.5 * (place[1:] + place[:-1])])
    axes.plot(1e3 * middle, force, color=colour, linewidth=0.5, alpha=0.45)
    axes.plot(1e3 * place, centred_mean(place, force, MEAN_LENGTH), color=colour, linestyle=style, linewidth=2.0,
              label=label)


def explain_lines(axes):
    """Legend entries for thin and thick lines, in no run's colour."""
    axes.plot([], [], color="0.4", linewidth=0.5, label="thin: mean between records")
    axes.plot([], [], color="0.4", linewidth=2.0,
              label=f"thick: centred mean over {1e3 * MEAN_LENGTH:g} mm, shorter at the ends")


def shade_unusable(axes, part, colour, run):
    """Grey from where on the results are not to be used, to the end; `run` in front where there are several."""
    start, reason = part
    label = "not to be used" + (": " + reason if reason else "")
    axes.axvspan(start, max(start, axes.get_xlim()[1]), facecolor=colour, alpha=0.15, hatch="//", edgecolor=colour,
                 linewidth=0, zorder=0, label=f"{run}, {label}" if run else label)


def mark_wedge(axes, summary, colour, run):
    """A line where a stone was first found wedged, and in the legend which one, between what; `run` in front of it."""
    stone, start = find_result(summary, "wedged_stone"), find_result(summary, "wedged_from")
    if stone is None or start is None:
        return
    text = textwrap.fill(f"{run + ', ' if run else ''}wedged from {float(start):.1f} mm on: {stone}", 62)
    axes.axvline(float(start), color=colour, linewidth=1.0, linestyle=(0, (1, 1)), label=text)


def draw_laboratory(axes, drawn):
    """Dotted line at the measured plateau of each of these surcharges [N]."""
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
    several, unusable = len(runs) > 1, []
    parameters = [read_parameters(run) for run in runs]
    for i, run in enumerate(runs):
        history, summary = read_history(run), read_summary(run)
        if "displacement" not in history or "pull_force" not in history:
            raise InputError(f"{run}/history.csv: the columns displacement and pull_force are missing, "
                             "so this is not a pull-out test.")
        label = labels[i] if i < len(labels) else title_of(run, summary)
        colour, style = COLOURS[i % len(COLOURS)], STYLES[i % len(STYLES)]
        draw_force(axes, history, colour, style, label if several else None)
        part = unusable_part(summary)
        if part is not None:
            unusable.append((part, colour if several else "0.3", label if several else ""))
        mark_wedge(axes, summary, colour if several else "0.3", label if several else "")
    axes.set_xlim(left=0, right=axes.dataLim.x1 or None)
    for part, colour, label in unusable:
        shade_unusable(axes, part, colour, label)
    explain_lines(axes)
    # Only where every run repeats the paper's test: a line that holds for one run would be read for all.
    surcharges = [surcharge_of_laboratory(each) for each in parameters]
    if with_laboratory and None not in surcharges:
        draw_laboratory(axes, sorted(set(surcharges)))
    axes.set_xlabel("displacement of the pulled edge [mm]")
    axes.set_ylabel("pull-out force [N]")
    axes.set_ylim(bottom=min(0.0, axes.get_ylim()[0]))
    axes.grid(color="0.92")
    axes.set_axisbelow(True)
    widths = [geogrid_width(each) for each in parameters]
    if np.ptp(widths) < 1e-6:  # neither unknown nor different
        width = widths[0]
        right = axes.secondary_yaxis("right", functions=(lambda force: 1e-3 * force / width,
                                                         lambda line_force: 1e3 * line_force * width))
        right.set_ylabel(f"force over the geogrid's width of {1e3 * width:.0f} mm [kN/m]")
    axes.legend(loc="best", fontsize=8, edgecolor="none", framealpha=0.8)
    if not several:
        text = labels[0] if labels else title_of(runs[0], read_summary(runs[0]))
        axes.set_title("Pull-out test, " + text, fontsize=11)
    save(figure, path)


def energy_figure(run, path):
    """Change of every ledger entry since the first record; entries too small to be seen are left out."""
    history = read_history(run)
    entries = {name[len("energy_"):]: values - values[0] for name, values in history.items()
               if name.startswith("energy_") and not name.startswith("energy_interface")
               and name != "energy_relative_error" and values.dtype.kind == "f"}
    if not entries or "time" not in history:
        print(f"Left out {path}: history.csv has no energy_* columns.")
        return
    figure, axes = plt.subplots(figsize=(8.5, 4.8), layout="constrained")
    swing = {name: np.nanmax(np.abs(values)) for name, values in entries.items()}
    shown = [name for name in entries if swing[name] > 0.005 * max(swing.values())]
    for name in shown:
        colour, style = ENERGIES.get(name, ("0.5", "-"))
        axes.plot(history["time"], entries[name], linewidth=1.4, color=colour, linestyle=style,
                  label=name.replace("_", " "))
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
                        help="leave out the laboratory's plateau, which is drawn where box, geogrid, speed and "
                             "surcharge are the paper's")
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
