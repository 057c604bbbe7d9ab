"""Friction that holds: tangential springs of walls and of contact, and what comes to rest by them."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import msgspec
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec.structs import replace
from numpy.typing import NDArray

import sim
from sim import Integrator, Scene, Simulation
from sim.edit.build import pin, remove
from sim.edit.edit import Selection, carried
from sim.engine.table import Table
from sim.forces.reference import Physics
from sim.forces.touch.pairs import Contacts
from sim.forces.touch.walls import NOWHERE
from sim.motion.stability import finished
from sim.scene.surroundings import Contact, Wall
from sim.scene.types import Method
from sim.solve.registry import METHODS
from sim.store.files import decode_scene, encode_scene
from studies.bench.heap import heap
from tests.sim.arrays import Arrays, off
from tests.sim.builders import built
from tests.sim.changes import after, apart, by, with_walls
from tests.sim.checks import known
from tests.sim.inside import begin_anew, system_of
from tests.sim.touching import HELD, crumpled, joined, line

G, TURN = 1000.0, math.radians(30.0)
DOWN = np.array((math.cos(TURN), math.sin(TURN)))


def block(friction: float, method: Method = "velocity_verlet", dt: float = 1e-3, speed: float = 0.0) -> Scene:
    """Two masses on a spring, one behind the other at rest in a slope of 30 degrees; y points down."""
    normal, depth = (math.sin(TURN), -math.cos(TURN)), math.sqrt(G * math.cos(TURN) / 8000.0)
    start = -depth * np.array(normal)
    wall = Wall(point=(0.0, 0.0), normal=normal, friction=friction, tangential_hardness=5000.0)
    return built(
        [tuple((start + way * DOWN).tolist()) for way in (0.0, 30.0)],
        velocities=[tuple((speed * DOWN).tolist())] * 2, stiffness=2000.0, damping=5.0, rest_length=30.0,
        gravity=(0.0, G), walls=(wall,), integrator=Integrator(method=method, dt=dt, tolerance=1e-3),
    )  # fmt: skip


def along(simulation: Simulation) -> float:
    return float((simulation.positions @ DOWN).mean())


STEPS = {"auto": 1.0 / 60.0, "rodas4": 1.0 / 60.0, "rodas5p": 1.0 / 60.0, "adams": 1.0 / 60.0}


# ------------------------------------------------------------------------- a block on a slope
@pytest.mark.parametrize("method", METHODS)
def test_a_block_on_a_slope_stays_or_slides_as_coulomb_says(method: Method) -> None:
    dt = STEPS.get(method, 1e-3)
    # What chooses its steps by its errors leaves vibrations within its tolerance of 1e-3 px; of what size and
    # phase, rounding decides. The fastest has 73 rad/s, of which the square is 2 hardness depth.
    off, speed = (1e-3, 0.073) if METHODS[method].adaptive else (1e-9, 1e-6)
    held = after(block(0.7, method, dt), 3.0)
    before = along(held)
    held.advance(3.0)
    # tan(30°) = 0.577: it holds, by a stretch of g sin / tangential_hardness, about which it has settled.
    assert abs(along(held) - before) < off
    assert np.abs(held.velocities).max() < speed
    stretches = [row[2] for row in known(held.capture().grips).walls]
    assert np.mean(stretches) == pytest.approx(G * math.sin(TURN) / 5000.0, abs=off)

    sliding = after(block(0.2, method, dt), 1.0)
    before = float((sliding.velocities @ DOWN).mean())
    sliding.advance(1.0)
    gained = float((sliding.velocities @ DOWN).mean()) - before
    assert gained == pytest.approx(G * (math.sin(TURN) - 0.2 * math.cos(TURN)), rel=1e-3)


def test_a_block_does_not_move_in_an_hour_where_friction_without_springs_creeps() -> None:
    scene = block(0.7, dt=2.5e-3)
    held = after(scene, 5.0)
    before = along(held)
    held.advance(3600.0)
    assert abs(along(held) - before) < 1e-9
    creeping = after(with_walls(scene, tangential_hardness=0.0), 5.0)
    before = along(creeping)
    creeping.advance(10.0)
    assert along(creeping) - before > 50.0


def test_a_block_that_slides_stops_where_coulomb_says_and_stays() -> None:
    mu, speed = 0.9, 300.0
    simulation = Simulation(block(mu, "rk4", 1e-4, speed))
    start = along(simulation)
    simulation.advance(2.0)
    braked = G * (mu * math.cos(TURN) - math.sin(TURN))
    assert along(simulation) - start == pytest.approx(speed**2 / (2.0 * braked), rel=5e-3)
    assert np.abs(simulation.velocities).max() < 1e-6


# ------------------------------------------------------------------------- what analyses know of it
def test_analyses_know_the_friction_that_holds_a_block() -> None:
    """It stands in a run, so it has a pose at rest, vibrations about it, and a sag."""
    scene = block(0.9, "auto")
    pose = sim.equilibrium(scene)
    assert np.abs(np.array(pose.positions) - after(scene, 20.0).positions).max() < 0.05
    assert len(known(pose.grips).walls) == 2
    assert np.abs(after(replace(scene, pose=pose), 2.0).positions - pose.positions).max() < 1e-3
    found = sim.tuning(scene)
    assert found.sag is not None
    # Both masses along the slope together: by the walls' springs alone, of 5000 1/s².
    assert known(found.slowest).frequency == pytest.approx(math.sqrt(5000.0) / math.tau, rel=1e-6)
    assert not found.notes
    kept = sim.keep_shape(replace(scene, pose=replace(pose, grips=None)))
    there = known(kept.pose)
    assert there.grips is not None
    assert np.abs(after(kept, 2.0).positions - there.positions).max() < 1e-6


def test_analyses_know_where_friction_does_not_hold() -> None:
    with pytest.raises(sim.InputError, match=r"nothing stops it$"):
        sim.equilibrium(block(0.5))  # tan 30° is .58
    with pytest.raises(sim.DesignError):
        sim.keep_shape(block(0.5))


def test_a_mass_on_a_floor_that_holds_is_as_stiff_along_it_as_it_says() -> None:
    floor = Wall(point=(0.0, 0.0), normal=(0.0, -1.0), friction=0.5, hardness=8000.0, tangential_hardness=1e4)
    scene = Scene(name="one", masses=(sim.Mass(position=(0.0, 0.0)),), walls=(floor,), gravity=(0.0, G))
    resting = replace(scene, pose=sim.equilibrium(scene))
    squares = sim.vibrations(resting, 2).omega ** 2
    assert squares == pytest.approx([2.0 * math.sqrt(G * 8000.0), 1e4], rel=1e-6)


# ------------------------------------------------------------------------- energy
@pytest.mark.parametrize("method", ["velocity_verlet", "rk4", "auto", "rodas5p", "generalized_alpha"])
def test_the_balance_has_what_sticks_and_what_slides(method: Method) -> None:
    balance = after(block(0.9, method, 1e-4, 300.0), 2.0).energy()
    way = G * (0.9 * math.cos(TURN) - math.sin(TURN))
    lost = 2.0 * 0.9 * G * math.cos(TURN) * 300.0**2 / (2.0 * way)  # by both masses, of 1 kg
    assert balance.friction == pytest.approx(-lost, rel=0.01)
    assert abs(balance.residual) < 1e-3 * lost
    stretch = G * math.sin(TURN) / 5000.0
    pushed = 2.0 * 8000.0 * math.sqrt(G * math.cos(TURN) / 8000.0) ** 3 / 3.0
    assert balance.walls - pushed == pytest.approx(2.0 * 0.5 * 5000.0 * stretch**2, rel=0.01)


# ------------------------------------------------------------------------- history
def test_what_sticks_goes_on_sticking_after_it_was_saved_and_restored() -> None:
    scene = block(0.7)
    held, still = (after(scene, 3.0) for _ in range(2))
    moment = held.capture()
    held.advance(1.0)
    held.restore(moment)
    held.advance(1.0)
    assert apart(held, still) < 1e-9
    # As a file.
    again = after(decode_scene(encode_scene(replace(scene, pose=moment_pose(held))), "block"), 1.0)
    assert apart(again, still) < 1e-9
    # With other numbers, and in another simulation.
    held.replace(replace(scene, air_friction=0.001))
    held.advance(1.0)
    other = Simulation(scene)
    other.take_state(held)
    other.advance(1.0)
    assert apart(other, still) < 1e-9
    # Without its grips, it slides until they hold again.
    lost = after(replace(scene, pose=replace(moment_pose(held), grips=None)), 1.0)
    assert apart(lost, still) > 0.01


def moment_pose(simulation: Simulation) -> sim.Pose:
    pose = simulation.pose()
    assert pose.grips
    return pose


def test_a_wall_that_is_moved_holds_nothing_any_more() -> None:
    scene = block(0.7)
    held = after(scene, 1.0)
    held.replace(with_walls(scene, point=(3.0, 0.0)))
    assert held.capture().grips is None


def test_an_edit_that_takes_parts_away_leaves_no_grips_of_others() -> None:
    held = after(block(0.7), 1.0)
    moment = held.capture()
    assert carried(remove(held.scene, Selection(masses=frozenset((0,)))), moment).grips is None
    assert carried(pin(held.scene, (0,), True), moment).grips == moment.grips


# ------------------------------------------------------------------------- where it is kept
def on_slope(shape: str, seed: int) -> Scene:
    """A crumpled body parts of which get stuck to each other, and to a slope."""
    wall = replace(block(0.7).walls[0], point=(0.0, 10.0), hardness=50.0, tangential_hardness=40.0)
    return replace(crumpled(shape, seed, HELD), walls=(wall,))


def begun(method: Method, dt: float = 5e-4) -> Simulation:
    """Such a body, once some of it is stuck."""
    simulation = after(by(on_slope("cloth", 6), method, dt=dt), 0.03)
    grips = known(simulation.capture().grips)
    assert min(len(grips.springs), len(grips.walls)) > 3
    return simulation


def constants(table: Table, name: str = "") -> Iterator[tuple[str, NDArray[Any]]]:
    """The arrays of a table and of the tables in it, without the pairs that may touch and the addresses of
    kernels, which are entered as these are loaded."""
    fields = [field for field in table.fields if field != "calls"]
    if isinstance(table, Contacts):
        fields = fields[: fields.index("number")]
    for field in fields:
        value = getattr(table, field)
        if isinstance(value, Table):
            yield from constants(value, f"{name}.{field}")
        elif isinstance(value, np.ndarray):
            yield f"{name}.{field}", value


@pytest.mark.parametrize("plain", [False, True])
@pytest.mark.parametrize("method", ["velocity_verlet", "generalized_alpha"])
def test_no_step_writes_to_the_tables_of_the_body(
    method: Method, plain: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    if plain:
        monkeypatch.setattr("sim.motion.motion.is_ready", lambda names: False)
    simulation = Simulation(by(on_slope("cloth", 6), method, dt=5e-4), wait=not plain)
    body = system_of(simulation).body
    before = {name: array.copy() for name, array in constants(body)}
    assert len(before) > 30
    simulation.advance(0.03)
    assert simulation.plain == plain
    assert simulation.capture().grips is not None
    assert system_of(simulation).body is body
    for name, array in constants(body):
        assert np.array_equal(array, before[name]), name


def test_a_copy_of_the_state_stays_as_it_is() -> None:
    simulation = begun("velocity_verlet")
    system, state = simulation.tables
    copy = state.copied()
    x, v = copy.x + 1j * copy.y, copy.vx + 1j * copy.vy
    physics = Physics(system.body, copy)
    forces, energies = physics.forces(x, v), physics.energies(x)
    assert np.array_equal(Physics(system.body, state).forces(x, v), forces)
    simulation.advance(0.03)
    assert np.array_equal(physics.forces(x, v), forces)
    assert physics.energies(x) == energies


def test_an_estimate_of_the_stable_step_is_about_the_state_in_which_it_began() -> None:
    scene = block(0.7, dt=1e-3)
    one, other = (after(scene, 1.0) for _ in range(2))
    look = one.stability_in_parts()
    next(look)
    loose = Simulation(replace(scene, pose=replace(moment_pose(one), grips=None)))
    one.restore(loose.capture())
    found = finished(look)
    assert found == other.stability()
    assert abs(found.limit / loose.stability().limit - 1.0) > 0.1


@pytest.mark.parametrize("plain", [False, True])
def test_a_step_that_is_refused_leaves_no_trace(plain: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    if plain:
        monkeypatch.setattr("sim.motion.motion.is_ready", lambda names: False)
    simulation = Simulation(block(0.7, "symplectic_euler"), wait=not plain)
    simulation.advance(0.1)
    assert simulation.plain == plain
    before = simulation.capture().grips
    monkeypatch.setattr("sim.motion.motion.RUNAWAY_SPEED", 0.0)
    begin_anew(simulation)
    simulation.step()
    assert simulation.divergence is not None
    assert simulation.capture().grips == before


# ------------------------------------------------------------------------- beside the kernels
def stuck(method: Method = "generalized_alpha") -> Arrays:
    """A crumpled body some of whose parts stick to each other, and to a slope."""
    simulation = begun("rk4")
    return Arrays(by(replace(simulation.scene, pose=moment_pose(simulation)), method, dt=1e-3))


@pytest.mark.parametrize("method", ["rk4", "generalized_alpha"])
def test_the_kernels_do_what_the_physics_in_numpy_says(method: Method) -> None:
    arrays = stuck(method)
    physics = Physics(arrays.body, arrays.state)
    x, v = arrays.state.x + 1j * arrays.state.y, arrays.state.vx + 1j * arrays.state.vy
    for _ in range(3):
        expected = physics.accelerations(x, v)
        flat = np.concatenate((expected.real, expected.imag))[arrays.here]
        q, u = (np.concatenate((z.real, z.imag)) for z in (x, v))
        found = arrays.accelerations(q, u)
        assert np.abs(found - flat).max() <= 1e-11 * np.abs(flat).max()
        x = x + 1e-3 * v  # as far as a step goes


def test_numpy_moves_what_sticks_as_the_kernels_do(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("sim.motion.motion.is_ready", lambda names: False)
    scene = by(on_slope("girder", 3), "symplectic_euler", dt=2e-4)
    plain = Simulation(scene, wait=False)
    plain.step(50)
    assert plain.plain
    monkeypatch.undo()
    compiled = Simulation(scene)
    compiled.step(50)
    assert apart(plain, compiled) <= 1e-9
    one, other = known(plain.capture().grips), known(compiled.capture().grips)
    assert [row[:2] for row in one.springs + one.walls] == [row[:2] for row in other.springs + other.walls]
    stretches = [[row[2] for row in grips.springs + grips.walls] for grips in (one, other)]
    assert stretches[0] == pytest.approx(stretches[1], abs=1e-9)
    assert max(map(abs, stretches[0])) > 1e-3


def test_the_matrix_is_that_of_the_forces() -> None:
    arrays, g = stuck(), 150.0
    assert off(arrays.matrix_of(g * g, g), arrays.by_differences(g * g, g, places=1e-4)) <= 1e-6


@settings(max_examples=20, deadline=None)
@given(
    friction=st.floats(0.0, 3.0),
    hardness=st.floats(1.0, 1e6),
    speed=st.floats(-500.0, 500.0),
    dt=st.sampled_from((1e-4, 1e-3, 1.0 / 60.0)),
    method=st.sampled_from(("symplectic_euler", "velocity_verlet", "rk4")),
)
def test_no_stretch_is_more_than_friction_bears_and_no_step_makes_energy(
    friction: float, hardness: float, speed: float, dt: float, method: Method
) -> None:
    scene = block(friction, method, dt, speed)
    scene = replace(
        scene, gravity=(0.0, 0.0), linear_springs=(replace(scene.linear_springs[0], stiffness=0.0),)
    )
    scene = replace(
        scene, walls=(replace(scene.walls[0], tangential_hardness=hardness, restitution="constant"),)
    )
    simulation = Simulation(scene)
    start = 0.5 * speed**2 + 8000.0 * math.sqrt(G * math.cos(TURN) / 8000.0) ** 3 / 3.0
    for _ in range(100):
        simulation.step()
        assert 0.5 * float((simulation.velocities**2).sum(1).max()) <= 1.01 * start + 1e-9
    _, state = simulation.tables
    assert ((state.wall_place < NOWHERE) | (state.wall_stretch == 0.0)).all()


# ------------------------------------------------------------------------- what comes to rest
def test_a_mass_stays_on_a_tilted_rope_of_another_body() -> None:
    at = np.array((120.0, 60.0))
    rope = line((0.0, 0.0), (40.0, 20.0), 7, (0, 1, 2, 3, 4, 5, 6))
    normal = np.array((20.0, -40.0)) / math.hypot(20.0, 40.0)
    places = [at + 11.0 * normal + way * np.array((0.9, 0.45)) for way in (-30.0, 30.0)]
    body = built(
        [tuple(place.tolist()) for place in places], stiffness=2000.0, damping=20.0, rest_length=60.0
    )
    contact = Contact(
        distance=12.0, stiffness=500.0, friction=0.8, restitution="constant", tangential_stiffness=2000.0
    )
    scene = joined(rope, body, contact=contact, gravity=(0.0, G), air_friction=0.0)
    for friction, least, most in ((0.8, 0.0, 1e-4), (0.2, 30.0, 1e9)):
        moving = replace(scene, contact=replace(contact, friction=friction))
        simulation = after(by(moving, "velocity_verlet", dt=5e-4), 2.0 if friction > 0.5 else 0.3)
        before = simulation.positions
        simulation.advance(0.4)
        assert least <= np.abs(simulation.positions - before).max() <= most


def test_a_heap_of_rings_comes_to_rest() -> None:
    simulation = after(by(replace(heap(10), bodies=()), "velocity_verlet", dt=1.0 / 3840.0), 5.0)
    assert float(np.sqrt((simulation.velocities**2).sum(1).mean())) < 0.1


def test_files_of_before_are_as_they_were() -> None:
    scene = sim.load_scene("pile")
    contact = known(scene.contact)
    assert (contact.restitution, contact.tangential_stiffness) == ("viscous", 0.0)
    assert "grips" not in msgspec.json.encode(Simulation(scene).pose()).decode().replace('"grips":null', "")
