"""Walls, wind, a medium, the ground, fillings, contact: forces, derivatives, energies, motion."""

from __future__ import annotations

import math
from functools import cache
from itertools import product
from typing import Any

import msgspec
import numpy as np
import pytest
from msgspec.structs import replace
from scipy.optimize import root_scalar

import sim
from sim import Integrator, Mass, Scene, Simulation
from sim.forces.air import wind_at, wind_gradient_at
from sim.forces.touch.push import damping_factor
from sim.model.system import build_system
from sim.motion.stability import damped_limit
from sim.scene.surroundings import Contact, Gas, Ground, Medium, Wall, Wind
from sim.scene.types import Damage, Method
from sim.solve.registry import METHODS
from tests.amount import part_of
from tests.sim.arrays import Arrays, Floats
from tests.sim.builders import built, hoop
from tests.sim.changes import apart, posed, with_springs
from tests.sim.inside import problem_of, solver_of
from tests.sim.surrounded import BROKEN, KINDS, TOUCHING, around, bare, run, surrounded
from tests.sim.touching import SOFT

FLOOR = Wall(point=(0.0, 0.0), normal=(0.0, -1.0), friction=0.0, bounciness=1.0)


def single(position: tuple[float, float], velocity: tuple[float, float] = (0.0, 0.0), **fields: Any) -> Scene:
    """One mass by itself, under no gravity unless `fields` say so."""
    mass = Mass(position=position, velocity=velocity, mass=3.0)
    return Scene(name="single", masses=(mass,), **fields)


# ------------------------------------------------------------------------- walls
def test_a_mass_rests_at_the_depth_that_the_hardness_says() -> None:
    scene = single((0.0, -1.0), gravity=(0.0, 1800.0), walls=(replace(FLOOR, bounciness=0.2),))
    resting = run(scene, 20.0, tolerance=1e-4)
    # It bounces ever less, but never quite stops.
    assert resting.positions[0, 1] == pytest.approx(math.sqrt(1800.0 / FLOOR.hardness), abs=0.05)


def test_the_loss_of_a_bounce_is_zero_where_nothing_is_lost_and_grows() -> None:
    losses = [damping_factor(e) for e in (1.0, 0.99, 0.7, 0.3, 0.1, 0.01)]
    assert losses[0] == 0.0
    assert losses == sorted(losses)
    assert damping_factor(0.0) == losses[-1]


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
    again = replace(gust, seed=6)
    anew = Arrays(single((0.0, 0.0), air_friction=0.1, wind=again)).body.environment.air
    assert wind_at(anew, 0.0, 0.0, 0.0) != pytest.approx(wind_at(around, 0.0, 0.0, 0.0))


def test_still_wind_is_still_air() -> None:
    scene = surrounded("steady wind", seed=2)
    still = replace(scene, wind=Wind(velocity=(0.0, 0.0)))
    none = replace(scene, wind=None)
    one, other = (run(each, 0.2, "adams", tolerance=1e-8) for each in (still, none))
    assert apart(one, other) <= 1e-4


# ------------------------------------------------------------------------- a medium, and the ground
def stick(turn: float, velocity: tuple[float, float] = (0.0, 0.0), **fields: Any) -> Scene:
    """A spring of 40 px at an angle in degrees, with 2 kg at each end."""
    ends = [(0.0, 0.0), (40.0 * math.cos(math.radians(turn)), 40.0 * math.sin(math.radians(turn)))]
    return built(ends, velocities=[velocity] * 2, mass=2.0, stiffness=1e4, rest_length=40.0, **fields)


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
    rod = with_springs(replace(rod, anchors=(), bodies=()), strength=1e6, rest_length=40.0)
    moving = [(30.0, 70.0)] * 4
    slowed = [
        Simulation(posed(rod, speeds=moving, damage=Damage(broken=broken))).loads.forces
        for broken in ((), (0,), (0, 1))
    ]
    # In line, mass 1 loses half of what the medium does to it, and keeps its friction; mass 0 loses both.
    assert np.abs(slowed[1][0]).max() <= 1e-9 < np.abs(slowed[0][0]).min()
    assert np.abs(slowed[2][1]).max() <= 1e-9
    by_friction = slowed[0][1] - 2.0 * (slowed[0][1] - slowed[1][1])
    alone = Simulation(posed(replace(rod, medium=msgspec.UNSET), speeds=moving)).loads.forces
    assert by_friction == pytest.approx(alone[1], rel=1e-4)
    assert slowed[1][2:] == pytest.approx(slowed[0][2:])


