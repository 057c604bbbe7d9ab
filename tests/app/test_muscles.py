"""Muscles in a session: given and moved by what a page says, the tempo of a run, and how they are drawn."""

from __future__ import annotations

from dataclasses import replace

import msgspec
import numpy as np
import pytest

import sim
from app.export import instances
from app.features.edit.messages import MoveMuscles, Select, ShapeMuscles, Tempo
from app.pages.sandbox.features import COMMANDS
from app.session import commands, log
from app.session.replay import Player
from app.stage.colors import palette
from app.stage.plan import Picture, encode_plan, own_rest_angles
from app.stage.sketch import Sketch
from app.wire.messages import read
from sim.edit.edit import Selection
from sim.edit.muscles import crest, give_muscles
from sim.forces.muscles import swings
from sim.scene.parts import JointMuscle, SpringMuscle
from tests.app.page_script import drawn
from tests.app.pages import SessionPage, answered
from tests.app.test_edits import Page

SOME = Selection(springs=frozenset({1, 2}), joints=frozenset({0}))


def worm() -> sim.Scene:
    scene = sim.rope(6, integrator=sim.Integrator(method="symplectic_euler"))
    return give_muscles(scene, SOME).scene


def muscle(page: Page) -> None:
    """Press the command's key."""
    does = COMMANDS["muscle"].does
    assert isinstance(does, commands.Change)
    page.session.post(does)
    page.frames(1)


# ------------------------------------------------------------------------- what the page says
def test_one_command_makes_muscles_and_takes_them_away() -> None:
    page = Page(sim.rope(6))
    muscle(page)
    assert [notice.text for notice in page.session.notices] == [
        "select springs or joints that are to have a muscle"
    ]
    first = page.do(Select(springs=(1, 2), joints=(0,)))
    muscle(page)
    scene = page.do()
    assert [bool(s.muscle) for s in scene.linear_springs] == [False, True, True, False, False]
    assert scene.angular_springs[0].muscle == JointMuscle() and scene.beat
    assert page.session.selection == SOME  # so that they can be moved at once
    page.do(Select(springs=(1,)))
    muscle(page)
    assert not page.do().linear_springs[1].muscle
    assert page.do(commands.Undo(), commands.Undo()) is first


def test_a_drag_is_one_step_and_keys_in_a_row_are_one() -> None:
    page = Page(worm())
    page.do(Select(springs=(1, 2)))
    for _ in range(5):
        page.do(MoveMuscles(later=0.02, stretch=0.01))
    assert len(page.session.versions) == 1
    page.do(commands.Visit(), MoveMuscles(later=-0.1))
    assert len(page.session.versions) == 2
    for _ in range(3):
        page.do(MoveMuscles(stretch=0.05, keys=True))
    assert len(page.session.versions) == 3
    scene = page.do(ShapeMuscles(wave="pulse", per_beat=2))
    assert scene.linear_springs[1].muscle == SpringMuscle(
        amplitude=0.4, wave="pulse", per_beat=2, phase=270.0
    )
    scene = page.do(ShapeMuscles(spread=True))
    assert [crest(s.muscle) for s in scene.linear_springs if s.muscle] == [0.0, 0.5 % 0.5]
    page.do(*[commands.Undo()] * 5)
    assert page.session.scene == worm()


@pytest.mark.parametrize(
    "text",
    [
        '{"do": "tempo", "frequency": 101}',
        '{"do": "tempo", "frequency": 1e999}',
        '{"do": "moveMuscles", "later": 11}',
        '{"do": "moveMuscles", "stretch": "1"}',
        '{"do": "shapeMuscles", "per_beat": 0}',
        '{"do": "shapeMuscles", "per_beat": 1.5}',
        '{"do": "shapeMuscles", "wave": "saw"}',
    ],
)
def test_what_makes_no_sense_is_not_heard(text: str) -> None:
    assert read(text) is None


# ------------------------------------------------------------------------- the tempo
def test_the_waves_go_on_at_another_tempo_and_a_replay_has_the_same_bits() -> None:
    page = Page(worm())
    page.session.post(commands.Play(True))
    page.frames(40)
    session = page.session
    for frequency in (2.0, 0.3, 0.0, 5.0):
        before = session.simulation.capture()
        page.edits.do(Tempo(frequency))
        session.drain()
        after = session.simulation.capture()
        assert after.time == before.time > 0.5
        parts = after.scene.linear_springs[1], after.scene.angular_springs[0]
        kinds = [part.muscle for part in parts if part.muscle]
        assert before.scene.beat and after.scene.beat and after.scene.beat.frequency == frequency
        then = swings(before.scene.beat, kinds, (), before.time)
        np.testing.assert_allclose(swings(after.scene.beat, kinds, (), after.time), then, atol=1e-9)
        page.frames(20)
    assert len(session.versions) == 1
    record = log.decode_log(answered(session, session.log_file), "log")
    player = Player(record, sim.Simulation(record.scene))
    while not player.ended:
        player.do()
    assert player.agrees, player.verdict
    page.do(commands.GoTo(0.5))  # a moment with the tempo of then
    assert session.simulation.capture().scene.beat == worm().beat


