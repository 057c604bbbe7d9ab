"""A force law is what its row and its terms say, in every kernel that reads them."""

from __future__ import annotations

from typing import get_args

import numba
import numpy as np
import pytest
from msgspec.structs import replace

import sim
from sim import Simulation
from sim.forces import joints as laws
from sim.forces.joints import (
    ANGLE,
    CONSERVATIVE,
    IN_NUMPY,
    LAWS,
    TUTORIAL,
    blocks_of_law,
    joint_blocks,
    joint_energy,
)
from sim.forces.reference import Physics
from sim.scene.types import ForceLaw
from sim.settings import CHOICES
from tests.sim.bodies import body
from tests.sim.inside import spring_forces, with_law

ANGLES = np.linspace(-3.0, 3.0, 13)


@numba.njit
def terms(law, deflection):
    """A way in from Python."""
    return laws.terms(law, deflection)


@numba.njit
def by_terms(law, size, rest, a, b, inv_a, inv_b):
    return blocks_of_law(law, size, rest, a, b, inv_a, inv_b, 1e-300)


@numba.njit
def by_products(law, size, cos, sin, a, b, inv_a, inv_b):
    zero = (0.0, 0.0)
    return joint_blocks(law, size, cos, sin, 0.0, 0.0, a, b, inv_a, inv_b, 1e-300, zero, zero, 0.0, False)


@numba.njit
def energy(law, ax, ay, bx, by, rest):
    return joint_energy(law, ax, ay, bx, by, rest, 1e-300)


def test_scenes_pages_and_kernels_know_the_same_laws() -> None:
    assert tuple(LAWS) == get_args(ForceLaw) == tuple(CHOICES["force_law"].options)
    assert {law.code for law in LAWS.values()} <= set(IN_NUMPY)
    assert len({law.code for law in LAWS.values()}) == len(LAWS)


@pytest.mark.parametrize("name", LAWS)
def test_the_torque_is_the_slope_of_the_energy_and_its_own_slope_the_stiffness(name: ForceLaw) -> None:
    code, h = LAWS[name].code, 1e-5
    for angle in ANGLES:
        torque, _, stiffness = terms(code, angle)
        before, after = terms(code, angle - h), terms(code, angle + h)
        assert torque == pytest.approx((after[1] - before[1]) / (2.0 * h), rel=1e-6, abs=1e-9)
        assert stiffness == pytest.approx((after[0] - before[0]) / (2.0 * h), rel=1e-6, abs=1e-9)


@pytest.mark.parametrize("name", LAWS)
def test_numpy_says_the_same(name: ForceLaw) -> None:
    code = LAWS[name].code
    torque, energies = IN_NUMPY[code](np.asarray(6.0 * np.exp(1j * ANGLES), complex))
    for i, angle in enumerate(ANGLES):
        assert (torque[i], energies[i]) == pytest.approx(
            tuple(6.0 * t for t in terms(code, angle)[:2]), abs=1e-12
        )


@pytest.mark.parametrize("seed", range(5))
def test_products_of_vectors_are_the_terms_of_the_sine(seed: int) -> None:
    random = np.random.default_rng(seed)
    a, b = (tuple(pair) for pair in random.normal(size=(2, 2)) * 10.0)
    rest, size = random.uniform(-3.0, 3.0), random.uniform(1.0, 5.0)
    inverse = [1.0 / np.hypot(*vector) for vector in (a, b)]
    found = by_products(CONSERVATIVE, size, size * np.cos(rest), size * np.sin(rest), a, b, *inverse)
    expected = by_terms(CONSERVATIVE, size, rest, a, b, *inverse)
    assert np.array(found) == pytest.approx(np.array(expected), rel=1e-9, abs=1e-9)
    deflection = np.angle(complex(*a).conjugate() * complex(*b) * np.exp(-1j * rest))
    for law in (TUTORIAL, CONSERVATIVE, ANGLE):
        weight = terms(law, deflection)[1] / (inverse[0] * inverse[1])
        found_energy: float = energy(law, a[0], a[1], b[0], b[1], rest)
        assert found_energy == pytest.approx(weight, rel=1e-9)


@pytest.mark.parametrize("shape", ["chain", "ring", "tree"])
def test_an_unknown_law_is_an_error_and_not_a_body_without_joints(shape: str) -> None:
    simulation = with_law(Simulation(body(shape, "conservative", 1)), 99)
    assert np.isnan(spring_forces(simulation)).any()
    system, state = simulation.tables
    with pytest.raises(KeyError):
        Physics(system.body, state)


# ------------------------------------------------------------------------- a law that is not there yet
@numba.njit
def deflection_at(law, torque, most):
    """A way in from Python."""
    return laws.deflection_at(law, torque, most)


@pytest.mark.parametrize("name", LAWS)
def test_yielding_finds_the_deflection_of_a_torque_from_the_terms(name: ForceLaw) -> None:
    code = LAWS[name].code
    for angle in (0.01, 0.3, 1.2):
        assert deflection_at(code, terms(code, angle)[0], 1.5) == pytest.approx(angle, abs=1e-12)


def made_up(s: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The torque 4 |A||B| tan((V - r) / 4), and its energy."""
    quarter = np.angle(s) / 4.0
    return 4.0 * abs(s) * np.tan(quarter), -16.0 * abs(s) * np.log(np.cos(quarter))


def test_what_is_measured_follows_from_a_law_that_is_new(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(LAWS, "made-up", laws.Law(99, "Made up"))
    monkeypatch.setitem(IN_NUMPY, 99, made_up)
    scene = replace(body("hub", "angle", 3), integrator=sim.Integrator(method="rodas5p", tolerance=1.0))
    simulation = with_law(Simulation(scene), 99)
    system, _ = simulation.tables
    angles = np.radians(simulation.angles - simulation.rest_angles)
    by_hand = np.tan((angles - 2.0 * np.pi * np.round(angles / (2.0 * np.pi))) / 4.0)
    for j, joint in enumerate(scene.angular_springs):
        found = sim.quantity(f"joint{j}.torque", scene).read(simulation)
        still = simulation.loads.torques[j]
        assert found == pytest.approx(still, rel=1e-3)
        quantity = system.body.torque_damping[1 + system.joint_order[j]]
        lengths = [sim.quantity(f"spring{s}.length", scene).read(simulation) for s in (joint.a, joint.b)]
        rate = np.radians(sim.quantity(f"joint{j}.rate", scene).read(simulation))
        wanted = lengths[0] * lengths[1] * (4.0 * joint.stiffness * by_hand[j] + quantity * rate)
        assert found == pytest.approx(wanted, rel=1e-3)
