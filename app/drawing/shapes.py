"""The flat meshes that are drawn, one of each kind, to be instanced: in units of their own."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache, partial
from typing import NamedTuple

import numpy as np


class Mesh(NamedTuple):
    """Vertices (V, 3) and triangles (F, 3) of a flat mesh; every triangle faces the viewer at +z."""

    vertices: np.ndarray
    faces: np.ndarray


@cache
def meshes() -> dict[str, Mesh]:
    """All meshes by name."""
    return {name: make() for name, make in _MAKERS.items()}


def _flat(points: np.ndarray, faces: np.ndarray) -> Mesh:
    """A mesh in the plane z = 0 (or near it), every face turned to the viewer at +z."""
    vertices = np.column_stack((points, np.zeros(len(points)))) if points.shape[1] == 2 else points
    one, two = (vertices[faces[:, k]] - vertices[faces[:, 0]] for k in (1, 2))
    away = one[:, 0] * two[:, 1] < one[:, 1] * two[:, 0]
    return Mesh(vertices, np.where(away[:, None], faces[:, ::-1], faces))


def _disc(corners: int = 36) -> Mesh:
    """A disc of radius 1."""
    t = np.linspace(0.0, 2.0 * np.pi, corners, endpoint=False)
    rim = np.arange(corners)
    faces = np.column_stack((np.zeros(corners, int), 1 + rim, 1 + (rim + 1) % corners))
    return _flat(np.vstack(([[0.0, 0.0]], np.column_stack((np.cos(t), np.sin(t))))), faces)


def _ring(inner: float = 0.82, corners: int = 48) -> Mesh:
    """A ring of outer radius 1."""
    t = np.linspace(0.0, 2.0 * np.pi, corners, endpoint=False)
    edge = np.column_stack((np.cos(t), np.sin(t)))
    i = np.arange(corners)
    j = (i + 1) % corners
    faces = np.vstack((np.column_stack((i, corners + i, corners + j)), np.column_stack((i, corners + j, j))))
    return _flat(np.vstack((edge * inner, edge)), faces)


def _bar() -> Mesh:
    """A bar from (0, 0) to (1, 0), of width 1."""
    points = np.array([[0.0, -0.5], [1.0, -0.5], [1.0, 0.5], [0.0, 0.5]])
    return _flat(points, np.array([[0, 1, 2], [0, 2, 3]]))


def _slice() -> Mesh:
    """A thin triangle with its tip at (0, 0) and its base, of width 1, at x = 1."""
    return _flat(np.array([[0.0, 0.0], [1.0, -0.5], [1.0, 0.5]]), np.array([[0, 1, 2]]))


def _pin() -> Mesh:
    """A support: a triangle with its tip at (0, 0), on a base plate below."""
    points = np.array(
        [[0.0, 0.0], [-0.7, -1.15], [0.7, -1.15], [-1.0, -1.15], [1.0, -1.15], [1.0, -1.35], [-1.0, -1.35]]
    )
    return _flat(points, np.array([[0, 1, 2], [3, 4, 5], [3, 5, 6]]))


def _coil(turns: int, slimness: float) -> Mesh:
    """A coil spring seen from the side, from (0, 0) to (1, 0), of amplitude 1: one flat ribbon.

    The coil's wire loops, as a real one does; the front half of each turn lies a little nearer.

    Args:
        turns: of the coil.
        slimness: length over amplitude at which it is mostly drawn; there the ribbon is even.
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
    return _flat(np.vstack((left, right)), faces)


COILS = {"coil": 3.3, "coil of slim springs": 7.0, "coil of very slim springs": 16.0}
"""Coils by their slimness: one scene is drawn with one of them."""


_MAKERS: dict[str, Callable[[], Mesh]] = {
    "disc": _disc,
    "ring": _ring,
    "bar": _bar,
    "slice": _slice,
    "pin": _pin,
    **{name: partial(_coil, round(3 + 0.75 * slimness), slimness) for name, slimness in COILS.items()},
}
