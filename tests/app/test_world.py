"""What the page is told and draws of surroundings and of damage, without a browser."""

from __future__ import annotations

import json
import re
from dataclasses import replace
from functools import partial
from unittest.mock import MagicMock

import msgspec
import numpy as np
import pytest

import sim
from app.export import around
from app.export.window import Window
from app.session import commands
from app.session.history import History
from app.session.notices import runaway_notice
from app.stage.colors import sent
from app.stage.looks import YIELDED
from app.stage.plan import Picture, encode_plan, yielded_of
from app.ui import readouts
from app.ui.view import Canvas
from sim.forces.air import wind_at
from sim.model.system import build_system
from sim.motion.energy import ENERGY_FIELDS
from sim.motion.stability import StabilityEstimate
from sim.scene.surroundings import Contact, Wall
from sim.scene.types import Damage
from tests.app.letters import Letters
from tests.app.page_script import drawn, sketch_of
from tests.app.pages import SessionPage
from tests.app.worlds import GUSTS, balloon, chain_under_load

HURT = Damage(broken=(1,), set_lengths=(0.0, 0.0, 30.0, 0.0), set_angles=(0.0, 0.0, 25.0))


def points(outline: str) -> np.ndarray:
    """The corners of a path of straight lines."""
    return np.array([list(map(float, pair.split())) for pair in re.findall(r"[-\d.]+ [-\d.]+", outline)])


def inside(corners: np.ndarray, x: float, y: float) -> bool:
    """Whether a polygon covers a point: a line from there crosses its edges an odd number of times."""
    after = np.roll(corners, -1, 0)
    spans = (corners[:, 1] > y) != (after[:, 1] > y)
    a, b = corners[spans], after[spans]
    return bool(((a[:, 0] + (y - a[:, 1]) / (b[:, 1] - a[:, 1]) * (b[:, 0] - a[:, 0])) > x).sum() % 2)


# ------------------------------------------------------------------------- surroundings
def test_a_scene_without_surroundings_is_told_nothing_of_them() -> None:
    scene = sim.rope(6)
    assert drawn(scene, Picture.at_start(scene))["sizes"].tolist() == [0, 0, 0]
    # Not even that there are none: its plan has just the sections of the body.
    plan, at, sections = encode_plan(1, sketch_of(scene), np.zeros(4)), 0, 0
    while at < len(plan):
        at, sections = at + 1 + int(plan[at]), sections + 1
    assert (at, sections) == (len(plan), 13)


def test_a_floor_is_filled_below_its_surface() -> None:
    scene = chain_under_load()
    corners = points(drawn(scene, Picture.at_start(scene))["outlines"]["wall"])
    assert inside(corners, 300.0, 581.0)
    assert not inside(corners, 300.0, 579.0)


@pytest.mark.parametrize("y_down", [True, False])
def test_a_slope_is_on_the_side_that_its_normal_does_not_point_to(y_down: bool) -> None:
    slope = Wall(point=(300.0, 300.0), normal=(1.0, 1.0))
    scene = balloon(walls=(slope,), view=sim.View(y_down=y_down))
    corners = points(drawn(scene, Picture.at_start(scene))["outlines"]["wall"])
    for x, y in ((290.0, 290.0), (150.0, 400.0), (310.0, 310.0), (450.0, 200.0)):
        on_screen = y if y_down else 600.0 - y
        assert inside(corners, x, on_screen) == (x + y < 600.0)


@pytest.mark.parametrize("liquid", [True, False])
def test_a_filling_is_where_its_loop_is_however_that_is_bent(liquid: bool) -> None:
    scene = balloon(liquid)
    bent = Picture.at_start(scene).positions
    bent[0] = (230.0, 300.0)  # far inside: no longer convex
    outlines = drawn(scene, Picture(bent))["outlines"]
    assert outlines["gas" if liquid else "liquid"] == ""
    corners = points(outlines["liquid" if liquid else "gas"])
    order = np.lexsort(corners.round(1).T), np.lexsort(bent.round(1).T)
    assert corners[order[0]] == pytest.approx(bent[order[1]], abs=0.06)
    assert inside(corners, 225.0, 300.0)
    assert not inside(corners, 260.0, 300.0)


def test_the_skin_of_contact_is_along_the_springs_that_are_not_broken() -> None:
    scene = chain_under_load(contact=Contact(distance=8.0))
    picture = Picture.at_start(scene)
    corners = points(drawn(scene, replace(picture, damage=HURT))["outlines"]["skin"]).reshape(-1, 2, 2)
    wanted = [picture.positions[[spring.a, spring.b]] for spring in scene.linear_springs]
    assert corners == pytest.approx(np.array([wanted[0], wanted[2], wanted[3]]))
    assert drawn(chain_under_load(), picture)["outlines"]["skin"] == ""


