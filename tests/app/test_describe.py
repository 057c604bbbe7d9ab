"""What D says of a body, and of the part of it that is chosen."""

from __future__ import annotations

import dataclasses
import math
import re
import time

import numpy as np
import pytest

import sim
from app.features.describe.messages import Describe, Described, FollowTouches, Touched
from app.features.describe.paragraph import paragraph, swing_of
from app.features.describe.part import of_part
from app.features.describe.touches import TouchWatch
from app.features.edit.messages import Select
from app.features.hands.messages import Grab
from app.session import commands
from app.wire.from_page import Perform
from sim.analysis.description import describe
from sim.analysis.modes import Modes
from sim.analysis.part_description import describe_joint, describe_part, describe_spring
from tests.app.whole import WholePage


def said(page: WholePage) -> str:
    return page.client.mail.last(Described).text


def touched(page: WholePage) -> list[Touched]:
    return [each for each in page.client.mail.sent if isinstance(each, Touched)]


def says(page: WholePage, text: str) -> bool:
    """Whether the page says something in the end: how a body swings is found in a thread."""
    end = time.monotonic() + 60.0
    while text not in said(page) and time.monotonic() < end:
        time.sleep(0.01)
        page.frames(1)
    return text in said(page)


def test_the_chosen_part_is_described_and_with_shift_the_body() -> None:
    page = WholePage("rod")
    page.frames(20)
    page.frames(3, commands.Play(False))
    page.frames(2, Describe(mass=4))
    x, y = page.simulation.positions[4]
    found = re.match(r"Mass 4, .* kg, is at x = ([\d.]+) px, y = ([\d.]+) px\.", said(page))
    assert found
    assert float(found[1]) == pytest.approx(x, rel=0.02)
    assert float(found[2]) == pytest.approx(y, rel=0.02)
    assert "join it to masses 3 and 5" in said(page)
    # What is selected comes before the mass that was clicked.
    page.frames(3, Select(springs=(2,)))
    page.frames(2, Describe(mass=4))
    assert said(page).startswith("Spring 2 joins masses 2 and 3.")
    page.frames(3, Select(joints=(1,)))
    page.frames(2, Describe())
    assert said(page).startswith("Joint 1 is at mass 2, between springs 1 and 2.")
    before, at, after = page.simulation.positions[1:4]
    one, other = (math.atan2(*(end - at)) for end in (before, after))
    corner = re.search(r"The corner between these springs has ([\d.]+)°\.", said(page))
    assert corner
    assert float(corner[1]) == pytest.approx(math.degrees(abs(one - other)), rel=0.02)
    page.frames(2, Perform("describeBody"))
    assert says(page, "A chain of")
    # Of several selected parts the body is described, as without any.
    page.frames(2, Describe(mass=4))
    page.frames(3, Select(springs=(2, 3)))
    page.frames(2, Describe())
    assert says(page, "A chain of")
    page.frames(3, Select())
    page.frames(2, Describe(mass=4))
    page.frames(2, Describe(mass=4000))
    assert says(page, "A chain of")


def test_a_held_mass_a_mass_in_hand_and_one_without_springs_are_told_apart() -> None:
    page = WholePage("rope")
    page.frames(5, Describe(mass=0))
    assert "It is held." in said(page)
    page.frames(5, Grab(0, 3, 0.0, 0.0), Describe(mass=3))
    page.frames(2, Describe(mass=3))
    assert "It is in your hand." in said(page)


def test_each_of_several_bodies_is_described_by_its_place() -> None:
    cradle = sim.load_scene("cradle")
    simulation = sim.Simulation(cradle)
    simulation.step(300)
    x, v = simulation.positions, simulation.velocities
    bodies = paragraph(describe(simulation, cradle), cradle).split("Body ")[1:]
    assert len(bodies) == 5
    for i, said in enumerate(bodies):
        assert said.startswith(f"{i + 1} from the left consists of masses {2 * i} and {2 * i + 1}.")
        found = re.search(r"Its lowest mass, (\d+), is ([\d.]+) px below", said)
        assert found
        assert int(found[1]) == 2 * i + 1
        assert float(found[2]) == pytest.approx(x[2 * i + 1, 1] - x[2 * i, 1], rel=0.02)
        fastest = re.search(r"moves to the right at ([\d.]+) px/s", said)
        assert (fastest is None) == ("It is at rest." in said) == (i > 0)
        if fastest:
            assert float(fastest[1]) == pytest.approx(math.hypot(*v[1]), rel=0.02)
    # One above the other they are told from the top.
    modes = sim.load_scene("lesson-modes")
    text = paragraph(describe(sim.Simulation(modes), modes), modes)
    assert re.findall(r"Body (\d) from the top consists of masses ([\d–]+)\.", text) == [
        ("1", "0–20"), ("2", "21–41"), ("3", "42–62"),
    ]  # fmt: skip
    # Of more than eight, only which mass is the fastest.
    many = sim.Scene(
        name="rain",
        masses=tuple(sim.Mass(position=(30.0 * i, 0.0)) for i in range(9)),
        gravity=(0.0, 1000.0),
    )
    rain = sim.Simulation(many)
    rain.step(100)
    text = paragraph(describe(rain, many), many)
    assert "Body" not in text
    assert re.search(r"The fastest mass, \d, moves down at [\d.]+ px/s\.$", text)
    # That nothing moves is said once.
    hooke = sim.load_scene("lesson-hooke")
    text = paragraph(describe(sim.Simulation(hooke), hooke), hooke)
    assert text.count("Body ") == 2
    assert text.count("Nothing moves.") == 1
    assert "at rest" not in text


