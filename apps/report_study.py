"""The page of a study: curves by point, tables of runs, means, paired differences, parts of the variance.

Shows what `interlock study` has computed; computes nothing itself.
"""

import os

import numpy as np
from line_styles import COLOURS, DASHES
from report_curves import chart, line
from report_text import citation, cited, read_text
from run_files import read_rows

# Shown of each table; all of them are in the files.
MOST_ROWS = 400
ENDS = ("state_hash", "version", "commit")


def short(text):
    try:
        return f"{float(text):.4g}" if text else ""
    except ValueError:
        return text


def curves_by_point(study):
    source = os.path.join(study, "curves.h5")
    if not os.path.isfile(source):
        return [], ""
    try:
        import h5py
    except ImportError as error:
        return [], f"Curves of the study need Debian's package python3-h5py ({error})."
    with h5py.File(source) as file:
        place, force, mean, deviation, counts = (np.array(file[name]) for name in
                                                 ("displacement", "force", "mean", "deviation", "n"))
        points = [name.decode() for name in np.array(file["points"]).ravel()]
        point_of_run = np.array(file["point_of_run"]).ravel().astype(int)
    x, series, styles = 1e3 * place.ravel(), [], list(DASHES)
    for p, name in enumerate(points[:len(COLOURS)]):
        mean[p][counts[p] < counts[p].max()] = np.nan  # a mean of those that are left would jump
        look = (p % len(COLOURS), styles[p % len(styles)])
        series.append(line(f"{name}, mean of {int(counts[p].max())}", x, mean[p], *look, 2.4))
        if np.any(np.isfinite(deviation[p])):
            series += [line(f"{name}, mean {sign} deviation", x, mean[p] + factor * deviation[p], p % len(COLOURS), ":", 1, quiet=True)
                       for sign, factor in (("+", 1), ("-", -1))]
    if len(points) > len(COLOURS):
        series = [line(points[p], x, run, "#888888", "-", 0.7, quiet=True) for run, p in zip(force, point_of_run)]
    drawn = chart("Force and displacement", "displacement [mm]", "force [N]", series)
    drawn["note"] = "Thick: mean of the fillings; dotted: mean plus and minus the standard deviation."
    return [drawn], ""


def table(title, rows, columns, note=""):
    """A card with these columns of the rows, numbers short."""
    if not rows:
        return []
    cells = [[row[name] if isinstance(row.get(name), dict) else
              short(row.get(name, "")).replace("_", " " if name == "measure" else "_") for name in columns]
             for row in rows[:MOST_ROWS]]
    numbers = [c for c in range(len(columns)) if all(is_number(row[c]) for row in cells)]
    if len(rows) > MOST_ROWS:
        note += f" The first {MOST_ROWS} of {len(rows)} rows."
    return [{"title": title, "head": [name.replace("_", " ") for name in columns], "rows": cells, "numbers": numbers,
             "note": note.strip()}]


def is_number(cell):
    if isinstance(cell, dict):
        return False
    try:
        return cell == "" or np.isfinite(float(cell)) or True
    except ValueError:
        return False


def with_links(study, runs):
    """The name of a run leads to its page, where it has one."""
    for row in runs:
        if os.path.isfile(os.path.join(study, "runs", row["run"], "report.html")):
            row["run"] = {"text": row["run"], "link": f"runs/{row['run']}/report.html"}
    return runs


def study_page(study):
    runs = with_links(study, read_rows(study, "runs.csv"))
    names = list(runs[0]) if runs else []
    levels = names[:names.index("status")] if "status" in names else names[:3]
    measures = [name for name in names[len(levels) + 2:] if name not in ENDS]
    done = sum(row.get("status") == "done" for row in runs)
    charts, problem = curves_by_point(study)
    cards = table("Runs", runs, levels + ["status", "reason"] + measures[:8])
    cards += table("Means over the fillings", read_rows(study, "means.csv"),
                   ["point", "measure", "n", "mean", "standard_deviation", "half_width_of_interval"])
    cards += table("Paired differences", read_rows(study, "differences.csv"),
                   ["factor", "level", "less", "measure", "n", "mean_difference", "half_width_of_interval",
                    "mean_of_reference"], "Level less reference in the same fillings; half width of the confidence interval.")
    variance = read_rows(study, "variance.csv")
    cards += table("Parts of the variance", variance, list(variance[0]) if variance else [])
    for each in cards:
        each["wide"] = True
    text = citation()
    return {
        "title": f"Study: {os.path.basename(os.path.abspath(study))}", "experiment": "study",
        "state": f"{done} of {len(runs)} runs are done", "finished": done == len(runs), "main": [], "results": [],
        "energy": [], "stages": [], "warnings": [problem] if problem else [], "not_usable": "", "inputs": "",
        "identity": [["version", ", ".join(sorted({row.get("version", "") for row in runs} - {""}))],
                     ["commit", ", ".join(sorted({row.get("commit", "") for row in runs} - {""}))]],
        "log": read_text(os.path.join(study, "run.log")), "cite": cited(text, {}), "citation_file": text,
        "cards": cards, "charts": charts, "replay": {"missing": ""},
    }
