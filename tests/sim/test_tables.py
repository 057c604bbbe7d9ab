"""The tables of a body: each says of every part what the scene says, whatever the order of the kernels."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import sim
from sim.engine.tables import Indices, Links
from sim.errors import SceneError, SettingError
from sim.forces.runs import slot_tables
from sim.model.system import System, build_system, joint_stiffness
from sim.scene.validate import validate
from tests.sim.fuzzing import wild_scene, wild_world
from tests.sim.inside import nothing_kept
from tests.sim.test_edit import some_edit

Table = list[tuple[int, ...]]


def one_by_one(plus: Indices, minus: Indices, owners: int, first: int, nothing: int, layers: int) -> Table:
    """What `slot_tables` makes, a thing at a time: an owner's first take its slots, the others are listed."""
    tables: Table = []
    lists: list[list[int]] = [[], [], []]
    for owner_of, sign in ((plus, 1), (minus, -1)):
        slots = [[nothing] * owners for _ in range(layers)]
        for thing, owner in enumerate(owner_of.tolist(), start=first):
            free = next((slot for slot in slots if slot[owner] == nothing), None)
            if free is not None:
                free[owner] = thing
            else:
                for column, value in zip(lists, (thing, owner, sign), strict=True):
                    column.append(value)
        tables.append(tuple(thing for slot in slots for thing in slot))
    return [*tables, *map(tuple, lists)]


@given(st.data(), st.integers(1, 9), st.integers(0, 1))
def test_things_take_the_slot_tables_their_owners_in_order(
    data: st.DataObject, owners: int, first: int
) -> None:
    count = data.draw(st.integers(0, 40))
    ends = st.lists(st.integers(0, owners - 1), min_size=count, max_size=count)
    plus, minus = (np.array(data.draw(ends), np.int64) for _ in range(2))
    layers, *made = slot_tables(plus, minus, owners, first, -1)
    assert [tuple(table.tolist()) for table in made] == one_by_one(plus, minus, owners, first, -1, layers)
    assert [table.dtype.kind for table in made] == ["i", "i", "i", "i", "f"]
    # Each layer but the first that there is not has something for half of the ends' slots.
    left = [np.bincount(owner_of, minlength=owners) for owner_of in (plus, minus)]
    filled = [sum(int((counts > layer).sum()) for counts in left) for layer in range(layers + 1)]
    assert all(2 * number >= owners for number in filled[:-1]) and 2 * filled[-1] < owners


def check_links(links: Links, a: Indices, b: Indices, pairs: range) -> None:
    """Each pair is in one run, or in one slot or list for each of its ends; rows and runs do not overlap."""
    found, in_rows = [], set()
    of_runs = links.first, links.a, links.b, links.count, links.row
    for first, start_a, start_b, count, row in np.transpose(of_runs).tolist():
        which = range(first, first + count)
        found += which
        assert [(a[s], b[s]) for s in which] == [(start_a + i, start_b + i) for i in range(count)]
        # An end looks where the run is, and the rows have places for all.
        line = next(k for k, at in enumerate(links.at_a.tolist()) if at + start_a == row)
        assert links.at_b[line] + start_b == row
        places = set(range(row, row + count))
        assert not places & in_rows and max(places) + 8 <= links.room
        in_rows |= places
    assert found == list(pairs[: links.loose - pairs.start]) and links.behind == pairs.stop
    loose = slice(links.loose, links.behind)
    nothing = int(max(links.into.max(initial=-1), links.out_of.max(initial=-1)))
    expected = one_by_one(b[loose], a[loose], links.ends, links.loose, nothing, links.layers)
    slots = links.into, links.out_of, links.rest, links.rest_end, links.rest_sign
    assert expected == [tuple(table.tolist()) for table in slots]


