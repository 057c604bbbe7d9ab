"""Springs that break and yield, and joints that yield, by every method."""

from __future__ import annotations

import math
from typing import Any

import msgspec
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import sim
from sim import Anchor, AngularSpring, Integrator, LinearSpring, Mass, Pose, Scene, SceneError, Simulation
from sim.body.damage import leaking
from sim.body.system import build_system, start_of
from sim.methods.registry import METHODS
from sim.physics import Physics
from sim.scene.surroundings import Contact
from sim.scene.types import Damage, ForceLaw, Method
from tests.sim.bodies import LAWS, body
from tests.sim.inside import same_state, solver_of

REPLACE = msgspec.structs.replace
ADAPTIVE = [name for name, method in METHODS.items() if method.adaptive]


def flung(speed: float = 1000.0, method: Method = "auto", **spring: Any) -> Scene:
    """A mass of 1 kg that flies away from a held one, at the end of a spring of 1000 kg/s² at rest."""
    return Scene(
        name="flung",
        masses=(Mass(position=(0.0, 0.0)), Mass(position=(100.0, 0.0), velocity=(speed, 0.0))),
        linear_springs=(LinearSpring(a=0, b=1, stiffness=1000.0, rest_length=100.0, **spring),),
        anchors=(Anchor(mass=0),),
        integrator=Integrator(method=method, dt=1e-3, tolerance=1e-3),
    )


def bent(law: ForceLaw, method: Method = "auto", speed: float = 3000.0, **joint: Any) -> Scene:
    """A held spring and a free one in line, whose joint is bent by the speed of the last mass."""
    return Scene(
        name="bent",
        masses=tuple(
            Mass(position=(100.0 * i, 0.0), velocity=(0.0, speed if i == 2 else 0.0)) for i in range(3)
        ),
        linear_springs=tuple(
            LinearSpring(a=i, b=i + 1, stiffness=1e6, rest_length=100.0, damping=10.0) for i in range(2)
        ),
        angular_springs=(AngularSpring(a=0, b=1, stiffness=1000.0, **joint),),
        anchors=(Anchor(mass=0), Anchor(mass=1)),
        force_law=law,
        integrator=Integrator(method=method, dt=1e-4, tolerance=1e-3),
    )


# ------------------------------------------------------------------------- breaking
@pytest.mark.parametrize("method", METHODS)
def test_a_spring_breaks_at_its_strength(method: Method) -> None:
    simulation = Simulation(flung(method=method, strength=20_000.0))
    simulation.energy()
    simulation.advance(0.5)
    assert simulation.damage == Damage(broken=(0,), set_lengths=(0.0,), hardened=(0.0,))
    # It flies on with what the spring has not taken: strength² / 2k.
    taken = 20_000.0**2 / 2000.0
    tolerated = 1e-5 if METHODS[method].adaptive else 0.1
    book = simulation.energy()
    assert book.broken == pytest.approx(-taken, rel=3e-3 if METHODS[method].adaptive else 0.1)
    assert book.kinetic == pytest.approx(500_000.0 + book.broken, rel=tolerated)
    assert book.linear == 0.0
    assert abs(book.residual) <= (1e-5 if METHODS[method].adaptive else 0.05) * 500_000.0


@pytest.mark.parametrize("method", METHODS)
def test_a_spring_that_is_strong_enough_does_not_break(method: Method) -> None:
    # Its largest force is sqrt(2 k E) = 31623.
    whole, plain = Simulation(flung(method=method, strength=33_000.0)), Simulation(flung(method=method))
    for simulation in (whole, plain):
        simulation.advance(0.5)
    assert whole.damage is None
    assert np.abs(whole.positions - plain.positions).max() <= 0.05


