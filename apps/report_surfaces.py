"""What stones look like: closed surfaces of triangles in the body frame of their clumps, fine and coarse."""

import json
from typing import NamedTuple

import numpy as np


class Surface(NamedTuple):
    """Vertices [m] and triangles, twice, and whether they are those of the stone itself."""

    fine: tuple
    coarse: tuple
    is_own: bool


def surfaces(shapes, path):
    """One for each shape.

    `path` is what `interlock` has made of the scans or synthetic stones (apps/stone_surfaces.h), or None. Where there
    is none that fits a shape, the surface is that of its spheres."""
    made = {}
    if path is not None:
        with open(path, encoding="utf-8") as file:
            made = {each["name"]: each for each in json.load(file)}
    result = []
    for shape in shapes:
        mine = made.get(shape["name"])
        if mine and abs(mine["volume"] / shape["volume"] - 1) < 1e-6:
            result.append(Surface(*(tuple(np.reshape(mine[level][part], (-1, 3)) for part in ("vertices", "triangles"))
                                    for level in ("fine", "coarse")), True))
        else:
            result.append(Surface(surface_of_spheres(shape, 2), surface_of_spheres(shape, 1), False))
    return result


def surface_of_spheres(shape, halvings):
    """Where rays from the centre of mass leave the spheres for the last time."""
    directions, triangles = ball(halvings)
    along = directions @ shape["centres"].T
    rest = shape["radii"] ** 2 - np.sum(shape["centres"] ** 2, axis=1) + along ** 2
    way = np.where(rest >= 0, along + np.sqrt(np.maximum(rest, 0)), 0).max(axis=1)
    return directions * np.maximum(way, 1e-5)[:, None], triangles


def ball(halvings):
    """An icosahedron whose faces are cut into four so many times: unit vectors and triangles."""
    golden = 0.5 * (1 + 5 ** 0.5)
    points = [(s * a, t * b, 0) for a, b in [(1, golden)] for s in (-1, 1) for t in (-1, 1)]
    points = np.array([np.roll(p, k) for k in range(3) for p in points])
    triangles = [(i, j, k) for i in range(12) for j in range(i) for k in range(j)
                 if max(np.linalg.norm(points[a] - points[b]) for a, b in ((i, j), (j, k), (k, i))) < 2.1]
    triangles = [t if np.linalg.det(points[list(t)]) > 0 else t[::-1] for t in triangles]
    points = [p / np.linalg.norm(p) for p in points]
    for _ in range(halvings):
        middle = {}

        def between(a, b):
            key = (min(a, b), max(a, b))
            if key not in middle:
                middle[key] = len(points)
                points.append((points[a] + points[b]) / np.linalg.norm(points[a] + points[b]))
            return middle[key]

        finer = []
        for a, b, c in triangles:
            ab, bc, ca = between(a, b), between(b, c), between(c, a)
            finer += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
        triangles = finer
    return np.array(points), np.array(triangles)