def test_undo_and_redo_of_a_tempo_let_the_waves_go_on() -> None:
    page = Page(worm())
    page.session.post(commands.Play(True))
    session = page.session
    page.frames(40)

    def beats(moment: sim.Moment) -> float:
        beat = moment.scene.beat
        assert beat
        return (beat.frequency * moment.time + beat.phase / 360.0) % 1.0

    def does(command: commands.Command, frequency: float) -> None:
        before = session.simulation.capture()
        session.post(command)
        session.drain()
        after = session.simulation.capture()
        assert after.scene.beat and after.scene.beat.frequency == frequency
        assert beats(after) == pytest.approx(beats(before), abs=1e-9)
        page.frames(17)

    first = worm().beat
    assert first
    page.do(commands.SetValue("gravity", 700.0), commands.Visit(), commands.SetValue("tempo", 2.3))
    page.frames(21)
    middle = session.simulation.time
    page.frames(21)
    does(commands.Undo(), first.frequency)
    again = session.simulation.time - 0.05
    does(commands.Undo(), first.frequency)
    assert not session.versions.undoable
    does(commands.Redo(), first.frequency)
    does(commands.Redo(), 2.3)
    assert not session.versions.redoable
    # Each version is known again in the past, whatever the phase of its beat is there.
    for time, undoable in ((0.2, ""), (middle, "Tempo"), (again, "Gravity")):
        page.do(commands.GoTo(time))
        assert session.versions.undoable.startswith(undoable) if undoable else not session.versions.undoable
        assert session.versions.has_undo(session.scene) == bool(undoable)
    does(commands.Undo(), first.frequency)
    assert session.scene.gravity == worm().gravity


# ------------------------------------------------------------------------- drawing
def moved(time: float, *efforts: float) -> tuple[sim.Scene, Picture]:
    scene = worm()
    others = (
        SpringMuscle(amplitude=-0.3, wave="pulse", per_beat=3, phase=10.0),
        SpringMuscle(amplitude=0.3, wave="pulse", phase=80.0, keys="left-right"),
        SpringMuscle(amplitude=0.2, wave="steady", keys="up-down"),
    )
    springs = list(scene.linear_springs)
    for k, muscle in enumerate(others, 2):
        springs[k] = msgspec.structs.replace(springs[k], muscle=muscle)
    scene = msgspec.structs.replace(scene, linear_springs=tuple(springs), bodies=())
    return scene, replace(Picture.at_start(scene), time=time, efforts=efforts)


@pytest.mark.parametrize("moment", [(0.0,), (0.21, 0.7, -0.4), (7.7, -1.0, 0.0)])
def test_pictures_have_muscles_where_the_page_has_them(moment: tuple[float, ...]) -> None:
    scene, picture = moved(*moment)
    nodes, sketch = drawn(scene, picture), Sketch(scene, palette(scene.view.colors, dark=False))
    rest = np.array([joint.rest_angle for joint in scene.angular_springs])
    for kind, parts in (
        ("muscles", instances.muscles(sketch, picture, of_joints=False)),
        ("halos", instances.muscles(sketch, picture, of_joints=True)),
        ("springs", instances.springs(sketch, picture)),
    ):
        node = nodes[kind]
        np.testing.assert_allclose(node["positions"][:, :2], parts.places, atol=1e-5)
        np.testing.assert_allclose(node["scales"][:, :2], np.c_[parts.lengths, parts.widths], rtol=1e-4)
        assert np.abs(node["colors"] - parts.colors).max() <= 12.0  # a shade of the table beside it at most
    np.testing.assert_allclose(nodes["deviations"], instances.deviations(sketch, picture, rest), atol=1e-3)


def test_a_log_repeats_what_keys_work_bit_for_bit() -> None:
    """Also from a moment at which a key is held."""
    page = SessionPage(sim.load_scene("hopper"))
    page.frames(20, commands.HoldKeys(frozenset({"down", "right"})))
    page.frames(6, commands.HoldKeys(frozenset({"up"})))
    moment = page.session.simulation.capture()
    entry = log.restore_entry(moment, with_scene=True)
    assert (
        log.moment_of(msgspec.convert(msgspec.to_builtins(entry), log.Restore), moment.scene).steer
        == moment.steer
    )
    page.frames(10, commands.SetValue("gravity", 900.0))
    page.frames(10, commands.GoTo(0.2), commands.Play(True))
    page.frames(20, commands.HoldKeys(frozenset()))
    record = log.decode_log(answered(page.session, page.session.log_file), "log")
    player = Player(record, sim.Simulation(record.scene))
    while not player.ended:
        player.do()
    assert player.agrees, player.verdict


def test_a_muscle_is_thickest_while_it_is_shortest() -> None:
    quarter, three = (moved(time) for time in (0.25, 0.75))
    widths = [
        instances.muscles(Sketch.plain(scene), picture, of_joints=False).widths[0]
        for scene, picture in (quarter, three)
    ]
    assert widths[1] == pytest.approx(widths[0] * 1.25 / 0.75)
    simulation = sim.Simulation(quarter[0])
    simulation.advance(0.25)
    assert own_rest_angles(simulation) == pytest.approx([0.0] * 4)  # without what the muscle adds now
    assert simulation.rest_angles[0] == pytest.approx(20.0)


def test_a_body_without_muscles_is_told_of_none() -> None:
    scene, rest = sim.rope(6), np.zeros(4)
    plain, muscular = (encode_plan(0, Sketch.plain(each), rest) for each in (scene, worm()))
    resting = msgspec.structs.replace(worm(), beat=msgspec.UNSET)
    assert np.array_equal(encode_plan(0, Sketch.plain(resting), rest), plain)
    assert len(muscular) > len(plain)
