"""The methods of integration: one table, one entry each."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, get_args

from ..kernels.core.tables import PAST, Adams, Rosenbrock, Tableau
from ..kernels.integrators.adams import run_adams
from ..kernels.integrators.euler import run_euler
from ..kernels.integrators.generalized_alpha import run_alpha
from ..kernels.integrators.rosenbrock import run_rosenbrock
from ..kernels.integrators.runge_kutta import run_runge_kutta
from ..kernels.integrators.verlet import run_verlet
from ..scene.types import Method
from . import adams as multistep
from . import limits, tableaux
from .limits import StabilityLimit

Kernel = Any
"""numba's dispatcher of a compiled function."""


@dataclass(frozen=True)
class MethodInfo:
    """One method.

    Attributes:
        name: as scenes have it.
        label: for people.
        kernel: what runs it; None for `auto`, which runs others by turns.
        order: of its error, as a power of the step; 0 where that says nothing.
        adaptive: whether it chooses its steps by a tolerance.
        implicit: whether it solves linear systems, and so bears any stiffness.
        summary: what it is and what it is good for, one sentence.
        limit: how its stability limit follows from a body; None where it has none.
        table: its coefficients, if it has any.
        tolerance_factor: for a tolerance of 1 px, the position error per second that one step may make, 1/s;
            found by trying, so that errors after a second come out somewhat below the tolerance. An error
            per unit of time, and not per step, makes errors proportional to the tolerance.
    """

    name: Method
    label: str
    kernel: Kernel
    order: int
    adaptive: bool
    implicit: bool
    summary: str
    limit: StabilityLimit | None = None
    table: Tableau | Rosenbrock | Adams | None = None
    tolerance_factor: float = 1.0


_ALL = (
    MethodInfo(
        "auto", "Auto", None, 0, True, True,
        "Keeps to the tolerance and changes between an explicit and an implicit method as the body asks for.",
    ),
    MethodInfo(
        "symplectic_euler", "Symplectic Euler", run_euler, 1, False, False,
        "The tutorial's: forces from the present state, then velocities, then positions; explodes above a "
        "limit of the step.", limits.flip(2.0),
    ),
    MethodInfo(
        "velocity_verlet", "Velocity Verlet", run_verlet, 2, False, False,
        "As cheap as Euler's and of second order; the same limit where nothing damps, a lower one under "
        "damping.", limits.flip(4.0), tolerance_factor=1.5,
    ),
    MethodInfo(
        "rk4", "Runge-Kutta 4", run_runge_kutta, 4, False, False,
        "Four evaluations a step; accurate where the step is short beside every vibration.",
        limits.runge_kutta(tableaux.RK4), tableaux.RK4,
    ),
    MethodInfo(
        "generalized_alpha", "Generalized-alpha", run_alpha, 2, False, True,
        "Implicit: bears any stiffness and calms what the step is too long for; springs turn and stretch in "
        "its Newton updates.", tolerance_factor=10.0,
    ),
    MethodInfo(
        "stable_spring", "Stable spring", run_euler, 1, False, False,
        "Symplectic Euler with every spring softened as far as the step needs; cannot explode, sags instead.",
        limits.flip(2.0),
    ),
    MethodInfo(
        "adams", "Adams", run_adams, 9, True, False,
        "Error-controlled, by a polynomial through past accelerations: two evaluations a step; for small "
        "errors of what moves smoothly.",
        None, multistep.adams(PAST - 1), 0.85,
    ),
    MethodInfo(
        "rodas4", "RODAS 4", run_rosenbrock, 4, True, True,
        "Error-controlled Rosenbrock method: for stiff bodies.", None, tableaux.RODAS4, 2.2,
    ),
    MethodInfo(
        "rodas5p", "RODAS 5P", run_rosenbrock, 5, True, True,
        "Error-controlled Rosenbrock method of order 5: for stiff bodies and small errors.",
        None, tableaux.RODAS5P, 3.2,
    ),
)  # fmt: skip

METHODS: dict[str, MethodInfo] = {method.name: method for method in _ALL}

assert set(METHODS) == set(get_args(Method))

ARM_METHODS = tuple(METHODS[name] for name in ("velocity_verlet", "rodas4", "generalized_alpha", "adams"))
"""The methods that `auto` chooses from, in the order of the ARM_ constants."""
