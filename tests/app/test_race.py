"""A race: two bodies on one terrain, and what the page is told of it."""

from __future__ import annotations

from unittest.mock import MagicMock

import msgspec
import numpy as np
import pytest

import sim
from app.features.race.feature import BeginRace, LeaveRace, RaceFeature
from app.features.race.messages import RaceAnswer
from app.features.race.rival import Rival
from app.session import commands
from app.ui.shelf import Shelf
from sim.edit.terrain import on_terrain
from sim.store.link import pack_scene
from tests.app.letters import Letters
from tests.app.pages import SessionPage, answered, in_one_piece

REPLACE = msgspec.structs.replace


def racing(one: str = "worm", other: str = "walker", **changes: object) -> tuple[SessionPage, Rival]:
    """A page with a race that has not begun."""
    page = SessionPage(sim.load_scene(one))
    page.frames(20)
    page.frames(1, BeginRace(REPLACE(sim.load_scene(other), **changes)))
    rival = page.session.companions.get(Rival)
    assert rival is not None
    return page, rival


def test_both_start_together_and_keep_to_one_clock() -> None:
    step = REPLACE(sim.load_scene("walker").integrator, dt=0.004)
    page, rival = racing(integrator=step)
    session = page.session
    assert not session.playing
    assert session.simulation.time == rival.simulation.time == 0.0
    page.frames(60, commands.Play(True))
    assert session.simulation.time > 0.9
    assert 0.0 <= session.simulation.time - rival.simulation.time < 0.004 + 1e-9
    alone = sim.Simulation(on_terrain(rival.scene, session.scene))
    alone.step(rival.simulation.step_count)
    assert np.abs(alone.positions - rival.simulation.positions).max() < 0.5  # its steps end elsewhere
    mine, theirs = rival.ways(session.simulation)
    mass = np.array([one.mass for one in rival.scene.masses])
    began = np.array([one.position[0] for one in rival.scene.masses])
    assert theirs == pytest.approx(mass @ (rival.simulation.positions[:, 0] - began) / mass.sum())
    assert abs(mine) > 1.0
    assert rival.fair
    page.frames(1, commands.Reset())
    assert rival.simulation.time < 0.05
    page.frames(1, LeaveRace())
    assert session.companions.get(Rival) is None
    page.frames(5)
    assert not any("rival" in beside for _, beside in session.history.recent(1.0))


def test_the_body_waits_for_a_slower_rival(monkeypatch: pytest.MonkeyPatch) -> None:
    page, rival = racing()
    real = rival.simulation.step
    monkeypatch.setattr(rival.simulation, "step", lambda n, attempts: real(min(n, 2), attempts))
    in_one_piece(rival.costs, 1_000_000)
    page.frames(40, commands.Play(True))
    dt = rival.simulation.dt
    assert 60 * dt < page.simulation.time < 90 * dt
    assert page.simulation.time - rival.simulation.time < 10 * dt
    assert page.session.pacer.rates(page.wall()).behind > 0.3


def test_what_is_done_on_the_way_is_noted_and_reaches_only_the_terrain() -> None:
    page, rival = racing()
    page.frames(20, commands.Play(True))
    places = rival.simulation.positions
    page.frames(1, commands.DragStart(3, 100.0, 300.0), commands.Point(140.0, 200.0))
    assert not rival.fair
    assert np.abs(rival.simulation.positions - places).max() < 30.0
    page.frames(1, commands.DragEnd(), commands.Play(False), commands.Reset())
    assert rival.fair
    page.frames(5, commands.Play(True))
    page.frames(1, commands.SetValue("gravity", 300.0))
    assert not rival.fair
    assert rival.simulation.scene.gravity == page.session.scene.gravity == (0.0, 300.0)
    assert rival.simulation.scene.beat == rival.scene.beat
    page.frames(1, commands.Undo())
    assert rival.simulation.scene.gravity == (0.0, 1000.0)


def test_going_back_in_time_takes_both_along() -> None:
    page, rival = racing()
    page.frames(30, commands.Play(True))
    half, at = rival.simulation.positions, page.simulation.time
    ways = rival.ways(page.simulation)
    page.frames(30)
    page.frames(1, commands.GoTo(at))
    assert np.array_equal(rival.simulation.positions, half)
    assert rival.ways(page.simulation) == ways
    assert rival.seconds == pytest.approx(at)
    page.frames(1, commands.GoTo(0.0))
    assert rival.simulation.time == rival.seconds == 0.0


def test_another_scene_ends_the_race() -> None:
    page, _ = racing()
    page.frames(1, commands.Open(sim.load_scene("rope")))
    assert page.session.companions.get(Rival) is None


def test_a_rival_that_explodes_is_out_and_the_other_goes_on() -> None:
    wild = REPLACE(sim.load_scene("walker").integrator, method="symplectic_euler", dt=0.05)
    page, rival = racing(integrator=wild)
    page.frames(120, commands.Play(True))
    assert rival.out == "it exploded"
    assert not rival.is_late
    assert page.simulation.time > 1.8


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        ("walker", ""),
        ("http://softrod.example/s%23{link}", ""),
        ("http://softrod.example/?scene=walker", ""),
        ("http://softrod.example/?scene=wlaker", "There is no preset called 'wlaker'"),
        ("http://softrod.example/s%231.abc", "The link is broken"),
        ("a%20b", "'a b' is neither a link to a scene nor the name of one."),
    ],
)
def test_a_rival_is_found_by_a_link_or_a_name(text: str, problem: str) -> None:
    page, letters = SessionPage("worm"), Letters()
    seen = MagicMock(session=page.session, mail=letters, shelf=Shelf(owned=False))
    races = RaceFeature(seen)
    link = pack_scene(sim.load_scene("walker"))
    answered(page.session, lambda: races.read("rival", text.format(link=link)))
    page.frames(1)
    said = letters.last(RaceAnswer).problem
    assert said.startswith(problem) if problem else not said
    assert (page.session.companions.get(Rival) is None) == bool(problem)