@pytest.mark.parametrize("method", ADAPTIVE)
def test_the_moment_of_breaking_is_found_to_the_tolerance(method: Method) -> None:
    # x = v/w sin(w t) reaches 20 px; from then on it goes straight on.
    w = math.sqrt(1000.0)
    t = math.asin(20.0 * w / 1000.0) / w
    expected = 120.0 + math.sqrt(500_000.0 * 2.0 - 400_000.0) * (0.3 - t)
    for dt in (1e-3, 0.05):  # the same, whatever the frames
        scene = flung(method=method, strength=20_000.0)
        simulation = Simulation(REPLACE(scene, integrator=Integrator(method=method, dt=dt, tolerance=1e-3)))
        simulation.step(round(0.3 / dt))
        assert simulation.time == pytest.approx(0.3)
        assert simulation.positions[1, 0] == pytest.approx(
            expected, abs=0.2
        )  # as its strength, to a thousandth


@pytest.mark.parametrize("law", LAWS)
def test_joints_break_with_their_springs(law: ForceLaw) -> None:
    scene = body("girder", law, 2)
    strong = tuple(REPLACE(spring, strength=1e12) for spring in scene.linear_springs)
    weak = (REPLACE(strong[0], strength=1.0), *strong[1:])
    integrator = Integrator(method="rodas5p", dt=1e-3, tolerance=1e-6)
    broken = Simulation(REPLACE(scene, linear_springs=weak, integrator=integrator))
    broken.energy()
    broken.advance(0.1)
    assert broken.damage is not None and broken.damage.broken == (0,)
    assert abs(broken.energy().residual) <= 1e-3 * broken.energy().kinetic
    # From where it broke it moves as a body that never had them. A spring without stiffness is still one.
    gone = [j for j, joint in enumerate(scene.angular_springs) if 0 in (joint.a, joint.b)]
    assert gone
    without = REPLACE(
        scene,
        linear_springs=(REPLACE(strong[0], stiffness=0.0, damping=0.0), *strong[1:]),
        angular_springs=tuple(
            REPLACE(joint, stiffness=0.0, damping=0.0) if j in gone else joint
            for j, joint in enumerate(scene.angular_springs)
        ),
        integrator=integrator,
        pose=REPLACE(broken.pose(), damage=None),
    )
    other = Simulation(without)
    for simulation in (broken, other):
        simulation.advance(0.05)
    assert np.abs(broken.positions - other.positions).max() <= 1e-2


# ------------------------------------------------------------------------- yielding
@pytest.mark.parametrize("hardening", [0.0, 700.0])
@pytest.mark.parametrize("method", METHODS)
def test_a_spring_yields_by_what_its_energy_says(method: Method, hardening: float) -> None:
    simulation = Simulation(flung(method=method, yield_force=10_000.0, hardening=hardening))
    simulation.energy()
    simulation.advance(0.12)  # out, and not so far back that it could yield again
    damage, book = simulation.damage, simulation.energy()
    assert damage is not None and not damage.broken
    # At the turning point all energy is elastic, (Y + H s)² / 2k, or went into yielding, Y s + H s² / 2.
    a, b, c = 0.5 * hardening * (1.0 + hardening / 1000.0), 10_000.0 * (1.0 + hardening / 1000.0), -450_000.0
    way = -c / b if hardening == 0.0 else (-b + math.sqrt(b * b - 4.0 * a * c)) / (2.0 * a)
    tolerated = 0.005 if METHODS[method].adaptive else 0.04
    assert damage.set_lengths[0] == pytest.approx(way, rel=tolerated)
    assert damage.hardened[0] == pytest.approx(hardening * damage.set_lengths[0], rel=1e-9)
    lost = 10_000.0 * way + 0.5 * hardening * way * way
    assert book.plastic == pytest.approx(-lost, rel=tolerated)
    assert abs(book.residual) <= 0.03 * 500_000.0


def test_yielding_is_of_first_order_and_its_books_are_of_the_methods() -> None:
    ways, residuals = [], []
    for dt in (4e-4, 2e-4, 1e-4):
        scene = flung(method="rk4", yield_force=10_000.0)
        scene = REPLACE(scene, integrator=Integrator(method="rk4", dt=dt))
        simulation = Simulation(scene)
        simulation.energy()
        simulation.advance(0.12)
        assert simulation.damage is not None
        ways.append(abs(simulation.damage.set_lengths[0] - 45.0))
        residuals.append(abs(simulation.energy().residual))
    assert 1.6 <= ways[0] / ways[1] <= 2.4 and 1.6 <= ways[1] / ways[2] <= 2.4
    assert residuals[2] <= residuals[0] / 16.0


