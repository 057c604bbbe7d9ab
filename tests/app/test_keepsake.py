"""What a browser keeps of a page: it leads back to where the page was, and nothing in it is trusted."""

from __future__ import annotations

import json
from typing import Any

import numpy as np
import pytest

import sim
from app.session import commands, keepsakes, log
from app.ui.kept import undo_store
from tests.app.pages import SessionPage
from tests.app.recording import agrees, busy_page


def a_page() -> SessionPage:
    page = busy_page(sim.load_scene("tutorial-3.3"))
    choices = commands.SelectJoint(4), commands.Speed(2.0), commands.Follow(True)
    page.frames(5, *choices, commands.Compare("rk4", "angle", 4))
    return page


@pytest.fixture
def page() -> SessionPage:
    return a_page()


@pytest.fixture(scope="module")
def kept() -> bytes:
    """The keepsake of such a page."""
    return a_page().session.keepsake()


def resumed(data: bytes) -> SessionPage:
    page = SessionPage("ring")
    page.frames(5)
    page.session.post(commands.Resume(data))
    page.session.drain()
    return page


@pytest.mark.parametrize("playing", [False, True])
def test_a_page_goes_on_where_it_was(page: SessionPage, playing: bool) -> None:
    page.frames(1, commands.Play(playing))
    before, session = page.session, resumed(page.session.keepsake()).session
    assert not session.notices
    assert np.array_equal(session.simulation.positions, before.simulation.positions)
    assert np.array_equal(session.simulation.velocities, before.simulation.velocities)
    assert session.simulation.time == before.simulation.time
    assert session.simulation.step_count == before.simulation.step_count
    assert session.scene == before.scene
    assert (session.playing, session.pacer.speed, session.follow, session.joint) == (playing, 2.0, True, 4)
    assert session.ghost is not None
    assert (session.ghost.method, session.ghost.law, session.ghost.finer) == ("rk4", "angle", 4)
    assert session.history.end == before.simulation.time


def test_the_scene_s_own_values_are_kept_too(kept: bytes) -> None:
    other = resumed(kept)
    other.frames(1, commands.RestoreSceneValues("body"), commands.RestoreSceneValues("solver"))
    assert other.session.scene == sim.load_scene(other.session.scene.name)


def test_reset_still_leads_to_the_scene_s_start(page: SessionPage) -> None:
    other = resumed(page.session.keepsake())
    other.frames(10)
    other.frames(1, commands.Reset())
    page.frames(1, commands.Reset())
    assert other.simulation.positions == pytest.approx(page.simulation.positions, abs=50.0)
    assert other.simulation.positions[5:] == pytest.approx(page.simulation.positions[5:])


def test_a_resumed_page_keeps_a_log_that_can_be_replayed(kept: bytes) -> None:
    other = resumed(kept)
    other.frames(30, commands.Play(True))
    agrees(other)


def test_own_values_of_another_body_begin_its_time_anew(kept: bytes) -> None:
    # As many masses, but without joints: no page writes that, but nothing in a keepsake is trusted.
    another = json.loads(log.encode_header(sim.rope(masses=12, joints=False)))["scene"]
    other = resumed(changed(kept, "opened", value=another))
    other.frames(10, commands.Play(True))
    other.frames(1, commands.Play(False), commands.RestoreSceneValues("body"))
    assert (len(other.session.history), other.simulation.time) == (1, 0.0)
    other.frames(10, commands.Play(True))
    agrees(other)


def test_a_keepsake_is_small() -> None:
    small = SessionPage().session.keepsake()
    assert len(small) < 6000
    scene = sim.rope(masses=20_000)
    rows = np.random.default_rng(1).normal(0.0, 300.0, (4, 20_000))
    data = keepsakes.encode(sim.Moment(scene, 1.0, 0.0, rows, 5.0, 2000), keepsakes.Choices(), scene, scene)
    assert len(data) < keepsakes.MAX_BYTES
    assert json.loads(data)["moment"] is None
    moment = keepsakes.decode(data).moment
    assert moment.time == 0.0
    assert len(moment.positions) == 20_000


def changed(data: bytes, *path: str, value: Any) -> bytes:
    whole = found = json.loads(data)
    for key in path[:-1]:
        found = found[key]
    found[path[-1]] = value
    return json.dumps(whole).encode()


