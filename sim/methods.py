"""The methods of integration: one table, one entry each."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, get_args

from . import multistep, tableaux
from .kernels.tables import PAST, Adams, Rosenbrock, Tableau
from .scene import Method

Kind = Literal["euler", "verlet", "explicit", "rosenbrock", "alpha", "adams", "auto"]


@dataclass(frozen=True)
class MethodInfo:
    """One method.

    Attributes:
        name: as scenes have it.
        label: for people.
        kind: which kernel runs it.
        order: of its error, as a power of the step; 0 where that says nothing.
        adaptive: whether it chooses its steps by a tolerance.
        implicit: whether it solves linear systems, and so bears any stiffness.
        summary: what it is and what it is good for, one sentence.
        table: its coefficients, if it has any.
        strictness: for a tolerance of 1 px, the position error per second that one step may make, 1/s; found
            by trying, so that errors after a second come out somewhat below the tolerance. An error per
            unit of time, and not per step, makes errors proportional to the tolerance.
    """

    name: Method
    label: str
    kind: Kind
    order: int
    adaptive: bool
    implicit: bool
    summary: str
    table: Tableau | Rosenbrock | Adams | None = None
    strictness: float = 1.0


_ALL = (
    MethodInfo(
        "auto", "Auto", "auto", 0, True, True,
        "Keeps to the tolerance and changes between an explicit and an implicit method as the body asks for.",
    ),
    MethodInfo(
        "symplectic_euler", "Symplectic Euler", "euler", 1, False, False,
        "The tutorial's: forces from the present state, then velocities, then positions; explodes above a "
        "limit of the step.",
    ),
    MethodInfo(
        "velocity_verlet", "Velocity Verlet", "verlet", 2, False, False,
        "As cheap as Euler's and of second order; the same limit where nothing damps, a lower one under "
        "damping.", strictness=1.5,
    ),
    MethodInfo(
        "rk4", "Runge-Kutta 4", "explicit", 4, False, False,
        "Four evaluations a step; accurate where the step is short beside every vibration.", tableaux.RK4,
    ),
    MethodInfo(
        "generalized_alpha", "Generalized-alpha", "alpha", 2, False, True,
        "Implicit: bears any stiffness and calms what the step is too long for; springs turn and stretch in "
        "its Newton updates.", strictness=10.0,
    ),
    MethodInfo(
        "stable_spring", "Stable spring", "euler", 1, False, False,
        "Symplectic Euler with every spring weakened as far as the step needs; cannot explode, sags instead.",
    ),
    MethodInfo(
        "dopri5", "Dormand-Prince 5", "explicit", 5, True, False,
        "Error-controlled Runge-Kutta: for moderate accuracy on bodies that are not stiff.",
        tableaux.DOPRI5, 1.0,
    ),
    MethodInfo(
        "dop853", "Dormand-Prince 8", "explicit", 8, True, False,
        "Error-controlled Runge-Kutta of order 8: for errors far below a thousandth of a pixel.",
        tableaux.DOP853, 2.5,
    ),
    MethodInfo(
        "adams", "Adams", "adams", 9, True, False,
        "Error-controlled, by a polynomial through past accelerations: two evaluations a step; for small "
        "errors of what moves smoothly.",
        multistep.adams(PAST - 1), 0.85,
    ),
    MethodInfo(
        "rodas4", "RODAS 4", "rosenbrock", 4, True, True,
        "Error-controlled Rosenbrock method: for stiff bodies.", tableaux.RODAS4, 2.2,
    ),
    MethodInfo(
        "rodas5p", "RODAS 5P", "rosenbrock", 5, True, True,
        "Error-controlled Rosenbrock method of order 5: for stiff bodies and small errors.",
        tableaux.RODAS5P, 3.2,
    ),
)  # fmt: skip

METHODS: dict[str, MethodInfo] = {method.name: method for method in _ALL}

assert set(METHODS) == set(get_args(Method))
