"""Bodies of many shapes with random numbers in them, in the middle of a motion."""

from __future__ import annotations

import itertools
import math
from collections.abc import Collection
from typing import get_args

import numpy as np
from msgspec.structs import replace

from sim import Anchor, AngularSpring, Beat, JointMuscle, LinearSpring, Mass, Scene, SpringMuscle
from sim.edit.build import wrapped_degrees
from sim.scene.types import ForceLaw
from tests.sim.builders import euler
from tests.sim.changes import with_joints, with_springs

LAWS: tuple[ForceLaw, ...] = get_args(ForceLaw)

Edges = list[tuple[int, int]]
Positions = list[tuple[float, float]]


def sharing(edges: Edges) -> Edges:
    """All pairs of springs that share a mass."""
    return [(s, t) for s, t in itertools.combinations(range(len(edges)), 2) if set(edges[s]) & set(edges[t])]


def _chain() -> tuple[Positions, Edges, Edges]:
    return [(40.0 * i, 0.0) for i in range(7)], [(i, i + 1) for i in range(6)], [(i, i + 1) for i in range(5)]


def _ring() -> tuple[Positions, Edges, Edges]:
    turns = [2.0 * math.pi * i / 8 for i in range(8)]
    positions = [(50.0 * math.cos(v), 50.0 * math.sin(v)) for v in turns]
    return positions, [(i, (i + 1) % 8) for i in range(8)], [(i, (i + 1) % 8) for i in range(8)]


