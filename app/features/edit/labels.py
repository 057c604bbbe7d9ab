"""What the steps of undo are called in the language that is spoken now.

`sim.edit` names an edit in English, as in "2 springs removed". The words of such a label make the key of its
message, `done-springs-removed`, and its number stands in the message's place. Labels of changed settings are
theirs; a label without a message is shown as it is.
"""

from __future__ import annotations

import re
from typing import cast

from sim import Scene
from sim.edit.values import NUMBERS, WAYS
from sim.settings import CHOICES, settings_of

from ...words import find, say
from ...words import settings as settings_words
from ...words.keys import Key
from .selection_panel import label_of, label_of_way, options_of

_SEVERAL = {"mass": "masses", "spring": "springs", "joint": "joints", "muscle": "muscles"}
_COUNTED = re.compile(rf"(\d+) ({'|'.join(_SEVERAL)})\b")
_CHANGED = re.compile(r"(.+) (set|scaled): (\d+) (\w+)")
_MOVED_STEP = re.compile(r"“(.*)” moved to step (\d+)")
_ACTS = re.compile(r"\d+ (\w+) (.+)")
_KINDS = {"masses": "masses", "springs": "linear_springs", "joints": "angular_springs"}


def done(label: str, scene: Scene) -> str:
    """Return what a step of undo is called.

    Args:
        label: of the step, in English.
        scene: whose settings it may be about.
    """
    several = _COUNTED.sub(lambda found: f"{found[1]} {_SEVERAL[found[2]]}", label)
    key = "-".join(("done", *re.findall("[a-z]+", several.lower())))
    if find(key):
        number = re.search(r"\d+", label)
        values: dict[str, str | float] = {"count": int(number[0])} if number else {}
        return say(cast(Key, key), **values)
    if match := _CHANGED.fullmatch(several):
        name, how, count, parts = match.groups()
        of = next((of for of in NUMBERS if of.label == name), None)
        if of is not None:
            said: Key = "done-number-set" if how == "set" else "done-number-scaled"
            return say(said, number=label_of(of), parts=say(cast(Key, f"edit-{parts}"), count=int(count)))
    if match := _MOVED_STEP.fullmatch(label):
        return say("done-step-moved", title=match[1], count=int(match[2]))
    if match := _ACTS.fullmatch(several):
        kind, acts = match.groups()
        for way_key, way in WAYS.items():
            for name, words in way.words.items():
                if way.kind == _KINDS.get(kind) and acts.endswith(f" {words}"):
                    return say("done-way", way=label_of_way(way_key), choice=options_of(way_key)[name])
    for setting in settings_of(scene):
        if setting.label == label:
            return settings_words.label_of(setting)
    for choice_key, choice in CHOICES.items():
        if choice.label == label:
            return settings_words.label_of_choice(choice_key)
    return label