def test_a_medium_sets_the_time_step_where_it_is_stiffest() -> None:
    thick = stick(0.0, medium=Medium(across=1e4, along=1.0), integrator=Integrator(method="velocity_verlet"))
    estimate = Simulation(thick).stability()
    assert estimate.cause == "resistance"
    # dt c / m = 1 of Verlet, with half of the spring for each end.
    assert estimate.limit == pytest.approx(2.0 / (1e4 * 20.0), rel=0.01)


# ------------------------------------------------------------------------- fillings
@pytest.mark.parametrize("method", METHODS)
def test_a_balloon_squeezed_to_nothing_comes_back(method: Method) -> None:
    gas = Gas(masses=tuple(range(24)), pressure=300.0, outside=100.0)
    balloon = hoop(24, 80.0, mass=0.2, stiffness=3000.0, damping=3.0, fillings=(gas,), air_friction=1e-3)
    x, y = np.array([mass.position for mass in balloon.masses]).T
    simulation = run(posed(balloon, zip(x, 1e-3 * y, strict=True)), 1.0, method, dt=1e-4, tolerance=0.1)
    assert simulation.divergence is None
    assert simulation.time == pytest.approx(1.0)
    assert area_of(*simulation.positions.T) > 0.5 * area_of(x, y)


def area_of(x: Floats, y: Floats) -> float:
    return 0.5 * float((x * np.roll(y, -1) - np.roll(x, -1) * y).sum())


@pytest.mark.parametrize("method", METHODS)
def test_a_gas_whose_area_is_tiny_makes_no_energy(method: Method) -> None:
    """A ring that is turned inside out and comes back; what is in it has p A = 0.0004 kg px²/s²."""
    gas = Gas(masses=tuple(range(12)), pressure=400.0, outside=3.0, area=1e-6)
    ring = hoop(12, 50.0, mass=0.5, stiffness=2000.0, damping=1.0, fillings=(gas,))
    masses = tuple(replace(m, velocity=(-12.0 * m.position[0], 6.0 * m.position[1])) for m in ring.masses)
    simulation = Simulation(
        replace(ring, masses=masses, integrator=Integrator(method=method, dt=1e-3, tolerance=0.1))
    )
    largest = simulation.energy().kinetic
    for _ in range(20):
        assert simulation.step(25) == 25
        largest = max(largest, simulation.energy().kinetic + simulation.energy().linear)
        assert abs(simulation.energy().residual) < 0.02 * largest
    (row,) = simulation.tables[0].body.environment.fillings.rows.tolist()
    assert row[1] * row[3] == pytest.approx(4e-4), "it is the same gas"


# ------------------------------------------------------------------------- as a whole
@cache
def where_it_comes_to(kind: str, seconds: float) -> tuple[Scene, Floats]:
    """A scene, and where its masses are after a while."""
    scene = around(kind, 3)
    return scene, run(scene, seconds, "rodas5p", tolerance=1e-9).positions


@pytest.mark.parametrize(("kind", "seconds", "rough"), [("all", 0.25, 2.0), ("girder in contact", 0.1, 1.0)])
@pytest.mark.parametrize("method", METHODS)
def test_every_method_comes_to_the_same_place(
    method: Method, kind: str, seconds: float, rough: float
) -> None:
    scene, reference = where_it_comes_to(kind, seconds)
    numbers = {"dt": 2e-5 if METHODS[method].order == 1 else 1e-4, "tolerance": 1e-4}
    apart = np.abs(run(scene, seconds, method, **numbers).positions - reference).max()
    assert apart <= (rough if METHODS[method].order == 1 else 0.1)


