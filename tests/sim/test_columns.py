"""Numbers of many parts as arrays: those of the parts as they are, however many others were asked for."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import sim
from sim.scene import columns
from sim.scene.columns import column, ends, has_any, vectors


@pytest.fixture(autouse=True)
def long(monkeypatch: pytest.MonkeyPatch) -> None:
    """As if the few parts of these tests were many."""
    monkeypatch.setattr(columns, "LONG", 0)


def spring(a: int, b: int, stiffness: float, strength: float | None = None) -> sim.LinearSpring:
    return sim.LinearSpring(a=a, b=b, stiffness=stiffness, rest_length=1.0, strength=strength)


def springs_of(count: int, first: int = 0) -> tuple[sim.LinearSpring, ...]:
    return tuple(spring(i, i + 1, float(i)) for i in range(first, first + count))


def test_arrays_are_those_of_the_parts() -> None:
    some = (*springs_of(3), spring(7, 2, 9, 5.0))
    for _ in range(2):
        assert column(some, "stiffness").tolist() == [0.0, 1.0, 2.0, 9.0]
        assert [end.tolist() for end in ends(some)] == [[0, 1, 2, 7], [1, 2, 3, 2]]
        assert np.isnan(column(some, "strength")).tolist() == [True, True, True, False]
    assert (has_any(some, "strength"), has_any(some, "yield_force")) == (True, False)
    assert (column((), "stiffness").size, has_any((), "strength")) == (0, False)
    assert [end.dtype for end in ends(())] == [np.int64, np.int64]


def test_nobody_can_write_to_them() -> None:
    array = column(springs_of(3), "stiffness")
    with pytest.raises(ValueError, match="read-only"):
        array[0] = 5.0


def test_a_tuple_that_is_gone_may_leave_its_id_to_the_next() -> None:
    for i in range(3 * columns.MOST):
        assert column(springs_of(4, first=i), "stiffness").tolist() == [float(i + k) for k in range(4)]


def test_few_are_kept() -> None:
    bodies = [springs_of(4, first=10 * i) for i in range(3 * columns.MOST)]
    made = [column(parts, "stiffness") for parts in bodies]
    # From the latest on, since what is made anew takes the place of another one.
    again = [column(parts, "stiffness") for parts in reversed(bodies)]
    kept = [one is other for one, other in zip(again, reversed(made), strict=True)]
    assert kept == [True] * columns.MOST + [False] * (2 * columns.MOST)


def test_a_list_that_changes_is_looked_at_again() -> None:
    some = list(springs_of(3))
    assert column(some, "stiffness").tolist() == [0.0, 1.0, 2.0]  # type: ignore[arg-type]
    some[1] = spring(8, 9, 8.0)
    assert column(some, "stiffness").tolist() == [0.0, 8.0, 2.0]  # type: ignore[arg-type]


def fields_of(parts: tuple[sim.LinearSpring, ...]) -> list[list[float]]:
    return [column(parts, "stiffness").tolist(), *(end.tolist() for end in ends(parts))]


@given(st.data())
def test_arrays_of_other_parts_are_made_of_those_that_are_the_same(data: st.DataObject) -> None:
    """Of some springs, any stretch is replaced by any other springs, again and again."""
    parts = springs_of(data.draw(st.integers(0, 12)))
    for step in range(4):
        expected = [
            [each.stiffness for each in parts],
            [each.a for each in parts],
            [each.b for each in parts],
        ]
        assert fields_of(parts) == expected
        start = data.draw(st.integers(0, len(parts)))
        end = data.draw(st.integers(start, len(parts)))
        new = springs_of(data.draw(st.integers(0, 3)), first=100 * (step + 1))
        parts = (*parts[:start], *new, *parts[end:])


def test_vectors_of_other_masses_are_made_of_those_that_are_the_same() -> None:
    masses = tuple(sim.Mass(position=(float(i), -float(i))) for i in range(6))
    new = sim.Mass(position=(50.0, 60.0))
    for some in (masses, masses[:5], (*masses[:2], new, *masses[3:]), (*masses, new), (), (new,)):
        expected = [list(mass.position) for mass in some]
        assert vectors(some, "position").tolist() == expected
        assert vectors(some, "position").shape == (len(some), 2)


def test_only_what_is_new_is_read() -> None:
    read: list[str] = []

    class Counted:
        def __getattr__(self, field: str) -> float:
            read.append(field)
            return 1.0

    def reads(parts: tuple[Any, ...]) -> int:
        read.clear()
        for field in ("stiffness", "damping", "rest_length"):
            column(parts, field)
        assert read.count("stiffness") == read.count("damping") == read.count("rest_length")
        return read.count("stiffness")

    parts = tuple(Counted() for _ in range(50))
    assert reads(parts) == 50
    parts = (*parts[:20], Counted(), *parts[21:])
    assert reads(parts) == 1
    parts = parts[1:]
    assert reads(parts) == 0
    assert reads((*parts, Counted())) == 1
