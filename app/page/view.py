"""One page's picture: the viser nodes of its scene, which belong to that page alone.

Only what changed is sent: a frame in which nothing moved by a tenth of a pixel sends nothing, and an array
that is the same as before is not sent again.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
import viser
from numpy.typing import NDArray

from sim import Scene, Simulation

from .colors import palette, sent_one
from .drawing import Z_GIZMO, Z_RING, Floats, Sketch
from .shapes import meshes

STILL = 0.1
"""Movement (in pixels of a 600 pixel high frame) below which a picture counts as unchanged."""

MAX_GIZMOS = 12
"""Gizmos are one node each; held masses beyond so many are dragged by themselves."""

# Ambient light only and no shadows: every mesh shows its own colour, and software rendering is twice as fast.
_FLAT: dict[str, Any] = {"material": "toon3", "lod": "off", "cast_shadow": False, "receive_shadow": False}


@dataclass(frozen=True)
class Picture:
    """What is to be drawn.

    Attributes:
        positions: (n, 2) px.
        deviations: (J,) present angle minus rest angle, degrees in (-180, 180].
        rest_length_scale: factor of the rest lengths.
        ghost: (n, 2) px, where the masses of a second body are, or None.
    """

    positions: Floats
    deviations: Floats
    rest_length_scale: float
    ghost: Floats | None = None

    @staticmethod
    def of(simulation: Simulation, ghost: Simulation | None = None) -> Picture:
        """The present state, and that of a second body."""
        off = simulation.angles - simulation.rest_angles
        return Picture(
            simulation.positions,
            180.0 - (180.0 - off) % 360.0,
            simulation.rest_length_scale,
            ghost.positions if ghost is not None else None,
        )

    @staticmethod
    def at_start(scene: Scene) -> Picture:
        """The start of a scene, when there is no simulation yet; without the joints."""
        starts = scene.pose.positions if scene.pose else [mass.position for mass in scene.masses]
        return Picture(np.array(starts, float), np.zeros(len(scene.angular_springs)), scene.rest_length_scale)


@dataclass(frozen=True)
class Touch:
    """What the user's hand did to a mass; positions in px."""

    phase: str  # start, update, end
    mass: int
    x: float
    y: float
    by_gizmo: bool


