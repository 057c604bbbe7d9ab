"""Friction of air whose sign changes is kept out of what Adams' methods go by."""

from __future__ import annotations

import math

import numpy as np
import pytest
from msgspec.structs import replace
from numpy.polynomial import Polynomial
from scipy.integrate import solve_ivp

import sim
from sim import Integrator, Mass, Scene, Simulation
from sim.engine.tables import PAST, SPARE
from sim.scene.types import AirLaw
from sim.solve.adams_table import adams
from sim.solve.steps import kinks
from tests.sim.changes import by

SLOTS = 32
MASSES = range(1, SLOTS - SPARE)
AIR, STEP = 0.3, 0.1
TABLE = adams(PAST - 1)


def flat(values: dict[int, float]) -> np.ndarray:
    """A flat vector that is zero but at some indices."""
    out = np.zeros(2 * SLOTS)
    for slot, value in values.items():
        out[slot] = value
    return out


def air(slots: range = MASSES) -> np.ndarray:
    out = np.zeros(SLOTS)
    out[slots] = AIR
    return out


@pytest.mark.parametrize("known", range(2, PAST + 1))
@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_the_past_becomes_that_of_the_new_sign(known: int, sign: float) -> None:
    """As the velocity would have been without the turn: the integral of a polynomial that fits all rows."""
    rng = np.random.default_rng(known)
    wavy = Polynomial([100.0, *rng.normal(0.0, 100.0, known - 1)])  # px/s², under the old sign
    speed = sign * (wavy.integ() + 4.0)  # px/s, at the latest step
    turning, steady = 3, SLOTS + 5
    v, to_v = flat({turning: -sign, steady: sign}), flat({turning: speed(0.0), steady: sign})
    head = 5
    past, told = np.zeros((PAST, 2 * SLOTS)), sign * wavy
    for r in range(PAST):
        past[(head + r) % PAST, [turning, steady]] = told(-r * STEP) if r < known else 1e9
    past[head, turning] -= 2.0 * AIR * speed(0.0) * abs(speed(0.0))  # there, the sign is the new one
    before = past.copy()
    kinks.turn_past(air(), v, to_v, past, head, known, TABLE.back, STEP)
    for r in range(1, known):
        expected = told(-r * STEP) - sign * 2.0 * AIR * speed(-r * STEP) ** 2
        assert past[(head + r) % PAST, turning] == pytest.approx(expected, rel=1e-9, abs=1e-6)
    past[:, turning] = before[:, turning]
    np.testing.assert_array_equal(past, before)


def fallen(pull: Polynomial, speed: float, kept: bool) -> np.ndarray:
    """(move, velocity) after a step under an acceleration and friction, which may keep its sign."""

    def rates(t: float, state: np.ndarray) -> tuple[float, float]:
        sign = speed if kept else state[1]
        return state[1], pull(t) - AIR * math.copysign(state[1] ** 2, sign)

    return solve_ivp(rates, (0.0, STEP), [0.0, speed], rtol=1e-12, atol=1e-13, max_step=STEP / 50).y[:, -1]


@pytest.mark.parametrize("sign", [1.0, -1.0])
@pytest.mark.parametrize("change", [-300.0, 0.0, 300.0])
@pytest.mark.parametrize(("strength", "exactly"), [(5.0, 1e-3), (50.0, 2e-2)])
def test_what_friction_did_since_the_turn_is_added(
    sign: float, change: float, strength: float, exactly: float
) -> None:
    """A velocity that turns in the step, while the acceleration but for friction changes evenly."""
    pull = Polynomial([sign * strength, sign * strength / 50.0 * change])  # px/s²
    speed = -0.3 * STEP * pull(0.0)
    kept, true = fallen(pull, speed, kept=True), fallen(pull, speed, kept=False)
    x, y, steady = 1, SLOTS + MASSES[-1], 4
    begin, end = pull(0.0) + sign * AIR * speed**2, pull(STEP) + sign * AIR * kept[1] ** 2
    v, a = flat({x: speed, y: -speed, steady: 1.0}), flat({x: begin, y: -begin, steady: 10.0})
    to_q, to_v = (flat({x: kept[i], y: -kept[i], steady: 7.0}) for i in range(2))
    kinks.with_kinks(air(), v, a, flat({x: end, y: -end, steady: 10.0}), STEP, to_q, to_v)
    for i, found in enumerate((to_q, to_v)):
        lost = true[i] - kept[i]
        assert found[x] - kept[i] == pytest.approx(lost, rel=exactly)
        assert found[y] + kept[i] == pytest.approx(-lost, rel=exactly)
        assert found[steady] == 7.0
        assert not np.delete(found, [x, y, steady]).any()


