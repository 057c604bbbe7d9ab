"""What stiffnesses mean, held against textbooks; and scenes made stable, or critically damped."""

from __future__ import annotations

import math
import re
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec.structs import replace

import sim
from sim.analysis import tuning as module
from sim.errors import InputError, SceneError
from sim.forces.touch.push import damping_factor
from sim.motion import divergence
from sim.motion.stability import largest_step
from sim.scene.types import Method
from sim.solve.registry import METHODS
from tests.amount import examples, part_of
from tests.sim.builders import built, euler
from tests.sim.changes import posed, with_joints, with_springs
from tests.sim.checks import known, refusal

EULER, VERLET = euler(), sim.Integrator(method="velocity_verlet")


def weight(
    k: float = 500.0, c: float = 3.0, mass: float = 2.0, gravity: float = 90.0, **changes: object
) -> sim.Scene:
    """A mass that hangs by a spring."""
    scene = built(
        [(0.0, 0.0), (0.0, 100.0)], mass=(1.0, mass), stiffness=k, damping=c, held=(0,),
        gravity=(0.0, gravity), integrator=EULER,
    )  # fmt: skip
    return replace(scene, **changes)


def row(stiffness: list[float], damping: list[float], masses: list[float], dt: float = 0.0025) -> sim.Scene:
    """Springs in a row, held at both ends, without gravity."""
    count = len(stiffness)
    places = [(10.0 * i, 0.0) for i in range(count + 1)]
    numbers: dict[str, Any] = {"stiffness": stiffness, "damping": damping, "mass": masses}
    return built(places, **numbers, held=(0, count), integrator=euler(dt))


# ------------------------------------------------------------------------- what numbers mean
def test_a_weight_on_a_spring_is_that_of_the_textbook() -> None:
    k, c, mass, gravity = 500.0, 3.0, 2.0, 90.0
    found = sim.tuning(weight(k, c, mass, gravity))
    omega, zeta = math.sqrt(k / mass), c / (2.0 * math.sqrt(k * mass))
    slowest, elastic, fastest = known(found.slowest), known(found.elastic), known(found.fastest)
    assert fastest.frequency == pytest.approx(omega / math.tau, rel=1e-6)
    assert fastest.damping_ratio == pytest.approx(zeta, rel=1e-6)
    assert fastest.period == pytest.approx(math.tau / omega, rel=1e-6)
    assert np.abs(fastest.shape) == pytest.approx(np.array([[0.0, 0.0], [0.0, 1.0]]), abs=1e-6)
    # The other one is that of a pendulum.
    assert (found.sag, found.sag_mass) == (pytest.approx(mass * gravity / k, rel=1e-9), 1)
    assert slowest.frequency == pytest.approx(math.sqrt(gravity / (100.0 + known(found.sag))) / math.tau)
    assert slowest.damping_ratio < 1e-6
    assert elastic.frequency == pytest.approx(fastest.frequency, rel=1e-6)
    # Limits of the methods, and of the spring alone.
    assert set(found.stable_steps) == {"symplectic_euler", "velocity_verlet", "rk4"}
    limit = 2.0 * (math.sqrt(1.0 + zeta**2) - zeta) / omega
    assert found.stable_steps["symplectic_euler"] == pytest.approx(limit, rel=1e-6)
    limit = 2.0 * (math.sqrt(1.0 + 4.0 * zeta**2) - 2.0 * zeta) / omega
    assert found.stable_steps["velocity_verlet"] == pytest.approx(limit, rel=1e-6)
    assert found.springs.stable_step == pytest.approx([found.stable_steps["symplectic_euler"]], rel=1e-6)
    assert found.springs.frequency == pytest.approx([omega / math.tau])
    assert found.springs.damping_ratio == pytest.approx([zeta])
    assert found.notes == ()
    undamped = sim.tuning(weight(c=0.0))
    assert undamped.stable_steps["rk4"] == pytest.approx(math.sqrt(8.0) / omega, rel=1e-3)


