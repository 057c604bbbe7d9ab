"""Bodies at rest, and their small vibrations: against balances of forces, closed forms and motion in time."""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from msgspec.structs import replace

import sim
from sim import InputError, LinearSpring, Mass, Pose, Scene
from sim.analysis.equilibrium import StaticModel, equilibrium
from sim.analysis.vibrations import vibrations
from sim.scene.types import ForceLaw
from tests.sim.arrays import Arrays
from tests.sim.bodies import tangle
from tests.sim.builders import PRESETS, chain, row
from tests.sim.changes import by, posed, with_broken, with_joints, with_masses
from tests.sim.checks import jacobian, known, refusal
from tests.sim.inside import Points, forces_of

LAWS: tuple[ForceLaw, ...] = ("conservative", "tutorial", "angle")


def unbalanced(scene: Scene, pose: Pose) -> float:
    """The largest force left on a free mass, in parts of the stiffest spring's force for a length of 1 px."""
    # By a method whose forces are the law's to the last digit.
    forces = forces_of(by(replace(scene, pose=pose), "symplectic_euler"))
    forces += np.outer([mass.mass for mass in scene.masses], scene.gravity)
    if scene.wind is not None:  # the mean wind, on bodies at rest
        forces += scene.air_friction * np.array(scene.wind.velocity) * np.abs(scene.wind.velocity)
    forces[[anchor.mass for anchor in scene.anchors]] = 0.0
    return float(np.abs(forces).max()) / max(spring.stiffness for spring in scene.linear_springs)


def positions_of(pose: Pose | None) -> Points:
    return np.array(known(pose).positions)


# ------------------------------------------------------------------------- on walls and on each other
FLOOR = sim.Wall(point=(300.0, 500.0), normal=(0.0, -1.0))


@pytest.mark.parametrize(("hardness", "gravity"), [(8.0, 1000.0), (1e9, 30.0), (1e9, 1000.0), (8e3, 9e4)])
@pytest.mark.parametrize("maker", [sim.air_balloon, sim.water_balloon, sim.jelly])
def test_a_soft_body_rests_on_a_floor(maker: Callable[..., Scene], hardness: float, gravity: float) -> None:
    floor = replace(FLOOR, hardness=hardness)
    walls = (floor, replace(floor, normal=(1.0, 0.0), point=(60.0, 0.0)))
    scene = maker(walls=walls, gravity=(0.0, gravity))
    pose = equilibrium(scene)
    # All of the weight is on the floor.
    depth = np.maximum(positions_of(pose)[:, 1] - 500.0, 0.0)
    mass = np.array([m.mass for m in scene.masses])
    assert float((mass * hardness * depth**2).sum()) == pytest.approx(gravity * mass.sum(), rel=1e-6)
    weight = gravity * float(mass.sum())
    assert np.abs(forces_with_walls(scene, pose)).max() <= 1e-6 * weight


def forces_with_walls(scene: Scene, pose: Pose) -> Points:
    """(n, 2) what is left on masses at rest."""
    arrays = Arrays(by(replace(scene, pose=pose), "generalized_alpha"))
    return arrays.pairs_of(arrays.weight * arrays.accelerations(arrays.q, 0.0 * arrays.v))


def two_balloons(stiffness: float) -> Scene:
    """One above the other."""
    lower = sim.WaterBalloon(masses=12, diameter=60.0, center=(300.0, 380.0))
    return Scene(
        name="two",
        bodies=(lower, replace(lower, center=(300.0, 310.0))),
        contact=sim.Contact(distance=8.0, stiffness=stiffness),
        walls=tuple(replace(FLOOR, normal=(x, -1.0), point=(300.0, 420.0)) for x in (0.5, -0.5)),
        gravity=(0.0, 500.0),
    )


def test_bodies_rest_on_each_other() -> None:
    scene = two_balloons(8000.0)
    pose = equilibrium(scene)
    assert np.abs(forces_with_walls(scene, pose)).max() <= 1e-6 * 500.0 * 0.2
    assert positions_of(pose)[12:, 1].mean() < positions_of(pose)[:12, 1].mean()


