"""Damage outlasts what could do more of it, and all that is told of a body goes by it."""

from __future__ import annotations

import math
from typing import Any

import msgspec
import numpy as np
import pytest

import sim
from sim import Integrator, Pose, Scene, Simulation
from sim.scene.types import Damage
from tests.sim.builders import built, row
from tests.sim.test_damage import bent, flung, fragile

REPLACE = msgspec.structs.replace


def without_limits(scene: Scene) -> Scene:
    """The scene with nothing that could still break or yield."""
    return REPLACE(
        scene,
        linear_springs=tuple(
            REPLACE(s, strength=None, yield_force=None, hardening=0.0) for s in scene.linear_springs
        ),
        angular_springs=tuple(REPLACE(j, yield_torque=None) for j in scene.angular_springs),
    )


def test_damage_stays_when_the_last_strength_is_taken_away() -> None:
    simulation = Simulation(fragile())
    simulation.advance(0.3)
    before = simulation.damage
    assert before is not None and before.broken and any(before.set_lengths) and any(before.set_angles)
    scene = without_limits(simulation.scene)
    simulation.replace(scene)
    assert simulation.damage == before
    moment = simulation.capture()
    # A moment, a pose, and another simulation of the same scene take it over, too.
    restored, taken, fresh = Simulation(scene), Simulation(scene), Simulation(scene)
    assert fresh.damage is None
    restored.restore(moment)
    taken.take_state(simulation)
    posed = Simulation(REPLACE(scene, pose=simulation.pose()))
    for each in (restored, taken, posed):
        assert each.damage == before
        each.advance(0.05)
    simulation.advance(0.05)
    for each in (restored, taken, posed):
        assert np.abs(each.positions - simulation.positions).max() <= 1e-6
    assert simulation.damage == before
    simulation.reset()
    assert simulation.damage is None
    fresh.advance(0.01)
    simulation.advance(0.01)
    assert np.abs(fresh.positions - simulation.positions).max() <= 1e-6


def test_taking_away_the_last_strength_changes_no_speed() -> None:
    # A spring that has broken under load would throw the mass if it healed.
    simulation = Simulation(flung(strength=20_000.0))
    simulation.advance(0.1)
    speed = float(np.hypot(*simulation.velocities[1]))
    simulation.replace(without_limits(simulation.scene))
    simulation.advance(0.05)
    assert float(np.hypot(*simulation.velocities[1])) == pytest.approx(speed, rel=1e-9)


def hung(**spring: Any) -> Scene:
    """A mass of 1 kg between two held ones, on two springs of 10 px."""
    return built(
        row(3), stiffness=1000.0, damping=5.0, spring=spring, held=(0, 2), gravity=(0.0, 500.0),
        integrator=Integrator(method="symplectic_euler", dt=1e-3),
    )  # fmt: skip


def with_damage(scene: Scene, damage: Damage) -> Scene:
    places = tuple(mass.position for mass in scene.masses)
    return REPLACE(scene, pose=Pose(positions=places, velocities=((0.0, 0.0),) * len(places), damage=damage))


def test_equilibrium_vibrations_and_tuning_go_by_the_damage_of_the_pose() -> None:
    broken = with_damage(hung(strength=1e6), Damage(broken=(1,)))
    pose = sim.equilibrium(broken)
    # It hangs on the one that is left, which 500 stretch by half a px.
    assert pose.positions[1] == pytest.approx((0.0, 10.5), abs=1e-6)
    assert pose.damage == Damage(broken=(1,))
    resting = REPLACE(broken, pose=pose)
    slow, fast = sim.vibrations(resting, 2).frequencies
    assert slow == pytest.approx(math.sqrt(500.0 / 10.5), rel=1e-6)  # a pendulum
    assert fast == pytest.approx(math.sqrt(1000.0), rel=1e-6)
    told = sim.tuning(broken)
    assert told.fastest is not None and told.sag == pytest.approx(10.5)
    assert told.fastest.frequency == pytest.approx(math.sqrt(1000.0) / math.tau, rel=1e-3)
    assert told.fastest.damping_ratio == pytest.approx(5.0 / (2.0 * math.sqrt(1000.0)), rel=1e-2)
    assert told.springs.frequency[1] == 0.0 and told.springs.frequency[0] > 0.0
    # Yielding, too: 3 px longer.
    longer = sim.equilibrium(with_damage(hung(yield_force=1e6), Damage(set_lengths=(3.0, 3.0))))
    plain = sim.equilibrium(
        REPLACE(hung(), linear_springs=tuple(REPLACE(s, rest_length=13.0) for s in hung().linear_springs))
    )
    assert np.array(longer.positions) == pytest.approx(np.array(plain.positions), abs=1e-6)


def test_make_stable_lowers_nothing_for_a_broken_spring() -> None:
    scene = hung(strength=1e12)
    stiff = (scene.linear_springs[0], REPLACE(scene.linear_springs[1], stiffness=1e9))
    scene = REPLACE(scene, linear_springs=stiff)
    assert sim.make_stable(scene).linear_springs[1].stiffness < 1e7
    broken = with_damage(scene, Damage(broken=(1,)))
    assert sim.make_stable(broken) is broken
    with pytest.raises(sim.InputError, match="spring 1 is broken, so it cannot vibrate"):
        sim.damp_vibration(broken, spring=1)


def test_an_equilibrium_that_would_break_or_yield_something_says_so() -> None:
    load = r"spring 0 and 1 more would {} in the pose at rest: 701\.9 kg px/s² is more than its {} of 600"
    for limit, words in (("strength", ("break", "strength")), ("yield_force", ("yield", "yield force"))):
        with pytest.warns(UserWarning, match=load.format(*words)):
            sim.equilibrium(hung(**{limit: 600.0}))
        notes = sim.tuning(hung(**{limit: 600.0})).notes
        assert any(words[1] + " of 600" in note for note in notes)
        assert not any(words[1] in note for note in sim.tuning(hung(**{limit: 710.0})).notes)
    scene = REPLACE(bent("conservative", yield_torque=1e3), gravity=(0.0, 2000.0))
    with pytest.warns(
        UserWarning, match=r"joint 0 would yield .* kg px²/s² is more than its yield torque of"
    ):
        sim.equilibrium(scene)
