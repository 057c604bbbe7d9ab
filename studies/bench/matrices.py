"""`softrod bench matrices`: how much elimination fills into the matrices of implicit steps."""

from __future__ import annotations

import math
import time

import numpy as np
from msgspec.structs import replace
from rich.console import Console

import sim
from sim import Anchor, AngularSpring, LinearSpring, Mass, Scene
from sim.model.sparsity import fill, new_matrix, pattern_of
from sim.model.system import build_system

from ..reporting.report import Table

PRESETS = ("study-w4", "study-ring", "study-tree", "hair-tuft", "flag-pole", "study-cloth")
SIDES = (10, 20, 30)
"""Masses along the edge of a cloth patch."""

GIRDER = 50
"""Rungs of a girder."""


def cloth(side: int) -> Scene:
    """Return a square patch of springs that bends like a net of rods."""
    width = 20.0 * (side - 1)
    body = sim.Cloth(
        columns=side, rows=side, width=width, height=width, start=(0.0, 0.0), diagonals=False, held="corner"
    )
    scene = sim.validate(Scene(name=f"cloth-{side}x{side}", bodies=(body,)))
    # The other joints hold the corners of its cells.
    in_line = tuple(joint for joint in scene.angular_springs if not joint.rest_angle)
    return replace(scene, bodies=(), angular_springs=in_line)


def girder(rungs: int) -> Scene:
    """Return two rails, with rungs and diagonals between them, and joints where three masses are in line."""
    places = [(20.0 * (i // 2), 20.0 * (i % 2)) for i in range(2 * rungs)]
    rails = [(i, i + 2) for i in range(2 * rungs - 2)]
    between = [(2 * i, 2 * i + 1) for i in range(rungs)] + [(2 * i, 2 * i + 3) for i in range(rungs - 1)]
    return Scene(
        name=f"girder-{rungs}",
        masses=tuple(Mass(position=place) for place in places),
        linear_springs=tuple(
            LinearSpring(a=a, b=b, stiffness=1e4, rest_length=math.dist(places[a], places[b]))
            for a, b in rails + between
        ),
        angular_springs=tuple(AngularSpring(a=s, b=s + 2, stiffness=1e4) for s in range(len(rails) - 2)),
        anchors=(Anchor(mass=0),),
    )


def in_a_band(scene: Scene) -> int:
    """Return the number of blocks in the band of a scene's matrix, in reverse Cuthill-McKee order."""
    from scipy.sparse import csr_matrix
    from scipy.sparse.csgraph import reverse_cuthill_mckee

    n = len(scene.masses)
    ends = np.array([(s.a, s.b) for s in scene.linear_springs])
    joined = [ends] + [
        np.array([(a, b)])
        for joint in scene.angular_springs
        for a in ends[joint.a].tolist()
        for b in ends[joint.b].tolist()
        if a != b
    ]
    a, b = np.concatenate(joined).T
    graph = csr_matrix((np.ones(2 * a.size), (np.r_[a, b], np.r_[b, a])), (n, n))
    position = np.empty(n, np.int64)
    position[reverse_cuthill_mckee(graph, symmetric_mode=True)] = np.arange(n)
    width = int(abs(position[a] - position[b]).max())
    return n + sum(2 * (n - k) for k in range(1, width + 1))


def bench_matrices(console: Console, repeats: int) -> None:
    """Print for each body the blocks of 2 x 2 in its matrix, in its factors and in a band instead."""
    rows = []
    for scene in (*map(sim.load_scene, PRESETS), girder(GIRDER), *map(cloth, SIDES)):
        system, times = build_system(scene), []
        for _ in range(repeats):
            pattern_of.cache_clear()
            began = time.perf_counter()
            new_matrix(system.body, system.held)
            times.append(time.perf_counter() - began)
        blocks, factors = fill(system.body, new_matrix(system.body, system.held))
        counts = map(str, (len(scene.masses), blocks, factors))
        filled = f"{100.0 * (factors / blocks - 1.0):.0f} %"
        rows.append((scene.name, *counts, filled, str(in_a_band(scene)), f"{1e3 * min(times):.2g}"))
    headings = ("body", "masses", "blocks", "in the factors", "filled in", "in a band", "ms to find this")
    console.print(Table(headings, rows, title="Blocks of matrices; their order is found once for a body"))
