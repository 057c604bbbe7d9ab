"""A thousand ropes of 12 masses at once, by softrod, a loop in C, NumPy, SciPy and JAX.

Errors are those of every `EVERY`-th rope, of which there is a reference.
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

from ..plain import Equations, Floats
from ..runs import FRAME, Failed, Ladder
from ..scenes import COUNT, EVERY, SECONDS, ropes
from . import c_loop, own, solvers

RATES = (240.0, 480.0, 960.0, 1920.0, 3840.0)
"""Steps a second: of Euler."""

VERLET_RATES = (240.0, 360.0, 480.0, 960.0)

LANES = 8
"""Ropes in a vector of the loop in C."""


def _steps(rate: float) -> str:
    return f"{rate:g} steps/s"


def ladders_of_softrod() -> list[Ladder]:
    """A `Simulation` each, made and moved, as anybody would write it; and `sim.run_many`, if there is one."""
    scenes = ropes(COUNT)
    made = [
        Ladder(
            own.NAME, "Auto, one by one", (0.1,), lambda value: f"{value:g} px",
            lambda value: _Own(scenes, sim.Integrator(dt=FRAME, tolerance=value), _one_by_one),
        )
    ]  # fmt: skip
    together: Any = getattr(sim, "run_many", None)
    if together is not None:

        def run(lanes: list[Scene]) -> list[Floats]:
            return [done.positions for done in together(lanes, SECONDS)]

        methods: tuple[tuple[Method, Sequence[float]], ...] = (
            ("symplectic_euler", RATES), ("velocity_verlet", VERLET_RATES),
        )  # fmt: skip
        for method, rates in methods:
            made.append(
                Ladder(
                    own.NAME,
                    f"run_many, {method}",
                    rates,
                    _steps,
                    lambda rate, m=method: _Own(scenes, sim.Integrator(method=m, dt=1.0 / rate), run),
                )
            )
    return made


def ladders_of_c() -> list[Ladder]:
    """One by one by the loop for any body, and eight at a time."""
    lanes = Lanes(ropes(COUNT))
    return [
        Ladder("C loop", "Euler, one by one", RATES, _steps, lambda rate: OneByOne(lanes, rate)),
        Ladder("C loop", "Euler, eight in a vector", RATES, _steps, lambda rate: Eights(lanes, rate)),
    ]


def ladders_of_numpy() -> list[Ladder]:
    """All ropes in an array."""
    lanes = Lanes(ropes(COUNT))
    return [
        Ladder("NumPy", "Verlet, all in an array", VERLET_RATES, _steps, lambda rate: AllInOne(lanes, rate))
    ]


def ladders_of_scipy() -> list[Ladder]:
    """`solve_ivp` for each."""
    lanes = Lanes(ropes(COUNT))
    text: Callable[[float], str] = lambda value: f"tolerance {value:g}"  # noqa: E731
    return [Ladder("SciPy", "LSODA, one by one", (0.1,), text, lambda value: _SciPy(lanes, value))]


def ladders_of_jax() -> list[Ladder]:
    """All ropes in an array, compiled by XLA."""
    lanes = Lanes(ropes(COUNT))
    return [Ladder("JAX", "Verlet, all in an array", VERLET_RATES, _steps, lambda rate: _Jax(lanes, rate))]


def _one_by_one(scenes: list[Scene]) -> list[Floats]:
    ends = []
    for scene in scenes:
        simulation = sim.Simulation(scene)
        simulation.advance(SECONDS)
        ends.append(simulation.positions)
    return ends


class _Own:
    """See `Runner`."""

    def __init__(
        self, scenes: list[Scene], integrator: sim.Integrator, run: Callable[[list[Scene]], list[Floats]]
    ) -> None:
        self._scenes = [msgspec.structs.replace(scene, integrator=integrator) for scene in scenes]
        self._run, self.ends = run, [np.empty(0)]
        run(self._scenes[:2])  # machine code

    def restart(self) -> None:
        pass

    def advance(self) -> None:
        self.ends = self._run(self._scenes)

    def positions(self) -> Floats:
        return np.concatenate(self.ends[::EVERY])


class Lanes:
    """Numbers of all ropes.

    Args:
        scenes: ropes that differ in their numbers and directions alone.

    Attributes:
        start: (ropes, masses, 4) x, y, vx, vy.
        stiffness, damping, rest, weight: (ropes,); weight is 1 / mass.
        gravity: px/s², downwards.
    """

    def __init__(self, scenes: Sequence[Scene]) -> None:
        self.equations = [Equations(scene) for scene in scenes]
        self.start = np.array([one.start.reshape(-1, 4) for one in self.equations])
        numbers = np.array([one.numbers[0] for one in self.equations])
        self.stiffness, self.damping, self.rest = numbers.T.copy()
        self.weight = np.array([1.0 / one.masses[0] for one in self.equations])
        self.gravity = float(self.equations[0].gravity[1])


class _Lanes:
    """What all of them have in common; see `Runner`."""

    def __init__(self, lanes: Lanes, rate: float) -> None:
        self._lanes, self._steps = lanes, round(rate * SECONDS)
        self.end = lanes.start[:, :, :2]

    def restart(self) -> None:
        pass

    def positions(self) -> Floats:
        return np.concatenate(self.end[::EVERY])


class OneByOne(_Lanes):
    def __init__(self, lanes: Lanes, rate: float) -> None:
        super().__init__(lanes, rate)
        self._runs = [c_loop.Run(one, "Euler", self._steps) for one in lanes.equations]

    def restart(self) -> None:
        for run in self._runs:
            run.restart()

    def advance(self) -> None:
        for run in self._runs:
            run.advance()
        self.end = np.array([run.positions() for run in self._runs])


class Eights(_Lanes):
    def __init__(self, lanes: Lanes, rate: float) -> None:
        super().__init__(lanes, rate)
        self._ropes = c_loop.library().ropes

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
            ctypes.c_double(SECONDS / self._steps), ctypes.c_double(lanes.gravity),
            *map(c_loop.pointer, numbers), *map(c_loop.pointer, parts),
        )  # fmt: skip
        self.end = np.stack([p.transpose(0, 2, 1).reshape(ropes, masses) for p in parts[:2]], -1)
        if not np.isfinite(self.end).all():
            raise Failed("ran away")


def _verlet(np_: Any, lanes: Lanes) -> tuple[Callable[[Any, Any], Any], Callable[..., Any]]:
    """Accelerations, and a step of Verlet, of all ropes; arrays are (2, masses, ropes)."""
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
    def advance(self) -> None:
        accelerations, step = _verlet(np, self._lanes)
        parts = self._lanes.start.transpose(2, 1, 0)
        q, v = parts[:2].copy(), parts[2:].copy()
        a, h = accelerations(q, v), SECONDS / self._steps
        for _ in range(self._steps):
            q, v, a = step(q, v, a, h)
        self.end = q.transpose(2, 1, 0)


class _Jax(_Lanes):
    def __init__(self, lanes: Lanes, rate: float) -> None:
        super().__init__(lanes, rate)
        from .jax_loops import jax_in_double

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
        found = self._run(*self._start(), self._steps, SECONDS / self._steps)
        self.end = np.asarray(found).transpose(2, 1, 0)


class _SciPy(_Lanes):
    def __init__(self, lanes: Lanes, tolerance: float) -> None:
        super().__init__(lanes, 1.0)
        self._runs = [solvers.SciPyRun(one, "LSODA", tolerance) for one in lanes.equations]

    def restart(self) -> None:
        for run in self._runs:
            run.restart()

    def advance(self) -> None:
        for run in self._runs:
            run.advance()
        self.end = np.array([run.positions() for run in self._runs])
