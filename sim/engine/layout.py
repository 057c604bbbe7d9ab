"""Memory layout of the arrays of tables."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import Any, Generic, TypeVar

import numpy as np

from .table import Floats, Memory, Part, Record, Table, address_of

_PAGE = 4096
"""Address distance in bytes; loads wait for stores whose addresses differ by a multiple of it. Halved,
`test_arrays_lie_in_the_same_part_of_a_page` fails."""
_ITEM = 8
"""Size of a float, bytes."""


def aligned_arena(sizes: Sequence[tuple[int, int]], page_offset: int) -> list[Floats]:
    """Return zeroed arrays, laid out consecutively in one block of memory.

    Each is given as (count, first): its length, and the index of the element to align to 64 bytes because
    loops start there.

    The speed of a short chain depends on the alignment of its arrays: a vector that crosses a cache line is
    slower to load, and a load waits for a store whose address differs by a multiple of 4096 bytes. With
    arbitrary alignment, run times vary by a fifth. The block starts `page_offset` bytes after such a
    multiple.
    """
    room, spans = _spans(tuple(sizes))
    block, start = _block(room, page_offset)
    return [block[start + begin : start + end] for begin, end in spans]


def _block(room: int, page_offset: int) -> tuple[Floats, int]:
    """Return zeros, and the index from which `room` of them are available; see `aligned_arena`."""
    block = np.zeros(room + _PAGE // _ITEM)
    return block, (page_offset - address_of(block)) % _PAGE // _ITEM


@lru_cache(maxsize=64)
def _spans(sizes: tuple[tuple[int, int], ...]) -> tuple[int, list[tuple[int, int]]]:
    """Return the number of floats in an arena, and the start and end of each array in it."""
    spans, start = [], 0
    for count, first in sizes:
        begin = start + (-first) % 8
        spans.append((begin, begin + count))
        start += -(-(first % 8 + count + 8) // 8) * 8
    return start, spans


_Made = TypeVar("_Made", bound=Table)


class Layout(Generic[_Made]):
    """Makes tables like an existing one, with zeroed arrays of their own, in a fifth of the time.

    The arrays of such a table and its nested tables are in one block of memory, and the words that kernels
    read of all of them in another. A new table is therefore a copy of these words with other addresses.

    Args:
        first: the table; all others have its numbers, and those of its arrays that are not in the block.
        arrays: the result of `aligned_arena` that contains the table's arrays.
        page_offset: see `aligned_arena`.
    """

    def __init__(self, first: _Made, arrays: Sequence[Floats], page_offset: int) -> None:
        block = arrays[0].base
        assert block is not None, "it is a part of the arena"
        self._room, self._page_offset = block.size - _PAGE // _ITEM, page_offset
        self._begins = address_of(block) + (page_offset - address_of(block)) % _PAGE
        self._parts: list[Part] = []
        words: list[int] = []
        self._add(first, words, {})
        self._words = np.array(words, np.int64)
        self._own = address_of(self._words)
        # 1 where a word is an address in the block, or of another table.
        self._of_arrays, self._of_tables = np.zeros((2, len(words)), np.int64)
        for part in self._parts:
            for name, field in part.fields.items():
                at = part.begin + part.kind.fields[name].start
                if isinstance(field, int):
                    self._of_tables[at] = 1
                    self._words[at] = self._own + _ITEM * self._parts[field].begin
                else:
                    self._of_arrays[at] = 1

    def _add(self, table: Any, words: list[int], known: dict[int, int]) -> int:
        """Add a table and those in it, and return its number; `known` maps addresses to table numbers."""
        if table.address() in known:
            return known[table.address()]
        same: dict[str, Any] = {}
        fields: dict[str, tuple[int, int, int] | int] = {}
        for name, field in table.fields.items():
            value = getattr(table, name)
            if isinstance(value, np.ndarray):
                begin = (address_of(value) - self._begins) // _ITEM
                if value.size and 0 <= begin < self._room:
                    fields[name] = begin, begin + value.size, value.shape[1] if field.dimensions == 2 else 0
                else:
                    same[name] = value
            elif isinstance(value, (Table, Record)):
                fields[name] = self._add(value, words, known)
            elif isinstance(table, Table):
                same[name] = value  # the numbers of a record are only in its words
        begin = len(words)
        words += table.words()
        self._parts.append(Part(type(table), begin, len(words), same, fields))
        known[table.address()] = len(self._parts) - 1
        return len(self._parts) - 1

    def made(self) -> _Made:
        """Return a table with new arrays."""
        block = np.zeros(self._room + _PAGE // _ITEM)
        address = address_of(block)
        way = (self._page_offset - address) % _PAGE
        room = block[way // _ITEM : way // _ITEM + self._room]
        words = self._words + self._of_arrays * (address + way - self._begins)
        if len(self._parts) > 1:
            words += self._of_tables * (address_of(words) - self._own)
        return Memory(room, words, self._parts).of(len(self._parts) - 1)
