"""Synthetic stones, and stones made into clumps of spheres (docs/theory/stones.md, docs/theory/clumps.md)."""

import json
import os
from dataclasses import dataclass, field

import numpy as np

from . import _native

__all__ = ["Stone", "Clump", "stones", "clump"]


@dataclass(frozen=True)
class Stone:
    """A closed surface. Its longest axis is near x, its shortest near z, its centre of volume is the origin."""

    vertices: np.ndarray  #: (n, 3) [m]
    triangles: np.ndarray  #: (m, 3) indices of vertices, counter-clockwise seen from outside
    longest: float  #: L, extent along the longest principal axis [m]
    intermediate: float  #: I [m]
    shortest: float  #: S [m]
    sieve: float  #: side of the smallest square opening that lets it through end-on [m]
    volume: float  #: [m3]
    sphericity: float  #: Wadell's: area of the ball of equal volume over its own [-]
    convexity: float  #: volume over that of the convex hull [-]
    angularity: float  #: index of dem/stones/angularity.h [degrees]

    @property
    def flatness(self):
        """S/I [-]."""
        return self.shortest / self.intermediate

    @property
    def elongation(self):
        """I/L [-]."""
        return self.intermediate / self.longest

    def save(self, file):
        """Writes a binary STL file in metres, which `interlock clump` and `Stones/Folder` of a case read."""
        _native.write_stl(os.fspath(file), self.vertices, self.triangles)


def stones(count, seed=1, **style):
    """`count` synthetic angular ballast stones, the same for the same seed: a list of Stone.

    `style` are the numbers of dem/stones/stone_style.h: flatness, flatness_spread, elongation, elongation_spread,
    faces, edge_wear, scars, scar_depth, steps, roughness [m], roughness_exponent, spacing of nodes [m]. Raises
    InputError when one is out of range."""
    return [Stone(**stone) for stone in _native.make_stones(count, seed, style)]


@dataclass(frozen=True)
class Clump:
    """A rigid body of spheres. Body frame: origin at the centre of mass, axes along the principal axes of inertia."""

    name: str
    spheres: np.ndarray  #: (n, 4): centre in the body frame and radius [m], largest first
    volume: float  #: of the stone, the union of the spheres aside [m3]
    density: float  #: [kg/m3]
    unit_inertia: np.ndarray  #: (3,) principal moments for unit density, ascending [m5]
    centre: np.ndarray  #: (3,) of mass, frame of the surface [m]
    rotation: np.ndarray  #: (4,) x, y, z, w: x_surface = centre + rotation x_body
    report: dict  #: how good it is: what `interlock clump` writes as its .report.json, names with units
    warnings: list = field(default_factory=list)  #: sentences; empty for a good clump
    text: str = ""  #: of a .clump.json file

    @property
    def mass(self):
        """That of the stone [kg]."""
        return self.density * self.volume

    @property
    def inertia(self):
        """(3,) principal moments about the centre of mass [kg m2]."""
        return self.density * self.unit_inertia

    @property
    def spheres_of_surface(self):
        """(n, 4): the spheres in the frame of the surface that the clump was made from [m]."""
        axis, w = self.rotation[:3], self.rotation[3]
        turn = 2 * np.cross(axis, self.spheres[:, :3])
        centres = self.spheres[:, :3] + w * turn + np.cross(axis, turn) + self.centre
        return np.column_stack([centres, self.spheres[:, 3]])

    def save(self, file):
        """Writes a .clump.json file, which `Stones/Folder` of a case reads."""
        with open(file, "w", encoding="utf-8") as stream:
            stream.write(self.text)


def clump(stone, *, d_min=None, r_min=None, p_max=100.0, max_spheres=0, order="random", bulge=0.0, seed=1,
          density=2650.0, mass_properties="mesh", touching_radius="surface", target_volume_error=0.0,
          target_inertia_error=0.0, unit="m", flip=False, accept_crossings=False, unusual=False, name=None):
    """Makes a stone into a clump, as `interlock clump` does.

    stone            file (.stl, .ply, .obj; clouds of points .ply, .xyz), Stone, or (vertices, triangles)
    d_min            a node nearer than this to a sphere gets none [m]; may be left out with order="gain"
    r_min            smaller spheres are rejected [m]; likewise
    p_max            stop when this share of the nodes has been used [%]
    max_spheres      stop at this number; 0: no limit
    order            "random" (nodes as they are drawn, the paper's) or "gain" (what adds most to the shape comes next)
    bulge            how far spheres may stand out so that their union has the stone's volume [m]
    seed             of the order of the nodes
    density          of the rock [kg/m3]
    mass_properties  "mesh", "uniform" or "equal-mass": what centre and inertia are those of
    touching_radius  "surface" (facets) or "nodes" (the paper's)
    target_volume_error, target_inertia_error   more stop rules [%]; 0: none
    unit             of the file or of the vertices: "m", "cm", "mm" or "inch"
    flip, accept_crossings, unusual             as the options of the same names

    Raises InputError, with the options' names of the command line in its sentence."""
    words = {"p_max": float(p_max), "max_spheres": int(max_spheres), "order": order, "bulge": float(bulge),
             "seed": int(seed), "density": float(density), "mass_properties": mass_properties,
             "touching_radius": touching_radius, "target_volume_error": float(target_volume_error),
             "target_inertia_error": float(target_inertia_error), "unit": unit, "flip": bool(flip),
             "accept_crossings": bool(accept_crossings), "unusual": bool(unusual)}
    words.update({key: float(value) for key, value in (("d_min", d_min), ("r_min", r_min)) if value is not None})
    if isinstance(stone, (str, os.PathLike)):
        file = os.fspath(stone)
        made = _native.clump_of_file(file, name or os.path.splitext(os.path.basename(file))[0], words)
    else:
        vertices, triangles = (stone.vertices, stone.triangles) if isinstance(stone, Stone) else stone
        made = _native.clump_of_arrays(np.ascontiguousarray(vertices, dtype=np.float64),
                                       np.ascontiguousarray(triangles, dtype=np.int32), name or "stone", words)
    for key in ("unit_inertia", "centre", "rotation"):
        made[key] = np.array(made[key])
    made["report"] = json.loads(made["report"])
    made["warnings"] = made["warnings"].splitlines()
    return Clump(density=float(density), **made)
