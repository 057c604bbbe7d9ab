"""When a picture counts as unchanged, and is not sent."""

from __future__ import annotations

from dataclasses import replace
from unittest.mock import MagicMock

import numpy as np
import pytest

import sim
from app.page.view import STILL, Canvas, Picture


@pytest.fixture
def scene() -> sim.Scene:
    return sim.rope(4, view=sim.View(frame=(0.0, 0.0, 600.0, 600.0)))


@pytest.fixture
def view(scene: sim.Scene) -> Canvas:
    """A view that was just drawn, of a page that is none."""
    view = Canvas(MagicMock(), lambda touch: None, lambda mass: None)
    view.build(scene, dark=False)
    assert view.draw(start(scene))
    return view


def start(scene: sim.Scene) -> Picture:
    """The scene and a second body, a little beside it."""
    picture = Picture.at_start(scene)
    return replace(picture, ghost=picture.positions + 1.0)


def test_the_same_picture_is_not_sent_again_unless_it_must_be(view: Canvas, scene: sim.Scene) -> None:
    assert not view.draw(start(scene))
    assert view.draw(start(scene), force=True)
    view.build(scene, dark=True)
    assert view.draw(start(scene))


@pytest.mark.parametrize("what", ["positions", "ghost"])
def test_a_movement_of_a_tenth_of_a_pixel_is_sent(view: Canvas, scene: sim.Scene, what: str) -> None:
    places = getattr(start(scene), what)
    for part, sent in ((0.9, False), (1.1, True)):
        moved = places.copy()
        moved[2, 1] -= part * STILL
        assert view.draw(replace(start(scene), **{what: moved})) is sent


def test_a_turn_of_half_a_degree_is_sent(view: Canvas, scene: sim.Scene) -> None:
    """Of a joint whose masses stay where they are: its rest angle turns."""
    for degrees, sent in ((0.4, False), (-0.6, True)):
        turned = start(scene).deviations + np.array([0.0, degrees])
        assert view.draw(replace(start(scene), deviations=turned)) is sent


def test_a_growth_of_rest_lengths_by_a_thousandth_is_sent(view: Canvas, scene: sim.Scene) -> None:
    for factor, sent in ((1.0009, False), (1.0011, True)):
        assert view.draw(replace(start(scene), rest_length_scale=factor)) is sent


def test_a_second_body_that_comes_or_goes_is_sent(view: Canvas, scene: sim.Scene) -> None:
    assert view.draw(replace(start(scene), ghost=None))
    assert view.draw(start(scene))
