"""A pose as a model in three dimensions: a GLB file, for programs such as Blender and for viewers on the web.

Masses are balls, springs are coils or bars; wedges, supports, muscles and walls are plates. Wind, media and
the ground are left out. glTF measures in metres: a px is a millimetre by default, the middle of the scene's
frame is the origin, and y points up.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

import sim

from ..stage.colors import linear, plain
from ..stage.plan import Picture
from ..stage.shapes import COILS, Mesh, convex, meshes
from ..stage.sketch import Floats, Sketch
from ..words.english import name_of
from . import around, instances
from .instances import Instances
from .window import Window

if TYPE_CHECKING:
    from trimesh import Trimesh

PX_PER_METRE = 1000.0
"""Scale of a model, unless another one is asked for."""

MAX_PARTS = 20_000
"""Masses and springs together, beyond which a file would be too large for most viewers."""

_WIRE = 0.15
"""Radius of a coil's wire, in radii of the coil."""

_SIDES = 6
"""Sides of the wire's cross-section."""

_SAMPLES = 12
"""Cross-sections of the wire in a turn of the coil."""

PLATE = 0.3
"""Thickness of wedges, supports and muscles, in radii of their mass or in their width."""

MUSCLES = ("spring", "belly", False), ("joint", "disc", True)
"""For each kind of muscle: what it moves, the flat mesh of its plate, and whether it is a joint's."""

Solid = tuple[Floats, NDArray[np.int64]]
"""Vertices (k, 3) and triangles (m, 3)."""


def glb(scene: sim.Scene, picture: Picture, scale: float = PX_PER_METRE) -> bytes:
    """The model of a pose, with `scale` px in a metre.

    Raises:
        sim.InputError: the scene has too many parts, or a position is not a finite number.
    """
    from trimesh import Scene as Group
    from trimesh.exchange.gltf import export_glb

    if len(scene.masses) + len(scene.linear_springs) > MAX_PARTS:
        raise sim.InputError(f"a model has {MAX_PARTS} masses and springs at most")
    if not np.isfinite(picture.positions).all():
        raise sim.InputError("a position is not a finite number")
    sketch = Sketch.plain(scene)
    group = Group()
    for name, mesh in _parts(sketch, scene, picture).items():
        # From the page's world to metres.
        mesh.apply_scale(1.0 / (scale * sketch.mapping.scale))
        group.add_geometry(mesh, geom_name=name, node_name=name)
    title = name_of(scene)

    def finish(tree: dict[str, Any]) -> None:
        tree["asset"]["generator"] = "softrod"
        extras = {"title": title, "time": picture.time, "metres_per_px": 1.0 / scale}
        tree["asset"]["extras"] = extras
        tree["materials"] = [
            {
                "name": "softrod",
                "doubleSided": True,
                "pbrMetallicRoughness": {"metallicFactor": 0.0, "roughnessFactor": 0.6},
            }
        ]
        for mesh in tree["meshes"]:
            for primitive in mesh["primitives"]:
                primitive["material"] = 0

    data = export_glb(group, include_normals=True, tree_postprocessor=finish)
    assert isinstance(data, bytes)
    return data


def _parts(sketch: Sketch, scene: sim.Scene, picture: Picture) -> dict[str, Trimesh]:
    """The meshes by name, in the page's world."""
    count, rest = len(sketch.radius), np.array([joint.rest_angle for joint in scene.angular_springs])
    discs = instances.masses(sketch, picture)
    fills = discs.some(slice(count, 2 * count))
    balls = fills._replace(lengths=sketch.radius, widths=sketch.radius)
    found = {"masses": _copies(ball(sketch.many), balls, sketch.radius)}
    pins = instances.pins(sketch, picture)
    if len(pins.angles):
        found["supports"] = _copies(plate(meshes()["pin"]), pins, PLATE * pins.widths)
    if len(sketch.springs):
        springs = instances.springs(sketch, picture, with_ropes=True).seen()
        solid = spring_solid(sketch)
        found["springs"] = _copies(solid, springs, springs.widths)
    for name, flat, of_joints in MUSCLES:
        muscles = instances.muscles(sketch, picture, of_joints).seen()
        if len(muscles.angles):
            found[f"muscles of {name}s"] = _copies(plate(meshes()[flat]), muscles, PLATE * muscles.widths)
    if len(rest):
        wedges = instances.wedges(sketch, picture, rest)
        # The wedge of a joint at its rest angle is nothing.
        seen = wedges.some(wedges.widths > 1e-6)
        if len(seen.angles):
            found["wedges"] = _copies(plate(meshes()["slice"]), seen, PLATE * seen.lengths)
    if plates := walls(sketch, scene):
        found["walls"] = plates
    return {name: mesh for name, mesh in found.items() if len(mesh.faces)}


