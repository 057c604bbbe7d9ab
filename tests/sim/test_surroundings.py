"""Walls, wind, a medium, the ground and fillings: forces, derivatives, energies, motion by every method."""

from __future__ import annotations

import math
from functools import cache
from itertools import product
from typing import Any

import msgspec
import numpy as np
import pytest
from scipy.optimize import root_scalar

import sim
from sim import Integrator, LinearSpring, Mass, Scene, Simulation
from sim.forces.air import wind_at, wind_gradient_at
from sim.forces.push import REFERENCE_SPEED, damping_factor
from sim.methods.registry import METHODS
from sim.physics import Physics
from sim.scene.surroundings import Gas, Ground, Liquid, Medium, Wall, Wind
from sim.scene.types import Damage, Method
from tests.amount import part_of
from tests.sim.arrays import Arrays, Floats
from tests.sim.inside import same_state, system_of
from tests.sim.surrounded import KINDS, surrounded

REPLACE = msgspec.structs.replace
FLOOR = Wall(point=(0.0, 0.0), normal=(0.0, -1.0), friction=0.0, bounciness=1.0)


def single(position: tuple[float, float], velocity: tuple[float, float] = (0.0, 0.0), **fields: Any) -> Scene:
    """One mass by itself, under no gravity unless `fields` say so."""
    mass = Mass(position=position, velocity=velocity, mass=3.0)
    return Scene(name="single", masses=(mass,), **fields)


def run(scene: Scene, seconds: float, method: Method = "auto", **numbers: float) -> Simulation:
    integrator = Integrator(**{"method": method, "dt": 1e-3, "tolerance": 1e-6, **numbers})
    simulation = Simulation(REPLACE(scene, integrator=integrator))
    simulation.advance(seconds)
    return simulation


# ------------------------------------------------------------------------- forces
@pytest.mark.parametrize("step", ["rk4", "symplectic_euler"])
@pytest.mark.parametrize("kind", KINDS)
def test_the_kernels_do_what_the_physics_in_numpy_says(kind: str, step: Method) -> None:
    for seed in range(4):
        scene = surrounded(kind, seed=seed, held=(1,))
        arrays = Arrays(REPLACE(scene, integrator=Integrator(method=step, dt=1e-3)))
        arrays.state.clock[0] = 0.37
        expected = Physics(arrays.body, arrays.state).accelerations(
            arrays.state.x + 1j * arrays.state.y, arrays.state.vx + 1j * arrays.state.vy
        )
        flat = np.concatenate((expected.real, expected.imag))[arrays.here]
        found = arrays.accelerations(arrays.q, arrays.v)
        assert np.abs(found - flat).max() <= 1e-12 * np.abs(flat).max()
        without = Arrays(
            REPLACE(scene, walls=(), wind=None, fillings=(), medium=msgspec.UNSET, ground=msgspec.UNSET)
        )
        assert np.abs(found - without.accelerations(arrays.q, arrays.v)).max() > 1.0


@pytest.mark.parametrize("kind", ["walls", "fillings", "all"])
def test_the_energies_are_those_of_the_physics_in_numpy(kind: str) -> None:
    scene = surrounded(kind, seed=2)
    balance, arrays = Simulation(scene).energy(), Arrays(scene)
    expected = Physics(arrays.body, arrays.state).energies(arrays.state.x + 1j * arrays.state.y)
    assert balance.walls == pytest.approx(expected["walls"], rel=1e-12)
    assert balance.fillings == pytest.approx(expected["fillings"], rel=1e-12)
    assert balance.walls + abs(balance.fillings) > 1.0


