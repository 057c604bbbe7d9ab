"""A body that runs away: the last good state is kept, and the message says what happened and why."""

from __future__ import annotations

import math

import numpy as np
import pytest
from msgspec.structs import replace

import sim
from sim import Scene, Simulation
from tests.sim.builders import chain, row, tutorial_rope
from tests.sim.changes import with_masses
from tests.sim.checks import known
from tests.sim.inside import general, put
from tests.sim.laws import Laws, complexes, points


def too_stiff(stiffness: float = 60_000.0) -> Scene:
    """The tutorial's rope, with angular springs too stiff for its step, hung askew so that it bends."""
    scene = sim.set_value(sim.load_scene("tutorial-3.3"), "angular_stiffness", stiffness)
    return with_masses(scene, position=lambda i, mass: (mass.position[0] + i % 2, mass.position[1]))


def ran(scene: Scene) -> Simulation:
    """A simulation after as many steps as it can make."""
    simulation = Simulation(scene)
    simulation.step(5000)
    return simulation


def runs_away(simulation: Simulation) -> list[int]:
    """The masses that leave what is allowed in the step that the simulation refused, by other equations."""
    dt, at, speed = simulation.dt, complexes(simulation.positions), complexes(simulation.velocities)
    speed = speed + dt * Laws(simulation.scene).accelerations(at, speed)
    numbers = np.column_stack((points(at + dt * speed), points(speed)))
    return np.flatnonzero(~(np.abs(numbers) <= 1e6).all(1)).tolist()


# ------------------------------------------------------------------------- where it stops
@pytest.mark.parametrize("batch", [1, 7, 64, 5000])
def test_stops_at_the_last_good_state(batch: int) -> None:
    simulation = Simulation(too_stiff())
    done = 0
    while simulation.divergence is None and done < 5000:
        done += simulation.step(batch)
    divergence = known(simulation.divergence)
    assert divergence.step == simulation.step_count == done
    assert simulation.time == pytest.approx(done * 0.0025, rel=1e-12)
    assert np.isfinite(simulation.positions).all()
    assert np.isfinite(simulation.velocities).all()
    assert max(np.abs(simulation.positions).max(), np.abs(simulation.velocities).max()) <= 1e6

    fresh = Simulation(too_stiff())
    assert fresh.step(done) == done
    assert fresh.divergence is None
    assert np.array_equal(fresh.positions, simulation.positions)
    assert np.array_equal(fresh.velocities, simulation.velocities)
    assert fresh.step(1) == 0


@pytest.mark.parametrize("path", ["chain", "general"])
def test_names_the_mass_and_the_limit(path: str) -> None:
    scene = too_stiff()
    if path == "general":
        scene = replace(
            scene, linear_springs=scene.linear_springs[:-1], angular_springs=scene.angular_springs[:-1]
        )
    simulation = Simulation(scene)
    simulation.step(5000)
    divergence = known(simulation.divergence)
    bad = runs_away(simulation)
    assert divergence.mass == bad[0]
    assert (divergence.quantity, divergence.limit) in (("speed", 1e6), ("position", 1e6))
    text = str(divergence)
    assert f"mass {bad[0]} " in text
    words = {"speed": "became too fast (over 1,000,000 px/s)", "position": "went too far (over 1,000,000 px)"}
    assert words[divergence.quantity] in text
    assert f"step {divergence.step}:" in text


def test_names_the_mass_of_the_scene_when_masses_are_listed_in_any_order() -> None:
    scene = too_stiff()
    count = len(scene.masses)
    # The scene's mass i becomes mass count - 1 - i; the solver still visits them from the anchor on.
    shuffled = replace(
        scene,
        masses=scene.masses[::-1],
        linear_springs=tuple(replace(s, a=count - 1 - s.a, b=count - 1 - s.b) for s in scene.linear_springs),
        anchors=tuple(replace(a, mass=count - 1 - a.mass) for a in scene.anchors),
    )
    one, other = (known(ran(each).divergence) for each in (scene, shuffled))
    assert other.step == one.step
    assert other.mass == count - 1 - one.mass


@pytest.mark.parametrize("direction", [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)])
def test_runaway_positions_and_speeds_are_named(direction: tuple[float, float]) -> None:
    # No springs: a mass that flies out of the range, and one that falls faster and faster.
    x, y = direction
    flying = chain([(999_990.0 * x, 999_990.0 * y)], velocities=[(900.0 * x, 900.0 * y)], dt=0.01)
    falling = chain([(0.0, 0.0)], gravity=(0.9e6 * x, 0.9e6 * y), dt=0.01)
    for scene, steps, quantity, at in (
        (flying, 1, "position", 999_999.0), (falling, 111, "speed", 999_000.0),
    ):  # fmt: skip
        simulation = Simulation(scene)
        assert simulation.step(1000) == steps
        divergence = known(simulation.divergence)
        assert (divergence.quantity, divergence.limit) == (quantity, 1e6)
        found = simulation.positions if quantity == "position" else simulation.velocities
        assert found[0] == pytest.approx([at * x, at * y])