def test_a_contact_too_stiff_for_a_step_makes_it_shorter() -> None:
    body = StaticModel(two_balloons(5e6), balanced=True)
    tangled = body.nudge(body.start, 3.0)
    shifts = (1e-6, 1e-3, 1e-1)
    tried = [body.factorise(tangled, shift) for shift in shifts]
    assert not all(tried)
    assert body.factorise(tangled, 1e6)


@pytest.mark.parametrize("friction", [0.0, 5.0])
def test_a_slope_holds_nothing_at_rest(friction: float) -> None:
    slope = replace(FLOOR, normal=(0.3, -1.0), friction=friction)
    creeps = ", and friction that creeps holds nothing that is at rest" if friction else ""
    with pytest.raises(InputError, match=f"nothing stops it{creeps}$"):
        equilibrium(sim.air_balloon(walls=(slope,)))


# ------------------------------------------------------------------------- balances
@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize(
    "name",
    [
        name
        for name in PRESETS
        if 0 < len(sim.load_scene(name).anchors) < len(sim.load_scene(name).masses)
        and name not in ("crane", "stick-slip")  # a motor or a belt does not rest
    ],
)
def test_forces_balance_in_every_preset(name: str, law: ForceLaw) -> None:
    scene = replace(sim.load_scene(name), force_law=law)
    pose = equilibrium(scene)
    assert unbalanced(scene, pose) < 1e-9
    assert not np.any(pose.velocities)
    for anchor in scene.anchors:
        assert pose.positions[anchor.mass] == scene.masses[anchor.mass].position


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("seed", [1, 3, 5, 7, 9])
def test_forces_balance_in_bodies_without_order(seed: int, law: ForceLaw) -> None:
    scene = replace(tangle(seed, held=(0, 1)), force_law=law, gravity=(30.0, 500.0))
    assert unbalanced(scene, equilibrium(scene)) < 1e-9


def test_a_joint_that_is_loaded_turns_by_the_sine() -> None:
    # Torque balance at a joint: K |A||B| sin V = m g |B| cos V, springs as good as rigid.
    stiffness, weight, length = 4.0, 60.0, 10.0
    scene = chain(
        row(3), stiffness=1e9, angular_stiffness=stiffness, held=(0, 1), gravity=(0.0, weight), mass=1.0
    )
    x, y = positions_of(equilibrium(scene))[2] - (length, 0.0)
    assert y / x == pytest.approx(weight / (stiffness * length), rel=1e-6)


def test_a_rest_length_scale_and_a_template_count() -> None:
    scene = sim.load_scene("tutorial-3.2")
    longer = equilibrium(replace(scene, gravity=(0.0, 0.0), rest_length_scale=1.5))
    lengths = np.hypot(*np.diff(positions_of(longer), axis=0).T)
    assert lengths[1:] == pytest.approx(1.5 * scene.linear_springs[0].rest_length, rel=1e-6)


def test_the_saved_pose_is_the_start_and_velocities_do_not_matter() -> None:
    scene = sim.rope(direction=(1.0, 0.0))
    pose = equilibrium(scene)
    again = equilibrium(posed(scene, pose.positions, [(50.0, -70.0)] * len(pose.positions)))
    assert positions_of(again) == pytest.approx(positions_of(pose), abs=1e-8)
    assert not np.any(again.velocities)


# ------------------------------------------------------------------------- hard cases
def test_a_rod_that_stands_upright_falls_to_one_side_unless_it_is_stiff() -> None:
    # No force on it is sideways.
    rod = sim.rope(8, 200.0, direction=(0.0, -1.0), held=(0, 1), driven=None, angular_stiffness=100.0)
    pose = equilibrium(rod)
    assert unbalanced(rod, pose) < 1e-9
    assert positions_of(pose)[-1, 1] > 150.0
    stiff = positions_of(equilibrium(replace(with_joints(rod, stiffness=1e5), gravity=(0.0, 20.0))))
    assert stiff[:, 0] == pytest.approx(300.0, abs=1e-6)
    assert stiff[-1, 1] == pytest.approx(-50.0, abs=0.1)