def test_the_wind_that_is_drawn_is_that_which_blows() -> None:
    scene = balloon(wind=GUSTS, air_friction=0.01)
    air = drawn(scene, Picture.at_start(scene))["air"]
    table = build_system(scene).body.environment.air
    for t in (0.0, 1.7):
        # Gusts stand still for who moves with the mean wind.
        there = 120.0 + 250.0j + t * complex(*GUSTS.velocity)
        assert air == pytest.approx(wind_at(table, t, there.real, there.imag), abs=0.05)


def test_there_is_no_wind_to_draw_where_it_does_nothing_or_is_calm() -> None:
    for scene in (
        balloon(wind=GUSTS),
        sim.set_value(balloon(wind=GUSTS, air_friction=0.01), "wind_speed", 0.0),
    ):
        assert drawn(scene, Picture.at_start(scene))["sizes"][2] == 0


@pytest.mark.parametrize("kinds", [("medium",), ("ground",), ("medium", "ground"), ()])
def test_a_medium_and_the_ground_are_told_of_and_drawn_where_a_scene_has_them(kinds: tuple[str, ...]) -> None:
    """In pictures as in the page, mark for mark."""
    around_it = {"medium": sim.Medium(), "ground": sim.Ground()}
    scene = chain_under_load(**{kind: around_it[kind] for kind in kinds})
    outlines = drawn(scene, Picture.at_start(scene))["outlines"]
    assert [kind for kind in ("medium", "ground") if outlines[kind]] == list(kinds)
    sketch = sketch_of(scene)
    scale = sketch.mapping.scale
    x, y = (np.array((0.0, 0.0)) - sketch.mapping.center) * (scale, scale * sketch.mapping.flip)
    window = Window((600, 600), -x / scale, y / scale, 1.0 / scale)  # its pixels are px of the scene
    assert window.unit == pytest.approx(1.0)
    for kind, lines in (("ripple", around.ripples(sketch, window)), ("grain", around.grains(sketch, window))):
        assert points(outlines[kind]).reshape(-1, 2) == pytest.approx(lines.reshape(-1, 2), abs=0.051), kind


# ------------------------------------------------------------------------- damage
def test_broken_springs_and_their_wedges_vanish_of_the_ghost_too() -> None:
    scene = chain_under_load()
    picture = Picture.at_start(scene)
    picture = replace(picture, damage=HURT, ghost=picture.positions, ghost_broken=(0, 3))
    nodes, slices = drawn(scene, picture), sketch_of(scene).slices
    assert (nodes["springs"]["scales"][:, 0] < 1e-5).tolist() == [False, True, False, False]
    assert (nodes["ghost"]["scales"][:, 0] < 1e-5).tolist() == [True, False, False, True]
    gone = (nodes["wedges"]["scales"][:, 0] < 1e-5).reshape(-1, slices)
    assert gone.all(1).tolist() == [True, True, False]
    assert gone.any(1).tolist() == [True, True, False]


def test_springs_that_have_yielded_have_a_mark_as_long_as_they_are_broken() -> None:
    scene = chain_under_load()
    picture = Picture.at_start(scene)
    hurt = Damage(broken=(1,), set_lengths=(0.9 * YIELDED * 50.0, 30.0, -30.0, 1.1 * YIELDED * 50.0))
    marks = drawn(scene, replace(picture, damage=hurt))["yielded"]
    springs = drawn(scene, picture)["springs"]
    assert (marks["scales"][:, 0] > 1e-5).tolist() == [False, False, True, True]
    assert marks["scales"][2:, 0] == pytest.approx(springs["scales"][2:, 0])
    assert (marks["scales"][2:, 1] < 0.5 * springs["scales"][2:, 1]).all()
    assert yielded_of(hurt, np.full(4, 50.0)) == 2
    assert yielded_of(Damage(broken=(1,)), np.full(4, 50.0)) == yielded_of(None, np.full(4, 50.0)) == 0


def test_only_a_scene_whose_springs_can_yield_has_a_node_for_marks() -> None:
    for yields in (None, 100.0):
        scene, client = chain_under_load(), MagicMock()
        springs = tuple(msgspec.structs.replace(s, yield_force=yields) for s in scene.linear_springs)
        Canvas(client, Letters(), lambda touch: None).build(
            msgspec.structs.replace(scene, linear_springs=springs), dark=False
        )
        names = [call.args[0] for call in client.scene.add_batched_meshes_simple.call_args_list]
        assert ("/body/yielded" in names) == (yields is not None)


def test_colours_and_wedges_go_by_the_present_rest_lengths_and_angles() -> None:
    scene = chain_under_load()
    colors = sketch_of(scene).palette
    places = Picture.at_start(scene).positions
    places[3:, 1] += 30.0  # spring 2 is as long as it has become
    nodes = drawn(scene, Picture(places, damage=HURT))
    assert (nodes["springs"]["colors"][2] == sent(colors.rest)).all()
    assert nodes["deviations"] == pytest.approx([0.0, 0.0, -25.0])
    assert (drawn(scene, Picture(places))["springs"]["colors"][2] == sent(colors.pulled)).all()


