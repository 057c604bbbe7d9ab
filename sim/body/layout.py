"""Where the arrays of tables lie in memory."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import Any, Generic, NamedTuple, TypeVar

import numpy as np

from ..kernels.engine.table import Floats, Record, Table, address_of

_PAGE = 4096
"""Bytes; loads wait for stores whose addresses differ by a multiple of that."""
_ITEM = 8
"""Bytes of a float."""


def slab(sizes: Sequence[tuple[int, int]], page_offset: int) -> list[Floats]:
    """Zeroed arrays, one after another in one block of memory.

    Each is given as (count, first): its length, and the index of the element to align to 64 bytes because
    loops start there.

    The speed of a short chain depends on how its arrays are aligned: a vector that crosses a cache line is
    slower to load, and a load waits for a store whose address differs by a multiple of 4096 bytes. Left to
    chance, run times differ by a fifth. The block starts `page_offset` bytes after such a multiple.
    """
    room, spans = _spans(tuple(sizes))
    block, start = _block(room, page_offset)
    return [block[start + begin : start + end] for begin, end in spans]


def _block(room: int, page_offset: int) -> tuple[Floats, int]:
    """Zeros, and the index from which on there is room for so many; see `slab`."""
    block = np.zeros(room + _PAGE // _ITEM)
    return block, (page_offset - address_of(block)) % _PAGE // _ITEM


@lru_cache(maxsize=64)
def _spans(sizes: tuple[tuple[int, int], ...]) -> tuple[int, list[tuple[int, int]]]:
    """The numbers that a slab has, and the first and the last of each array in it."""
    spans, start = [], 0
    for count, first in sizes:
        begin = start + (-first) % 8
        spans.append((begin, begin + count))
        start += -(-(first % 8 + count + 8) // 8) * 8
    return start, spans


_Made = TypeVar("_Made", bound=Table)


class _Part(NamedTuple):
    """A table of a `Layout`.

    Attributes:
        kind: its class.
        begin, end: its words in those of all.
        same: what is the same in all copies, by name.
        tables: the number of each table in it, by name.
        arrays: of each array in the block, its first number and the one behind its last, and the length of
            its rows, or 0; by name.
    """

    kind: type[Table] | type[Record]
    begin: int
    end: int
    same: dict[str, Any]
    tables: dict[str, int]
    arrays: dict[str, tuple[int, int, int]]


class Layout(Generic[_Made]):
    """Makes tables like one that there is, with arrays of their own, all zero, in a fifth of the time.

    The arrays of such a table, and of the tables in it, lie in one block of memory, and the words that
    kernels read of all of them in another one. So a table is made of a copy of these words with other
    addresses.

    Args:
        first: the table; all others have its numbers, and those of its arrays that are not in the block.
        arrays: what `slab` made, in which the arrays of the table are.
        page_offset: as of `slab`.
    """

    def __init__(self, first: _Made, arrays: Sequence[Floats], page_offset: int) -> None:
        block = arrays[0].base
        assert block is not None, "it is a part of the slab"
        self._room, self._page_offset = block.size - _PAGE // _ITEM, page_offset
        self._begins = address_of(block) + (page_offset - address_of(block)) % _PAGE
        self._parts: list[_Part] = []
        self._known: dict[int, int] = {}  # the number of each part, by its address
        words: list[int] = []
        self._add(first, words)
        self._words = np.array(words, np.int64)
        self._own = address_of(self._words)
        # One where a word is an address in the block, or of another part.
        self._of_arrays, self._of_tables = np.zeros((2, len(words)), np.int64)
        for part in self._parts:
            fields = part.kind.fields
            self._of_arrays[[part.begin + fields[name].start for name in part.arrays]] = 1
            at = [part.begin + fields[name].start for name in part.tables]
            self._of_tables[at] = 1
            self._words[at] = [self._own + _ITEM * self._parts[i].begin for i in part.tables.values()]

    def _add(self, table: Any, words: list[int]) -> int:
        """Add a table and those in it; its number."""
        if table.address() in self._known:
            return self._known[table.address()]
        same: dict[str, Any] = {}
        tables: dict[str, int] = {}
        arrays: dict[str, tuple[int, int, int]] = {}
        for name, field in table.fields.items():
            value = getattr(table, name)
            if isinstance(value, np.ndarray):
                begin = (address_of(value) - self._begins) // _ITEM
                if value.size and 0 <= begin < self._room:
                    arrays[name] = begin, begin + value.size, value.shape[1] if field.dimensions == 2 else 0
                else:
                    same[name] = value
            elif isinstance(value, (Table, Record)):
                tables[name] = self._add(value, words)
            elif isinstance(table, Table):
                same[name] = value  # those of a record are in its words alone
        begin = len(words)
        words += table.words()
        self._parts.append(_Part(type(table), begin, len(words), same, tables, arrays))
        self._known[table.address()] = len(self._parts) - 1
        return len(self._parts) - 1

    def made(self) -> _Made:
        """A table with new arrays."""
        block, start = _block(self._room, self._page_offset)
        room = block[start : start + self._room]
        words = self._words + self._of_arrays * (address_of(block) + _ITEM * start - self._begins)
        address = address_of(words)
        if len(self._parts) > 1:
            words += self._of_tables * (address - self._own)
        made: list[Any] = []
        wholes = words.data
        floats = wholes.cast("B").cast("d")
        for kind, begin, end, same, tables, arrays in self._parts:
            values = same.copy()
            for name, number in tables.items():
                values[name] = made[number]
            here = wholes[begin:end], floats[begin:end], address + _ITEM * begin
            made.append(kind.placed(*here, values, room, arrays))
        return made[-1]
