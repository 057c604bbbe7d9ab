"""How far a session's body can be foretold, without a browser."""

from __future__ import annotations

import math

import numpy as np
import pytest

import sim
from app.session import commands, predictability
from app.session.pacing import Costs
from app.session.predictability import PredictabilityMeter
from app.ui import readouts
from tests.app.pages import SessionPage


def upright() -> sim.Scene:
    """A pendulum of one stiff arm that stands on its head: errors grow at a rate of 3.16 / s."""
    return sim.rope(
        2, 100.0, direction=(0.0, -1.0), driven=None, stiffness=1e6, damping=0.0, joints=False,
        gravity=(0.0, 1000.0), air_friction=0.0, integrator=sim.Integrator(method="auto"),
    )  # fmt: skip


def meter_of(page: SessionPage) -> PredictabilityMeter:
    assert page.session.predictability is not None
    return page.session.predictability


def test_errors_grow_as_fast_as_they_do() -> None:
    page = SessionPage(upright())
    assert readouts.predictability_table(page.session) == ""
    page.frames(30, commands.MeasurePredictability(True))
    assert meter_of(page).growth is None
    assert "being measured" in readouts.predictability_table(page.session)
    page.frames(60)
    growth = meter_of(page).growth
    assert growth == pytest.approx(math.sqrt(10.0), rel=0.05)
    told = readouts.predictability_table(page.session)
    assert "Errors grow × 2" in told
    assert "a tolerance of 0.1 px is kept." in told
    assert "any error grows" not in readouts.ghost_table(page.session)
    page.frames(1, commands.Compare("rk4", ""))
    assert "any error grows" in readouts.ghost_table(page.session)
    page.frames(1, commands.MeasurePredictability(False))
    assert page.session.predictability is None
    assert readouts.predictability_table(page.session) == ""


def test_the_body_does_not_notice() -> None:
    pages = [SessionPage() for _ in range(2)]
    pages[1].frames(0, commands.MeasurePredictability(True))
    for page in pages:
        page.drag(5, 50.0, frames=20)
        page.frames(10, commands.HoldKeys(frozenset({"up"})))
        page.frames(10, commands.DragEnd(), commands.SetValue("gravity", 500.0))
    one, other = (page.simulation for page in pages)
    assert np.array_equal(one.positions, other.positions)
    assert one.time == other.time


def test_hands_and_keys_reach_it() -> None:
    page = SessionPage()
    x, y = map(float, page.simulation.positions[5])
    page.frames(
        1,
        commands.MeasurePredictability(True),
        commands.DragStart(5, x, y),
        commands.HoldKeys(frozenset({"up"})),
    )
    for _ in range(10):
        page.frames(2, commands.Point(x + 80.0, y))
    body = page.simulation
    for one in meter_of(page).shadow.pair:
        assert one.time == pytest.approx(body.time)
        assert one.positions[5] == pytest.approx(body.positions[5])
        assert one.rest_length_scale == pytest.approx(body.rest_length_scale)
        assert np.hypot(*(one.positions - body.positions).T).max() < 5.0  # Euler's own error is in it
    page.frames(2, commands.DragEnd())
    assert meter_of(page).shadow.hair[:2, 5].any()


def test_going_back_finds_the_growth_of_then() -> None:
    page = SessionPage(upright())
    page.frames(100, commands.MeasurePredictability(True))
    then, at = meter_of(page).growth, page.simulation.time
    page.frames(50, commands.SetValue("gravity", 4000.0))
    assert meter_of(page).growth != then
    page.frames(1, commands.GoTo(at))
    assert meter_of(page).growth == pytest.approx(then)
    page.frames(60, commands.Play())
    assert meter_of(page).growth == pytest.approx(then, rel=0.1)
    page.frames(
        1, commands.MeasurePredictability(False), commands.MeasurePredictability(True), commands.GoTo(at)
    )
    assert meter_of(page).growth is None


def test_another_body_and_a_reset_begin_anew() -> None:
    page = SessionPage()
    page.frames(80, commands.MeasurePredictability(True))
    assert meter_of(page).growth is not None
    page.frames(2, commands.Reset())
    assert meter_of(page).growth is None
    page.frames(2, commands.SetValue("masses", 6.0))
    assert meter_of(page).shadow.hair.shape == (4, 6)
    page.frames(2, commands.Open(sim.load_scene("ring")))
    assert page.session.predictability is None
    assert not page.session.notices


def test_without_enough_time_it_sees_only_parts_of_the_motion(monkeypatch: pytest.MonkeyPatch) -> None:
    page = SessionPage(upright())
    page.frames(1, commands.MeasurePredictability(True))
    meter = meter_of(page)
    follow = meter.follow

    def hurried(simulation: sim.Simulation, steps: int, budget: float) -> None:
        # There is time for two steps of the seven of a frame.
        monkeypatch.setattr(predictability, "smoothed", lambda *_: budget / 2.0)
        meter.costs = Costs()
        follow(simulation, steps, budget)

    meter.follow = hurried  # type: ignore[method-assign]
    page.frames(400)
    assert not page.session.is_heavy
    meter.costs.learn(1, 1.0, 1)
    assert page.session.is_heavy
    assert meter.growth == pytest.approx(math.sqrt(10.0), rel=0.2)


def test_it_is_there_again_after_a_restart() -> None:
    page = SessionPage(upright())
    page.frames(1, commands.MeasurePredictability(True))
    again = SessionPage("ring")
    again.frames(1, commands.Resume(page.session.keepsake()))
    assert again.session.predictability is not None


def test_nothing_is_told_where_every_mass_is_held() -> None:
    page = SessionPage("tutorial-3.1")
    page.frames(80, commands.MeasurePredictability(True))
    assert "no mass is free" in readouts.predictability_table(page.session)
    assert meter_of(page).verdict == ""
