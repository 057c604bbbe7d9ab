"""One number of each of many parts, as an array.

Making an array from ten thousand parts takes a good part of a millisecond per number, and the tables, the
drawing and the sliders of a body need the same arrays. An edit of one spring leaves masses, joints and all
other springs unchanged. The most recent arrays are therefore cached, and those of other parts are derived
from them as far as the parts are the same.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import chain
from operator import attrgetter
from typing import Any

import numpy as np
from numpy.typing import NDArray

# Unless noted, doubling or halving one of these numbers fails no test.
MOST = 12
"""Number of tuples of parts whose arrays are cached: several versions of a body, or several bodies."""

LONG = 100
"""Number of parts from which cached arrays are reused; for fewer, rebuilding is as fast."""

Parts = tuple[Any, ...]
_Arrays = dict[tuple[str, type], NDArray[Any]]

_kept: dict[int, tuple[Parts, _Arrays]] = {}
"""Each of these tuples by its id, which is unique as long as it is cached; the latest comes last."""


def column(parts: Parts, field: str) -> NDArray[np.float64]:
    """Return the (k,) numbers in a field of each part, read-only; NaN where a part has none."""
    return _column(parts, field, float)


def columns(parts: Parts, *fields: str) -> NDArray[np.float64]:
    """Return the (fields, k) numbers in two or more fields of each part; no part may lack one."""
    if len(parts) >= LONG:
        return np.array([column(parts, field) for field in fields])
    return _at_once(parts, map(attrgetter(*fields), parts), len(fields), float).T


def vectors(parts: Parts, field: str) -> NDArray[np.float64]:
    """Return the (k, 2) vectors in a field of each part, read-only."""
    if len(parts) >= LONG:
        return _column(parts, field, float).reshape(-1, 2)
    return _at_once(parts, map(attrgetter(field), parts), 2, float)


def ends(parts: Parts) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Return the (k,) `a` and `b` of springs or joints, read-only."""
    if len(parts) >= LONG:
        return _column(parts, "a", np.int64), _column(parts, "b", np.int64)
    a, b = _at_once(parts, map(_ENDS, parts), 2, np.int64).T
    return a, b


_ENDS = attrgetter("a", "b")


def _at_once(parts: Parts, rows: Iterable[Any], width: int, dtype: type) -> NDArray[Any]:
    """Return a (k, width) array of short rows, in half of the time of an array for each column."""
    array = np.fromiter(chain.from_iterable(rows), dtype, width * len(parts))
    return _read_only(array).reshape(-1, width)


def has_any(parts: Parts, field: str) -> bool:
    """Return whether any part has a number in an optional field."""
    if len(parts) < LONG:  # faster than making an array that nothing else needs
        return not {None}.issuperset(map(attrgetter(field), parts))
    return not np.isnan(column(parts, field)).all()


def is_set_in_any(parts: Parts, field: str) -> bool:
    """Return whether any part has an optional field that is unset in the others."""
    if len(parts) < LONG:
        return any(map(attrgetter(field), parts))
    return bool(_column(parts, field, object).any())


def _column(parts: Parts, field: str, dtype: type) -> NDArray[Any]:
    parts = tuple(parts)  # unchanged, unless it is a list, which may be modified
    found = _kept.pop(id(parts), None)  # concurrent threads make an array twice at worst
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
    """Return the arrays of parts that are mostly the same as in an earlier call, reading only the others."""
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
    """Return the number of identical parts at the beginning."""
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