@pytest.mark.parametrize("kind", ["gas", "fillings"])
def test_a_filling_pushes_nothing_away_as_a_whole(kind: str) -> None:
    arrays = Arrays(surrounded(kind, joints=False, damping=0.0, air=0.0, gravity=(0.0, 0.0)))
    force = arrays.pairs_of(arrays.weight * arrays.accelerations(arrays.q, arrays.v))
    without = Arrays(
        REPLACE(surrounded(kind, joints=False, damping=0.0, air=0.0, gravity=(0.0, 0.0)), fillings=())
    )
    force -= without.pairs_of(without.weight * without.accelerations(without.q, without.v))
    at = arrays.pairs(arrays.q)
    size = float(np.abs(force).sum())
    assert size > 100.0
    assert np.abs(force.sum(0)).max() <= 1e-14 * size
    torque = float((at[:, 0] * force[:, 1] - at[:, 1] * force[:, 0]).sum())
    assert abs(torque) <= 1e-14 * size * float(np.abs(at).max())


@pytest.mark.parametrize("kind", ["walls", "gas", "fillings"])
def test_the_force_is_the_gradient_of_the_energy(kind: str) -> None:
    for seed in range(3):
        scene = surrounded(kind, seed=seed, damping=0.0, twist=0.0, air=0.0)
        walls = tuple(REPLACE(wall, friction=0.0, bounciness=1.0) for wall in scene.walls)
        arrays = Arrays(REPLACE(scene, walls=walls))
        force = arrays.weight * arrays.accelerations(arrays.q, 0.0 * arrays.v)
        assert np.abs(force + arrays.gradient()).max() <= 1e-7 * np.abs(force).max()


# ------------------------------------------------------------------------- derivatives
@pytest.mark.parametrize("kind", KINDS)
def test_the_matrix_is_that_of_the_forces(kind: str) -> None:
    for seed, held in ((1, ()), (2, (0, 3))):
        arrays = Arrays(surrounded(kind, seed=seed, held=held))
        g = 150.0
        by_place = arrays.derivative(by_velocity=False, step=1e-3)
        by_speed = arrays.derivative(by_velocity=True, step=0.01)
        expected = g * g * np.eye(len(by_place)) - g * by_speed - by_place
        found = np.linalg.inv(arrays.inverse(g * g, g))
        assert np.abs(found - expected).max() <= 1e-7 * np.abs(expected).max()


@pytest.mark.parametrize("kind", ["walls", "gusts", "medium", "ground", "all"])
def test_the_product_with_the_derivative_by_velocities(kind: str) -> None:
    arrays = Arrays(surrounded(kind, seed=4, held=(1,)))
    expected = arrays.derivative(by_velocity=True, step=0.01)
    start, z = np.random.default_rng(1).normal(size=(2, arrays.here.size)) * 100.0
    change = 0.7 * expected @ z
    found = arrays.resistance(z, 0.7, start) - start
    assert np.abs(found - change).max() <= 1e-7 * np.abs(change).max()


@pytest.mark.parametrize("kind", KINDS)
def test_the_definite_matrix_is_one(kind: str) -> None:
    for seed in range(4):
        arrays = Arrays(surrounded(kind, seed=seed))
        whole = np.linalg.inv(arrays.inverse(1e-3, 150.0, definite=True))
        stiffness = arrays.weight[:, None] * whole
        size = np.abs(stiffness).max()
        assert np.abs(stiffness - stiffness.T).max() <= 1e-9 * size
        assert np.linalg.eigvalsh(0.5 * (stiffness + stiffness.T))[0] >= -1e-9 * size


# ------------------------------------------------------------------------- walls
def test_a_mass_rests_at_the_depth_that_the_hardness_says() -> None:
    scene = single((0.0, -1.0), gravity=(0.0, 1800.0), walls=(REPLACE(FLOOR, bounciness=0.2),))
    resting = run(scene, 20.0, tolerance=1e-4)
    # It bounces ever less, but never quite stops.
    assert resting.positions[0, 1] == pytest.approx(math.sqrt(1800.0 / FLOOR.hardness), abs=0.05)


