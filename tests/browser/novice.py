"""Somebody who sees the page for the first time: what attracts them, by their few words for what they want.

They see words, names and tooltips, and nothing of how the page is made. What they decide depends on what is
visible alone, so that two runs on one page go the same way.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from typing import Any, NamedTuple

Thing = dict[str, Any]
"""Something that can be pressed, as `visible.js` describes it."""

_LEAST = 4
"""Letters from which a word is seen in a longer one, as "stiff" in "stiffness"."""

TYPED = ("text", "number", "spinbutton", "textarea", "textbox")
SEARCHED = ("search", "searchbox")
SLID = ("slider", "range")
_CHOSEN = (
    *TYPED,
    *SEARCHED,
    *SLID,
    "select",
    "combobox",
    "option",
    "checkbox",
    "switch",
    "radio",
    "a",
    "link",
)
"""What nobody presses only to see what is behind it."""


class Key(NamedTuple):
    """What a visitor recognizes a thing by."""

    kind: str
    seen: str
    name: str


def key_of(thing: Thing) -> Key:
    """What a visitor recognizes it by; a figure in it may change."""
    return Key(thing["kind"], re.sub(r"\d+", "#", thing["seen"]), re.sub(r"\d+", "#", thing["name"]))


def score(words: Sequence[str], thing: Thing, touched: bool = False) -> float:
    """How much a thing promises somebody who looks for these words: 1 if it says the first of them alone.

    Args:
        words: theirs, the most likely first.
        thing: what they look at.
        touched: with a finger, which sees no tooltips.
    """
    fields = {thing["tip"]: 0.0 if touched else 0.5}
    fields[thing["name"]] = 0.9 if thing["seen"] else 1.0
    fields[thing["seen"]] = 1.0
    points: dict[str, float] = {}
    for text, weight in fields.items():
        found = re.findall(r"[^\W\d_]+", text.casefold())
        for other in found:
            fits = max(_fit(word, other) / (1.0 + 0.5 * i) for i, word in enumerate(words))
            # One word among many says less than one that stands alone.
            points[other] = max(points.get(other, 0.0), weight * fits * (0.6 + 0.4 / len(found)))
    return sum(points.values()) * (1.0 if thing["inView"] else 0.9)


def _fit(word: str, other: str) -> float:
    if other == word:
        return 1.0
    return 0.8 if len(word) >= _LEAST and other.startswith(word) else 0.0


def promising(
    things: Iterable[Thing], words: Sequence[str], tried: set[Key], touched: bool = False
) -> list[tuple[float, Thing]]:
    """What promises anything and is not on already, the best first; of equals, the first of the page."""
    found = [
        (score(words, thing, touched), thing)
        for thing in things
        if not thing["disabled"] and key_of(thing) not in tried
    ]
    fitting = [(points, thing) for points, thing in found if points > 0.0 and thing["state"] != "true"]
    return sorted(fitting, key=lambda pair: -pair[0])


def revealing(things: Iterable[Thing], tried: set[Key]) -> list[Thing]:
    """What somebody presses who sees nothing that promises anything: tabs, then what says that there is more
    behind it, then icons, then the other buttons."""

    def rank(thing: Thing) -> int:
        if thing["kind"] == "tab":
            return 0
        if thing["opens"]:
            return 1
        return 3 if re.search(r"[^\W\d_]", thing["seen"]) else 2

    worth = [
        thing
        for thing in things
        if not thing["disabled"]
        and thing["kind"] not in _CHOSEN
        and (thing["seen"] or thing["name"] or thing["tip"])
        and thing["state"] != "true"
        and key_of(thing) not in tried
    ]
    return sorted(worth, key=rank)
