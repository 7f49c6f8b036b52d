"""The curves in the page of a run, by experiment: what page.js draws with Chart.js. Needs NumPy only.

A chart is {title, x, y: texts of the axes; note; series; time, place: where on x each record's time is, so that the slider
can mark it; from, why: the part that is not to be used}. A series is {label, x, y, colour, dash, width, points, quiet: not in
the legend}.
Units are those of the axes.
"""

import csv
import os

import numpy as np
from line_styles import COLOURS, DASHES, ENERGIES
from run_files import centred_mean, during_pull, find_result, number, unusable_part

MOST_ROWS = 1500  # more points than a chart has pixels


def digits(values):
    """Five digits, nothing where there is no number."""
    return [float(f"{v:.5g}") if np.isfinite(v) else None for v in np.asarray(values, dtype=float)]


def line(label, x, y, colour=0, dash="-", width=2.0, points=False, quiet=False):
    step = int(np.ceil(len(x) / MOST_ROWS)) or 1
    colour = COLOURS[colour] if isinstance(colour, int) else colour
    return {"label": label, "x": digits(x[::step]), "y": digits(y[::step]), "width": width, "points": points, "quiet": quiet,
            "colour": "ink" if colour == "#000000" else colour, "dash": DASHES.get(dash, dash)}


def chart(title, x, y, series, history=None, place=None, unusable=None):
    result = {"title": title, "x": x, "y": y, "series": series}
    if history is not None and "time" in history:
        step = int(np.ceil(len(place) / MOST_ROWS)) or 1
        result["time"] = history["time"][::step].tolist()
        result["place"] = digits(place[::step])
    if unusable is not None:
        result["from"], result["why"] = unusable
    return result


def middles(place):
    """A mean between two records belongs to the middle between them; the first one has none before it."""
    return np.concatenate([place[:1], 0.5 * (place[1:] + place[:-1])])


def thin_and_thick(name, place, x, values, length, scale, text):
    """Means between records, and their centred mean over `length` of `place`."""
    return [line(f"{name}, mean between records", middles(x), values, 0, width=0.7),
            line(f"{name}, centred mean over {text}", x, scale(centred_mean(place, values, length)), 0, width=2.4)]


def same(values):
    return values


def ledger(history, x, label, unusable=None):
    """Change of every entry since the first record, of those that can be seen."""
    entries = {name[len("energy_"):]: values - values[0] for name, values in history.items()
               if name.startswith("energy_") and not name.startswith("energy_interface")
               and name != "energy_relative_error" and values.dtype.kind == "f"}
    swing = {name: np.nanmax(np.abs(values)) for name, values in entries.items()}
    largest = max(swing.values(), default=0)
    series = [line(name.replace("_", " "), x, values, *ENERGIES.get(name, ("#777777", "-")), width=1.6)
              for name, values in entries.items() if swing[name] > 0.005 * largest]
    return [chart("Energy ledger", label, "change since the first record [J]", series, history, x, unusable)] \
        if series else []


def pull_out(run, history, summary, parameters):
    history = during_pull(history)
    if not {"displacement", "pull_force"} <= history.keys():
        return []
    u, unusable, label = history["displacement"], unusable_part(summary), "displacement of the pulled edge [mm]"
    x = 1e3 * u
    charts = [chart("Force and displacement", label, "pull-out force [N]",
                    thin_and_thick("force", u, x, history["pull_force"], 1e-3, same, "1 mm"), history, x, unusable)]
    charts += ledger(history, x, label, unusable)
    geogrid = []
    if "rear_displacement" in history:
        rear = 1e3 * (history["rear_displacement"] - history["rear_displacement"][0])
        geogrid = [line("pulled edge", x, x, "#000000", ":"), line("rear edge", x, rear, 1)]
    if geogrid:
        charts.append(chart("Motion of the geogrid", label, "displacement [mm]", geogrid, history, x))
    if "largest_axial_force" in history:
        charts.append(chart("Largest axial force in a rib", label, "force [N]",
                            [line("largest axial force", x, history["largest_axial_force"], 2)], history, x, unusable))
    return charts


def heap(run, history, summary, parameters):
    time = history["time"]
    charts = profile(run, summary)
    for name, scale, title, unit in (("height", 1e3, "Height of the heap", "height [mm]"),
                                     ("stones", 1, "Stones that have been dropped", "stones [-]"),
                                     ("kinetic_energy", 1, "Kinetic energy", "energy [J]")):
        if name in history:
            charts.append(chart(title, "time [s]", unit, [line(title, time, scale * history[name])], history, time))
    return charts + ledger(history, time, "time [s]")


