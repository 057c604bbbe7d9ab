"""Constant forces on masses, against closed forms, and in everything that knows the forces on a body."""

from __future__ import annotations

import math
from typing import Any

import msgspec
import numpy as np
import pytest
from msgspec.structs import replace

import sim
from sim import Scene, Simulation
from sim.edit.copying import copy, decode, encode, paste
from sim.edit.shape import mirror
from sim.scene.surroundings import Wall
from sim.scene.types import Integrator
from sim.solve.registry import METHODS
from sim.store.files import decode_link, decode_scene, encode_scene
from sim.store.link import pack_scene
from tests.sim.builders import built
from tests.sim.changes import step_all


def hung(force: tuple[float, float] | None, **changes: Any) -> Scene:
    """A mass of 2 kg on a spring of 500 kg/s², 100 px long, below a held one, without gravity."""
    places = [(0.0, 0.0), (0.0, 100.0)]
    scene = built(places, mass=(1.0, 2.0), stiffness=500.0, held=(0,), name="hung", **changes)
    top, end = scene.masses
    return scene if force is None else replace(scene, masses=(top, replace(end, force=force)))


def method(name: Any, dt: float = 1e-3) -> Integrator:
    return Integrator(method=name, dt=dt, tolerance=1e-8)


@pytest.mark.parametrize("name", METHODS)
def test_a_mass_on_a_spring_swings_about_where_its_force_is_borne(name: str) -> None:
    """x = (F / k) (1 - cos(w t)); no step is smaller than a thousandth of the swing's period."""
    simulation = Simulation(hung((0.0, 1000.0), integrator=method(name, 1e-4)))
    omega, sag = math.sqrt(500.0 / 2.0), 2.0
    for _ in range(4):
        simulation.step(500)
        wanted = 100.0 + sag * (1.0 - math.cos(omega * simulation.time))
        assert simulation.positions[1, 1] == pytest.approx(wanted, abs=5e-3 * sag)
        assert abs(simulation.energy().residual) < 2e-3 * 1000.0 * sag


@pytest.mark.parametrize("name", METHODS)
def test_gravity_and_the_same_weight_as_forces_move_a_body_alike(name: str) -> None:
    heavy = sim.rope(masses=6, integrator=method(name, 2.5e-3), gravity=(300.0, 2000.0))
    light = replace(
        heavy,
        bodies=(),
        gravity=(0.0, 0.0),
        masses=tuple(replace(m, force=(300.0 * m.mass, 2000.0 * m.mass)) for m in heavy.masses),
    )
    one, other = Simulation(heavy), Simulation(light)
    step_all(200, one, other)
    np.testing.assert_allclose(other.positions, one.positions, atol=1e-6)
    assert other.energy().gravity == pytest.approx(one.energy().gravity, rel=1e-9)
    np.testing.assert_allclose(other.loads.forces, one.loads.forces, atol=1e-4)


def test_the_force_is_minus_the_gradient_of_the_energy() -> None:
    scene = hung((123.0, -456.0), gravity=(10.0, 20.0))
    step, gradient = 1e-3, []
    for by in ((step, 0.0), (0.0, step)):
        ends = []
        for sign in (1.0, -1.0):
            at = (by[0] * sign, 100.0 + by[1] * sign)
            masses = (scene.masses[0], replace(scene.masses[1], position=at))
            ends.append(Simulation(replace(scene, masses=masses)).energy().gravity)
        gradient.append((ends[0] - ends[1]) / (2.0 * step))
    np.testing.assert_allclose(gradient, [-(123.0 + 20.0), 456.0 - 40.0], rtol=1e-9)


def test_a_held_mass_does_not_move_and_its_support_bears_the_force() -> None:
    scene = hung(None)
    scene = replace(scene, masses=(replace(scene.masses[0], force=(50.0, -70.0)), scene.masses[1]))
    simulation = Simulation(scene)
    assert simulation.energy().gravity == 0.0
    simulation.step(100)
    np.testing.assert_allclose(simulation.positions, [(0.0, 0.0), (0.0, 100.0)], atol=1e-5)
    np.testing.assert_allclose(simulation.loads.forces, [(50.0, -70.0), (0.0, 0.0)], atol=1e-3)
    # A hand that takes a loaded mass bears it, too, and what it does to the energy is in the balance.
    loaded = Simulation(hung((0.0, 1000.0), integrator=method("auto")))
    assert loaded.energy().gravity == -1e5
    loaded.grab(1)
    assert loaded.energy().gravity == 0.0
    assert loaded.energy().anchors == 1e5
    loaded.step(50)
    assert loaded.positions[1, 1] == 100.0
    loaded.release(1)
    loaded.step(50)
    assert loaded.positions[1, 1] > 100.0
    assert abs(loaded.energy().residual) < 1e-2


# ------------------------------------------------------------------------- at rest
def test_a_wall_does_not_push_a_mass_that_is_held_in_it() -> None:
    wall = Wall(point=(0.0, 0.0), normal=(0.0, -1.0), hardness=2e4)
    scene = built([(0.0, 5.0), (0.0, -60.0)], held=(0,), rest_length=65.0, gravity=(0.0, 0.0), walls=(wall,))
    assert np.abs(Simulation(scene).loads.forces).max() < 1e-6


def test_at_rest_a_spring_is_longer_by_force_over_stiffness() -> None:
    assert sim.equilibrium(hung((0.0, 1000.0))).positions[1] == pytest.approx((0.0, 102.0), abs=1e-9)
    # It turns towards the force, too.
    x, y = sim.equilibrium(hung((300.0, 400.0))).positions[1]
    assert (x, y) == pytest.approx((0.6 * 101.0, 0.8 * 101.0), abs=1e-7)


def test_tuning_says_how_far_a_body_sinks_under_its_loads() -> None:
    told = sim.tuning(hung((0.0, 1000.0)))
    assert told.sag == pytest.approx(2.0)
    assert told.sag_mass == 1
    # A constant force changes no frequency along the spring.
    assert told.fastest is not None
    assert told.fastest.frequency == pytest.approx(math.sqrt(250.0) / math.tau)
    # What only a force moves away for ever has vibrations all the same.
    free = replace(hung((0.0, 1000.0)), anchors=())
    told = sim.tuning(free)
    assert told.sag is None
    assert "the vibrations are those of the body without its loads" in told.notes


# ------------------------------------------------------------------------- files, links, edits
def test_files_have_forces_only_where_there_are_any() -> None:
    scene = hung((3.0, -4.5))
    data = encode_scene(scene)
    assert data.count(b'"force"') == 1
    assert b'"force": [3.0, -4.5]' in data
    assert b'"force"' not in encode_scene(hung(None))
    assert decode_scene(data, "file") == scene
    assert decode_link(pack_scene(scene)) == scene


def test_copies_keep_forces_and_mirrors_turn_them() -> None:
    scene = hung((3.0, -4.5))
    places = [mass.position for mass in scene.masses]
    pasted = paste(scene, decode(encode(copy(scene, [0, 1], places))), (500.0, 500.0)).scene
    assert [mass.force for mass in pasted.masses] == [msgspec.UNSET, (3.0, -4.5)] * 2
    mirrored = mirror(scene, [0, 1], places).scene
    assert [mass.force for mass in mirrored.masses] == [msgspec.UNSET, (-3.0, -4.5)]
    down = mirror(hung((0.0, 5.0)), [0, 1], places).scene
    assert b"-0.0" not in encode_scene(down)
