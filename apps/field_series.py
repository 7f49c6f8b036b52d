"""The fields of a run that were written for ParaView, as arrays.

Reads the series of coupling/output/field_output.h with the HDF5 files that they name:
    clumps.xdmf    points: member spheres; fields `radius` [m], `clump` (number of the stone)
                   and `displacement` [m] of the stone since the first frame
    geogrid.xdmf   lines: beam elements
    contacts.xdmf  lines: from centre to centre of what touches; fields `force` [N] and
                   `kind` (0 two stones, 1 stone and wall, 2 stone and rib); no frame without contacts
In the XDMF files the unit follows the name of a field: "force [N]". Needs h5py.
"""

import os
import xml.etree.ElementTree

# A run that is still writing holds a lock, which must not keep its pictures from being drawn.
os.environ["HDF5_USE_FILE_LOCKING"] = "FALSE"

import h5py
import numpy as np


class Series:
    """A time series of one field: the frames of an XDMF file, whose arrays lie in HDF5 files."""

    def __init__(self, path):
        self.folder = os.path.dirname(path)
        root = xml.etree.ElementTree.parse(path).getroot()
        self.frames = [grid for grid in root.iter("Grid") if grid.find("Time") is not None]

    def __len__(self):
        return len(self.frames)

    def time(self, frame):
        return float(self.frames[frame].find("Time").get("Value"))

    def points(self, frame):
        """Coordinates [m], one row a point."""
        return self.array(self.frames[frame].find("Geometry"))

    def lines(self, frame):
        """Indices of the two end points of every line."""
        return self.array(self.frames[frame].find("Topology")).reshape(-1, 2)

    def attribute(self, frame, name):
        """One value or row a point or line. Raises KeyError when the file has no field of this name, which is
        given without its unit."""
        for attribute in self.frames[frame].iter("Attribute"):
            if attribute.get("Name").partition(" [")[0] == name:
                return self.array(attribute)
        raise KeyError(f"no field {name}")

    def frame_at(self, time):
        """The frame whose time is nearest."""
        return int(np.argmin([abs(self.time(i) - time) for i in range(len(self))]))

    def array(self, element):
        """What `file.h5:/dataset` in an element's DataItem points at."""
        file, dataset = element.find("DataItem").text.strip().split(":")
        with h5py.File(os.path.join(self.folder, file), "r") as fields:
            return fields[dataset][()]


def open_series(run, name):
    """The series of one field, or None where the run wrote none or has no frame yet."""
    path = os.path.join(run, name + ".xdmf")
    if not os.path.isfile(path):
        return None
    series = Series(path)
    return series if len(series) else None


def section_force_of_test(series, frame, test):
    """Name and values of the section force that says most about a laboratory test; None for modes, which have none."""
    fields = {"axial force [N]": ("axial_force", 1), "in-plane moment [N mm]": ("moment_in_plane", 1e3),
              "out-of-plane moment [N mm]": ("moment_out_of_plane", 1e3)}
    if test == "modes":
        return None
    values = {name: scale * series.attribute(frame, field) for name, (field, scale) in fields.items()}
    first = test.split()[0]
    name = {"wide-width": "axial force [N]", "single-rib": "axial force [N]",
            "aperture": "in-plane moment [N mm]",
            "supports": max(values, key=lambda n: np.abs(values[n]).max())}.get(first, "out-of-plane moment [N mm]")
    return name, values[name]
