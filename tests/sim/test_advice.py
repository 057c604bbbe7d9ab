"""Which method suits a scene: errors are true, and what is recommended is near enough."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest
from msgspec.structs import replace

import sim
from sim.analysis.advice import Advice, Tried, compare_methods, recommended
from sim.motion import divergence
from sim.motion.stability import StabilityMeter
from sim.solve.registry import METHODS
from tests.sim.checks import known

ROPE = sim.rope(4)


@pytest.fixture(scope="module")
def advice() -> Advice:
    return compare_methods(ROPE, (1.0, 0.1))


def end(method: str, value: float) -> np.ndarray:
    """Where the masses of the rope are after a second."""
    given = {"tolerance": value, "dt": 1.0 / 60.0} if METHODS[method].adaptive else {"dt": value}
    integrator = replace(ROPE.integrator, method=METHODS[method].name, **given)
    simulation = sim.Simulation(replace(ROPE, integrator=integrator))
    simulation.step(round(1.0 / integrator.dt))
    assert simulation.time == pytest.approx(1.0)
    return simulation.positions


def test_every_method_is_tried_and_its_errors_are_true(advice: Advice) -> None:
    assert {one.method for one in advice.tried} == set(METHODS)
    right = end("rodas4", 1e-9)
    assert advice.doubt < 1e-3
    assert advice.moved == pytest.approx(
        np.hypot(*(right - [mass.position for mass in ROPE.masses]).T).max(), abs=1e-3
    )
    for one in advice.tried:
        if math.isfinite(one.error):
            found = np.hypot(*(end(one.method, one.value) - right).T).max()
            assert one.error == pytest.approx(found, rel=1e-3, abs=2e-3)


def test_settings_get_finer_until_they_are_near_enough(advice: Advice) -> None:
    for name in METHODS:
        values = [one.value for one in advice.tried if one.method == name]
        assert values == sorted(set(values), reverse=True)
        assert [one.error <= 0.1 for one in advice.tried if one.method == name][:-1].count(True) == 0
        front = advice.front(name)
        assert all(a.seconds <= b.seconds and a.error > b.error for a, b in itertools.pairwise(front))


def test_what_is_recommended_is_near_enough_and_the_fastest() -> None:
    tried = [
        Tried("auto", 1.0, 0.4, 2e-3), Tried("velocity_verlet", 0.004, 2.0, 1e-3),
        Tried("velocity_verlet", 0.002, 0.03, 2.1e-3), Tried("rk4", 0.004, 0.9, 6e-3),
        Tried("adams", 10.0, 0.001, 1e-4),
    ]  # fmt: skip
    # Adams is near enough by luck, at a tolerance of 10 px.
    assert recommended(tried, 1.0) == (
        "take Auto at 1 px, which ends 0.4 px off; Velocity Verlet at 2 ms is as fast and ends 0.03 px off"
    )
    assert recommended(tried, 0.1) == "take Velocity Verlet at 2 ms, which ends 0.03 px off"
    assert "none of the settings" in recommended(tried, 1e-3 / 2.0)


def test_where_nothing_can_be_told_it_is_said() -> None:
    tried = (Tried("auto", 1.0, 0.0, 1e-3),)
    assert "small errors grow" in Advice(tried, 0.5, 100.0).sentence(1.0)
    assert "from its start" in Advice(tried, 0.0, 0.2).sentence(1.0)
    assert Advice(tried, 0.0, 100.0).sentence(1.0) == "To 1 px, take Auto at 1 px, which ends 0 px off."


@pytest.mark.parametrize("errors", [(), (0.0,), (math.nan,), (1.0, math.inf)])
def test_errors_that_are_none_are_refused(errors: tuple[float, ...]) -> None:
    with pytest.raises(sim.InputError, match="above zero"):
        compare_methods(ROPE, errors)


def test_it_does_not_wait_for_what_is_not_compiled(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sim.Simulation, "plain", True)
    with pytest.raises(sim.InputError, match="still being compiled"):
        compare_methods(ROPE, wait=False)


def test_why_a_body_exploded_is_found_when_somebody_asks(monkeypatch: pytest.MonkeyPatch) -> None:
    def unasked(*_: object) -> None:
        raise AssertionError("nobody asked")

    scene = sim.set_value(sim.load_scene("tutorial-3.3"), "linear_stiffness", 1e6)
    monkeypatch.setattr(divergence, "StabilityMeter", unasked)
    simulation = sim.Simulation(scene)
    simulation.step(5000)
    found = known(simulation.divergence)
    simulation.reset()
    simulation.move(0, (500.0, 500.0))
    monkeypatch.setattr(divergence, "StabilityMeter", StabilityMeter)
    assert found.stability.limit < found.dt
    assert "is above the stability limit" in str(found)
