"""A race: two bodies on one terrain, and what the page is told of it."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from unittest.mock import MagicMock

import msgspec
import numpy as np
import pytest

import sim
from app.features.race import rivals
from app.features.race.feature import BeginRace, LeaveRace, RaceFeature
from app.features.race.messages import Race, RaceAnswer
from app.features.race.rivals import Rivals
from app.session import commands
from app.session.finish import finish_of
from app.stage.plan import Picture
from app.stage.together import side_by_side, together
from app.ui.feature import Drawn
from app.ui.shelf import Shelf
from app.ui.view import picture_of
from sim.edit.terrain import center, on_terrain
from sim.scene.types import Damage
from sim.store.link import pack_scene
from tests.app.letters import Letters
from tests.app.pages import SessionPage, answered, in_one_piece

REPLACE = msgspec.structs.replace


def racing(
    one: str | sim.Scene = "worm", other: str | sim.Scene = "walker", finish: float = 150.0, **changes: object
) -> tuple[SessionPage, Rivals]:
    """A page with a race that has not begun; the changes are those of the other scene."""
    page = SessionPage(one)
    page.frames(20)
    scene = sim.load_scene(other) if isinstance(other, str) else other
    page.frames(1, BeginRace((REPLACE(scene, **changes),), finish))
    rival = page.session.companions.get(Rivals)
    assert rival is not None
    return page, rival


def test_both_start_together_and_keep_to_one_clock() -> None:
    step = REPLACE(sim.load_scene("walker").integrator, dt=0.004)
    page, rival = racing(integrator=step)
    session = page.session
    assert not session.playing
    assert session.simulation.time == rival.bodies[0].time == 0.0
    page.frames(60, commands.Play(True))
    assert session.simulation.time > 0.9
    assert 0.0 <= session.simulation.time - rival.bodies[0].time < 0.004 + 1e-9
    alone = sim.Simulation(on_terrain(rival.scenes[0], session.scene))
    alone.step(rival.bodies[0].step_count)
    assert np.abs(alone.positions - rival.bodies[0].positions).max() < 0.5  # its steps end elsewhere
    mine, theirs = rival.ways(session.simulation)
    mass = np.array([one.mass for one in rival.scenes[0].masses])
    began = np.array([one.position[0] for one in rival.scenes[0].masses])
    assert theirs == pytest.approx(mass @ (rival.bodies[0].positions[:, 0] - began) / mass.sum())
    assert abs(mine) > 1.0
    assert rival.fair
    page.frames(1, commands.Reset())
    assert rival.bodies[0].time < 0.05
    page.frames(1, LeaveRace())
    assert session.companions.get(Rivals) is None
    page.frames(5)
    assert not any("rival" in beside for _, beside in session.history.recent(1.0))


def test_the_body_waits_for_a_slower_rival(monkeypatch: pytest.MonkeyPatch) -> None:
    page, rival = racing()
    real = rival.bodies[0].step
    monkeypatch.setattr(rival.bodies[0], "step", lambda n, attempts: real(min(n, 2), attempts))
    in_one_piece(rival.costs, 1_000_000)
    page.frames(40, commands.Play(True))
    dt = rival.bodies[0].dt
    assert 60 * dt < page.simulation.time < 90 * dt
    assert page.simulation.time - rival.bodies[0].time < 10 * dt
    assert page.session.pacer.rates(page.wall()).behind > 0.3


def test_what_is_done_on_the_way_is_noted_and_reaches_only_the_terrain() -> None:
    page, rival = racing()
    page.frames(20, commands.Play(True))
    places = rival.bodies[0].positions
    page.frames(1, commands.DragStart(3, 100.0, 300.0), commands.Point(140.0, 200.0))
    assert not rival.fair
    assert np.abs(rival.bodies[0].positions - places).max() < 30.0
    page.frames(1, commands.DragEnd(), commands.Play(False), commands.Reset())
    assert rival.fair
    page.frames(5, commands.Play(True))
    page.frames(1, commands.SetValue("gravity", 300.0))
    assert not rival.fair
    assert rival.bodies[0].scene.gravity == page.session.scene.gravity == (0.0, 300.0)
    assert rival.bodies[0].scene.beat == rival.scenes[0].beat
    page.frames(1, commands.Undo())
    assert rival.bodies[0].scene.gravity == (0.0, 1000.0)


def test_going_back_in_time_takes_both_along() -> None:
    page, rival = racing()
    page.frames(30, commands.Play(True))
    half, at = rival.bodies[0].positions, page.simulation.time
    ways = rival.ways(page.simulation)
    page.frames(30)
    page.frames(1, commands.GoTo(at))
    assert np.array_equal(rival.bodies[0].positions, half)
    assert rival.ways(page.simulation) == ways
    assert rival.seconds == pytest.approx(at)
    page.frames(1, commands.GoTo(0.0))
    assert rival.bodies[0].time == rival.seconds == 0.0


def test_another_scene_ends_the_race() -> None:
    page, _ = racing()
    page.frames(1, commands.Open(sim.load_scene("rope")))
    assert page.session.companions.get(Rivals) is None


def arrival_alone(scene: sim.Scene, way: float) -> float:
    """Seconds that a body by itself needs for a way, interpolated within the step in which it gets there."""
    body = sim.Simulation(scene)
    start = last = x = center(scene, body.positions)
    while x - start < way:
        last = x
        body.step(1)
        x = center(scene, body.positions)
    return body.time - body.dt * (x - start - way) / (x - last)


@pytest.mark.parametrize("speed", [1.0, 8.0])
def test_arrival_is_where_a_step_crosses_the_line_however_many_a_frame_has(speed: float) -> None:
    step = REPLACE(sim.load_scene("worm").integrator, dt=0.004)
    page, rival = racing("worm", "lesson-worm", 50.0, integrator=step)
    terrain = page.session.scene
    page.frames(1, commands.Speed(speed), commands.Play(True))
    while not rival.is_over:
        page.frames(1)
    mine, theirs = rival.runners
    assert mine.arrived == pytest.approx(arrival_alone(terrain, 50.0), abs=1e-3)
    other = on_terrain(rival.scenes[0], terrain)
    assert theirs.arrived == pytest.approx(arrival_alone(other, 50.0), abs=1e-3)
    start = sim.Simulation(terrain).positions
    assert rival.lines[0] == pytest.approx(center(terrain, start) + 50.0)


def flying(x: float, y: float) -> sim.Scene:
    """A mass that flies by itself."""
    return sim.Scene(
        name="flying", gravity=(0.0, 0.0), masses=(sim.Mass(position=(0.0, 0.0), velocity=(x, y)),)
    )


@pytest.mark.parametrize(
    ("velocity", "gravity", "seconds", "why"),
    [
        ((-60.0, 0.0), 0.0, 2.6, "away"),
        ((10.0, 0.0), 1000.0, 2.0, "fell"),
        ((3.0, 0.0), 0.0, 31.0, "late"),
        ((75.0, 0.0), 0.0, 2.1, ""),
    ],
)
def test_what_never_arrives_ends_the_race_as_well(
    velocity: tuple[float, float], gravity: float, seconds: float, why: str
) -> None:
    one = REPLACE(flying(100.0, 0.0), gravity=(0.0, gravity))
    page, rival = racing(one, flying(*velocity))
    page.frames(round(60 * seconds), commands.Play(True))
    mine, theirs = rival.runners
    assert mine.arrived == pytest.approx(1.5)
    assert (mine.out, theirs.out) == ("", why)
    assert theirs.arrived == (None if why else pytest.approx(2.0))
    assert rival.is_over
    page.frames(1, commands.DragStart(0, 0.0, 0.0))
    assert rival.fair  # the result stands


def test_racing_again_starts_both_over() -> None:
    page, rival = racing(flying(100.0, 0.0), flying(200.0, 0.0), 50.0)
    page.frames(60, commands.Play(True))
    assert rival.is_over
    over = page.simulation.time
    page.frames(1, commands.GoTo(0.3))
    assert [runner.is_done for runner in rival.runners] == [False, True]  # as it was at that moment
    page.frames(1, commands.GoTo(over))
    assert rival.is_over
    page.frames(1, commands.Reset())
    assert [runner.is_done for runner in rival.runners] == [False, False]
    page.frames(60, commands.Play(True))
    assert [runner.arrived for runner in rival.runners] == [pytest.approx(0.5), pytest.approx(0.25)]


def test_the_page_is_told_of_finish_and_times() -> None:
    page, _ = racing(flying(100.0, 0.0), flying(-200.0, 0.0), 50.0)
    letters = Letters()
    races = RaceFeature(MagicMock(session=page.session, mail=letters))
    page.frames(60, commands.Play(True))
    races.frame(Drawn(plan=1, now=page.wall(), exactly=False))
    said = letters.last(Race)
    assert (said.finish, said.lines, said.arrived) == (50.0, (50.0, 50.0), (0.5, None))
    assert said.outs == ("", "away")
    page.frames(1, LeaveRace())
    races.frame(Drawn(plan=1, now=page.wall(), exactly=False))
    assert letters.last(Race) == Race()


def test_a_body_that_is_led_over_the_line_is_there_in_that_frame() -> None:
    page, rival = racing(flying(0.0, 0.0), flying(0.0, 0.0), 50.0)
    page.frames(10, commands.Play(True))
    page.frames(2, commands.DragStart(0, 0.0, 0.0), commands.Point(60.0, 0.0))
    page.frames(30)
    arrived = rival.runners[0].arrived
    assert arrived is not None
    assert 0.1 < arrived < page.simulation.time
    assert not rival.fair


@pytest.mark.parametrize(("one", "other"), [("worm", "lesson-worm"), ("swimmer", "worm"), ("worm", "heart")])
def test_the_faster_reaches_the_finish_in_five_to_ten_seconds(one: str, other: str) -> None:
    bodies = sim.load_scene(one), on_terrain(sim.load_scene(other), sim.load_scene(one))
    finish = finish_of(*bodies)
    assert finish == float(f"{finish:.2g}")
    times = []
    for scene in bodies:
        body = sim.Simulation(scene)
        start = center(scene, body.positions)
        while body.time < 10.0 and center(scene, body.positions) - start < finish:
            body.step(20)
        times.append(body.time)
    assert 5.0 < min(times) < 10.0


def test_the_finish_is_on_the_side_to_which_the_faster_goes() -> None:
    assert finish_of(flying(-70.0, 0.0), flying(20.0, 0.0)) == -400.0
    # What does not travel has as far to go as it is long.
    heart = sim.load_scene("heart")
    assert finish_of(heart, heart) == 250.0


def test_what_would_take_too_long_is_not_tried_out() -> None:
    slow = REPLACE(flying(70.0, 0.0), integrator=sim.Integrator(dt=1e-6))
    assert finish_of(slow, slow) == 300.0  # half of the view, as a mass has no length


def test_a_rival_that_explodes_is_out_and_the_other_goes_on() -> None:
    wild = REPLACE(sim.load_scene("walker").integrator, method="symplectic_euler", dt=0.05)
    page, rival = racing(integrator=wild)
    page.frames(120, commands.Play(True))
    assert rival.runners[1].out == "exploded"
    assert not rival.is_late
    assert page.simulation.time > 1.8
    assert not rival.is_over


def test_a_body_that_explodes_is_out_until_it_is_taken_back() -> None:
    wild = REPLACE(sim.load_scene("walker").integrator, method="symplectic_euler", dt=0.05)
    page, rival = racing(REPLACE(sim.load_scene("walker"), integrator=wild), "worm")
    page.frames(60, commands.Play(True))
    assert rival.runners[0].out == "exploded"
    assert not page.session.playing
    page.frames(1, commands.BackBeforeDivergence())
    assert not rival.runners[0].out


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
    rival = page.session.companions.get(Rivals)
    assert (rival is None) == bool(problem)
    if rival is not None:
        assert rival.finish == finish_of(page.session.scene, rival.bodies[0].scene)


def test_others_join_until_there_are_four_and_all_are_drawn_each_by_its_own_steps() -> None:
    page, letters = SessionPage("worm"), Letters()
    races = RaceFeature(MagicMock(session=page.session, mail=letters, shelf=Shelf(owned=False)))

    def race(name: str) -> str:
        answered(page.session, lambda: races.read("rival", name))
        page.frames(1)
        return letters.last(RaceAnswer).problem

    names = ("walker", "heart", "worm")
    assert [race(name) for name in names] == ["", "", ""]
    assert race("swimmer") == "4 bodies are as many as can be in a race."
    rivals = page.session.companions.get(Rivals)
    assert rivals is not None
    assert [scene.name for scene in rivals.scenes] == list(names)
    page.frames(30, commands.Play(True))
    terrain = page.session.scene
    for body, name in zip(rivals.bodies, names, strict=True):
        alone = sim.Simulation(on_terrain(sim.load_scene(name), terrain))
        alone.step(body.step_count)
        assert body.step_count > 0
        assert np.abs(alone.positions - body.positions).max() < 0.5  # its steps end elsewhere
    # One picture has all of them.
    second = picture_of(page.session).second
    assert second is not None
    counts = [len(body.positions) for body in rivals.bodies]
    for part, body in zip(np.split(second.positions, np.cumsum(counts)[:-1]), rivals.bodies, strict=True):
        assert np.array_equal(part, body.positions)
    page.frames(1)
    races.frame(Drawn(plan=1, now=page.wall() + 1.0, exactly=False))
    said = letters.last(Race)
    assert (said.names, said.masses, said.more) == (("Worm", "Walker", "Heart", "Worm"), tuple(counts), False)
    assert len(said.ways) == len(said.lines) == len(said.arrived) == len(said.outs) == 4
    # Back in time, all of them.
    half = [body.positions for body in rivals.bodies]
    at = page.simulation.time
    page.frames(30)
    page.frames(1, commands.GoTo(at))
    assert all(np.array_equal(body.positions, one) for body, one in zip(rivals.bodies, half, strict=True))


def test_what_broke_in_each_of_several_bodies_is_broken_in_the_one_that_is_drawn() -> None:
    scenes = [sim.load_scene(name) for name in ("rope", "triangle", "rope")]
    damages = (None, Damage(broken=(1,)), Damage(broken=(0, 2), set_lengths=(3.0,) * 11))
    pictures = [
        replace(Picture.at_start(scene), damage=one) for scene, one in zip(scenes, damages, strict=True)
    ]
    drawn, whole = side_by_side(scenes, pictures), together(scenes)
    assert drawn.damage is not None
    springs = [len(scene.linear_springs) for scene in scenes]
    assert drawn.damage.broken == (springs[0] + 1, springs[0] + springs[1], springs[0] + springs[1] + 2)
    assert drawn.damage.set_lengths == (0.0,) * (springs[0] + springs[1]) + (3.0,) * springs[2]
    assert len(whole.linear_springs) == sum(springs)
    assert len(whole.masses) == len(drawn.positions) == sum(len(scene.masses) for scene in scenes)
    joint, masses = whole.angular_springs[-1], len(whole.masses) - len(scenes[-1].masses)
    assert joint.b == scenes[-1].angular_springs[-1].b + springs[0] + springs[1]
    assert whole.linear_springs[-1].b == scenes[-1].linear_springs[-1].b + masses
    assert side_by_side(scenes[:1], pictures[:1]) is pictures[0]


def test_the_page_says_the_time_after_which_a_race_ends() -> None:
    words = Path(rivals.__file__).with_name("words.js").read_text(encoding="utf-8")
    assert f'const LIMIT = "{rivals.LIMIT:g}";' in words