@pytest.mark.parametrize("bounciness", [0.05, 0.3, 0.8, 1.0])
@pytest.mark.parametrize("method", ["rodas5p", "adams", "velocity_verlet"])
def test_a_mass_leaves_a_wall_with_its_bounciness(method: Method, bounciness: float) -> None:
    scene = single((0.0, -20.0), (0.0, REFERENCE_SPEED), walls=(REPLACE(FLOOR, bounciness=bounciness),))
    left = run(scene, 0.5, method, dt=1e-5)
    assert left.velocities[0, 1] == pytest.approx(-bounciness * REFERENCE_SPEED, rel=1e-4)


def test_the_loss_of_a_bounce_is_zero_where_nothing_is_lost_and_grows() -> None:
    losses = [damping_factor(e) for e in (1.0, 0.99, 0.7, 0.3, 0.1, 0.01)]
    assert losses[0] == 0.0
    assert losses == sorted(losses)
    assert damping_factor(0.0) == losses[-1]


def test_the_deepest_point_of_a_bounce() -> None:
    # All kinetic energy is in the wall: v² / 2 = hardness d³ / 3.
    scene = single((0.0, 0.0), (0.0, 500.0), walls=(FLOOR,))
    simulation = Simulation(REPLACE(scene, integrator=Integrator(method="rodas5p", dt=1e-5, tolerance=1e-9)))
    deepest = 0.0
    while simulation.velocities[0, 1] > 0.0:
        simulation.step()
        deepest = max(deepest, simulation.positions[0, 1])
    assert deepest == pytest.approx((1.5 * 500.0**2 / FLOOR.hardness) ** (1.0 / 3.0), rel=1e-6)


def test_a_slope_holds_or_lets_slide_as_friction_says() -> None:
    # On a slope of 30 degrees, held by friction of more than tan(30°) but for creep.
    turn = math.radians(30.0)
    normal, down = (math.sin(turn), -math.cos(turn)), np.array([math.cos(turn), math.sin(turn)])
    pulling = 1000.0 * math.sin(turn)

    def sliding(friction: float) -> tuple[float, float]:
        wall = REPLACE(FLOOR, normal=normal, friction=friction, bounciness=0.1, slip_speed=5.0)
        depth = math.sqrt(1000.0 * math.cos(turn) / wall.hardness)
        start = (-normal[0] * depth, -normal[1] * depth)
        moved = run(single(start, gravity=(0.0, 1000.0), walls=(wall,)), 1.0)
        return float(moved.positions[0] @ down), float(moved.velocities[0] @ down)

    _, speed = sliding(0.2)
    assert speed == pytest.approx(pulling - 0.2 * 1000.0 * math.cos(turn), rel=0.03)
    way, speed = sliding(1.0)
    assert speed == pytest.approx(5.0 * math.atanh(math.tan(turn)), rel=1e-3)  # it creeps
    assert way == pytest.approx(speed, rel=0.02)


# ------------------------------------------------------------------------- wind
def test_gusts_are_as_strong_as_they_should_be_and_neither_compressed_nor_still() -> None:
    gust = Wind(velocity=(400.0, 300.0), turbulence=0.3, length_scale=200.0, seed=5)
    around = Arrays(single((0.0, 0.0), air_friction=0.1, wind=gust)).body.environment.air
    places = np.random.default_rng(1).uniform(0.0, 1e5, (20_000, 3))
    air = np.array([wind_at(around, *place) + wind_gradient_at(around, *place) for place in places])
    assert air[:, :2].mean(0) == pytest.approx((400.0, 300.0), abs=5.0)
    assert air[:, :2].std(0) == pytest.approx(0.3 * 500.0, rel=0.1)
    assert np.abs(air[:, 2] + air[:, 5]).max() <= 1e-12 * np.abs(air[:, 2:]).max()  # div v = 0
    # The eddies go with the mean wind.
    one, other = wind_at(around, 0.0, 30.0, 40.0), wind_at(around, 2.0, 830.0, 640.0)
    assert one == pytest.approx(other)
    assert np.abs(np.subtract(one, wind_at(around, 2.0, 30.0, 40.0))).max() > 1.0
    again = REPLACE(gust, seed=6)
    anew = Arrays(single((0.0, 0.0), air_friction=0.1, wind=again)).body.environment.air
    assert wind_at(anew, 0.0, 0.0, 0.0) != pytest.approx(wind_at(around, 0.0, 0.0, 0.0))


