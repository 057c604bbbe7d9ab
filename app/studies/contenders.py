"""softrod's methods as a study runs them: in one call, and frame by frame as the page does."""

from __future__ import annotations

import time
from dataclasses import dataclass

import msgspec
import numpy as np
from numpy.typing import NDArray

import sim
from sim import Scene
from sim.methods import METHODS
from sim.stepping import FlowStepper

Points = NDArray[np.float64]

FRAMES = 60
"""Times at which a path is looked at, per second."""

ATTEMPTS = 3_000_000
"""Steps of error-controlled methods, kept or not, after which a run counts as failed."""


@dataclass(frozen=True)
class Setting:
    """A method with its step or tolerance.

    Attributes:
        method: a name of `sim.methods`, or of one of the other solvers.
        value: time step, s, or tolerance, px.
    """

    method: str
    value: float


@dataclass(frozen=True)
class Run:
    """What a setting did.

    Attributes:
        path: (frames, n, 2) px; only the last frame where it went in one call. None where it failed.
        seconds: of computing; tables and patterns of matrices are made before the clock starts.
        work: evaluations of the accelerations.
        failure: why there is no path, or empty.
    """

    path: Points | None
    seconds: float
    work: int
    failure: str = ""


def prepared(scene: Scene, setting: Setting, duration: float) -> tuple[sim.Simulation, int]:
    """A simulation by the setting, ready to go, and the time steps of a frame.

    A fixed step is rounded so that a whole number of them makes up a frame.
    """
    info = METHODS[setting.method]
    if info.adaptive:
        steps, integrator = 1, sim.Integrator(method=info.name, dt=1.0 / FRAMES, tolerance=setting.value)
    else:
        steps = max(1, round(1.0 / FRAMES / setting.value))
        integrator = sim.Integrator(method=info.name, dt=1.0 / FRAMES / steps)
    simulation = sim.Simulation(msgspec.structs.replace(scene, integrator=integrator))
    if info.implicit:
        stepper = simulation._stepper
        assert isinstance(stepper, FlowStepper)
        _ = stepper.solver.matrix
    return simulation, steps


def frame_count(duration: float) -> int:
    """Frames in a duration, s."""
    return max(1, round(duration * FRAMES))


def in_one_call(scene: Scene, setting: Setting, duration: float) -> Run:
    """Do the whole duration in one call."""
    return _run(scene, setting, duration, frames=1)


def frame_by_frame(scene: Scene, setting: Setting, duration: float) -> Run:
    """Do a call for each frame, each going on from what the one before left."""
    return _run(scene, setting, duration, frames=frame_count(duration))


def _run(scene: Scene, setting: Setting, duration: float, frames: int) -> Run:
    simulation, steps = prepared(scene, setting, duration)
    steps *= frame_count(duration) // frames
    path = np.empty((frames, len(scene.masses), 2))
    seconds, left = 0.0, ATTEMPTS
    for frame in range(frames):
        began = time.perf_counter()
        done = simulation.step(steps, left)
        seconds += time.perf_counter() - began
        effort = simulation.effort()
        left -= effort.steps + effort.rejected
        if simulation.divergence is not None:
            return Run(None, seconds, 0, f"ran away: {simulation.divergence.quantity}")
        if done < steps:
            return Run(None, seconds, 0, f"gave up after {ATTEMPTS} steps")
        path[frame] = simulation.positions
    return Run(path, seconds, 0)


def distance(one: Points, other: Points) -> float:
    """The largest distance between two places of a mass, px."""
    return float(np.sqrt(((one - other) ** 2).sum(-1)).max())
