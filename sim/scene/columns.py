"""One number of each of many parts, as an array.

To make an array of ten thousand parts takes a good part of a millisecond for each number, and the tables, the
drawing and the sliders of a body ask for the same ones. An edit of a spring leaves masses and joints as they
were. So the arrays of the parts that were asked for last are kept.
"""

from __future__ import annotations

from operator import attrgetter
from typing import Any

import numpy as np
from numpy.typing import NDArray

MOST = 12
"""Tuples of parts whose arrays are kept: those of some versions of a body, or of some bodies."""

_kept: dict[int, tuple[tuple[Any, ...], dict[tuple[str, type], NDArray[Any]]]] = {}
"""Each of these tuples by its id, which no other can get as long as it is kept; the latest comes last."""


def column(parts: tuple[Any, ...], field: str) -> NDArray[np.float64]:
    """(k,) the number that each part has in a field, read-only; NaN where it has none."""
    return _column(parts, field, float)


def ends(parts: tuple[Any, ...]) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """(k,) the `a` and the `b` of springs or of joints, read-only."""
    return _column(parts, "a", np.int64), _column(parts, "b", np.int64)


def has_any(parts: tuple[Any, ...], field: str) -> bool:
    """Whether any part has a number in a field that may be without one."""
    return not np.isnan(column(parts, field)).all()


def _column(parts: tuple[Any, ...], field: str, dtype: type) -> NDArray[Any]:
    parts = tuple(parts)  # itself, unless it is a list, which may change
    found = _kept.pop(id(parts), None)  # threads that do the same make an array twice at worst
    if found is None:
        found = parts, {}
        for oldest in list(_kept)[: max(0, len(_kept) - MOST + 1)]:
            _kept.pop(oldest, None)
    _kept[id(parts)] = found
    array = found[1].get((field, dtype))
    if array is None:
        array = found[1][field, dtype] = np.array(list(map(attrgetter(field), parts)), dtype)
        array.setflags(write=False)
    return array
