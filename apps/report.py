#!/usr/bin/python3 -I
"""The page of a finished or running simulation: RUN_DIR/report.html, one file that a browser opens from disk.

    report.py RUN_DIR [--surfaces FILE | --no-surfaces SENTENCE]

Puts data, style and programs (apps/report/) and the libraries three.js and Chart.js, as Debian has them, into one
file. What cannot be shown, for lack of frames, of a package or of a state on disk, is left out, and the page says why.
Ends with 2 when the folder holds no history at all.
"""

import argparse
import json
import os
import sys

HERE = os.path.dirname(os.path.realpath(__file__))
sys.path.insert(0, HERE)
import report_study
import report_text
from report_curves import curves, laboratory
from run_files import InputError, find_result, read_history, read_parameters, read_summary

LIBRARIES = "/usr/share/javascript"
# In this order; what the last ones need comes first.
SCRIPTS = ["unpack.js", "colours.js", "text.js", "charts.js", "copies.js", "stones.js", "ribs.js", "contacts.js", "scene.js",
           "legends.js", "replay.js", "pieces.js", "tools.js", "page.js"]


def library(*names):
    """The text of scripts of Debian's packages, or None where one is not installed."""
    texts = []
    for name in names:
        try:
            with open(os.path.join(LIBRARIES, name), encoding="utf-8") as file:
                texts.append(file.read())
        except OSError:
            return None
    return "\n".join(texts)


def part(name):
    with open(os.path.join(HERE, "report", name), encoding="utf-8") as file:
        return file.read()


def replay_of(run, arguments, parameters, history):
    """The frames, or the sentence that says why there are none."""
    try:
        from report_replay import NoReplay, replay
        from report_pieces import pieces
    except ImportError as error:
        return {"missing": f"The replay needs Debian's package python3-h5py ({error})."}
    try:
        if parameters.get("Experiment") in ("laboratory", "geogrid"):
            return pieces(run)
        return replay(run, parameters, history, arguments.surfaces, arguments.no_surfaces)
    except NoReplay as reason:
        return {"missing": str(reason)}
    except (OSError, KeyError, ValueError, IndexError) as error:
        # The files of a running case may be in the middle of being written.
        return {"missing": f"The frames cannot be read ({type(error).__name__}: {error})."}


def stages_so_far(run):
    try:
        from report_stones import stages
    except ImportError:
        return []
    return stages(run)


def run_page(run, arguments):
    parameters, summary = read_parameters(run), read_summary(run)
    experiment = summary.get("experiment") or parameters.get("Experiment", "pull-out")
    if not summary:
        summary = {"stages": stages_so_far(run)}
    is_laboratory = experiment in ("laboratory", "geogrid")
    history = {} if is_laboratory else read_history(run)
    data = report_text.texts(run, experiment, summary, parameters)
    if is_laboratory:
        data["cards"] = report_study.table("Measured and stated", report_study.read_rows(run, "table.csv"),
                                           ["quantity", "unit", "measured", "stated"])
    data["charts"] = laboratory(run) if is_laboratory else curves(run, experiment, history, summary, parameters)
    data["replay"] = replay_of(run, arguments, parameters, history)
    if "time" in history:
        data["times"] = [float(time) for time in history["time"]]
    return data


def write(run, data):
    """Under a temporary name first, so that a reader never finds half a page."""
    three = library("three/three.min.js", "three/examples/js/controls/OrbitControls.js")
    chart = library("chart.js/chart.min.js")
    if three is None and "missing" not in data["replay"]:
        data["replay"] = {"missing": "The replay needs Debian's package libjs-three."}
    if chart is None:
        data["no_charts"] = "Curves need Debian's package libjs-chart.js."
    use_three = three is not None and "missing" not in data["replay"]
    page = part("page.html")
    for mark, text in (
            ("/*STYLE*/", part("page.css")), ("/*CHART*/", chart or ""), ("/*THREE*/", three if use_three else ""),
            ("/*PROGRAM*/", "\n".join(part(name) for name in SCRIPTS)), ("<!--TITLE-->", report_text.escaped(data["title"])),
            # No tag may end the script that carries the data.
            ("/*DATA*/", json.dumps(data, separators=(",", ":"), allow_nan=False).replace("<", "\\u003c"))):
        before, after = page.split(mark)
        page = before + text + after
    path = os.path.join(run, "report.html")
    try:
        with open(path + ".part", "w", encoding="utf-8", errors="backslashreplace") as file:
            file.write(page)
        os.replace(path + ".part", path)
    except OSError:
        if os.path.exists(path + ".part"):
            os.remove(path + ".part")
        raise
    print(f"Wrote {path}.")
    if data["replay"].get("missing"):
        print(f"It has no replay: {data['replay']['missing']}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("run", metavar="RUN_DIR", help="output folder of interlock run or interlock study")
    parser.add_argument("--surfaces", metavar="FILE", help="surfaces of the stones (apps/stone_surfaces.h)")
    parser.add_argument("--no-surfaces", metavar="SENTENCE", default="", help="why there are none")
    arguments = parser.parse_args()
    for stream in (sys.stdout, sys.stderr):  # names of folders may hold letters that the terminal's encoding lacks
        stream.reconfigure(errors="backslashreplace")
    try:
        is_study = os.path.isfile(os.path.join(arguments.run, "runs.csv"))
        write(arguments.run, report_study.study_page(arguments.run) if is_study else run_page(arguments.run, arguments))
    except InputError as error:
        print(error, file=sys.stderr)
        return 2
    except OSError as error:
        print(f"{error.filename or arguments.run}: {error.strerror}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
