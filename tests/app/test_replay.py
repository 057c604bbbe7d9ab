"""Logs that are played in a page: at their own pace, within a frame's time, and until someone acts."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from rich.console import Console

import sim
from app.cli import headless
from app.session import commands, log
from app.session.log import decode_log
from app.session.replay import Player
from sim.errors import InputError
from tests.app.pages import SessionPage
from tests.app.recording import agrees, busy_page, log_of, perturbed, replayed


@pytest.fixture(scope="module")
def data() -> bytes:
    return log_of(busy_page(sim.load_scene("tutorial-3.3")))


def played(data: bytes, frames: int) -> SessionPage:
    page = SessionPage("ring")
    page.frames(3)
    page.frames(frames, commands.Replay(decode_log(data, "log")))
    return page


def test_a_page_plays_a_log_in_its_own_time(data: bytes) -> None:
    page = played(data, 30)
    assert page.session.replay is not None
    assert page.simulation.time == pytest.approx(0.5, abs=0.05)
    page.frames(30, commands.Play(False))
    assert page.simulation.time == pytest.approx(0.5, abs=0.05)
    page.frames(400, commands.Play(True))
    assert page.session.replay is None
    assert not page.session.playing
    assert "agrees" in page.told
    end = replayed(data).simulation
    assert np.array_equal(page.simulation.positions, end.positions)
    page.frames(30, commands.Play(True))
    agrees(page)


def test_looking_back_in_a_replay_does_not_disturb_it(data: bytes) -> None:
    page = played(data, 60)
    page.frames(3, commands.GoTo(0.2))
    assert not page.session.playing
    assert page.simulation.time == pytest.approx(0.2, abs=0.02)
    page.frames(3, commands.GoForward(), commands.GoBack(0.1))
    page.frames(400, commands.Play(True))
    assert "agrees" in page.told


def test_a_page_says_that_a_replay_differs(data: bytes) -> None:
    page = played(perturbed(data), 500)
    assert [notice.kind for notice in page.session.notices] == ["warning"]
    assert "differs first at step " in page.told


@pytest.mark.parametrize(
    "command",
    [
        commands.DragStart(0, 0.0, 0.0),
        commands.HoldKeys(frozenset({"up"})),
        commands.SetValue("gravity", 1.0),
        commands.Reset(),
    ],
)
@pytest.mark.parametrize("scrubbed", [False, True])
def test_whoever_acts_takes_over(data: bytes, command: commands.Command, scrubbed: bool) -> None:
    page = played(data, 30)
    if scrubbed:
        page.frames(2, commands.GoTo(0.1))
    before = page.simulation.time
    page.frames(1, command)
    assert page.session.replay is None
    assert "taken over" in page.told
    page.frames(20, commands.DragEnd(), commands.Play(True))
    if not isinstance(command, commands.Reset):
        assert page.simulation.time == pytest.approx(before + 21 / 60, abs=0.05)
    agrees(page)


def test_a_page_refuses_frames_that_would_stop_it() -> None:
    for preset, entry in (
        ("tutorial-3.3", b'{"do":"step","n":400000}'),
        ("ring", b'{"do":"step","n":20000,"attempts":1000000}'),
    ):
        page = played(log.encode_header(sim.load_scene(preset)) + b"\n" + entry, 5)
        assert page.session.replay is None
        assert "line 2: this frame is too heavy" in page.told


def test_a_log_of_endless_changes_does_not_stop_the_page() -> None:
    header = log.encode_header(sim.load_scene("tutorial-3.3"))
    again = b'{"do":"choose","key":"method","value":"rk4","times":10000000}'
    recorded = decode_log(header + b"\n" + again, "log")
    player = Player(recorded, sim.Simulation(recorded.scene))
    done: list[int] = []
    player.do = lambda attempts: done.append(attempts) or 0  # type: ignore[method-assign, func-returns-value]
    player.advance(1.0, budget=0.0, most=100, attempts=100)
    assert len(done) == 1  # when the time of a frame is over


def test_the_energy_of_a_replay_is_followed_from_its_beginning(tmp_path: Path) -> None:
    page = SessionPage()
    page.drag(0, 60.0, frames=20)
    page.frames(20, commands.DragEnd(), commands.FollowEnergy(True))
    page.frames(20, commands.FollowEnergy(False))
    recorded = decode_log(log_of(page), "log")
    recording, player = headless.run(recorded, None, 10, Console(quiet=True), energy=True)
    assert player.agrees
    recording.write(tmp_path / "run.npz")
    assert np.load(tmp_path / "run.npz")["anchors"][-1] > 1.0  # what the hand did at the very beginning


def test_while_a_log_is_played_there_is_none_to_save(data: bytes) -> None:
    page = played(data, 10)
    with pytest.raises(InputError, match="being played"):
        log_of(page)


def test_an_undo_that_has_nothing_to_undo_does_not_end_a_replay(data: bytes) -> None:
    page = played(data, 30)
    page.frames(3, commands.Undo(), commands.Redo())
    assert page.session.replay is not None
    assert not page.session.notices