def test_two_free_masses_have_one_vibration_and_fall() -> None:
    free = weight(mass=3.0, anchors=())
    found = sim.tuning(free)
    omega = math.sqrt(500.0 / (1.0 * 3.0 / 4.0))
    for vibration in (found.slowest, found.elastic, found.fastest):
        assert known(vibration).frequency == pytest.approx(omega / math.tau, rel=1e-5)
    assert found.springs.frequency == pytest.approx([omega / math.tau])
    assert found.sag is None
    assert found.sag_mass is None
    assert found.notes == (
        "nothing holds mass 0, so it falls",
        "the vibrations are those of the body without gravity",
    )
    assert sim.tuning(replace(free, gravity=(0.0, 0.0))).notes == ()


def test_a_row_of_springs_has_the_frequencies_of_the_textbook() -> None:
    n, k, mass = 9, 800.0, 0.5
    scene = row([k] * (n + 1), [0.0] * (n + 1), [mass] * (n + 2))
    found = sim.tuning(scene)
    omega = [2.0 * math.sqrt(k / mass) * math.sin(j * math.pi / (2 * (n + 1))) for j in (1, n)]
    assert known(found.slowest).frequency == pytest.approx(omega[0] / math.tau, rel=1e-6)
    assert known(found.fastest).frequency == pytest.approx(omega[1] / math.tau, rel=1e-3)
    assert found.sag is None
    alone = math.sqrt(k * 2.0 / mass) / math.tau
    assert found.springs.frequency[1:-1] == pytest.approx([alone] * (n - 1))
    # At both ends one mass is held.
    assert found.springs.frequency[[0, -1]] == pytest.approx([alone / math.sqrt(2.0)] * 2)


@pytest.mark.parametrize("name", part_of(["rod", "ring", "cloth", "air-balloon", "tutorial-3.3"], 3))
def test_steps_are_those_of_the_stability_meter(name: str) -> None:
    scene = sim.load_scene(name)
    found = sim.tuning(scene)
    for method, step in found.stable_steps.items():
        assert step == largest_step(scene, method)
    assert known(found.elastic).frequency <= 1.01 * known(found.fastest).frequency


def test_a_pose_is_the_start_of_steps_and_not_of_the_sag() -> None:
    scene = weight()
    short = posed(with_springs(scene, damping=0.0), [(0.0, 0.0), (0.0, 0.5)])
    assert sim.tuning(short).sag == pytest.approx(sim.tuning(scene).sag, rel=1e-6)
    # So short a spring is stiff across itself: its tension by its length.
    assert sim.tuning(short).stable_steps["symplectic_euler"] < 0.2


def test_what_cannot_be_found_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    held = weight(anchors=(sim.Anchor(mass=0), sim.Anchor(mass=1)))
    found = sim.tuning(held)
    assert (found.slowest, found.elastic, found.fastest, found.sag) == (None, None, None, None)
    assert found.springs.frequency.tolist() == [0.0]
    assert found.springs.stable_step.tolist() == [math.inf]
    monkeypatch.setattr(module, "MAX_MASSES", 1)
    found = sim.tuning(weight())
    assert found.slowest is None
    assert found.fastest is not None
    assert found.notes == ("the slowest vibrations are found for at most 1 masses",)
    loose = sim.Scene(name="loose", masses=(sim.Mass(position=(0.0, 0.0)),))
    assert sim.tuning(loose).fastest is None
    with pytest.raises(SceneError):
        sim.tuning(replace(loose, air_friction=-1.0))


# ------------------------------------------------------------------------- stable at a step
numbers = st.floats(0.1, 10.0)


