"""Ensembles: every member goes as a simulation of its body alone."""

from __future__ import annotations

import msgspec
import numpy as np
import pytest

import sim
from sim import InputError, Simulation
from sim.analysis.ensemble import Member, Track, fixed_step_methods, marks, run_ensemble
from sim.scene.types import ForceLaw

REPLACE = msgspec.structs.replace


def ropes(count: int, law: ForceLaw, seed: int = 0) -> list[Member]:
    """Ropes that differ in everything that may differ: lengths, constants, masses, which are held, steps."""
    rng = np.random.default_rng(seed)
    found = []
    for i in range(count):
        scene = sim.rope(
            masses=(3, 7)[i % 2],
            length=rng.uniform(50.0, 300.0),
            direction=(1.0, rng.uniform(-1.0, 1.0)),
            stiffness=rng.uniform(1e3, 1e4),
            damping=rng.uniform(0.0, 50.0),
            angular_stiffness=rng.uniform(1e2, 3e3),
            rest_angle=rng.uniform(-120.0, 120.0),
            held=((0,), (), (2,), (0, 2))[i % 4],
            driven=None,
            gravity=(rng.uniform(-500.0, 500.0), 1000.0),
            air_friction=rng.uniform(0.0, 0.01),
            force_law=law,
        )
        weights = rng.uniform(0.5, 2.0, len(scene.masses))
        masses = tuple(REPLACE(m, mass=float(w)) for m, w in zip(scene.masses, weights, strict=True))
        dt = float(rng.uniform(2e-4, 2e-3))
        scene = REPLACE(scene, bodies=(), masses=masses, rest_length_scale=float(rng.uniform(0.8, 1.2)))
        found.append(Member(scene, dt, marks(0.2, dt, 4)))
    return found


def alone(member: Member, method: str) -> Track:
    """By `Simulation`."""
    simulation = Simulation(member.scene, dt=member.dt, integrator=method)
    states = []
    for mark in member.marks:
        simulation.step(mark - simulation.step_count)
        states.append((simulation.positions, simulation.velocities))
    return Track(np.array([p for p, _ in states]), np.array([v for _, v in states]))


def assert_alike(members: list[Member], method: str) -> None:
    found = dict(run_ensemble(members, method, threads=2))
    assert sorted(found) == list(range(len(members)))
    for i, member in enumerate(members):
        right = alone(member, method)
        assert found[i].positions == pytest.approx(right.positions, abs=1e-12)
        assert found[i].velocities == pytest.approx(right.velocities, abs=1e-9)


@pytest.mark.parametrize("law", ["tutorial", "conservative", "angle"])
@pytest.mark.parametrize("method", fixed_step_methods())
def test_every_member_is_a_simulation(method: str, law: ForceLaw) -> None:
    assert_alike(ropes(6, law), method)


def test_a_body_that_runs_away_harms_no_other() -> None:
    calm = ropes(8, "conservative")
    wild = [Member(m.scene, 0.2, tuple(range(5, 45, 10))) for m in calm[:4]]
    for method in ("symplectic_euler", "velocity_verlet", "rk4"):
        found = dict(run_ensemble([*calm[:6], *wild, *calm[6:]], method))
        for i, member in enumerate(calm):
            right = alone(member, method)
            assert found[i if i < 6 else i + 4].positions == pytest.approx(right.positions, abs=1e-12)
        for i in range(6, 10):
            gone = np.isnan(found[i].positions)
            assert gone[-1].all()
            # Not a bad number before the first look at which it is gone.
            first = int(gone.any((1, 2)).argmax())
            assert not gone[:first].any()
            assert gone[first:].all()


def test_results_are_the_same_with_any_number_of_threads() -> None:
    members = ropes(40, "tutorial")
    one, two = (dict(run_ensemble(members, "rk4", threads=n)) for n in (1, 2))
    for i in range(40):
        assert np.array_equal(one[i].positions, two[i].positions)


def test_methods_without_a_fixed_step_are_refused() -> None:
    with pytest.raises(InputError, match="method: 'auto' has no fixed step; symplectic_euler"):
        next(run_ensemble([], "auto"))


def test_marks_are_even_and_ascending() -> None:
    assert marks(1.0, 0.01, 4) == (25, 50, 75, 100)
    assert marks(1.0, 0.4, 4) == (1, 1, 2, 2)
    assert marks(0.1, 1.0, 3) == (1, 1, 1)
