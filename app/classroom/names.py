"""Names that a class assigns, so that nobody has to type one and none can be rude."""

from __future__ import annotations

import secrets
from collections import Counter
from collections.abc import Callable, Collection

COLORS = {
    "Red": "#d1495b",
    "Orange": "#d9822b",
    "Golden": "#b58900",
    "Green": "#3a8a4d",
    "Teal": "#128a8a",
    "Blue": "#2f6fb5",
    "Violet": "#7a56b3",
    "Pink": "#c2528b",
    "Brown": "#8a6248",
    "Grey": "#68737d",
}
"""Colours by the word in a name; each has a contrast of at least 3 with white."""

ANIMALS = (
    "Badger", "Bear", "Beaver", "Bison", "Camel", "Crane", "Deer", "Dolphin", "Eagle", "Falcon",
    "Finch", "Fox", "Gecko", "Hare", "Hedgehog", "Heron", "Horse", "Ibex", "Kiwi", "Koala",
    "Lark", "Lion", "Lynx", "Magpie", "Marten", "Mole", "Moose", "Newt", "Otter", "Owl",
    "Panda", "Penguin", "Puffin", "Raven", "Robin", "Salmon", "Seal", "Swan", "Tiger", "Turtle",
    "Walrus", "Wolf", "Wren", "Yak", "Zebra",
)  # fmt: skip

LETTERS = "ABCDEFGHJKMNPRSTUVWXYZ"
"""Letters of a class's code: none that could be mistaken for a digit or for another letter."""

_RUDE = frozenset(("ANUS", "ARSE", "BUTT", "CRAP", "CUNT", "DAMN", "FAGS", "FART", "FUCK", "NAZI", "PUSS"))
_RUDE_STEMS = ("ASS", "CUM", "FAG", "FUK", "KKK", "SEX", "TWA", "WTF")

Choose = Callable[[int], int]
"""Picks a number below another one."""


def new_name(taken: Collection[str], choose: Choose = secrets.randbelow) -> str:
    """Return a name such as "Blue Heron" that nobody has.

    Its animal is one that nobody has, as long as there is one, and its colour one of those that fewest have.

    Args:
        taken: names that are in use; fewer than there are names.
    """
    used = Counter(name.split()[0] for name in taken)
    animals = set(ANIMALS) - {name.split()[1] for name in taken} or set(ANIMALS)
    free = [(color, animal) for color in COLORS for animal in ANIMALS if f"{color} {animal}" not in taken]
    fitting = [name for name in free if name[1] in animals]
    least = min(used[color] for color, _ in fitting)
    best = [f"{color} {animal}" for color, animal in fitting if used[color] == least]
    return best[choose(len(best))]


def color_of(name: str) -> str:
    """Return the colour in a name, as in "#2f6fb5"."""
    return COLORS[name.split()[0]]


def new_code(taken: Collection[str], choose: Choose = secrets.randbelow) -> str:
    """Return four letters that no class has yet, and that are no word that does not belong on a wall."""
    while True:
        code = "".join(LETTERS[choose(len(LETTERS))] for _ in range(4))
        if code not in taken and code not in _RUDE and not any(stem in code for stem in _RUDE_STEMS):
            return code
