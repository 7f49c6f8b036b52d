"""What a run leaves behind, as numbers: history.csv, summary.json, used.prm. Needs NumPy only."""

import csv
import json
import os

import numpy as np

TEXTS = {"run", "state_hash", "version", "commit"}  # columns whose entries may look like numbers


class InputError(Exception):
    """The folder that the user named cannot be drawn; the text is one full sentence."""


def read_history(run):
    """Columns of history.csv as name -> array, names without unit; text columns stay text."""
    path = os.path.join(run, "history.csv")
    if not os.path.isfile(path):
        raise InputError(f"{run}: there is no history.csv, so this is not the output folder of a run.")
    return {name.split("[")[0].strip(): values for name, values in read_table(path).items()}


def read_table(path):
    """Columns of a table as name -> array, names as in its first line; text columns stay text."""
    try:
        with open(path, newline="", encoding="utf-8") as file:
            rows = [row for row in csv.reader(file) if row]
    except OSError as error:
        raise InputError(f"{path}: the table cannot be read: {error.strerror}.") from error
    if len(rows) < 2:
        raise InputError(f"{path}: the file has no record yet.")
    names = rows[0]
    # The last line of a running case may be half written.
    rows = [row for row in rows[1:] if len(row) == len(names)]
    columns = {name: [row[i] for row in rows] for i, name in enumerate(names)}
    return {name: np.array(texts) if name in TEXTS else as_numbers(texts) for name, texts in columns.items()}


def as_numbers(texts):
    try:
        return np.array([float(text) if text else np.nan for text in texts])
    except ValueError:
        return np.array(texts)


def read_summary(run):
    """summary.json as a dictionary, empty while the run has not written it."""
    path = os.path.join(run, "summary.json")
    if not os.path.isfile(path):
        return {}
    with open(path, encoding="utf-8") as file:
        return json.load(file)


def read_parameters(run):
    """used.prm as "Section/Name" -> text, empty where there is none."""
    path = os.path.join(run, "used.prm")
    if not os.path.isfile(path):
        return {}
    parameters, section = {}, ""
    with open(path, encoding="utf-8", errors="replace") as file:
        for line in file:
            word, _, rest = line.strip().partition(" ")
            if word == "subsection":
                section = rest.strip() + "/"
            elif word == "end":
                section = ""
            elif word == "set":
                name, _, value = rest.partition("=")
                parameters[section + name.strip()] = value.strip().strip('"')
    return parameters


def number(parameters, name):
    """An entry as a number; not a number where there is none."""
    try:
        return float(parameters.get(name, ""))
    except ValueError:
        return np.nan


def read_rows(study, name):
    """Rows of a table of a study as dictionaries of texts; none where it has no such table."""
    path = os.path.join(study, name)
    if not os.path.isfile(path):
        return []
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def of_ribs(parameters, name, direction=""):
    """A size of the ribs that run `direction`, along or across: of the product, where the run has one."""
    if "Product/Pitch along" in parameters:
        return number(parameters, f"Product/{name} {direction}" if direction else "Product/" + name)
    return number(parameters, "Geogrid/" + name)


def during_pull(history):
    """The records of the pull: those of its stage where stages are named, else all."""
    stage = history.get("stage")
    if stage is None or stage.dtype.kind != "U" or not np.any(stage == "pull"):
        return history
    return {name: values[stage == "pull"] for name, values in history.items()}


def find_result(summary, name):
    """A value of the summary's results, under its bare name or with a unit behind it."""
    for key, value in summary.get("results", {}).items():
        if key == name or key.startswith(name + "_"):
            return value
    return None


def centred_mean(place, value, length):
    """Mean of `value`, each of which is the mean since the place before it, over `length` around each place.

    Towards the ends the windows become shorter, down to the first and the last value themselves: a window that is
    shifted or cut off on one side lags behind a curve that rises, and halves its initial slope."""
    integral = np.concatenate([[0], np.cumsum(value[1:] * np.diff(place))])
    half = np.minimum(length / 2, np.minimum(place - place[0], place[-1] - place))
    below, above = place - half, place + half
    width = above - below
    mean = np.interp(above, place, integral) - np.interp(below, place, integral)
    return np.where(width > 0, mean / np.where(width > 0, width, 1), value)


def first_words(sentence, most=60):
    """The beginning of a sentence, whole words of it."""
    sentence = sentence.strip().rstrip(".")
    if len(sentence) <= most:
        return sentence
    return sentence[:most].rpartition(" ")[0].rstrip(" ,;:") + " ..."


def unusable_part(summary):
    """From which displacement on the results must not be used [mm] and why; None where all can."""
    start = find_result(summary, "not_usable_from_mm")
    start = summary.get("not_usable_from_mm") if start is None else start
    if start is None:
        return None
    warnings = [str(warning) for warning in summary.get("warnings", [])]
    about_use = [warning for warning in warnings if "usable" in warning or "not to be used" in warning]
    because = find_result(summary, "not_usable_because")
    return float(start), first_words(because or (about_use + warnings + [""])[0])
