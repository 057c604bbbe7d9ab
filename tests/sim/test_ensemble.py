"""Ensembles: every lane does what a simulation of its body alone does, to rounding."""

from __future__ import annotations

import msgspec
import numpy as np
import pytest

import sim
from sim import InputError, Scene, Simulation
from sim.ensemble import LANES, Member, Track, fixed_step_methods, marks, run_ensemble
from sim.scene import ForceLaw
from tests.sim.bodies import body

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
        scene = REPLACE(scene, rope=None, masses=masses, rest_length_scale=float(rng.uniform(0.8, 1.2)))
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
        assert found[i].positions == pytest.approx(right.positions, abs=1e-8)
        assert found[i].velocities == pytest.approx(right.velocities, abs=1e-5)


@pytest.mark.parametrize("law", ["tutorial", "conservative", "angle"])
@pytest.mark.parametrize("method", fixed_step_methods())
def test_every_lane_is_a_simulation(method: str, law: ForceLaw) -> None:
    # Two lengths, each with a batch that is full and one that is not.
    assert_alike(ropes(2 * LANES + 6 if law != "angle" else 4, law), method)


@pytest.mark.parametrize("law", ["tutorial", "conservative"])
def test_stable_springs_are_weakened_in_every_lane_for_its_own_step(law: ForceLaw) -> None:
    stiff = sim.rope(masses=5, stiffness=1e7, damping=1e4, angular_stiffness=1e7, force_law=law)
    assert_alike([Member(stiff, dt, marks(0.1, dt, 3)) for dt in (5e-4, 1e-3, 3e-3)], "stable_spring")


@pytest.mark.parametrize("shape", ["hub", "ring"])
@pytest.mark.parametrize("method", fixed_step_methods())
def test_other_bodies_go_alone(method: str, shape: str) -> None:
    assert_alike([Member(body(shape, "conservative", i), 1e-3, (1, 20)) for i in range(3)], method)


@pytest.mark.parametrize("law", ["tutorial", "conservative"])
def test_chains_listed_in_any_order_damped_joints_and_circles(law: ForceLaw) -> None:
    (member, *_) = ropes(1, law)
    scene: Scene = member.scene
    turned = tuple(REPLACE(s, a=s.b, b=s.a) for s in scene.linear_springs[::-1])
    turned_joints = tuple(
        REPLACE(j, a=len(turned) - 1 - j.b, b=len(turned) - 1 - j.a) for j in scene.angular_springs
    )
    backwards = REPLACE(scene, linear_springs=turned, angular_springs=turned_joints)
    twisted = REPLACE(scene, angular_springs=tuple(REPLACE(j, damping=1.0) for j in scene.angular_springs))
    circle = sim.rope(masses=4, circle=sim.Circle(radius=20.0, frequency=2.0), force_law=law)
    members = [Member(s, member.dt, member.marks) for s in (backwards, twisted, circle)]
    assert_alike(members, "velocity_verlet")


def test_a_body_that_runs_away_harms_no_other() -> None:
    calm = ropes(LANES, "conservative")
    wild = [Member(m.scene, 0.2, tuple(range(5, 45, 10))) for m in calm[:4]]
    for method in ("symplectic_euler", "velocity_verlet", "rk4"):
        found = dict(run_ensemble([*calm[:6], *wild, *calm[6:]], method))
        for i, member in enumerate(calm):
            right = alone(member, method)
            assert found[i if i < 6 else i + 4].positions == pytest.approx(right.positions, abs=1e-8)
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
