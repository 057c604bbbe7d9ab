"""A gas or a liquid gets out of a loop whose springs break."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from msgspec.structs import replace

import sim
from sim import Integrator, Pose, Scene, Simulation
from sim.forces.plasticity import leaking
from sim.forces.reference import Physics
from sim.model.state import start_of
from sim.model.system import build_system
from sim.scene.types import Damage, Method
from sim.solve.registry import METHODS
from tests.sim.builders import hoop
from tests.sim.changes import after, apart


def burst(method: Method = "auto", filling: Any = None, weak: int = 5, joined: bool = True) -> Scene:
    """A blown-up ring of 12 masses, of which one spring is weaker than the others."""
    rim = tuple(range(12))
    scene = hoop(
        12, 50.0, mass=0.5, stiffness=2000.0, damping=1.0,
        fillings=(filling or sim.Gas(masses=rim, pressure=400.0, outside=100.0),),
        integrator=Integrator(method=method, dt=1e-4, tolerance=1e-3),
    )  # fmt: skip
    springs = [replace(s, strength=8000.0 if i == weak else 1e9) for i, s in enumerate(scene.linear_springs)]
    return replace(scene, linear_springs=tuple(springs if joined else springs[:-1]))


FILLINGS = {
    "gas": None,
    "liquid": sim.Liquid(masses=tuple(range(12)), bulk_modulus=2000.0, area=12000.0),
}


@pytest.mark.parametrize("kind", FILLINGS)
@pytest.mark.parametrize("method", METHODS)
def test_a_filling_gets_out_of_a_burst_skin(method: Method, kind: str) -> None:
    scene = burst(method, FILLINGS[kind])
    simulation = Simulation(scene)
    start = simulation.energy().total
    whole = simulation.capture()
    before = simulation.energy()
    while simulation.damage is None:
        before = simulation.energy()
        assert simulation.step() == 1 and simulation.time < 1.0
    balance = simulation.energy()
    assert simulation.damage.broken == (5,)
    # Its energy is gone with it, and the balance says where.
    assert before.fillings != 0.0 and balance.fillings == 0.0
    assert balance.broken == pytest.approx(-before.fillings - 8000.0**2 / (2.0 * 2000.0), rel=0.1)
    assert abs(balance.residual) <= (1e-2 if METHODS[method].order == 1 else 1e-3) * max(
        abs(start), balance.kinetic
    )
    # From then on it moves as a body without it.
    empty = replace(scene, fillings=(), pose=simulation.pose())
    other, again = Simulation(empty), Simulation(replace(scene, pose=simulation.pose()))
    for each in (simulation, other, again):
        each.advance(0.05)
    for each in (simulation, again):
        assert apart(each, other) <= 2e-2
    # Going back makes the skin tight again, and so does a reset.
    simulation.restore(whole)
    assert simulation.energy().fillings == pytest.approx(start - simulation.energy().linear, rel=1e-9)
    first = Simulation(scene)
    simulation.advance(0.01)
    simulation.reset()
    for each in (simulation, first):
        each.advance(0.02)
    assert apart(simulation, first) <= 1e-6


def test_numpy_moves_a_burst_balloon_without_its_filling() -> None:
    scene = burst("velocity_verlet")
    pose = Pose(
        positions=tuple(m.position for m in scene.masses),
        velocities=((0.0, 0.0),) * 12,
        damage=Damage(broken=(5,)),
    )
    system, state = start_of(replace(scene, pose=pose), build_system(replace(scene, pose=pose)))
    x, v = state.x + 1j * state.y, state.vx + 1j * state.vy
    empty = replace(scene, pose=pose, fillings=())
    without, other = start_of(empty, build_system(empty))
    forces = Physics(system.body, state).forces(x, v)[system.mass_index]
    assert forces == pytest.approx(Physics(without.body, other).forces(x, v)[without.mass_index])
    assert sim.equilibrium(replace(scene, pose=pose)).damage == Damage(broken=(5,))


def test_a_loop_leaks_where_a_spring_of_it_is_broken_and_only_there() -> None:
    loop = [np.array([0, 1, 2])]
    ends = np.array([(0, 1), (2, 1), (2, 0), (3, 0)])
    assert leaking(loop, ends, np.array([], int)) == []
    assert leaking(loop, ends, np.array([0])) == [0]
    assert leaking(loop, ends, np.array([1])) == [0]
    assert leaking(loop, ends, np.array([2])) == [0]
    assert leaking(loop, ends, np.array([3])) == []  # not a part of it
    # Where there never was a spring, the scene says that it is tight.
    assert leaking(loop, ends[:2], np.array([], int)) == []


def test_a_loop_with_a_gap_from_the_start_is_tight() -> None:
    simulation = after(burst(joined=False), 0.02)
    assert simulation.damage is None and simulation.energy().fillings != 0.0
