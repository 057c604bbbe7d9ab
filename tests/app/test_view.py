"""When a picture counts as unchanged, and is not sent."""

from __future__ import annotations

from dataclasses import replace
from unittest.mock import MagicMock

import pytest

import sim
from app.stage.pictures import STILL
from app.stage.plan import Picture
from app.ui.view import Canvas
from tests.app.letters import Letters


@pytest.fixture
def scene() -> sim.Scene:
    return sim.rope(4, view=sim.View(frame=(0.0, 0.0, 600.0, 600.0)))


@pytest.fixture
def view(scene: sim.Scene) -> Canvas:
    """A view that was just drawn, of a page that is none."""
    view = Canvas(MagicMock(), Letters(), lambda touch: None)
    view.build(scene, dark=False)
    assert view.draw(start(scene), 0.0)
    return view


def start(scene: sim.Scene) -> Picture:
    """The scene and a second body, a little beside it."""
    picture = Picture.at_start(scene)
    return replace(picture, ghost=picture.positions + 1.0)


def test_the_same_picture_is_not_sent_again_unless_it_must_be(view: Canvas, scene: sim.Scene) -> None:
    assert not view.draw(start(scene), 0.0)
    assert not view.draw(start(scene), 0.0, exactly=True)
    near = replace(start(scene), positions=start(scene).positions + 0.01)
    assert not view.draw(near, 0.0)
    assert view.draw(near, 0.0, exactly=True)
    view.build(scene, dark=True)
    assert view.draw(start(scene), 0.0)


@pytest.mark.parametrize("what", ["positions", "ghost"])
def test_a_movement_of_a_tenth_of_a_pixel_is_sent(view: Canvas, scene: sim.Scene, what: str) -> None:
    places = getattr(start(scene), what)
    for part, sent in ((0.9, False), (1.1, True)):
        moved = places.copy()
        moved[2, 1] -= part * STILL
        assert view.draw(replace(start(scene), **{what: moved}), 0.0) is sent


def test_a_turn_of_half_a_degree_is_sent(view: Canvas, scene: sim.Scene) -> None:
    """Of joints whose masses stay where they are: their rest angles turn."""
    for degrees, sent in ((0.4, False), (-0.6, True)):
        assert view.draw(replace(start(scene), rest_angle_shift=degrees), 0.0) is sent


def test_a_body_that_is_another_one_only_by_its_numbers_keeps_its_nodes() -> None:
    scene = sim.rope(12)
    client = MagicMock()
    view = Canvas(client, Letters(), lambda touch: None)
    view.build(scene, dark=False)
    added = client.scene.add_batched_meshes_simple.call_count
    for key, value in (("masses", 13), ("rest_angle", 20.0)):
        scene = sim.set_value(scene, key, value)
        view.build(scene, dark=False)
        assert view.draw(Picture.at_start(scene), 0.0), f"after another {key} everything is drawn anew"
    view.build(scene, dark=True)
    assert view.draw(Picture.at_start(scene), 0.0), "after another palette, too"
    assert client.scene.add_batched_meshes_simple.call_count == added


def test_a_growth_of_rest_lengths_by_a_thousandth_is_sent(view: Canvas, scene: sim.Scene) -> None:
    for factor, sent in ((1.0009, False), (1.0011, True)):
        assert view.draw(replace(start(scene), rest_length_scale=factor), 0.0) is sent


def test_a_second_body_that_comes_or_goes_is_sent(view: Canvas, scene: sim.Scene) -> None:
    assert view.draw(replace(start(scene), ghost=None), 0.0)
    assert view.draw(start(scene), 0.0)