def told(letters: Letters) -> list[str]:
    """What the page was told of by numbers."""
    return [json.loads(message.text)["tell"] for message in letters.sent]


def test_damage_is_sent_when_it_changes_and_only_then() -> None:
    scene, letters = chain_under_load(), Letters()
    view = Canvas(MagicMock(), letters, lambda touch: None)
    view.build(scene, dark=False)
    still = Picture.at_start(scene)
    assert view.draw(still, 0.0)
    assert told(letters) == ["plan", "frame"]
    assert view.draw(replace(still, damage=HURT), 0.0)
    assert told(letters)[2:] == ["damage", "frame"]
    assert not view.draw(replace(still, damage=HURT), 0.0)
    # A little more is not seen, but by those who look closely.
    more = msgspec.structs.replace(HURT, set_lengths=(0.0, 0.0, 30.05, 0.0))
    assert not view.draw(replace(still, damage=more), 0.0)
    assert view.draw(replace(still, damage=more), 0.0, exactly=True)
    much = msgspec.structs.replace(HURT, set_lengths=(0.0, 0.0, 31.0, 0.0))
    assert view.draw(replace(still, damage=much), 0.0)
    assert view.draw(still, 0.0)  # all is whole again
    assert view.draw(replace(still, ghost=still.positions), 0.0)
    assert view.draw(replace(still, ghost=still.positions, ghost_broken=(1,)), 0.0)


# ------------------------------------------------------------------------- in time
def broken(page: SessionPage) -> int:
    damage = page.simulation.damage
    return len(damage.broken) if damage else 0


def test_going_back_brings_springs_back_in_body_ghost_and_old_future() -> None:
    page = SessionPage(chain_under_load())
    session = page.session
    page.frames(1, commands.Compare("rk4", ""))
    page.frames(60)
    assert broken(page) == 1
    ghost = page.ghost
    assert ghost.simulation.damage is not None
    page.frames(1, commands.GoTo(0.05))
    assert broken(page) == 0
    assert ghost.simulation.damage is None
    page.frames(1, commands.SetValue("strength", 1e6))
    assert "broken" not in readouts.hud(session, sketch_of(session.scene).palette, False)
    page.frames(40, commands.Play(True))
    assert broken(page) == 0
    future = session.abandoned_future
    assert future is not None
    late = future.damage_at(0.6)
    assert late and late.broken == (1,)
    assert future.damage_at(0.06) is future.damage_at(99.0) is None


def test_the_head_up_display_counts_broken_springs() -> None:
    page = SessionPage(chain_under_load())
    page.frames(60)
    assert "1 spring broken" in readouts.hud(page.session, sketch_of(page.session.scene).palette, False)


def test_the_head_up_display_counts_springs_that_have_yielded() -> None:
    """The girder yields long before it breaks, and not under the load that it comes with."""
    scene = sim.load_scene("girder")
    page = SessionPage(scene)
    shown = partial(readouts.hud, page.session, sketch_of(scene).palette, False)
    page.frames(60)
    assert "yielded" not in shown()
    page.frames(60, commands.SetValue("load", 130.0))
    assert "springs yielded" in shown()
    assert "broken" not in shown()
    page.frames(120, commands.SetValue("load", 250.0))
    assert "springs broken" in shown()


def test_moments_share_damage_that_does_not_change() -> None:
    ring, simulation = History(), sim.Simulation(chain_under_load())
    for _ in range(60):
        simulation.step(8)
        ring.add(simulation.capture())
    assert ring[ring.last].damage is not None
    assert ring[ring.last].damage is ring[ring.last - 1].damage


def test_every_entry_of_the_energy_balance_has_a_name() -> None:
    assert readouts.ENERGIES == ENERGY_FIELDS
    assert all(map(readouts.energy_name, ENERGY_FIELDS))


def test_energies_of_surroundings_and_losses_have_names() -> None:
    page = SessionPage(chain_under_load())
    page.frames(80, commands.FollowEnergy(True))
    table = readouts.energy_table(page.session)
    for name in ("lost in breaking", "lost to walls", "residual"):
        assert name in table
    assert "gases" not in table
    page = SessionPage(balloon())
    page.frames(5, commands.FollowEnergy(True))
    table = readouts.energy_table(page.session)
    assert "gases and liquids" in table
    assert "breaking" not in table


@pytest.mark.parametrize("cause", ["walls", "fillings"])
def test_a_runaway_by_surroundings_is_explained(cause: str) -> None:
    divergence = sim.Divergence(0, 1, "position", 1e6, 0.01, lambda: StabilityEstimate(0.004, cause))  # type: ignore[arg-type]
    text = runaway_notice(divergence, balloon()).text
    assert f"the stiffness of the {cause}" in text
    assert "choose the integrator Auto" in text
    assert str(divergence).endswith(f"set by the {cause}")