class Canvas:
    """The nodes of one page.

    Args:
        client: the page.
        on_touch: hears of drags, on viser's event loop; it must not block.
        on_click: hears which mass was clicked.
    """

    def __init__(
        self, client: viser.ClientHandle, on_touch: Callable[[Touch], None], on_click: Callable[[int], None]
    ) -> None:
        self._client = client
        self._on_touch = on_touch
        self._on_click = on_click
        self._nodes: dict[str, Any] = {}
        self._sent: dict[tuple[str, str], NDArray[Any]] = {}
        self._gizmos: list[tuple[int, viser.TransformControlsHandle]] = []
        self._built: tuple[Scene, bool] | None = None
        self._drawn: Picture | None = None
        self._gizmo_in_hand: int | None = None
        self.sketch: Sketch | None = None

    def build(self, scene: Scene, dark: bool) -> None:
        """Put up the nodes of a scene, in place of those of the one before; `draw` then fills them in."""
        if self._built == (scene, dark):
            return
        with self._client.atomic():
            self._clear()
            self._built = (scene, dark)
            self.sketch = sketch = Sketch(scene, palette(scene.view.colors, dark))
            places, angles, scales, colors = sketch.grid(scene)
            self._add("grid", "bar", len(places), colors, places, angles, scales)
            n, springs, joints = len(scene.masses), len(scene.linear_springs), len(scene.angular_springs)
            if springs:
                self._add("springs", sketch.spring_shape, springs)
            if joints:
                self._add("wedges", "slice", joints * sketch.slices)
            if len(sketch.pinned):
                size = 2.0 * sketch.radius[sketch.pinned]
                held = np.tile(sent_one(sketch.palette.held), (len(size), 1)).astype(np.uint8)
                self._add("pins", "pin", len(size), held, scales=size)
            if sketch.driven is not None:
                size = 1.75 * sketch.radius[[sketch.driven]]
                drive = np.array([sent_one(sketch.palette.driven)], np.uint8)
                self._add("ring", "ring", 1, drive, scales=size)
            masses = self._add("masses", "disc", 3 * n, sketch.mass_colors(), scales=sketch.mass_scales())
            self._listen(masses, n)

    def show_gizmos(self, on: bool) -> None:
        """Put up a gizmo at each held mass, or take them away."""
        if on != bool(self._gizmos) and self.sketch is not None:
            with self._client.atomic():
                self._remove_gizmos()
                if on:
                    self._add_gizmos(self.sketch)
            self._drawn = None  # so that the next picture puts them in place

    def draw(self, picture: Picture, force: bool = False) -> bool:
        """Send what changed since the last picture, and return whether anything did.

        Args:
            force: send even the smallest movement, so that a paused picture is exact.
        """
        sketch = self.sketch
        if sketch is None or (not force and self._is_still(picture)):
            return False
        self._drawn = picture
        with self._client.atomic():
            positions = picture.positions
            if "springs" in self._nodes:
                self._put("springs", *sketch.spring_arrays(positions, picture.rest_length_scale))
            if "wedges" in self._nodes:
                self._put("wedges", *sketch.wedge_arrays(positions, picture.deviations))
            if "pins" in self._nodes:
                self._put("pins", sketch.pins(positions))
            if sketch.driven is not None:
                self._put("ring", sketch.mapping.to_world(positions[[sketch.driven]], Z_RING))
            self._put("masses", sketch.masses(positions))
            self._draw_ghost(sketch, picture.ghost)
            for mass, gizmo in self._gizmos:
                # While a gizmo is dragged it belongs to the pointer.
                if mass != self._gizmo_in_hand:
                    place = sketch.mapping.to_world(positions[[mass]], Z_GIZMO)[0]
                    if not np.array_equal(place, gizmo.position):
                        gizmo.position = place
        return True

    # --------------------------------------------------------------------- inside
    def _draw_ghost(self, sketch: Sketch, positions: Floats | None) -> None:
        """A second body is there only while it is compared with."""
        if positions is None or not len(sketch.springs):
            node = self._nodes.pop("ghost", None)
            if node is not None:
                node.remove()
                for key in [key for key in self._sent if key[0] == "ghost"]:
                    del self._sent[key]
            return
        if "ghost" not in self._nodes:
            count = len(sketch.springs)
            color = np.tile(sent_one(sketch.palette.driven), (count, 1)).astype(np.uint8)
            self._add("ghost", "bar", count, color)
        self._put("ghost", *sketch.ghost_arrays(positions))

    def _is_still(self, picture: Picture) -> bool:
        drawn, sketch = self._drawn, self.sketch
        if drawn is None or sketch is None or drawn.positions.shape != picture.positions.shape:
            return False
        if (drawn.ghost is None) != (picture.ghost is None):
            return False
        pixel = 1.0 / (100.0 * sketch.mapping.scale)  # the frame is 6 units, or 600 pixels, long
        moved = np.abs(picture.positions - drawn.positions).max(initial=0.0)
        if drawn.ghost is not None and picture.ghost is not None:
            moved = max(moved, np.abs(picture.ghost - drawn.ghost).max(initial=0.0))
        turned = np.abs(picture.deviations - drawn.deviations).max(initial=0.0)
        grown = abs(picture.rest_length_scale / drawn.rest_length_scale - 1.0)
        return bool(moved < STILL * pixel and turned < 0.5 and grown < 1e-3)

    def _clear(self) -> None:
        for node in self._nodes.values():
            node.remove()
        self._nodes.clear()
        self._sent.clear()
        self._remove_gizmos()
        self._drawn = None

    def _remove_gizmos(self) -> None:
        for _, gizmo in self._gizmos:
            gizmo.remove()
        self._gizmos.clear()
        self._gizmo_in_hand = None

    def _add(
        self,
        name: str,
        shape: str,
        count: int,
        colors: NDArray[np.uint8] | None = None,
        places: Floats | None = None,
        angles: Floats | None = None,
        scales: Floats | None = None,
    ) -> viser.BatchedMeshHandle:
        if angles is None:
            angles = np.tile((1.0, 0.0, 0.0, 0.0), (count, 1))
        mesh = meshes()[shape]
        node = self._client.scene.add_batched_meshes_simple(
            f"/body/{name}",
            mesh.vertices,
            mesh.faces,
            batched_wxyzs=angles,
            batched_positions=np.zeros((count, 3)) if places is None else places,
            batched_scales=np.full((count, 3), 1e-6) if scales is None else scales,
            batched_colors=np.zeros((count, 3), np.uint8) if colors is None else colors,
            side="double",
            **_FLAT,
        )
        self._nodes[name] = node
        return node

    def _put(
        self,
        name: str,
        positions: Floats,
        wxyzs: Floats | None = None,
        scales: Floats | None = None,
        colors: NDArray[np.uint8] | None = None,
    ) -> None:
        for prop, value in (
            ("batched_positions", positions),
            ("batched_wxyzs", wxyzs),
            ("batched_scales", scales),
            ("batched_colors", colors),
        ):
            if value is None:
                continue
            value = value if value.dtype == np.uint8 else value.astype(np.float32)
            before = self._sent.get((name, prop))
            if before is None or not np.array_equal(before, value):
                self._sent[name, prop] = value
                setattr(self._nodes[name], prop, value)

    def _listen(self, masses: viser.BatchedMeshHandle, n: int) -> None:
        @masses.on_drag
        async def _(event: viser.SceneNodeDragEvent) -> None:
            if event.instance_index is not None and self.sketch is not None:
                # The drag plane is the front of the disc; only x and y count.
                x, y = self.sketch.mapping.to_scene(*event.end_position[:2])
                self._on_touch(Touch(event.phase, event.instance_index % n, x, y, by_gizmo=False))

        @masses.on_click
        async def _(event: viser.SceneNodePointerEvent) -> None:
            if event.instance_index is not None:
                self._on_click(event.instance_index % n)

    def _add_gizmos(self, sketch: Sketch) -> None:
        for mass in sketch.held[:MAX_GIZMOS].tolist():
            gizmo = self._client.scene.add_transform_controls(
                f"/gizmos/{mass}",
                scale=64.0,
                line_width=2.0,
                fixed=True,  # the same size on the screen at any zoom
                active_axes=(True, True, False),
                disable_rotations=True,
                opacity=0.75,
            )
            self._gizmos.append((mass, gizmo))
            self._listen_to_gizmo(mass, gizmo)

    def _listen_to_gizmo(self, mass: int, gizmo: viser.TransformControlsHandle) -> None:
        @gizmo.on_update
        async def _(event: viser.TransformControlsEvent) -> None:
            if event.client_id is None or self.sketch is None:
                return  # our own write
            self._gizmo_in_hand = None if event.phase == "end" else mass
            x, y = self.sketch.mapping.to_scene(*(float(c) for c in event.target.position[:2]))
            self._on_touch(Touch(event.phase, mass, x, y, by_gizmo=True))
