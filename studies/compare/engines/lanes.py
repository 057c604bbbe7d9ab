"""Many ropes of 12 masses at once, by softrod, a loop in C, NumPy, SciPy and JAX.

Positions are those of every `EVERY`-th rope, which has a reference.
"""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Sequence
from typing import Any

import msgspec
import numpy as np

import sim
from sim import Scene
from sim.scene.types import Method

from ...bench.many import simulate_each, simulate_together
from ..engine import per_second, tolerance_text
from ..equations import Equations
from ..measure import Contender, ladder
from ..plain import PlainSystem
from ..runs import FRAME, PATIENCE, SECONDS, SOFTROD, Failed, Floats, Runner
from ..scenes import EVERY
from . import c_loop
from .jax_loops import jax_in_double
from .solvers import SolverRun

RATES = (240.0, 480.0, 960.0, 1920.0, 3840.0)
"""Steps per second of Euler."""

VERLET_RATES = (240.0, 360.0, 480.0, 960.0)
"""Steps per second of Verlet."""

LANES = 8
"""Ropes in a vector of the loop in C."""


def by_softrod(scenes: Sequence[Scene]) -> list[Contender]:
    """A `Simulation` for each rope, as anybody would write it, and `sim.run_many`."""

    def one_by_one(tolerance: float) -> Runner:
        return _Softrod(scenes, sim.Integrator(dt=FRAME, tolerance=tolerance), simulate_each)

    def together(method: Method) -> Callable[[float], Runner]:
        return lambda rate: _Softrod(scenes, sim.Integrator(method=method, dt=1.0 / rate), simulate_together)

    return [
        Contender(SOFTROD, "Auto, one by one", ladder((0.1,)), lambda value: f"{value:g} px", one_by_one),
        _at_rates(SOFTROD, "run_many, symplectic_euler", RATES, together("symplectic_euler")),
        _at_rates(SOFTROD, "run_many, velocity_verlet", VERLET_RATES, together("velocity_verlet")),
    ]


def by_c(scenes: Sequence[Scene]) -> list[Contender]:
    """One by one in the loop for any body, and eight at a time."""
    lanes = Lanes(scenes)
    name = "C loop"
    return [
        _at_rates(name, "Verlet, one by one", VERLET_RATES, lambda rate: OneByOne(lanes, rate)),
        _at_rates(name, "Euler, eight in a vector", RATES, lambda rate: Eights(lanes, rate, False)),
        _at_rates(name, "Verlet, eight in a vector", VERLET_RATES, lambda rate: Eights(lanes, rate, True)),
    ]


def by_numpy(scenes: Sequence[Scene]) -> list[Contender]:
    """All ropes in one array."""
    lanes = Lanes(scenes)
    return [_at_rates("NumPy", "Verlet, all in an array", VERLET_RATES, lambda rate: AllInOne(lanes, rate))]


def by_scipy(scenes: Sequence[Scene]) -> list[Contender]:
    """`solve_ivp` for each rope."""
    lanes = Lanes(scenes)
    equations = [Equations(scene) for scene in scenes]
    return [
        Contender(
            "SciPy",
            "LSODA, one by one",
            ladder((0.1,)),
            tolerance_text,
            lambda value: _SciPy(lanes, equations, value),
        )
    ]


def by_jax(scenes: Sequence[Scene]) -> list[Contender]:
    """All ropes in one array, compiled by XLA."""
    lanes = Lanes(scenes)
    return [_at_rates("JAX", "Verlet, all in an array", VERLET_RATES, lambda rate: _Jax(lanes, rate))]


def _at_rates(engine: str, method: str, rates: Sequence[float], make: Callable[[float], Runner]) -> Contender:
    return Contender(engine, method, ladder(rates), per_second("steps"), make)


class _Softrod(Runner):
    """softrod on all ropes."""

    def __init__(
        self,
        scenes: Sequence[Scene],
        integrator: sim.Integrator,
        simulate: Callable[[list[Scene]], list[Floats]],
    ) -> None:
        self._scenes = [msgspec.structs.replace(scene, integrator=integrator) for scene in scenes]
        self._simulate, self._ends = simulate, [np.empty(0)]
        simulate(self._scenes[:2])  # loads machine code

    def advance(self) -> None:
        self._ends = self._simulate(self._scenes)

    def positions(self) -> Floats:
        return np.concatenate(self._ends[::EVERY])


class Lanes:
    """The numbers of all ropes as arrays.

    Args:
        scenes: ropes that differ in their numbers and directions alone.

    Attributes:
        start: (ropes, masses, 4) x, y, vx, vy.
        stiffness, damping, rest, weight: (ropes,); weight is 1 / mass.
        gravity: px/s², downwards.
    """

    def __init__(self, scenes: Sequence[Scene]) -> None:
        self.systems = [PlainSystem(scene) for scene in scenes]
        self.start = np.array([one.start.reshape(-1, 4) for one in self.systems])
        numbers = np.array([one.numbers[0] for one in self.systems])
        self.stiffness, self.damping, self.rest = numbers.T.copy()
        self.weight = np.array([1.0 / one.masses[0] for one in self.systems])
        self.gravity = float(self.systems[0].gravity[1])


