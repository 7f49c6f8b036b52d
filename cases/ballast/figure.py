#!/usr/bin/python3 -I
"""Shear box or triaxial runs side by side: table, and friction angle over stress beside published values.

    figure.py RUN_DIR... -o FOLDER     strength.csv (one row a run), strength.md, strength.png in FOLDER

Runs that differ in the seed of their filling only are one series: mean and standard deviation. The first finished
run says which test it is; others are left out.
"""

import argparse
import csv
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "apps"))
import figures
import strength_figures
import triaxial_figures
import matplotlib.pyplot as plt
import numpy as np

# Column of the table -> value of the results.
SHEAR_BOX_MEASURES = {
    "peak angle [degrees]": lambda r: r["peak_friction_angle_deg"],
    "peak by load [degrees]": lambda r: r["peak_friction_angle_of_applied_load_deg"],
    "residual angle [degrees]": lambda r: r["residual_friction_angle_deg"],
    "dilation angle [degrees]": lambda r: r["dilation_angle_at_peak_deg"],
    "at [mm]": lambda r: 1e3 * r["displacement_at_peak_m"],
    "secant stiffness [MPa/m]": lambda r: 1e-6 * r["secant_stiffness_Pa_per_m"],
    "volume change [%]": lambda r: 1e2 * r["volume_change_at_end"],
    "porosity [-]": lambda r: r["porosity"],
}
TRIAXIAL_MEASURES = {
    "peak angle [degrees]": lambda r: r["peak_friction_angle_deg"],
    "residual angle [degrees]": lambda r: r["residual_friction_angle_deg"],
    "dilation angle [degrees]": lambda r: r["dilation_angle_at_peak_deg"],
    "at [%]": lambda r: 1e2 * r["strain_at_peak"],
    "E50 [MPa]": lambda r: 1e-6 * r["secant_stiffness_Pa"],
    "volume change [%]": lambda r: 1e2 * r["volume_change_at_end"],
    "porosity [-]": lambda r: r["porosity"],
    "porosity at the end [-]": lambda r: r["porosity_at_end"],
}
# Experiment -> stress that was asked for in the results, its name in the table, measures, axes of the figure.
TESTS = {
    "shear box": ("normal_stress_Pa", "normal stress [kPa]", SHEAR_BOX_MEASURES, strength_figures.strength_axes),
    "triaxial": ("cell_pressure_Pa", "cell pressure [kPa]", TRIAXIAL_MEASURES, triaxial_figures.strength_axes),
}


def filling_of(test, parameters):
    """Its name in run.sh."""
    if figures.number(parameters, "Filling/Stone friction") < 0:
        return "loose"
    return "tamped" if test == "triaxial" and figures.number(parameters, "Load/Compaction stress") > 0 else "dense"


def read_runs(folders):
    """The experiment, and one dictionary a finished run: what it is, and its measures; other runs are named."""
    rows, test = [], None
    for folder in folders:
        summary, parameters = figures.read_summary(folder), figures.read_parameters(folder)
        experiment = summary.get("experiment")
        if experiment not in TESTS or "peak_friction_angle_deg" not in summary["results"]:
            print(f"Left out {folder}: there is no summary.json of a finished {test or 'strength test'}.")
            continue
        test = test or experiment
        if experiment != test:
            print(f"Left out {folder}: it is a {experiment} test, the others are {test} tests.")
            continue
        results = summary["results"]
        row = {"run": os.path.basename(os.path.normpath(folder)), "seed": summary["seed"],
               "spheres": round(results["spheres_per_stone"]),
               "friction": figures.number(parameters, "Contact/Stone friction"),
               "filling": filling_of(test, parameters),
               "stress [kPa]": 1e-3 * results[TESTS[test][0]],
               "not usable from [mm]": results.get("not_usable_from_mm", "")}
        row.update({name: measure(results) for name, measure in TESTS[test][2].items()})
        rows.append(row)
    return test, rows


def series_of(rows):
    """(spheres, friction, filling) -> normal stress -> rows. The mean number of spheres follows from which stones
    were poured: neighbours are one series."""
    series = {}
    for row in rows:
        spheres = next((key[0] for key in series if abs(key[0] / row["spheres"] - 1) < 0.1), row["spheres"])
        key = (spheres, row["friction"], row["filling"])
        series.setdefault(key, {}).setdefault(row["stress [kPa]"], []).append(row)
    return series


def mean_and_deviation(rows, name):
    values = np.array([row[name] for row in rows], dtype=float)
    return values.mean(), values.std(ddof=1) if len(values) > 1 else np.nan


