"""JAX: loops that XLA compiles, and diffrax's solvers. Compiling is not timed.

The first import of JAX sets it to double precision.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np

from sim import Scene

from ..engine import package, tolerance_text
from ..measure import Contender, ladder
from ..plain import PlainSystem
from ..runs import SECONDS, Failed, Floats, Runner
from .c_loop import euler_and_verlet
from .solvers import RELATIVE

TOLERANCES = tuple(10.0 ** (half / 2) for half in range(2, -9, -1))
"""px and px/s."""

MAX_UNKNOWNS = 400
"""Unknowns up to which diffrax's implicit solver takes part: it takes the Jacobian as a dense matrix."""

MAX_STEPS = 50_000
"""Steps after which a run is given up; XLA's loops cannot be interrupted."""


def jax_paths(scene: Scene) -> list[Contender]:
    """Loops on a rope or a net."""
    system = PlainSystem(scene)
    return euler_and_verlet("JAX", scene, lambda method, steps: _Loop(system, method, steps))


def diffrax_paths(scene: Scene) -> list[Contender]:
    """diffrax's solvers on a rope or a net."""
    system = PlainSystem(scene)
    solvers = ["Tsit5", "Dopri8"] + (["Kvaerno5"] if system.start.size <= MAX_UNKNOWNS else [])
    return [
        Contender(
            "diffrax",
            solver,
            ladder(TOLERANCES),
            tolerance_text,
            lambda value, solver=solver: _Solver(system, solver, value),
        )
        for solver in solvers
    ]


def jax_in_double() -> Any:
    """Import JAX and set it to double precision."""
    jax = package("jax")

    jax.config.update("jax_enable_x64", True)
    return jax


def acceleration_of(system: PlainSystem) -> Callable[[Any, Any, Any], Any]:
    """Return a function (t, q, v) of (n, 2) arrays that returns accelerations.

    A led mass is where it should be at the time t, whatever q and v say.
    """
    jax = jax_in_double()
    jnp = jax.numpy
    a, b = system.springs.T
    k, c, rest = system.numbers.T
    weight = np.where(system.held, 0.0, 1.0 / system.masses)[:, None]
    fall = np.where(system.held[:, None], 0.0, system.gravity)

    def acceleration(t: Any, q: Any, v: Any) -> Any:
        q, v = lead(system, t, q, v)
        along, relative = q[b] - q[a], v[b] - v[a]
        length = jnp.sqrt((along**2).sum(1))
        rate = (along * relative).sum(1) / length
        force = ((k * (length - rest) + c * rate) / length)[:, None] * along
        total = jnp.zeros_like(q).at[a].add(force).at[b].add(-force)
        return total * weight + fall

    return acceleration


def lead(system: PlainSystem, t: Any, q: Any, v: Any) -> tuple[Any, Any]:
    """Return positions and velocities with a led mass where it is at a time."""
    if system.circle is None:
        return q, v
    jnp = jax_in_double().numpy
    radius, frequency, ramp = system.circle
    gone = -jnp.expm1(-t / ramp)
    p, rate = 2.0 * math.pi * frequency * (t - ramp * gone), 2.0 * math.pi * frequency * gone
    place = system.start[:2] + radius * jnp.stack((jnp.sin(p), 1.0 - jnp.cos(p)))
    return q.at[0].set(place), v.at[0].set(radius * rate * jnp.stack((jnp.cos(p), jnp.sin(p))))


class _Run(Runner):
    """A compiled function from the start to the end."""

    def __init__(self, system: PlainSystem) -> None:
        start = system.start.reshape(-1, 4)
        self._system, self._start = system, (start[:, :2].copy(), start[:, 2:].copy())
        self._end: Any = None
        self._solve: Callable[[Any, Any], Any]

    def advance(self) -> None:
        # JAX returns before it has computed.
        self._end = np.asarray(self._solve(*self._start).block_until_ready())
        if not np.isfinite(self._end).all():
            raise Failed("ran away")

    def positions(self) -> Floats:
        found = self._end.copy()
        if self._system.circle is not None:
            found[0] = self._system.lead_at(SECONDS)[:2]
        return found


class _Loop(_Run):
    _compiled: dict[tuple[int, str], Any] = {}  # noqa: RUF012

    def __init__(self, system: PlainSystem, method: str, steps: int) -> None:
        super().__init__(system)
        if steps > MAX_STEPS:
            raise Failed(f"more than {MAX_STEPS} steps")
        key = id(system), method
        if key not in self._compiled:
            self._compiled[key] = _loop(system, method)
        run, h = self._compiled[key], SECONDS / steps
        self._solve = lambda q, v: run(q, v, steps, h)
        run(*self._start, 1, h).block_until_ready()


def _loop(system: PlainSystem, method: str) -> Any:
    """Return a compiled function (q, v, steps, h) that returns the positions at the end."""
    jax = jax_in_double()
    acceleration = acceleration_of(system)

    def euler(i: Any, state: Any, h: Any) -> Any:
        q, v, a = state
        q, v = lead(system, i * h, q, v)
        v = v + h * acceleration(i * h, q, v)
        return q + h * v, v, a

    def verlet(i: Any, state: Any, h: Any) -> Any:
        q, v, a = state
        q, v = lead(system, i * h, q, v)
        q, expected = q + h * v + 0.5 * h * h * a, v + h * a
        q, expected = lead(system, (i + 1) * h, q, expected)
        after = acceleration((i + 1) * h, q, expected)
        return q, v + 0.5 * h * (a + after), after

    step = euler if method == "Euler" else verlet

    def run(q: Any, v: Any, steps: Any, h: Any) -> Any:
        first = acceleration(0.0, q, v)
        return jax.lax.fori_loop(0, steps, lambda i, state: step(i, state, h), (q, v, first))[0]

    return jax.jit(run)


class _Solver(_Run):
    _compiled: dict[tuple[int, str], Any] = {}  # noqa: RUF012

    def __init__(self, system: PlainSystem, solver: str, tolerance: float) -> None:
        super().__init__(system)
        key = id(system), solver
        if key not in self._compiled:
            self._compiled[key] = _solver(system, solver)
        run = self._compiled[key]
        self._solve = lambda q, v: run(q, v, tolerance)
        run(*self._start, 1e3).block_until_ready()


def _solver(system: PlainSystem, solver: str) -> Any:
    """Return a compiled function (q, v, tolerance) that returns the positions at the end, or NaN."""
    jax = jax_in_double()
    diffrax = package("diffrax")

    acceleration = acceleration_of(system)
    fixed = system.held[:, None]

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
