"""Arrays of numbers with names: the sections of a message, from one table for who writes and who reads them.

An array is a list of sections of single precision, each after its length; empty ones at the end are left out.
The page reads them with `unpack.js` by the same tables (`layouts.js`, made from the messages' `sections`).
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
        name: what it is called, as in Python.
        doc: what it holds, and its unit.
        numbers: names of single numbers that it consists of, and what they are; a name that ends in "?" is a
            flag, 1 or 0. Without them it is a list of any length.
    """

    name: str
    doc: str = ""
    numbers: Mapping[str, str] = field(default_factory=dict)


def pack(layout: tuple[Section, ...], values: Mapping[str, ArrayLike]) -> NDArray[np.float32]:
    """An array with these sections.

    Args:
        layout: the table.
        values: of sections by their names; those that are not named are empty.

    Raises:
        KeyError: a section of that name is not in the table.
    """
    if unknown := set(values) - {section.name for section in layout}:
        raise KeyError(*unknown)
    flat = [np.asarray(values.get(section.name, ()), np.float32).ravel() for section in layout]
    while flat and not flat[-1].size:
        flat.pop()
    return joined(*flat)


def joined(*sections: ArrayLike) -> NDArray[np.float32]:
    """Sections, each after its length."""
    flat = [np.asarray(section, np.float32).ravel() for section in sections]
    return np.concatenate([part for section in flat for part in ([len(section)], section)], dtype=np.float32)
