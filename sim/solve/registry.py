"""The table of integration methods."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, get_args

from ..engine.tables import PAST, Adams, Rosenbrock, Tableau
from ..scene.types import Method
from . import stability_limits as limits
from . import tableaux
from .adams_table import adams
from .stability_limits import StabilityLimit
from .steps.adams import run_adams
from .steps.euler import run_euler
from .steps.generalized_alpha import run_alpha
from .steps.rosenbrock import run_rosenbrock
from .steps.runge_kutta import run_runge_kutta
from .steps.verlet import run_verlet

Kernel = Any
"""numba's dispatcher of a compiled function."""


@dataclass(frozen=True)
class MethodInfo:
    """An integration method.

    Attributes:
        name: its name in scenes.
        label: its name for people.
        kernel: the kernel that runs it; None for `auto`, which runs other methods by turns.
        order: order of its error as a power of the step; 0 where there is none.
        summary: what it is and what it is good for, in one sentence.
        look: its colour and marker in figures, in matplotlib's notation.
        adaptive: whether it chooses its steps by a tolerance.
        implicit: whether it solves linear systems, and so handles any stiffness.
        limit: the rule for its stability limit; None where it has none.
        table: its coefficients, if it has a table of them.
        tolerance_factor: position error per second of simulated time that a step may make, as a multiple of
            the tolerance; found by experiment, so that errors after a second are somewhat below the
            tolerance. An error per unit of time, and not per step, makes errors proportional to the
            tolerance.
    """

    name: Method
    label: str
    kernel: Kernel
    order: int
    summary: str
    look: tuple[str, str]
    adaptive: bool = False
    implicit: bool = False
    limit: StabilityLimit | None = None
    table: Tableau | Rosenbrock | Adams | None = None
    tolerance_factor: float = 1.0


_ALL = (
    MethodInfo(
        "auto", "Auto", None, order=0, adaptive=True, implicit=True, look=("black", "o"),
        summary="Keeps to the tolerance and changes between an explicit and an implicit method as the body "
        "asks for.",
    ),
    MethodInfo(
        "symplectic_euler", "Symplectic Euler", run_euler, order=1, look=("#d55e00", "s"),
        summary="The tutorial's: forces from the present state, then velocities, then positions; explodes "
        "above a limit of the step.",
        limit=limits.period_doubling_limit(2.0, limits.euler_step),
    ),
    MethodInfo(
        "velocity_verlet", "Velocity Verlet", run_verlet, order=2, look=("#0072b2", "^"),
        summary="As cheap as Euler's and of second order; the same limit where nothing damps, a lower one "
        "under damping.",
        limit=limits.period_doubling_limit(4.0, limits.verlet_step), tolerance_factor=1.5,
    ),
    MethodInfo(
        "rk4", "Runge-Kutta 4", run_runge_kutta, order=4, look=("#56b4e9", "D"),
        summary="Four evaluations a step; accurate where the step is short beside every vibration.",
        limit=limits.runge_kutta(tableaux.RK4), table=tableaux.RK4,
    ),
    MethodInfo(
        "generalized_alpha", "Generalized-alpha", run_alpha, order=2, implicit=True, look=("#e69f00", "v"),
        summary="Implicit: stable at any stiffness; vibrations with fewer than some twenty steps per period "
        "become too slow and die out, without a message.",
        tolerance_factor=10.0,
    ),
    MethodInfo(
        "stable_spring", "Stable spring", run_euler, order=1, look=("#d55e00", "P"),
        summary="Symplectic Euler with every spring softened as far as the step needs; cannot explode, sags "
        "instead.",
        limit=limits.period_doubling_limit(2.0, limits.euler_step),
    ),
    MethodInfo(
        "adams", "Adams", run_adams, order=PAST + 1, adaptive=True, look=("#e69f00", "*"),
        summary="Explicit multistep: two force evaluations a step, the order adapts to smoothness; for small "
        "errors of smooth motion.",
        table=adams(PAST - 1), tolerance_factor=0.85,
    ),
    MethodInfo(
        "rodas4", "RODAS 4", run_rosenbrock, order=4, adaptive=True, implicit=True, look=("#cc79a7", "X"),
        summary="Error-controlled Rosenbrock method: for stiff bodies.",
        table=tableaux.RODAS4, tolerance_factor=2.2,
    ),
    MethodInfo(
        "rodas5p", "RODAS 5P", run_rosenbrock, order=5, adaptive=True, implicit=True, look=("#cc79a7", "p"),
        summary="Error-controlled Rosenbrock method of order 5: for stiff bodies and small errors.",
        table=tableaux.RODAS5P, tolerance_factor=3.2,
    ),
)  # fmt: skip

METHODS: dict[str, MethodInfo] = {method.name: method for method in _ALL}
"""The methods, by name."""

assert set(METHODS) == set(get_args(Method))

AUTO_METHODS = tuple(METHODS[name] for name in ("velocity_verlet", "rodas4", "generalized_alpha", "adams"))
"""The methods that `auto` chooses from, in the order of `VERLET`, `ROSENBROCK`, `ALPHA` and `ADAMS`."""
