"""Tables that a layout makes: each has memory of its own, at the same places in a page."""

from __future__ import annotations

import numba
import numpy as np
import pytest

import sim
from sim.engine.layout import Layout, aligned_arena
from sim.engine.table import Floats, Record, Rows, Table, address_of
from tests.sim.inside import solver_of


class _Count(Record):
    rows: Rows
    steps: int
    time: float


class _Inner(Table):
    far: Floats
    shared: Floats
    count: _Count


class _Outer(Table):
    near: Floats
    inner: _Inner
    again: _Count
    factor: float


SHARED = np.array([7.0])


def new_layout() -> Layout[_Outer]:
    near, far, rows = aligned_arena([(5, 1), (3, 0), (8, 0)], page_offset=512)
    count = _Count(rows=rows.reshape(2, 4), steps=4)
    inner = _Inner(far=far, shared=SHARED, count=count)
    return Layout(_Outer(near=near, inner=inner, again=count, factor=2.5), (near, far, rows), page_offset=512)


def _go_on(outer):
    outer.inner.far[2] = outer.factor * outer.inner.shared[0]
    outer.near[4] += 1.0
    outer.again.steps += 1
    outer.inner.count.rows[1, 2] = outer.again.steps
    outer.inner.count.time = 0.5


def test_kernels_and_python_share_the_numbers_of_each_and_no_other_has_them() -> None:
    layout, go_on = new_layout(), numba.njit(_go_on)
    one, other = layout.made(), layout.made()
    go_on(one)
    go_on(one)
    assert (one.near.tolist(), one.inner.far.tolist()) == ([0.0, 0.0, 0.0, 0.0, 2.0], [0.0, 0.0, 17.5])
    assert (one.inner.count.steps, one.again.steps, one.again.time, one.again.rows[1, 2]) == (6, 6, 0.5, 6.0)
    assert one.again.rows.shape == (2, 4)
    assert (other.factor, other.inner.count.steps, other.again.time) == (2.5, 4, 0.0)
    assert not any(array.any() for array in (other.near, other.inner.far, other.again.rows))
    assert one.inner.shared is other.inner.shared is SHARED
    changed = one.replaced(near=np.ones(5))
    go_on(changed)
    assert (changed.near[4], one.near[4], one.again.steps) == (2.0, 2.0, 7)


def test_arrays_lie_in_the_same_part_of_a_page() -> None:
    layout = new_layout()
    places = {
        tuple(address_of(a) % 4096 for a in (t.near, t.inner.far)) for t in (layout.made(), layout.made())
    }
    assert places == {(512 + 56, 512 + 128)}


def test_there_is_nothing_else_in_a_table() -> None:
    with pytest.raises(AttributeError, match="_Outer has no nothing"):
        getattr(new_layout().made(), "nothing")  # noqa: B009


@pytest.mark.parametrize("masses", (3, 12, 100, 1000))
def test_rows_of_a_method_lie_in_another_part_of_a_page_than_its_new_state(masses: int) -> None:
    """Where they begin, both are 8 bytes before a whole number of cache lines."""
    simulation = sim.Simulation(sim.rope(masses))
    integrator = solver_of(simulation).integrator
    assert address_of(integrator.new.q) % 4096 == 56
    assert address_of(integrator.a) % 4096 == 2560 + 56


# ------------------------------------------------------------------------- records
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