def test_a_squeezed_spring_keeps_some_length() -> None:
    scene = flung(speed=-1500.0, yield_force=100.0)
    simulation = Simulation(REPLACE(scene, integrator=Integrator(method="auto", dt=1e-3, tolerance=0.1)))
    simulation.advance(0.5)
    assert simulation.damage is not None
    assert -99.0 <= simulation.damage.set_lengths[0] <= 1e4
    assert np.isfinite(simulation.positions).all()


@pytest.mark.parametrize("method", ADAPTIVE)
def test_a_spring_that_cannot_yield_any_further_does_not_shorten_steps(method: Method) -> None:
    # Squeezed to the least rest length there is, by a mass that comes back from the other side.
    scene = flung(speed=-1500.0, yield_force=100.0)
    simulation = Simulation(REPLACE(scene, integrator=Integrator(method=method, dt=0.1, tolerance=0.1)))
    assert simulation.step(attempts=20_000) == 1


@pytest.mark.parametrize("method", ADAPTIVE)
def test_errors_of_a_yielding_joint_fall_with_the_tolerance(method: Method) -> None:
    ends = []
    for tolerance in (0.1, 0.01, 2e-3):
        scene = bent("conservative", yield_torque=2e6, damping=2.0)
        scene = REPLACE(scene, integrator=Integrator(method=method, dt=0.01, tolerance=tolerance))
        simulation = Simulation(scene)
        simulation.step(15)
        ends.append(simulation.positions[2])
    assert np.hypot(*(ends[0] - ends[2])) <= 10.0 * 0.1
    assert np.hypot(*(ends[1] - ends[2])) <= 10.0 * 0.01


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("method", METHODS)
def test_a_joint_yields_and_stays_bent(method: Method, law: ForceLaw) -> None:
    # At 3000 px/s its energy is 4.5e6; its torque at a right angle would be 1e7.
    scene = bent(law, method, yield_torque=2e6, damping=2.0)
    simulation = Simulation(scene)
    simulation.energy()
    simulation.advance(1.0)
    damage, book = simulation.damage, simulation.energy()
    assert damage is not None
    # Its elastic deflection is asin(0.2), or 0.2 under the law of the angle; the rest of the way is for good.
    assert abs(damage.set_angles[0]) > 10.0
    assert simulation.rest_angles[0] == pytest.approx(damage.set_angles[0])
    assert book.plastic < -1e5
    tolerated = 0.1 if METHODS[method].order == 1 else 0.02
    assert abs(book.residual) <= tolerated * 4.5e6
    weaker = Simulation(bent(law, method, yield_torque=1e6, damping=2.0))
    weaker.advance(1.0)
    assert weaker.damage is not None
    assert abs(weaker.damage.set_angles[0]) > abs(damage.set_angles[0])


def test_a_joint_that_does_not_reach_its_yield_torque_does_not_yield() -> None:
    simulation = Simulation(bent("conservative", yield_torque=9.99e6, speed=1000.0))
    simulation.advance(1.0)
    assert simulation.damage is None


# ------------------------------------------------------------------------- what is kept
def fragile(seed: int = 0, method: Method = "auto") -> Scene:
    """A body of which some springs break, and some yield, soon."""
    scene = body("girder", seed=seed, air=0.0)
    springs = tuple(
        REPLACE(
            spring,
            strength=6e4 if s % 3 else None,
            yield_force=2e4 if s % 2 else None,
            hardening=10.0 * s * (s % 2),
        )
        for s, spring in enumerate(scene.linear_springs)
    )
    joints = tuple(REPLACE(joint, yield_torque=3e5) for joint in scene.angular_springs)
    return REPLACE(
        scene,
        linear_springs=springs,
        angular_springs=joints,
        integrator=Integrator(method=method, dt=1e-3, tolerance=0.01),
    )


