#!/usr/bin/python3 -I
"""Pictures of finished or running triaxial tests of ballast.

    triaxial_figures.py RUN_DIR        curves.png, strength.png, energy.png in RUN_DIR/figures

Reads history.csv, used.prm and summary.json. strength.png needs a finished run. Ends with 2 when the folder
holds no history at all.
"""

import os
import sys

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
import figures  # before Matplotlib, which it sets up
import strength_figures
import matplotlib.pyplot as plt
import numpy as np

# Published strength of railway ballast: label, cell pressure [kPa], friction angle [degrees], how it is known,
# marker. Two values of an angle are those at the two pressures. sin phi = q/(q + 2 s3) where q was given.
PUBLISHED = [
    ("Sun, Indraratna, Nimbalkar 2016, cyclic, survived: a lower bound (derived from its data)", [10], [66.9], "^"),
    ("the same, collapsed at 40 Hz, inertia included (derived from its data)", [30, 60], [55.2, 52.5], "x"),
    # s3 = sigma_n/(1 + sin phi) of normal stresses of 35 and 140 kPa.
    ("Sweta and Hussaini 2018-20, large shear box (abstract; converted)", [18.3, 75.8], [66.5, 58.0], "-s"),
    ("Indraratna et al. 1998, triaxial, latite (from memory, not read again)", [1, 240], [67.0, 46.0], "--"),
]
FILTER = 0.005  # peaks in the summary are those of means over this axial strain


def strength_axes(axes):
    """What every figure of angles over cell pressure has."""
    for (label, pressure, angle, style), colour in zip(PUBLISHED, ("0.2", "0.4", "0.2", "0.6")):
        axes.plot(pressure, angle, style, color=colour, mfc="none", linewidth=1.2, label=label)
    axes.set_xscale("log")
    axes.set_xlim(4, 150)
    axes.set_xticks([5, 10, 20, 30, 60, 100], ["5", "10", "20", "30", "60", "100"])
    axes.minorticks_off()
    axes.set_ylim(0, 80)
    axes.set_xlabel("cell pressure [kPa]")
    axes.set_ylabel("friction angle [degrees]")
    axes.grid(color="0.92")
    axes.set_axisbelow(True)


def degrees_of_ratio(ratio):
    ratio = np.maximum(ratio, 1)
    return np.degrees(np.arcsin((ratio - 1) / (ratio + 1)))


def ratio_of_degrees(angle):
    sine = np.sin(np.radians(np.clip(angle, 0, 85)))
    return (1 + sine) / (1 - sine)


def curves_figure(run, path):
    history = figures.read_history(run)
    if "axial_strain" not in history:
        raise figures.InputError(f"{run}/history.csv: the column axial_strain is missing, so this is not a triaxial "
                                 "test.")
    strain = history["axial_strain"]
    axial = figures.centred_mean(strain, history["axial_stress"], FILTER)
    sides = figures.centred_mean(strain, 0.5 * (history["stress_x"] + history["stress_y"]), FILTER)
    figure, (above, below) = plt.subplots(2, 1, figsize=(7.5, 6.6), sharex=True, layout="constrained")
    above.plot(1e2 * strain, history["stress_ratio"], color=figures.COLOURS[0], linewidth=0.5, alpha=0.45,
               label="mean between records")
    above.plot(1e2 * strain, axial / sides, color=figures.COLOURS[0], linewidth=2,
               label=f"centred mean over {1e2 * FILTER:.2g} %")
    above.set_ylabel("axial over lateral stress [-]")
    above.set_ylim(bottom=1)
    above.secondary_yaxis("right", functions=(degrees_of_ratio, ratio_of_degrees)).set_ylabel("friction angle [degrees]")
    below.plot(1e2 * strain, 1e2 * history["volume_change"], color=figures.COLOURS[1], linewidth=1.6)
    below.set_ylabel("volume change [%], growth is positive")
    below.set_xlabel("axial strain [%]")
    part = figures.unusable_part(figures.read_summary(run))
    for axes in (above, below):
        axes.grid(color="0.92")
        if part is not None:  # the way of the plate is in mm there
            figures.shade_unusable(axes, (0.1 * part[0] / history["height"][0], part[1]), "0.3", "")
    above.legend(fontsize=8, edgecolor="none")
    pressure = figures.number(figures.read_parameters(run), "Load/Cell pressure")
    above.set_title(f"Triaxial test at {1e-3 * pressure:g} kPa ({os.path.basename(os.path.normpath(run))})", fontsize=11)
    figures.save(figure, path)


def strength_figure(run, path):
    strength_figures.strength_figure(run, path, strength_axes, "cell_pressure_Pa")


if __name__ == "__main__":
    sys.exit(strength_figures.draw_all(__doc__.splitlines()[0], curves_figure, strength_figure))