def test_masses_a_billion_times_lighter_do_no_harm() -> None:
    scene = sim.rope(12, 300.0, direction=(1.0, 0.0), stiffness=1e6, held=(0, 1), driven=None)
    scene = with_masses(replace(scene, gravity=(0.0, 3.0)), mass=lambda i, _: 1e-6 if i % 2 else 1e3)
    assert unbalanced(scene, equilibrium(scene)) < 1e-9


@pytest.mark.parametrize(("force", "mass"), [(1e9, 1e-6), (1e-6, 1e6), (1e9, 1.0), (1e-6, 1.0)])
def test_units_of_force_and_mass_do_not_matter(force: float, mass: float) -> None:
    def places(force: float, mass: float) -> Points:
        stiff: dict[str, Any] = {"stiffness": 1e4 * force, "angular_stiffness": 100.0 * force, "mass": mass}
        fixed: dict[str, Any] = {"rest_angle": 12.0, "held": (0, 29), "driven": None, "gravity": (0.0, 0.0)}
        return positions_of(equilibrium(sim.rope(30, 300.0, **stiff, **fixed)))

    assert places(force, mass) == pytest.approx(places(1.0, 1.0), abs=1e-7)


def test_a_rope_folded_exactly_unfolds() -> None:
    folded = [(0.0, 0.0), (10.0, 0.0), (0.0, 0.0), (10.0, 0.0), (0.0, 0.0)]
    scene = chain(folded, stiffness=100.0, angular_stiffness=30.0, held=(0,))
    pose = equilibrium(scene)
    assert unbalanced(scene, pose) < 1e-9
    assert math.dist(pose.positions[0], pose.positions[-1]) == pytest.approx(40.0, rel=1e-6)


def test_a_long_rope_hangs() -> None:
    scene = sim.rope(1000, 300.0, direction=(1.0, 0.0), stiffness=1e9, angular_stiffness=1e7)
    pose = equilibrium(scene)
    assert unbalanced(scene, pose) < 1e-8
    assert positions_of(pose)[-1, 1] > 400.0


def test_nothing_to_do_where_all_is_held() -> None:
    scene = chain(row(3), stiffness=10.0, held=(0, 1, 2), gravity=(0.0, 10.0))
    assert equilibrium(scene).positions == tuple(row(3))


def test_what_has_no_equilibrium_is_refused_with_the_reason() -> None:
    scene = chain(row(3), stiffness=10.0, held=(0,))
    alone = (*scene.masses, Mass(position=(0.0, 50.0)))
    for without, why in (
        (replace(scene, masses=alone, gravity=(0.0, 10.0)), "nothing holds mass 3, so it falls"),
        (sim.rope(stiffness=0.0, joints=False), "nothing stops it"),
        (replace(tangle(2), force_law="angle"), "the spring between masses 3 and 7 shrinks to no length"),
    ):
        assert why in refusal(InputError, equilibrium, without)
    assert "air_friction" in refusal(sim.SceneError, equilibrium, replace(sim.rope(), air_friction=-1.0))


# ------------------------------------------------------------------------- vibrations
def test_a_mass_between_two_springs() -> None:
    scene = chain(row(3), stiffness=30.0, held=(0, 2), mass=2.0, rest_length=8.0)
    found = vibrations(scene, 2)
    # Along the springs both stiffnesses; across them what is pulled taut over the length.
    across, along = math.sqrt(2.0 * 30.0 * 2.0 / 10.0 / 2.0), math.sqrt(2.0 * 30.0 / 2.0)
    assert found.omega == pytest.approx([across, along], rel=1e-9)
    assert np.abs(found.shapes[0]) == pytest.approx(np.array([[0, 0], [0, 1], [0, 0]]), abs=1e-9)
    assert np.abs(found.shapes[1]) == pytest.approx(np.array([[0, 0], [1, 0], [0, 0]]), abs=1e-9)


