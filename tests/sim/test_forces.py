"""All forces against NumPy, their energies and their derivatives: one table of bodies for all terms.

`test_laws.py` holds springs and joints against equations that are written down once more.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
import pytest
from msgspec.structs import replace

from sim import Scene, Simulation
from sim.forces.all import TERMS
from sim.forces.joints import JointsReference
from sim.forces.rails import RAILS
from sim.forces.reference import Physics
from sim.forces.term import Term
from sim.scene.types import ForceLaw, Method
from tests.sim.arrays import Arrays, Floats, off
from tests.sim.bodies import LAWS, SHAPES, body
from tests.sim.changes import by, with_joints, with_springs, with_walls
from tests.sim.inside import forces_of
from tests.sim.surrounded import AROUND, KINDS, ON_RAILS, TOUCHING, around, bare, force_around

Make = Callable[..., Scene]
"""Of a body: (seed, further arguments of `bodies.body`)."""
LACKS: dict[str, dict[str, Any]] = {
    "": {},
    " undamped": {"damping": 0.0, "twist": 0.0, "air": 0.0},
    " joint-damped": {"damping": 0.0, "air": 0.0},
    " damped": {"twist": 0.0},
    " without joints": {"joints": False},
}
"""What a body may lack, for which the kernels have leaner branches."""


def lacking(shape: str, law: ForceLaw, lack: str, seed: int, **changes: Any) -> Scene:
    return body(shape, law, seed, **{**LACKS[lack], **changes})


def yielding(shape: str, law: ForceLaw, seed: int, **changes: Any) -> Scene:
    """A body every other of whose springs and joints yields in its present state."""
    scene = body(shape, law, seed, **changes)
    arrays, at = Arrays(scene), np.array([mass.position for mass in scene.masses])
    x, still = arrays.state.x + 1j * arrays.state.y, np.zeros(arrays.slots, complex)
    torques = np.abs(JointsReference(arrays.body, arrays.state).torques(x, still))
    limits = [0.6 * torque if i % 2 else None for i, torque in enumerate(torques[arrays.system.joint_order])]

    def force(i: int, s: Any) -> float | None:
        stretch = float(np.hypot(*(at[s.b] - at[s.a]))) - s.rest_length
        return 0.6 * s.stiffness * abs(stretch) if i % 2 else None

    def hardening(i: int, s: Any) -> float:
        return 0.3 * s.stiffness * (i % 4) if i % 2 else 0.0

    return with_springs(with_joints(scene, yield_torque=limits), yield_force=force, hardening=hardening)


PLAIN: dict[str, Make] = {
    f"{shape} {law}{lack}": partial(lacking, shape, law, lack)
    for shape in SHAPES
    for law in LAWS
    for lack in LACKS
}
SURROUNDED: dict[str, Make] = {kind: partial(around, kind) for kind in AROUND}
YIELDING: dict[str, Make] = {
    f"{shape} {law} that yields": partial(yielding, shape, law)
    for shape in ("girder", "tree", "ring")
    for law in LAWS
}
GENERAL = {f"{name}, general path": make for name, make in PLAIN.items() if name.startswith("chain")}
BODIES = {**PLAIN, **GENERAL, **SURROUNDED, **YIELDING}
WHOLE = [name for name in BODIES if not any(lack and name.split(",")[0].endswith(lack) for lack in LACKS)]
"""Those that lack nothing."""


def arrays_of(name: str, seed: int, **changes: Any) -> Arrays:
    return Arrays(BODIES[name](seed, **changes), general=name in GENERAL)


def is_steep(name: str) -> bool:
    """What bounces with a constant restitution is damped ever more steeply, the less deep it is."""
    return name in TOUCHING and TOUCHING[name][1].restitution == "constant"


def test_every_term_is_in_a_body() -> None:
    """A new one needs a kind of surroundings, by which all tests of this file look at it."""

    def largest(name: str, term: Term) -> float:
        arrays = arrays_of(name, 0)
        x, v = (z[0] + 1j * z[1] for z in (arrays.q.reshape(2, -1), arrays.v.reshape(2, -1)))
        return float(np.abs(Physics(arrays.body, arrays.state).terms[term.name].forces(x, v)).max())

    for term in TERMS:
        if term is RAILS:  # it exerts only what others need
            assert any(arrays_of(name, 0).body.environment.rails.slot.size for name in SURROUNDED)
            continue
        assert any(largest(name, term) > 1.0 for name in SURROUNDED), term.name


# ------------------------------------------------------------------------- against NumPy
@pytest.mark.parametrize("method", ["rk4", "symplectic_euler"])
@pytest.mark.parametrize("name", [name for name in BODIES if name not in YIELDING])
def test_the_kernels_do_what_the_physics_in_numpy_says(name: str, method: Method) -> None:
    """So do the energies; under the tutorial's law, the joints' is that of the conservative one."""
    for seed in range(3):
        scene = by(BODIES[name](seed, held=(1,)), method, dt=1e-3)
        arrays = Arrays(scene, general=name in GENERAL)
        arrays.state.clock[0] = 0.37
        found = arrays.accelerations(arrays.q, arrays.v)
        assert off(found, arrays.by_numpy()) <= 1e-12
        if name in SURROUNDED:
            without = Arrays(bare(scene))
            assert np.abs(found - without.accelerations(arrays.q, arrays.v)).max() > 1.0
        balance = Simulation(scene).energy()
        energies = Physics(arrays.body, arrays.state).energies(arrays.state.x + 1j * arrays.state.y)
        for kind, energy in energies.items():
            assert getattr(balance, kind) == pytest.approx(energy, rel=1e-12), kind


# ------------------------------------------------------------------------- what no force may do
@pytest.mark.parametrize(
    "name",
    [f"{shape} {law}" for shape in SHAPES for law in LAWS]
    + ["gas", "fillings", "girder in contact", "cloth in contact", "ring in contact"],
)
def test_nothing_within_a_body_pushes_or_turns_it_as_a_whole(name: str) -> None:
    # Contact is rough and in motion: friction has no torque either.
    for seed in range(3):
        if name in SURROUNDED:
            still: dict[str, Any] = {"joints": False, "damping": 0.0, "air": 0.0, "gravity": (0.0, 0.0)}
            at, force = force_around(BODIES[name](seed, **still))
        else:
            scene = BODIES[name](seed)
            at, force = np.array([mass.position for mass in scene.masses]), forces_of(scene)
        size = float(np.abs(force).sum())
        assert size > 100.0
        assert np.abs(force.sum(0)).max() <= 1e-13 * size
        torque = float((at[:, 0] * force[:, 1] - at[:, 1] * force[:, 0]).sum())
        assert abs(torque) <= 1e-13 * size * float(np.abs(at).max())


@pytest.mark.parametrize(
    "name",
    [f"{shape} {law}" for shape in SHAPES for law in LAWS if law != "tutorial"]
    + ["walls", "gas", "fillings", "girder in contact", "cloth in contact", "ring in contact"],
)
@pytest.mark.parametrize("held", [(), (0, 4)])
def test_the_force_is_minus_the_gradient_of_the_energy(name: str, held: tuple[int, ...]) -> None:
    smooth: dict[str, float] = {"friction": 0.0, "bounciness": 1.0}
    for seed in range(2):
        scene = with_walls(BODIES[name](seed, damping=0.0, twist=0.0, air=0.0, held=held), **smooth)
        arrays = Arrays(replace(scene, contact=scene.contact and replace(scene.contact, **smooth)))
        free = np.isin(arrays.here, arrays.free)
        force = arrays.weight * arrays.accelerations(arrays.q, 0.0 * arrays.v)
        assert off(-arrays.gradient()[free], force[free]) <= 1e-7


# ------------------------------------------------------------------------- derivatives
def resisted(arrays: Arrays, change: Floats, start: Floats, z: Floats) -> float:
    """How far the product of z with the derivative by velocities is off, as a part of what it is."""
    found = arrays.resistance(z, 0.7, start) - start
    return float(np.abs(found - change).max() / (np.abs(change).max() + 1.0))


@pytest.mark.parametrize("name", BODIES)
def test_the_matrix_and_its_part_by_velocities_are_those_of_the_forces(name: str) -> None:
    resists = not name.split(",")[0].endswith(" undamped")
    for seed, held in ((1, ()), (2, (0, 3))):
        arrays = arrays_of(name, seed, held=held)
        # About as large as the derivatives, so that both count.
        g, speeds = 150.0, 0.01 if name in SURROUNDED else 0.1
        by_place, by_speed = arrays.derivative(False, 1e-3), arrays.derivative(True, speeds)
        expected = g * g * np.eye(arrays.here.size) - g * by_speed - by_place
        assert off(arrays.matrix_of(g * g, g), expected) <= (1e-6 if is_steep(name) else 1e-7)
        start, z = np.random.default_rng(seed).normal(size=(2, arrays.here.size)) * 100.0
        start = arrays.along @ start  # a motion has no part across rails
        assert np.abs(expected @ arrays.solve(z) - z).max() <= (1e-4 if is_steep(name) else 1e-5)
        if name not in YIELDING:  # of which the product knows nothing
            change = 0.7 * by_speed @ z
            assert resisted(arrays, change, start, z) <= (1e-5 if is_steep(name) else 1e-7)
            # There is something to be right about wherever anything resists.
            assert (np.abs(change).max() > 10.0) == resists


@pytest.mark.parametrize("name", YIELDING)
def test_what_yields_has_another_matrix(name: str) -> None:
    scene = BODIES[name](1, held=(0,))
    elastic = with_springs(with_joints(scene, yield_torque=None), yield_force=None, hardening=0.0)
    one, other = (Arrays(each).matrix_of(2e4, 150.0) for each in (scene, elastic))
    assert off(other, one) >= 1e-2


@pytest.mark.parametrize("name", [name for name in WHOLE if name not in YIELDING])
def test_the_definite_matrix_is_one(name: str) -> None:
    indefinite = 0
    for seed in range(3 if name in SURROUNDED else 6):
        arrays, g = arrays_of(name, seed, held=(0,) if seed % 2 else ()), 150.0
        free = np.isin(arrays.here, arrays.free)
        for definite in (True, False):
            whole = arrays.matrix_of(g * g, g, definite) - g * g * np.eye(arrays.here.size)
            # On rails, rows have no part across; what is solved for has none either.
            stiffness = (arrays.weight[:, None] * whole @ arrays.along)[free][:, free]
            size = np.abs(stiffness).max()
            lowest = np.linalg.eigvalsh(0.5 * (stiffness + stiffness.T))[0]
            if definite:
                assert np.abs(stiffness - stiffness.T).max() <= 1e-9 * size
                assert lowest >= -1e-9 * size
            else:
                indefinite += bool(lowest < -1e-3 * size)
    # The true one is not: these bodies are compressed and bent.
    assert indefinite >= 1 or name in KINDS or name in TOUCHING or name == ON_RAILS
