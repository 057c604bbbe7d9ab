"""A session's modes: found beside the frames, put in and driven by commands, and nothing while closed."""

from __future__ import annotations

import threading
import time

import msgspec
import numpy as np
import pytest

import sim
from app.features.modes import messages
from app.features.modes.feature import DriveMode, ModesFeature, PutIntoMode, ShowModes
from app.session import commands
from app.session.modes import COUNT, ModesWatch
from app.session.session import KEYS_FORGOTTEN_AFTER
from app.ui.feature import Drawn
from sim.compiling.compiler import ENTRY_POINTS, fetch
from tests.app.letters import Letters
from tests.app.pages import SessionPage
from tests.app.panels import page_of
from tests.app.recording import agrees
from tests.app.test_arrows import sections

REPLACE = msgspec.structs.replace
DRAWN = Drawn(0, 0.0, exactly=True)


def opened(name: str = "bridge") -> tuple[SessionPage, ModesWatch]:
    """A page that looks at the modes of a preset, which are found."""
    fetch(ENTRY_POINTS)
    page = SessionPage(sim.load_scene(name))
    page.frames(1, ShowModes(True))
    return page, found(page)


def found(page: SessionPage, before: int = 0) -> ModesWatch:
    """What a page's session knows of modes, once it knows more than before."""
    watch = page.session.modes
    assert watch is not None
    end = time.monotonic() + 60.0
    while watch.number <= before and time.monotonic() < end:
        time.sleep(0.005)
        watch.tick(page.simulation, busy=False)
    assert watch.number > before
    return watch


def amplitude(page: SessionPage, mode: int) -> float:
    """Of a mode now, in that of a full bar."""
    watch = page.session.modes
    assert watch is not None
    now = watch.excitation(page.simulation)
    assert now is not None
    assert watch.found is not None
    reach = np.hypot(now.amplitudes, now.rates / watch.found.omega) / watch.full
    return float(reach[mode])


def numbers(letters: Letters, kind: str) -> np.ndarray:
    """The last array of a kind that a page was told."""
    pairs = zip(letters.keys, letters.sent, strict=True)
    return [message.numbers for key, message in pairs if key == f"softrod-{kind}"][-1]


def test_nothing_is_done_while_nobody_looks() -> None:
    page = SessionPage("bridge")
    letters = Letters()
    view = ModesFeature(page_of(page.session, letters=letters))
    for _ in range(5):
        page.frames(1)
        view.frame(DRAWN)
    assert page.session.modes is None
    assert not letters.sent
    assert not any(thread.name == "softrod-modes" for thread in threading.enumerate())
    page.frames(1, PutIntoMode(0, 0.5), DriveMode(0))
    assert page.session.driving.drive is None
    assert not page.session.notices


def test_a_body_is_put_into_a_mode_by_one_step_of_undo() -> None:
    page, _ = opened()
    page.frames(1, commands.Play(False))
    session = page.session
    before = session.simulation.capture()
    generation, openings = session.generation, session.openings
    page.frames(1, commands.Visit(), PutIntoMode(2, 0.3))
    page.frames(1, PutIntoMode(2, 0.8))
    assert amplitude(page, 2) == pytest.approx(0.8, rel=1e-9)
    assert (session.generation, session.openings) == (generation, openings)
    assert session.versions.undoable == "mode 3"
    page.frames(1, commands.Visit(), PutIntoMode(1, 0.4))
    page.frames(1, commands.Undo())
    assert amplitude(page, 2) == pytest.approx(0.8, rel=1e-9)
    assert amplitude(page, 1) < 1e-3
    page.frames(1, commands.Undo())
    assert np.array_equal(session.simulation.capture().rows, before.rows)
    page.frames(1, commands.Redo())
    assert amplitude(page, 2) == pytest.approx(0.8, rel=1e-9)
    assert session.openings == openings


def test_undo_comes_back_to_the_motion_at_the_present_time() -> None:
    page, _ = opened()
    page.frames(10)
    before = page.simulation.capture()
    page.frames(20, PutIntoMode(0, 0.5))
    now = page.simulation.time
    page.frames(0, commands.Play(False), commands.Undo())
    page.session.drain()
    assert page.simulation.time == now
    assert np.array_equal(page.simulation.capture().rows, before.rows)


@pytest.mark.parametrize("command", [PutIntoMode(99, 0.5), PutIntoMode(-1, 0.5), PutIntoMode(0, np.nan)])
def test_what_cannot_be_put_in_is_nothing(command: PutIntoMode) -> None:
    page, _ = opened()
    page.frames(1, commands.Play(False))
    rows = page.simulation.capture().rows
    page.frames(1, command)
    assert np.array_equal(page.simulation.capture().rows, rows)


def test_a_mode_is_driven_while_it_is_said_and_its_support_comes_back() -> None:
    page, watch = opened("lesson-bridge-modes")
    session, start = page.session, page.simulation.positions
    for _ in range(90):
        page.frames(1, DriveMode(1))
    drive = session.driving.drive
    assert drive is not None
    assert not drive.grabbed
    assert amplitude(page, 1) > 0.2
    now = watch.excitation(session.simulation)
    assert now is not None
    assert now.energies[1] > 0.5 * now.energies.sum()
    # Nothing is heard of it any more: it fades.
    page.frames(int(KEYS_FORGOTTEN_AFTER * 60.0) + 60)
    assert session.driving.drive is None
    held = [anchor.mass for anchor in session.scene.anchors]
    assert np.abs(session.simulation.positions[held] - start[held]).max() < 1e-9
    assert watch.number == 1  # the support's way is no other body
    agrees(page)