def _copies(solid: Solid, parts: Instances, depths: Floats) -> Trimesh:
    """Copies of a solid, each so many times as deep, as one mesh with colours."""
    vertices, faces = solid
    cosine, sine = np.cos(parts.angles)[:, None], np.sin(parts.angles)[:, None]
    x, y = vertices[:, 0] * parts.lengths[:, None], vertices[:, 1] * parts.widths[:, None]
    places = np.stack(
        (
            parts.places[:, :1] + x * cosine - y * sine,
            parts.places[:, 1:] + x * sine + y * cosine,
            vertices[:, 2] * depths[:, None],
        ),
        axis=-1,
    ).reshape(-1, 3)
    every = (faces + len(vertices) * np.arange(len(cosine))[:, None, None]).reshape(-1, 3)
    return _colored(places, every, np.repeat(parts.colors, len(vertices), axis=0))


def _colored(vertices: Floats, faces: NDArray[np.int64], colors: NDArray[np.uint8]) -> Trimesh:
    """A mesh with a colour at each vertex: glTF has them in linear light."""
    from trimesh import Trimesh

    light = np.column_stack((plain(255.0 * linear(colors)), np.full(len(colors), 255, np.uint8)))
    return Trimesh(vertices, faces, vertex_colors=light, process=False)


def ball(many: bool) -> Solid:
    """A ball of radius 1."""
    from trimesh.creation import icosphere

    mesh = icosphere(subdivisions=1 if many else 2)
    return np.array(mesh.vertices), np.array(mesh.faces)


def spring_solid(sketch: Sketch) -> Solid:
    """A bar or a coil from (0, 0) to (1, 0), of width or radius 1."""
    return _rod() if sketch.bars else _coil(sketch.spring_shape)


def _rod() -> Solid:
    """A bar from (0, 0) to (1, 0), 1 thick."""
    from trimesh.creation import cylinder

    mesh = cylinder(0.5, sections=_SIDES, segment=((0.0, 0.0, 0.0), (1.0, 0.0, 0.0)))
    return np.array(mesh.vertices), np.array(mesh.faces)


def _coil(shape: str) -> Solid:
    """A helix from (0, 0) to (1, 0), of radius 1, with straight ends; see `app.stage.shapes`."""
    slimness = COILS.get(shape, 7.0)
    turns = round(3 + 0.75 * slimness)
    lead = 0.5 / slimness
    t = np.linspace(0.0, turns, turns * _SAMPLES + 1)
    swell = np.clip(np.minimum(t, turns - t) / 0.5, 0.0, 1.0)
    angle = 2.0 * np.pi * t
    out = np.column_stack((np.zeros(len(t)), np.sin(angle), np.cos(angle)))
    wire = swell[:, None] * out
    wire[:, 0] = lead + (1.0 - 2.0 * lead) * t / turns
    # Where it is mostly drawn, the wire is round.
    stretch = np.array((slimness, 1.0, 1.0))
    path = np.vstack(((0.0, 0.0, 0.0), wire, (1.0, 0.0, 0.0))) * stretch
    along = np.gradient(path, axis=0)
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    # Across the wire: away from the axis of the coil, and perpendicular to that.
    one = np.vstack((out[0], out, out[-1]))
    one -= (one * along).sum(1, keepdims=True) * along
    one /= np.linalg.norm(one, axis=1, keepdims=True)
    other = np.cross(along, one)
    turn = np.arange(_SIDES) * 2.0 * np.pi / _SIDES
    rim = np.cos(turn)[:, None] * one[:, None] + np.sin(turn)[:, None] * other[:, None]
    vertices = (path[:, None] + _WIRE * rim).reshape(-1, 3) / stretch
    i, j = np.meshgrid(np.arange(len(path) - 1), np.arange(_SIDES), indexing="ij")
    a, b = i * _SIDES + j, i * _SIDES + (j + 1) % _SIDES
    sides = np.concatenate((np.stack((a, b, b + _SIDES), -1), np.stack((a, b + _SIDES, a + _SIDES), -1)))
    end = convex(np.zeros((_SIDES, 2))).faces
    last = len(vertices) - _SIDES
    return vertices, np.concatenate((sides.reshape(-1, 3), end[:, ::-1], end + last))


def plate(mesh: Mesh) -> Solid:
    """A flat mesh, 1 thick, halfway to either side."""
    from trimesh.creation import extrude_triangulation

    solid = extrude_triangulation(mesh.vertices[:, :2], mesh.faces, 1.0, process=False)
    return np.array(solid.vertices) - (0.0, 0.0, 0.5), np.array(solid.faces)


def walls(sketch: Sketch, scene: sim.Scene) -> Trimesh | None:
    """Plates where walls are, as far as the scene's frame and a little more goes."""
    from trimesh.util import concatenate

    window = Window.fit(sketch, scene.view.frame, (1000, 1000))
    origin = np.array((window.x, window.y))
    depth = 4.0 * float(np.median(sketch.radius))
    found: list[Trimesh] = []
    for wall in around.walls(sketch, window):
        if len(wall.corners) < 3:
            continue
        corners = ((wall.corners - origin) / (window.step, -window.step))[::-1]
        vertices, faces = plate(convex(corners))
        color = plain(np.tile(sketch.palette.line, (len(vertices), 1)))
        found.append(_colored(vertices * (1.0, 1.0, depth), faces, color))
    if not found:
        return None
    whole: Any = concatenate(found)
    return whole
