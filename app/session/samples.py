"""Samples of a plot: a row for each frame of the last minute, and the extremes of what was before.

Older rows are thinned in levels: from one to the next, half as many stand for a stretch of time. So a bounded
number covers hours.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from .history import SPAN

Floats = NDArray[np.float64]

LEVELS = 12
"""Levels of thinned rows, at most: with these, an hour at a tenth of the usual speed is covered."""

LEVEL_ROWS = 300
"""Rows of a level."""

_SPARE = SPAN // 6
"""Room for rows beyond those that are kept, so that rows seldom have to be moved."""


class _Rows:
    """Rows in order of time, of which the first and the last can be taken away."""

    def __init__(self, room: int, width: int) -> None:
        self._room = np.empty((room, width))
        self._first = self._end = 0

    def __len__(self) -> int:
        return self._end - self._first

    @property
    def rows(self) -> Floats:
        """(k, width) all rows. A view."""
        return self._room[self._first : self._end]

    def append(self, rows: Floats) -> None:
        """Add rows."""
        if self._end + len(rows) > len(self._room):
            kept = self.rows.copy()
            self._first, self._end = 0, len(kept)
            self._room[: self._end] = kept
        self._room[self._end : self._end + len(rows)] = rows
        self._end += len(rows)

    def take_first(self, count: int) -> Floats:
        """Remove the first rows and return them. A view, until something is appended."""
        self._first += count
        return self._room[self._first - count : self._first]

    def drop_last(self) -> None:
        """Remove the last row."""
        self._end -= 1


class Samples:
    """Rows of a time and values, the times ascending.

    At least the last `SPAN` rows are complete. Of what is older, buckets of equally many rows are replaced by
    half as many: those with the lowest and the highest value of each column, and others between them. What
    leaves a level of `LEVEL_ROWS` rows is thinned again into the next one, and what leaves the last level is
    forgotten.

    Args:
        columns: of values.
    """

    def __init__(self, columns: int) -> None:
        self._width = 1 + columns
        self._bucket = 4 * columns
        self._levels = [_Rows(SPAN + _SPARE, self._width)]

    def __len__(self) -> int:
        return sum(map(len, self._levels))

    @property
    def rows(self) -> Floats:
        """(k, 1 + columns) times, s, and values; a view as long as nothing is thinned."""
        levels = [level.rows for level in reversed(self._levels)]
        return levels[0] if len(levels) == 1 else np.concatenate(levels)

    @property
    def last(self) -> Floats | None:
        """(1 + columns,) the newest row, a view; None if there is none."""
        level = self._newest
        return level.rows[-1] if level is not None else None

    @property
    def is_thinned(self) -> bool:
        """Whether some rows stand for several frames."""
        return len(self._levels) > 1

    @property
    def complete_since(self) -> float:
        """Time, s, of the oldest row before which rows are thinned; 0 if there is none."""
        rows = self._levels[0].rows
        return float(rows[0, 0]) if len(rows) else 0.0

    @property
    def frames(self) -> NDArray[np.int64]:
        """(k,) for how many frames each of `rows` stands: 1 where rows are complete."""
        counts = [(2**k, len(level)) for k, level in enumerate(self._levels)]
        return np.repeat(*np.array(counts[::-1], dtype=np.int64).T)

    def append(self, row: Sequence[float]) -> None:
        """Add a row, of a later time than all before."""
        self._levels[0].append(np.array([row]))
        for k in range(LEVELS + 1):
            level = self._levels[k]
            if len(level) < (LEVEL_ROWS if k else SPAN) + self._bucket:
                return
            bucket = level.take_first(self._bucket)
            if k == LEVELS:
                return
            if k + 1 == len(self._levels):
                self._levels.append(_Rows(LEVEL_ROWS + 2 * self._bucket, self._width))
            self._levels[k + 1].append(bucket[_outstanding(bucket[:, 1:])])

    def drop_after(self, time: float) -> None:
        """Remove the rows later than a time, s."""
        while (level := self._newest) is not None and level.rows[-1, 0] > time:
            level.drop_last()

    def clear(self) -> None:
        """Remove all rows."""
        del self._levels[1:]
        self._levels[0].take_first(len(self._levels[0]))

    def with_columns(self, columns: Sequence[int | None]) -> Samples:
        """Return the same rows with other columns: each is one of these, or None for one without values."""
        copy = Samples(len(columns))
        copy._levels = [_Rows(len(level._room), 1 + len(columns)) for level in self._levels]
        for old, new in zip(self._levels, copy._levels, strict=True):
            rows = np.full((len(old), 1 + len(columns)), np.nan)
            rows[:, 0] = old.rows[:, 0]
            for i, column in enumerate(columns, start=1):
                if column is not None:
                    rows[:, i] = old.rows[:, 1 + column]
            new.append(rows)
        return copy

    @property
    def _newest(self) -> _Rows | None:
        """The level of the newest row."""
        return next((level for level in self._levels if len(level)), None)


def _outstanding(values: Floats) -> NDArray[np.int64]:
    """The indices of half of some rows: those of each column's lowest and highest values, and some others."""
    count = len(values)
    some = ~np.isnan(values)
    lowest = np.where(some, values, np.inf).argmin(0)
    highest = np.where(some, values, -np.inf).argmax(0)
    kept = dict.fromkeys((*lowest.tolist(), *highest.tolist(), *range(0, count, 2), *range(1, count, 2)))
    return np.array(sorted(list(kept)[: count // 2]))
