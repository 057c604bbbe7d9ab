"""Friction that holds, in a session: what springs remember comes back by looking back, undo and logs."""

from __future__ import annotations

import numpy as np
import pytest

import sim
from app.session import commands
from sim.edit.edit import Edit, Selection
from sim.edit.values import number, set_number
from sim.scene.types import Grips
from sim.settings.touch import with_grip, with_restitution
from tests.app.pages import SessionPage
from tests.app.recording import agrees, busy_page


def sticky() -> sim.Scene:
    return with_grip(with_restitution(sim.load_scene("pile"), "constant"), True)


@pytest.fixture
def page() -> SessionPage:
    """A page whose bodies hold each other, and a wall."""
    page = SessionPage(sticky())
    page.frames(90)
    page.frames(1, commands.Play(False))
    assert min(len(grips_of(page).springs), len(grips_of(page).walls)) > 3
    return page


def grips_of(page: SessionPage) -> Grips:
    grips = page.simulation.capture().grips
    assert grips is not None
    return grips


def test_looking_back_brings_back_what_held(page: SessionPage) -> None:
    session, before = page.session, grips_of(page)
    time = session.simulation.time
    ends = []
    for _ in range(3):
        page.frames(30, commands.Play(True))
        assert grips_of(page) != before
        ends.append(session.simulation.positions)
        page.frames(2, commands.GoTo(time))
        assert session.simulation.time == time
        assert grips_of(page) == before
    assert np.array_equal(*ends[1:])  # the method begins anew there


def test_what_holds_goes_on_holding_over_an_edit_and_its_undo(page: SessionPage) -> None:
    before = grips_of(page)

    def stiffer(moment: sim.Moment, _: Selection) -> Edit:
        return set_number(moment.scene, number("linear_springs", "stiffness"), [3], 5e4)

    for command in (commands.Change(stiffer), commands.Undo(), commands.Redo()):
        scene = page.session.scene
        page.frames(1, command)
        assert page.session.scene != scene
        assert grips_of(page) == before


def test_a_log_leads_to_the_same_bits() -> None:
    page = busy_page(sticky())
    agrees(page)
    assert grips_of(page).springs