@pytest.mark.parametrize("method", METHODS)
def test_a_mass_drifts_with_a_steady_wind(method: Method) -> None:
    # v' = c/m (w - v)²: the difference falls as 1 / (1/w + c t / m).
    scene = single((0.0, 0.0), air_friction=0.03, wind=Wind(velocity=(200.0, 0.0)))
    drifting = run(scene, 1.0, method, dt=1e-4)
    expected = 200.0 - 1.0 / (1.0 / 200.0 + 0.01)
    tolerated = 0.02 if METHODS[method].order == 1 else 1e-4
    assert drifting.velocities[0, 0] == pytest.approx(expected, rel=tolerated)
    assert drifting.velocities[0, 1] == 0.0


def test_still_wind_is_still_air() -> None:
    scene = surrounded("steady wind", seed=2)
    still = REPLACE(scene, wind=Wind(velocity=(0.0, 0.0)))
    none = REPLACE(scene, wind=None)
    one, other = (run(each, 0.2, "adams", tolerance=1e-8) for each in (still, none))
    assert np.abs(one.positions - other.positions).max() <= 1e-4


# ------------------------------------------------------------------------- a medium, and the ground
def stick(turn: float, velocity: tuple[float, float] = (0.0, 0.0), **fields: Any) -> Scene:
    """A spring of 40 px at an angle in degrees, with 2 kg at each end."""
    ends = ((0.0, 0.0), (40.0 * math.cos(math.radians(turn)), 40.0 * math.sin(math.radians(turn))))
    return Scene(
        name="stick",
        masses=tuple(Mass(position=end, velocity=velocity, mass=2.0) for end in ends),
        linear_springs=(LinearSpring(a=0, b=1, stiffness=1e4, rest_length=40.0),),
        **fields,
    )


@pytest.mark.parametrize("method", METHODS)
def test_a_stick_that_sinks_at_a_slant_drifts_sideways(method: Method) -> None:
    # Along it, 4 kg g sin(30 deg) = 40 px along v; across it likewise. Twice the drag across leads it aside.
    medium, turn = Medium(across=2.0, along=1.0), np.exp(1j * math.pi / 6.0)
    sinking = run(stick(30.0, gravity=(0.0, 100.0), medium=medium), 3.0, method)
    pull = 4.0 * 100.0j * np.conj(turn)  # along it, and across it
    expected = turn * (pull.real / (40.0 * medium.along) + 1j * pull.imag / (40.0 * medium.across))
    assert expected.real / expected.imag == pytest.approx(math.sqrt(3.0) / 5.0)
    for velocity in sinking.velocities:
        assert complex(*velocity) == pytest.approx(expected, rel=1e-5)


def test_a_medium_is_carried_along_by_the_wind() -> None:
    carried = run(stick(30.0, medium=Medium(), wind=Wind(velocity=(60.0, -25.0))), 3.0, tolerance=1e-8)
    assert carried.velocities == pytest.approx(np.tile((60.0, -25.0), (2, 1)), rel=1e-6)
    assert carried.energy().air == 0.0  # asked for only now, when nothing is resisted any more


@pytest.mark.parametrize(("turn", "coefficient"), [(0.0, 0.2), (180.0, 0.3), (90.0, 0.4), (-90.0, 0.4)])
def test_a_stick_on_the_ground_slides_to_a_stop(turn: float, coefficient: float) -> None:
    # v' = -mu g v / w with w = sqrt(v² + s²): w - s arsinh(s / v) falls by mu g t.
    slip, duration = 40.0, 0.4

    def height(v: float) -> float:
        return math.hypot(v, slip) - slip * math.asinh(slip / v)

    sliding = run(stick(turn, (150.0, 0.0), ground=Ground(slip_speed=slip)), duration, tolerance=1e-8)
    low = height(150.0) - coefficient * 1000.0 * duration
    expected = root_scalar(lambda v: height(v) - low, bracket=(1e-9, 150.0), xtol=1e-12).root
    assert sliding.velocities == pytest.approx(np.tile((expected, 0.0), (2, 1)), rel=1e-6, abs=1e-6)


