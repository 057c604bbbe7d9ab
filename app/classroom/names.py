"""Names that a class assigns, so that nobody has to type one and none can be rude."""

from __future__ import annotations

import secrets
from collections import Counter
from collections.abc import Callable, Collection
from functools import cache
from itertools import product
from typing import NamedTuple

from ..words import language, say, speaking

COLORS = (
    "#d1495b",
    "#d9822b",
    "#b58900",
    "#3a8a4d",
    "#128a8a",
    "#2f6fb5",
    "#7a56b3",
    "#c2528b",
    "#8a6248",
    "#68737d",
)
"""The colours of the words in `seat-colors`; each has a contrast of at least 3 with white."""

LETTERS = "ABCDEFGHJKMNPRSTUVWXYZ"
"""Letters of a class's code: none that could be mistaken for a digit or for another letter."""

_RUDE = frozenset(("ANUS", "ARSE", "BUTT", "CRAP", "CUNT", "DAMN", "FAGS", "FART", "FUCK", "NAZI", "PUSS"))
_RUDE_STEMS = ("ASS", "CUM", "FAG", "FUK", "KKK", "SEX", "TWA", "WTF")

_NO_MARKS = {ord(mark): None for mark in "\u2068\u2069"}
"""The marks of Fluent around what stands in a text's places: a name's words have one direction."""

Choose = Callable[[int], int]
"""Picks a number below another one."""


class Name(NamedTuple):
    """A name, and the colour in it, as in "#2f6fb5"."""

    text: str
    color: str


def new_name(taken: Collection[str], choose: Choose = secrets.randbelow) -> Name:
    """Return a name such as "Blue Heron" that nobody has, in the language that is spoken now.

    Its animal is one that nobody has, as long as there is one, and its colour one of those that fewest have.

    Args:
        taken: names that are in use, of any kind; fewer than there are names.
    """
    names = _names(language())
    found = {pair for pair, name in names.items() if name in taken}
    used_colors, used_animals = Counter(color for color, _ in found), {animal for _, animal in found}
    free = [pair for pair in names if pair not in found]
    fitting = [pair for pair in free if pair[1] not in used_animals] or free
    least = min(used_colors[color] for color, _ in fitting)
    best = [pair for pair in fitting if used_colors[pair[0]] == least]
    pair = best[choose(len(best))]
    return Name(names[pair], COLORS[pair[0]])


@cache
def _names(tag: str) -> dict[tuple[int, int], str]:
    """All names in a language, by the numbers of their colours and animals."""
    with speaking(tag):
        colors, animals = (enumerate(say(key).splitlines()) for key in ("seat-colors", "seat-animals"))
        return {
            (i, j): say("seat-name", color=color, animal=animal).translate(_NO_MARKS)
            for (i, color), (j, animal) in product(colors, animals)
        }


def new_code(taken: Collection[str], choose: Choose = secrets.randbelow) -> str:
    """Return four letters that no class has yet, and that are no word that does not belong on a wall."""
    while True:
        code = "".join(LETTERS[choose(len(LETTERS))] for _ in range(4))
        if code not in taken and code not in _RUDE and not any(stem in code for stem in _RUDE_STEMS):
            return code
