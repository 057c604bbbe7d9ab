"""A session's hands, where a body cannot follow at once, and its second body; without a browser."""

from __future__ import annotations

from unittest import mock

import numpy as np
import pytest

import sim
from app.session import commands
from app.session.ghost import FINER
from app.session.pacing import HEAVY_UNIT, Costs
from app.stage.colors import palette
from app.ui import readouts
from app.words import speaking
from studies.bench import frames
from tests.app.pages import BUDGET, FRAME, SessionPage, in_one_piece


def rate_limited() -> SessionPage:
    """The tutorial's rope in a hundred pieces, hanging already."""
    page = SessionPage(frames.rod(100, sim.Integrator()))
    page.frames(30)
    assert page.simulation.rate_limited
    return page


def hud(page: SessionPage) -> str:
    return readouts.hud(page.session, palette("softrod", dark=False), at_rest=False)


def torn(page: SessionPage, far: float, reports: int = 12) -> tuple[float, float]:
    """Tear the anchor to and fro; where it was."""
    x, y = page.drag(0)
    for report in range(reports):
        page.frames(3, commands.Point(x + far * (report % 2), y))
    return x, y


@pytest.mark.parametrize("far", [500.0, 1e5])
def test_an_anchor_torn_away_does_not_stop_the_clock(far: float) -> None:
    page = rate_limited()
    # Few milliseconds of computing in a frame, whatever the machine.
    in_one_piece(page.session.costs, 1000)
    behind, light = page.session.pacer.behind, hud(page)
    torn(page, far)
    assert page.session.pacer.behind - behind <= FRAME
    assert page.simulation.divergence is None
    told = hud(page)
    assert "cannot follow" not in light
    assert "the body cannot follow so fast: the hand is" in told
    assert "px behind" in told


def test_an_anchor_that_was_let_go_still_comes_to_where_the_pointer_left_it() -> None:
    page = rate_limited()
    x, y = torn(page, 400.0)
    page.frames(1, commands.DragEnd())
    assert not page.session.hands.masses
    assert np.hypot(*(page.simulation.positions[0] - (x + 400.0, y))) > 0.0
    page.frames(120)
    assert page.simulation.positions[0] == pytest.approx((x + 400.0, y), abs=1e-6)
    assert "behind" not in hud(page)


def test_time_stands_for_the_hand_of_a_demanding_body_too() -> None:
    page = rate_limited()
    page.frames(1, commands.Play(False))
    x, y = torn(page, 400.0, reports=2)
    assert page.simulation.positions[0] == pytest.approx((x, y))
    page.frames(1, commands.DragEnd())
    page.frames(120, commands.Play())
    assert page.simulation.positions[0] == pytest.approx((x + 400.0, y), abs=1e-6)


@pytest.mark.parametrize("method", ["rk4", "symplectic_euler", "auto", "adams"])
def test_a_ghost_is_led_as_the_body_is(method: str) -> None:
    page = rate_limited()
    page.frames(1, commands.Compare(method, ""))
    x, y = page.drag(0)
    ghost = page.ghost
    for report in range(8):
        page.frames(3, commands.Point(x + 300.0 * (report % 2), y))
        if ghost.simulation.divergence is None:  # as explicit methods with such a step do
            apart = ghost.simulation.positions[0] - page.simulation.positions[0]
            assert np.hypot(*apart) < 0.5
    page.frames(1, commands.DragEnd())


# ---------------------------------------------------------------------------------------------- the ghost


def test_a_ghost_of_finer_steps_shows_how_wrong_the_body_s_are() -> None:
    page = SessionPage()
    apart = {}
    for finer in FINER:
        page.frames(1, commands.Reset(), commands.Compare("symplectic_euler", "", finer))
        ghost = page.ghost
        assert ghost.simulation.dt == pytest.approx(0.0025 / finer)
        page.drag(0, 60.0, frames=30)
        assert ghost.simulation.time == pytest.approx(page.simulation.time)
        assert ghost.simulation.positions[0] == pytest.approx(page.simulation.positions[0])
        page.frames(1, commands.DragEnd())
        apart[finer] = ghost.worst
    assert apart[1] == 0.0
    # Of first order: what is left at a half is a half of what the whole step is wrong by.
    assert 0.01 < apart[2] < apart[4] < apart[10]
    assert 1.4 < apart[10] / apart[2] < 2.0
    assert "Euler, step / 10" in readouts.ghost_table(page.session)


def test_a_ghost_that_is_late_is_not_compared_and_catches_up() -> None:
    page = SessionPage()
    page.frames(20, commands.Compare("symplectic_euler", "", 10))
    ghost = page.ghost
    before = ghost.distance
    costs, ghost.costs = ghost.costs, Costs()
    in_one_piece(ghost.costs, 9)
    page.frames(20, commands.SetValue("gravity", 10.0))
    late = page.simulation.time - ghost.simulation.time
    assert late > 0.2
    assert ghost.distance == before
    page.frames(1, commands.GoBack(0.1))
    page.frames(1, commands.GoTo(1e9))
    assert page.simulation.time - ghost.simulation.time == pytest.approx(late)
    ghost.costs = costs
    page.frames(5, commands.Play(True))
    assert ghost.simulation.time == pytest.approx(page.simulation.time)
    assert ghost.distance != before


def test_a_ghost_has_the_time_that_the_body_leaves() -> None:
    page = SessionPage()
    page.frames(5, commands.Compare("rk4", "", 10))
    ghost = page.ghost
    ghost.costs.learn(1, 10.0 * BUDGET / 20.0, 10)
    with mock.patch.object(ghost.simulation, "step", wraps=ghost.simulation.step) as step:
        page.frames(1)
    assert 8 <= step.call_args_list[0].args[1] <= 20
    ghost.costs.learn(1, 10.0 * HEAVY_UNIT, 1)
    assert page.session.is_heavy


def test_a_reset_forgets_how_far_off_the_ghost_has_been() -> None:
    page = SessionPage()
    page.frames(1, commands.Compare("symplectic_euler", "", 4))
    ghost = page.ghost
    page.drag(0, 60.0, frames=30)
    page.frames(30, commands.DragEnd())
    assert 0.0 < ghost.distance <= ghost.worst
    page.frames(1, commands.Play(False), commands.Reset())
    assert page.session.ghost is ghost
    assert (ghost.distance, ghost.worst) == (0.0, 0.0)


def test_a_ghost_of_a_finer_tolerance() -> None:
    page = SessionPage("study-w1")
    page.frames(20, commands.Compare("adams", "conservative", 10))
    ghost = page.ghost
    assert ghost.simulation.scene.integrator.tolerance == pytest.approx(0.01)
    assert ghost.simulation.dt == page.simulation.dt
    assert "Adams, tolerance / 10, Force law: Conservative" in readouts.ghost_table(page.session)
    with speaking("de"):
        assert "Adams, Toleranz / 10, Kraftgesetz: Konservativ" in readouts.ghost_table(page.session)


def test_a_ghost_s_step_is_one_that_a_scene_may_have() -> None:
    page = SessionPage(sim.set_value(sim.load_scene("tutorial-3.3"), "dt", 2.5e-6))
    page.frames(2, commands.Play(False), commands.Compare("rk4", "", 10), commands.DoSteps(10))
    assert not page.session.notices
    ghost = page.ghost
    assert 1e-6 <= ghost.simulation.dt <= 1.3e-6
    page.frames(2, commands.SetValue("dt", 1e-6), commands.DoSteps(10))
    assert not page.session.notices
    assert ghost.simulation.dt == 1e-6
    assert ghost.simulation.time == pytest.approx(page.simulation.time)
