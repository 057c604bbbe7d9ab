"""Has kernels compiled by another process, so that all who compute load the same machine code from the disk.

The sums of the energy balance may be reordered by the compiler. A process that compiles them itself can get
other last digits than one that loads them from the disk, and a table must not depend on who came first.
`python -m app.sweep.warm METHOD...` is that other process.
"""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterable
from pathlib import Path

import sim
from sim.compiling.compiler import ENTRY_POINTS, FOR_ENERGY, FOR_FALLBACK, needed_by
from sim.methods.registry import ARM_METHODS


def warm(methods: Iterable[str]) -> None:
    """Have the kernels of these methods and of the energy balance on the disk, if anything can be there."""
    methods = sorted(set(methods))
    if not all(marker.exists() for marker in _markers(methods)):
        # If it fails, this process compiles.
        words = [sys.executable, "-m", "app.sweep.warm", *methods]
        subprocess.run(words, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)


def _markers(methods: Iterable[str]) -> list[Path]:
    """Files that exist once all kernels of these methods have been on the disk."""
    found = [ENTRY_POINTS[name].marker for method in methods for name in _kernels(method)]
    return [marker.with_suffix(".swept") for marker in found if marker is not None]


def _kernels(method: str) -> list[str]:
    """Names of all kernels that a run by a method may come to."""
    arms = [arm.name for arm in ARM_METHODS] if method == "auto" else []
    needed = [name for one in (method, *arms) for name in needed_by(one)]
    return list(dict.fromkeys((*needed, *FOR_FALLBACK, *FOR_ENERGY)))


def _compile(method: str) -> None:
    """Do what a run does: a kernel that is called through its address is kept apart from the same one that is
    compiled by its name."""
    simulation = sim.Simulation(sim.rope(3), integrator=method)
    simulation.keep_books(True)
    simulation.step()
    for name in _kernels(method):
        ENTRY_POINTS[name].load()


if __name__ == "__main__":
    for word in sys.argv[1:]:
        _compile(word)
    for path in _markers(sys.argv[1:]):
        path.touch()