def test_going_back_undoes_damage_and_going_on_does_the_same_again() -> None:
    simulation = Simulation(fragile())
    simulation.advance(0.05)
    moment = simulation.capture()
    ends = []
    for _ in range(2):
        simulation.restore(moment)
        assert simulation.damage == moment.damage
        simulation.advance(0.3)
        ends.append((simulation.positions.tolist(), simulation.damage))
    assert ends[0] == ends[1]
    assert ends[0][1] is not None and ends[0][1] != moment.damage and ends[0][1].broken
    simulation.reset()
    assert simulation.damage is None
    fresh = Simulation(fragile())
    for each in (simulation, fresh):
        each.advance(0.2)
    assert same_state(simulation, fresh)


def test_a_saved_pose_has_the_damage_and_settings_keep_it(tmp_path: Any) -> None:
    simulation = Simulation(fragile())
    simulation.advance(0.3)
    saved = REPLACE(simulation.scene, pose=simulation.pose())
    sim.save_scene(saved, tmp_path / "worn.json")
    opened = Simulation(sim.load_scene(tmp_path / "worn.json"))
    assert opened.damage == simulation.damage
    assert np.array_equal(
        solver_of(opened).system.body.stiffness, solver_of(simulation).system.body.stiffness
    )
    simulation.replace(REPLACE(simulation.scene, gravity=(0.0, 100.0)))
    assert simulation.damage == opened.damage
    other = Simulation(simulation.scene)
    other.take_state(simulation)
    assert other.damage == simulation.damage


@pytest.mark.parametrize(
    ("damage", "sentence"),
    [
        (Damage(broken=(99,)), r"pose\.damage\.broken\[0\]: spring 99 does not exist \(0\.\.0\)"),
        (Damage(set_lengths=(1.0, 2.0)), r"pose\.damage\.set_lengths: 2 entries do not match the 1 linear"),
        (Damage(set_angles=(1.0,)), r"pose\.damage\.set_angles: 1 entries do not match the 0 angular"),
        (Damage(hardened=(math.nan,)), r"pose\.damage\.hardened\[0\]: nan is not a finite number"),
    ],
)
def test_damage_that_does_not_fit_is_refused(damage: Damage, sentence: str) -> None:
    pose = Pose(positions=((0.0, 0.0), (100.0, 0.0)), velocities=((0.0, 0.0),) * 2, damage=damage)
    with pytest.raises(SceneError, match=sentence):
        sim.validate(REPLACE(flung(), pose=pose))


def test_where_nothing_yields_or_breaks_there_is_nothing_to_pay_for() -> None:
    simulation = Simulation(sim.load_scene("ring"))
    state = simulation._state
    assert not simulation._body.strength.present
    assert all(state.__dict__[name].size == 0 for name in ("set_length", "set_angle", "hardened", "broken"))
    assert simulation.capture().damage is None


@given(seed=st.integers(0, 10_000), method=st.sampled_from(sorted(METHODS)), strength=st.floats(0.0, 1e5))
@settings(max_examples=30, deadline=None)
def test_whatever_breaks_and_yields_numbers_stay_good(seed: int, method: Method, strength: float) -> None:
    scene = fragile(seed % 7, method)
    springs = tuple(
        REPLACE(spring, strength=strength, yield_force=0.3 * strength) for spring in scene.linear_springs
    )
    integrator = Integrator(method=method, dt=1e-3, tolerance=1.0)
    simulation = Simulation(REPLACE(scene, linear_springs=springs, integrator=integrator))
    simulation.energy()
    for _ in range(5):
        simulation.step(20, attempts=2000)
        assert np.isfinite(simulation.positions).all()
        assert np.isfinite(simulation.energy().residual)
    damage = simulation.damage
    assert damage is None or list(damage.broken) == sorted(set(damage.broken))


