"""What the page of a run says in words and numbers: what it was, results, stages, warnings, inputs, how to cite."""

import html
import os
import re

from run_files import find_result

HERE = os.path.dirname(os.path.realpath(__file__))
# Behind the names of results: what they are in.
UNITS = [("_kN_per_m", "kN/m"), ("_kg_per_m3", "kg/m³"), ("_m_per_s", "m/s"), ("_N_per_m", "N/m"), ("_Pa_per_m", "Pa/m"), ("_deg", "°"),
         ("_mm", "mm"), ("_m", "m"), ("_kg", "kg"), ("_N", "N"), ("_J", "J"), ("_Pa", "Pa"), ("_s", "s")]
MAIN = {"pull-out": ["peak_pull_force_N", "displacement_at_peak_m", "pull_force_at_end_N", "mass_in_box_kg",
                     "largest_stretch_of_a_rib"],
        "heap": ["angle_of_repose_deg", "height_m", "stones"],
        "shear box": ["peak_friction_angle_deg", "residual_friction_angle_deg", "normal_stress_Pa", "porosity"],
        "triaxial": ["peak_friction_angle_deg", "residual_friction_angle_deg", "cell_pressure_Pa", "porosity"]}


def escaped(text):
    return html.escape(str(text))


def result_row(name, value):
    """Name in words, value with its unit: lengths in mm, large forces and stresses in kN and kPa."""
    unit = ""
    for ending, symbol in UNITS:
        if name.endswith(ending):
            name, unit = name[:-len(ending)], symbol
            break
    if isinstance(value, bool):
        value = "yes" if value else "no"
    elif isinstance(value, float):
        if unit == "m" and abs(value) < 1:
            value, unit = 1e3 * value, "mm"
        elif unit in ("N", "Pa") and abs(value) >= (1e3 if unit == "Pa" else 1e4):
            value, unit = 1e-3 * value, "k" + unit
        value = f"{value:.4g}"
    return [name.replace("_", " "), str(value), unit]


def duration(seconds):
    if seconds < 60:
        return f"{seconds:.1f} s"
    return f"{int(seconds // 3600)} h {int(seconds % 3600 // 60)} min" if seconds >= 3600 else \
        f"{int(seconds // 60)} min {int(seconds % 60)} s"


def stage_rows(summary):
    rows, begin = [], 0.0
    for stage in summary.get("stages", []):
        end = begin + stage["simulated_time_s"]
        rows.append([stage["name"], f"{begin:.3f} to {end:.3f} s" if end > begin else "", f"{stage['steps']:,}".replace(",", " "),
                     duration(stage["wall_time_s"])])
        begin = end
    return rows


def read_text(path):
    if not os.path.isfile(path):
        return ""
    with open(path, encoding="utf-8", errors="replace") as file:
        return file.read()


def citation():
    """The sentence to cite, and the file that it is from: beside the folder of the scripts."""
    return read_text(os.path.join(os.path.dirname(HERE), "CITATION.cff"))


def cited(text, summary):
    def entry(name):
        found = re.search(rf'^{name}: *"?(.*?)"?$', text, re.MULTILINE)
        return found.group(1) if found else ""

    if not text:
        return ""
    commit = summary.get("origin", {}).get("commit", "")
    return f"The Interlock developers, {entry('title')}, version {entry('version')}" \
        + (f", commit {commit}" if commit else "") + ". The method is that of J.-F. Ferellec and G. McDowell, A method " \
        "to model realistic particle shape and inertia in DEM, Granular Matter 12 (2010) 459-467, " \
        "doi:10.1007/s10035-010-0205-8."


def identity(summary, parameters):
    """What tells this run from all others."""
    origin = summary.get("origin", {})
    rows = [["date", origin.get("date")], ["state hash", summary.get("state_hash", "").strip("0") and summary["state_hash"]],
            ["hash of the inputs", summary.get("parameters_hash")], ["version", summary.get("version")],
            ["commit", origin.get("commit")], ["compiler", origin.get("compiler")], ["ranks", summary.get("ranks")],
            ["seed of the filling", summary.get("seed")], ["time step", f"{1e6 * summary['time_step_s']:.3g} µs"
                                                           if summary.get("time_step_s") else None],
            ["started from", parameters.get("Start from")]]
    return [[name, str(value)] for name, value in rows if value not in (None, "")]


def energy_rows(summary):
    return [result_row(name if name == "relative_error" or name.endswith("_J") else name + "_J", value)
            for name, value in (summary.get("energy") or {}).items() if isinstance(value, (int, float))]


def texts(run, experiment, summary, parameters):
    results = summary.get("results", {})
    log = read_text(os.path.join(run, "run.log"))
    warnings = list(summary.get("warnings", []))
    finished = "results" in summary
    if not finished:
        warnings = [row[len("warning: "):] for row in log.splitlines() if row.startswith("warning: ")]
    if finished:
        state = f"finished: {summary.get('steps', 0):,} steps in {duration(summary.get('wall_time_s', 0))}".replace(",", " ")
    else:
        stopped = [row for row in log.splitlines() if row.startswith("Stopped: ")]
        state = stopped[-1] if stopped else "not finished: this page shows what there was when it was made"
    main = [result_row(name, results[name]) for name in MAIN.get(experiment, []) if results.get(name) is not None]
    text = citation()
    return {
        "title": f"{experiment.capitalize()}: {os.path.basename(os.path.abspath(run))}", "experiment": experiment, "state": state,
        "finished": finished, "main": main,
        "results": [result_row(name, value) for name, value in results.items() if value is not None],
        "energy": energy_rows(summary), "stages": stage_rows(summary), "warnings": warnings,
        "not_usable": summary.get("not_usable") or find_result(summary, "not_usable_because") or "",
        "identity": identity(summary, parameters), "inputs": read_text(os.path.join(run, "used.prm")),
        "log": log, "cite": cited(text, summary), "citation_file": text,
    }