def _tree() -> tuple[Positions, Edges, Edges]:
    """Three generations with two branches each; some springs point towards the root."""
    positions = [(0.0, 0.0)] + [(60.0 * g, 40.0 * i) for g in (1, 2, 3) for i in range(2**g)]
    edges = [((i - 1) // 2, i) if i % 3 else (i, (i - 1) // 2) for i in range(1, 15)]
    return positions, edges, sharing(edges)


def _girder() -> tuple[Positions, Edges, Edges]:
    """Two rails, rungs and diagonals, with joints along the rails and in the corners."""
    count = 6
    positions = [(40.0 * (i // 2), 40.0 * (i % 2)) for i in range(2 * count)]
    rails = [(i, i + 2) for i in range(2 * count - 2)]
    rungs = [(2 * i, 2 * i + 1) for i in range(count)]
    diagonals = [(2 * i, 2 * i + 3) for i in range(count - 1)]
    edges = [*rails, *rungs, *diagonals]
    along = [(i, i + 2) for i in range(2 * count - 4)]
    return positions, edges, [*along, *((2 * i, len(rails) + i) for i in range(count - 1))]


def _cloth() -> tuple[Positions, Edges, Edges]:
    """A grid, with a joint wherever two springs lie in line."""
    side = 4
    positions = [(30.0 * (i % side), 30.0 * (i // side)) for i in range(side * side)]
    across = [(i, i + 1) for i in range(side * side) if i % side < side - 1]
    down = [(i, i + side) for i in range(side * (side - 1))]
    edges = [*across, *down]
    in_line = [
        (s, t)
        for s, t in itertools.permutations(range(len(edges)), 2)
        if edges[s][1] == edges[t][0] and edges[s][1] - edges[s][0] == edges[t][1] - edges[t][0]
    ]
    return positions, edges, in_line


def _hub() -> tuple[Positions, Edges, Edges]:
    """Five springs from one mass, two of them towards it, and a joint between every two."""
    positions = [(0.0, 0.0), *((60.0 * math.cos(1.3 * i), 60.0 * math.sin(1.3 * i)) for i in range(5))]
    edges = [(0, i + 1) if i % 2 else (i + 1, 0) for i in range(5)]
    return positions, edges, list(itertools.combinations(range(5), 2))


def _tangle() -> tuple[Positions, Edges, Edges]:
    """No order at all."""
    rng = np.random.default_rng(9)
    count = 9
    positions = [(float(x), float(y)) for x, y in rng.uniform(0.0, 200.0, (count, 2))]
    pairs = list(itertools.combinations(range(count), 2))
    edges = [pairs[i][:: rng.choice((-1, 1))] for i in rng.choice(len(pairs), 16, replace=False)]
    meeting = sharing(edges)
    return positions, edges, [meeting[i] for i in rng.choice(len(meeting), 20, replace=False)]


SHAPES = {
    "chain": _chain,
    "ring": _ring,
    "tree": _tree,
    "girder": _girder,
    "cloth": _cloth,
    "hub": _hub,
    "tangle": _tangle,
}


def body(
    shape: str,
    law: ForceLaw = "conservative",
    seed: int = 0,
    *,
    damping: float = 30.0,
    twist: float = 3.0,
    air: float = 0.01,
    gravity: tuple[float, float] = (30.0, 500.0),
    held: tuple[int, ...] = (),
    joints: bool = True,
) -> Scene:
    """A body that is stretched, compressed, bent and moving.

    Args:
        shape: one of SHAPES.
        law: the force law.
        seed: of the random numbers.
        damping, twist: the largest damping of a linear and of an angular spring, kg/s.
        air, gravity: as in a scene.
        held: masses that are held.
        joints: whether there are angular springs.
    """
    rng = np.random.default_rng(seed)
    positions, edges, pairs = SHAPES[shape]()
    typical = float(np.median([math.dist(positions[a], positions[b]) for a, b in edges]))
    moved = np.array(positions) + rng.uniform(-0.25, 0.25, (len(positions), 2)) * typical
    speeds = rng.normal(0.0, 100.0, moved.shape)

    def some(low: float, high: float) -> float:
        return float(rng.uniform(low, high))

    return Scene(
        name=shape,
        masses=tuple(
            Mass(position=(x, y), velocity=(u, v), mass=some(0.5, 3.0))
            for (x, y), (u, v) in zip(moved.tolist(), speeds.tolist(), strict=True)
        ),
        linear_springs=tuple(
            LinearSpring(
                a=a,
                b=b,
                stiffness=some(100.0, 1e4),
                damping=some(0.1, 1.0) * damping,
                rest_length=math.dist(moved[a], moved[b]) * some(0.6, 1.4),
            )
            for a, b in edges
        ),
        angular_springs=tuple(
            AngularSpring(
                a=a,
                b=b,
                stiffness=some(10.0, 3000.0),
                damping=some(0.1, 1.0) * twist,
                rest_angle=some(-180.0, 180.0),
            )
            for a, b in (pairs if joints else [])
        ),
        anchors=tuple(Anchor(mass=i) for i in held),
        gravity=gravity,
        air_friction=air,
        force_law=law,
        integrator=euler(1e-4),
    )


def tangle(seed: int, held: tuple[int, ...] = ()) -> Scene:
    """A body with no order to it and weak joints under the tutorial's law, which nothing pulls at."""
    scene = body("tangle", "tutorial", seed, twist=0.0, air=0.0, gravity=(0.0, 0.0), held=held)
    return with_joints(scene, stiffness=lambda _, joint: 0.1 * joint.stiffness)


def with_muscles(scene: Scene, stretch: float = 0.08, turn: float = 8.0) -> Scene:
    """The scene with a muscle in every spring and every joint: sines and pulses of many phases.

    Args:
        scene: a scene of masses and springs.
        stretch: amplitude of springs, as a fraction.
        turn: of joints, degrees.
    """

    def of_spring(s: int, _: LinearSpring) -> SpringMuscle:
        wave = "pulse" if s % 4 == 1 else "sine"
        amplitude = stretch if s % 3 else -stretch
        return SpringMuscle(amplitude=amplitude, phase=50.0 * s % 360.0, wave=wave, per_beat=1 + s % 2)

    def of_joint(j: int, _: AngularSpring) -> JointMuscle:
        return JointMuscle(amplitude=turn, phase=35.0 * j % 360.0, wave="sine")

    scene = with_joints(with_springs(scene, muscle=of_spring), muscle=of_joint)
    return replace(scene, beat=Beat(frequency=1.7, phase=40.0))


def flipped(scene: Scene, springs: Collection[int]) -> Scene:
    """The scene whose springs of these indices go from b to a. Angles with one of them are 180° larger."""
    angular = tuple(
        replace(j, rest_angle=wrapped_degrees(j.rest_angle + 180.0))
        if (j.a in springs) != (j.b in springs)
        else j
        for j in scene.angular_springs
    )
    linear = tuple(
        replace(s, a=s.b, b=s.a) if i in springs else s for i, s in enumerate(scene.linear_springs)
    )
    return replace(scene, linear_springs=linear, angular_springs=angular)


def some_flipped(scene: Scene, seed: int) -> Scene:
    """The scene with about half of its springs flipped."""
    rng = np.random.default_rng(seed)
    return flipped(scene, set(np.flatnonzero(rng.random(len(scene.linear_springs)) < 0.5).tolist()))