@pytest.mark.parametrize("law", LAWS)
def test_they_are_those_of_the_forces(law: ForceLaw) -> None:
    """Of a Jacobian from differences of forces, at an equilibrium under load."""
    scene = replace(tangle(3, held=(0, 1)), force_law=law, gravity=(0.0, 300.0))
    resting = replace(scene, pose=equilibrium(scene))
    start, count = positions_of(resting.pose).ravel(), 2 * len(scene.masses)
    weights = np.repeat([mass.mass for mass in scene.masses], 2)[4:, None]

    def forces(at: Points) -> Points:
        return forces_of(posed(scene, at.reshape(-1, 2)))[2:].ravel()

    of_forces = jacobian(forces, start, 1e-3, range(4, count)) / weights
    exact = np.sort(np.sqrt(-np.linalg.eigvals(of_forces).real))
    assert vibrations(resting, count - 4).omega == pytest.approx(exact, rel=1e-5)


def test_what_does_not_vibrate_is_refused() -> None:
    free = chain(row(3), stiffness=10.0, angular_stiffness=1.0)
    pushed = chain(row(3), stiffness=10.0, held=(0, 2), rest_length=12.0)
    held = chain(row(4), stiffness=10.0, held=(0, 3))
    for scene, count, why in (
        *((loose, 1, "do not hold the body") for loose in (free, pushed, replace(free, angular_springs=()))),
        *((held, count, f"{count} is not in the range 1..4") for count in (0, 5)),
        (sim.rope(1200), 1, "1200 masses are more than 1000"),
    ):
        assert why in refusal(InputError, vibrations, scene, count)


def test_a_part_that_only_a_broken_spring_holds_is_named() -> None:
    scene = replace(chain(row(4), stiffness=10.0, held=(0,)), gravity=(0.0, 10.0))
    why = "only broken springs hold mass 2, so it falls"
    assert why in refusal(InputError, equilibrium, with_broken(scene, [1]))
    # Where another way round is whole, it holds.
    other = LinearSpring(a=1, b=3, stiffness=10.0, rest_length=20.0)
    around = replace(scene, linear_springs=(*scene.linear_springs, other))
    assert equilibrium(with_broken(around, [1])).positions[3][1] > 0.0
    # Without gravity nothing pulls.
    equilibrium(with_broken(replace(scene, gravity=(0.0, 0.0)), [1]))


def test_constant_forces_move_a_free_part_unless_they_are_in_balance() -> None:
    free = chain(row(2), stiffness=100.0)
    pulled = with_masses(free, force=[(0.0, 0.0), (50.0, 0.0)])
    assert "nothing holds mass 0, so it moves away" in refusal(InputError, equilibrium, pulled)
    (x0, _), (x1, _) = equilibrium(with_masses(free, force=[(-50.0, 0.0), (50.0, 0.0)])).positions
    rest = free.linear_springs[0].rest_length
    assert x1 - x0 == pytest.approx(rest + 0.5, abs=1e-9)


def test_vibrations_have_hertz_and_say_where_a_load_is_left_out() -> None:
    rod = replace(sim.rod(masses=5), gravity=(0.0, 1000.0))
    with pytest.warns(UserWarning, match="forces do not balance where the scene starts"):
        loaded = vibrations(rod, 2)
    assert loaded.frequencies == pytest.approx(loaded.omega / math.tau)
    resting = replace(rod, pose=equilibrium(rod))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        found = vibrations(resting, 2)
        vibrations(replace(rod, gravity=(0.0, 0.0)), 2)
    told = known(sim.tuning(rod).slowest)
    assert found.frequencies[0] == pytest.approx(told.frequency, rel=1e-6)
