"""Where the walls of a run are in each frame, for the replay in its page. Needs h5py.

A state on disk has the walls as they were then. Walls that move keep their shape: in other frames they are shifted along
their normals to where stones touch them, and the lower half of a shear box by its displacement.
"""

import os

import h5py
import numpy as np
from report_stones import STATES

WALLS = "state/world/engine/walls"


def read_walls(run):
    """Names, ids and corners [m] (walls x 4 x 3) of the newest state."""
    for state in STATES:
        path = os.path.join(run, state)
        if not os.path.isfile(path):
            continue
        try:
            with h5py.File(path, "r") as file:
                group = file[WALLS]
                corner, one, two = (group[name][:] for name in ("corner", "edge1", "edge2"))
                return (group["name"].asstr()[:].ravel().tolist(), group["id"][:].ravel().astype(int),
                        np.stack([corner, corner + one, corner + one + two, corner + two], axis=1))
        except (OSError, KeyError):
            continue
    return [], np.zeros(0, int), np.zeros((0, 4, 3))


def walls(run, frames, history):
    """The outlines that a reader needs: [{name, corners: of each frame x, y, z of four corners}]."""
    names, ids, corners = read_walls(run)
    if not names:
        return []
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 3] - corners[:, 0])
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    positions = []
    for time in frames.times:
        places = corners.copy()
        shift_lower_half(places, names, history, time)
        for wall, place in touched(frames, time).items():
            row = np.flatnonzero(ids == wall)
            if len(row) == 1:
                w = row[0]
                places[w] += normals[w] * (normals[w] @ (place - places[w, 0]))
        positions.append(places)
    positions = np.array(positions)
    return [{"name": name, "corners": np.round(positions[:, w], 5).reshape(len(positions), -1).tolist()}
            for w, name in enumerate(names)]


def touched(frames, time):
    """Wall id -> the mean point where stones touch it, of those that are touched at this time."""
    frame = frames.same_time("contacts", time)
    if frame is None:
        return {}
    series = frames.series["contacts"]
    at_wall = series.attribute(frame, "kind") == 1
    ends = series.lines(frame)[at_wall, 1]
    wall, points = series.attribute(frame, "body")[ends].astype(int), series.points(frame)[ends]
    return {int(w): points[wall == w].mean(axis=0) for w in np.unique(wall)}


def shift_lower_half(places, names, history, time):
    if "shear_force" not in history:
        return
    back = np.interp(time, history["time"], history["displacement"]) - history["displacement"][-1]
    for w, name in enumerate(names):
        if name == "floor" or name == "ledge" or name.startswith("lower"):
            places[w, :, 0] += back
