"""What a garment does to the body that wears it: runs scenes of Toile and gives their results as NumPy arrays.

Lengths are mm, forces N; pressures are kPa, stresses MPa. doc/python.md shows how it is used.
"""

import os
from typing import Any, Callable, Iterator, Mapping, Optional, TypedDict, Union

import numpy
from numpy.typing import NDArray

__version__: str

Scene = Union[str, "os.PathLike[str]", Mapping[str, Any]]
"""The path of a scene's XML file, or a dictionary of what such a file holds."""

class Error(Exception):
    """What Toile cannot do; the base of its other errors."""

class InputError(Error):
    """The scene, or a file that it names, cannot be used; the message names list, parameter and what is allowed."""

class SolveError(Error):
    """A stage could not reach its end. The session holds the last converged state."""

class CheckError(Error):
    """All was computed, but a check of the scene does not hold."""

class Step:
    """One accepted step of a run."""

    @property
    def stage(self) -> str: ...
    @property
    def step(self) -> int: ...
    @property
    def parameter(self) -> float: ...
    @property
    def load(self) -> float: ...
    @property
    def seam(self) -> float: ...
    @property
    def iterations(self) -> int: ...
    @property
    def cut_backs(self) -> int: ...
    @property
    def residual(self) -> float: ...
    @property
    def strain_energy(self) -> float: ...
    @property
    def dissipated(self) -> float: ...
    @property
    def negative_pivots(self) -> int: ...
    @property
    def final(self) -> bool: ...
    @property
    def seconds(self) -> float: ...

class Fields:
    """The fields of one state by name: a value a node or an element. Arrays are read-only views."""

    def __getitem__(self, name: str) -> NDArray[numpy.float64]: ...
    def __contains__(self, name: str) -> bool: ...
    def __len__(self) -> int: ...
    def __iter__(self) -> Iterator[str]: ...
    def keys(self) -> list[str]: ...
    def unit(self, name: str) -> str: ...
    @property
    def position(self) -> NDArray[numpy.float64]: ...
    @property
    def normal(self) -> NDArray[numpy.float64]: ...

class Block:
    """Elements of one panel that have the same fabric and number of nodes."""

    @property
    def name(self) -> str: ...
    @property
    def material(self) -> str: ...
    @property
    def connectivity(self) -> NDArray[numpy.int32]: ...

class Sections(TypedDict):
    """Sections of the garment, a value a section; NaN where there is none. Pressures in kPa."""

    title: list[str]
    panels: list[str]
    height: NDArray[numpy.float64]
    girth: NDArray[numpy.float64]
    pressure: NDArray[numpy.float64]
    pressure_error: NDArray[numpy.float64]
    pressure_min: NDArray[numpy.float64]
    pressure_max: NDArray[numpy.float64]
    laplace: NDArray[numpy.float64]
    hoop_tension: NDArray[numpy.float64]
    closed: NDArray[numpy.bool_]
    at_support: NDArray[numpy.bool_]

class Session:
    """A scene, its run, and the record of the run."""

    def __init__(
        self,
        scene: Scene,
        *,
        settings: Mapping[str, Any] = ...,
        threads: int = 1,
        allow_plugins: bool = False,
        verbose: bool = False,
    ) -> None: ...
    def run(
        self,
        *,
        output: Optional[Union[str, "os.PathLike[str]"]] = None,
        progress: Optional[Callable[[Step], Any]] = None,
    ) -> None: ...
    @property
    def title(self) -> str: ...
    @property
    def start(self) -> list[str]: ...
    @property
    def warnings(self) -> list[str]: ...
    @property
    def notes(self) -> list[str]: ...
    @property
    def steps(self) -> list[Step]: ...
    @property
    def fields(self) -> Fields: ...
    @property
    def levels(self) -> Sections: ...
    @property
    def curve(self) -> Sections: ...
    @property
    def points(self) -> dict[str, NDArray[numpy.float64]]: ...
    @property
    def distances(self) -> dict[str, NDArray[numpy.float64]]: ...
    @property
    def reactions(self) -> dict[str, NDArray[numpy.float64]]: ...
    @property
    def blocks(self) -> list[Block]: ...
    @property
    def edges(self) -> dict[str, NDArray[numpy.int32]]: ...
    @property
    def pattern(self) -> NDArray[numpy.float64]: ...
    @property
    def placed(self) -> NDArray[numpy.float64]: ...

def run(
    scene: Scene,
    *,
    output: Optional[Union[str, "os.PathLike[str]"]] = None,
    progress: Optional[Callable[[Step], Any]] = None,
    settings: Mapping[str, Any] = ...,
    threads: int = 1,
    allow_plugins: bool = False,
    verbose: bool = False,
) -> Session:
    """Makes a Session of a scene, runs it, and returns it."""
