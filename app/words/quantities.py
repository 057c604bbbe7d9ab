"""What the quantities of `sim.motion.quantities` are called in the language that is spoken now.

Their texts are the messages of `quantities.ftl`, found by their names there; what has none is called by its
name. Formulas, tables and the names of plots have the English names in any language.
"""

from __future__ import annotations

import re

from . import find, say
from .keys import Key

_COUNTED: dict[str, Key] = {
    "joint": "quantity-joint.counted",
    "spring": "quantity-spring.counted",
    "mass": "quantity-mass.counted",
}
_PART = re.compile(r"([a-z]+)(\d+)")


def quantity_of(of: str, what: str) -> str:
    """What a kind of quantity is called, as "angle" of a joint."""
    return find(f"quantity-{of}-{what.replace('_', '-')}", what)


def kind_of_part(of: str) -> str:
    """What a kind of part is called, as "joint"."""
    return find(f"quantity-{of}", of)


def part_called(part: str) -> str:
    """What a part is called, as "joint3"."""
    match = _PART.fullmatch(part)
    if match is None or match[1] not in _COUNTED:
        return kind_of_part(part)
    return say(_COUNTED[match[1]], number=match[2])