@settings(max_examples=examples(40))
@given(
    st.lists(st.tuples(st.floats(1.0, 1e6), st.floats(0.0, 300.0), numbers), min_size=2, max_size=6),
    st.floats(1e-4, 0.1),
    st.sampled_from(["symplectic_euler", "velocity_verlet", "rk4"]),
)
def test_the_change_makes_it_stable_and_is_the_least(
    springs: list[tuple[float, float, float]], dt: float, method: Method
) -> None:
    scene = row([k for k, _, _ in springs], [c for _, c, _ in springs], [1.0, *(m for *_, m in springs)])
    scene = replace(scene, integrator=sim.Integrator(method=method, dt=dt))
    made = sim.make_stable(scene)
    limit = largest_step(made, method)
    assert limit >= dt
    if largest_step(scene, method) >= 1.02 * dt:
        assert made is scene
        return
    # Nothing else has changed, and nothing has grown.
    assert replace(made, linear_springs=scene.linear_springs) == scene
    for old, new in zip(scene.linear_springs, made.linear_springs, strict=True):
        assert new.stiffness <= old.stiffness
        assert new.damping <= old.damping
        assert replace(new, stiffness=old.stiffness, damping=old.damping) == old
    # With a cap that is some per cent higher it would not be.
    assert limit <= 1.03 * dt
    simulation = sim.Simulation(made)
    simulation.step(300)
    assert simulation.divergence is None


def test_only_what_offends_is_changed() -> None:
    k, c = [100.0, 100.0, 9e5, 100.0, 100.0], [1.0] * 5
    made = sim.make_stable(row(k, c, [1.0] * 6, dt=0.01))
    assert [s.stiffness for s in made.linear_springs[:2] + made.linear_springs[3:]] == [100.0] * 4
    assert made.linear_springs[2].stiffness < 3e4
    assert [s.damping for s in made.linear_springs] == c
    # Where damping is too strong, stiffness stays.
    c[2] = 5000.0
    made = sim.make_stable(row([100.0] * 5, c, [1.0] * 6, dt=0.01))
    assert [s.stiffness for s in made.linear_springs] == [100.0] * 5
    assert made.linear_springs[2].damping < 250.0
    assert [s.damping for i, s in enumerate(made.linear_springs) if i != 2] == [1.0] * 4


def test_a_spring_alone_keeps_what_the_step_bears() -> None:
    dt, mass = 0.02, 3.0
    made = sim.make_stable(weight(1e7, 0.0, mass, integrator=euler(dt)))
    assert made.linear_springs[0].stiffness == pytest.approx(4.0 * mass / (1.01 * dt) ** 2, rel=3e-3)


@pytest.mark.parametrize("name", part_of(["rod", "ring", "girder", "tree", "tutorial-3.2"], 3))
def test_presets_run_after_it(name: str) -> None:
    scene = sim.load_scene(name)
    made = sim.make_stable(scene, 0.01, "symplectic_euler")
    assert (made.integrator.dt, made.integrator.method) == (0.01, "symplectic_euler")
    assert largest_step(made, "symplectic_euler") >= 0.01
    simulation = sim.Simulation(made)
    simulation.step(200)
    assert simulation.divergence is None
    assert len(made.masses) == len(scene.masses)
    assert made.anchors == scene.anchors
    # A template's factor is in the numbers of the joints.
    assert sim.make_stable(made) is made


def test_a_violent_start_is_run_too() -> None:
    # At its start, drawn out, it is less stiff than when it has sprung back.
    scene = row([3e4] * 4, [0.0] * 4, [1.0] * 5, dt=0.0075)
    speeds = ((0.0, 0.0), (2e4, 100.0), (-2e4, 0.0), (2e4, -100.0), (0.0, 0.0))
    violent = posed(scene, speeds=speeds)
    made = sim.make_stable(violent)
    assert made.pose == violent.pose
    simulation = sim.Simulation(made)
    simulation.step(133)
    assert simulation.divergence is None


