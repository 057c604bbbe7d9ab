"""The flat meshes that are drawn, one of each kind, to be instanced: in units of their own.

They are made with trimesh, which takes half a second to import, and kept on the disk as arrays, so that a
start need not wait for it. The file is named by a hash of this source; a changed shape is made anew.
"""

from __future__ import annotations

import contextlib
import hashlib
import io
from collections.abc import Callable
from functools import cache, partial
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
import platformdirs

from sim.files import write_atomically

if TYPE_CHECKING:
    import trimesh


class Mesh(NamedTuple):
    """Vertices (V, 3) and triangles (F, 3) of a flat mesh; every triangle faces the viewer at +z."""

    vertices: np.ndarray
    faces: np.ndarray


@cache
def meshes() -> dict[str, Mesh]:
    """All meshes by name: from the disk, or else made, and kept for the next start."""
    digest = hashlib.sha256(Path(__file__).read_bytes()).hexdigest()[:20]
    path = platformdirs.user_cache_path("softrod", appauthor=False) / f"meshes-{digest}.npz"
    with contextlib.suppress(OSError, ValueError, KeyError), np.load(path) as kept:
        return {name: Mesh(kept[f"{name}.vertices"], kept[f"{name}.faces"]) for name in _MAKERS}
    made = {name: make() for name, make in _MAKERS.items()}
    arrays = {}
    for name, mesh in made.items():
        arrays |= {f"{name}.vertices": mesh.vertices, f"{name}.faces": mesh.faces}
    data = io.BytesIO()
    np.savez(data, **arrays)
    with contextlib.suppress(OSError):  # a start without a cache is only slower
        path.parent.mkdir(parents=True, exist_ok=True)
        write_atomically(path, data.getvalue())
    return {name: Mesh(np.array(mesh.vertices), np.array(mesh.faces)) for name, mesh in made.items()}


def _flat(points: np.ndarray, faces: np.ndarray) -> trimesh.Trimesh:
    """A mesh in the plane z = 0 (or near it), every face turned to the viewer at +z."""
    import trimesh

    vertices = np.column_stack((points, np.zeros(len(points)))) if points.shape[1] == 2 else points
    mesh = trimesh.Trimesh(vertices, faces, process=False)
    away = mesh.face_normals[:, 2] < 0.0
    mesh.faces[away] = mesh.faces[away][:, ::-1]
    return mesh


def _disc(corners: int = 36) -> trimesh.Trimesh:
    """A disc of radius 1."""
    t = np.linspace(0.0, 2.0 * np.pi, corners, endpoint=False)
    rim = np.arange(corners)
    faces = np.column_stack((np.zeros(corners, int), 1 + rim, 1 + (rim + 1) % corners))
    return _flat(np.vstack(([[0.0, 0.0]], np.column_stack((np.cos(t), np.sin(t))))), faces)


def _ring(inner: float = 0.82, corners: int = 48) -> trimesh.Trimesh:
    """A ring of outer radius 1."""
    t = np.linspace(0.0, 2.0 * np.pi, corners, endpoint=False)
    edge = np.column_stack((np.cos(t), np.sin(t)))
    i = np.arange(corners)
    j = (i + 1) % corners
    faces = np.vstack((np.column_stack((i, corners + i, corners + j)), np.column_stack((i, corners + j, j))))
    return _flat(np.vstack((edge * inner, edge)), faces)


def _bar() -> trimesh.Trimesh:
    """A bar from (0, 0) to (1, 0), of width 1."""
    points = np.array([[0.0, -0.5], [1.0, -0.5], [1.0, 0.5], [0.0, 0.5]])
    return _flat(points, np.array([[0, 1, 2], [0, 2, 3]]))


def _slice() -> trimesh.Trimesh:
    """A thin triangle with its tip at (0, 0) and its base, of width 1, at x = 1."""
    return _flat(np.array([[0.0, 0.0], [1.0, -0.5], [1.0, 0.5]]), np.array([[0, 1, 2]]))


def _pin() -> trimesh.Trimesh:
    """A support: a triangle with its tip at (0, 0), on a base plate below."""
    points = np.array(
        [[0.0, 0.0], [-0.7, -1.15], [0.7, -1.15], [-1.0, -1.15], [1.0, -1.15], [1.0, -1.35], [-1.0, -1.35]]
    )
    return _flat(points, np.array([[0, 1, 2], [3, 4, 5], [3, 5, 6]]))


def _coil(turns: int, slimness: float) -> trimesh.Trimesh:
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


_MAKERS: dict[str, Callable[[], trimesh.Trimesh]] = {
    "disc": _disc,
    "ring": _ring,
    "bar": _bar,
    "slice": _slice,
    "pin": _pin,
    **{name: partial(_coil, round(3 + 0.75 * slimness), slimness) for name, slimness in COILS.items()},
}
