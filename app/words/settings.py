"""What the settings and choices of `sim.settings` are called in the language that is spoken now.

Their texts are the messages of `settings.ftl`, found by their names there. What has none, as a setting that a
page makes for a control of its own, is called what it says itself.
"""

from __future__ import annotations

import re

from sim.scene.types import Scene
from sim.settings import CHOICES, Setting

from . import find, say

_OF_BODY = re.compile(r"bodies\[(\d+)\]\.(.+)")


def label_of(setting: Setting) -> str:
    """The name of a setting for people."""
    of_body, own = _OF_BODY.fullmatch(setting.key), _text(setting)
    if not of_body or not own:
        return own or setting.label
    recipe = find(f"recipe-{_dashed(setting.recipe)}", setting.recipe)
    return say("setting-of-body", recipe=recipe, number=int(of_body[1]) + 1, setting=own)


def term_of(setting: Setting) -> str:
    """The technical term for it, where its name is a plainer one; "" elsewhere."""
    return _text(setting, ".hint") or setting.term


def remark_of(setting: Setting, scene: Scene) -> str:
    """What users should know when they set it in a scene; "" if nothing."""
    remark = setting.remark(scene)
    return remark and (_text(setting, ".remark") or remark)


def label_of_choice(key: str) -> str:
    """The name of a choice for people."""
    return find(f"choice-{_dashed(key)}", CHOICES[key].label)


def options_of(key: str) -> dict[str, str]:
    """The names to choose from, each with its label for people."""
    options = CHOICES[key].options
    return {name: find(f"choice-{_dashed(key)}-{_dashed(name)}", label) for name, label in options.items()}


def _text(setting: Setting, attribute: str = "") -> str:
    """Return what the message of a setting says; a recipe may have one of its own for a field."""
    of_body = _OF_BODY.fullmatch(setting.key)
    field = _dashed(of_body[2] if of_body else setting.key)
    own = find(f"setting-{_dashed(setting.recipe)}-{field}{attribute}") if setting.recipe else ""
    return own or find(f"setting-{field}{attribute}")


def _dashed(name: str) -> str:
    """A name as keys have it: "HairTuft" is "hair-tuft"."""
    return re.sub("(?<=[a-z])(?=[A-Z])|_", "-", name).lower()
