"""The three force laws: what each is, which of them have an energy, and what none of them may do."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from msgspec.structs import replace

from sim import Integrator, Scene, Simulation
from sim.scene.types import ForceLaw
from tests.sim.arrays import Arrays, off
from tests.sim.bodies import LAWS, SHAPES, body
from tests.sim.builders import built
from tests.sim.changes import with_joints
from tests.sim.inside import forces_of, general, put, spring_forces, system_of
from tests.sim.laws import JOINTS, Laws, complexes, points

DAMPINGS = [
    pytest.param({"damping": 0.0, "twist": 0.0}, id="undamped"),
    pytest.param({"damping": 0.0}, id="joint_damped"),
    pytest.param({"twist": 0.0}, id="damped"),
    pytest.param({}, id="both"),
    pytest.param({"joints": False}, id="without joints"),
    pytest.param({"gravity": (0.0, 0.0)}, id="without gravity"),
    pytest.param({"air": 0.0}, id="without air"),
]
"""What a body may lack, for which the kernels have leaner branches."""
Points = np.ndarray


def two_springs(
    v: float,
    law: ForceLaw,
    rest: float = 20.0,
    lengths: tuple[float, float] = (30.0, 70.0),
) -> Scene:
    """Two springs without linear forces, at an angle of v degrees."""
    turn, (a, b) = math.radians(v), lengths
    return built(
        [(-a, 0.0), (0.0, 0.0), (b * math.cos(turn), b * math.sin(turn))], rest_length=1.0,
        joint={"stiffness": 5.0, "rest_angle": rest}, force_law=law,
        # Whose forces are the law's to the last digit.
        integrator=Integrator(method="symplectic_euler"),
    )  # fmt: skip


# ------------------------------------------------------------------------- what each law is
def test_shapes_take_every_way_through_the_tables() -> None:
    """That of what follows nothing goes untested because of how bodies are tabulated."""
    bodies = {shape: system_of(Simulation(body(shape))).body for shape in SHAPES}
    assert bodies["girder"].hinged < bodies["girder"].springs
    for kind in ("held", "bends"):
        of_kind = {shape: getattr(of, kind) for shape, of in bodies.items()}
        assert of_kind["chain"].loose == of_kind["chain"].behind > 0, "all in a run"
        assert of_kind["girder"].first.size and of_kind["girder"].layers == 1, "some in a run, some gathered"
        assert of_kind["ring"].first.size and of_kind["ring"].rest.size, "some in a run, others one by one"
        assert of_kind["tangle"].layers == 2 and of_kind["tangle"].rest.size, "none in a run"


@pytest.mark.parametrize("damping", DAMPINGS)
@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("shape", SHAPES)
def test_accelerations_are_those_of_the_equations(shape: str, law: ForceLaw, damping: dict[str, Any]) -> None:
    for seed, held in ((1, ()), (2, (0, 3))):
        scene = body(shape, law, seed, held=held, **damping)
        arrays, laws = Arrays(scene), Laws(scene)
        positions, speeds = (complexes(arrays.pairs(flat)) for flat in (arrays.q, arrays.v))
        found = arrays.pairs_of(arrays.accelerations(arrays.q, arrays.v))
        assert off(found, points(laws.accelerations(positions, speeds))) <= 1e-13
        assert not found[list(held)].any()
        assert arrays.potential(arrays.q) == pytest.approx(
            Laws(replace(scene, force_law="conservative") if law == "tutorial" else scene).potential(
                positions
            ),
            rel=1e-12,
        )


@pytest.mark.parametrize("damping", DAMPINGS)
@pytest.mark.parametrize("path", [lambda s: s, general], ids=["own path", "general"])
@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("shape", ["chain", "cloth"])
def test_symplectic_euler_goes_by_the_same_laws(
    shape: str, law: ForceLaw, path: Callable[[Simulation], Simulation], damping: dict[str, Any]
) -> None:
    scene = body(shape, law, 5, held=(2,), **damping)
    simulation, laws, dt = path(Simulation(scene)), Laws(scene), scene.integrator.dt
    positions, speeds = complexes(simulation.positions), complexes(simulation.velocities)
    for _ in range(70):
        speeds += dt * laws.accelerations(positions, speeds)
        positions += dt * speeds
    simulation.step(70)
    assert np.abs(simulation.positions - points(positions)).max() <= 1e-9
    assert np.abs(simulation.velocities - points(speeds)).max() <= 1e-7


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("rest", [-135.0, 0.0, 20.0, 180.0])
@pytest.mark.parametrize("off", [-179.0, -90.0, -10.0, 0.0, 33.0, 179.0])
def test_couple_and_pull_of_a_joint(law: ForceLaw, rest: float, off: float) -> None:
    scene = two_springs(rest + off, law, rest)
    force, positions = forces_of(scene), np.array([mass.position for mass in scene.masses])
    size, angle = 5.0 * 30.0 * 70.0, math.radians(off)
    torque, energy = (size * each for each in JOINTS[law](angle))
    energy = 0.0 if law == "tutorial" else energy  # it has no forces along the springs
    for end, sign in ((0, 1.0), (2, -1.0)):
        arm = positions[end] - positions[1]
        turning = arm[0] * force[end][1] - arm[1] * force[end][0]
        assert turning == pytest.approx(sign * torque, rel=1e-11, abs=1e-9)
        # The energy is proportional to both lengths, so its derivative by each is the energy over it.
        assert arm @ force[end] == pytest.approx(-energy, rel=1e-11, abs=1e-9)


# ------------------------------------------------------------------------- energies
def work_on_a_loop(scene: Scene, loop: Callable[[float], Points], pieces: int) -> float:
    """The work that springs and joints do along a smooth closed path, from 0 to 2 pi.

    Equal weights: on a periodic path, they are exact to all orders.
    """
    simulation = Simulation(scene)
    work = 0.0
    for i in range(pieces):
        s = 2.0 * math.pi * i / pieces
        put(simulation, loop(s), np.zeros((len(scene.masses), 2)))
        slope = (loop(s + 1e-4) - loop(s - 1e-4)) / 2e-4
        work += float((spring_forces(simulation) * slope).sum()) * 2.0 * math.pi / pieces
    return work


@pytest.mark.parametrize("shape", SHAPES)
def test_only_the_tutorials_law_does_work_on_a_closed_path(shape: str) -> None:
    # Rest angles near the present ones, so that the path keeps off the angle law's jump.
    scene = body(shape, seed=6)
    angles = Simulation(scene).angles
    scene = with_joints(scene, rest_angle=[float((angle + 205.0) % 360.0 - 180.0) for angle in angles])
    rng = np.random.default_rng(2)
    positions = np.array([mass.position for mass in scene.masses])
    one, other = rng.uniform(-4.0, 4.0, (2, *positions.shape))

    def loop(s: float) -> Points:
        return positions + math.sin(s) * one + (1.0 - math.cos(s)) * other

    work = {law: work_on_a_loop(replace(scene, force_law=law), loop, 200) for law in LAWS}
    assert abs(work["tutorial"]) > 300.0
    assert abs(work["conservative"]) <= 1e-6 * abs(work["tutorial"])
    assert abs(work["angle"]) <= 1e-6 * abs(work["tutorial"])
