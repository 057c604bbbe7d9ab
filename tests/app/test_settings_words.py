"""Settings and choices are said in the page's language; in English, as `sim` calls them."""

from __future__ import annotations

from dataclasses import replace
from typing import get_args

import pytest

import sim
from app.words import languages, speaking
from app.words.settings import label_of, label_of_choice, options_of, remark_of, term_of
from sim.scene.recipes.recipe import AnyRecipe
from sim.settings import CHOICES, SETTINGS, Setting, set_choice
from sim.settings.recipes import settings_of_recipe
from tests.app.whole import WholePage

ALL: list[Setting] = [
    *SETTINGS.values(),
    *(each for kind in get_args(AnyRecipe) for alone in (True, False)
      for each in settings_of_recipe(kind, 1, alone)),
]  # fmt: skip

MASSES = "bodies[1].masses"


def renamed(setting: Setting) -> Setting:
    return replace(setting, label="-", term=setting.term and "-")


def test_every_setting_has_a_message_that_is_in_english_its_label() -> None:
    for setting in ALL:
        assert label_of(renamed(setting)) == setting.label
        assert term_of(renamed(setting)) == setting.term
    scene = set_choice(sim.load_scene("pile"), "method", "rk4")
    remark = SETTINGS["bounciness"].remark(scene)
    assert remark and remark_of(replace(SETTINGS["bounciness"], remark=lambda _: "-"), scene) == remark
    assert remark_of(SETTINGS["gravity"], scene) == ""


def test_every_choice_has_messages_that_are_in_english_its_labels(monkeypatch: pytest.MonkeyPatch) -> None:
    for key, choice in CHOICES.items():
        with monkeypatch.context() as patch:
            patch.setitem(
                CHOICES, key, replace(choice, label="-", options=dict.fromkeys(choice.options, "-"))
            )
            assert (label_of_choice(key), options_of(key)) == (choice.label, choice.options)


@pytest.mark.parametrize("tag", languages())
def test_what_can_be_chosen_has_different_names(tag: str) -> None:
    with speaking(tag):
        for key in CHOICES:
            assert len(set(options_of(key).values())) == len(options_of(key))


def test_a_control_s_own_setting_is_called_what_it_says() -> None:
    own = replace(SETTINGS["gravity"], key="mode_frequency", label="Own name", term="own term")
    assert (label_of(own), term_of(own)) == ("Own name", "own term")


def test_a_page_has_its_sliders_and_lists_in_its_language() -> None:
    with speaking("de"):
        masses = next(one for one in settings_of_recipe(sim.FlagPole, 1, alone=False) if one.key == MASSES)
        assert label_of(masses) == "Fahnenmast 2: Massen der Stange"
        page = WholePage("rope")
        page.frames(2)
    labels = {one.label for one in page.gui.there}
    assert {"Fallbeschleunigung", "Luftreibung"} <= labels and "Gravity" not in labels
    (gravity,) = (one for one in page.gui.there if one.label == "Dehnsteifigkeit")
    assert gravity.hint.startswith("Steifigkeit der Federn; 0 bis ")
