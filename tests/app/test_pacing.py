"""The clock: what is owed, what is lost, and what the page is told of it."""

from __future__ import annotations

import pytest

from app.session.pacing import Pacer
from sim.motion.solver import SolverStats

DT = 0.01
FRAME = 0.05


def ran(pacer: Pacer, frames: int, missed: int = 0) -> float:
    """Let frames pass, each of five time steps, so many of which are not reached; the time."""
    now = 0.0
    pacer.grant(now, DT)
    for _ in range(frames):
        now += FRAME
        steps = pacer.grant(now, DT)
        assert steps == 5
        pacer.record(now, DT, steps - missed, 1e-3, SolverStats(steps=steps - missed), missed)
    return now


def test_a_clock_that_keeps_up_is_not_behind() -> None:
    pacer = Pacer()
    rates = pacer.rates(ran(pacer, 12))
    assert (rates.behind, rates.losing) == (0.0, 0.0)
    assert rates.real_time_factor == pytest.approx(1.0)


def test_steps_that_were_granted_and_not_reached_are_lost() -> None:
    pacer = Pacer()
    rates = pacer.rates(ran(pacer, 12, missed=2))
    assert pacer.behind == pytest.approx(12 * 2 * DT)
    assert rates.behind == pytest.approx(12 * 2 * DT)
    assert rates.losing == pytest.approx(12 * 2 * DT)
    assert rates.real_time_factor == pytest.approx(0.6)
    pacer.restart()
    assert pacer.behind == 0.0


def test_what_is_lost_is_of_the_last_second() -> None:
    pacer = Pacer()
    rates = pacer.rates(ran(pacer, 60, missed=1))
    assert rates.behind == pytest.approx(60 * DT)
    assert rates.losing == pytest.approx(20 * DT, abs=1.5 * DT)
