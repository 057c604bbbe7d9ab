"""Springs that break and yield, and joints that yield, by every method."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec.structs import replace

import sim
from sim import Anchor, Integrator, Scene, Simulation
from sim.scene.surroundings import Contact
from sim.scene.types import Circle, Damage, ForceLaw, Method
from sim.solve.registry import METHODS
from tests.amount import examples
from tests.sim.bodies import LAWS, body
from tests.sim.builders import built, row
from tests.sim.changes import after, apart, by, posed, step_all, with_joints, with_springs
from tests.sim.checks import known, order
from tests.sim.inside import solver_of

ADAPTIVE = [name for name, method in METHODS.items() if method.adaptive]


def flung(speed: float = 1000.0, method: Method = "auto", **spring: Any) -> Scene:
    """A mass of 1 kg that flies away from a held one, at the end of a spring of 1000 kg/s² at rest."""
    return built(
        [(0.0, 0.0), (100.0, 0.0)], velocities=[(0.0, 0.0), (speed, 0.0)], stiffness=1000.0,
        spring=spring, held=(0,), integrator=Integrator(method=method, dt=1e-3, tolerance=1e-3),
    )  # fmt: skip


def bent(law: ForceLaw, method: Method = "auto", speed: float = 3000.0, **joint: Any) -> Scene:
    """A held spring and a free one in line, whose joint is bent by the speed of the last mass."""
    return built(
        row(3, 100.0), velocities=[(0.0, 0.0), (0.0, 0.0), (0.0, speed)], stiffness=1e6, damping=10.0,
        joint={"stiffness": 1000.0, **joint}, held=(0, 1), force_law=law,
        integrator=Integrator(method=method, dt=1e-4, tolerance=1e-3),
    )  # fmt: skip


# ------------------------------------------------------------------------- breaking
@pytest.mark.parametrize("method", METHODS)
def test_a_spring_breaks_at_its_strength(method: Method) -> None:
    simulation = after(flung(method=method, strength=20_000.0), 0.5)
    assert simulation.damage == Damage(broken=(0,), set_lengths=(0.0,), hardened=(0.0,))
    # It flies on with what the spring has not taken: strength² / 2k.
    taken = 20_000.0**2 / 2000.0
    tolerated = 1e-5 if METHODS[method].adaptive else 0.1
    balance = simulation.energy()
    assert balance.broken == pytest.approx(-taken, rel=3e-3 if METHODS[method].adaptive else 0.1)
    assert balance.kinetic == pytest.approx(500_000.0 + balance.broken, rel=tolerated)
    assert balance.linear == 0.0
    assert abs(balance.residual) <= (1e-5 if METHODS[method].adaptive else 0.05) * 500_000.0


@pytest.mark.parametrize("method", METHODS)
def test_a_spring_that_is_strong_enough_does_not_break(method: Method) -> None:
    # Its largest force is sqrt(2 k E) = 31623.
    whole, plain = after(flung(method=method, strength=33_000.0), 0.5), after(flung(method=method), 0.5)
    assert whole.damage is None
    assert apart(whole, plain) <= 0.05


@pytest.mark.parametrize("law", LAWS)
def test_joints_break_with_their_springs(law: ForceLaw) -> None:
    scene = by(body("girder", law, 2), "rodas5p", dt=1e-3, tolerance=1e-6)
    broken = after(with_springs(scene, strength=lambda s, _: 1e12 if s else 1.0), 0.1)
    assert known(broken.damage).broken == (0,)
    assert abs(broken.energy().residual) <= 1e-3 * broken.energy().kinetic
    # From where it broke it moves as a body that never had them. A spring without stiffness is still one.
    gone = [j for j, joint in enumerate(scene.angular_springs) if 0 in (joint.a, joint.b)]
    assert gone

    def without(some: list[int]) -> dict[str, Any]:
        return {
            field: lambda i, part, field=field: 0.0 if i in some else getattr(part, field)
            for field in ("stiffness", "damping")
        }

    never = with_joints(with_springs(scene, strength=1e12, **without([0])), **without(gone))
    other = Simulation(replace(never, pose=replace(broken.pose(), damage=None)))
    for simulation in (broken, other):
        simulation.advance(0.05)
    assert apart(broken, other) <= 1e-2


# ------------------------------------------------------------------------- yielding
@pytest.mark.parametrize("hardening", [0.0, 700.0])
@pytest.mark.parametrize("method", METHODS)
def test_a_spring_yields_by_what_its_energy_says(method: Method, hardening: float) -> None:
    # Out, and not so far back that it could yield again.
    simulation = after(flung(method=method, yield_force=10_000.0, hardening=hardening), 0.12)
    damage, balance = known(simulation.damage), simulation.energy()
    assert not damage.broken
    # At the turning point all energy is elastic, (Y + H s)² / 2k, or went into yielding, Y s + H s² / 2.
    a, b, c = 0.5 * hardening * (1.0 + hardening / 1000.0), 10_000.0 * (1.0 + hardening / 1000.0), -450_000.0
    way = -c / b if hardening == 0.0 else (-b + math.sqrt(b * b - 4.0 * a * c)) / (2.0 * a)
    tolerated = 0.005 if METHODS[method].adaptive else 0.04
    assert damage.set_lengths[0] == pytest.approx(way, rel=tolerated)
    assert damage.hardened[0] == pytest.approx(hardening * damage.set_lengths[0], rel=1e-9)
    lost = 10_000.0 * way + 0.5 * hardening * way * way
    assert balance.plastic == pytest.approx(-lost, rel=tolerated)
    assert abs(balance.residual) <= 0.03 * 500_000.0


@pytest.mark.parametrize("method", ["velocity_verlet", "generalized_alpha", "rk4"])
def test_yielding_is_of_second_order_and_its_balance_is_too(method: Method) -> None:
    # The mean over many places in a step at which yielding begins, as errors depend on that.
    steps, errors, residuals = (8e-4, 4e-4, 2e-4, 1e-4), [], []
    for dt in steps:
        off, left = [], []
        for k in range(5):
            force = 10_000.0 + 200.0 * k
            simulation = after(by(flung(yield_force=force), method, dt=dt), 0.12)
            way = (1e9 - force**2) / 2000.0 / force
            off.append(abs(known(simulation.damage).set_lengths[0] - way))
            left.append(abs(simulation.energy().residual))
        errors.append(np.mean(off))
        residuals.append(np.mean(left))
    assert 1.8 <= order(steps, errors) <= (3.2 if method == "rk4" else 2.3)
    assert order(steps, residuals) >= 1.8


@pytest.mark.parametrize("method", METHODS)
def test_what_is_beyond_its_limit_where_it_is_put_yields_or_breaks_at_once(method: Method) -> None:
    # Stretched by 20 px, of which 10 are elastic; from there it swings as a spring of 110 px.
    scene = flung(speed=0.0, method=method, yield_force=10_000.0)
    far = (scene.masses[0], replace(scene.masses[1], position=(120.0, 0.0)))
    simulation = after(replace(scene, masses=far), 0.05)
    assert known(simulation.damage).set_lengths[0] == pytest.approx(10.0, rel=1e-9)
    # Of an energy of 200 000, 50 000 is left.
    balance = simulation.energy()
    assert balance.plastic == pytest.approx(-150_000.0, rel=1e-9)
    assert abs(balance.residual) <= (0.05 if METHODS[method].order == 1 else 2e-3) * 50_000.0
    broken = after(replace(scene, masses=far, linear_springs=flung(strength=1e4).linear_springs), 0.05)
    assert broken.positions[1, 0] == pytest.approx(120.0, abs=1e-9)


@pytest.mark.parametrize("method", ADAPTIVE)
def test_a_spring_that_cannot_yield_any_further_does_not_shorten_steps(method: Method) -> None:
    # Squeezed to the least rest length there is, by a mass that comes back from the other side.
    simulation = Simulation(by(flung(speed=-1500.0, yield_force=100.0), method, dt=0.1, tolerance=0.1))
    assert simulation.step(attempts=20_000) == 1
    assert -99.0 <= known(simulation.damage).set_lengths[0] <= 1e4


@pytest.mark.parametrize("part", ["springs", "joints"])
@pytest.mark.parametrize("method", ADAPTIVE)
def test_errors_fall_with_the_tolerance_where_a_led_body_yields(method: Method, part: str) -> None:
    of_springs: dict[str, Any] = {"yield_force": 4000.0} if part == "springs" else {}
    of_joints: dict[str, Any] = {"yield_torque": 1e5} if part == "joints" else {}
    scene = built(
        row(4, 30.0), stiffness=3e4, damping=3.0, spring=of_springs,
        joint={"stiffness": 1000.0, "damping": 2.0, **of_joints}, gravity=(0.0, 1000.0),
        anchors=(Anchor(mass=0, circle=Circle(radius=60.0, frequency=1.5, ramp=0.1)),),
    )  # fmt: skip
    runs: list[tuple[Method, float]] = [("adams", 1e-8), (method, 0.01), (method, 1e-4)]
    ends = []
    for one, tolerance in runs:
        simulation = Simulation(by(scene, one, dt=0.5, tolerance=tolerance))
        assert simulation.step(attempts=100_000) == 1
        damage = known(simulation.damage)
        assert any(damage.set_lengths if part == "springs" else damage.set_angles)
        ends.append(simulation.positions)
    assert np.abs(ends[1] - ends[0]).max() <= 2.0 * 0.01
    assert np.abs(ends[2] - ends[0]).max() <= 3.0 * 1e-4


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("method", METHODS)
def test_a_joint_yields_and_stays_bent(method: Method, law: ForceLaw) -> None:
    # At 3000 px/s its energy is 4.5e6; its torque at a right angle would be 1e7.
    simulation = after(bent(law, method, yield_torque=2e6, damping=2.0), 0.2)
    damage, balance = known(simulation.damage), simulation.energy()
    # Its elastic deflection is asin(0.2), or 0.2 under the law of the angle; the rest of the way is for good.
    assert abs(damage.set_angles[0]) > 10.0
    assert simulation.rest_angles[0] == pytest.approx(damage.set_angles[0])
    assert balance.plastic < -1e5
    tolerated = 0.1 if METHODS[method].order == 1 else 0.02
    assert abs(balance.residual) <= tolerated * 4.5e6
    weaker = after(bent(law, method, yield_torque=1e6, damping=2.0), 0.2)
    assert abs(known(weaker.damage).set_angles[0]) > abs(damage.set_angles[0])


@pytest.mark.parametrize("law", LAWS)
def test_a_joint_that_is_led_round_and_round_yields_behind_it(law: ForceLaw) -> None:
    """And goes on from a moment as if it had never stopped."""
    simulation = Simulation(bent(law, "symplectic_euler", speed=2e4, yield_torque=7e6))
    simulation.step(80)
    turned, before = 0.0, float(simulation.angles[0])
    while turned < 900.0:
        simulation.step(20)
        angle = float(simulation.angles[0])
        turned, before = turned + math.remainder(angle - before, 360.0), angle
        (set_angle,) = known(simulation.damage).set_angles
        assert 20.0 < math.remainder(angle - set_angle, 360.0) < 60.0
        sim.validate(replace(simulation.scene, pose=simulation.pose()))  # which a file may have
    other = Simulation(simulation.scene)
    other.restore(simulation.capture())
    step_all(100, simulation, other)
    assert other.positions == pytest.approx(simulation.positions, abs=1e-9)


def test_a_joint_that_does_not_reach_its_yield_torque_does_not_yield() -> None:
    assert after(bent("conservative", yield_torque=9.99e6, speed=1000.0), 1.0).damage is None


@pytest.mark.parametrize("law", LAWS)
def test_a_joint_that_never_can_does_not_yield_however_far_it_is_led(law: ForceLaw) -> None:
    # Its torque is 1e7 at most; 175 degrees are more than where a sine law is the strongest.
    simulation = Simulation(bent(law, yield_torque=1e15))
    x, y = simulation.positions[1]
    turn = math.radians(175.0)
    simulation.grab(2)
    simulation.move(2, (x + 100.0 * math.cos(turn), y + 100.0 * math.sin(turn)))
    simulation.step(5)
    assert abs(simulation.angles[0]) > 100.0
    assert simulation.damage is None


# ------------------------------------------------------------------------- what is kept
def fragile(seed: int = 0, method: Method = "auto") -> Scene:
    """A body of which some springs break, and some yield, soon."""
    scene = with_springs(
        with_joints(body("girder", seed=seed, air=0.0), yield_torque=3e5),
        strength=lambda s, _: 6e4 if s % 3 else None,
        yield_force=lambda s, _: 2e4 if s % 2 else None,
        hardening=lambda s, _: 10.0 * s * (s % 2),
    )
    return by(scene, method, dt=1e-3, tolerance=0.01)


def test_a_saved_pose_has_the_damage_and_settings_keep_it(tmp_path: Any) -> None:
    simulation = after(fragile(), 0.3)
    saved = replace(simulation.scene, pose=simulation.pose())
    sim.save_scene(saved, tmp_path / "worn.json")
    opened = Simulation(sim.load_scene(tmp_path / "worn.json"))
    assert opened.damage == simulation.damage
    assert np.array_equal(
        solver_of(opened).system.body.stiffness, solver_of(simulation).system.body.stiffness
    )
    simulation.replace(replace(simulation.scene, gravity=(0.0, 100.0)))
    assert simulation.damage == opened.damage
    other = Simulation(simulation.scene)
    other.take_state(simulation)
    assert other.damage == simulation.damage


@given(seed=st.integers(0, 10_000), method=st.sampled_from(sorted(METHODS)), strength=st.floats(0.0, 1e5))
@settings(max_examples=examples(30))
def test_whatever_breaks_and_yields_numbers_stay_good(seed: int, method: Method, strength: float) -> None:
    scene = with_springs(fragile(seed % 7), strength=strength, yield_force=0.3 * strength)
    simulation = after(by(scene, method, dt=1e-3, tolerance=1.0), 0.0)
    for _ in range(5):
        simulation.step(20, attempts=2000)
        assert np.isfinite(simulation.positions).all()
        assert np.isfinite(simulation.energy().residual)
    damage = simulation.damage
    assert damage is None or list(damage.broken) == sorted(set(damage.broken))


@pytest.mark.parametrize("method", METHODS)
def test_the_energy_of_what_touches_a_spring_goes_with_it(method: Method) -> None:
    # A mass is pressed against a spring that is stretched beyond its strength, and breaks in the first step.
    scene = built(
        [(-100.0, 0.0), (100.0, 0.0), (0.0, -5.0), (0.0, -105.0)], [(0, 1), (2, 3)],
        stiffness=10.0, rest_length=(190.0, 100.0), held=(0, 1),
        contact=Contact(distance=12.0, stiffness=300.0, friction=0.0),
        integrator=Integrator(method=method, dt=1e-5, tolerance=1e-6),
    )  # fmt: skip
    simulation = Simulation(with_springs(scene, strength=[50.0, None]))
    before = simulation.energy()
    assert before.contact == pytest.approx(300.0 * 7.0**3 / 3.0)
    simulation.step(20)
    balance = simulation.energy()
    assert known(simulation.damage).broken == (0,)
    assert balance.contact == 0.0
    assert balance.broken == pytest.approx(-before.contact - 500.0, rel=1e-3)
    assert abs(balance.residual) <= 1e-3 * before.contact


@pytest.mark.parametrize("method", ADAPTIVE)
def test_the_moment_of_a_break_is_found_to_the_tolerance(method: Method) -> None:
    """x = v sin(w t) / w until k x is the strength, and a free flight from there."""
    omega, speed = math.sqrt(1000.0), 1000.0
    turns = math.asin(omega * 20_000.0 / (1000.0 * speed))
    for tolerance, dt in ((0.1, 0.1), (1e-2, 0.1), (1e-3, 0.1), (1e-3, 1e-3)):  # whatever the frames
        simulation = Simulation(by(flung(strength=20_000.0), method, dt=dt, tolerance=tolerance))
        simulation.step(round(1.0 / dt))
        flown = 20.0 + speed * math.cos(turns) * (1.0 - turns / omega)
        assert simulation.positions[1, 0] - 100.0 == pytest.approx(flown, abs=10.0 * tolerance)


# ------------------------------------------------------------------------- what outlasts its limits
def without_limits(scene: Scene) -> Scene:
    """The scene with nothing that could still break or yield."""
    endless = with_springs(scene, strength=None, yield_force=None, hardening=0.0)
    return with_joints(endless, yield_torque=None)


def test_damage_stays_when_the_last_strength_is_taken_away() -> None:
    simulation = after(fragile(), 0.3)
    before = known(simulation.damage)
    assert before.broken and any(before.set_lengths) and any(before.set_angles)
    scene = without_limits(simulation.scene)
    simulation.replace(scene)
    assert simulation.damage == before
    moment = simulation.capture()
    # A moment, a pose, and another simulation of the same scene take it over, too.
    restored, taken, fresh = Simulation(scene), Simulation(scene), Simulation(scene)
    assert fresh.damage is None
    restored.restore(moment)
    taken.take_state(simulation)
    posed = Simulation(replace(scene, pose=simulation.pose()))
    for each in (restored, taken, posed):
        assert each.damage == before
        each.advance(0.05)
    simulation.advance(0.05)
    assert max(apart(each, simulation) for each in (restored, taken, posed)) <= 1e-6
    assert simulation.damage == before
    simulation.reset()
    assert simulation.damage is None
    fresh.advance(0.01)
    simulation.advance(0.01)
    assert apart(fresh, simulation) <= 1e-6


def test_taking_away_the_last_strength_changes_no_speed() -> None:
    # A spring that has broken under load would throw the mass if it healed.
    simulation = after(flung(strength=20_000.0), 0.1)
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


def test_equilibrium_vibrations_and_tuning_go_by_the_damage_of_the_pose() -> None:
    broken = posed(hung(strength=1e6), damage=Damage(broken=(1,)))
    pose = sim.equilibrium(broken)
    # It hangs on the one that is left, which 500 stretch by half a px.
    assert pose.positions[1] == pytest.approx((0.0, 10.5), abs=1e-6)
    assert pose.damage == Damage(broken=(1,))
    resting = replace(broken, pose=pose)
    slow, fast = sim.vibrations(resting, 2).omega
    assert slow == pytest.approx(math.sqrt(500.0 / 10.5), rel=1e-6)  # a pendulum
    assert fast == pytest.approx(math.sqrt(1000.0), rel=1e-6)
    found = sim.tuning(broken)
    fastest = known(found.fastest)
    assert found.sag == pytest.approx(10.5)
    assert fastest.frequency == pytest.approx(math.sqrt(1000.0) / math.tau, rel=1e-3)
    assert fastest.damping_ratio == pytest.approx(5.0 / (2.0 * math.sqrt(1000.0)), rel=1e-2)
    assert found.springs.frequency[1] == 0.0 and found.springs.frequency[0] > 0.0
    # Yielding, too: 3 px longer.
    longer = sim.equilibrium(posed(hung(yield_force=1e6), damage=Damage(set_lengths=(3.0, 3.0))))
    plain = sim.equilibrium(with_springs(hung(), rest_length=13.0))
    assert np.array(longer.positions) == pytest.approx(np.array(plain.positions), abs=1e-6)


def test_make_stable_lowers_nothing_for_a_broken_spring() -> None:
    scene = with_springs(hung(strength=1e12), stiffness=[1000.0, 1e9])
    assert sim.make_stable(scene).linear_springs[1].stiffness < 1e7
    broken = posed(scene, damage=Damage(broken=(1,)))
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
    scene = replace(bent("conservative", yield_torque=1e3), gravity=(0.0, 2000.0))
    with pytest.warns(
        UserWarning, match=r"joint 0 would yield .* kg px²/s² is more than its yield torque of"
    ):
        sim.equilibrium(scene)
