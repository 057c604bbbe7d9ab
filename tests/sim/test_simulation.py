"""`Simulation`: stepping, time, what it hands out, and going on with another scene."""

from __future__ import annotations

import hashlib
import math
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from msgspec.structs import replace

import sim
from sim import Anchor, InputError, Simulation
from tests.sim.builders import askew, chain, row, undisturbed
from tests.sim.changes import step_all
from tests.sim.inside import same_state

# ------------------------------------------------------------------------- stepping
TRAJECTORY = """
import hashlib, sim
digest = hashlib.sha256()
for preset in ("tutorial-3.3", "hair-tuft"):
    simulation = sim.Simulation(sim.load_scene(preset))
    simulation.keys = {"right", "up"}
    for i in range(50):
        simulation.lead(0, (300.0 + 5.0 * i, 160.0))
        simulation.step(7)
        digest.update(simulation.positions.tobytes() + simulation.velocities.tobytes())
    simulation.stability()
print(digest.hexdigest())
"""


def test_a_run_is_the_same_bit_for_bit_in_every_process() -> None:
    # Not in this one, in which other tests may have compiled parts of kernels anew.
    words, root = [sys.executable, "-c", TRAJECTORY], Path(sim.__file__).parent.parent
    processes = [subprocess.Popen(words, stdout=subprocess.PIPE, text=True, cwd=root) for _ in range(2)]
    one, other = (process.communicate()[0] for process in processes)
    assert one == other
    assert len(one.strip()) == len(hashlib.sha256().hexdigest())


def test_no_steps_and_wrong_numbers_of_steps(rope: Simulation) -> None:
    assert rope.step(0) == 0
    with pytest.raises(InputError, match="step"):
        rope.step(-1)


def test_a_lead_waits_for_the_next_step_that_is_done(rope: Simulation) -> None:
    rope.lead(0, (310.0, 170.0))
    rope.step(0)
    rope.advance(0.001)
    assert tuple(rope.positions[0]) != (310.0, 170.0)
    rope.step()
    assert tuple(rope.positions[0]) == (310.0, 170.0)


def test_advance_keeps_what_is_left_over(rope: Simulation) -> None:
    pieces = [0.0001, 0.0033, 0.0, 0.0299, 0.0174, 0.0006, 0.0487]
    assert sum(pieces) == pytest.approx(0.1)
    done = [rope.advance(seconds) for seconds in pieces]
    assert sum(done) == 40
    assert done[:4] == [0, 1, 0, 12]
    assert rope.time == pytest.approx(0.1)
    assert same_state(rope, undisturbed(40))


def test_advance_by_exact_multiples_is_not_short_of_a_step(rope: Simulation) -> None:
    assert [rope.advance(0.0025 * n) for n in (1, 3, 10, 12, 400)] == [1, 3, 10, 12, 400]
    # In floating point, 0.3 / 0.1 is a hair less than 3.
    assert Simulation(chain(row(2), stiffness=1.0), dt=0.1).advance(0.3) == 3


@pytest.mark.parametrize("seconds", [-0.1, math.nan, math.inf])
def test_advance_refuses_what_is_no_duration(rope: Simulation, seconds: float) -> None:
    with pytest.raises(InputError, match="advance"):
        rope.advance(seconds)
    assert rope.step_count == 0


def test_dt_of_the_caller_overrides_that_of_every_scene() -> None:
    simulation = Simulation(askew(), dt=0.001, integrator="symplectic_euler")
    assert simulation.dt == simulation.scene.integrator.dt == 0.001
    simulation.replace(sim.load_scene("ring"))
    assert simulation.dt == 0.001
    with pytest.raises(sim.SceneError, match=r"integrator\.dt"):
        Simulation(askew(), dt=2.0)
    with pytest.raises(sim.SceneError, match=r"integrator\.method"):
        Simulation(askew(), integrator="leapfrog")