def test_what_hangs_on_a_broken_spring_rests_on_the_others() -> None:
    rod = sim.rope(
        masses=4, length=120.0, ground=Ground(), medium=Medium(), gravity=(0.0, 0.0), air_friction=0.0
    )
    rod = REPLACE(
        rod,
        bodies=(),
        anchors=(),
        linear_springs=tuple(REPLACE(s, strength=1e6, rest_length=40.0) for s in rod.linear_springs),
    )
    moving = tuple((30.0, 70.0) for _ in rod.masses)
    pose = sim.Pose(positions=tuple(m.position for m in rod.masses), velocities=moving)
    slowed = []
    for broken in ((), (0,), (0, 1)):
        damage = Damage(broken=broken)
        body = Simulation(REPLACE(rod, pose=REPLACE(pose, damage=damage)))
        slowed.append(body.loads.forces)
    # In line, mass 1 loses half of what the medium does to it, and keeps its friction; mass 0 loses both.
    assert np.abs(slowed[1][0]).max() <= 1e-9 < np.abs(slowed[0][0]).min()
    assert np.abs(slowed[2][1]).max() <= 1e-9
    by_friction = slowed[0][1] - 2.0 * (slowed[0][1] - slowed[1][1])
    alone = Simulation(REPLACE(rod, medium=msgspec.UNSET, pose=pose)).loads.forces
    assert by_friction == pytest.approx(alone[1], rel=1e-4)
    assert slowed[1][2:] == pytest.approx(slowed[0][2:])


def test_a_medium_sets_the_time_step_where_it_is_stiffest() -> None:
    thick = stick(0.0, medium=Medium(across=1e4, along=1.0), integrator=Integrator(method="velocity_verlet"))
    estimate = Simulation(thick).stability()
    assert estimate.cause == "resistance"
    # dt c / m = 1 of Verlet, with half of the spring for each end.
    assert estimate.limit == pytest.approx(2.0 / (1e4 * 20.0), rel=0.01)


# ------------------------------------------------------------------------- fillings
def balloon(**changes: Any) -> Scene:
    """A ring of 24 springs with a gas inside."""
    turns = [math.tau * i / 24 for i in range(24)]
    edge = 2.0 * 80.0 * math.sin(math.pi / 24)
    fields: dict[str, Any] = {
        "name": "balloon",
        "masses": tuple(Mass(position=(80 * math.cos(v), 80 * math.sin(v)), mass=0.2) for v in turns),
        "linear_springs": tuple(
            sim.LinearSpring(a=i, b=(i + 1) % 24, stiffness=3000.0, damping=3.0, rest_length=edge)
            for i in range(24)
        ),
        "fillings": (Gas(masses=tuple(range(24)), pressure=300.0, outside=100.0),),
    }
    return Scene(**{**fields, **changes})


def area_of(positions: Floats) -> float:
    x, y = positions.T
    return 0.5 * float((x * np.roll(y, -1) - np.roll(x, -1) * y).sum())


