"""`softrod bench peers`: its scenes, their references, and what is measured."""

from __future__ import annotations

import msgspec
import numpy as np
import pytest

import sim
from studies.bench.heap import heap
from studies.peers import heaps, references
from studies.peers.plain import Equations
from studies.peers.scenes import HEAPS, PATHS, ropes


@pytest.mark.parametrize("name", PATHS)
def test_a_reference_is_that_of_its_scene(name: str) -> None:
    found = references.reference(name)
    assert found.shape == (len(PATHS[name].make().masses), 2)
    assert np.isfinite(found).all()


def test_a_reference_is_what_is_computed_anew() -> None:
    assert np.abs(references.compute(PATHS["rope-12"].make()) - references.reference("rope-12")).max() < 1e-8


def test_softrod_agrees_with_the_references() -> None:
    for name, allowed in (("rope-12", 1e-6), ("net-100-soft", 1e-5)):
        exact = sim.Integrator(method="adams", dt=1.0, tolerance=1e-7)
        simulation = sim.Simulation(msgspec.structs.replace(PATHS[name].make(), integrator=exact))
        simulation.step()
        assert np.abs(simulation.positions - references.reference(name)).max() < allowed


def test_another_scene_has_no_reference(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(PATHS, "rope-12", PATHS["rope-100"])
    with pytest.raises(sim.InputError, match="rope-12: its reference is of another scene"):
        references.reference("rope-12")


def test_the_plain_equations_have_their_jacobian() -> None:
    equations = Equations(PATHS["rope-12"].make())
    y = equations.start + np.random.default_rng(1).normal(size=equations.start.size)
    jacobian, f = equations.jacobian()(0.3, y), equations.derivative
    expected = np.empty((y.size, y.size))
    for k, shift in enumerate(1e-5 * np.eye(y.size)):
        expected[:, k] = (f(0.3, y + shift) - f(0.3, y - shift)) / 2e-5
    assert np.abs(jacobian.toarray() - expected).max() < 1e-6 * np.abs(expected).max()  # type: ignore[attr-defined]


def test_many_ropes_are_alike_but_for_their_numbers() -> None:
    first, last = ropes(3)[0], ropes(3)[-1]
    assert len(first.masses) == len(last.masses) == 12
    assert first.linear_springs[0].stiffness < last.linear_springs[0].stiffness
    assert first.masses[-1].position != last.masses[-1].position


def test_a_heap_is_judged_by_its_places(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(HEAPS, "heap-120", lambda: heap(2))
    at = np.array([mass.position for mass in heap(2).masses])
    apart = heaps.Pile("heap-120")
    apart.look(at)
    assert (apart.deepest, apart.inside()) == (0.0, 0)
    # One into the other: at the left, up to one spring of the other's.
    at[12:] += at[:12].mean(0) - at[12:].mean(0) + (20.0, 0.0)
    into = heaps.Pile("heap-120")
    into.look(at)
    assert 3.0 < into.deepest <= 4.0
    assert 0 < into.inside() < 12
    into.look(at + np.array((0.0, 0.5)))
    assert into.speed(0.1) == pytest.approx(5.0)
