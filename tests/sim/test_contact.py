"""Contact: its forces, derivatives and energies, and motion by every method."""

from __future__ import annotations

import numpy as np
import pytest
from msgspec.structs import replace

import sim
from sim import Integrator, Mass, Scene, Simulation
from sim.forces.touch.batch import BATCH
from sim.forces.touch.contact import no_tunnelling
from sim.scene.surroundings import Contact, Wall
from sim.scene.types import Method
from sim.solve.registry import METHODS
from tests.sim.arrays import Arrays, Floats, off
from tests.sim.changes import apart, by
from tests.sim.inside import KRYLOV, solver_of
from tests.sim.surrounded import force_around, run
from tests.sim.touching import (
    CONSTANT,
    HARD,
    SMOOTH,
    SOFT,
    crumpled,
    joined,
    line,
    listed,
    nearer,
    ring,
)


# ------------------------------------------------------------------------- forces
@pytest.mark.parametrize("contact", [CONSTANT, replace(CONSTANT, tangential_stiffness=2000.0)])
@pytest.mark.parametrize("rings", [10, 47])
@pytest.mark.parametrize("method", ["rk4", "symplectic_euler"])
def test_many_pairs_are_pushed_like_a_few(method: Method, rings: int, contact: Contact) -> None:
    rng = np.random.default_rng(rings)
    bodies = []
    for i in range(rings):
        velocity = tuple(rng.normal(0.0, 50.0, 2).tolist())
        bodies.append(ring((21.0 * (i % 7), 19.0 * (i // 7)), 12.0, 12, velocity))
    scene = joined(*bodies, contact=contact, integrator=Integrator(method=method, dt=1e-3))
    arrays = Arrays(scene)
    pairs = sorted(nearer(arrays, arrays.q, contact.distance))
    assert (2 * BATCH if rings > 10 else BATCH // 4) < len(pairs)
    assert len(pairs) % 8 != 0  # the last batch is filled up
    if contact.tangential_stiffness:
        springs, masses = np.array(pairs[1::2]).T  # every other has a tangential spring
        state, count, way = arrays.state, springs.size, rng.uniform(0.0, 2.0 * np.pi, springs.size)
        state.contact_start[:] = np.searchsorted(springs, np.arange(arrays.body.springs + 1))
        state.contact_mass[:count] = masses
        place = rng.uniform(0.0, 1.0, count), np.cos(way), np.sin(way), *rng.uniform(3.0, 9.0, (2, count))
        state.contact_stretch[:count] = np.column_stack((rng.normal(0.0, 0.1, count), *place))
    found = arrays.accelerations(arrays.q, arrays.v)
    assert off(found, arrays.by_numpy()) <= 1e-12


def test_the_push_on_a_mass_beside_a_spring() -> None:
    # 2 px deep, a quarter of the way along the spring, which is still; the mass slides along it at 40 px/s.
    beside = Scene(name="one", masses=(Mass(position=(25.0, 10.0), velocity=(40.0, 0.0)),))
    scene = joined(
        line((0.0, 0.0), (100.0, 0.0), 2, ()), beside, integrator=Integrator(method="rk4"),
        contact=replace(SOFT, bounciness=1.0),
    )  # fmt: skip
    _, force = force_around(scene)
    push = 50.0 * 2.0**2
    friction = 0.7 * push * np.tanh(40.0 / 80.0)
    assert force[2] == pytest.approx((-friction, push))
    # A quarter, and the couple that balances the friction, which acts 10 px beside the spring.
    assert force[1] == pytest.approx((0.25 * friction, -0.25 * push - friction * 10.0 / 100.0))
    assert force[0] == pytest.approx(-force[1] - force[2])


def test_friction_is_still_where_everything_turns_as_a_whole() -> None:
    at = np.array([(0.0, 0.0), (100.0, 0.0), (25.0, 10.0), (104.0, -5.0)])
    masses = tuple(Mass(position=(x, y), velocity=(-3.0 * y, 3.0 * x)) for x, y in at.tolist())
    body = line((0.0, 0.0), (100.0, 0.0), 2, ())
    scene = replace(body, masses=masses, contact=replace(SOFT, friction=10.0, bounciness=0.0))
    scene = by(scene, "generalized_alpha")
    _, rough = force_around(scene)
    _, smooth = force_around(replace(scene, contact=SMOOTH))
    assert np.abs(smooth).max() > 100.0
    assert np.abs(rough - smooth).max() <= 1e-11 * np.abs(smooth).max()


# ------------------------------------------------------------------------- derivatives


def test_a_system_whose_iteration_does_not_converge_has_no_solution() -> None:
    arrays = Arrays(crumpled("cloth", 2))
    arrays.factorise(1e3, 10.0)
    assert np.isfinite(arrays.solve(np.ones(arrays.here.size))).all()
    matrix = arrays.matrix
    arrays.matrix = matrix.replaced(krylov=matrix.krylov[:4].copy(), hessenberg=np.zeros((5, 2)))
    assert np.isinf(arrays.solve(np.ones(arrays.here.size))).all()


def test_steps_go_on_where_iterations_do_not_converge(monkeypatch: pytest.MonkeyPatch) -> None:
    scene = crumpled("cloth", 2)
    expected = run(scene, 0.05, "rodas4", tolerance=1e-3)
    monkeypatch.setattr(KRYLOV, 1)
    short = run(scene, 0.05, "rodas4", tolerance=1e-3)
    assert solver_of(short).stats().rejected > solver_of(expected).stats().rejected
    assert apart(short, expected) <= 1e-2


# ------------------------------------------------------------------------- motion


@pytest.mark.parametrize("method", [name for name in METHODS if METHODS[name].adaptive])
def test_nothing_that_falls_passes_a_held_spring(method: Method) -> None:
    # In free fall nothing else limits the steps: they would be as long as a call.
    falling = tuple(
        Mass(position=(30.0 + 4.0 * i, -300.0 - 3.7 * i), mass=0.1, velocity=(0.0, 1500.0)) for i in range(10)
    )
    scene = joined(
        line((0.0, 0.0), (100.0, 0.0), 2, (0, 1)),
        Scene(name="masses", masses=falling),
        contact=replace(HARD, stiffness=5000.0, friction=0.0),
    )
    simulation = Simulation(by(scene, method, dt=1 / 60, tolerance=1.0))
    simulation.step(60)
    assert simulation.divergence is None
    assert (simulation.velocities[2:, 1] < 0.0).all()
    assert (simulation.positions[2:, 1] < 0.0).all()


def test_a_ring_stays_on_a_held_rope() -> None:
    rope = line((0.0, 0.0), (20.0, 0.0), 8, (0, 7))
    scene = joined(rope, ring((70.0, -100.0), 12.0, 8), contact=HARD, gravity=(0.0, 1000.0))
    simulation = run(scene, 3.0, dt=0.1, tolerance=0.5)
    at = simulation.positions
    x, y = at[8:].mean(0)
    assert 0.0 < np.interp(x, at[:8, 0], at[:8, 1]) - y < 20.0


def test_a_rope_that_falls_on_itself_lies_on_itself() -> None:
    rope = line((0.0, -15.0), (0.0, -10.0), 16, ())
    masses = tuple(
        replace(mass, position=(mass.position[0] + 0.5 * (i % 3), mass.position[1]))
        for i, mass in enumerate(rope.masses)
    )
    floor = Wall(point=(0.0, 0.0), normal=(0.0, -1.0), bounciness=0.0)
    scene = replace(rope, masses=masses, gravity=(0.0, 1000.0), walls=(floor,), contact=HARD)
    simulation = run(scene, 2.0, "auto", tolerance=0.1)
    assert simulation.divergence is None
    arrays = Arrays(replace(scene, pose=simulation.scene.pose))
    index = arrays.system.mass_index
    q = np.zeros_like(arrays.q)
    q[index], q[arrays.slots + index] = simulation.positions.T
    assert nearer(arrays, q, 6.0)
    assert not nearer(arrays, q, 2.0)
    assert np.abs(simulation.velocities).max() < 300.0


@pytest.mark.parametrize("method", ["auto", "rk4", "generalized_alpha"])
def test_a_ring_inside_another_bounces_off_and_stays_in(method: Method) -> None:
    inner, outer = ring((0.0, 0.0), 15.0, 10, (400.0, 130.0)), ring((0.0, 0.0), 60.0, 24)
    scene = joined(inner, outer, contact=replace(HARD, friction=0.1, bounciness=0.9))
    simulation = Simulation(by(scene, method, dt=2e-4, tolerance=0.01))
    simulation.energy()
    approaching = []
    for _ in range(100):
        simulation.advance(0.01)
        at, speed = simulation.positions, simulation.velocities
        assert np.hypot(*(at[:10].mean(0) - at[10:].mean(0))) < 60.0
        gap = at[:10].mean(0) - at[10:].mean(0)
        approaching.append(gap @ (speed[:10].mean(0) - speed[10:].mean(0)) > 0.0)
    assert np.diff(np.array(approaching, int)).tolist().count(-1) >= 2  # it leaves where it has been pushed
    balance = simulation.energy()
    assert abs(balance.residual) <= 0.01 * (abs(balance.friction) + balance.kinetic)


@pytest.mark.parametrize("method", ["auto", "symplectic_euler", "velocity_verlet", "rodas5p"])
def test_very_rough_bodies_stay_finite(method: Method) -> None:
    rope = line((-60.0, 30.0), (15.0, 0.0), 9, (0, 8))
    scene = joined(
        ring((0.0, 0.0), 15.0, 10, (300.0, 200.0)), rope, gravity=(0.0, 1000.0),
        contact=replace(HARD, friction=10.0, slip_speed=1.0),
    )  # fmt: skip
    simulation = run(scene, 1.0, method, dt=1e-4, tolerance=0.1)
    assert simulation.divergence is None
    assert simulation.time == pytest.approx(1.0)
    assert np.abs(simulation.velocities).max() < 2000.0


# ------------------------------------------------------------------------- which pairs are found
def test_a_body_does_not_touch_itself_as_it_is_built() -> None:
    for shape in ("girder", "cloth", "ring", "chain"):
        scene = crumpled(shape, contact=replace(SOFT, distance=70.0))  # far more than a spring is long
        _, force = force_around(replace(scene, pose=None))
        assert np.abs(force).max() <= 1e-8
    ropes = [line((0.0, y), (10.0, 0.0), 5, ()) for y in (0.0, 3.0)]
    _, force = force_around(joined(*ropes, contact=SOFT))
    assert (force[:5, 1] < 0.0).all() and (force[5:, 1] > 0.0).all()  # but other bodies


def scattered(seed: int) -> Arrays:
    """Long and short springs here and there, some far out, one of no length, and masses without any."""
    rng = np.random.default_rng(seed)
    at = rng.normal(0.0, 60.0, (70, 2)) + np.where(rng.random((70, 1)) < 0.1, 1e5, -40.0)
    at[:20] *= 4.0
    lines = tuple(sim.LinearSpring(a=2 * i, b=2 * i + 1, stiffness=1.0, rest_length=1.0) for i in range(30))
    scene = Scene(
        name="scattered",
        masses=tuple(Mass(position=(x, y)) for x, y in rng.uniform(-1e4, 1e4, (70, 2)).tolist()),
        linear_springs=lines,
        contact=Contact(distance=float(rng.uniform(2.0, 40.0)), stiffness=1.0),
        pose=sim.Pose(positions=tuple(map(tuple, at.tolist())), velocities=((0.0, 0.0),) * 70),
    )
    arrays = Arrays(scene)
    one, other = (int(arrays.system.mass_index[mass]) for mass in (30, 31))
    for half in (0, arrays.slots):
        arrays.q[half + other] = arrays.q[half + one]
    return arrays


@pytest.mark.parametrize("seed", range(6))
def test_the_list_has_all_pairs_that_are_near(seed: int) -> None:
    arrays = scattered(seed)
    contact = arrays.body.environment.contact
    arrays.accelerations(arrays.q, arrays.v)
    expected = nearer(arrays, arrays.q, contact.distance + contact.margin)
    assert listed(arrays) == expected
    assert len(expected) > 20
    rng = np.random.default_rng(seed)
    q = arrays.q.copy()
    for _ in range(8):  # now and then, the list is made anew
        q[arrays.here] += rng.uniform(-0.1, 0.1, arrays.here.size) * contact.margin
        arrays.accelerations(q, arrays.v)
        assert nearer(arrays, q, contact.distance) <= listed(arrays)


def test_forces_do_not_depend_on_the_list_by_a_single_bit() -> None:
    arrays = Arrays(crumpled("cloth", 2))
    contact = arrays.body.environment.contact
    crowded = arrays.body.environment.replaced(
        contact=contact.replaced(
            member=contact.member[: arrays.body.masses + 7].copy(), crowded=contact.crowded.copy(),
            number=contact.number.copy(), at=contact.at.copy(), start=contact.start.copy(),
        )
    )  # fmt: skip
    q = arrays.q.copy()
    arrays.accelerations(q, arrays.v)
    before, number = contact.at.copy(), contact.start[-1]
    q[arrays.here] += np.random.default_rng(1).uniform(-0.3, 0.3, arrays.here.size) * contact.margin
    kept = arrays.accelerations(q, arrays.v)
    assert np.array_equal(contact.at, before)
    contact.number[0] = -1.0
    anew = arrays.accelerations(q, arrays.v)
    assert contact.start[-1] != number
    body = arrays.body
    arrays.body = body.replaced(environment=crowded)
    without_room = arrays.accelerations(q, arrays.v)
    assert crowded.contact.crowded[0] == 1
    assert np.array_equal(kept, anew)
    assert np.array_equal(kept, without_room)


def test_a_state_that_has_run_away_has_no_pairs() -> None:
    arrays = Arrays(crumpled("girder"))
    for bad in (np.nan, np.inf, 1e200):
        q = arrays.q.copy()
        q[3] = bad
        arrays.accelerations(q, arrays.v)
        assert listed(arrays) == set()
    arrays.accelerations(arrays.q, arrays.v)
    assert listed(arrays)


def test_a_step_through_a_spring_is_seen() -> None:
    over = Scene(name="one", masses=(Mass(position=(40.0, -50.0)),))
    arrays = Arrays(joined(line((0.0, 0.0), (100.0, 0.0), 2, ()), over, contact=HARD))
    ball = arrays.slots + int(arrays.system.mass_index[2])

    def apart(way: float, of: Floats) -> bool:
        to_q = arrays.q + way * of
        return bool(no_tunnelling(arrays.body, arrays.q, to_q))

    falling = np.zeros_like(arrays.q)
    falling[ball] = 1.0
    assert apart(40.0, falling)  # not there yet
    assert not apart(60.0, falling)
    assert not apart(5000.0, falling)
    everything = np.zeros_like(arrays.q)
    everything[arrays.here[3:]] = 1.0
    assert apart(5000.0, everything)