@pytest.mark.parametrize(
    "filling",
    [
        Gas(masses=tuple(range(24)), pressure=300.0, outside=100.0),
        Gas(masses=tuple(range(23, -1, -1)), pressure=300.0, outside=100.0),
        Liquid(masses=tuple(range(24)), bulk_modulus=2000.0, area=25_000.0),
    ],
)
def test_a_balloon_rests_where_its_pressure_balances_the_springs(filling: Gas | Liquid) -> None:
    scene = balloon(fillings=(filling,))
    at = np.array(sim.equilibrium(scene).positions)
    edges = np.hypot(*(np.roll(at, -1, 0) - at).T)
    start = area_of(np.array([m.position for m in scene.masses]))
    if isinstance(filling, Gas):
        pressure = 300.0 * start / area_of(at) - 100.0
    else:
        pressure = 2000.0 * (1.0 - area_of(at) / 25_000.0)
    # A regular polygon: tension * 2 sin(pi/n) = pressure * distance of the masses before and after / 2 ...
    tension = 3000.0 * (edges.mean() - scene.linear_springs[0].rest_length)
    assert np.ptp(edges) <= 1e-6
    assert 2.0 * tension * math.sin(math.pi / 24) == pytest.approx(
        pressure * edges.mean() * math.cos(math.pi / 24), rel=1e-6
    )
    assert tension > 100.0


@pytest.mark.parametrize("method", METHODS)
def test_a_balloon_squeezed_to_nothing_comes_back(method: Method) -> None:
    positions = [m.position for m in balloon().masses]
    flat = tuple((x, 1e-3 * y) for x, y in positions)
    scene = balloon(pose=sim.Pose(positions=flat, velocities=((0.0, 0.0),) * 24), air_friction=1e-3)
    simulation = run(scene, 1.0, method, dt=1e-4, tolerance=0.1)
    assert simulation.divergence is None
    assert simulation.time == pytest.approx(1.0)
    assert area_of(simulation.positions) > 0.5 * area_of(np.array(positions))


# ------------------------------------------------------------------------- all methods
@cache
def where_it_comes_to() -> tuple[Scene, Floats]:
    """A scene, and where its masses are after a quarter of a second."""
    scene = surrounded("all", seed=3)
    return scene, run(scene, 0.25, "rodas5p", tolerance=1e-9).positions


@pytest.mark.parametrize("method", METHODS)
def test_every_method_comes_to_the_same_place(method: Method) -> None:
    scene, reference = where_it_comes_to()
    numbers = {"dt": 2e-5 if METHODS[method].order == 1 else 1e-4, "tolerance": 1e-4}
    off = np.abs(run(scene, 0.25, method, **numbers).positions - reference).max()
    assert off <= (2.0 if METHODS[method].order == 1 else 0.1)


@pytest.mark.parametrize(
    ("kind", "method", "order"),
    [
        *[
            ("fillings", method, METHODS[method].order)
            for method in ("symplectic_euler", "velocity_verlet", "rk4")
        ],
        # A wall is entered with a jump of the second derivative of the force.
        ("walls", "velocity_verlet", 2),
        ("walls", "rk4", 2),
        ("walls", "symplectic_euler", 1),
    ],
)
def test_errors_fall_with_the_order_of_the_method(kind: str, method: Method, order: int) -> None:
    scene = surrounded(kind, seed=3, air=0.0)
    reference = run(scene, 0.1, "rodas5p", dt=0.1, tolerance=1e-11).positions
    errors = [np.abs(run(scene, 0.1, method, dt=dt).positions - reference).max() for dt in (2e-4, 5e-5)]
    assert math.log(errors[0] / errors[1], 4.0) >= order - 0.3, errors


BALANCED = product(["auto", "adams", "rodas5p", "rk4", "velocity_verlet"], KINDS)


@pytest.mark.parametrize(("method", "kind"), part_of([*BALANCED], 4))
def test_the_balance_closes(method: Method, kind: str) -> None:
    scene = surrounded(kind, seed=5, held=(2,))
    simulation = Simulation(REPLACE(scene, integrator=Integrator(method=method, dt=1e-5, tolerance=1e-8)))
    simulation.energy()
    x, y = scene.masses[2].position
    worst = 0.0
    for i in range(20):
        simulation.lead(2, (x + i, y - 2.0 * i))
        simulation.step(500)
        worst = max(worst, abs(simulation.energy().residual))
    balance = simulation.energy()
    largest = abs(balance.kinetic) + abs(balance.linear) + abs(balance.damping) + abs(balance.air)
    assert worst <= 1e-4 * largest
    assert (balance.walls > 0.0 or balance.friction < 0.0) == bool(scene.walls or scene.ground)
    assert (balance.fillings != 0.0) == bool(scene.fillings)
    assert (balance.friction == 0.0) == (not (scene.walls or scene.ground))


