"""Which masses and springs are found to touch, and which never do."""

from __future__ import annotations

import numpy as np
import pytest

import sim
from sim import Mass, Scene
from sim.forces.contact import no_tunnelling
from sim.scene.surroundings import Contact
from tests.sim.arrays import Arrays, Floats
from tests.sim.surrounded import force_around
from tests.sim.touching import HARD, REPLACE, SOFT, crumpled, joined, line, listed, nearer


def test_a_body_does_not_touch_itself_as_it_is_built() -> None:
    for shape in ("girder", "cloth", "ring", "chain"):
        scene = crumpled(shape, contact=REPLACE(SOFT, distance=70.0))  # far more than a spring is long
        _, force = force_around(REPLACE(scene, pose=None))
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
