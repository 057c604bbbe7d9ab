"""The stability meter against the eigenvalues of the whole step, of bodies at rest and in motion."""

from __future__ import annotations

import math
from itertools import product

import numpy as np
import pytest
from msgspec.structs import replace

import sim
from sim import Integrator, Scene, Simulation
from sim.edit.edit import of_parts
from sim.scene.types import Damage, ForceLaw, Method
from tests.amount import part_of
from tests.sim.bodies import LAWS, body, tangle
from tests.sim.builders import chain, euler
from tests.sim.changes import after, by, pairs, posed, with_masses, with_springs
from tests.sim.inside import put
from tests.sim.whole_step import hold

METHODS_WITH_LIMIT: tuple[Method, ...] = ("symplectic_euler", "velocity_verlet", "rk4")
DT = 2e-4


def turning(scene: Scene, rate: float) -> Scene:
    """A free body that turns as a whole, by `rate` rad/s."""
    scene = of_parts(scene)
    positions = np.array([mass.position for mass in scene.masses])
    x, y = (positions - positions.mean(0)).T
    velocities = list(pairs(rate * np.column_stack((-y, x))))
    return replace(with_masses(scene, velocity=velocities), anchors=(), gravity=(0.0, 0.0))


def euler_preset(preset: str, law: ForceLaw) -> Simulation:
    return Simulation(replace(sim.load_scene(preset), force_law=law, integrator=euler()))


PRESETS_AND_LAWS = [*product(["tutorial-3.3", "ring", "box"], LAWS), ("hair-tuft", "conservative"),
                    ("flag-pole", "tutorial")]  # fmt: skip


@pytest.mark.parametrize(("preset", "law"), part_of(PRESETS_AND_LAWS, 3))
def test_presets_at_their_start(preset: str, law: ForceLaw) -> None:
    hold(euler_preset(preset, law))


@pytest.mark.parametrize(("preset", "law"), part_of(PRESETS_AND_LAWS, 4))
def test_presets_whose_driven_mass_is_led(preset: str, law: ForceLaw) -> None:
    simulation = euler_preset(preset, law)
    driven = next(a.mass for a in simulation.anchors if a.driven)
    x, y = simulation.positions[driven]
    for frame in range(4):
        simulation.lead(driven, (x + 60.0 * math.sin(frame), y + 30.0 * math.cos(2.0 * frame)))
        simulation.step(40)
        hold(simulation)


@pytest.mark.parametrize("seed", part_of(range(3), 3))
@pytest.mark.parametrize("preset", ["tutorial-3.3", "ring", "box", "hair-tuft"])
def test_presets_at_random_positions(preset: str, seed: int) -> None:
    simulation = euler_preset(preset, "tutorial")
    positions = simulation.positions
    put(simulation, positions + np.random.default_rng(seed).normal(0.0, 6.0, positions.shape))
    hold(simulation)


@pytest.mark.parametrize("damping", [0.5, 1.5, 5.0])
def test_the_first_estimate_is_as_good_as_later_ones(damping: float) -> None:
    # The flag's damping and the pole's stiffness each have a limit of their own, far from the step that the
    # meter begins with.
    hold(Simulation(sim.flag_pole(flag_damping=damping, wind=None, integrator=euler())), 1e-3)


@pytest.mark.parametrize("seed", range(8))
def test_random_bodies(seed: int) -> None:
    hold(Simulation(replace(tangle(seed, held=(0, 3)), air_friction=0.01)))


@pytest.mark.parametrize("damping", [0.0, 30.0])
@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("shape", part_of(["chain", "girder", "hub"], 3))
def test_dampers_of_joints(shape: str, law: ForceLaw, damping: float) -> None:
    damped, without = (body(shape, law, 3, damping=damping, twist=t, held=(1,)) for t in (200.0, 0.0))
    # It matters: without it, longer steps would do.
    assert Simulation(without).stability().limit > 1.3 * hold(Simulation(damped))


SHAPES = (("chain", 0), ("ring", 0), ("hub", 0), ("girder", 5))
RESTING = [*product(SHAPES, (0.0, 30.0, 300.0), METHODS_WITH_LIMIT)]


@pytest.mark.parametrize(("shape", "damping", "method"), part_of(RESTING, 3))
def test_bodies_of_any_shape_at_rest(shape: tuple[str, int], damping: float, method: Method) -> None:
    name, seed = shape
    scene = by(body(name, "conservative", seed, damping=damping, held=(1,)), method, dt=DT)
    hold(Simulation(replace(scene, pose=sim.equilibrium(scene))))


TURNING = [*product((("conservative", 0.0), ("conservative", 0.5), ("conservative", 3.0), ("tutorial", 2.0),
                     ("angle", 2.0)), METHODS_WITH_LIMIT)]  # fmt: skip