def test_muscles_motors_and_forces_are_said() -> None:
    worm = sim.load_scene("worm")
    simulation = sim.Simulation(worm)
    muscles = [s for s, spring in enumerate(worm.linear_springs) if spring.muscle]
    joints = [j for j, joint in enumerate(worm.angular_springs) if joint.muscle or joint.motor]
    texts = [of_part(describe_spring(simulation, worm, s), worm) for s in muscles]
    texts += [of_part(describe_joint(simulation, worm, j), worm) for j in joints]
    assert texts
    assert all("muscle" in text or "motor" in text for text in texts)
    rope = sim.Simulation(sim.rope(masses=4))
    rope.step(100)
    text = of_part(describe_part(rope, rope.scene, "spring", 0), rope.scene)
    assert re.search(r"It is stretched by [\d.]+ %\. It pulls its ends together with [\d.]+ kg px/s²\.", text)


def test_a_touch_is_told_once_after_the_body_was_free_and_only_on_demand() -> None:
    # A mass that falls on a floor, bounces and comes to rest there.
    floor = sim.Wall(point=(300.0, 500.0), normal=(0.0, -1.0), bounciness=0.5, restitution="constant")
    scene = sim.Scene(
        name="ball", masses=(sim.Mass(position=(300.0, 400.0)),), gravity=(0.0, 1000.0), walls=(floor,)
    )
    page = WholePage(scene)
    page.frames(60)
    assert not touched(page)
    page.frames(2, commands.Reset())
    page.frames(600, FollowTouches(on=True))
    told = touched(page)
    assert told
    assert {each.by for each in told} == {"floor"}
    assert len(told) < 4  # small bounces are no news


def test_what_lies_on_a_floor_is_no_news_however_seldom_it_is_looked_at() -> None:
    floor = sim.Wall(point=(300.0, 500.0), normal=(0.0, -1.0))
    resting = sim.Simulation(
        sim.Scene(
            name="ball", masses=(sim.Mass(position=(300.0, 500.2)),), gravity=(0.0, 500.0), walls=(floor,)
        )
    )
    watch = TouchWatch()
    for wall in range(20):
        assert watch.look(resting, 1, -1.0, float(wall)) is None
        resting.step(200)


def test_each_piece_is_said_to_be_held_or_free() -> None:
    masses = tuple(sim.Mass(position=(100.0 * i, 100.0)) for i in range(3))
    spring = sim.LinearSpring(a=0, b=1, stiffness=1000.0, damping=1.0, rest_length=100.0)
    scene = sim.Scene(name="x", masses=masses, linear_springs=(spring,), anchors=(sim.Anchor(mass=0),))
    text = paragraph(describe(sim.Simulation(scene), scene), scene)
    assert re.search(r"^A chain .*?\. It is held at mass 0, .*? A single mass\. Nothing holds it\. ", text)
    assert "Together they are 200 px wide" in text


def test_a_body_that_swings_by_less_than_one_length_is_nearly_at_rest() -> None:
    scene = sim.load_scene("rope")
    simulation = sim.Simulation(scene)
    rest = Modes(scene, 1).rest
    found = describe(simulation, scene)
    found = dataclasses.replace(found, motion=dataclasses.replace(found.motion, velocity=(0.0, 2.0)))
    assert "It is nearly at rest" in paragraph(found, scene, swing_of(found, scene, rest))
    # Where it turns back it is slow, and not at rest.
    assert "moves down at 2 px/s" in paragraph(found, scene, swing_of(found, scene, rest + 5.0))
    fast = dataclasses.replace(found, motion=dataclasses.replace(found.motion, velocity=(0.0, 20.0)))
    assert "moves down at 20 px/s" in paragraph(fast, scene, swing_of(fast, scene, rest))


def test_a_body_that_is_not_let_go_yet_is_not_at_rest() -> None:
    scene = sim.load_scene("rod")
    simulation = sim.Simulation(scene)
    found, rest = describe(simulation, scene), Modes(scene, 1).rest
    told = paragraph(found, scene, swing_of(found, scene, simulation.positions))
    away = re.search(r"It does not move now, ([\d.]+) px away from its rest\.", told)
    assert away, told
    assert float(away[1]) == pytest.approx(max(map(math.hypot, *(simulation.positions - rest).T)), rel=0.02)


def test_a_body_that_floats_is_away_from_its_rest_by_its_deformation_alone() -> None:
    dumbbell = sim.Scene(
        name="dumbbell",
        masses=(sim.Mass(position=(0.0, 0.0)), sim.Mass(position=(100.0, 0.0))),
        linear_springs=(sim.LinearSpring(a=0, b=1, stiffness=1000.0, rest_length=100.0),),
    )
    found = describe(sim.Simulation(dumbbell), dumbbell)
    turned = np.array([[200.0, 50.0], [200.0, 150.0]])
    assert "It is at rest." in paragraph(found, dumbbell, swing_of(found, dumbbell, turned))
    longer = turned + np.array([[0.0, -5.0], [0.0, 5.0]])
    assert "It does not move now, 5 px away from its rest." in paragraph(
        found, dumbbell, swing_of(found, dumbbell, longer)
    )


def test_a_description_that_is_overtaken_is_not_told() -> None:
    page = WholePage("rope")
    page.frames(2, *[Perform("describeBody")] * 5, Describe(mass=3))
    assert says(page, "Mass 3,")
    page.frames(2, Perform("describeBody"))
    assert says(page, "A chain of")
    # What was not told is nothing that the next one compares with.
    assert "since" not in said(page).lower()
    texts = [each.text for each in page.client.mail.sent if isinstance(each, Described)]
    assert [text.split(",")[0].split(" of ")[0] for text in texts] == ["Mass 3", "A chain"]
