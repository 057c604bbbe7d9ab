"""A loop in C, of masses and springs in arrays, compiled by gcc: symplectic Euler and velocity Verlet."""

from __future__ import annotations

import ctypes
import shutil
import subprocess
import tempfile
from collections.abc import Callable
from functools import cache
from pathlib import Path

import numpy as np

from sim import Scene
from sim.motion.stability import largest_step

from ..measure import Contender, ladder
from ..plain import PlainSystem
from ..runs import SECONDS, Failed, Floats, Runner
from .softrod import BEYOND


def paths(scene: Scene) -> list[Contender]:
    """Both methods on a rope or a net."""
    system = PlainSystem(scene)
    return euler_and_verlet("C loop", scene, lambda method, steps: Run(system, method, steps))


def euler_and_verlet(engine: str, scene: Scene, make: Callable[[str, int], Runner]) -> list[Contender]:
    """Symplectic Euler and velocity Verlet, with steps in parts of softrod's limit of the same.

    Args:
        engine: its name.
        scene: by which the limits are known.
        make: prepares a run of a method, "Euler" or "Verlet", with so many steps.
    """
    return [
        Contender(
            engine,
            method,
            ladder([SECONDS / largest_step(scene, same) * part for part in BEYOND]),
            lambda rate: f"{round(rate)} steps/s",
            lambda rate, method=method: make(method, round(rate * SECONDS)),
        )
        for method, same in (("Euler", "symplectic_euler"), ("Verlet", "velocity_verlet"))
    ]


@cache
def library() -> ctypes.CDLL:
    """Return the program, compiled."""
    source = Path(__file__).with_name("springs.c")
    with tempfile.TemporaryDirectory() as folder:
        compiled, built = Path(folder) / "springs.o", Path(folder) / "springs.so"
        gcc, flags = str(shutil.which("gcc")), ("-O3", "-march=native", "-ffast-math", "-fPIC")
        subprocess.run([gcc, *flags, "-c", "-o", compiled, source], check=True)
        # Linking with -ffast-math would flush denormals to zero in all of this process (gcc before 13).
        subprocess.run([gcc, "-shared", "-o", built, compiled, "-lm"], check=True)
        return ctypes.CDLL(str(built))


def pointer(array: np.ndarray) -> ctypes.c_void_p:
    """Return a pointer to the numbers of an array."""
    return ctypes.c_void_p(array.ctypes.data)


class Run(Runner):
    """A rope or a net."""

    def __init__(self, system: PlainSystem, method: str, steps: int) -> None:
        self._start = system.start.reshape(-1, 4)
        self._q, self._v = np.empty((len(self._start), 2)), np.empty((len(self._start), 2))
        weight = np.where(system.held, 0.0, 1.0 / system.masses)
        circle = np.array(system.circle or (0.0, 0.0, 1.0))
        self._arrays = (
            np.ascontiguousarray(system.springs, np.int64), system.numbers.copy(), weight,
            system.gravity.copy(), circle, np.empty(4 * weight.size),
        )  # fmt: skip
        ends, numbers, weight, gravity, circle, work = map(pointer, self._arrays)
        self._arguments = (
            ctypes.c_long(len(self._start)), ctypes.c_long(len(system.springs)), ends, numbers, weight,
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