# ------------------------------------------------------------------------- what is handed out
def test_positions_and_velocities_are_copies(rope: Simulation) -> None:
    rope.positions[:] = 0.0
    rope.velocities[:] = 1e5
    rope.step(10)
    assert same_state(rope, undisturbed(10))
    before = rope.positions
    kept = before.copy()
    rope.step()
    assert np.array_equal(before, kept)


def test_a_pose_carries_the_state_to_another_simulation(rope: Simulation) -> None:
    rope.step(100)
    other = Simulation(replace(rope.scene, pose=rope.pose()))
    assert same_state(rope, other)
    step_all(50, rope, other)
    assert same_state(rope, other)


# ------------------------------------------------------------------------- reset and replace
def test_reset_starts_over(rope: Simulation) -> None:
    start = rope.positions
    rope.keys = {"up", "right"}
    rope.move(0, (0.0, 0.0))
    rope.advance(0.1234)
    rope.lead(0, (50.0, 50.0))
    rope.keys = set()
    rope.reset()
    assert np.array_equal(rope.positions, start)
    assert not rope.velocities.any()
    assert (rope.time, rope.step_count, rope.rest_length_scale) == (0.0, 0, 1.0)
    assert not rope.rest_angles.any()
    # Neither the target nor the fraction of a step that was owed is left.
    assert rope.advance(0.0024) == 0
    rope.step(20)
    assert same_state(rope, undisturbed(20))


def test_replace_goes_on_where_the_topology_is_the_same(rope: Simulation) -> None:
    rope.grab(4)
    rope.step(100)
    rope.advance(0.001)
    before, speed = rope.positions, rope.velocities
    rope.replace(sim.set_value(sim.set_value(rope.scene, "gravity", 500.0), "dt", 0.001))
    assert np.array_equal(rope.positions, before)
    assert np.array_equal(rope.velocities, speed)
    assert (rope.time, rope.step_count, rope.dt) == (pytest.approx(0.25), 100, 0.001)
    # The grab and the owed millisecond are still there.
    assert rope.advance(0.0) == 1
    assert rope.time == pytest.approx(0.251)
    assert np.array_equal(rope.positions[4], before[4])
    assert rope.scene.gravity == (0.0, 500.0)


def test_replace_takes_hold_of_new_anchors(rope: Simulation) -> None:
    rope.step(50)
    scene = replace(rope.scene, bodies=(), anchors=(Anchor(mass=11),))
    rope.replace(scene)
    assert not rope.velocities[11].any()
    before = rope.positions
    rope.step(20)
    assert np.array_equal(rope.positions[11], before[11])
    assert not np.array_equal(rope.positions[0], before[0])


@pytest.mark.parametrize("part", ["linear_springs", "angular_springs"])
def test_replace_restarts_where_springs_join_something_else(rope: Simulation, part: str) -> None:
    rope.step(100)
    first, *others = getattr(rope.scene, part)
    turned = (replace(first, a=first.b, b=first.a), *others)
    scene = replace(rope.scene, bodies=(), **{part: turned})
    rope.replace(scene)
    assert rope.step_count == 0
    assert same_state(rope, Simulation(scene))


def test_replace_restarts_where_the_topology_is_another(rope: Simulation) -> None:
    rope.grab(4)
    rope.step(100)
    scene = replace(sim.set_value(rope.scene, "masses", 9), pose=None)
    rope.replace(scene)
    fresh = Simulation(scene)
    assert (rope.time, rope.step_count) == (0.0, 0)
    assert same_state(rope, fresh)
    step_all(30, rope, fresh)
    assert same_state(rope, fresh)


def test_replace_with_an_invalid_scene_changes_nothing(rope: Simulation) -> None:
    rope.step(10)
    other = Simulation(askew())
    other.step(10)
    with pytest.raises(sim.SceneError, match="air_friction"):
        rope.replace(replace(rope.scene, air_friction=-1.0))
    step_all(10, rope, other)
    assert same_state(rope, other)
