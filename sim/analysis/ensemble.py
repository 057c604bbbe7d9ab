"""Runs many bodies, each with its own fixed step, for maps of a method's behaviour.

The work is spread over threads, since kernels release the GIL.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor, as_completed
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..errors import InputError
from ..methods.registry import METHODS
from ..motion.simulation import Simulation
from ..scene.types import Scene

_ATTEMPTS = 60
"""Attempts per step for a method that shortens steps that fail; one that needs more counts as failed."""


@dataclass(frozen=True)
class Member:
    """One body of an ensemble.

    Attributes:
        scene: the body and its start; the scene's method is not used.
        dt: time step, s.
        marks: ascending numbers of steps after which the state is recorded.
    """

    scene: Scene
    dt: float
    marks: tuple[int, ...]


@dataclass(frozen=True)
class Track:
    """The recorded states of a body.

    Attributes:
        positions: (marks, n, 2) px, in the order of the scene's masses. NaN from the mark before which the
            body ran away, by the limits of a `Simulation`, or the method found no step.
        velocities: (marks, n, 2) px/s, likewise.
    """

    positions: NDArray[np.float64]
    velocities: NDArray[np.float64]


def fixed_step_methods() -> list[str]:
    """The methods that an ensemble can use."""
    return [name for name, method in METHODS.items() if not method.adaptive]


def run_ensemble(
    members: Sequence[Member], method: str, threads: int | None = None
) -> Iterator[tuple[int, Track]]:
    """Run all members, and yield (index, track) of each when it is done, in any order.

    Args:
        members: the bodies; they may differ in everything.
        method: one of `fixed_step_methods()`.
        threads: number of threads; None for as many as there are cores.

    Raises:
        InputError: the method has no fixed step.
    """
    if method not in fixed_step_methods():
        raise InputError(f"method: {method!r} has no fixed step; {', '.join(fixed_step_methods())} have one")
    workers = threads or os.cpu_count() or 1
    with ThreadPoolExecutor(workers) as pool:
        waiting: set[Future[tuple[int, Track]]] = set()
        try:
            for i, member in enumerate(members):
                waiting.add(pool.submit(_run_member, i, member, method))
                if len(waiting) >= 4 * workers:
                    yield _finished(waiting)
            while waiting:
                yield _finished(waiting)
        finally:
            pool.shutdown(cancel_futures=True)


def _finished(waiting: set[Future[tuple[int, Track]]]) -> tuple[int, Track]:
    done = next(as_completed(waiting))
    waiting.remove(done)
    return done.result()


def _run_member(index: int, member: Member, method: str) -> tuple[int, Track]:
    simulation = Simulation(member.scene, dt=member.dt, integrator=method)
    shape = len(member.marks), len(member.scene.masses), 2
    positions, velocities = np.full((2, *shape), np.nan)
    for k, mark in enumerate(member.marks):
        steps = mark - simulation.step_count
        if simulation.step(steps, attempts=_ATTEMPTS * steps) < steps:
            break
        positions[k], velocities[k] = simulation.positions, simulation.velocities
    return index, Track(positions, velocities)


def marks(duration: float, dt: float, samples: int) -> tuple[int, ...]:
    """Numbers of steps, at least 1, that divide a duration (s) evenly into samples."""
    steps = max(1, round(duration / dt))
    return tuple(max(1, round(steps * (k + 1) / samples)) for k in range(samples))