class _Lanes(Runner):
    """All ropes up to the end."""

    def __init__(self, lanes: Lanes, rate: float) -> None:
        self._lanes, self._steps = lanes, round(rate * SECONDS)
        self.end = lanes.start[:, :, :2]

    def positions(self) -> Floats:
        return np.concatenate(self.end[::EVERY])


class _Each(_Lanes):
    """A run for each rope."""

    _runs: Sequence[Runner]

    def restart(self) -> None:
        for run in self._runs:
            run.restart()

    def advance(self) -> None:
        for run in self._runs:
            run.advance()
        self.end = np.array([run.positions() for run in self._runs])


class OneByOne(_Each):
    """The loop in C for any body."""

    def __init__(self, lanes: Lanes, rate: float) -> None:
        super().__init__(lanes, rate)
        self._runs = [c_loop.Run(one, "Verlet", self._steps) for one in lanes.systems]


class _SciPy(_Each):
    """SciPy's LSODA."""

    def __init__(self, lanes: Lanes, equations: Sequence[Equations], tolerance: float) -> None:
        super().__init__(lanes, 1.0)
        self._runs = [SolverRun(one, "SciPy", "LSODA", tolerance, patience=PATIENCE) for one in equations]


class Eights(_Lanes):
    """Eight ropes side by side in each vector, in C."""

    def __init__(self, lanes: Lanes, rate: float, verlet: bool) -> None:
        super().__init__(lanes, rate)
        self._ropes, self._verlet = c_loop.library().ropes, verlet

    def advance(self) -> None:
        lanes = self._lanes
        ropes, masses, _ = lanes.start.shape
        groups = ropes // LANES
        # By group, mass and lane.
        parts = [
            np.ascontiguousarray(part.reshape(groups, LANES, masses).transpose(0, 2, 1))
            for part in np.moveaxis(lanes.start, -1, 0)
        ]
        numbers = lanes.stiffness, lanes.damping, lanes.rest, lanes.weight
        self._ropes(
            ctypes.c_long(groups), ctypes.c_long(masses), ctypes.c_long(self._steps),
            ctypes.c_double(SECONDS / self._steps), ctypes.c_long(self._verlet),
            ctypes.c_double(lanes.gravity),
            *map(c_loop.pointer, numbers), *map(c_loop.pointer, parts),
        )  # fmt: skip
        self.end = np.stack([p.transpose(0, 2, 1).reshape(ropes, masses) for p in parts[:2]], -1)
        if not np.isfinite(self.end).all():
            raise Failed("ran away")


def _verlet(np_: Any, lanes: Lanes) -> tuple[Callable[[Any, Any], Any], Callable[..., Any]]:
    """Return functions for accelerations and a step of Verlet of all ropes; arrays are (2, masses, ropes)."""
    pull, held = lanes.stiffness * lanes.rest, np.ones((1, lanes.start.shape[1], 1))
    held[0, 0] = 0.0
    fall = held * np.array((0.0, lanes.gravity))[:, None, None]
    weights = held * lanes.weight

    def accelerations(q: Any, v: Any) -> Any:
        along, relative = q[:, 1:] - q[:, :-1], v[:, 1:] - v[:, :-1]
        square = (along * along).sum(0)
        inverse = 1.0 / np_.sqrt(square)
        rate = (along * relative).sum(0)
        tension = (lanes.stiffness - pull * inverse + lanes.damping * rate * inverse * inverse) * along
        below = np_.concatenate((tension, np_.zeros_like(tension[:, :1])), 1)
        above = np_.concatenate((np_.zeros_like(tension[:, :1]), tension), 1)
        return (below - above) * weights + fall

    def step(q: Any, v: Any, a: Any, h: Any) -> Any:
        q, expected = q + h * v + 0.5 * h * h * a, v + h * a
        after = accelerations(q, expected)
        return q, v + 0.5 * h * (a + after), after

    return accelerations, step


class AllInOne(_Lanes):
    """NumPy."""

    def advance(self) -> None:
        accelerations, step = _verlet(np, self._lanes)
        parts = self._lanes.start.transpose(2, 1, 0)
        q, v = parts[:2].copy(), parts[2:].copy()
        a, h = accelerations(q, v), SECONDS / self._steps
        for _ in range(self._steps):
            q, v, a = step(q, v, a, h)
        self.end = q.transpose(2, 1, 0)


class _Jax(_Lanes):
    """JAX."""

    def __init__(self, lanes: Lanes, rate: float) -> None:
        super().__init__(lanes, rate)
        jax = jax_in_double()
        accelerations, step = _verlet(jax.numpy, lanes)

        def run(q: Any, v: Any, steps: Any, h: Any) -> Any:
            state = q, v, accelerations(q, v)
            return jax.lax.fori_loop(0, steps, lambda _, state: step(*state, h), state)[0]

        self._run = jax.jit(run)
        self._run(*self._start(), 1, SECONDS / self._steps).block_until_ready()

    def _start(self) -> tuple[Floats, Floats]:
        parts = self._lanes.start.transpose(2, 1, 0)
        return parts[:2], parts[2:]

    def advance(self) -> None:
        found = self._run(*self._start(), self._steps, SECONDS / self._steps).block_until_ready()
        self.end = np.asarray(found).transpose(2, 1, 0)
