"""What takes part in `softrod bench peers`: a row for each engine or solver."""

from __future__ import annotations

import importlib
import importlib.util
import shutil
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from sim import Scene

from .measure import Contender

Contenders = Callable[[Scene], list[Contender]]

_MODULES = {"scikit-sundae": "sksundae"}
"""Modules of packages that have another name."""


@dataclass(frozen=True)
class Engine:
    """An engine or a solver.

    Attributes:
        name: for people and for `--engines`.
        paths: its methods on a rope or a net; None where it takes no part.
        heaps: its methods on a heap of rings, or None.
        many: its methods on many ropes, or None.
        packages: that it needs besides those of softrod.
        programs: that it needs on the machine.
    """

    name: str
    paths: Contenders | None = None
    heaps: Contenders | None = None
    many: Callable[[Sequence[Scene]], list[Contender]] | None = None
    packages: tuple[str, ...] = ()
    programs: tuple[str, ...] = ()

    def missing(self) -> str:
        """Return what it lacks here as a sentence; empty where nothing does."""
        absent = [
            name for name in self.packages if importlib.util.find_spec(_MODULES.get(name, name)) is None
        ]
        absent += [name for name in self.programs if shutil.which(name) is None]
        return f"{' and '.join(absent)} {'is' if len(absent) == 1 else 'are'} not installed" if absent else ""


def package(name: str) -> Any:
    """Import a package of the extra `peers`, which may be missing when types are checked."""
    return importlib.import_module(name)


def per_second(what: str) -> Callable[[float], str]:
    """Return what writes a rate for people, as "960 steps/s"."""
    return lambda rate: f"{rate:g} {what}/s"


def tolerance_text(value: float) -> str:
    """Return a tolerance for people."""
    return f"tolerance {value:.2g}"
