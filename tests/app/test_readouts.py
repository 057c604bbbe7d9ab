"""Texts that go into the page."""

from __future__ import annotations

import re

import msgspec
import pytest

import sim
from app.session.session import Session
from app.stage.colors import palette
from app.ui import readouts
from app.words import speaking
from sim.solve.registry import METHODS


def test_a_description_from_a_stranger_s_file_is_escaped() -> None:
    evil = "<img src=x onerror=alert(1)>"
    scene = msgspec.structs.replace(sim.rope(), description=evil)
    for editable in (True, False):
        assert "<img" not in readouts.description(scene, editable)
        assert "&lt;img" in readouts.description(scene, editable)


@pytest.mark.parametrize("name", ["tutorial-3.1", "tutorial-3.2", "tutorial-3.3", "ring"])
def test_readouts_are_those_of_the_scene(name: str) -> None:
    session = Session(sim.load_scene(name))
    table = readouts.joint_table(session)
    rows = re.findall(r"<tr><td[^>]*>([^<]*)</td>", table)
    expected = {
        "tutorial-3.1": ["joint0", "sine", "cosine", "angle", "angle"],
        "tutorial-3.2": ["joint0", "angle"],
        "tutorial-3.3": ["joint0", "angle", "rest angle"],
        "ring": ["joint0", "angle", "rest angle"],
    }
    assert rows == expected[name]


def test_the_angle_test_reads_the_tutorial_s_numbers() -> None:
    session = Session(sim.load_scene("tutorial-3.1"))
    session.simulation.move(0, (475.0, 300.0))
    # Springs (-175, 0) and (0, 175): a right angle, clockwise on a screen whose y points down is positive.
    table = readouts.joint_table(session)
    assert "-1.0000" in table
    assert "-90.00°" in table
    assert "-1.5708 rad" in table
    with speaking("es"):
        assert "-1,5708 rad" in readouts.joint_table(session)


def test_a_scene_without_joints_has_no_readout() -> None:
    assert readouts.joint_table(Session(sim.rope(joints=False))) == ""


def test_the_meter_says_when_the_step_is_too_large() -> None:
    session = Session(sim.set_value(sim.load_scene("tutorial-3.3"), "angular_stiffness", 60_000.0))
    session.stability_watch.estimate = session.simulation.stability()
    text = readouts.hud(session, palette("softrod", dark=False), at_rest=False)
    assert re.search(r"time step 2\.5 ms, 1\d\d % of the limit: unstable<", text)
    # A straight body stands still until something bends it.
    session.simulation.step(100)
    text = readouts.hud(session, palette("softrod", dark=False), at_rest=True)
    assert ": unstable, explodes when touched" in text
    session.play(False)
    assert "touched" not in readouts.hud(session, palette("softrod", dark=False), at_rest=True)
    # Nothing is promised of a step that is not too large.
    session = Session(sim.load_scene("tutorial-3.3"))
    session.stability_watch.estimate = session.simulation.stability()
    text = readouts.hud(session, palette("softrod", dark=False), at_rest=True, meter=True)
    assert re.search(r"time step 2\.5 ms, \d\d % of the limit<", text)
    assert "stable" not in text


def test_the_meter_is_there_where_it_matters() -> None:
    scene, colors = sim.load_scene("tutorial-3.3"), palette("softrod", dark=False)

    def has_meter(scene: sim.Scene, meter: bool = False) -> bool:
        session = Session(scene)
        session.stability_watch.estimate = session.simulation.stability()
        return "softrod-meter" in readouts.hud(session, colors, False, meter)

    limit = sim.Simulation(scene).stability().limit
    assert not has_meter(sim.set_value(scene, "dt", 0.75 * limit))
    assert has_meter(sim.set_value(scene, "dt", 0.85 * limit))
    assert has_meter(scene, meter=True)
    view = msgspec.structs.replace(scene.view, readouts=("degrees", "stability"))
    assert has_meter(msgspec.structs.replace(scene, view=view))


@pytest.mark.parametrize(
    ("value", "largest", "text"),
    [
        (1e-295, 1e-290, "0"),
        (-1e-9, 5e4, "0"),
        (3.14159, 5e4, "3.142"),
        (1234567.8, 2e6, "1,234,568"),
        (-1.5e12, 2e12, "-1.5e12"),
    ],
)
def test_energies_are_rounded_to_what_matters(value: float, largest: float, text: str) -> None:
    assert readouts.energy(value, largest) == text


def test_energies_have_a_unit() -> None:
    session = Session(sim.load_scene("tutorial-3.3"))
    session.follows_energy = True
    assert "kg px²/s²" in readouts.energy_table(session)


@pytest.mark.parametrize("method", METHODS)
def test_there_is_a_meter_for_every_method_that_has_a_limit(method: str) -> None:
    session = Session(sim.set_choice(sim.load_scene("tutorial-3.3"), "method", method))
    session.stability_watch.estimate = session.simulation.stability()
    shown = "softrod-meter" in readouts.hud(session, palette("softrod", dark=False), False, meter=True)
    assert shown == (method in ("symplectic_euler", "velocity_verlet", "rk4", "stable_spring"))


def test_clicking_a_mass_finds_its_joint() -> None:
    scene = sim.load_scene("tutorial-3.3")
    assert readouts.joint_of_mass(scene, 1) == 0
    assert readouts.joint_of_mass(scene, 5) == 4
    assert readouts.joint_of_mass(scene, 0) is None


@pytest.mark.parametrize(
    ("value", "text"), [(1e6, "1M"), (5000.0, "5k"), (0.0001, "0.0001"), (-180.0, "-180")]
)
def test_slider_ends_are_short(value: float, text: str) -> None:
    assert readouts.short(value) == text
