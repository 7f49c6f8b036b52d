"""The stones of a run for its page: which there are, what they look like, where they are in each frame.

Frames hold member spheres; which stone has which shape stands in the states on disk (docs/checkpoint_format.md), and
a stone's attitude is the rotation that takes the spheres of its shape to those of the frame. Needs h5py.
"""

import os

import h5py
import numpy as np

# Newest first; older ones know stones that have left the box since.
STATES = ["checkpoint.h5", "checkpoint.previous.h5", "state_at_failure.h5", "state_before_pull.h5",
          "state_before_geogrid.h5"]
CLUMPS = "state/world/engine/clumps"


class NoReplay(Exception):
    """There is nothing to replay; the text is one full sentence."""


def stages(run):
    """The stages that have ended, as summary.json has them, of a run that has not."""
    for name in STATES:
        try:
            with h5py.File(os.path.join(run, name), "r") as state:
                group = state["records/stages"]
                columns = [group[column][:].ravel().tolist() for column in ("steps", "simulated_time", "wall_time")]
                return [{"name": stage, "steps": steps, "simulated_time_s": time, "wall_time_s": wall}
                        for stage, steps, time, wall in zip(group["name"].asstr()[:].ravel().tolist(), *columns)]
        except (OSError, KeyError):
            continue
    return []


class Stones:
    """Every stone that a state on disk knows, ids ascending, and the shapes they share."""

    def __init__(self, run):
        self.shapes, known = [], {}
        for name in STATES:
            path = os.path.join(run, name)
            if not os.path.isfile(path):
                continue
            try:
                with h5py.File(path, "r") as state:
                    self.take(state[CLUMPS], known)
            except (OSError, KeyError):
                continue  # of another version, or being replaced just now
        if not known:
            raise NoReplay("The run has kept no state on disk yet (checkpoint.h5), which says what its stones are.")
        self.ids = np.array(sorted(known))
        rows = [known[i] for i in self.ids]
        self.shape = np.array([row[0] for row in rows])
        self.mass = np.array([row[1] for row in rows])
        self.is_load = np.array([row[2] for row in rows], dtype=bool)

    def take(self, clumps, known):
        shapes = [read_shape(clumps["shapes"][str(k)]) for k in range(int(clumps["shapes/count"][0]))]
        if len(shapes) > len(self.shapes):
            self.shapes += shapes[len(self.shapes):]
        columns = (clumps[name][:].ravel().tolist() for name in ("id", "shape", "mass", "kind"))
        for clump, shape, mass, kind in zip(*columns):
            known.setdefault(clump, (shape, mass, kind != 0))

    def poses(self, clumps, frame):
        """Centres of mass [m] and attitudes (x, y, z, w; body to world; all zero where a stone is not there)."""
        points, owner = clumps.points(frame).astype(float), clumps.attribute(frame, "clump")
        there, first = np.unique(owner, return_index=True)
        stone = np.searchsorted(self.ids, there.astype(int))
        known = (stone < len(self.ids)) & (self.ids[np.minimum(stone, len(self.ids) - 1)] == there)
        centres, attitudes = np.zeros((len(self.ids), 3)), np.zeros((len(self.ids), 4))
        for k, shape in enumerate(self.shapes):
            mine = np.flatnonzero(known & (self.shape[np.minimum(stone, len(self.ids) - 1)] == k))
            if len(mine) == 0:
                continue
            spheres = points[first[mine][:, None] + np.arange(len(shape["centres"]))]
            rows = stone[mine]
            centres[rows], attitudes[rows] = fit(shape["centres"], spheres)
        return centres, attitudes


def read_shape(group):
    return {"name": group["name"].asstr()[0], "volume": float(group["volume"][0]),
            "centres": group["spheres/centre"][:], "radii": group["spheres/radius"][:].ravel()}


def fit(body, world):
    """The rigid motions that take the points `body` (n x 3) nearest to each of `world` (m x n x 3).

    Source: Horn, J. Opt. Soc. Am. A 4 (1987) 629-642: the attitude is the eigenvector of the largest eigenvalue of a
    symmetric matrix that the products of the coordinates make."""
    middle, middles = body.mean(axis=0), world.mean(axis=1)
    s = np.einsum("nk,mnl->mkl", body - middle, world - middles[:, None])
    matrix = np.empty((len(world), 4, 4))
    matrix[:, 0, 0] = np.trace(s, axis1=1, axis2=2)
    for i, (j, k) in enumerate([(1, 2), (2, 0), (0, 1)]):
        matrix[:, 0, i + 1] = matrix[:, i + 1, 0] = s[:, j, k] - s[:, k, j]
        matrix[:, i + 1, i + 1] = 2 * s[:, i, i] - matrix[:, 0, 0]
        matrix[:, j + 1, k + 1] = matrix[:, k + 1, j + 1] = s[:, j, k] + s[:, k, j]
    w, x, y, z = np.linalg.eigh(matrix)[1][:, :, 3].T
    attitudes = np.stack([x, y, z, w], axis=1)
    if len(body) == 1:  # of a ball: any
        attitudes = np.tile([0.0, 0.0, 0.0, 1.0], (len(world), 1))
    return middles - rotated(attitudes, middle), attitudes


def rotated(attitudes, vector):
    axis, w = attitudes[:, :3], attitudes[:, 3:]
    turn = 2 * np.cross(axis, vector)
    return vector + w * turn + np.cross(axis, turn)
