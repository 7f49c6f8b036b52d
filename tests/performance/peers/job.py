"""What a peer is asked to run, what it answers, and the spheres of a packed state in the world."""
import os
import subprocess
from dataclasses import dataclass

import numpy as np


@dataclass
class Law:
    """Contact law of every pair of spheres and at walls; SI units."""
    k_n: float
    k_t: float
    friction: float
    rate_n: float  # dashpots: rate times the reduced mass of the clumps [1/s]
    rate_t: float
    gravity: float
    dt: float


@dataclass
class Job:
    state: dict  # format clump-workload-1
    law: Law
    warm: int
    steps: int
    skin: float
    core: str
    folder: str  # of the peer's files


@dataclass
class Result:
    seconds: float  # a step
    contacts: int   # touching pairs of spheres at the end


def rotation(quaternion):
    """Matrix of a quaternion w, x, y, z: x_world = R x_body + position."""
    w, x, y, z = quaternion
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


def world_spheres(state):
    """One row a sphere: x, y, z, radius, index of its clump; clumps in order, then their spheres."""
    bodies = [np.array(shape["spheres"]) for shape in state["shapes"]]
    rows = []
    for i, clump in enumerate(state["clumps"]):
        body = bodies[clump["shape"]]
        centres = body[:, :3] @ rotation(clump["quat"]).T + np.array(clump["pos"])
        rows.append(np.column_stack([centres, body[:, 3], np.full(len(body), i)]))
    return np.vstack(rows)


def run_program(command, job, **environment):
    """Runs a peer on the core of the job, in its folder."""
    return subprocess.run(["taskset", "-c", job.core, *command], cwd=job.folder, capture_output=True, text=True,
                          env=dict(os.environ, OMP_NUM_THREADS="1", **environment))
