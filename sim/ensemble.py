"""Many bodies at once, each with a fixed step of its own: what a map of a method's behaviour is made of.

Bodies that are chains go through `kernels.ensemble`, eight in a vector; all others one by one, by the same
kernels that run a simulation. Either way the work is spread over threads, since kernels hold no lock.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor, as_completed
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from .errors import InputError
from .kernels import ensemble as lanes
from .kernels.controls import refresh
from .kernels.tables import ANGLE, Body, Floats, Live
from .methods import METHODS
from .scene import MAX_COORDINATE, RUNAWAY_SPEED, Scene
from .simulation import Simulation
from .system import System, build_system, new_live
from .weaken import weakened

LANES = int(lanes.LANES)
"""Bodies that are stepped together."""

_CODES = {
    "symplectic_euler": lanes.EULER,
    "stable_spring": lanes.EULER,  # on weakened tables
    "velocity_verlet": lanes.VERLET,
    "rk4": lanes.RUNGE_KUTTA_4,
}
_FIELDS = int(lanes.FIELDS)
_ATTEMPTS = 60
"""Attempts per step that a method gets which shortens a step that fails; one that needs more has given up."""


@dataclass(frozen=True)
class Member:
    """One body of an ensemble.

    Attributes:
        scene: what starts; its own method is not used.
        dt: time step, s.
        marks: numbers of steps, ascending, after which the state is kept.
    """

    scene: Scene
    dt: float
    marks: tuple[int, ...]


@dataclass(frozen=True)
class Track:
    """How a body went.

    Attributes:
        positions: (marks, n, 2) px, in the order of the scene's masses. From the mark on at which a body has
            run away by the limits of a `Simulation`, or found no way on, NaN.
        velocities: (marks, n, 2) px/s, likewise.
    """

    positions: NDArray[np.float64]
    velocities: NDArray[np.float64]


def fixed_step_methods() -> list[str]:
    """The methods that an ensemble can be run by."""
    return [name for name, method in METHODS.items() if not method.adaptive]


def run_ensemble(
    members: Sequence[Member], method: str, threads: int | None = None
) -> Iterator[tuple[int, Track]]:
    """Run all members, and give (index, track) of each when it is done, in no order.

    Args:
        members: the bodies; they may differ in everything.
        method: one of `fixed_step_methods()`.
        threads: how many; None for as many as there are cores.

    Raises:
        InputError: the method has no fixed step.
    """
    if method not in fixed_step_methods():
        raise InputError(f"method: {method!r} has no fixed step; {', '.join(fixed_step_methods())} have one")
    workers = threads or os.cpu_count() or 1
    jobs = _jobs(members, method)
    with ThreadPoolExecutor(workers) as pool:
        waiting: set[Future[list[tuple[int, Track]]]] = set()
        try:
            for job in jobs:
                waiting.add(pool.submit(_run_job, members, method, job))
                if len(waiting) >= 4 * workers:
                    yield from _finished(waiting)
            while waiting:
                yield from _finished(waiting)
        finally:
            pool.shutdown(cancel_futures=True)


def _finished(waiting: set[Future[list[tuple[int, Track]]]]) -> Iterator[tuple[int, Track]]:
    done = next(as_completed(waiting))
    waiting.remove(done)
    yield from done.result()


def _jobs(members: Sequence[Member], method: str) -> Iterator[list[int]]:
    """Batches of chains of the same length that take about as many steps, and single bodies."""
    groups: dict[tuple[int, int], list[int]] = {}
    for i, member in enumerate(members):
        body = _tables(member.scene).body
        if method in _CODES and _vectorised(member.scene, body):
            groups.setdefault((body.masses, body.law), []).append(i)
        else:
            yield [i]
    for group in groups.values():
        group.sort(key=lambda i: members[i].marks[-1])
        for start in range(0, len(group), LANES):
            yield group[start : start + LANES]


def _vectorised(scene: Scene, body: Body) -> bool:
    moving = any(anchor.circle is not None for anchor in scene.anchors)
    return body.chain and body.law != ANGLE and not body.twisted and not moving


@lru_cache(maxsize=4096)
def _tables(scene: Scene) -> System:
    return build_system(scene)


def _run_job(members: Sequence[Member], method: str, job: list[int]) -> list[tuple[int, Track]]:
    chosen = [members[i] for i in job]
    system = _tables(chosen[0].scene)
    if method in _CODES and _vectorised(chosen[0].scene, system.body):
        return list(zip(job, _run_lanes(chosen, method), strict=True))
    return [(i, _run_alone(member, method)) for i, member in zip(job, chosen, strict=True)]


def _run_alone(member: Member, method: str) -> Track:
    """One body by the kernels of a simulation."""
    simulation = Simulation(member.scene, dt=member.dt, integrator=method)
    shape = len(member.marks), len(member.scene.masses), 2
    positions, velocities = np.full((2, *shape), np.nan)
    for k, mark in enumerate(member.marks):
        steps = mark - simulation.step_count
        if simulation.step(steps, attempts=_ATTEMPTS * steps) < steps:
            break
        positions[k], velocities[k] = simulation.positions, simulation.velocities
    return Track(positions, velocities)


def _run_lanes(members: Sequence[Member], method: str) -> Iterator[Track]:
    """Up to LANES chains of the same length, together."""
    systems = [_tables(member.scene) for member in members]
    n, law = systems[0].body.masses, systems[0].body.law
    data = np.zeros((n + 2, _FIELDS, LANES))
    live = new_live(systems[0])  # of the same size for all
    for lane, (member, system) in enumerate(zip(members, systems, strict=True)):
        _fill(data[:, :, lane], live, member, system, method == "stable_spring")
    steps = np.zeros(LANES)
    steps[: len(members)] = [member.dt for member in members]
    flat = aligned(data.size)
    flat[:] = data.ravel()
    data = flat.reshape(data.shape)
    data[:, int(lanes.STEP)] = steps
    if _CODES[method] == lanes.EULER:
        data[:, int(lanes.WEIGHT) : int(lanes.STEP)] *= steps
    own = data[:, int(lanes.WEIGHT) : int(lanes.STEP) + 1].copy()
    carry = aligned(lanes.CARRIED)
    looks = max(len(member.marks) for member in members)
    states = np.full((looks, 4, n, LANES), np.nan)
    done = np.zeros(LANES, np.int64)
    for k in range(looks):
        until = done.copy()
        for lane, member in enumerate(members):
            until[lane] = member.marks[min(k, len(member.marks) - 1)]
        data[:, int(lanes.WEIGHT) : int(lanes.STEP) + 1] = own
        lanes.run_ensemble(flat, carry, until - done, n, law, _CODES[method], k == 0)
        done = until
        states[k] = data[1 : n + 1, int(lanes.X) : int(lanes.VY) + 1].swapaxes(0, 1)
    return (
        _track(states[: len(member.marks), :, :, lane], system.mass_place - 1)
        for lane, (member, system) in enumerate(zip(members, systems, strict=True))
    )


def _track(states: Floats, place: NDArray[np.int64]) -> Track:
    """From (marks, 4, n) states in the order of places."""
    with np.errstate(invalid="ignore"):
        good = (np.abs(states[:, :2]) <= MAX_COORDINATE).all((1, 2))
        good &= (np.abs(states[:, 2:]) <= RUNAWAY_SPEED).all((1, 2))
    bad = ~np.logical_and.accumulate(good)
    states = np.where(bad[:, None, None], np.nan, states)[:, :, place]
    return Track(*(np.ascontiguousarray(half.swapaxes(1, 2)) for half in (states[:, :2], states[:, 2:])))


def _fill(lane: Floats, live: Live, member: Member, system: System, weak: bool) -> None:
    """Write one body into its lane, (n + 2, FIELDS); `live` is scratch."""
    scene, body = member.scene, system.body
    if weak:
        body = weakened(body, system.inverse_mass, system.held, member.dt)
    live.controls[:] = scene.rest_length_scale, 0.0
    refresh(body, live)
    masses, springs = slice(1, body.masses + 1), slice(1, body.springs + 1)
    free = np.where(system.held, 0.0, 1.0)
    columns = {
        lanes.WEIGHT: free * system.inverse_mass,
        lanes.AIR: free * system.inverse_mass * scene.air_friction,
        lanes.GX: free * scene.gravity[0],
        lanes.GY: free * scene.gravity[1],
    }
    for field, column in zip((lanes.X, lanes.Y, lanes.VX, lanes.VY), system.start, strict=True):
        columns[field] = column
    for field, column in columns.items():
        lane[masses, int(field)] = column
    for field, column in (
        (lanes.STIFFNESS, body.stiffness),
        (lanes.DAMPING, body.damping),
        (lanes.PULL, live.pull),
        # The joint before a spring, so that there is none at the first.
        (lanes.COUPLE_COS, live.couple_cos),
        (lanes.COUPLE_SIN, live.couple_sin),
        (lanes.COUPLE_SIZE, body.couple_size),
    ):
        lane[springs, int(field)] = column[: body.springs]


def aligned(size: int) -> Floats:
    """Zeros, the first of which stands where a vector may be loaded at once: at a multiple of 64 bytes."""
    block = np.zeros(size + 8)
    start = -block.ctypes.data % 64 // 8
    return block[start : start + size]


def marks(duration: float, dt: float, looks: int) -> tuple[int, ...]:
    """Steps after which a body is looked at, evenly over a duration (s); the first is 1 at least."""
    steps = max(1, round(duration / dt))
    return tuple(max(1, round(steps * (k + 1) / looks)) for k in range(looks))