def check_tables(scene: sim.Scene, system: System) -> None:
    body = system.body
    at = system.mass_order.tolist()
    assert sorted(at) == list(range(len(scene.masses)))
    assert [at[slot - 1] for slot in system.mass_index.tolist()] == list(range(len(scene.masses)))
    assert system.inverse_mass.tolist() == [1.0 / scene.masses[i].mass for i in at]
    held = {anchor.mass for anchor in scene.anchors}
    assert system.held.tolist() == [i in held for i in at]
    order = system.spring_order.tolist()
    assert sorted(order) == list(range(len(scene.linear_springs)))
    for s, spring in enumerate(scene.linear_springs[i] for i in order):
        ends = at[body.spring_a[s] - 1], at[body.spring_b[s] - 1]
        numbers = body.stiffness[s], body.damping[s], body.rest_length[s]
        assert (*ends, *numbers) == (spring.a, spring.b, spring.stiffness, spring.damping, spring.rest_length)
    for array in (body.stiffness, body.damping, body.rest_length):
        assert not array[len(order) :].any()
    joints = system.joint_order.tolist()
    stiffnesses = joint_stiffness(scene)
    for j, joint, stiffness in zip(joints, scene.angular_springs, stiffnesses, strict=True):
        assert (order[body.joint_a[j]], order[body.joint_b[j]]) == (joint.a, joint.b)
        assert (body.joint_stiffness[j], body.joint_rest[j]) == (stiffness, joint.rest_angle)
        assert (body.angular_stiffness[j + 1], body.torque_damping[j + 1]) == (stiffness, joint.damping)
    hinged_springs, springs, all_joints = range(body.hinged), range(len(order)), range(len(joints))
    check_links(body.held, body.spring_a, body.spring_b, hinged_springs)
    check_links(body.free, body.spring_a, body.spring_b, springs[body.hinged :])
    if body.joints == len(joints):  # in a chain there may be more
        check_links(body.bends, body.joint_a, body.joint_b, all_joints)
    hinged = {s for joint in (body.joint_a, body.joint_b) for s in joint.tolist()}
    assert hinged == set(range(body.hinged))
    assert all(not array.flags.writeable for _, array in body.arrays())


@given(st.integers(0, 2**32 - 1), st.booleans())
def test_tables_say_what_the_scene_says(seed: int, world: bool) -> None:
    rng = np.random.default_rng(seed)
    scene = wild_scene(rng)
    try:
        scene = validate(wild_world(scene, rng) if world else scene)
    except SceneError:
        return
    system = build_system(scene)
    check_tables(scene, system)
    # Of the angles, too, which are read by the ends of the joints.
    simulation = sim.Simulation(scene, wait=False)
    at = np.array([complex(*position) for position in simulation.positions.tolist()])
    way = [at[spring.b] - at[spring.a] for spring in scene.linear_springs]
    angles = [np.degrees(np.angle(way[j.b] * np.conj(way[j.a]))) for j in scene.angular_springs]
    off = np.remainder(np.array(angles) - simulation.angles + 180.0, 360.0) - 180.0
    assert np.abs(off).max(initial=0.0) < 1e-5


def bytes_of(table: Any) -> list[bytes]:
    """All that is in a table, and in the tables in it."""
    found: list[bytes] = []
    for name in table.fields:
        value = getattr(table, name)
        if isinstance(value, np.ndarray):
            found.append(value.tobytes())
        else:
            found += bytes_of(value) if hasattr(value, "fields") else [repr(value).encode()]
    return found


@given(st.data(), st.sampled_from(("tutorial-3.3", "ring", "box", "girder", "hair-tuft", "pile")))
def test_tables_after_edits_are_those_of_a_scene_that_is_new(data: st.DataObject, name: str) -> None:
    """Bit for bit: what is kept of the parts before an edit changes nothing."""
    scene = sim.load_scene(name)
    for _ in range(data.draw(st.integers(1, 4))):
        try:
            scene = some_edit(data.draw, scene, [mass.position for mass in scene.masses]).scene
        except (SceneError, SettingError):
            continue
        made = build_system(scene)
        with nothing_kept():
            anew = build_system(scene)
        check_tables(scene, made)
        assert bytes_of(made.body) == bytes_of(anew.body)
        for field in dataclasses.fields(System)[1:]:
            one, other = getattr(made, field.name), getattr(anew, field.name)
            assert (one is None) == (other is None)
            assert np.array_equal(one, other) if isinstance(one, np.ndarray) else one == other


@pytest.mark.parametrize("name", ["tutorial-3.3", "ring", "hair-tuft", "girder", "air-balloon", "pile"])
def test_tables_of_presets(name: str) -> None:
    scene = sim.load_scene(name)
    check_tables(scene, build_system(scene))