def test_a_broken_spring_is_no_obstacle() -> None:
    # A mass falls on a spring between two held masses, which breaks under another load or holds.
    scene = Scene(
        name="bar",
        masses=(
            *(Mass(position=(x, 0.0)) for x in (0.0, 200.0)),
            Mass(position=(100.0, -50.0), velocity=(0.0, 300.0), mass=0.1),
        ),
        linear_springs=(LinearSpring(a=0, b=1, stiffness=1000.0, rest_length=100.0, strength=2e5),),
        anchors=(Anchor(mass=0), Anchor(mass=1)),
        contact=sim.Contact(distance=10.0),
        integrator=Integrator(method="auto", dt=1e-3),
    )
    whole = Simulation(scene)
    whole.advance(0.5)
    assert whole.positions[2, 1] < 0.0
    weak = (REPLACE(scene.linear_springs[0], strength=5e4),)  # it is pulled with 1e5
    broken = Simulation(REPLACE(scene, linear_springs=weak))
    broken.advance(0.5)
    assert broken.damage is not None
    assert broken.positions[2, 1] > 50.0
    broken.reset()
    broken.step(1)


# ------------------------------------------------------------------------- what else knows of it
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
    return Scene(
        name="hung",
        masses=tuple(Mass(position=(10.0 * i, 0.0)) for i in range(3)),
        linear_springs=tuple(
            LinearSpring(a=i, b=i + 1, stiffness=1000.0, rest_length=10.0, damping=5.0, **spring)
            for i in range(2)
        ),
        anchors=(Anchor(mass=0), Anchor(mass=2)),
        gravity=(0.0, 500.0),
        integrator=Integrator(method="symplectic_euler", dt=1e-3),
    )


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


# ------------------------------------------------------------------------- fillings get out
def burst(method: Method = "auto", filling: Any = None, weak: int = 5, joined: bool = True) -> Scene:
    """A blown-up ring of 12 masses, of which one spring is weaker than the others."""
    count, radius = 12, 50.0
    turns = [math.tau * i / count for i in range(count)]
    edge = 2.0 * radius * math.sin(math.pi / count)
    rim = tuple(range(count))
    return Scene(
        name="burst",
        masses=tuple(Mass(position=(radius * math.cos(v), radius * math.sin(v)), mass=0.5) for v in turns),
        linear_springs=tuple(
            LinearSpring(
                a=i,
                b=(i + 1) % count,
                stiffness=2000.0,
                damping=1.0,
                rest_length=edge,
                strength=8000.0 if i == weak else 1e9,
            )
            for i in range(count if joined else count - 1)
        ),
        gravity=(0.0, 0.0),
        fillings=(filling or sim.Gas(masses=rim, pressure=400.0, outside=100.0),),
        integrator=Integrator(method=method, dt=1e-4, tolerance=1e-3),
    )


FILLINGS = {
    "gas": None,
    "liquid": sim.Liquid(masses=tuple(range(12)), bulk_modulus=2000.0, area=12000.0),
}


@pytest.mark.parametrize("kind", FILLINGS)
@pytest.mark.parametrize("method", METHODS)
def test_a_filling_gets_out_of_a_burst_skin(method: Method, kind: str) -> None:
    scene = burst(method, FILLINGS[kind])
    simulation = Simulation(scene)
    start = simulation.energy().total
    whole = simulation.capture()
    before = simulation.energy()
    while simulation.damage is None:
        before = simulation.energy()
        assert simulation.step() == 1 and simulation.time < 1.0
    book = simulation.energy()
    assert simulation.damage.broken == (5,)
    # Its energy is gone with it, and the balance says where.
    assert before.fillings != 0.0 and book.fillings == 0.0
    assert book.broken == pytest.approx(-before.fillings - 8000.0**2 / (2.0 * 2000.0), rel=0.1)
    assert abs(book.residual) <= (1e-2 if METHODS[method].order == 1 else 1e-3) * max(
        abs(start), book.kinetic
    )
    # From then on it moves as a body without it.
    empty = REPLACE(scene, fillings=(), pose=simulation.pose())
    other, again = Simulation(empty), Simulation(REPLACE(scene, pose=simulation.pose()))
    for each in (simulation, other, again):
        each.advance(0.05)
    for each in (simulation, again):
        assert np.abs(each.positions - other.positions).max() <= 2e-2
    # Going back makes the skin tight again, and so does a reset.
    simulation.restore(whole)
    assert simulation.energy().fillings == pytest.approx(start - simulation.energy().linear, rel=1e-9)
    first = Simulation(scene)
    simulation.advance(0.01)
    simulation.reset()
    for each in (simulation, first):
        each.advance(0.02)
    assert np.abs(simulation.positions - first.positions).max() <= 1e-6