def test_accelerations_are_told_with_the_sign_before_the_turn() -> None:
    v = flat({1: -1.0, 2: 1.0, SLOTS + 1: 3.0, SLOTS + 2: 0.0})
    to_v = flat({1: 2.0, 2: 2.0, SLOTS + 1: -4.0, SLOTS + 2: 5.0})
    a = np.zeros(2 * SLOTS)
    kinks.without_kinks(air(range(1, 3)), v, to_v, a)
    np.testing.assert_allclose(a, flat({1: 2.0 * AIR * 4.0, SLOTS + 1: -2.0 * AIR * 16.0}), rtol=1e-14)
    assert kinks.any_turns(v, to_v)
    assert not kinks.any_turns(v, v)
    assert not kinks.any_turns(np.zeros(2 * SLOTS), to_v)


def test_kinks_are_looked_at_where_they_matter() -> None:
    a, weight = flat({SLOTS + MASSES[-1]: -1000.0}), 0.02
    error = 2.0 * AIR * 100.0**2 * weight * STEP  # px per second
    assert kinks.kinks_matter(air(), a, STEP, weight, 10.0 * error)
    assert not kinks.kinks_matter(air(), a, STEP, weight, 100.0 * error)
    assert not kinks.kinks_matter(np.zeros(SLOTS), a, STEP, weight, 1e-9)


def thrown(tolerance: float, friction: float, law: AirLaw = "tutorial") -> Simulation:
    """Masses that rise and fall, thrown at different speeds, without springs."""
    masses = tuple(Mass(position=(30.0 * i, 0.0), velocity=(0.0, -100.0 - 40.0 * i)) for i in range(8))
    integrator = Integrator(method="adams", tolerance=tolerance, dt=1.0)
    return Simulation(
        Scene(
            name="thrown",
            masses=masses,
            gravity=(0.0, 1000.0),
            air_friction=friction,
            air_law=law,
            integrator=integrator,
        )
    )


def exact(speed: float, friction: float, time: float) -> float:
    """How far a mass of 1 kg falls that was thrown up: by the tangent, and then by the hyperbolic one."""
    limit = math.sqrt(1000.0 / friction)
    top = limit / 1000.0 * math.atan(speed / limit)
    rise = limit**2 / 2000.0 * math.log1p((speed / limit) ** 2)
    return limit**2 / 1000.0 * math.log(math.cosh(1000.0 * (time - top) / limit)) - rise


@pytest.mark.parametrize(("tolerance", "most"), [(1e-3, 45), (1e-6, 115), (1e-9, 220)])
def test_what_is_thrown_up_turns_without_short_steps(tolerance: float, most: int) -> None:
    """Eight masses turn at eight moments, between the steps; their closed form has two branches.

    Where kinks are seen, it takes 55, 208 and 358 steps.
    """
    friction = 0.002
    simulation = thrown(tolerance, friction)
    assert simulation.step() == 1
    expected = [exact(100.0 + 40.0 * i, friction, 1.0) for i in range(8)]
    assert np.abs(simulation.positions[:, 1] - expected).max() < max(tolerance, 4e-9)
    assert simulation.stats().steps < most


@pytest.mark.parametrize("tolerance", [1e-7, 1e-9])
def test_a_turn_costs_no_accuracy_wherever_in_a_step_it_is(tolerance: float) -> None:
    """Tolerances beside each other put the turns at other points of other steps."""
    expected = [exact(100.0 + 40.0 * i, 0.002, 1.0) for i in range(8)]
    off = []
    for nearby in tolerance * np.geomspace(0.8, 1.25, 15):
        simulation = thrown(float(nearby), 0.002)
        simulation.step()
        off.append(np.abs(simulation.positions[:, 1] - expected).max() / nearby)
    assert max(off) < 5.0


@pytest.mark.parametrize("tolerance", [1e-2, 1e-4, 1e-6])
def test_air_that_brakes_alike_in_all_directions_has_a_kink_on_a_straight_line_only(tolerance: float) -> None:
    """There Adams sees it, which costs steps, and now and then some accuracy."""
    simulation = thrown(tolerance, 0.002, "isotropic")
    simulation.step()
    expected = [exact(100.0 + 40.0 * i, 0.002, 1.0) for i in range(8)]
    assert np.abs(simulation.positions[:, 1] - expected).max() < 8.0 * tolerance


@pytest.mark.parametrize("name", ["study-w2", "study-w5"])
def test_kinks_ask_for_hardly_more_steps(name: str) -> None:
    """A rope on a circle, and one that rolls up, under a tolerance for which each kink counts."""
    scene = by(sim.load_scene(name), "adams", tolerance=1e-6, dt=1.0)
    steps = []
    for friction in (0.002, 0.0):
        simulation = Simulation(replace(scene, air_friction=friction))
        assert simulation.step() == 1
        steps.append(simulation.stats().steps)
    assert steps[0] < 1.35 * steps[1]