IN_BALANCE = [*KINDS, *(kind for kind in TOUCHING if kind.startswith("girder"))]
BALANCED = [
    (method, kind)
    for method, kind in product(["auto", "adams", "rodas5p", "rk4", "velocity_verlet"], IN_BALANCE)
    if (method, kind) != ("rodas5p", BROKEN)  # which takes minutes
]


@pytest.mark.parametrize(("method", "kind"), part_of([*BALANCED], 5))
def test_the_balance_closes(method: Method, kind: str) -> None:
    scene = around(kind, 5, held=(2,))
    simulation = Simulation(replace(scene, integrator=Integrator(method=method, dt=1e-5, tolerance=1e-8)))
    simulation.energy()
    x, y = simulation.positions[2].tolist()
    worst = 0.0
    for i in range(20):
        simulation.lead(2, (x + i, y - 2.0 * i))
        simulation.step(500)
        worst = max(worst, abs(simulation.energy().residual))
    balance = simulation.energy()
    largest = abs(balance.kinetic) + abs(balance.linear) + abs(balance.damping) + abs(balance.air)
    assert worst <= (1e-3 if "sticks" in kind else 1e-4) * largest
    solid = any(mass.solid for mass in scene.masses)
    rough = bool(scene.walls or scene.ground or scene.contact or solid)
    assert (balance.walls > 0.0 or balance.contact > 0.0 or balance.friction < 0.0) == rough
    assert (balance.friction == 0.0) == (not rough)
    assert (balance.fillings != 0.0) == bool(scene.fillings)


def test_scenes_pay_only_for_what_surrounds_and_touches_and_breaks_their_bodies() -> None:
    for scene in (sim.load_scene("ring"), replace(sim.load_scene("ring"), contact=Contact(distance=0.0))):
        simulation = Simulation(scene)
        simulation.step()
        system, state = simulation.tables
        environment, matrix = system.body.environment, solver_of(simulation).matrix
        assert not environment.present and not system.body.limits.present
        assert problem_of(simulation).no_tunnelling == 0
        assert max(array.size for _, array in environment.contact.arrays()) <= 17
        for table in (environment.air, environment.resistance, environment.walls, environment.fillings):
            assert all(array.size == 0 for name, array in table.arrays() if name != "start")
        for array in (
            matrix.of_mass, matrix.coupling, matrix.coupling_state, matrix.krylov, matrix.hessenberg,
            state.set_length, state.set_angle, state.hardened, state.broken,
            state.wall_stretch, state.wall_place, state.contact_start, state.contact_stretch,
        ):  # fmt: skip
            assert array.size == 0
        moment = simulation.capture()
        assert moment.damage is None and moment.grips is None


@pytest.mark.parametrize(("kind", "seconds", "near"), [("all", 0.1, 1.0), ("girder in contact", 0.05, 0.1)])
def test_numpy_moves_bodies_until_kernels_are_there(
    kind: str, seconds: float, near: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("sim.motion.motion.is_ready", lambda names: False)
    plain = Simulation(around(kind, 3), wait=False)
    plain.advance(seconds)
    assert plain.plain
    monkeypatch.undo()
    assert np.abs(plain.positions - run(around(kind, 3), seconds, "rodas5p").positions).max() <= near


HARD: dict[str, dict[str, Any]] = {
    "walls": {"walls": (Wall(point=(0.0, -50.0), normal=(0.0, -1.0), hardness=1e5),)},
    "fillings": {"fillings": (Gas(masses=(0, 2, 4, 5, 3, 1), pressure=1e6),)},
    "contact": {"contact": replace(SOFT, stiffness=1e4)},
}
"""What limits the time step of a body, by what the meter says of it."""


@pytest.mark.parametrize("cause", HARD)
def test_the_stability_meter_sees_what_surrounds_a_body(cause: str) -> None:
    scene = bare(around("girder in contact" if cause == "contact" else "walls", 1))
    scene = replace(scene, integrator=Integrator(method="velocity_verlet", dt=1e-6))
    hard = replace(scene, **HARD[cause])
    estimate = Simulation(hard).stability()
    assert estimate.cause == cause
    assert estimate.limit < 0.5 * Simulation(scene).stability().limit
    if cause == "contact":
        assert damped_limit(build_system(hard)) < 0.5 * damped_limit(build_system(scene))