def test_numpy_moves_a_burst_balloon_without_its_filling() -> None:
    scene = burst("velocity_verlet")
    pose = Pose(
        positions=tuple(m.position for m in scene.masses),
        velocities=((0.0, 0.0),) * 12,
        damage=Damage(broken=(5,)),
    )
    system, state = start_of(REPLACE(scene, pose=pose), build_system(REPLACE(scene, pose=pose)))
    x, v = state.x + 1j * state.y, state.vx + 1j * state.vy
    empty = REPLACE(scene, pose=pose, fillings=())
    without, other = start_of(empty, build_system(empty))
    forces = Physics(system.body, state).forces(x, v)[system.mass_index]
    assert forces == pytest.approx(Physics(without.body, other).forces(x, v)[without.mass_index])
    assert sim.equilibrium(REPLACE(scene, pose=pose)).damage == Damage(broken=(5,))


def test_a_loop_leaks_where_all_springs_of_an_edge_are_broken_and_only_there() -> None:
    loop = [np.array([0, 1, 2])]
    ends = np.array([(0, 1), (2, 1), (2, 0), (1, 0), (3, 0)])
    assert leaking(loop, ends, np.array([], int)) == []
    assert leaking(loop, ends, np.array([0])) == []  # another spring joins the same masses
    assert leaking(loop, ends, np.array([0, 3])) == [0]
    assert leaking(loop, ends, np.array([1])) == [0]
    assert leaking(loop, ends, np.array([2])) == [0]
    assert leaking(loop, ends, np.array([4])) == []  # not a part of it
    # Where there never was a spring, the scene says that it is tight.
    assert leaking(loop, ends[:2], np.array([], int)) == []


def test_a_loop_with_a_gap_from_the_start_is_tight() -> None:
    simulation = Simulation(burst(joined=False))
    simulation.advance(0.02)
    assert simulation.damage is None and simulation.energy().fillings != 0.0


@pytest.mark.parametrize("method", METHODS)
def test_the_energy_of_what_touches_a_spring_goes_with_it(method: Method) -> None:
    # A mass is pressed against a spring that is stretched beyond its strength, and breaks in the first step.
    scene = Scene(
        name="pressed",
        masses=tuple(Mass(position=p) for p in ((-100.0, 0.0), (100.0, 0.0), (0.0, -5.0), (0.0, -105.0))),
        linear_springs=(
            LinearSpring(a=0, b=1, stiffness=10.0, rest_length=190.0, strength=50.0),
            LinearSpring(a=2, b=3, stiffness=10.0, rest_length=100.0),
        ),
        anchors=(Anchor(mass=0), Anchor(mass=1)),
        gravity=(0.0, 0.0),
        contact=Contact(distance=12.0, stiffness=300.0, friction=0.0),
        integrator=Integrator(method=method, dt=1e-5, tolerance=1e-6),
    )
    simulation = Simulation(scene)
    before = simulation.energy()
    assert before.contact == pytest.approx(300.0 * 7.0**3 / 3.0)
    simulation.step(20)
    book = simulation.energy()
    assert simulation.damage is not None and simulation.damage.broken == (0,)
    assert book.contact == 0.0
    assert book.broken == pytest.approx(-before.contact - 500.0, rel=1e-3)
    assert abs(book.residual) <= 1e-3 * before.contact
