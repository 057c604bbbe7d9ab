"""One number of each of many parts, as an array.

To make an array of ten thousand parts takes a good part of a millisecond for each number, and the tables, the
drawing and the sliders of a body ask for the same ones. An edit of a spring leaves masses and joints as they
were, and all other springs. So the arrays of the parts that were asked for last are kept, and those of other
parts are made of them as far as the parts are the same.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import chain
from operator import attrgetter
from typing import Any

import numpy as np
from numpy.typing import NDArray

MOST = 12
"""Tuples of parts whose arrays are kept: those of some versions of a body, or of some bodies."""

LONG = 100
"""Number of parts from which on arrays of other parts are looked through for what is the same: with fewer, it
is as soon made anew."""

Parts = tuple[Any, ...]
_Arrays = dict[tuple[str, type], NDArray[Any]]

_kept: dict[int, tuple[Parts, _Arrays]] = {}
"""Each of these tuples by its id, which no other can get as long as it is kept; the latest comes last."""


def column(parts: Parts, field: str) -> NDArray[np.float64]:
    """(k,) the number that each part has in a field, read-only; NaN where it has none."""
    return _column(parts, field, float)


def columns(parts: Parts, *fields: str) -> NDArray[np.float64]:
    """(fields, k) the numbers that each part has in two or more fields; it is without one in none of them."""
    if len(parts) >= LONG:
        return np.array([column(parts, field) for field in fields])
    return _at_once(parts, map(attrgetter(*fields), parts), len(fields), float).T


def vectors(parts: Parts, field: str) -> NDArray[np.float64]:
    """(k, 2) the vector that each part has in a field, read-only."""
    if len(parts) >= LONG:
        return _column(parts, field, float).reshape(-1, 2)
    return _at_once(parts, map(attrgetter(field), parts), 2, float)


def ends(parts: Parts) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """(k,) the `a` and the `b` of springs or of joints, read-only."""
    if len(parts) >= LONG:
        return _column(parts, "a", np.int64), _column(parts, "b", np.int64)
    a, b = _at_once(parts, map(_ENDS, parts), 2, np.int64).T
    return a, b


_ENDS = attrgetter("a", "b")


def _at_once(parts: Parts, rows: Iterable[Any], width: int, dtype: type) -> NDArray[Any]:
    """(k, width) an array of what short rows have, in half of the time of an array for each column."""
    array = np.fromiter(chain.from_iterable(rows), dtype, width * len(parts))
    return _read_only(array).reshape(-1, width)


def has_any(parts: Parts, field: str) -> bool:
    """Whether any part has a number in a field that may be without one."""
    if len(parts) < LONG:  # sooner than to make an array that nothing else asks for
        return not {None}.issuperset(map(attrgetter(field), parts))
    return not np.isnan(column(parts, field)).all()


def _column(parts: Parts, field: str, dtype: type) -> NDArray[Any]:
    parts = tuple(parts)  # itself, unless it is a list, which may change
    found = _kept.pop(id(parts), None)  # threads that do the same make an array twice at worst
    if found is None:
        found = parts, _inherited(parts) if len(parts) >= LONG else {}
        if len(_kept) >= MOST:
            for oldest in list(_kept)[: len(_kept) - MOST + 1]:
                _kept.pop(oldest, None)
    _kept[id(parts)] = found
    array = found[1].get((field, dtype))
    if array is None:
        array = found[1][field, dtype] = _read_only(_made(parts, field, dtype))
    return array


def _inherited(parts: Parts) -> _Arrays:
    """The arrays of parts most of which are the same as in an earlier call: only the others are read anew."""
    for other, arrays in reversed(list(_kept.values())):
        before = _same(parts, other)
        after = min(_same(reversed(parts), reversed(other)), min(len(parts), len(other)) - before)
        if 2 * (before + after) > len(parts):
            middle, rest = parts[before : len(parts) - after], len(other) - after
            return {
                (field, dtype): _read_only(
                    _spliced(array[:before], _made(middle, field, dtype), array[rest:])
                )
                for (field, dtype), array in list(arrays.items())
            }
    return {}


def _spliced(first: NDArray[Any], middle: NDArray[Any], last: NDArray[Any]) -> NDArray[Any]:
    return np.concatenate((first, middle, last) if len(middle) else (first, last))


def _same(some: Iterable[Any], others: Iterable[Any]) -> int:
    """How many parts are the same at the beginning."""
    count = -1
    for count, (one, other) in enumerate(zip(some, others, strict=False)):
        if one is not other:
            return count
    return count + 1


def _made(parts: Sequence[Any], field: str, dtype: type) -> NDArray[Any]:
    return np.array(list(map(attrgetter(field), parts)), dtype)


def _read_only(array: NDArray[Any]) -> NDArray[Any]:
    array.setflags(write=False)
    return array