@pytest.mark.parametrize(("turn", "method"), part_of(TURNING, 3))
def test_regular_bodies_that_turn(method: Method, turn: tuple[ForceLaw, float]) -> None:
    # Their vibrations come in pairs of equal frequencies, which damping couples as soon as they turn.
    for sides, damping in ((5, 10.0), (6, 20.0), (9, 40.0)):
        scene = turning(sim.polygon(sides=sides, damping=damping), turn[1])
        hold(Simulation(by(replace(scene, force_law=turn[0]), method, dt=DT)))


def test_a_regular_body_that_turns_runs_below_its_limit_and_explodes_above() -> None:
    scene = turning(sim.polygon(sides=5), 0.5)
    limit = Simulation(by(scene, "symplectic_euler", dt=DT)).stability().limit
    for factor, runs in ((0.98, True), (1.02, False)):
        simulation = Simulation(by(scene, "symplectic_euler", dt=factor * limit))
        # A little noise, since nothing else moves a body that is at rest in itself.
        noise = 1e-6 * np.random.default_rng(1).normal(size=(4, len(scene.masses)))
        simulation.take_state(simulation, noise)
        simulation.advance(60.0)
        lengths = np.abs(np.diff(simulation.positions, axis=0))
        assert (simulation.divergence is None and lengths.max() < 1e3) == runs


MOVING = (
    ("box", 0.5),
    ("tutorial-3.3", 0.2),
    ("water-balloon", 0.5),
    ("water-balloon", 0.9),
    ("triangle", 0.3),
)


@pytest.mark.parametrize(("preset", "method"), part_of([*product(MOVING, METHODS_WITH_LIMIT)], 5))
def test_presets_in_motion(preset: tuple[str, float], method: Method) -> None:
    name, time = preset
    simulation = after(by(sim.load_scene(name), method, dt=DT), time)
    # The meter leaves out that a mass comes further into a wall in the course of the step.
    hold(simulation, 0.02 if simulation.scene.walls else 0.01)


@pytest.fixture(scope="module")
def lying() -> Scene:
    """A polygon that has come to rest on two held masses and the spring between them, with friction."""
    top = of_parts(sim.polygon(sides=5, damping=20.0))
    low = max(m.position[1] for m in top.masses) + 15.0
    n = len(top.masses)
    scene = replace(
        top,
        masses=(*top.masses, sim.Mass(position=(-500.0, low)), sim.Mass(position=(1500.0, low))),
        linear_springs=(
            *top.linear_springs,
            sim.LinearSpring(a=n, b=n + 1, stiffness=1000.0, rest_length=2000.0),
        ),
        anchors=(sim.Anchor(mass=n), sim.Anchor(mass=n + 1)),
        gravity=(0.0, 500.0),
        contact=sim.Contact(distance=12.0, stiffness=500.0, friction=0.9, bounciness=0.3),
        integrator=Integrator(method="auto", dt=1 / 60, tolerance=1e-3),
    )
    simulation = after(scene, 3.0)
    return replace(simulation.scene, pose=simulation.pose())


@pytest.mark.parametrize("method", METHODS_WITH_LIMIT)
def test_a_body_that_lies_on_another(lying: Scene, method: Method) -> None:
    simulation = Simulation(by(lying, method, dt=DT))
    alone = Simulation(by(replace(lying, contact=None), method, dt=DT))
    if method == "velocity_verlet":  # friction at rest damps strongly
        assert simulation.stability().limit < 0.9 * alone.stability().limit
    hold(simulation, 0.02)  # it still creeps


@pytest.mark.parametrize("method", METHODS_WITH_LIMIT)
def test_what_has_yielded_counts(method: Method) -> None:
    # Two springs of 10 px that have yielded to 300 px and are at rest there, at a right angle.
    scene = chain([(10.0, 0.0), (0.0, 0.0), (0.0, 10.0)], stiffness=10000.0, mass=1.0, held=(0, 2))
    places, damage = [(300.0, 0.0), (0.0, 0.0), (0.0, 300.0)], Damage(set_lengths=(290.0, 290.0))
    scene = posed(with_springs(scene, yield_force=1e6), places, damage=damage)
    simulation = Simulation(by(scene, method, dt=DT))
    unit = {"symplectic_euler": 2.0, "velocity_verlet": 2.0, "rk4": math.sqrt(8.0)}[method]
    assert simulation.stability().limit == pytest.approx(unit / math.sqrt(10000.0), rel=1e-3)
    hold(simulation)


def test_walls_that_soften_with_the_step_do_not_limit_it() -> None:
    stone = chain([(0.0, 103.0)], mass=1.0)
    floor = sim.Wall(point=(0.0, 100.0), normal=(0.0, -1.0), hardness=1e6, friction=0.0, bounciness=0.5)
    scene = by(replace(stone, walls=(floor,)), "symplectic_euler", dt=1e-3)
    assert Simulation(scene).stability().limit == math.inf
    other = Simulation(by(scene, "velocity_verlet", dt=DT)).stability()
    assert other.limit > 50.0 * math.sqrt(4.0 / (2.0 * 1e6 * 3.0)), "many times that of the wall as it is"
