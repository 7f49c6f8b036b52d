import os
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, overload

import numpy as np
from numpy.typing import NDArray

class Results:
    folder: str
    stopped: str
    def __init__(self, folder: str | os.PathLike[str], stopped: str = "") -> None: ...
    @property
    def finished(self) -> bool: ...
    @property
    def history(self) -> dict[str, NDArray[Any]]: ...
    def table(self) -> Any: ...  # pandas.DataFrame
    @property
    def summary(self) -> dict[str, Any]: ...
    @property
    def parameters(self) -> dict[str, str]: ...
    @property
    def state_hash(self) -> str | None: ...
    @property
    def log(self) -> str: ...
    @property
    def frames(self) -> Frames: ...
    def path(self, name: str) -> str: ...

@dataclass(frozen=True)
class Frame:
    time: float  # [s]
    ids: NDArray[np.int64]  # (n,)
    shapes: NDArray[np.int64]  # (n,)
    masses: NDArray[np.float64]  # (n,) [kg]
    positions: NDArray[np.float64]  # (n, 3) [m]
    orientations: NDArray[np.float64]  # (n, 4) x, y, z, w
    number: int
    series: dict[str, Any]
    def field(self, name: str, attribute: str | None = None) -> NDArray[Any] | None: ...

class Frames(Sequence[Frame]):
    def __init__(self, folder: str) -> None: ...
    @property
    def times(self) -> NDArray[np.float64]: ...  # [s]
    @property
    def shapes(self) -> list[dict[str, Any]]: ...
    def __len__(self) -> int: ...
    @overload
    def __getitem__(self, number: int) -> Frame: ...
    @overload
    def __getitem__(self, number: slice) -> list[Frame]: ...
