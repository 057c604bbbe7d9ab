"""JAX: loops that XLA compiles, and diffrax's solvers. Compiling is not timed.

The first import of JAX sets it to double precision.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np

from sim.motion.stability import largest_step

from ..plain import Equations, Floats
from ..runs import Failed, Ladder
from ..scenes import MANY, PATHS, SECONDS
from . import lacking, package
from .own import BEYOND
from .solvers import RELATIVE

TOLERANCES = tuple(10.0 ** (half / 2) for half in range(2, -9, -1))
"""px and px/s."""

MOST = 400
"""Unknowns up to which diffrax's implicit solver is asked: it takes the Jacobian as a dense matrix."""

MAX_STEPS = 400_000


class Jax:
    """See `engines`."""

    NAME = "JAX"

    @staticmethod
    def missing() -> str:
        return lacking("jax")

    @staticmethod
    def ladders(name: str) -> list[Ladder]:
        if name == MANY:
            from . import many

            return many.ladders_of_jax()
        if name not in PATHS:
            return []
        scene = PATHS[name].make()
        equations = Equations(scene)
        return [
            Ladder(
                "JAX", method, [SECONDS / largest_step(scene, same) * part for part in BEYOND],
                lambda rate: f"{round(rate)} steps/s",
                lambda rate, method=method: _Loop(equations, method, round(rate * SECONDS)),
            )
            for method, same in (("Euler", "symplectic_euler"), ("Verlet", "velocity_verlet"))
        ]  # fmt: skip


class Diffrax:
    """See `engines`."""

    NAME = "diffrax"

    @staticmethod
    def missing() -> str:
        return lacking("jax", "diffrax")

    @staticmethod
    def ladders(name: str) -> list[Ladder]:
        if name not in PATHS:
            return []
        equations = Equations(PATHS[name].make())
        solvers = ["Tsit5", "Dopri8"] + (["Kvaerno5"] if equations.start.size <= MOST else [])
        return [
            Ladder(
                "diffrax", solver, TOLERANCES, lambda value: f"tolerance {value:.2g}",
                lambda value, solver=solver: _Solver(equations, solver, value),
            )
            for solver in solvers
        ]  # fmt: skip


def jax_in_double() -> Any:
    """The module."""
    jax = package("jax")

    jax.config.update("jax_enable_x64", True)
    return jax


def acceleration_of(equations: Equations) -> Callable[[Any, Any, Any], Any]:
    """A function (t, q, v) of (n, 2) arrays, which returns accelerations; and puts a led mass where it is."""
    jax = jax_in_double()
    jnp = jax.numpy
    a, b = equations.springs.T
    k, c, rest = equations.numbers.T
    weight = np.where(equations.held, 0.0, 1.0 / equations.masses)[:, None]
    fall = np.where(equations.held[:, None], 0.0, equations.gravity)

    def acceleration(t: Any, q: Any, v: Any) -> Any:
        q, v = lead(equations, t, q, v)
        along, relative = q[b] - q[a], v[b] - v[a]
        length = jnp.sqrt((along**2).sum(1))
        rate = (along * relative).sum(1) / length
        force = ((k * (length - rest) + c * rate) / length)[:, None] * along
        total = jnp.zeros_like(q).at[a].add(force).at[b].add(-force)
        return total * weight + fall

    return acceleration


def lead(equations: Equations, t: Any, q: Any, v: Any) -> tuple[Any, Any]:
    """Positions and velocities with a led mass where it is at a time."""
    if equations.circle is None:
        return q, v
    jnp = jax_in_double().numpy
    radius, frequency, ramp = equations.circle
    gone = -jnp.expm1(-t / ramp)
    p, rate = 2.0 * math.pi * frequency * (t - ramp * gone), 2.0 * math.pi * frequency * gone
    place = equations.start[:2] + radius * jnp.stack((jnp.sin(p), 1.0 - jnp.cos(p)))
    return q.at[0].set(place), v.at[0].set(radius * rate * jnp.stack((jnp.cos(p), jnp.sin(p))))


