"""Whatever commands a page sends, in whatever order: none is an exception, and every frame can be sent."""

from __future__ import annotations

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

import sim
from app.features.edit import messages as asks
from app.features.edit.edits import make_edit
from app.features.modes.feature import DriveMode, PutIntoMode, ShowModes
from app.session import commands
from app.stage.plan import encode_damage, encode_frame
from app.ui.view import picture_of
from sim.edit.edit import Selection
from tests.amount import examples
from tests.app.pages import SessionPage

SCENES = {name: sim.load_scene(name) for name in ("tutorial-3.3", "triangle", "tutorial-3.1")}

unit = st.floats(-3.0, 3.0, width=32)
place = st.tuples(unit, unit)
index = st.integers(0, 5)
some = st.none() | index

DONE = ("remove", "pin", "duplicate", "mirror", "corners", "triangulate", "rest")


def change(ask: asks.Gesture) -> commands.Change:
    return commands.Change(lambda *now: make_edit(ask, *now))


def select(masses: frozenset[int], springs: frozenset[int]) -> commands.Select:
    return commands.Select(lambda *_: Selection(masses, springs))


COMMANDS: st.SearchStrategy[commands.Command] = st.one_of(
    st.builds(commands.Play, st.sampled_from([None, True, False])),
    st.builds(commands.DoSteps, st.integers(1, 5)),
    st.builds(commands.GoTo, st.floats(0.0, 0.3)),
    st.builds(commands.GoBack, st.sampled_from([0.0, 0.05])),
    st.builds(commands.GoForward),
    st.builds(commands.ForgetFuture),
    st.builds(commands.BackBeforeDivergence),
    st.builds(commands.Reset),
    st.builds(commands.Undo),
    st.builds(commands.Redo),
    st.builds(commands.Visit),
    st.builds(commands.Open, st.sampled_from(list(SCENES.values()))),
    st.builds(commands.Compare, st.sampled_from(["", "rk4", "symplectic_euler"]), st.just("")),
    st.builds(commands.MeasurePredictability, st.booleans()),
    st.builds(commands.FollowEnergy, st.booleans()),
    st.builds(commands.SetValue, st.just("gravity"), st.sampled_from([0.0, 500.0])),
    st.builds(commands.SetValue, st.just("masses"), st.sampled_from([4.0, 6.0, 12.0])),
    st.builds(commands.SetChoice, st.just("method"), st.sampled_from(["rk4", "symplectic_euler"])),
    st.builds(commands.RestoreSceneValues, st.sampled_from(["body", "solver"])),
    st.builds(commands.DragStart, index, unit, unit),
    st.builds(commands.Point, unit, unit, late=st.just(True)),
    st.builds(commands.DragEnd),
    st.builds(commands.Follow, st.booleans()),
    st.builds(ShowModes, st.booleans()),
    st.builds(PutIntoMode, index, unit),
    st.builds(DriveMode, st.integers(-1, 5)),
    st.builds(commands.SelectJoint, index),
    st.builds(commands.HoldKeys, st.sampled_from([frozenset(), frozenset({"up"}), frozenset({"left"})])),
    st.builds(select, st.frozensets(index, max_size=3), st.frozensets(index, max_size=2)),
    st.builds(
        change,
        st.builds(
            asks.Line, st.none() | index, st.none() | index, st.tuples(unit, unit), st.tuples(unit, unit)
        ),
    ),
    st.builds(change, st.builds(asks.Place, unit, unit)),
    st.builds(change, st.builds(asks.Move, unit, unit, st.booleans(), some)),
    st.builds(change, st.builds(asks.Act, st.sampled_from(DONE), some)),
)


def check(page: SessionPage) -> None:
    """The frame that the page would be sent."""
    picture = picture_of(page.session)
    n = len(page.session.scene.masses)
    assert picture.positions.shape == (n, 2)
    assert picture.ghost is None or picture.ghost.shape == (n, 2)
    numbers = encode_frame(1, picture)
    assert np.isfinite(numbers).all()
    time, left = float(numbers[2]), float(numbers[5])
    assert abs(time + left - picture.time) <= 1e-12 * max(picture.time, 1.0)
    encode_damage(1, picture)
    page.session.keepsake()


@settings(max_examples=examples(100))
@given(st.lists(st.tuples(COMMANDS, st.integers(0, 3)), max_size=25))
def test_no_order_of_commands_ends_in_an_exception(told: list[tuple[commands.Command, int]]) -> None:
    page = SessionPage(SCENES["tutorial-3.3"])
    page.frames(3)
    for command, frames in told:
        page.session.post(command)
        page.session.drain()
        check(page)
        page.frames(frames)
        check(page)


def test_a_second_body_has_the_masses_of_the_first_where_all_of_them_are_held() -> None:
    page = SessionPage(SCENES["tutorial-3.1"])
    page.frames(2, commands.Open(SCENES["tutorial-3.3"]), commands.Compare("rk4", "angle", 4))
    page.frames(2, commands.Undo())
    check(page)
    page.frames(2, commands.Redo())
    check(page)
    assert all(notice.kind == "info" for notice in page.session.notices)


def test_before_a_runaway_is_found_though_an_edit_has_added_masses() -> None:
    page = SessionPage(SCENES["tutorial-3.3"])
    page.frames(3, commands.SetValue("rest_angle", 30.0))
    line = asks.Line(a=11, end=(1.0, 1.0))
    page.frames(3, change(line), commands.SetValue("angular_stiffness", 1e9))
    page.frames(60)
    assert page.simulation.divergence is not None
    page.frames(1, commands.BackBeforeDivergence())
    assert page.simulation.divergence is None
    check(page)
