"""In which direction a spring is written never matters: not to forces, limits, tuning or edits."""

from __future__ import annotations

import math
from typing import Any

import msgspec
import numpy as np
import pytest
from msgspec.structs import replace

import sim
from sim import Simulation
from sim.analysis.tuning import inverse_reduced_masses
from sim.design.tune import damp_springs
from sim.edit.build import extend, positions_of, remove
from sim.edit.copying import copy, paste
from sim.edit.edit import Edit, Selection, of_parts
from sim.edit.shape import add_corners, cut, mirror, triangulate
from sim.edit.values import take_as_rest
from sim.model.system import build_system
from sim.motion.stability import damped_limit, largest_step, quick_limit
from sim.scene.types import ForceLaw, Method
from sim.solve.registry import METHODS
from tests.sim.bodies import LAWS, SHAPES, body, flipped, some_flipped
from tests.sim.builders import chain, row
from tests.sim.changes import after, by, with_joints, with_springs
from tests.sim.checks import known


def close(one: Any, other: Any, rel: float = 1e-9) -> None:
    one, other = np.asarray(one, float), np.asarray(other, float)
    assert other == pytest.approx(one, rel=rel, abs=rel * max(1.0, float(np.abs(one).max(initial=0.0))))


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("shape", SHAPES)
def test_loads_and_energies_do_not_depend_on_directions(shape: str, law: ForceLaw) -> None:
    scene = body(shape, law, 4)
    one, other = Simulation(scene), Simulation(some_flipped(scene, 1))
    close(one.loads.forces, other.loads.forces)
    close(one.loads.torques, other.loads.torques)
    close(msgspec.structs.astuple(one.pose())[0], msgspec.structs.astuple(other.pose())[0])
    close(one.energy().total, other.energy().total)
    close(one.energy().angular, other.energy().angular)
    for name in ("spring0.force", "spring0.elongation", "joint0.torque", "joint0.rate"):
        close(sim.quantity(name, scene).read(one), sim.quantity(name, scene).read(other))
    off = [[s.angles - s.rest_angles] for s in (one, other)]
    close(np.cos(np.radians(off[0])), np.cos(np.radians(off[1])))
    close(np.sin(np.radians(off[0])), np.sin(np.radians(off[1])))


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("shape", ["chain", "ring", "hub"])
@pytest.mark.parametrize("method", METHODS)
def test_motion_does_not_depend_on_directions(method: Method, shape: str, law: ForceLaw) -> None:
    scene = by(body(shape, law, 2, held=(0,)), method, dt=1e-4, tolerance=1e-3)
    one, other = (after(each, 0.02) for each in (scene, some_flipped(scene, 2)))
    # Where roundings decide on the next step, they differ by the tolerance.
    close(one.positions, other.positions, 1e-5 if METHODS[method].adaptive else 1e-8)


@pytest.mark.parametrize("shape", SHAPES)
def test_limits_and_softnesses_do_not_depend_on_directions(shape: str) -> None:
    scene = body(shape, "conservative", 4, held=(1,))
    other = some_flipped(scene, 3)
    for method in ("symplectic_euler", "velocity_verlet", "rk4"):
        close(largest_step(scene, method), largest_step(other, method), 1e-3)
    for limit in (quick_limit, damped_limit):
        close(limit(build_system(scene)), limit(build_system(other)))
    for one, two in zip(inverse_reduced_masses(scene), inverse_reduced_masses(other), strict=True):
        close(one, two)
    soft, same = (after(by(each, "stable_spring", dt=0.05), 0.15) for each in (scene, other))
    close(soft.positions, same.positions, 1e-6)


