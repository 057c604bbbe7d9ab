"""The results of `softrod study`, and the names of what it measures."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from .engines import solvers
from .random_study import BodyResult
from .runs import SOFTROD, Point, method_label, option_name

UNSURE = 0.3
"""Part of an error above which the references differ too much to say who is within it."""

SOLVERS: dict[str, tuple[str, str]] = {
    option_name(engine, method): (engine, method)
    for engine, methods in (("SciPy", solvers.SCIPY), ("CVODE", solvers.CVODE))
    for method in methods
}
"""Engine and method of the other solvers, by their names in `--integrators`."""


def label(name: str) -> str:
    """Return the name of a method for people."""
    return " ".join(SOLVERS[name]) if name in SOLVERS else method_label(SOFTROD, name)


@dataclass
class SceneResults:
    """Results of one scene.

    Attributes:
        scene: its name.
        doubt: largest distance between the two references, px.
        points: one per setting.
        complete: whether all settings were tried, and timed as often as they should be.
    """

    scene: str
    doubt: float
    points: list[Point] = field(default_factory=list)
    complete: bool = False

    def is_doubtful(self, error: float) -> bool:
        """Whether the reference is not sure enough to say who is within an error, px."""
        return self.doubt > UNSURE * error

    def of(self, names: Sequence[str]) -> list[Point]:
        """Return the points of some methods."""
        return [point for point in self.points if point.name in names]


@dataclass
class Study:
    """Results, as far as they go.

    Attributes:
        errors: that are asked about, px, from large to small.
        scenes: one for each scene that was begun.
        bodies: random ones.
    """

    errors: tuple[float, ...]
    scenes: list[SceneResults] = field(default_factory=list)
    bodies: list[BodyResult] = field(default_factory=list)