def test_a_step_that_no_softer_spring_makes_stable_is_refused_with_the_reason(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    braked, fast = (posed(weight(), speeds=[(0.0, 0.0), (speed, 0.0)]) for speed in (1e4, 9e6))
    why = "make_stable: at 0.0025 s it is not springs .* but air friction$"
    assert re.match(why, refusal(InputError, sim.make_stable, replace(braked, air_friction=5.0)))
    why, blamed = "however soft its springs: the time step is below", list[object]()
    find = divergence.limit_to_blame
    monkeypatch.setattr(divergence, "limit_to_blame", lambda *about: blamed.append(about) or find(*about))
    assert why in refusal(InputError, sim.make_stable, fast)
    assert len(blamed) == 1, "it takes long, and is for what is said only"


def test_methods_without_a_limit_change_nothing_but_the_step() -> None:
    stiff = weight(1e9)
    for method in ("auto", "rodas4", "generalized_alpha", "stable_spring"):
        made = sim.make_stable(stiff, 0.01, method)
        assert made == replace(stiff, integrator=sim.Integrator(method=method, dt=0.01))
    own = weight(1e9, integrator=sim.Integrator())
    assert sim.make_stable(own) is own
    with pytest.raises(SceneError, match="dt"):
        sim.make_stable(stiff, 2.0)
    with pytest.raises(SceneError, match="method"):
        sim.make_stable(stiff, 0.01, "magic")  # type: ignore[arg-type]


# ------------------------------------------------------------------------- critical damping
def test_a_spring_is_damped_critically_by_the_known_solution() -> None:
    k, mass = 700.0, 3.0
    made = sim.damp_vibration(weight(k, 0.0, mass), spring=0)
    assert made.linear_springs[0].damping == pytest.approx(2.0 * math.sqrt(k * mass), rel=1e-12)
    assert sim.tuning(made).springs.damping_ratio == pytest.approx([1.0], rel=1e-12)
    both = sim.damp_vibration(weight(k, 0.0, mass, anchors=()), spring=0)
    assert both.linear_springs[0].damping == pytest.approx(2.0 * math.sqrt(k * 0.75), rel=1e-12)
    # The body's own vibration is the same one, whatever damping it had before.
    for c in (0.0, 5.0, 900.0):
        whole = sim.damp_vibration(weight(k, c, mass))
        assert whole.linear_springs[0].damping == pytest.approx(2.0 * math.sqrt(k * mass), rel=1e-6)


def test_the_swing_under_gravity_is_passed_over_unless_it_is_asked_for() -> None:
    scene = sim.load_scene("tutorial-3.3")
    made = sim.damp_vibration(scene)
    found = sim.tuning(made)
    elastic = known(found.elastic)
    assert elastic.damping_ratio == pytest.approx(1.0, rel=1e-6)
    assert known(found.slowest).frequency < 0.5 * elastic.frequency
    assert "and 1e+06 is the most" in refusal(InputError, sim.damp_vibration, scene, mode=0)
    pendulum = weight(1e7, 0.0)
    assert "hold no such vibration" in refusal(InputError, sim.damp_vibration, pendulum, mode=0)


def test_another_vibration_can_be_damped() -> None:
    rod = replace(sim.rod(masses=7, length=200.0), gravity=(0.0, 0.0))
    made = sim.damp_vibration(rod, mode=1)
    resting, found = module.vibrations_at_rest(made, 2)
    dampers = module.Dampers(resting)
    of = dampers.numbers.damping, dampers.numbers.joint_damping
    ratios = [dampers.ratio(float(found.omega[k]), found.shapes[k], *of) for k in (0, 1)]
    assert ratios[1] == pytest.approx(1.0, rel=1e-6)
    assert ratios[0] < 0.9


def test_dampings_of_the_other_kind_stay_unless_they_are_too_much_alone() -> None:
    rod = replace(sim.rod(masses=7, length=200.0), gravity=(0.0, 0.0))
    row_of = sim.damp_vibration(rod, mode=0)
    again = sim.damp_vibration(with_joints(row_of, damping=lambda _, joint: 3.0 * joint.damping))
    first, second = ([joint.damping for joint in scene.angular_springs] for scene in (row_of, again))
    assert second == pytest.approx(first, rel=1e-6)
    # A mass at the corner of two springs and a weak joint: the springs hold it, the joint damps too much.
    corner = built(
        [(0.0, 0.0), (50.0, 0.0), (80.0, 40.0)], stiffness=500.0, damping=1.0, rest_length=50.0, held=(0, 2),
        joint={"stiffness": 1.0, "damping": 900.0, "rest_angle": 53.130102354155980},
    )  # fmt: skip
    made = sim.damp_vibration(corner)
    assert [s.damping for s in made.linear_springs] == [0.0, 0.0]
    assert 0.0 < made.angular_springs[0].damping < 900.0
    found = known(sim.tuning(made).elastic)
    assert found.damping_ratio == pytest.approx(1.0, rel=1e-6)


HELD = weight(anchors=(sim.Anchor(mass=0), sim.Anchor(mass=1)))


@pytest.mark.parametrize(
    ("scene", "changes", "said"),
    [
        (weight(), {"spring": 1}, "spring 1 does not exist (0..0)"),
        (weight(), {"spring": -1}, "spring -1 does not exist"),
        (weight(), {"spring": True}, "spring True does not exist"),
        (weight(), {"mode": -1}, "-1 is not the number of a vibration"),
        (weight(), {"mode": True}, "True is not the number of a vibration"),
        (weight(), {"mode": 2}, "the body has no vibration 2, but 2"),
        (HELD, {"spring": 0}, "both masses of spring 0 are held"),
        (HELD, {}, "hold no such vibration"),
        (weight(1e15, 0.0, 1e4), {"spring": 0}, "take a damping of 6.32e+09 kg/s, and 1e+06 is the most"),
    ],
)
def test_what_cannot_be_damped_is_refused(scene: sim.Scene, changes: dict[str, Any], said: str) -> None:
    sentence = refusal(InputError, sim.damp_vibration, scene, **changes)
    assert sentence.startswith("damp_vibration: ")
    assert said in sentence


@pytest.mark.parametrize("slip", [10.0, 1.0, 0.1])
def test_friction_damps_a_small_vibration_as_at_a_creep(slip: float) -> None:
    """A mass that lies on a rough floor, on a spring along it: c = mu N / slip speed."""
    floor = sim.Wall(
        point=(0.0, 0.0), normal=(0.0, -1.0), hardness=1e4, friction=0.02, slip_speed=slip, bounciness=1.0
    )
    depth = math.sqrt(1000.0 / 1e4)
    places = [(0.0, depth), (50.0, depth)]
    fields: dict[str, Any] = {"gravity": (0.0, 1000.0), "walls": (floor,)}
    scene = built(places, mass=(1.0, 2.0), stiffness=100.0, held=(0,), **fields)
    found = known(sim.tuning(scene).slowest)
    omega = math.tau * found.frequency
    assert found.damping_ratio == pytest.approx(0.02 * 1000.0 / slip / (2.0 * omega), rel=0.01)


@pytest.mark.parametrize("own", part_of([*METHODS], 3))
def test_the_tuning_of_a_body_on_a_floor_does_not_depend_on_its_method(own: Any) -> None:
    """Two masses that lie on a floor, which some methods soften: each swings on it with sqrt(2 H d)."""
    hardness, depth = 1e4, math.sqrt(1000.0 / 1e4)
    floor = sim.Wall(point=(0.0, 0.0), normal=(0.0, -1.0), hardness=hardness, friction=0.0, bounciness=0.5)
    fields: dict[str, Any] = {
        "gravity": (0.0, 1000.0),
        "walls": (floor,),
        "integrator": sim.Integrator(method=own, dt=0.01),
    }
    scene = built([(0.0, depth), (50.0, depth)], stiffness=10.0, **fields)
    found = sim.tuning(scene)
    fastest, omega, loss = known(found.fastest), math.sqrt(2.0 * hardness * depth), damping_factor(0.5)
    assert fastest.frequency == pytest.approx(omega / math.tau, rel=1e-3)
    assert fastest.damping_ratio == pytest.approx(loss * 1000.0 / (2.0 * omega), rel=1e-2)
    for method, step in found.stable_steps.items():
        by = sim.set_choice(scene, "method", method)
        assert step == pytest.approx(sim.Simulation(by).stability().limit, rel=1e-2)
        assert largest_step(scene, method) == step
