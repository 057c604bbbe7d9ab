"""A loop in C, of masses and springs in arrays, compiled by gcc: symplectic Euler and velocity Verlet."""

from __future__ import annotations

import ctypes
import shutil
import subprocess
import tempfile
from functools import cache
from pathlib import Path

import numpy as np

from sim.motion.stability import largest_step

from ..plain import Equations, Floats
from ..runs import Failed, Ladder
from ..scenes import MANY, PATHS, SECONDS
from .own import BEYOND

NAME = "C loop"

METHODS = {"Euler": "symplectic_euler", "Verlet": "velocity_verlet"}
"""Its methods, and softrod's names of the same."""


def missing() -> str:
    """See `engines`."""
    return "" if shutil.which("gcc") else "gcc is not installed"


def ladders(name: str) -> list[Ladder]:
    """See `engines`."""
    if name == MANY:
        from . import many

        return many.ladders_of_c()
    if name not in PATHS:
        return []
    scene = PATHS[name].make()
    equations = Equations(scene)
    return [
        Ladder(
            NAME,
            method,
            [SECONDS / largest_step(scene, same) * part for part in BEYOND],
            lambda rate: f"{round(rate)} steps/s",
            lambda rate, method=method: Run(equations, method, round(rate * SECONDS)),
        )
        for method, same in METHODS.items()
    ]


@cache
def library() -> ctypes.CDLL:
    """The program, compiled."""
    source = Path(__file__).with_name("springs.c")
    with tempfile.TemporaryDirectory() as folder:
        compiled, built = Path(folder) / "springs.o", Path(folder) / "springs.so"
        gcc, flags = str(shutil.which("gcc")), ("-O3", "-march=native", "-ffast-math", "-fPIC")
        subprocess.run([gcc, *flags, "-c", "-o", compiled, source], check=True)
        # Linked with -ffast-math, it would make tiny numbers zero in all of this process (gcc before 13).
        subprocess.run([gcc, "-shared", "-o", built, compiled, "-lm"], check=True)
        return ctypes.CDLL(str(built))


def pointer(array: np.ndarray) -> ctypes.c_void_p:
    """To the numbers of an array."""
    return ctypes.c_void_p(array.ctypes.data)


class Run:
    """See `Runner`."""

    def __init__(self, equations: Equations, method: str, steps: int) -> None:
        self._start = equations.start.reshape(-1, 4)
        self._q, self._v = np.empty((len(self._start), 2)), np.empty((len(self._start), 2))
        weight = np.where(equations.held, 0.0, 1.0 / equations.masses)
        circle = np.array(equations.circle or (0.0, 0.0, 1.0))
        self._kept = (
            np.ascontiguousarray(equations.springs, np.int64), equations.numbers.copy(), weight,
            equations.gravity.copy(), circle, np.empty(4 * weight.size),
        )  # fmt: skip
        ends, numbers, weight, gravity, circle, work = map(pointer, self._kept)
        self._arguments = (
            ctypes.c_long(len(self._start)), ctypes.c_long(len(equations.springs)), ends, numbers, weight,
            gravity, circle, *map(ctypes.c_double, self._start[0, :2]), ctypes.c_long(steps),
            ctypes.c_double(SECONDS / steps), ctypes.c_long(method == "Verlet"), pointer(self._q),
            pointer(self._v), work,
        )  # fmt: skip
        self._run = library().run

    def restart(self) -> None:
        self._q[:], self._v[:] = self._start[:, :2], self._start[:, 2:]

    def advance(self) -> None:
        self._run(*self._arguments)
        if not np.isfinite(self._q).all():
            raise Failed("ran away")

    def positions(self) -> Floats:
        return self._q
