"""The arrow keys in simulated time, and how well the motion is solved."""

from __future__ import annotations

import math

import numpy as np
import pytest
from msgspec.structs import replace

import sim
from sim import ArrowKeys, InputError, Scene, Simulation
from sim.scene.types import Method
from tests.sim.builders import tutorial_preset, tutorial_rope
from tests.sim.changes import apart, by, step_all


def with_keys(scene: Scene, *keys: str, dt: float | None = None) -> Simulation:
    simulation = Simulation(scene, dt=dt)
    simulation.keys = set(keys)
    return simulation


# ------------------------------------------------------------------------- keys
@pytest.mark.parametrize("dt", [0.0025, 0.00125, 0.0005, 0.004])
def test_keys_act_per_simulated_time(dt: float) -> None:
    steps = round(1.0 / dt)
    for keys, sign in (("up", "right"), 1), (("down", "left"), -1):
        simulation = with_keys(sim.load_scene("tutorial-3.3"), *keys, dt=dt)
        assert simulation.step(steps) == steps
        # 400 intervals a second: lengths times 1.002^400 = 2.22, angles plus 40 degrees.
        assert simulation.rest_length_scale == pytest.approx(1.002 ** (sign * 400), rel=1e-9)
        assert simulation.rest_angles == pytest.approx(np.full(10, sign * 40.0), abs=1e-9)


def test_keys_do_nothing_once_let_go_or_where_the_scene_has_none() -> None:
    simulation = with_keys(sim.load_scene("tutorial-3.3"), "up")
    simulation.step(10)
    simulation.keys = ()
    simulation.step(10)
    assert simulation.rest_length_scale == pytest.approx(1.002**10)
    simulation = with_keys(sim.load_scene("tutorial-3.2"), "up", "right")
    simulation.step(10)
    assert simulation.rest_length_scale == 1.0
    assert set(simulation.rest_angles) == {float(simulation.scene.template or 0)}


def test_unknown_keys_are_refused() -> None:
    simulation = with_keys(sim.load_scene("tutorial-3.3"), "up")
    for keys in ({"space"}, "up", {"up", ""}, [3]):
        with pytest.raises(InputError, match="keys"):
            simulation.keys = keys  # type: ignore[assignment]
    assert simulation.keys == {"up"}


@pytest.mark.parametrize(
    ("key", "start", "expected"), [("right", 179.95, -179.95), ("left", -179.95, 179.95)]
)
def test_rest_angles_wrap_at_180(key: str, start: float, expected: float) -> None:
    simulation = with_keys(sim.set_value(sim.load_scene("tutorial-3.3"), "rest_angle", start), key)
    simulation.step()
    assert simulation.rest_angles[0] == pytest.approx(expected, abs=1e-9)
    assert simulation.scene.angular_springs[0].rest_angle == pytest.approx(expected, abs=1e-9)
    simulation.step(3600 - 1)
    assert simulation.rest_angles[0] == pytest.approx(start, abs=1e-6)


def test_minus_180_is_shown_as_180() -> None:
    scene = sim.set_value(sim.load_scene("tutorial-3.3"), "rest_angle", -180.0)
    assert set(Simulation(scene).rest_angles) == {180.0}


def test_rest_length_scale_stays_within_its_range() -> None:
    # Held, so that nothing breaks while the lengths go where no rope could follow.
    everywhere = tutorial_rope(masses=3, held=(0, 1, 2))
    for key, limit in (("up", 100.0), ("down", 0.01)):
        simulation = with_keys(everywhere, key)
        simulation.step(3000)
        assert simulation.rest_length_scale == limit
        assert sim.validate(simulation.scene).rest_length_scale == limit
    # And back: the clamp is not a trap.
    simulation.keys = {"up"}
    simulation.step(10)
    assert simulation.rest_length_scale == pytest.approx(0.01 * 1.002**10)


@pytest.mark.parametrize("preset", ["tutorial-3.3", "ring"])
def test_the_scene_folds_the_keys_in(preset: str) -> None:
    simulation = with_keys(tutorial_preset(preset), "down", "left")
    simulation.step(123)
    scene = sim.validate(simulation.scene)
    again = Simulation(scene)
    assert again.rest_length_scale == simulation.rest_length_scale
    assert again.rest_angles == pytest.approx(simulation.rest_angles, abs=1e-9)
    # It also moves on in the same way.
    again = Simulation(replace(scene, pose=simulation.pose()))
    again.keys = simulation.keys
    step_all(200, simulation, again)
    assert apart(again, simulation) <= 1e-7


def test_a_template_scene_that_keys_have_turned_keeps_its_stiffness() -> None:
    scene = sim.set_value(sim.load_scene("tutorial-3.2"), "template", 45)
    simulation = with_keys(replace(scene, arrow_keys=ArrowKeys()), "right")
    simulation.step(100)
    folded = sim.validate(simulation.scene)
    assert folded.template is None
    assert folded.angular_springs[0].rest_angle == pytest.approx(55.0)
    assert folded.angular_springs[0].stiffness == pytest.approx(math.sqrt(2.0) * 10_000.0)
    again = Simulation(replace(folded, pose=simulation.pose()))
    simulation.keys = ()
    step_all(100, simulation, again)
    assert apart(again, simulation) <= 1e-7


@pytest.mark.parametrize("rates", [{"rest_length_factor": 2.0}, {"rest_angle_step": 90.0}])
@pytest.mark.parametrize("keys", [{"up", "right"}, {"down", "left"}, {"up", "down"}])
@pytest.mark.parametrize("method", ["symplectic_euler", "auto"])
def test_the_fastest_keys_allowed_leave_a_valid_scene(
    rates: dict[str, float], keys: set[str], method: Method
) -> None:
    # 2500 intervals in one step, which is more than a factor or an angle can grow by in a number.
    scene = sim.rope(masses=3, held=(0, 1, 2), arrow_keys=ArrowKeys(**rates, interval=1e-6))
    simulation = with_keys(by(scene, method), *keys)
    simulation.step(2)
    sim.validate(simulation.scene)
    assert 0.01 <= simulation.rest_length_scale <= 100.0


# ------------------------------------------------------------------------- the picture
@pytest.mark.parametrize("name", [info.name for info in sim.list_scenes() if info.built_in])
def test_what_a_preset_shows_stays_in_its_frame(name: str) -> None:
    simulation = Simulation(sim.load_scene(name))
    xmin, ymin, xmax, ymax = simulation.scene.view.frame
    for _ in range(5 * 60):
        simulation.advance(1.0 / 60.0)
        x, y = simulation.positions.T
        assert xmin < x.min() and x.max() < xmax
        assert ymin < y.min() and y.max() < ymax