def profile(run, summary):
    path = os.path.join(run, "profile.csv")
    if not os.path.isfile(path):
        return []
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.reader(file))[1:]
    series = []
    for sector in dict.fromkeys(row[0] for row in rows):
        x, y = (1e3 * np.array([float(row[c]) for row in rows if row[0] == sector]) for c in (1, 2))
        whole = sector == "all"
        series.append(line("all azimuths" if whole else "one of 8 sectors", x, y, 0 if whole else "#888888",
                           "-" if whole else ":", 2.4 if whole else 0.9, quiet=not whole and sector != "0"))
    angle = find_result(summary, "angle_of_repose_deg")
    title = "Profile" + (f", angle of repose {angle:.1f} degrees" if angle else "")
    return [chart(title, "distance from the centroid in plan [mm]", "mean height of the surface [mm]", series)]


def shear_box(run, history, summary, parameters):
    if "shear_force" not in history:
        return []
    u, unusable = history["displacement"], unusable_part(summary)
    x, label = 1e3 * u, "displacement of the lower half [mm]"
    length = 0.05 * (find_result(summary, "mean_stone_size") or 0.035)
    with np.errstate(divide="ignore", invalid="ignore"):
        mean = centred_mean(u, history["shear_force"], length) / centred_mean(u, history["normal_force"], length)
    return [
        chart("Strength", label, "shear over normal force [-]",
              [line("mean between records", middles(x), history["friction_ratio"], 0, width=0.7),
               line(f"centred mean over {1e3 * length:.2g} mm", x, mean, 0, width=2.4)], history, x, unusable),
        chart("Dilation", label, "rise of the plate [mm]", [line("rise", x, 1e3 * history["dilation"], 1)],
              history, x, unusable)] + ledger(history, x, label, unusable)


def triaxial(run, history, summary, parameters):
    if "axial_strain" not in history:
        return []
    strain, part = history["axial_strain"], unusable_part(summary)
    unusable = part and (0.1 * part[0] / history["height"][0], part[1])  # the way of the plate is in mm there
    x, label = 1e2 * strain, "axial strain [%]"
    axial, sides = history["axial_stress"], 0.5 * (history["stress_x"] + history["stress_y"])
    mean = centred_mean(strain, axial, 0.005) / centred_mean(strain, sides, 0.005)
    return [
        chart("Strength", label, "axial over lateral stress [-]",
              [line("mean between records", middles(x), history["stress_ratio"], 0, width=0.7),
               line("centred mean over 0.5 %", x, mean, 0, width=2.4)], history, x, unusable),
        chart("Volume change", label, "volume change [%], growth is positive",
              [line("volume change", x, 1e2 * history["volume_change"], 1)], history, x, unusable)
    ] + ledger(history, x, label, unusable)


def laboratory(run):
    """Load over deformation of each test, those of one kind together, with what the data sheet states."""
    with open(os.path.join(run, "history.csv"), newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    table = os.path.join(run, "table.csv")
    stated = {}
    if os.path.isfile(table):
        with open(table, newline="", encoding="utf-8") as file:
            for row in csv.DictReader(file):
                parts = row["quantity"].split(", ")
                if len(parts) == 3 and parts[2].startswith("force at") and row["stated"]:
                    stated.setdefault(f"{parts[0]} {parts[1]}", []).append(
                        (float(parts[2].split()[2]), float(row["stated"])))
    kinds = {}
    for row in rows:
        kinds.setdefault((row["deformation_name"], row["load_name"]), {}).setdefault(row["test"], []).append(
            (float(row["deformation"]), float(row["load"])))
    charts = []
    for (deformation, load), tests in kinds.items():
        percent, kilo = deformation.startswith("strain"), load.endswith("[N/m]")
        series = []
        for k, (test, path) in enumerate(tests.items()):
            x, y = np.array(path).T * np.array([[100 if percent else 1], [1e-3 if kilo else 1]])
            series.append(line(test, x, y, k % len(COLOURS), list(DASHES)[k % len(DASHES)]))
            if test in stated:
                series.append(line("data sheet, " + test, *np.array(stated[test]).T, k % len(COLOURS), points=True))
        charts.append(chart(", ".join(tests), "strain [%]" if percent else deformation.replace("_", " "),
                            "force per width [kN/m]" if kilo else load.replace("_", " "), series))
    return charts


BY_EXPERIMENT = {"pull-out": pull_out, "heap": heap, "shear box": shear_box, "triaxial": triaxial}


def curves(run, experiment, history, summary, parameters):
    draw = BY_EXPERIMENT.get(experiment)
    if draw is None:
        return ledger(history, history["time"], "time [s]") if "time" in history else []
    return draw(run, history, summary, parameters)