def write_tables(test, rows, series, folder):
    stress_name, measures = TESTS[test][1:3]
    with open(os.path.join(folder, "strength.csv"), "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, fieldnames=list(rows[0]))
        writer.writeheader()
        writer.writerows(rows)
    lines = [f"| spheres | friction | filling | {stress_name} | fillings | " + " | ".join(measures) + " |",
             "|" + "---|" * (5 + len(measures))]
    for (spheres, friction, filling), points in sorted(series.items()):
        for stress, members in sorted(points.items()):
            cells = []
            for name in measures:
                mean, deviation = mean_and_deviation(members, name)
                digits = 3 if name.startswith("porosity") else 1
                cells.append(f"{mean:.{digits}f}" +
                             ("" if np.isnan(deviation) else f" ± {deviation:.{digits}f}"))
            lines.append(f"| {spheres} | {friction:g} | {filling} | {stress:g} | {len(members)} | " +
                         " | ".join(cells) + " |")
    lines += differences(series, [name for name in measures if name.endswith("angle [degrees]") or "by load" in name])
    with open(os.path.join(folder, "strength.md"), "w", encoding="utf-8") as file:
        file.write("\n".join(lines) + "\n")
    print("\n".join(lines))


# Student's t for intervals of 95 %, by the number of values.
STUDENT = {2: 12.706, 3: 4.303, 4: 3.182, 5: 2.776, 6: 2.571, 7: 2.447, 8: 2.365, 9: 2.306, 10: 2.262}


def differences(series, names):
    """Lines of a table: how series differ from the one that most others differ from in one respect, paired by the
    seeds of the fillings; of each filling the mean over the stresses. With intervals of 95 %."""
    def one_apart(a, b):
        return sum(x != y for x, y in zip(a, b)) == 1

    reference = max(series, key=lambda key: sum(one_apart(key, other) for other in series))
    lines = []
    for key in sorted(series):
        if not one_apart(key, reference):
            continue
        by_seed = {}
        for stress in set(series[key]) & set(series[reference]):
            there = {row["seed"]: row for row in series[reference][stress]}
            for row in series[key][stress]:
                if row["seed"] in there:
                    by_seed.setdefault(row["seed"], []).append([row[name] - there[row["seed"]][name] for name in names])
        values = np.array([np.mean(pairs, axis=0) for pairs in by_seed.values()])
        if len(values) not in STUDENT:
            continue
        half = STUDENT[len(values)] * values.std(axis=0, ddof=1) / np.sqrt(len(values))
        lines.append("| {} | {:g} | {} | ".format(*key) + f"{len(values)} | " +
                     " | ".join(f"{mean:+.1f} ± {h:.1f}" for mean, h in zip(values.mean(axis=0), half)) + " |")
    if not lines:
        return []
    return ["", "Differences from {} spheres, friction {:g}, {}, in the same fillings; 95 % intervals:".format(*reference), "",
            "| spheres | friction | filling | fillings | " + " | ".join(names) + " |",
            "|" + "---|" * (4 + len(names))] + lines


def draw(series, strength_axes, path):
    figure, axes = plt.subplots(figsize=(8.5, 7.5), layout="constrained")
    strength_axes(axes)
    for i, ((spheres, friction, filling), points) in enumerate(sorted(series.items())):
        stresses = sorted(points)
        colour = figures.COLOURS[i % len(figures.COLOURS)]
        shift = 1 + 0.02 * (i - len(series) / 2)  # so that bars do not hide each other
        for name, marker, text in (("peak angle [degrees]", "o", "peak"),
                                   ("residual angle [degrees]", "v", "last fifth")):
            mean, deviation = np.transpose([mean_and_deviation(points[s], name) for s in stresses])
            axes.errorbar(shift * np.array(stresses), mean, np.nan_to_num(deviation), color=colour, marker=marker,
                          mfc=colour if text == "peak" else "none", linewidth=1, capsize=3,
                          linestyle="-" if text == "peak" else ":",
                          label=f"{spheres} spheres, friction {friction:g}, {filling}: {text}")
    axes.legend(fontsize=7, edgecolor="none", loc="upper center", bbox_to_anchor=(0.5, -0.1), ncol=2)
    figures.save(figure, path)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("runs", nargs="+", metavar="RUN_DIR")
    parser.add_argument("-o", "--output", required=True, metavar="FOLDER")
    arguments = parser.parse_args()
    test, rows = read_runs(arguments.runs)
    if not rows:
        print("None of the runs is finished.", file=sys.stderr)
        return 2
    series = series_of(rows)
    write_tables(test, rows, series, arguments.output)
    draw(series, TESTS[test][3], os.path.join(arguments.output, "strength.png"))
    return 0


if __name__ == "__main__":
    sys.exit(main())
