"""Editing in a session: the run goes on, undo and redo, going back in time, ghosts, logs."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

import sim
from app.session import commands, versions
from sim.edit.build import extend, positions_of, remove
from sim.edit.edit import Edit, Selection
from sim.edit.shape import move
from sim.edit.values import number, set_number
from sim.scene.types import shown_name
from tests.app.pages import SessionPage
from tests.app.recording import agrees

NOTHING = Selection()


def longer(moment: sim.Moment, _: Selection = NOTHING) -> Edit:
    """One more mass at the end of a rope."""
    x, y = moment.rows[:2, -1].tolist()
    return extend(moment.scene, len(moment.scene.masses) - 1, (x + 10.0, y + 20.0), positions_of(moment))


def shorter(moment: sim.Moment, _: Selection = NOTHING) -> Edit:
    """Without the mass in the middle, which tears the rope in two."""
    return remove(moment.scene, Selection(masses=frozenset({len(moment.scene.masses) // 2})))


def stiffer(moment: sim.Moment, _: Selection = NOTHING) -> Edit:
    return set_number(moment.scene, number("linear_springs", "stiffness"), [3], 5e4)


@pytest.fixture
def page() -> SessionPage:
    return SessionPage()


def masses(page: SessionPage) -> int:
    return len(page.simulation.positions)


def test_the_run_goes_on_over_an_edit_and_its_undo(page: SessionPage) -> None:
    page.frames(30)
    before = page.simulation.capture()
    page.frames(0, commands.Play(False))
    page.frames(1, commands.Change(longer))
    session = page.session
    assert masses(page) == 13
    assert session.simulation.time == before.time
    np.testing.assert_array_equal(session.simulation.positions[:12], before.positions)
    assert session.versions.undoable == "mass and spring added"
    page.frames(1, commands.Undo())
    assert session.simulation.capture().scene is before.scene
    np.testing.assert_array_equal(session.simulation.positions, before.positions)
    assert (session.versions.undoable, session.versions.redoable) == ("", "mass and spring added")
    page.frames(1, commands.Redo())
    assert masses(page) == 13
    page.frames(30, commands.Play(True))
    assert session.simulation.time > before.time
    assert np.isfinite(session.simulation.positions).all()


def test_a_mass_that_was_removed_comes_back_where_it_was(page: SessionPage) -> None:
    page.frames(30, commands.Change(shorter))
    assert masses(page) == 11
    page.frames(1, commands.Play(False), commands.Undo())
    assert masses(page) == 12
    page.frames(20, commands.Play(True))
    lengths = np.hypot(*np.diff(page.simulation.positions, axis=0).T)
    assert lengths.max() < 60.0  # it is a rope again


def test_everything_that_changes_the_scene_is_a_step(page: SessionPage) -> None:
    session = page.session
    first = session.simulation.capture().scene
    page.frames(1, commands.SetValue("gravity", 500.0), commands.SetChoice("method", "rk4"))
    page.frames(1, commands.RestoreSceneValues("body"), commands.Open(sim.load_scene("ring")))
    assert session.versions.undoable == "opening Ring"
    openings = session.openings
    page.frames(1, commands.Undo())
    assert session.openings > openings  # it is to be fitted to the window
    assert session.scene.name == "tutorial-3.3"
    assert session.versions.undoable == "own values of the body"
    page.frames(1, commands.Undo())
    assert session.scene.gravity[1] == 500.0
    assert session.versions.undoable == "Integrator"
    page.frames(1, commands.Undo())
    assert session.simulation.method == "symplectic_euler"
    page.frames(1, commands.Undo())
    assert session.simulation.capture().scene is first
    page.frames(1, *[commands.Redo()] * 4)
    assert session.scene.name == "ring"


def test_moving_a_slider_is_one_step(page: SessionPage) -> None:
    for value in range(100, 130):
        page.frames(1, commands.SetValue("gravity", float(value)))
    assert len(page.session.versions) == 1
    page.frames(100)  # however long it rests in between
    page.frames(1, commands.SetValue("gravity", 129.0))
    assert len(page.session.versions) == 1
    page.frames(1, commands.Visit(), commands.SetValue("gravity", 5.0))  # the next press is another one
    assert len(page.session.versions) == 2
    page.frames(1, commands.Undo())
    assert page.session.scene.gravity[1] == 129.0
    page.frames(1, commands.Undo())
    assert page.session.scene.gravity[1] == 2000.0


def test_one_press_of_a_slider_is_one_step_though_each_value_is_another_body(page: SessionPage) -> None:
    page.frames(5)
    for count in (13, 14, 15):
        page.frames(100, commands.SetValue("masses", float(count)))
    page.frames(1, commands.Visit())
    page.frames(1, commands.SetValue("masses", 16.0))
    assert len(page.session.versions) == 2
    page.frames(1, commands.Undo())
    assert masses(page) == 15
    page.frames(1, commands.Undo())
    assert masses(page) == 12


def test_what_keys_did_before_a_slider_was_moved_stays(page: SessionPage) -> None:
    page.hold(30, "up")
    scale = page.simulation.rest_length_scale
    assert scale > 1.1
    page.frames(1, commands.SetValue("gravity", 500.0), commands.Undo())
    assert page.simulation.rest_length_scale == pytest.approx(scale)
    assert page.session.scene.gravity[1] == 2000.0


def test_a_scale_of_lengths_goes_back_and_forth(page: SessionPage) -> None:
    page.frames(1, commands.SetValue("rest_length_scale", 1.5))
    for command, scale in ((commands.Undo(), 1.0), (commands.Redo(), 1.5)):
        page.frames(1, command)
        assert page.simulation.rest_length_scale == pytest.approx(scale)


def test_an_undo_that_leads_to_another_scene_says_so(page: SessionPage) -> None:
    before = shown_name(page.session.scene)
    page.frames(1, commands.Open(sim.load_scene("jelly")))
    page.frames(1, commands.SetValue("gravity", 500.0))
    page.frames(1, commands.Undo())
    assert not page.session.notices
    page.frames(1, commands.Undo())
    assert [notice.title for notice in page.session.notices] == [f"Back to “{before}”"]
    page.frames(1, commands.Redo())
    assert page.session.notices[-1].text == f"Undo leads to “{before}” again."


def test_after_an_undo_a_slider_begins_another_step(page: SessionPage) -> None:
    page.frames(1, commands.SetValue("gravity", 100.0), commands.SetValue("rest_angle", 5.0))
    page.frames(1, commands.Undo(), commands.SetValue("gravity", 300.0))
    page.frames(1, commands.Undo())
    assert page.session.scene.gravity[1] == 100.0


def test_going_back_in_time_shows_the_body_of_then_and_undo_follows(page: SessionPage) -> None:
    session = page.session
    page.frames(30)
    early = session.simulation.time
    page.frames(30, commands.Change(longer))
    generation = session.generation
    page.frames(1, commands.GoTo(early / 2.0))
    assert masses(page) == 12
    assert session.generation != generation
    assert session.versions.redoable == "mass and spring added"
    page.frames(1, commands.GoTo(session.history.end))
    assert masses(page) == 13
    assert session.versions.undoable == "mass and spring added"
    page.frames(1, commands.GoTo(early / 2.0))
    page.frames(10, commands.Play(True), commands.Change(longer))
    assert session.versions.redoable == ""
    assert masses(page) == 13


def test_a_ghost_follows_over_an_edit(page: SessionPage) -> None:
    page.frames(5, commands.Compare("rk4", ""))
    page.frames(10, commands.Change(longer))
    ghost = page.ghost
    assert len(ghost.simulation.positions) == 13
    assert ghost.distance < 5.0
    page.frames(10, commands.Undo())
    assert len(ghost.simulation.positions) == 12


def test_an_edited_run_is_replayed_bit_for_bit(page: SessionPage) -> None:
    page.frames(20)
    page.frames(20, commands.Change(longer))
    page.frames(20, commands.Change(stiffer))
    page.frames(20, commands.Change(shorter))
    page.frames(20, commands.Undo())
    agrees(page)


def test_what_cannot_be_done_is_one_sentence_and_nothing_changes(page: SessionPage) -> None:
    before = page.simulation.capture().scene

    def all_gone(moment: sim.Moment, _: Selection) -> Edit:
        return remove(moment.scene, Selection(masses=frozenset(range(12))))

    page.frames(1, commands.Change(all_gone))
    assert "at least one mass" in page.told
    assert page.simulation.capture().scene is before
    assert not page.session.versions.undoable
    page.frames(1, commands.Undo(), commands.Redo())  # there is nothing to take back
    assert page.simulation.capture().scene is before


@pytest.mark.parametrize(("most", "bound"), [("MAX_STEPS", 40), ("MAX_BYTES", 50_000)])
def test_undo_is_bounded(page: SessionPage, most: str, bound: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(versions, most, bound)
    page.frames(0, commands.Play(False))
    for i in range(30):
        page.session.post(commands.SetValue("gravity", 1.0 + i % 7))
        page.session.post(commands.SetValue("air_friction", 1e-4 * (1 + i % 5)))
    page.frames(1)
    if most == "MAX_STEPS":
        assert len(page.session.versions) == bound
    else:
        assert 0.8 * bound < page.session.versions.bytes <= bound


def test_the_selection_follows_the_parts(page: SessionPage) -> None:
    """Through edits, undo and redo; a part that is gone is no longer selected, and other bodies have none."""
    session = page.session
    some = Selection(frozenset({2, 6, 9, 40}), frozenset({1, 8}), frozenset({0, 7}))
    page.frames(1, commands.Play(False), commands.Select(lambda moment, selection: some))
    assert session.selection == Selection(frozenset({2, 6, 9}), frozenset({1, 8}), frozenset({0, 7}))
    revision = session.revision
    page.frames(1, commands.Select(lambda _, selection: selection._replace(joints=frozenset({7}))))
    assert session.revision == revision  # nothing is drawn anew
    page.frames(1, commands.Change(shorter))  # without mass 6, between springs 5 and 6
    assert session.selection == Selection(frozenset({2, 8}), frozenset({1, 6}), frozenset({4}))
    page.frames(1, commands.Undo())
    assert session.selection == Selection(frozenset({2, 9}), frozenset({1, 8}), frozenset({7}))
    page.frames(1, commands.Redo())
    assert session.selection == Selection(frozenset({2, 8}), frozenset({1, 6}), frozenset({4}))
    page.frames(1, commands.GoTo(0.0))
    page.frames(1, commands.Open(sim.load_scene("ring")))
    assert session.selection == NOTHING


def test_an_edit_may_say_what_is_selected_and_gets_the_selection(page: SessionPage) -> None:
    def copied(moment: sim.Moment, selection: Selection) -> Edit:
        assert selection.masses == {0, 1}
        edit = longer(moment)
        return dataclasses.replace(edit, select=Selection(frozenset({12})))

    page.frames(1, commands.Select(lambda *_: Selection(frozenset({0, 1}))), commands.Change(copied))
    assert page.session.selection.masses == {12}


def test_edits_with_the_same_key_are_one_step(page: SessionPage) -> None:
    def nudged(moment: sim.Moment, _: Selection) -> Edit:
        return move(moment.scene, [4], (3.0, 1.0))

    session = page.session
    page.frames(1, commands.Play(False))
    before = session.simulation.positions.copy()
    for _ in range(5):
        page.frames(5, commands.Change(nudged, "nudge", within=1.0))
    assert len(session.versions) == 1
    np.testing.assert_allclose(session.simulation.positions[4], before[4] + (15.0, 5.0))
    page.frames(100)  # more than a second later it is another one
    page.frames(1, commands.Change(nudged, "nudge", within=1.0))
    page.frames(1, commands.Change(stiffer, key="other"))
    page.frames(1, commands.Change(nudged), commands.Change(nudged))
    assert len(session.versions) == 5
    page.frames(1, *[commands.Undo()] * 4)
    np.testing.assert_allclose(session.simulation.positions[4], before[4] + (15.0, 5.0))
    page.frames(1, commands.Undo())
    np.testing.assert_array_equal(session.simulation.positions, before)
    page.frames(1, commands.Redo())
    np.testing.assert_allclose(session.simulation.positions[4], before[4] + (15.0, 5.0))
