"""How fast small errors grow, held against motions of which that is known."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import sim
from sim.analysis.predictability import TwinTrajectory, growth_within, hair_of, horizon, verdict
from sim.errors import InputError
from tests.sim.builders import built, chain

EXACTLY = sim.Integrator(method="auto", tolerance=1e-3)


def swinging(*degrees: float, length: float = 100.0, stiffness: float = 1e6) -> sim.Scene:
    """A pendulum of so many arms at these angles from hanging, under a gravity of 1000, on stiff springs."""
    places = [(0.0, 0.0)]
    for angle in map(math.radians, degrees):
        x, y = places[-1]
        places.append((x + length * math.sin(angle), y + length * math.cos(angle)))
    return built(places, stiffness=stiffness, held=(0,), gravity=(0.0, 1000.0), integrator=EXACTLY)


def bouncing(damping: float, method: str = "auto") -> sim.Scene:
    """A mass that swings about once a second between four springs."""
    places = [(2.0, 1.0), (0.0, 100.0), (0.0, -100.0), (100.0, 0.0), (-100.0, 0.0)]
    numbers: dict[str, Any] = {"stiffness": 20.0, "damping": damping, "rest_length": 100.0}
    scene = built(places, [(0, i) for i in range(1, 5)], **numbers, held=range(1, 5))
    return sim.set_choice(scene, "method", method)


@pytest.mark.parametrize("method", ["auto", "symplectic_euler"])
def test_errors_of_a_spring_s_swings_do_not_grow(method: str) -> None:
    found = sim.predictability(bouncing(0.0, method), 6.0)
    assert abs(found.rate) < 0.1
    assert found.e_folding > 10.0
    assert found.times[-1] == pytest.approx(6.0)
    assert found.growth[0] == 0.0
    assert found.verdict.startswith("errors do not grow: ")


def test_damping_takes_errors_away_at_its_own_rate() -> None:
    found = sim.predictability(bouncing(1.5), 4.0)
    assert found.rate == pytest.approx(-1.5, abs=0.1)
    assert found.e_folding == math.inf


def test_a_pendulum_that_stands_on_its_head() -> None:
    found = sim.predictability(swinging(180.0), 3.0)
    # The arm is a little shorter under the weight.
    assert found.rate == pytest.approx(math.sqrt(1000.0 / (100.0 - 1e-3)), rel=0.01)
    assert found.per_second == pytest.approx(math.exp(found.rate))
    assert "errors grow × 24 in a second: a tolerance of 0.001 px is kept" in found.verdict


def test_a_double_pendulum_is_chaotic() -> None:
    """Of the order of the frequency of small swings (Shinbrot et al., Chaos in a double pendulum, 1992)."""
    wild = sim.predictability(swinging(120.0, 150.0, stiffness=1e5), 8.0)
    calm = sim.predictability(swinging(5.0, 7.0, stiffness=1e5), 8.0)
    unit = math.sqrt(1000.0 / 100.0)
    assert 0.3 * unit < wild.rate < 2.0 * unit
    assert abs(calm.rate) < 0.1 * unit


@pytest.mark.parametrize("preset", ["pile", "girder", "flag-pole"])
def test_bodies_that_touch_break_or_stand_in_the_wind(preset: str) -> None:
    found = sim.predictability(sim.load_scene(preset), 0.2)
    assert np.isfinite(found.growth).all()
    assert found.times[-1] == pytest.approx(0.2, abs=0.02)


def test_held_masses_are_nowhere_else() -> None:
    body = sim.Simulation(sim.load_scene("tutorial-3.3"))
    shadow = TwinTrajectory(body)
    near, far = shadow.pair
    apart = far.positions - near.positions
    assert not apart[0].any()
    assert apart[1:].all()
    assert np.hypot(*apart.T).max() == pytest.approx(hair_of(body.scene))
    body.grab(5)
    shadow.place(body)
    assert not shadow.hair[:, 5].any()
    assert near.positions[5] == pytest.approx(body.positions[5])


def test_a_shadow_takes_over_what_keys_have_changed_and_other_bodies() -> None:
    body = sim.Simulation(sim.load_scene("tutorial-3.3"))
    shadow = TwinTrajectory(body)
    body.keys = {"up", "right"}
    body.step(40)
    shadow.place(body)
    assert shadow.pair[0].rest_length_scale == body.rest_length_scale
    assert shadow.pair[0].rest_angles == pytest.approx(body.rest_angles)
    body.replace(sim.load_scene("ring"))
    shadow.place(body)
    assert shadow.step(7)
    assert shadow.hair.shape == (4, len(body.scene.masses))
    assert not shadow.held


def test_a_shadow_without_time_says_so() -> None:
    shadow = TwinTrajectory(sim.Simulation(swinging(90.0)))
    assert not shadow.step(1000, attempts=3)
    assert shadow.level == 0.0


def test_what_cannot_be_told_is_refused() -> None:
    with pytest.raises(InputError, match="every mass of the scene is held"):
        sim.predictability(chain([(0.0, 0.0), (10.0, 0.0)], held=(0, 1)), 1.0)
    for attempts in (0, -1, 1.5, True):
        with pytest.raises(sim.InputError, match="attempts"):
            sim.predictability(bouncing(0.0), 1.0, attempts)  # type: ignore[arg-type]
    for duration in (0.0, -1.0, math.nan, 1e5):
        with pytest.raises(InputError, match=r"is not in the range 0\.\.10000 s"):
            sim.predictability(bouncing(0.0), duration)


def test_the_growth_of_the_last_second() -> None:
    times = np.arange(0.0, 3.0, 0.05)
    # Its sign changes five times a second.
    levels = 2.0 * times + np.log(np.abs(np.cos(5.0 * math.pi * times)) + 1e-9)
    assert growth_within(list(times), list(levels), 1.0) == pytest.approx(2.0, abs=0.1)
    assert growth_within(list(times[:10]), list(levels[:10]), 1.0) is None
    assert growth_within([], [], 1.0) is None


def test_what_is_said_of_it() -> None:
    scene = swinging(10.0)
    assert horizon(scene, 1.0) == math.inf
    assert horizon(scene, 100.0) == pytest.approx(math.log(1e-3 / 2.0**-46) / math.log(100.0))
    assert verdict(scene, 4000.0) == (
        f"errors grow × 4e+03 in a second: no tolerance can promise where it is in "
        f"{horizon(scene, 4000.0):.2g} s"
    )
    euler = sim.set_choice(scene, "method", "symplectic_euler")
    assert "no time step can promise" in verdict(euler, 4000.0)
    assert verdict(euler, 3.0) == "errors grow × 3 in a second: a shorter time step makes them smaller"


def test_a_run_that_is_too_hard_ends_with_what_is_known_and_says_so() -> None:
    whole = sim.predictability(swinging(180.0), 3.0)
    assert whole.complete and "used up" not in whole.verdict
    part = sim.predictability(swinging(180.0), 3.0, 2000)
    assert not part.complete and 0.0 < part.times[-1] < 3.0
    assert part.growth == pytest.approx(whole.growth[: len(part.growth)])
    assert part.verdict.startswith(f"until {part.times[-1]:.3g} s, errors")
    assert part.verdict.endswith("; the 2000 steps that it may try were used up before 3 s")
    # Nor is the last look left out in silence.
    for attempts in range(1300, 1500, 20):
        found = sim.predictability(swinging(180.0), 0.2, attempts)
        assert found.complete == (found.times[-1] == pytest.approx(0.2))
    none = sim.predictability(swinging(180.0), 3.0, 1)
    assert not none.complete and len(none.times) == 1 and none.rate == 0.0
    assert none.verdict.startswith("how fast errors grow is not known; the 1 steps")