class _Run:
    """What both have in common; see `Runner`."""

    def __init__(self, equations: Equations) -> None:
        start = equations.start.reshape(-1, 4)
        self._equations, self._start = equations, (start[:, :2].copy(), start[:, 2:].copy())
        self._end: Any = None
        self._solve: Callable[[Any, Any], Any]

    def restart(self) -> None:
        pass

    def advance(self) -> None:
        self._end = np.asarray(self._solve(*self._start))
        if not np.isfinite(self._end).all():
            raise Failed("ran away")

    def positions(self) -> Floats:
        found = self._end.copy()
        if self._equations.circle is not None:
            found[0] = self._equations.lead_at(SECONDS)[:2]
        return found


class _Loop(_Run):
    _compiled: dict[tuple[int, str], Any] = {}  # noqa: RUF012

    def __init__(self, equations: Equations, method: str, steps: int) -> None:
        super().__init__(equations)
        key = id(equations), method
        if key not in self._compiled:
            self._compiled[key] = _loop(equations, method)
        run, h = self._compiled[key], SECONDS / steps
        self._solve = lambda q, v: run(q, v, steps, h)
        run(*self._start, 1, h).block_until_ready()


def _loop(equations: Equations, method: str) -> Any:
    """A compiled function (q, v, steps, h) that returns where masses are in the end."""
    jax = jax_in_double()
    acceleration = acceleration_of(equations)

    def euler(i: Any, state: Any, h: Any) -> Any:
        q, v, a = state
        q, v = lead(equations, i * h, q, v)
        v = v + h * acceleration(i * h, q, v)
        return q + h * v, v, a

    def verlet(i: Any, state: Any, h: Any) -> Any:
        q, v, a = state
        q, v = lead(equations, i * h, q, v)
        q, expected = q + h * v + 0.5 * h * h * a, v + h * a
        q, expected = lead(equations, (i + 1) * h, q, expected)
        after = acceleration((i + 1) * h, q, expected)
        return q, v + 0.5 * h * (a + after), after

    step = euler if method == "Euler" else verlet

    def run(q: Any, v: Any, steps: Any, h: Any) -> Any:
        first = acceleration(0.0, q, v)
        return jax.lax.fori_loop(0, steps, lambda i, state: step(i, state, h), (q, v, first))[0]

    return jax.jit(run)


class _Solver(_Run):
    _compiled: dict[tuple[int, str], Any] = {}  # noqa: RUF012

    def __init__(self, equations: Equations, solver: str, tolerance: float) -> None:
        super().__init__(equations)
        key = id(equations), solver
        if key not in self._compiled:
            self._compiled[key] = _solver(equations, solver)
        run = self._compiled[key]
        self._solve = lambda q, v: run(q, v, tolerance)
        run(*self._start, 1e3).block_until_ready()


def _solver(equations: Equations, solver: str) -> Any:
    """A compiled function (q, v, tolerance) that returns where masses are in the end, or no numbers."""
    jax = jax_in_double()
    diffrax = package("diffrax")

    acceleration = acceleration_of(equations)
    fixed = equations.held[:, None]

    def slope(t: Any, y: Any, _: Any) -> Any:
        q, v = y
        return jax.numpy.where(fixed, 0.0, v), acceleration(t, q, v)

    def solve(q: Any, v: Any, tolerance: Any) -> Any:
        found = diffrax.diffeqsolve(
            diffrax.ODETerm(slope), getattr(diffrax, solver)(), 0.0, SECONDS, None, (q, v),
            stepsize_controller=diffrax.PIDController(rtol=RELATIVE * tolerance, atol=tolerance),
            saveat=diffrax.SaveAt(t1=True), max_steps=MAX_STEPS, throw=False,
            adjoint=diffrax.DirectAdjoint() if solver == "Kvaerno5" else diffrax.ForwardMode(),
        )  # fmt: skip
        bad = found.result != diffrax.RESULTS.successful
        return jax.numpy.where(bad, jax.numpy.nan, found.ys[0][0])

    return jax.jit(solve)
