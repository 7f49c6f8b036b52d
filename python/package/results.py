"""What a run leaves in its folder. Needs NumPy; frames need h5py; tables need pandas."""

import os
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from . import run_files
from .run_files import InputError

__all__ = ["Results", "Frame", "Frames"]


class Results:
    """The output folder of a run that has ended, was stopped or goes on. Files are read when they are asked for."""

    def __init__(self, folder, stopped=""):
        self.folder = os.fspath(folder)
        self.stopped = stopped  #: why and where a run within Python was stopped, a sentence; else empty
        if not os.path.isfile(os.path.join(self.folder, "used.prm")):
            raise InputError(f"{self.folder}: there is no used.prm, so this is not the output folder of a run.")

    def __repr__(self):
        return f"Results({self.folder!r}{'' if self.finished else ', not finished'})"

    @property
    def finished(self):
        """Whether the run has ended by itself: summary.json is there."""
        return os.path.isfile(os.path.join(self.folder, "summary.json"))

    @property
    def history(self):
        """history.csv: dict of arrays, one number a record, names with units as in the file ("pull_force [N]")."""
        return run_files.read_table(self.path("history.csv"))

    def table(self):
        """history.csv as a pandas DataFrame."""
        return _pandas().DataFrame(self.history)

    @property
    def summary(self):
        """summary.json as a dict; empty while the run has not ended."""
        return run_files.read_summary(self.folder)

    @property
    def parameters(self):
        """used.prm: name "Section/Entry" -> text."""
        return run_files.read_parameters(self.folder)

    @property
    def state_hash(self):
        """16 digits of the whole state at the end; None while the run has not ended."""
        return self.summary.get("state_hash")

    @property
    def log(self):
        """run.log."""
        with open(self.path("run.log"), encoding="utf-8", errors="replace") as file:
            return file.read()

    @property
    def frames(self):
        """The frames that were written for ParaView, as a sequence of Frame; needs h5py."""
        return Frames(self.folder)

    def path(self, name):
        """Of a file in the folder."""
        return os.path.join(self.folder, name)


@dataclass(frozen=True)
class Frame:
    """The stones at one time, ids ascending; only those that are in the box."""

    time: float  #: simulated [s]
    ids: np.ndarray  #: (n,)
    shapes: np.ndarray  #: (n,) number of the shape in Frames.shapes
    masses: np.ndarray  #: (n,) [kg]
    positions: np.ndarray  #: (n, 3) centres of mass [m]
    orientations: np.ndarray  #: (n, 4) body to world (x, y, z, w)
    number: int  #: of the frame
    series: dict  #: name -> field_series.Series, or None: "clumps" (spheres), "geogrid", "contacts"

    def field(self, name, attribute=None):
        """Raw arrays of a series at this time: points (n, 3) [m], or one of its fields ("geogrid", "axial_force").
        None where the series has no frame of this time."""
        series = self.series[name]
        if series is None:
            return None
        frame = series.frame_at(self.time)
        if abs(series.time(frame) - self.time) > 1e-9 + 1e-6 * abs(self.time):
            return None
        return series.points(frame) if attribute is None else series.attribute(frame, attribute)


class Frames(Sequence):
    """Frames in the order of time. Places and attitudes are those that the spheres of the frames have."""

    def __init__(self, folder):
        try:
            from . import field_series, report_stones
        except ImportError as error:
            raise ImportError("Frames are read with h5py, which is not there: apt-get install python3-h5py.") from error
        self._series = {name: field_series.open_series(folder, name) for name in ("clumps", "geogrid", "contacts")}
        if self._series["clumps"] is None:
            raise InputError(f"{folder}: the run has written no frames (Output/Field frames, of a heap "
                             "Output/Frame interval).")
        try:
            self._stones = report_stones.Stones(folder)
        except report_stones.NoReplay as error:
            raise InputError(f"{folder}: {error}") from error

    @property
    def times(self):
        """(frames,) [s]."""
        return np.array([self._series["clumps"].time(i) for i in range(len(self))])

    @property
    def shapes(self):
        """Of the stones: dicts with `name`, `volume` [m3], `centres` (n, 3) in the body frame and `radii` (n,) [m]."""
        return self._stones.shapes

    def __len__(self):
        return len(self._series["clumps"])

    def __getitem__(self, number):
        if isinstance(number, slice):
            return [self[i] for i in range(*number.indices(len(self)))]
        if number < 0:
            number += len(self)
        if not 0 <= number < len(self):
            raise IndexError(f"there are {len(self)} frames")
        stones, clumps = self._stones, self._series["clumps"]
        positions, orientations = stones.poses(clumps, number)
        there = orientations.any(axis=1)
        return Frame(clumps.time(number), stones.ids[there], stones.shape[there], stones.mass[there],
                     positions[there], orientations[there], number, self._series)


def _pandas():
    try:
        import pandas
    except ImportError as error:
        raise ImportError("Tables need pandas, which is not there: apt-get install python3-pandas; the same numbers "
                          "are in dicts of arrays.") from error
    return pandas
