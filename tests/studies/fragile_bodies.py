"""Random bodies that yield or break within the second that they are looked at."""

from __future__ import annotations

import math

import numpy as np
from msgspec.structs import replace

import sim
from sim import Anchor, LinearSpring, Mass, Scene
from studies.compare.random_bodies import random_body

KINDS = ("springs yield", "joints yield", "springs break", "springs break under a touch")

_SEED = 2026
"""Goes before the kind and the seed of each body."""

_LOOKS = 100
"""Times at which loads are looked at, in the second."""


def fragile_body(seed: int, kind: str) -> Scene | None:
    """A random body with limits below what its parts would bear otherwise; None where there is nothing to do.

    Args:
        seed: of the body; the same one every time.
        kind: one of `KINDS`. The last is a rope between two held masses, on which others fall.
    """
    rng = np.random.default_rng((_SEED, KINDS.index(kind), seed))
    scene = _rope_under_masses(rng) if kind == KINDS[3] else random_body(seed)
    largest = _largest_loads(scene)
    if largest is None:
        return None
    forces, torques = largest
    springs, joints = list(scene.linear_springs), list(scene.angular_springs)
    if kind == KINDS[0]:
        for s in np.flatnonzero(rng.random(len(springs)) < 0.5).tolist():
            hardening = springs[s].stiffness * float(rng.choice((0.0, 0.01, 0.1, 0.5)))
            limit = max(forces[s], 1.0) * float(rng.uniform(0.3, 0.95))
            springs[s] = replace(springs[s], yield_force=limit, hardening=hardening)
    elif kind == KINDS[1]:
        for j in np.flatnonzero(rng.random(len(joints)) < 0.6).tolist():
            joints[j] = replace(joints[j], yield_torque=max(torques[j], 1.0) * float(rng.uniform(0.3, 0.95)))
    else:
        some = min(len(springs), int(rng.integers(1, 4)))
        for s in rng.choice(len(springs), some, replace=False).tolist():
            springs[s] = replace(springs[s], strength=max(forces[s], 1.0) * float(rng.uniform(0.4, 0.95)))
    return sim.validate(replace(scene, linear_springs=tuple(springs), angular_springs=tuple(joints)))


def _largest_loads(scene: Scene) -> tuple[list[float], list[float]] | None:
    """The largest force of each spring and torque of each joint in a second; None where it gets stuck."""
    integrator = sim.Integrator(method="adams", dt=1.0 / _LOOKS, tolerance=1e-3)
    simulation = sim.Simulation(replace(scene, integrator=integrator))
    a, b = np.array([(s.a, s.b) for s in scene.linear_springs]).T
    stiffness = np.array([s.stiffness for s in scene.linear_springs])
    rest = np.array([s.rest_length for s in scene.linear_springs])
    forces, torques = np.zeros(len(a)), np.zeros(len(scene.angular_springs))
    for _ in range(_LOOKS):
        if simulation.step(1, 20_000) < 1 or simulation.divergence is not None:
            return None
        at = simulation.positions
        forces = np.maximum(forces, np.abs(stiffness * (np.hypot(*(at[b] - at[a]).T) - rest)))
        torques = np.maximum(torques, np.abs(simulation.loads.torques))
    return forces.tolist(), torques.tolist()


def _rope_under_masses(rng: np.random.Generator) -> Scene:
    count, spacing, distance = int(rng.integers(5, 15)), rng.uniform(20.0, 40.0), float(rng.uniform(4.0, 8.0))

    def log_uniform(low: float, high: float) -> float:
        return float(np.exp(rng.uniform(math.log(low), math.log(high))))

    stiffness = log_uniform(3e3, 3e5)
    masses = [
        Mass(position=(float(spacing * i), 0.0), mass=float(rng.uniform(0.2, 1.0))) for i in range(count)
    ]
    masses += [
        Mass(
            position=(
                float(rng.uniform(spacing, spacing * (count - 2))),
                -float(rng.uniform(distance + 2.0, 60.0)) - 60.0 * k,
            ),
            velocity=(float(rng.normal(0.0, 50.0)), float(rng.uniform(100.0, 600.0))),
            mass=float(rng.uniform(0.5, 4.0)),
        )
        for k in range(int(rng.integers(1, 4)))
    ]
    return Scene(
        name="rope-under-masses",
        masses=tuple(masses),
        linear_springs=tuple(
            LinearSpring(
                a=i,
                b=i + 1,
                stiffness=stiffness * float(rng.uniform(0.5, 2.0)),
                damping=float(rng.uniform(0.0, 10.0)),
                rest_length=float(spacing * rng.uniform(0.9, 1.0)),
            )
            for i in range(count - 1)
        ),
        anchors=(Anchor(mass=0), Anchor(mass=count - 1)),
        gravity=(0.0, 1000.0),
        air_friction=float(rng.choice((0.0, 0.002))),
        contact=sim.Contact(
            distance=distance, stiffness=log_uniform(1e3, 1e5), friction=float(rng.choice((0.0, 0.3)))
        ),
    )
