import os
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

@dataclass(frozen=True)
class Stone:
    vertices: NDArray[np.float64]  # (n, 3) [m]
    triangles: NDArray[np.int32]  # (m, 3)
    longest: float  # [m]
    intermediate: float  # [m]
    shortest: float  # [m]
    sieve: float  # [m]
    volume: float  # [m3]
    sphericity: float
    convexity: float
    angularity: float  # [degrees]
    @property
    def flatness(self) -> float: ...
    @property
    def elongation(self) -> float: ...
    def save(self, file: str | os.PathLike[str]) -> None: ...

def stones(count: int, seed: int = 1, *, flatness: float = ..., flatness_spread: float = ...,
           elongation: float = ..., elongation_spread: float = ..., faces: int = ..., edge_wear: float = ...,
           scars: int = ..., scar_depth: float = ..., steps: int = ..., roughness: float = ...,
           roughness_exponent: float = ..., spacing: float = ...) -> list[Stone]: ...

@dataclass(frozen=True)
class Clump:
    name: str
    spheres: NDArray[np.float64]  # (n, 4): centre, radius [m], body frame
    volume: float  # [m3]
    density: float  # [kg/m3]
    unit_inertia: NDArray[np.float64]  # (3,) [m5]
    centre: NDArray[np.float64]  # (3,) [m]
    rotation: NDArray[np.float64]  # (4,) x, y, z, w
    report: dict[str, Any]
    warnings: list[str] = ...
    text: str = ...
    @property
    def mass(self) -> float: ...  # [kg]
    @property
    def inertia(self) -> NDArray[np.float64]: ...  # (3,) [kg m2]
    @property
    def spheres_of_surface(self) -> NDArray[np.float64]: ...  # (n, 4) [m]
    def save(self, file: str | os.PathLike[str]) -> None: ...

def clump(stone: str | os.PathLike[str] | Stone | tuple[ArrayLike, ArrayLike], *, d_min: float | None = None,
          r_min: float | None = None, p_max: float = 100.0, max_spheres: int = 0,
          order: Literal["random", "gain"] = "random", bulge: float = 0.0, seed: int = 1, density: float = 2650.0,
          mass_properties: Literal["mesh", "uniform", "equal-mass"] = "mesh",
          touching_radius: Literal["surface", "nodes"] = "surface", target_volume_error: float = 0.0,
          target_inertia_error: float = 0.0, unit: Literal["m", "cm", "mm", "inch"] = "m", flip: bool = False,
          accept_crossings: bool = False, unusual: bool = False, name: str | None = None) -> Clump: ...
