"""A case: a parameter file with changes, and its run in this process."""

import atexit
import os
import sys
from collections.abc import Mapping

from . import _native
from .results import Results

__all__ = ["Case"]

atexit.register(_native.stop_mpi)


class Case(Mapping):
    """Entries of a case, name "Section/Entry" -> value, all of them, defaults included.

    Case("quick.prm", {"Geogrid/Rigid": True}) or Case("quick.prm", **{"Geogrid/Rigid": True}) reads the file and
    changes entries as `interlock run quick.prm --set "Geogrid/Rigid=true"` does; relative paths in the changes start at
    the working folder. Everything is checked at once; InputError says all that is wrong. `unusual` takes values that
    look like those of another unit. Values come as float, int, bool, str or tuple of floats."""

    def __init__(self, file, changes=None, *, unusual=False, **entries):
        self.file = os.fspath(file)
        self._unusual = unusual
        self._read({**(changes or {}), **entries})

    def _read(self, changes):
        texts = [f"{name}={_text(value)}" for name, value in changes.items()]
        if self._unusual:
            texts.append("Unusual values=true")
        read = _native.read_case(self.file, texts)
        self._input, self._changes, self._entries = read, changes, read.entries()

    def __getitem__(self, name):
        self._require(name)
        text, unit, allowed, _ = self._entries[name]
        return _value(text, allowed)

    def __setitem__(self, name, value):
        """Changes one entry. Raises InputError, and changes nothing, when the case could not be run with it."""
        self._read({**self._changes, name: value})

    def __iter__(self):
        return iter(self._entries)

    def __len__(self):
        return len(self._entries)

    def __repr__(self):
        changes = "".join(f", {name!r}: {value!r}" for name, value in self._changes.items())
        return f"Case({self.file!r}{', {' + changes[2:] + '}' if changes else ''})"

    def _require(self, name):
        if name not in self._entries:
            nearest = _native.nearest_name(str(name), list(self._entries))
            raise KeyError(f"There is no entry \"{name}\"" +
                           (f"; the nearest known one is \"{nearest}\"." if nearest else "."))

    def describe(self, name):
        """What an entry is, its unit, what is allowed: one text."""
        self._require(name)
        _, unit, allowed, sentence = self._entries[name]
        return f"{name}{' [' + unit + ']' if unit else ''}: {sentence} Allowed: {allowed}."

    @property
    def experiment(self):
        """"pull-out", "heap", "packing", "laboratory", "shear box" or "triaxial"."""
        return self._input.experiment()

    @property
    def text(self):
        """A complete parameter file: what the run leaves as used.prm."""
        return self._input.text()

    def forecast(self):
        """What the run would take, without it, as `interlock check` says: a dict with `clumps`, `spheres`, `time_step`
        [s], `stages` (name, simulated_time [s], steps, processor_time [s]), `memory`, `disk` [bytes], `warnings`."""
        return self._input.forecast()

    def run(self, folder=None, callback=None, *, every=100, force=False, resume=False, quiet=True):
        """Runs the case into `folder` (results/NAME for NAME.prm), as `interlock run` does on one process: the same
        files, digits and state hash. Returns its Results.

        callback   called between two steps with a Moment: `time` [s], `step`, `stage`, `fraction` of the stage,
                   `time_step` [s], and of the n stones `positions`, `velocities`, `forces`, ... as read-only NumPy
                   arrays that look at the simulation's own memory. They are valid during the call only: copy what is
                   to be kept (`moment.positions.copy()`); an array that is kept ends the run with BufferError. When it
                   returns True or "stop", the run keeps its state and ends; `finished` of the results is False then.
                   What it raises ends the run in the same way and comes out of this call. Not called while the run is
                   prepared, nor by the laboratory of geogrids, which has no steps.
        every      steps between two calls, a multiple of 100
        force      remove the results of an earlier run in the folder first
        resume     go on from the checkpoint in the folder; from the beginning when there is none
        quiet      False: print what the program prints

        Raises InputError when nothing was run, RunFailure when the run failed or is not to be used, KeyboardInterrupt
        after Control-C, with the state kept. One run at a time in a process."""
        folder = _native.default_folder(self.file) if folder is None else os.fspath(folder)
        if every < 1 or every % 100:
            raise ValueError(f"every is {every}, but must be a multiple of 100 steps.")
        line = f"case.run({folder!r}, resume=True)"
        stopped = self._input.run(folder, resume, force, line, callback, every, None if quiet else sys.stdout)
        return Results(folder, stopped=stopped)


def _text(value):
    if hasattr(value, "tolist"):  # NumPy's
        value = value.tolist()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (list, tuple)):
        return ", ".join(_text(item) for item in value)
    if isinstance(value, float):
        return repr(value)
    return str(os.fspath(value) if isinstance(value, os.PathLike) else value)


def _value(text, allowed):
    if allowed.startswith("a whole number"):
        return int(text)
    if allowed.startswith("a number"):
        return float(text)
    if allowed.startswith("numbers"):
        return tuple(float(word) for word in text.split(",") if word.strip())
    if allowed == '"true" or "false"':
        return text == "true"
    return text
