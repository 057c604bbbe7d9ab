"""What the steps of undo are called, in English as the edits call them, and in German."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

import sim
from app.features.edit.labels import done
from app.features.making.maker import LABELS
from app.words import speaking
from sim.edit import build, shape
from sim.edit.edit import Edit, Selection
from sim.edit.muscles import toggle_muscles
from sim.edit.values import NUMBERS, WAYS, number, set_number, set_way
from sim.settings import CHOICES, settings_of


@pytest.fixture(scope="module")
def worm() -> sim.Scene:
    return sim.load_scene("worm")


def in_german(label: str, scene: sim.Scene) -> str:
    with speaking("de"):
        return done(label, scene)


def edits(scene: sim.Scene) -> list[Edit]:
    """One edit of each kind that counts parts."""
    starts = [mass.position for mass in scene.masses]
    some = Selection(springs=frozenset({0, 1}))
    return [
        build.remove(scene, Selection(masses=frozenset({0}))),
        build.remove(scene, some),
        build.pin(scene, frozenset({0, 1}), on=True),
        build.pin(scene, frozenset({0}), on=False),
        build.add_mass(scene, (0.0, -500.0)),
        build.extend(scene, 0, (-300.0, -500.0), starts, 1.0),
        shape.move(scene, frozenset({0, 1}), (1.0, 2.0)),
        shape.mirror(scene, frozenset(range(len(starts))), starts),
        toggle_muscles(scene, some),
        set_number(scene, number("linear_springs", "stiffness"), [0, 1], 500.0),
    ]


def test_edits_are_called_as_they_call_themselves_and_in_german_otherwise(worm: sim.Scene) -> None:
    for edit in edits(worm):
        assert done(edit.label, worm) == edit.label
        assert in_german(edit.label, worm) != edit.label


def test_german_labels(worm: sim.Scene) -> None:
    assert in_german("1 mass pinned", worm) == "1 Masse festgehalten"
    assert in_german("2 masses pinned", worm) == "2 Massen festgehalten"
    assert in_german("Joint stiffness scaled: 1 joint", worm) == "Steifigkeit des Gelenks skaliert: 1 Gelenk"
    assert in_german("“Go 5” moved to step 2", worm) == "„Go 5“ wird Schritt 2"
    assert in_german("Gravity", worm) == "Fallbeschleunigung"
    assert in_german("what nobody knows", worm) == "what nobody knows"


def test_all_changes_of_steps_and_settings_have_german_labels(worm: sim.Scene) -> None:
    for label in LABELS.values():
        assert in_german(f"{label} of step 3", worm).endswith(" von Schritt 3")
    for setting in settings_of(worm):
        assert done(setting.label, worm) == setting.label
    for choice in CHOICES.values():
        assert done(choice.label, worm) == choice.label
    for of in NUMBERS:
        assert in_german(f"{of.label} set: 1 mass", worm).endswith("gesetzt: 1 Masse")


def test_ways_are_called_by_their_choices(worm: sim.Scene) -> None:
    edit = set_way(worm, WAYS["springs"], [0, 1], "pull")
    assert done(edit.label, worm) == "Springs act: pulls only"
    assert in_german(edit.label, worm) == "Federn wirken: nur ziehend"


def test_each_message_of_a_step_of_undo_is_one_that_a_label_finds(worm: sim.Scene) -> None:
    words = Path(done.__code__.co_filename).parents[2] / "words" / "en" / "edit.ftl"
    keys = re.findall(r"^done-[a-z-]+", words.read_text(encoding="utf-8"), re.M)
    by_name = {"done-number-set", "done-number-scaled", "done-way", "done-step-moved"}
    for key in set(keys) - by_name:
        label = key.removeprefix("done-").replace("-", " ")
        assert in_german(label, worm) != label, key