PATHS: list[tuple[tuple[str, ...], Any]] = [
    (("format",), "softrod-log"),
    (("version",), 2),
    (("more",), 1),
    (("scene", "more"), 1),
    (("scene", "air_friction"), -1.0),
    (("scene",), None),
    (("moment", "time"), -1.0),
    (("moment", "time"), 1e300),
    (("moment", "step"), 0.5),
    (("moment", "scale"), 1e9),
    (("moment", "pose", "positions"), []),
    (("moment", "pose", "positions"), [[1e300, 0.0]] * 12),
    (("moment", "pose", "velocities"), [[float("nan"), 0.0]] * 12),
    (("wishes", "speed"), float("inf")),
    (("wishes", "speed"), 1e9),
    (("wishes", "joint"), -1),
    (("wishes", "playing"), "yes"),
    (("wishes", "ghost"), {"method": "leapfrog"}),
    (("wishes", "ghost"), {"method": "rk4", "law": "none"}),
    (("wishes", "ghost"), {"method": "rk4", "finer": 10**9}),
]


@pytest.mark.parametrize(("path", "value"), PATHS)
def test_a_bad_keepsake_changes_nothing(kept: bytes, path: tuple[str, ...], value: Any) -> None:
    other = resumed(changed(kept, *path, value=value))
    assert other.told.startswith("could not be resumed: ")
    assert "\n" not in other.told
    assert other.session.scene.name == "ring"
    other.frames(5)
    assert other.simulation.time > 0.1


def test_what_is_no_keepsake_is_refused() -> None:
    for data in (b"", b"nonsense", b"[]", b"\xff", b"[" * 100_000, b" " * 10_000_000):
        assert resumed(data).told.startswith("could not be resumed: ")


def test_a_joint_that_does_not_exist_is_the_last_one(kept: bytes) -> None:
    assert resumed(changed(kept, "wishes", "joint", value=500)).session.joint == 9


# ------------------------------------------------------------------------- undo
def test_what_could_be_undone_can_be_undone_by_the_page_that_comes_back() -> None:
    page = SessionPage()
    page.frames(3, commands.SetValue("gravity", 500.0))
    page.frames(3, commands.Open(sim.load_scene("box")), commands.SetValue("gravity", 100.0))
    page.frames(3, commands.Undo())
    data, secret = page.session.keepsake(), 32 * "a"
    undo_store.store(secret, page.session.versions)
    page.frames(3, commands.SetValue("air_friction", 1.0))  # of which the browser keeps nothing any more
    other = SessionPage("ring")
    other.frames(3, commands.Resume(data, undo_store.copy_of(secret)))
    session = other.session
    other.frames(1, commands.Undo())
    assert (session.scene.name, session.scene.gravity[1]) == ("tutorial-3.3", 500.0)
    other.frames(1, commands.Undo())
    assert session.scene.gravity[1] == 2000.0
    other.frames(1, commands.Redo(), commands.Redo())
    assert session.scene.name == "box"
    assert all(notice.kind == "info" for notice in session.notices)
    # The first page, should it still be there, has its own.
    page.frames(1, commands.Undo())
    assert page.session.scene.air_friction != 1.0


def test_of_a_scene_that_no_version_is_nothing_is_undone() -> None:
    page = SessionPage()
    page.frames(3, commands.SetValue("gravity", 500.0))
    other = SessionPage("ring")
    other.frames(3, commands.SetValue("gravity", 7.0))
    page.frames(3, commands.Resume(other.session.keepsake(), page.session.versions.copy()))
    assert len(page.session.versions) == 0
    page.frames(1, commands.Undo())
    assert page.session.scene.name == "ring"
    assert undo_store.copy_of(32 * "b") is None


def test_what_is_kept_for_pages_that_come_back_is_bounded(monkeypatch: pytest.MonkeyPatch) -> None:
    page = SessionPage()
    page.frames(3, commands.SetValue("gravity", 500.0))
    names = [f"{number:032x}" for number in range(2 * undo_store.MAX_PAGES)]
    for name in names:
        undo_store.store(name, page.session.versions)
    assert [name for name in names if undo_store.copy_of(name) is not None] == names[undo_store.MAX_PAGES :]
    monkeypatch.setattr(undo_store, "MAX_BYTES", 3 * page.session.versions.bytes)
    undo_store.store(32 * "c", page.session.versions)
    names.append(32 * "c")
    assert [name for name in names if undo_store.copy_of(name) is not None] == names[-3:]


def test_that_somebody_did_something_is_kept() -> None:
    page = SessionPage("rope")
    assert resumed(page.session.keepsake()).session.recorder.acts == 0
    page.frames(1, commands.HoldKeys(frozenset(("up",))))
    assert resumed(page.session.keepsake()).session.recorder.acts > 0
