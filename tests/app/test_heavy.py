"""A heavy body holds up neither the other pages nor its own controls: the order of events."""

from __future__ import annotations

import threading

import pytest

import sim
from app.pages.sandbox.tab import Tab
from app.server.ticker import LONGEST_FRAME, next_frame
from app.session import commands
from app.session.pacing import HEAVY_UNIT, Costs, is_large
from app.session.session import FRAME, Session
from app.wire.from_page import Perform
from app.wire.to_page import PageState
from studies.bench.tabs import cloth
from tests.app.hostile import eventually
from tests.app.test_serving import Stage, say, session_of, stage  # noqa: F401


def told(tab: Tab) -> PageState:
    state = tab.probe().state
    assert state is not None
    return state


def test_others_go_on_and_pause_is_answered_while_a_step_takes_its_time(
    stage: Stage,  # noqa: F811
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    with stage.opened() as (one, heavy), stage.opened() as (other, light):
        session = session_of(heavy)
        say(one, Perform("plot"), Perform("gizmos"))
        eventually(lambda: told(heavy).gizmos)
        begun, go_on = threading.Event(), threading.Event()
        tick = Session.tick

        def slow(self: Session, *given: float) -> None:
            if self is session:
                begun.set()
                assert go_on.wait(30.0)
            tick(self, *given)

        monkeypatch.setattr(Session, "is_heavy", property(lambda self: self is session))
        monkeypatch.setattr(Session, "tick", slow)
        try:
            assert begun.wait(10.0)
            steps = session_of(light).simulation.step_count
            eventually(lambda: session_of(light).simulation.step_count > steps + 30)
            assert told(heavy).playing
            say(one, Perform("pause"))
            eventually(lambda: not told(heavy).playing)
            assert session.playing  # it is not applied before the step is done
            # Nor does the page forget a switch.
            assert told(heavy).gizmos
            other.read_for(0.05)
        finally:
            go_on.set()
        eventually(lambda: not session.playing)


def test_a_scene_is_heavy_by_its_size_or_by_what_its_steps_cost() -> None:
    session = Session(sim.rope(12))
    assert not session.is_heavy
    session.post(commands.Open(cloth(40)))
    assert session.is_heavy  # also while it is only about to be opened
    assert is_large(cloth(40))
    assert not is_large(cloth(20))

    costs = Costs()
    costs.learn(10, 10 * 0.9 * HEAVY_UNIT, 10)
    assert costs.unit < HEAVY_UNIT
    session.costs = costs
    session.drain()
    assert session.is_heavy


def test_frames_grow_longer_with_the_work_but_never_beyond_their_limit() -> None:
    def after(worked: float) -> float:
        frame = FRAME
        for _ in range(100):
            frame = next_frame(frame, worked)
        return frame

    assert after(0.1 * FRAME) == FRAME
    assert FRAME < after(FRAME) < LONGEST_FRAME
    assert after(10.0) == pytest.approx(LONGEST_FRAME, rel=1e-3)
    frame = next_frame(LONGEST_FRAME, 0.0)
    assert FRAME < frame < LONGEST_FRAME
