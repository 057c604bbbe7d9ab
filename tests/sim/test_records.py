"""Tables and records: numbers that kernels and Python read and write by name."""

from __future__ import annotations

import numba
import numpy as np
import pytest

from sim.kernels.engine.table import Floats, Record, Table


class _Clock(Record):
    parts: Floats
    time: float
    ticks: int
    wound: bool


class _Case(Table):
    clock: _Clock
    offset: float


def _advance(case, count):
    clock = case.clock
    for _ in range(count):
        clock.time += case.offset
        clock.ticks += 1
        clock.parts[0] = clock.time
    clock.wound = clock.ticks < 3


def test_a_kernel_and_python_share_the_numbers_of_a_record() -> None:
    case = _Case(clock=_Clock(parts=np.zeros(1), time=1.0), offset=0.5)
    advance = numba.njit(_advance)
    advance(case, 2)
    assert (case.clock.time, case.clock.ticks, case.clock.wound) == (2.0, 2, True)
    case.clock.ticks = 10
    advance(case, 1)
    assert (case.clock.time, case.clock.ticks, case.clock.wound) == (2.5, 11, False)
    assert case.clock.parts.tolist() == [2.5]


def test_records_are_cleared_and_taken_over_by_number() -> None:
    one, other = (_Clock(parts=np.ones(1), time=3.0, ticks=2, wound=True) for _ in range(2))
    one.clear()
    assert (one.time, one.ticks, one.wound, one.parts.tolist()) == (0.0, 0, False, [1.0])
    one.take_over(other)
    assert (one.time, one.ticks, one.wound) == (3.0, 2, True)


def test_only_numbers_of_records_can_be_set() -> None:
    clock = _Clock(parts=np.zeros(1))
    case = _Case(clock=clock, offset=0.5)
    for thing, name in ((case, "offset"), (clock, "parts")):
        with pytest.raises(AttributeError, match=r"read-only|no setter"):
            setattr(thing, name, 1.0)
    with pytest.raises(TypeError, match="tme"):
        _Clock(parts=np.zeros(1), tme=1.0)