def test_a_number_that_is_none_is_named() -> None:
    # No scene leads there in one step; were there one, this is what would happen.
    simulation = Simulation(chain(row(3), stiffness=100.0, held=(0,)))
    velocities = np.zeros((3, 2))
    velocities[2, 0] = np.nan
    put(simulation, simulation.positions, velocities)
    assert simulation.step(5) == 0
    divergence = known(simulation.divergence)
    assert divergence.quantity == "number"
    assert divergence.mass in (1, 2)  # the spring hands it on
    assert "not a finite number" in str(divergence)
    assert "\n" not in str(divergence)


@pytest.mark.parametrize("general_path", [False, True])
def test_a_spring_without_length_pulls_at_nothing(general_path: bool) -> None:
    # It has no direction. What else pulls at its ends goes on, on both paths.
    simulation = Simulation(chain(row(3), stiffness=100.0, damping=5.0, held=(0,)))
    if general_path:
        general(simulation)
    simulation.move(0, tuple(simulation.positions[1]))
    assert simulation.step(1) == 1
    assert abs(simulation.velocities[1, 0]) < 1e-15  # the other is at its rest length, to the last digit
    assert simulation.step(500) == 500
    assert np.isfinite(simulation.positions).all()


# ------------------------------------------------------------------------- afterwards
def test_a_body_that_ran_away_makes_no_steps_until_it_is_reset() -> None:
    simulation = ran(too_stiff())
    positions, count = simulation.positions, simulation.step_count
    simulation.lead(0, (0.0, 0.0))
    assert simulation.step(10) == 0
    assert simulation.advance(1.0) == 0
    assert np.array_equal(simulation.positions, positions)
    assert simulation.step_count == count
    # Not even where a step would go well, as it does when everything is held.
    for mass in range(len(positions)):
        simulation.grab(mass)
    assert simulation.step(10) == 0
    simulation.reset()
    assert simulation.divergence is None
    assert simulation.step(5) == 5
    fresh = Simulation(too_stiff())
    fresh.step(5)
    assert np.array_equal(simulation.positions, fresh.positions)


def test_a_body_that_ran_away_makes_no_steps_until_another_takes_its_place() -> None:
    simulation = ran(too_stiff())
    with pytest.raises(sim.SceneError):
        simulation.replace(replace(too_stiff(), name=""))
    assert simulation.divergence is not None
    simulation.replace(sim.load_scene("ring"))
    assert simulation.divergence is None
    assert simulation.step(5) == 5


# ------------------------------------------------------------------------- why
@pytest.mark.parametrize("stiffness", [45_000.0, 60_000.0])
def test_too_large_a_step_is_blamed_on_the_law_that_sets_the_limit(stiffness: float) -> None:
    # At 45 000 the torn body itself would be stable again, so it must be looked at as it was.
    divergence = known(ran(too_stiff(stiffness)).divergence)
    assert "stability limit" in divergence.reason
    assert "angular stiffness" in divergence.reason
    assert "0.0025 s" in divergence.reason
    # A long chain's formula; the meter may be a little above it.
    assert divergence.stability.limit == pytest.approx(0.5 / math.sqrt(stiffness), rel=0.03)
    assert str(divergence).endswith(divergence.reason)


def test_too_stiff_linear_springs_are_blamed_as_such() -> None:
    positions = [(10.0 * i + 0.1 * (i % 2), 0.0) for i in range(10)]
    simulation = ran(chain(positions, stiffness=1e6, held=(0,), dt=0.0025))
    assert "linear stiffness" in known(simulation.divergence).reason


@pytest.mark.parametrize("joints", [True, False])
def test_a_violent_move_is_not_blamed_on_the_step(joints: bool) -> None:
    simulation = Simulation(tutorial_rope(joints=joints))
    simulation.move(0, (90_000.0, 0.0))
    simulation.step(100)
    divergence = known(simulation.divergence)
    assert divergence.stability.limit > simulation.dt
    assert "small motions" in divergence.reason
    assert "is above the stability limit" not in str(divergence)


def test_the_meter_survives_a_spring_without_length() -> None:
    simulation = Simulation(sim.load_scene("tutorial-3.3"))
    positions = simulation.positions
    positions[4] = positions[5]
    put(simulation, positions)
    assert simulation.stability().limit >= 0.0
