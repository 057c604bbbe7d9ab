"""The outlines of the flat meshes of `app.drawing.shapes`, for programs that fill polygons."""

from __future__ import annotations

from collections import Counter
from functools import cache

import numpy as np

from ..drawing.shapes import meshes
from ..drawing.sketch import Floats


@cache
def outlines(name: str) -> tuple[Floats, ...]:
    """(k, 2) corners of each closed line around a mesh, so turned that the mesh lies to its left.

    They are to be filled by the rule that is called nonzero: the wire of a coil crosses itself.
    """
    mesh = meshes()[name]
    edges = [
        (int(one), int(two)) for face in mesh.faces for one, two in zip(face, np.roll(face, -1), strict=True)
    ]
    uses = Counter(map(frozenset, edges))
    # A tight turn of a coil has triangles that are turned over: only where a line starts, its sense counts.
    free = {frozenset(edge): edge for edge in edges if uses[frozenset(edge)] == 1}
    beside: dict[int, list[int]] = {}
    for one, two in free.values():
        beside.setdefault(one, []).append(two)
        beside.setdefault(two, []).append(one)
    lines: list[Floats] = []
    while free:
        start, at = next(iter(free.values()))
        line = [start]
        free.pop(frozenset((start, at)))
        while at != start:
            line.append(at)
            after = next(corner for corner in beside[at] if frozenset((at, corner)) in free)
            free.pop(frozenset((at, after)))
            at = after
        lines.append(mesh.vertices[line, :2])
    return tuple(lines)