def test_the_same_bits_again_and_after_going_back() -> None:
    scene = surrounded("all", seed=6)
    one, other = run(scene, 0.3), run(scene, 0.3)
    assert same_state(one, other)
    moment = one.capture()
    ends = []
    for _ in range(2):
        one.restore(moment)
        one.advance(0.2)
        ends.append(one.positions)
    assert np.array_equal(*ends)


def test_where_nothing_surrounds_there_is_nothing_to_pay_for() -> None:
    environment = system_of(Simulation(sim.load_scene("ring"))).body.environment
    assert not environment.present
    for table in (environment.air, environment.resistance, environment.walls, environment.fillings):
        assert all(array.size == 0 for name, array in table.arrays() if name != "start")


def test_numpy_moves_a_body_in_surroundings_until_kernels_are_there(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("sim.motion.simulation.is_ready", lambda names: False)
    scene = surrounded("all", seed=3)
    plain = Simulation(scene, wait=False)
    plain.advance(0.1)
    assert plain.plain
    monkeypatch.undo()
    assert np.abs(plain.positions - run(scene, 0.1, "rodas5p").positions).max() <= 1.0


@pytest.mark.parametrize("kind", ["walls", "gas"])
def test_the_stability_meter_sees_walls_and_fillings(kind: str) -> None:
    hard = {
        "walls": {"walls": (Wall(point=(0.0, -50.0), normal=(0.0, -1.0), hardness=1e5),)},
        "gas": {"fillings": (Gas(masses=(0, 2, 4, 5, 3, 1), pressure=1e6),)},
    }[kind]
    scene = REPLACE(surrounded(kind, seed=1), **hard)
    scene = REPLACE(scene, integrator=Integrator(method="velocity_verlet", dt=1e-5))
    estimate = Simulation(scene).stability()
    assert estimate.cause == {"walls": "walls", "gas": "fillings"}[kind]
    bare = Simulation(REPLACE(scene, walls=(), fillings=())).stability()
    assert estimate.limit < 0.5 * bare.limit


@pytest.mark.parametrize("method", METHODS)
def test_a_gas_whose_area_is_tiny_makes_no_energy(method: Any) -> None:
    """A ring that is turned inside out and comes back; what is in it has p A = 0.0004 kg px²/s²."""
    count, radius = 12, 50.0
    turns = np.arange(count) * math.tau / count
    places = radius * np.column_stack((np.cos(turns), np.sin(turns)))
    edge = 2.0 * radius * math.sin(math.pi / count)
    scene = Scene(
        name="inside out",
        masses=tuple(
            Mass(position=(x, y), velocity=(-12.0 * x, 6.0 * y), mass=0.5) for x, y in places.tolist()
        ),
        linear_springs=tuple(
            LinearSpring(a=i, b=(i + 1) % count, stiffness=2000.0, damping=1.0, rest_length=edge)
            for i in range(count)
        ),
        gravity=(0.0, 0.0),
        fillings=(Gas(masses=tuple(range(count)), pressure=400.0, outside=3.0, area=1e-6),),
        integrator=Integrator(method=method, dt=1e-3, tolerance=0.1),
    )
    simulation = Simulation(scene)
    largest = simulation.energy().kinetic
    for _ in range(20):
        assert simulation.step(25) == 25
        largest = max(largest, simulation.energy().kinetic + simulation.energy().linear)
        assert abs(simulation.energy().residual) < 0.02 * largest
    (row,) = simulation.tables[0].body.environment.fillings.rows.tolist()
    assert row[1] * row[3] == pytest.approx(4e-4), "it is the same gas"
