"""The deformed pieces of a geogrid's laboratory tests, and its modes, for the replay in their page. Needs h5py."""

import csv
import os

import field_series
import numpy as np
from report_replay import packed
from report_stones import NoReplay

MOST_PIECES = 24


def tests_of(run):
    with open(os.path.join(run, "history.csv"), newline="", encoding="utf-8") as file:
        return list(dict.fromkeys(row["test"] for row in csv.DictReader(file)))


def piece(series, frame, test):
    points, lines = series.points(frame), series.lines(frame)
    unloaded = points - series.attribute(frame, "displacement")
    result = {"name": test if test != "modes" else f"mode {frame + 1}", "lines": packed(lines, "u4"),
              "points": packed(points, "f4"), "unloaded": packed(unloaded, "f4")}
    field = field_series.section_force_of_test(series, frame, test)
    if field is not None:
        result["field"], result["values"] = field[0], packed(field[1], "f4")
    return result


def pieces(run):
    found = []
    for test in tests_of(run):
        series = field_series.open_series(run, test.replace(" ", "_"))
        for frame in range(len(series) if series and test == "modes" else 1 if series else 0):
            found.append(piece(series, frame, test))
    if not found:
        raise NoReplay("The run has written no deformed pieces (TEST.xdmf) yet.")
    return {"pieces": found[:MOST_PIECES], "times": list(range(len(found[:MOST_PIECES])))}
