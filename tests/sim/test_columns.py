"""Numbers of many parts as arrays: those of the parts as they are, however many others were asked for."""

from __future__ import annotations

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


def test_few_are_kept() -> None:
    for i in range(3 * columns.MOST):  # a tuple that is gone may leave its id to the next
        assert column(springs_of(4, first=i), "stiffness").tolist() == [float(i + k) for k in range(4)]
        assert len(columns._kept) <= columns.MOST


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
    columns._kept.clear()
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


def test_only_what_is_new_is_read(monkeypatch: pytest.MonkeyPatch) -> None:
    read: list[int] = []

    def counting(parts: tuple[sim.LinearSpring, ...], field: str, dtype: type) -> np.ndarray:
        read.append(len(parts))
        return made(parts, field, dtype)

    made = columns._made
    columns._kept.clear()
    monkeypatch.setattr(columns, "_made", counting)
    parts = springs_of(50)
    fields_of(parts)
    parts = (*parts[:20], spring(3, 4, 5.0), *parts[21:])
    fields_of(parts)
    parts = parts[1:]
    fields_of(parts)
    fields_of((*parts, spring(0, 9, 1.0)))
    assert read == [50] * 3 + [1] * 3 + [0] * 3 + [1] * 3
