"""A scene's name and description: one name for one thing, and no text of a preset on another body."""

from __future__ import annotations

import pytest
from msgspec.structs import replace

import sim
from sim.edit.build import add_mass, pin
from sim.edit.edit import inverse
from sim.edit.texts import UNNAMED, as_own, renamed, set_texts
from sim.errors import SceneError
from sim.scene.types import shown_name
from sim.scene.validate import validate
from sim.store.files import is_built_in, safe_name
from tests.sim.checks import refusal


def test_a_scene_gets_one_name_and_a_text_and_nothing_else_changes() -> None:
    rope = sim.load_scene("rope")
    edit = set_texts(rope, "  Newton's\ncradle & more ", "\n One line. \n\nAnother <b>one</b>.\n")
    scene = validate(edit.scene)
    assert (scene.name, scene.title) == ("Newton's cradle & more", "")
    assert scene.description == "One line.\n\nAnother <b>one</b>."
    texts = {"name": rope.name, "title": rope.title, "description": rope.description}
    assert replace(scene, **texts) == rope
    assert not edit.moves_parts
    assert inverse(edit, rope).scene is rope
    # The name that is shown is that of its file.
    assert safe_name(scene.name) == shown_name(scene)
    # What is shown already is left as it is, a preset's title, too.
    assert set_texts(rope, "Rope", rope.description).scene is rope
    described = set_texts(rope, "Rope", "Mine.").scene
    assert (described.name, described.title, described.description) == ("rope", "Rope", "Mine.")


@pytest.mark.parametrize(
    ("name", "description", "why"),
    [
        ("", "", "name: it must not be empty"),
        (" \n ", "", "name: it must not be empty"),
        ("a" * 61, "", "name: 61 characters are more than 60"),
        ("mine", "b" * 2001, "description: 2001 characters are more than 2000"),
        ("Ring", "", "'Ring' is a built-in preset"),
        ("???", "", "cannot be the name of a scene"),
        ("mine", "\ud800", "description: it has characters that cannot be written"),
    ],
)
def test_a_text_that_a_file_cannot_have_is_refused_in_one_sentence(
    name: str, description: str, why: str
) -> None:
    assert why in refusal(SceneError, set_texts, sim.load_scene("rope"), name, description)


def test_texts_of_the_greatest_length_are_taken() -> None:
    scene = set_texts(sim.load_scene("rope"), "n" * 60, "d" * 2000).scene
    assert (len(scene.name), len(scene.description)) == (60, 2000)


def test_a_preset_whose_parts_come_or_go_is_a_scene_of_its_own() -> None:
    empty = sim.load_scene("empty")
    edit = as_own(add_mass(empty, (10.0, 20.0)), empty)
    assert (edit.scene.name, edit.scene.title, edit.scene.description) == (UNNAMED, "", "")
    assert not is_built_in(UNNAMED)
    assert inverse(edit, empty).scene is empty
    # What keeps its parts keeps its texts.
    held = pin(empty, [0], on=False)
    assert as_own(held, empty) is held
    # So do a user's own scenes, whatever is done to them, and lessons.
    mine = set_texts(empty, "mine", "A text.").scene
    more = add_mass(mine, (10.0, 20.0))
    assert as_own(more, mine) is more
    lesson = sim.load_scene("lesson-hooke")
    taught = add_mass(lesson, (10.0, 20.0))
    assert as_own(taught, lesson) is taught


def test_the_name_under_which_a_scene_is_saved_is_its_only_one() -> None:
    empty = sim.load_scene("empty")
    # Even one that was its title before.
    scene = renamed(empty, empty.title).scene
    assert (scene.name, scene.title, scene.description) == (empty.title, "", empty.description)
    assert renamed(scene, scene.name).scene is scene