def test_a_driven_frame_tries_no_more_steps_than_any_other() -> None:
    page, _ = opened("lesson-bridge-modes")
    page.frames(20, DriveMode(1))
    session = page.session
    simulation, drive = session.simulation, session.driving.drive
    assert drive is not None
    steps = 6 * drive.steps(simulation.dt)  # six straight lines in which the support is led
    simulation.stats()
    assert session.driving.step(session.recorder, session.modes, steps, 1_000_000) == steps
    most = simulation.stats().work // 2
    done = session.driving.step(session.recorder, session.modes, steps, most)
    assert simulation.stats().work == pytest.approx(most, rel=0.1)
    assert steps // 6 < done < steps


def test_a_body_that_nothing_holds_is_driven_where_it_swings_most() -> None:
    fetch(ENTRY_POINTS)
    scene = REPLACE(sim.load_scene("girder"), anchors=(), gravity=(0.0, 0.0), bodies=())
    page = SessionPage(scene)
    page.frames(1, ShowModes(True))
    found(page)
    page.frames(30, DriveMode(0))
    assert page.session.driving.drive is not None
    assert page.simulation.grabbed
    page.frames(1, DriveMode(-1))
    assert page.session.driving.drive is None
    assert not page.simulation.grabbed


def test_a_mode_that_is_not_there_cannot_be_driven() -> None:
    page, _ = opened()
    page.frames(1, DriveMode(50))
    (notice,) = page.session.notices
    assert notice.text == "there is no mode 51 to drive"


def test_another_number_and_another_body_have_other_modes() -> None:
    page, watch = opened()
    assert watch.found is not None
    before = watch.found.omega
    page.frames(1, commands.SetValue("linear_stiffness", 4e5))
    assert found(page, 1).found is not None
    assert watch.found.omega[3] > 1.2 * before[3]
    page.frames(1, commands.Open(sim.load_scene("rod")))
    page.frames(1)
    if watch.found is None:  # a small body's are there at once, now and then
        found(page, watch.number)
    assert watch.found is not None
    assert len(watch.found.rest) == 10


def test_too_large_a_body_says_so() -> None:
    fetch(ENTRY_POINTS)
    page = SessionPage(sim.rope(1001))
    page.frames(1, ShowModes(True))
    watch = found(page)
    assert watch.found is None
    assert watch.trouble == "modes: 1001 masses are more than 1000"


def test_a_page_is_told_of_them() -> None:
    page, watch = opened()
    letters = Letters()
    view = ModesFeature(page_of(page.session, letters=letters))
    page.frames(1, PutIntoMode(3, 0.5))
    view.frame(DRAWN)
    assert watch.found is not None
    state = letters.last(messages.Modes)
    assert state.on
    assert state.frequencies == pytest.approx(watch.found.omega / (2.0 * np.pi), rel=1e-6)
    shapes = sections(numbers(letters, "ModeShapes"))
    assert shapes[0][0] == state.number
    assert shapes[1] == pytest.approx(watch.found.rest.ravel(), rel=1e-6)
    assert shapes[3] == pytest.approx(watch.found.shapes[0].ravel(), abs=1e-6)
    assert len(shapes) == 3 + 3 * COUNT
    head, levels, shares, frames = sections(numbers(letters, "ModeLevels"))
    assert levels[3] == pytest.approx(amplitude(page, 3), rel=0.05)
    assert float(np.abs(shares).sum()) == pytest.approx(1.0, rel=1e-5)
    assert frames == pytest.approx([1.0, 0.0, 0.0, 0.0])
    assert head[0] == state.number
    page.frames(1, ShowModes(False))
    view.frame(DRAWN)
    assert not letters.last(messages.Modes).on
    assert not numbers(letters, "ModeShapes").size


def test_a_page_is_told_when_the_body_begins_to_touch() -> None:
    fetch(ENTRY_POINTS)
    floor = sim.Wall(point=(0.0, 450.0), normal=(0.0, -1.0))
    page = SessionPage(sim.jelly(columns=3, rows=2, width=80.0, height=40.0, walls=(floor,)))
    letters = Letters()
    view = ModesFeature(page_of(page.session, letters=letters))
    page.frames(1, commands.Play(False), ShowModes(True))
    found(page)
    page.frames(1, commands.Play())
    touching: list[float] = []
    while max(touching, default=0.0) <= 1e-4 and page.simulation.time < 2.0:
        lowest = page.simulation.positions[:, 1].max()
        view.frame(DRAWN)
        touching.append(float(sections(numbers(letters, "ModeLevels"))[0][3]))
        if lowest < 440.0:
            assert touching[-1] == 0.0
        page.frames(2)
    assert touching[-1] > 1e-4, "which is where the page clicks"
    assert len(touching) > 5
