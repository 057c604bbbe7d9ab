"""Arrays of numbers with named sections, written and read by the same table.

An array is a list of sections of single precision, each after its length; empty ones at the end are left out.
The page reads them with `unpack.js` and `layouts.js`, which is made from the messages' `sections`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike, NDArray


@dataclass(frozen=True)
class Section:
    """A section of an array.

    Attributes:
        name: its name in Python.
        doc: its content and unit.
        numbers: names and descriptions of single numbers; a name that ends in "?" is a flag, 1 or 0. Without
            them the section is a list of any length.
    """

    name: str
    doc: str = ""
    numbers: Mapping[str, str] = field(default_factory=dict)


def pack(layout: tuple[Section, ...], values: Mapping[str, ArrayLike]) -> NDArray[np.float32]:
    """Make an array with named sections.

    Args:
        layout: the table.
        values: of sections by their names; the others are empty.

    Raises:
        KeyError: a section of that name is not in the table.
    """
    if unknown := set(values) - {section.name for section in layout}:
        raise KeyError(*unknown)
    flat = [np.asarray(values.get(section.name, ()), np.float32).ravel() for section in layout]
    while flat and not flat[-1].size:
        flat.pop()
    return _after_lengths(flat)


def joined(*sections: ArrayLike) -> NDArray[np.float32]:
    """Join sections, each after its length."""
    return _after_lengths([np.asarray(section, np.float32).ravel() for section in sections])


def _after_lengths(flat: list[NDArray[np.float32]]) -> NDArray[np.float32]:
    return np.concatenate([part for section in flat for part in ([len(section)], section)], dtype=np.float32)