def test_tuning_equilibrium_and_vibrations_do_not_depend_on_directions() -> None:
    scene = of_parts(sim.rod(masses=8, damping=5.0))
    other = some_flipped(scene, 5)
    close(sim.equilibrium(scene).positions, sim.equilibrium(other).positions, 1e-8)
    resting = [replace(each, pose=sim.equilibrium(each)) for each in (scene, other)]
    one, two = (sim.vibrations(each, 5).omega for each in resting)
    close(one, two, 1e-6)
    told, same = sim.tuning(scene), sim.tuning(other)
    for part in ("slowest", "elastic", "fastest"):
        first, second = getattr(told, part), getattr(same, part)
        close(first.frequency, second.frequency, 1e-3)
        close(first.damping_ratio, second.damping_ratio, 1e-2)
    for part in ("springs", "joints"):
        for first, second in zip(getattr(told, part), getattr(same, part), strict=True):
            close(first, second)
    # Of one joint, by hand: three masses in line, one of its springs written against the other.
    three = chain(row(3), angular_stiffness=1000.0)
    for some in ((), (0,), (1,), (0, 1)):
        frequency = sim.tuning(flipped(three, some)).joints.frequency[0]
        assert frequency == pytest.approx(math.sqrt(6.0 * 1000.0) / math.tau, rel=1e-9)


def test_numbers_that_are_made_stable_or_damped_do_not_depend_on_directions() -> None:
    scene = of_parts(sim.rod(masses=8, damping=5.0))
    other = some_flipped(scene, 6)
    for change in (
        lambda each: sim.make_stable(each, 1 / 60, "symplectic_euler"),
        lambda each: sim.damp_vibration(each),
        lambda each: sim.damp_vibration(each, spring=3),
    ):
        one, two = change(scene), change(other)
        for kind in ("linear_springs", "angular_springs"):
            for field in ("stiffness", "damping"):
                first, second = ([getattr(p, field) for p in getattr(s, kind)] for s in (one, two))
                close(first, second, 1e-2)


EDITS: dict[str, Any] = {
    "mirror": lambda scene, at, moment: mirror(scene, range(4), at),
    "paste": lambda scene, at, moment: paste(scene, copy(scene, range(5), at), (300.0, 50.0)),
    "cut": lambda scene, at, moment: cut(scene, ((60.0, -300.0), (60.0, 300.0)), at),
    "corners": lambda scene, at, moment: add_corners(scene, range(len(scene.masses)), at),
    "extend": lambda scene, at, moment: extend(scene, 0, (500.0, 500.0), at),
    "triangulate": lambda scene, at, moment: triangulate(scene, range(len(scene.masses)), at),
    "rest": lambda scene, at, moment: take_as_rest(moment, Selection(masses=frozenset(range(6)))),
    "remove": lambda scene, at, moment: remove(scene, Selection(masses=frozenset({2}))),
    "damp": lambda scene, at, moment: damp_springs(scene, (0, 1, 2)),
}


@pytest.mark.parametrize("shape", ["chain", "hub", "girder"])
@pytest.mark.parametrize("name", EDITS)
def test_edits_do_not_depend_on_directions(name: str, shape: str) -> None:
    scene = body(shape, "conservative", 4)
    if name in ("corners", "triangulate", "extend"):
        scene = replace(scene, angular_springs=scene.angular_springs[:2])
    edited = []
    for each in (scene, some_flipped(scene, 7)):
        moment = Simulation(each).capture()
        try:
            edit = EDITS[name](each, positions_of(moment), moment)
        except sim.SettingError as error:
            edited.append(str(error))
            continue
        assert isinstance(edit, Edit)
        edited.append(edit.scene)
    one, two = edited
    if isinstance(one, str) or isinstance(two, str):
        assert one == two
        return
    first, second = Simulation(one), Simulation(two)
    close(first.positions, second.positions)
    close(first.loads.forces, second.loads.forces)
    assert len(one.angular_springs) == len(two.angular_springs)


@pytest.mark.parametrize("law", LAWS)
def test_yielding_and_breaking_do_not_depend_on_directions(law: ForceLaw) -> None:
    scene = by(body("girder", law, 2, air=0.0), "rk4", dt=1e-4)
    scene = with_springs(with_joints(scene, yield_torque=3e5), strength=5e4, yield_force=2e4, hardening=5.0)
    one, other = (after(each, 0.05) for each in (scene, some_flipped(scene, 8)))
    worn, same = known(one.damage), known(other.damage)
    assert any(worn.set_angles) and any(same.set_angles)
    assert worn.broken == same.broken
    close(worn.set_lengths, same.set_lengths, 1e-7)
    close(worn.set_angles, same.set_angles, 1e-7)
    close(one.positions, other.positions, 1e-7)
