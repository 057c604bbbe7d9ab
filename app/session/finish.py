"""Where a race ends, and when a body gets there."""

from __future__ import annotations

import math

import numpy as np

import sim
from sim.edit.terrain import center

TRIAL = 6.0
"""Simulated seconds after which the faster body, left to itself, is about at the finish."""

MAX_WORK = 2_000_000
"""Time steps times masses, springs and joints of a trial: a second or two. Larger ones are not tried out."""

TRAVELS = 0.1
"""Part of its length by which a body that travels comes in a trial; others only swing."""


def finish_of(one: sim.Scene, other: sim.Scene, wait: bool = True) -> float:
    """Return the way to the finish along x, a round number of px; negative to the left.

    It is what the faster of two bodies comes in `TRIAL` seconds. Where neither travels by itself, or that
    would take too long to find out, it is the length of the longer one, to the right.

    Args:
        one, other: their scenes.
        wait: whether the trial may wait for the compiler.
    """
    bodies = [sim.Simulation(scene, wait=wait) for scene in (one, other)]
    length = max(float(np.ptp(body.positions, axis=0).max(initial=0.0)) for body in bodies)
    if length == 0.0:
        left, _, right, _ = one.view.frame
        length = 0.5 * (right - left)
    way = max(map(_way, bodies), key=abs)
    return _rounded(way if abs(way) >= TRAVELS * length else length)


def arrival(before: sim.Moment, steps: int, line: float, wait: bool = True) -> float | None:
    """Return the seconds after a moment at which the centre of mass crosses a line.

    The steps are done once more, one at a time, so that the result does not depend on how many a frame has.

    Args:
        before: the moment.
        steps: time steps after it, at most.
        line: its x, px.
        wait: whether the steps may wait for the compiler.

    Returns:
        The seconds, interpolated within a step; None if it does not get there without hands and keys.
    """
    scene = before.scene
    body = sim.Simulation(scene, wait=wait)
    body.restore(before)
    x = center(scene, body.positions)
    side = x < line
    for step in range(steps):
        last = x
        body.step(1)
        x = center(scene, body.positions)
        if (x < line) != side:
            return (step + (line - last) / (x - last)) * body.dt
    return None


def _way(body: sim.Simulation) -> float:
    """How far a body comes along x in a trial, px; 0 if that would take too long to find out."""
    scene, steps = body.scene, round(TRIAL / body.dt)
    parts = len(scene.masses) + len(scene.linear_springs) + len(scene.angular_springs)
    if body.plain or steps * parts > MAX_WORK:
        return 0.0
    start = center(scene, body.positions)
    body.step(steps)
    return center(scene, body.positions) - start if body.divergence is None else 0.0


def _rounded(way: float) -> float:
    """The nearest number with at most two digits, of which the second is 0 or 5."""
    half = 0.5 * 10.0 ** math.floor(math.log10(abs(way)))
    return float(f"{round(way / half) * half:.2g}")
