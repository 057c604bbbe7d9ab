"""A pendulum that somebody has built and recorded, fitted; the source is in `free_swing.csv`."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

import sim
from sim.design.measurements import read_measurements
from tests.sim.builders import built

DATA = Path(__file__).with_name("free_swing.csv")
ZERO = 0.7
"""Degrees that the encoder shows where the pendulum hangs: about the middle of its turning points."""
LENGTH = 90.0
"""Of the guess, px; of which 1000 are a metre."""
MODEL_LENGTH, MODEL_DAMPING = 82.8, 0.0292
"""Length of the simple pendulum that swings as the source's model (`model.py`, its arm held), mm, and the
model's damping ratio: the inertia is 7/12 m l², the weight's torque 1.93 m g l / 2, and c = 0.000667 N m s,
with m = 95.7 g and l = 137 mm. The author found 1.93 and most of m by comparing with a recording."""


def read_off(times: np.ndarray, angles: np.ndarray) -> tuple[float, float]:
    """The length of the simple pendulum, mm, by the time from one passage to the next in the same sense; and
    the damping ratio, by the logarithmic decrement of the two turning points between them."""
    angles = angles - ZERO
    down = np.flatnonzero((angles[:-1] >= 0.0) & (angles[1:] < 0.0))
    passages = times[down] + angles[down] / (angles[down] - angles[down + 1]) * np.diff(times)[0]
    near, far = -float(angles.min()), float(angles.max())
    swing = math.radians(0.5 * (near + far))
    # Of small swings: the period of a pendulum grows as 1 + a² / 16 + 11 a⁴ / 3072.
    period = float(passages[1] - passages[0]) / (1.0 + swing**2 / 16.0 + 11.0 * swing**4 / 3072.0)
    return 9810.0 * (period / (2.0 * math.pi)) ** 2, math.log(near / far) / math.pi


def test_a_recorded_swing_gives_the_length_and_the_loss_that_are_read_off_it() -> None:
    """What agrees: the length, to 2 % with the period and with the source's own model. What a swing loses
    agrees to a fifth only: the bearing's friction is no drag of the air, and the scene has no other. The fit
    says that something is lacking, and its intervals are wide."""
    (table,) = read_measurements(DATA)
    length, damping = read_off(table.time, table.columns[0].values)
    guess = built(
        [(0.0, 0.0), (0.0, LENGTH)], velocities=[(0.0, 0.0), (-500.0, 0.0)], stiffness=2e5, held=(0,),
        gravity=(0.0, 9810.0), air_friction=1e-3,
    )  # fmt: skip
    match = {"angle": f"{90.0 + ZERO} - spring0.direction"}
    found = sim.fit(guess, DATA, ["gravity", "mass1.vx", "air_friction"], match)
    gravity, (series,) = found.values["gravity"], found.series
    # The swing tells g / length; g is known, and so is the length.
    best, low, high = (LENGTH * 9810.0 / g for g in (gravity.value, gravity.high, gravity.low))
    assert best == pytest.approx(length, rel=0.02)
    assert low < MODEL_LENGTH < high
    assert best == pytest.approx(MODEL_LENGTH, rel=0.02)
    assert read_off(series.time, series.fitted)[1] == pytest.approx(damping, rel=0.25)
    assert damping == pytest.approx(MODEL_DAMPING, rel=0.1)
    assert series.noise < 0.6  # degrees, of swings of 40
    assert any("The scene may lack something." in sentence for sentence in found.sentences)
