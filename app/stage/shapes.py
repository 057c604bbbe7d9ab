"""Flat meshes of the parts of a body, of unit size, for instanced drawing."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache, partial
from typing import NamedTuple

import numpy as np


class Mesh(NamedTuple):
    """A flat mesh.

    Attributes:
        vertices: (V, 3).
        faces: (F, 3) triangles, all facing the viewer at +z.
        outlines: (k, 2) corners of each closed outline, for filling by the nonzero rule: the wire of a coil
            crosses itself.
    """

    vertices: np.ndarray
    faces: np.ndarray
    outlines: tuple[np.ndarray, ...]


@cache
def meshes() -> dict[str, Mesh]:
    """All meshes by name."""
    return {name: make() for name, make in _MAKERS.items()}


def convex(*polygons: np.ndarray) -> Mesh:
    """A mesh of convex polygons, (k, 2) corners each, anticlockwise, as fans of triangles."""
    fans, start = [], 0
    for polygon in polygons:
        k = np.arange(1, len(polygon) - 1)
        fans.append(start + np.column_stack((0 * k, k, k + 1)))
        start += len(polygon)
    corners = np.concatenate(polygons)
    return Mesh(np.column_stack((corners, np.zeros(len(corners)))), np.concatenate(fans), polygons)


def _circle(corners: int, radius: float = 1.0) -> np.ndarray:
    t = np.linspace(0.0, 2.0 * np.pi, corners, endpoint=False)
    return radius * np.column_stack((np.cos(t), np.sin(t)))


def _ring(inner: float = 0.82, corners: int = 48) -> Mesh:
    """A ring of outer radius 1."""
    lines = _circle(corners, inner), _circle(corners)
    vertices = np.column_stack((np.concatenate(lines), np.zeros(2 * corners)))
    i = np.arange(corners)
    j = (i + 1) % corners
    faces = np.vstack((np.column_stack((i, corners + i, corners + j)), np.column_stack((i, corners + j, j))))
    return Mesh(vertices, faces, (lines[0][::-1], lines[1]))


def _coil(turns: int, slimness: float) -> Mesh:
    """A coil spring seen from the side, from (0, 0) to (1, 0), of amplitude 1: one flat ribbon.

    The wire loops like a real one; the front half of each turn lies a little nearer.

    Args:
        turns: of the coil.
        slimness: typical length over amplitude, at which the width of the ribbon is even.
    """
    lead, line = 0.5 / slimness, 0.3
    t = np.linspace(0.0, turns, turns * 20 + 1)
    swell = np.clip(np.minimum(t, turns - t) / 0.5, 0.0, 1.0)
    x = lead + (1.0 - 2.0 * lead) * t / turns + 0.17 / slimness * swell * (np.cos(2.0 * np.pi * t) - 1.0)
    y = np.sin(2.0 * np.pi * t) * swell
    z = 0.004 * np.cos(2.0 * np.pi * t)
    path = np.vstack(([[0.0, 0.0, 0.0], [lead * 0.7, 0.0, 0.0]], np.column_stack((x, y, z))))
    path = np.vstack((path, [[1.0 - lead * 0.7, 0.0, 0.0], [1.0, 0.0, 0.0]]))
    shape = np.array([slimness, 1.0])
    along = np.gradient(path[:, :2] * shape, axis=0)
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    side = np.column_stack((-along[:, 1], along[:, 0])) * (line / 2.0) / shape
    left, right = path.copy(), path.copy()
    left[:, :2] += side
    right[:, :2] -= side
    n = len(path)
    i = np.arange(n - 1)
    faces = np.vstack((np.column_stack((i, i + n, i + 1)), np.column_stack((i + 1, i + n, i + n + 1))))
    vertices = np.vstack((left, right))
    # In tight turns some triangles of the ribbon face backwards.
    one, two = (vertices[faces[:, k]] - vertices[faces[:, 0]] for k in (1, 2))
    away = one[:, 0] * two[:, 1] < one[:, 1] * two[:, 0]
    faces = np.where(away[:, None], faces[:, ::-1], faces)
    return Mesh(vertices, faces, (np.vstack((right, left[::-1]))[:, :2],))


COILS = {"coil": 3.3, "coil of slim springs": 7.0, "coil of very slim springs": 16.0}
"""Coils and their slimness; all springs of a scene are drawn with one of them."""

_BAR = np.array([[0.0, -0.5], [1.0, -0.5], [1.0, 0.5], [0.0, 0.5]])
_ALONG = np.linspace(0.0, 1.0, 17)
_SWELL = 0.5 * np.sin(np.pi * _ALONG) ** 0.7
_BELLY = np.vstack((np.column_stack((_ALONG, -_SWELL)), np.column_stack((_ALONG, _SWELL))[-2:0:-1]))
_SLICE = np.array([[0.0, 0.0], [1.0, -0.5], [1.0, 0.5]])
_SUPPORT = np.array([[0.0, 0.0], [-0.7, -1.15], [0.7, -1.15]])
_BASE = np.array([[-1.0, -1.35], [1.0, -1.35], [1.0, -1.15], [-1.0, -1.15]])

_MAKERS: dict[str, Callable[[], Mesh]] = {
    "disc": partial(convex, _circle(36)),  # of radius 1
    "ring": _ring,
    "bar": partial(convex, _BAR),  # from (0, 0) to (1, 0), of width 1
    "belly": partial(convex, _BELLY),  # of a muscle, from (0, 0) to (1, 0), of width 1
    "slice": partial(convex, _SLICE),  # of a wedge: its tip at (0, 0), its base of width 1 at x = 1
    "pin": partial(convex, _SUPPORT, _BASE),  # a support: its tip at (0, 0), on a plate
    **{name: partial(_coil, round(3 + 0.75 * slimness), slimness) for name, slimness in COILS.items()},
}
