#!/usr/bin/python3 -I
"""Pictures of finished or running strength tests of ballast (shear box).

    strength_figures.py RUN_DIR        curves.png, strength.png, energy.png in RUN_DIR/figures

Reads history.csv, used.prm and summary.json. strength.png needs a finished run. Ends with 2 when the folder
holds no history at all.
"""

import argparse
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
import figures  # before Matplotlib, which it sets up
import matplotlib.pyplot as plt
import numpy as np

# Published strength of railway ballast: label, normal stress [kPa], friction angle [degrees], how it is known,
# marker. Two values of an angle are those at the two stresses.
PUBLISHED = [
    ("Sweta and Hussaini 2018-20, large shear box, granite, 2.5-10 mm/min (abstract)",
     [35, 140], [66.5, 58.0], "-s"),
    # Survived 490,000 cycles at q = 230 kPa and a cell pressure of 10 kPa; sin phi = q/(q + 2 s3), and the normal
    # stress on the plane of failure is s3 (1 + sin phi).
    ("Sun, Indraratna, Nimbalkar 2016, cyclic triaxial, a lower bound (derived from its data)",
     [19.2], [66.9], "^"),
    ("Indraratna et al. 1998, triaxial, latite (from memory, not read again)", [1, 240], [67.0, 46.0], "--"),
]
# The filter of the summary: means over this share of a mean stone, whose size a running test has not told yet [m].
FILTER_SHARE, USUAL_STONE = 0.05, 0.035


def draw_published(axes):
    for (label, stress, angle, style), colour in zip(PUBLISHED, ("0.2", "0.2", "0.6")):
        axes.plot(stress, angle, style, color=colour, mfc="none", linewidth=1.2, label=label)


def strength_axes(axes):
    """What every figure of angles over normal stress has."""
    draw_published(axes)
    axes.set_xscale("log")
    axes.set_xlim(1, 300)
    axes.set_xticks([1, 2, 5, 10, 20, 50, 100, 200], ["1", "2", "5", "10", "20", "50", "100", "200"])
    axes.set_ylim(20, 85)
    axes.set_xlabel("normal stress on the plane [kPa]")
    axes.set_ylabel("friction angle, atan(shear/normal force) [degrees]")
    axes.grid(color="0.92")
    axes.set_axisbelow(True)


def curves_figure(run, path):
    history = figures.read_history(run)
    if "shear_force" not in history:
        raise figures.InputError(f"{run}/history.csv: the column shear_force is missing, so this is not a shear "
                                 "box test.")
    place = history["displacement"]
    size = figures.find_result(figures.read_summary(run), "mean_stone_size") or USUAL_STONE
    length = FILTER_SHARE * size
    shear, normal = (figures.centred_mean(place, history[name], length)
                     for name in ("shear_force", "normal_force"))
    figure, (above, below) = plt.subplots(2, 1, figsize=(7.5, 6.6), sharex=True, layout="constrained")
    with np.errstate(divide="ignore", invalid="ignore"):
        above.plot(1e3 * place, history["friction_ratio"], color=figures.COLOURS[0], linewidth=0.5, alpha=0.45,
                   label="mean between records")
        above.plot(1e3 * place, shear / normal, color=figures.COLOURS[0], linewidth=2,
                   label=f"centred mean over {1e3 * length:.2g} mm")
    above.set_ylabel("shear over normal force [-]")
    above.set_ylim(bottom=0)
    degrees = above.secondary_yaxis("right", functions=(lambda ratio: np.degrees(np.arctan(ratio)),
                                                        lambda angle: np.tan(np.radians(np.clip(angle, 0, 85)))))
    degrees.set_ylabel("friction angle [degrees]")
    below.plot(1e3 * place, 1e3 * history["dilation"], color=figures.COLOURS[1], linewidth=1.6)
    below.set_ylabel("rise of the plate [mm]")
    below.set_xlabel("displacement of the lower half [mm]")
    part = figures.unusable_part(figures.read_summary(run))
    for axes in (above, below):
        axes.grid(color="0.92")
        if part is not None:
            figures.shade_unusable(axes, part, "0.3", "")
    above.legend(fontsize=8, edgecolor="none")
    stress = figures.number(figures.read_parameters(run), "Load/Normal stress")
    above.set_title(f"Shear box at {1e-3 * stress:g} kPa ({os.path.basename(os.path.normpath(run))})", fontsize=11)
    figures.save(figure, path)


def strength_figure(run, path, draw_axes=strength_axes, place="mean_normal_stress_Pa"):
    """Peak and residual angle over the stress `place` of the results, on axes with what is published."""
    results = figures.read_summary(run).get("results", {})
    if "peak_friction_angle_deg" not in results:
        print(f"Left out {path}: the run is not finished.")
        return
    figure, axes = plt.subplots(figsize=(7.5, 4.8), layout="constrained")
    draw_axes(axes)
    stress = 1e-3 * results[place]
    axes.plot(stress, results["peak_friction_angle_deg"], "o", color=figures.COLOURS[0], label="this run, peak")
    axes.plot(stress, results["residual_friction_angle_deg"], "o", color=figures.COLOURS[0], mfc="none",
              label="this run, last fifth of the way")
    axes.legend(fontsize=8, edgecolor="none", loc="lower right")
    figures.save(figure, path)


def draw_all(title, curves, strength):
    """The figures of the folder on the command line; returns the exit code."""
    parser = argparse.ArgumentParser(description=title)
    parser.add_argument("run", metavar="RUN_DIR", help="output folder of interlock run")
    run = parser.parse_args().run
    folder = os.path.join(run, "figures")
    try:
        curves(run, os.path.join(folder, "curves.png"))
        strength(run, os.path.join(folder, "strength.png"))
        figures.energy_figure(run, os.path.join(folder, "energy.png"))
    except figures.InputError as error:
        print(error, file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(draw_all(__doc__.splitlines()[0], curves_figure, strength_figure))
