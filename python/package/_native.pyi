# The extension behind the package. Arrays of a Moment are read-only views without copies, valid while the callback has
# it; n stones, ids ascending. SI units, world frame.
from collections.abc import Callable, Mapping
from typing import Any, TextIO

import numpy as np
from numpy.typing import NDArray

version: str
commit: str

class Moment:
    @property
    def stage(self) -> str: ...
    @property
    def fraction(self) -> float: ...  # of the stage; negative where nobody can tell
    @property
    def time(self) -> float: ...  # [s]
    @property
    def step(self) -> int: ...
    @property
    def number(self) -> int: ...  # of the stage, from 1
    @property
    def stages(self) -> int: ...
    @property
    def time_step(self) -> float: ...  # [s]
    @property
    def positions(self) -> NDArray[np.float64]: ...  # (n, 3) centres of mass [m]
    @property
    def orientations(self) -> NDArray[np.float64]: ...  # (n, 4) body to world, x, y, z, w
    @property
    def velocities(self) -> NDArray[np.float64]: ...  # (n, 3) half a step ago [m/s]
    @property
    def angular_momenta(self) -> NDArray[np.float64]: ...  # (n, 3) half a step ago [kg m2/s]
    @property
    def spins(self) -> NDArray[np.float64]: ...  # (n, 3) of the last motion [rad/s]
    @property
    def forces(self) -> NDArray[np.float64]: ...  # (n, 3) of all contacts, without gravity [N]
    @property
    def torques(self) -> NDArray[np.float64]: ...  # (n, 3) [N m]
    @property
    def masses(self) -> NDArray[np.float64]: ...  # (n,) [kg]
    @property
    def ids(self) -> NDArray[np.int64]: ...  # (n,)
    @property
    def shapes(self) -> NDArray[np.int32]: ...  # (n,)
    @property
    def geogrid_nodes(self) -> NDArray[np.float64] | None: ...  # (m, 3) a copy [m]
    @property
    def clamp_force(self) -> NDArray[np.float64] | None: ...  # (3,) a copy [N]
    def __len__(self) -> int: ...

class CaseInput:
    def entries(self) -> dict[str, tuple[str, str, str, str]]: ...
    def text(self) -> str: ...
    def experiment(self) -> str: ...
    def forecast(self) -> dict[str, Any]: ...
    def run(self, folder: str, resume: bool, force: bool, resume_line: str, callback: Callable[[Moment], Any] | None,
            every: int, screen: TextIO | None) -> str: ...

def read_case(file: str, changes: list[str]) -> CaseInput: ...
def default_folder(file: str) -> str: ...
def nearest_name(name: str, known: list[str]) -> str: ...
def stop_mpi() -> None: ...
def make_stones(count: int, seed: int, style: Mapping[str, float]) -> list[dict[str, Any]]: ...
def clump_of_file(file: str, name: str, words: Mapping[str, Any]) -> dict[str, Any]: ...
def clump_of_arrays(vertices: NDArray[np.float64], triangles: NDArray[np.int32], name: str,
                    words: Mapping[str, Any]) -> dict[str, Any]: ...
def write_stl(file: str, vertices: NDArray[np.float64], triangles: NDArray[np.int32]) -> None: ...
