"""Random bodies of any topology."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable

import numpy as np

import sim
from sim import Anchor, AngularSpring, LinearSpring, Mass, Scene
from sim.scene.types import Circle

Positions = list[tuple[float, float]]
Pairs = list[tuple[int, int]]
Graph = tuple[Positions, Pairs, Pairs]
"""Positions of masses, (start, end) of springs, and pairs of springs that joints hold."""

_SEED = 2008
"""Prefix of the seed of each body."""


def random_body(seed: int) -> Scene:
    """Return the random body of a seed, the same one every time.

    Shape, size, force law, masses, stiffnesses, dampings, rest lengths and angles, speeds, anchors and their
    circles, gravity and air are all random; stiffnesses and dampings differ by up to a factor of four within
    a body and by a hundred and more between bodies.
    """
    rng = np.random.default_rng((_SEED, seed))
    shape = list(_SHAPES)[int(rng.integers(len(_SHAPES)))]
    spacing = float(rng.uniform(15.0, 50.0))
    positions, springs, joints = _SHAPES[shape](rng)
    n = len(positions)
    at = spacing * (np.array(positions) + rng.normal(0.0, 0.05, (n, 2)))

    def log_uniform(low: float, high: float) -> float:
        return float(np.exp(rng.uniform(math.log(low), math.log(high))))

    def about(size: float) -> float:
        return size * float(rng.uniform(0.5, 2.0))

    kilograms = log_uniform(0.2, 5.0)
    stiffness, damping = log_uniform(1e3, 1e6), log_uniform(1.0, 100.0) * float(rng.random() < 0.85)
    bending, twist = log_uniform(1e2, 1e5), log_uniform(0.1, 20.0) * float(rng.random() < 0.3)
    stretch, bent = float(rng.uniform(0.0, 0.2)), float(rng.uniform(0.0, 60.0))
    speed = log_uniform(1.0, 300.0)
    held = rng.choice(n, min(n - 1, int(rng.choice((0, 1, 1, 1, 2)))), replace=False).tolist()
    circle = Circle(
        radius=float(rng.uniform(10.0, 150.0)),
        frequency=float(rng.uniform(0.5, 2.5)) * float(rng.choice((-1.0, 1.0))),
        ramp=float(rng.uniform(0.05, 0.3)),
    )
    led = rng.random() < 0.4
    return sim.validate(
        Scene(
            name=f"{shape}-{seed}",
            masses=tuple(
                Mass(position=(x, y), velocity=(u, v), mass=about(kilograms))
                for (x, y), (u, v) in zip(at.tolist(), rng.normal(0.0, speed, (n, 2)).tolist(), strict=True)
            ),
            linear_springs=tuple(
                LinearSpring(
                    a=a,
                    b=b,
                    stiffness=about(stiffness),
                    damping=about(damping),
                    rest_length=math.dist(at[a], at[b]) * float(rng.uniform(1.0 - stretch, 1.0 + stretch)),
                )
                for a, b in springs
            ),
            angular_springs=tuple(
                AngularSpring(
                    a=s,
                    b=t,
                    stiffness=about(bending),
                    damping=about(twist),
                    rest_angle=math.remainder(
                        _angle(at, springs[s], springs[t]) + float(rng.uniform(-bent, bent)), 360.0
                    ),
                )
                for s, t in joints
            ),
            anchors=tuple(
                Anchor(mass=mass, circle=circle if led and i == 0 else None)
                for i, mass in enumerate(sorted(held))
            ),
            gravity=(0.0, float(rng.choice((0.0, 1000.0, 2000.0)))),
            air_friction=float(rng.choice((0.0, 0.002, 0.02))),
            air_law="tutorial",  # its kinks are what methods with error control have to see
            force_law="tutorial" if rng.random() < 0.5 else "conservative",
        )
    )


def _angle(at: np.ndarray, first: tuple[int, int], second: tuple[int, int]) -> float:
    """Return the angle from one spring to another, degrees."""
    a, b = at[first[1]] - at[first[0]], at[second[1]] - at[second[0]]
    return math.degrees(math.atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]))


def _chain(rng: np.random.Generator) -> Graph:
    n = int(rng.integers(3, 41))
    springs = [(i, i + 1) for i in range(n - 1)]
    return [(float(i), 0.0) for i in range(n)], springs, [(i, i + 1) for i in range(n - 2)]


def _ring(rng: np.random.Generator) -> Graph:
    n = int(rng.integers(4, 41))
    radius = 0.5 / math.sin(math.pi / n)
    turns = [2.0 * math.pi * i / n for i in range(n)]
    around = [(i, (i + 1) % n) for i in range(n)]
    return [(radius * math.cos(v), radius * math.sin(v)) for v in turns], around, around


def _tree(rng: np.random.Generator) -> Graph:
    """Return a tree: each mass hangs on an earlier one, with a joint between their springs."""
    n = int(rng.integers(5, 41))
    positions: Positions = [(0.0, 0.0)]
    springs: Pairs = []
    joints: Pairs = []
    way = [0.0]
    for i in range(1, n):
        parent = int(rng.integers(max(0, i - 6), i))
        way.append(way[parent] + float(rng.uniform(-1.0, 1.0)))
        x, y = positions[parent]
        positions.append((x + math.cos(way[i]), y + math.sin(way[i])))
        springs.append((parent, i) if rng.random() < 0.7 else (i, parent))
        if parent:
            joints.append((parent - 1, i - 1))
    return positions, springs, joints


def _grid(rng: np.random.Generator) -> Graph:
    """Return a grid, perhaps with diagonals, and joints where two springs lie in line."""
    across, down = (int(c) for c in rng.integers(2, 8, 2))
    positions = [(float(i % across), float(i // across)) for i in range(across * down)]
    springs = [(i, i + 1) for i in range(across * down) if i % across < across - 1]
    springs += [(i, i + across) for i in range(across * (down - 1))]
    joints = [
        (s, t)
        for s, t in itertools.permutations(range(len(springs)), 2)
        if springs[s][1] == springs[t][0] and springs[s][1] - springs[s][0] == springs[t][1] - springs[t][0]
    ]
    if rng.random() < 0.7:
        springs += [(i, i + across + 1) for i in range(across * (down - 1)) if i % across < across - 1]
    return positions, springs, joints


def _tangle(rng: np.random.Generator) -> Graph:
    """Return springs between random pairs, and joints between random springs that share a mass."""
    n = int(rng.integers(4, 16))
    positions = [(float(x), float(y)) for x, y in rng.uniform(0.0, math.sqrt(n), (n, 2))]
    pairs = list(itertools.combinations(range(n), 2))
    chosen = rng.choice(len(pairs), min(len(pairs), int(rng.integers(n, 3 * n))), replace=False)
    springs = [pairs[i] if rng.random() < 0.5 else pairs[i][::-1] for i in sorted(chosen.tolist())]
    sharing = [
        (s, t)
        for s, t in itertools.combinations(range(len(springs)), 2)
        if len({*springs[s], *springs[t]}) == 3
    ]
    some = rng.choice(len(sharing), min(len(sharing), int(rng.integers(0, 2 * n))), replace=False)
    return positions, springs, [sharing[i] for i in sorted(some.tolist())]


_SHAPES: dict[str, Callable[[np.random.Generator], Graph]] = {
    "chain": _chain,
    "ring": _ring,
    "tree": _tree,
    "grid": _grid,
    "tangle": _tangle,
}
