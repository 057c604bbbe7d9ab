"""The whole run: any of its frames is computed again to the last bit, within bounds of memory and time."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

import sim
from app.session import commands, history, log, reel
from app.session.history import History, Wanted
from sim.edit import build
from tests.app.pages import FRAME, SessionPage, in_one_piece
from tests.app.recording import decode_log, log_of


def state(moment: sim.Moment) -> tuple[Any, ...]:
    """All of a moment, to be compared to the last bit."""
    keyed = moment.rest_length_scale, moment.rest_angle_shift
    return (
        moment.rows.tobytes(),
        moment.time,
        moment.step_count,
        moment.scene,
        keyed,
        moment.damage,
        moment.grips,
    )


class Watched(SessionPage):
    """A page of which somebody else notes each frame.

    Attributes:
        seen: the states at the ends of frames, by time, without those of an abandoned future.
    """

    def __init__(self, scene: sim.Scene | str) -> None:
        self.seen: dict[float, Any] = {}
        super().__init__(scene)

    def frames(self, count: int, *posts: commands.Command) -> None:
        for i in range(count):
            super().frames(1, *(posts if i == 0 else ()))
            session = self.session
            if not session.history.scrubbed:
                last = session.history[session.history.last]
                self.seen = {time: known for time, known in self.seen.items() if time < last.time}
                self.seen[last.time] = state(last)

    def compare(self, rng: np.random.Generator, count: int) -> None:
        """Go to some frames, which have to be as they were."""
        times = list(self.seen)
        for time in rng.choice(times, count):
            super().frames(1, commands.GoTo(float(time)))
            assert state(self.simulation.capture()) == self.seen[time], time


def longer(moment: sim.Moment, _: object) -> Any:
    scene = moment.scene
    x, y = moment.positions[-1].tolist()
    return build.add_mass(scene, (x + 30.0, y))


def eventful(page: Watched, rng: np.random.Generator) -> None:
    """Drag, hold keys, set numbers, choose methods, edit, undo, and go back and on."""
    page.frames(40)
    page.drag(len(page.simulation.positions) - 1, 50.0, -20.0, frames=15)
    page.frames(15, commands.DragEnd(), commands.SetValue("gravity", 700.0))
    page.hold(12, "up", "right")
    page.frames(20, commands.SetChoice("method", str(rng.choice(["adams", "rk4", "auto"]))))
    page.frames(1, commands.Play(False), commands.SetValue("gravity", 300.0))
    page.frames(2, commands.DoSteps(7))
    page.compare(rng, 3)
    page.frames(1, commands.GoTo(1e9))
    page.frames(25, commands.Play(True))
    page.frames(25, commands.Change(longer))
    page.frames(10, commands.Undo())
    page.frames(
        1, commands.GoTo(float(rng.choice(list(page.seen)[60:]))), commands.SetValue("gravity", 900.0)
    )
    page.frames(60, commands.Play(True))


@pytest.mark.parametrize("stretch", [0.0, 0.005, 1e9])
@pytest.mark.parametrize("preset", ["tutorial-3.3", "girder", "stick-slip"])
def test_any_frame_of_an_eventful_run_comes_back_to_the_last_bit(
    preset: str, stretch: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(history, "SPAN", 20)
    monkeypatch.setattr(reel, "STRETCH", stretch)
    monkeypatch.setattr(reel, "WORTH", 0.0)
    page, rng = Watched(preset), np.random.default_rng(7)
    eventful(page, rng)
    assert len(page.session.history) < 30
    page.compare(rng, 12)
    page.frames(20, commands.GoTo(1e9), commands.Play(True))
    page.compare(rng, 6)
    assert page.session.history.start == 0.0


def test_frames_can_be_stepped_through_anywhere(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(history, "SPAN", 20)
    monkeypatch.setattr(reel, "STRETCH", 1e-3)
    monkeypatch.setattr(reel, "WORTH", 0.0)
    monkeypatch.setattr(reel, "BEFORE", 5)
    monkeypatch.setattr(reel, "AFTER", 3)
    page = Watched("tutorial-3.3")
    page.frames(120)
    times = list(page.seen)
    SessionPage.frames(page, 1, commands.GoTo(times[70]))
    for back in range(69, 55, -1):
        SessionPage.frames(page, 1, commands.GoBack())
        assert state(page.simulation.capture()) == page.seen[times[back]]
    for on in range(57, 80):
        SessionPage.frames(page, 2, commands.GoForward())
        assert state(page.simulation.capture()) == page.seen[times[on]]
    SessionPage.frames(page, 1, commands.GoBack(1.0))
    assert page.simulation.time == pytest.approx(times[79] - 1.0, abs=FRAME)
    SessionPage.frames(page, 1, commands.GoBack(1e6), commands.GoBack())
    assert page.simulation.time == 0.0


def test_going_on_from_long_ago_makes_another_run(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(history, "SPAN", 20)
    page, rng = Watched("tutorial-3.3"), np.random.default_rng(1)
    page.frames(200)
    page.frames(1, commands.GoTo(1.0), commands.SetValue("gravity", 0.0))
    page.frames(100, commands.Play(True))
    assert page.session.history.end == pytest.approx(1.0 + 99 * FRAME, abs=0.02)
    old = page.session.abandoned_future
    assert old is not None
    assert old.start == pytest.approx(1.0, abs=FRAME)
    assert old.end > 2.0
    page.compare(rng, 8)


def test_frames_of_a_machine_that_is_too_slow_come_back(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(history, "SPAN", 20)
    page = Watched(sim.set_value(sim.load_scene("ring"), "tolerance", 1e-6))
    in_one_piece(page.session.costs, 9)
    page.frames(120)
    assert page.session.pacer.behind > 0.1
    page.compare(np.random.default_rng(2), 8)


def test_any_frame_of_a_replay_comes_back_and_the_replay_goes_on(monkeypatch: pytest.MonkeyPatch) -> None:
    first = Watched("tutorial-3.3")
    eventful(first, np.random.default_rng(3))
    recorded = decode_log(log_of(first), "log")
    monkeypatch.setattr(history, "SPAN", 20)
    page = Watched("ring")
    page.frames(1, commands.Replay(recorded))
    page.seen.clear()
    page.frames(100)
    page.compare(np.random.default_rng(4), 8)
    page.frames(600, commands.Play(True))
    assert page.session.replay is None
    assert "agrees" in page.told


def test_undo_knows_the_scene_of_a_frame_that_is_computed_again(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(history, "SPAN", 20)
    page = SessionPage()
    page.frames(10)
    page.frames(30, commands.SetValue("gravity", 400.0))
    time = page.simulation.time
    page.frames(60, commands.SetValue("linear_damping", 9.0))
    page.frames(1, commands.GoTo(time))
    assert page.session.scene.gravity == (0.0, 400.0)
    page.frames(1, commands.Undo())
    assert page.session.scene.gravity == (0.0, 2000.0)


# ------------------------------------------------------------------------- in slices
def test_a_frame_is_computed_in_slices_and_commands_wait_for_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(history, "SPAN", 5)
    page = Watched("tutorial-3.3")
    page.frames(60)
    session, time = page.session, list(page.seen)[40]
    session.post(commands.GoTo(0.1))  # overtaken
    session.post(commands.GoTo(time))
    session.post(commands.Play(True))
    monkeypatch.setattr("app.session.session.MIN_SLICE", 0.0)
    rounds = 0
    while session.has_commands:
        session.drain()
        assert session.playing == (not session.has_commands and rounds > 0)
        session.tick(0.0)
        rounds += 1
    assert rounds > 20
    page.frames(2)
    assert time < session.simulation.time < time + 0.1


def test_what_is_seen_before_a_frame_is_there_is_what_was(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(history, "SPAN", 20)
    page = Watched("tutorial-3.3")
    page.frames(300)
    before = page.simulation.positions
    monkeypatch.setattr("app.session.session.MIN_SLICE", 0.0)
    page.session.post(commands.GoTo(1.0))
    page.session.drain()
    page.session.tick(0.0)
    assert page.session.is_seeking
    assert not page.session.is_idle
    assert np.array_equal(page.simulation.positions, before)


# ------------------------------------------------------------------------- memory
def an_hour(masses: int, computing: float, method: str = "auto") -> History:
    """The past of an hour of two frames a second, of a body that is a burden to the machine.

    Args:
        masses: of the body, whose memory is that of a moving one.
        computing: seconds for each simulated one.
        method: which moves it.
    """
    simulation = sim.Simulation(sim.set_choice(sim.rope(masses=masses), "method", method))
    simulation.step(10)
    point, moment = simulation.checkpoint(), simulation.capture()
    # Somebody else's would be as large, but here is only one.
    body: Any = SimpleNamespace(time=0.0, divergence=None, checkpoint=lambda: replace(point, time=body.time))
    past = History()
    past.add(replace(moment, time=0.0))
    for i in range(1, 7201):
        past.ready(body, complete=True)
        past.reel.note(log.Lead(mass=0, to=(i * 0.001, i * 0.002)))
        past.reel.note(log.Step(n=6, attempts=300 + i))
        past.reel.spend(0.5 * computing)
        body.time = 0.5 * i
        past.add(replace(moment, time=body.time))
        assert past.bytes <= history.MAX_BYTES
        assert past.reel.bytes <= reel.MAX_BYTES + 1_000_000  # of the open stretch
    return past


def counted(past: History) -> int:
    """Bytes of all numbers and lines in a past, counted one by one."""
    stretches = past.reel.stretches
    lines = sum(stretch.packed_bytes for stretch in stretches)
    moments = sum(past[i].rows.nbytes for i in range(len(past)))
    return lines + moments + sum(stretch.start.nbytes for stretch in stretches)


def test_an_hour_is_less_than_100_megabytes() -> None:
    # An abandoned future can have as many moments as the past.
    assert reel.MAX_BYTES + 2 * (history.MAX_BYTES + reel.AGAIN_BYTES) <= 100_000_000


def test_of_a_large_body_few_frames_are_computed_with_a_wanted_one(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(history, "SPAN", 20)
    monkeypatch.setattr(reel, "AGAIN_BYTES", 100_000)
    page = Watched("tutorial-3.3")
    page.frames(300)
    page.compare(np.random.default_rng(8), 4)
    assert 80 < len(page.session.history) < 200


def test_an_hour_of_a_short_body_takes_a_few_megabytes() -> None:
    past = an_hour(12, 0.002)
    assert past.start == 0.0
    assert past.reel.bytes < 4_000_000
    assert max(stretch.seconds for stretch in past.reel.stretches) < 2 * reel.STRETCH


def test_an_hour_of_a_larger_body_has_longer_stretches_the_older_they_are() -> None:
    past = an_hour(100, 0.05)
    seconds = np.array([stretch.seconds for stretch in past.reel.stretches])
    assert past.start == 0.0
    assert seconds.max() <= reel.LONGEST
    assert seconds[:100].mean() > 2.0 * seconds[-100:].mean()
    assert 10_000_000 < counted(past) <= past.bytes + past.reel.bytes


def test_of_a_heavy_body_only_what_is_not_long_ago_is_computed_again() -> None:
    past = an_hour(1500, 0.9)
    stretches = past.reel.stretches
    assert max(stretch.seconds for stretch in stretches) <= reel.LONGEST + 0.45
    assert 60.0 < 3600.0 - past.reel.start < 1000.0
    assert isinstance(past.at(past.reel.start - 9.25), int)  # the nearest that is stored
    assert past.at(past.reel.start + 9.25) == Wanted(None, past.reel.start + 9.25) or past.reel.start > 1800.0
    assert counted(past) <= past.bytes + past.reel.bytes
    # There is no gap.
    assert all(one.last == other.first for one, other in pairwise(stretches))


def test_a_checkpoint_that_is_dear_is_made_seldom(monkeypatch: pytest.MonkeyPatch) -> None:
    times = iter(np.arange(10_000) * 0.004)
    monkeypatch.setattr(reel, "perf_counter", lambda: next(times))  # each takes 4 ms
    past = an_hour(12, 0.1)
    assert min(stretch.seconds for stretch in past.reel.stretches[:-1]) >= 50 * 0.004


def test_a_hand_at_rest_while_time_stands_takes_no_memory() -> None:
    page = SessionPage()
    page.frames(10)
    page.frames(1, commands.Play(False))
    x, y = page.simulation.positions[8]
    page.frames(1, commands.DragStart(8, x, y))
    before = page.session.history.reel.bytes
    page.frames(1000, commands.Point(x + 5.0, y))
    assert page.session.history.reel.bytes - before < 1000


def test_what_moves_by_numpy_is_stored(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(history, "SPAN", 20)
    late = [True]  # as if its kernels were still being compiled
    complete = sim.Simulation.complete.fget
    assert complete is not None
    monkeypatch.setattr(sim.Simulation, "complete", property(lambda self: not late[0] and complete(self)))
    page = Watched("tutorial-3.3")
    page.frames(50)
    late[0] = False
    page.frames(60)
    assert 70 <= len(page.session.history) <= 75
    page.compare(np.random.default_rng(6), 12)
