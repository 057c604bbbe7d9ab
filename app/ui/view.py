"""The picture of one page: the viser nodes of its scene, and the messages that fill them.

The nodes are empty: the page's script fills them from the plan of the body and the positions of its masses
(canvas.js).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import viser

from sim import Scene

from ..session import commands
from ..session.hand import GIZMO
from ..session.session import Session
from ..stage.colors import palette
from ..stage.pictures import Pictures
from ..stage.plan import Picture
from ..stage.shapes import meshes
from ..stage.sketch import Z_GIZMO, Floats, Sketch
from ..stage.together import side_by_side
from ..wire.carrier import Mail

MAX_GIZMOS = 12
"""Gizmos of one page, each a node of its own; further held masses are dragged directly."""

# Ambient light only and no shadows: every mesh shows its own colour, and software rendering is twice as fast.
_FLAT: dict[str, Any] = {"material": "toon3", "lod": "off", "cast_shadow": False, "receive_shadow": False}


_BODY = "/body/"
"""Prefix of the names of the body's nodes."""

_SECOND = "/second/"
"""Prefix of the names of a second body's nodes."""

_BEHIND = -0.3
"""Depth of a second body, behind the first."""


def kinds_of(sketch: Sketch) -> dict[str, str]:
    """The meshes of the nodes of a body, by the names of the nodes."""
    kinds = {
        "halos": "disc" if sketch.muscles[:, 0].any() else "",
        "muscles": "" if sketch.muscles[:, 0].all() else "belly",
        "springs": sketch.spring_shape if len(sketch.springs) else "",
        "ropes": "bar" if len(sketch.ropes) else "",
        "yielded": "bar" if sketch.yields else "",
        "wedges": "slice" if len(sketch.joint_a) else "",
        "pins": "pin" if len(sketch.pinned) else "",
        "ring": "ring" if sketch.driven is not None else "",
        "masses": "disc",
    }
    return {name: mesh for name, mesh in kinds.items() if mesh}


class Canvas:
    """The nodes of one page.

    Args:
        client: the page.
        mail: sends messages to its script.
        post: posts commands while a gizmo is dragged, on viser's event loop; it must not block.
    """

    def __init__(
        self, client: viser.ClientHandle, mail: Mail, post: Callable[[commands.Command], None]
    ) -> None:
        self._client, self._mail = client, mail
        self._post = post
        self._nodes: dict[str, Any] = {}
        self._gizmos: list[tuple[int, viser.TransformControlsHandle]] = []
        self._built: tuple[Any, ...] = ()
        self._second_built: tuple[Any, ...] = ()
        self._gizmo_in_hand: int | None = None
        self.pictures = Pictures(mail)

    @property
    def nodes(self) -> tuple[str, ...]:
        """The names of all nodes, including gizmos."""
        return (*self._nodes, *(gizmo.name for _, gizmo in self._gizmos))

    def build(
        self, scene: Scene, dark: bool, rest_angles: Floats | None = None, number: int | None = None
    ) -> None:
        """Create the nodes of a scene and send its plan, as far as they have changed; then call `draw`.

        Args:
            scene: the scene.
            dark: the page is dark.
            rest_angles: (J,) degrees without the arrow keys' shift; None for the scene's own.
            number: number of a plan that other pages have too; None to count its own.
        """
        sketch = Sketch(scene, palette(scene.view.colors, dark))
        kinds = kinds_of(sketch)
        shape = (scene.view, kinds, *sketch.held.tolist())
        with self._client.atomic():
            if shape != self._built:
                self._clear()
                self._built = shape
                for name, mesh in kinds.items():
                    self._add_empty(f"{_BODY}{name}", mesh)
            self.pictures.build(scene, dark, rest_angles, number)

    def build_second(self, second: Scene | None, dark: bool) -> None:
        """Create the nodes of a second body behind the first, or remove them.

        Call it after `build`: both have the same view.
        """
        with self._client.atomic():
            sketch = self.pictures.build_second(second, dark)
            kinds = {} if sketch is None else kinds_of(sketch)
            if tuple(kinds.items()) != self._second_built:
                self._remove(_SECOND)
                self._second_built = tuple(kinds.items())
                self.pictures.forget()
                for name, mesh in kinds.items():
                    self._add_empty(f"{_SECOND}{name}", mesh, _BEHIND)

    def show_gizmos(self, on: bool) -> None:
        """Add a gizmo at each held mass, or remove them."""
        sketch = self.pictures.sketch
        if on != bool(self._gizmos) and sketch is not None:
            with self._client.atomic():
                self._remove_gizmos()
                if on:
                    self._add_gizmos(sketch)
            self.pictures.forget()  # has the next picture place them

    def draw(self, picture: Picture, now: float, exactly: bool = False) -> bool:
        """Send a picture if it differs from the last one, and return True if it does.

        Args:
            picture: a picture of the scene that was built last.
            now: wall time, s.
            exactly: send even the smallest movement, so that a paused picture is exact.
        """
        sketch = self.pictures.sketch
        if sketch is None or self.pictures.is_drawn(picture, exactly=exactly):
            return False
        with self._client.atomic():
            self._show_ghost(picture.ghost is not None)
            self.pictures.send(picture, now, exactly=exactly)
            for mass, gizmo in self._gizmos:
                # While a gizmo is dragged it belongs to the pointer.
                if mass != self._gizmo_in_hand:
                    position = sketch.mapping.to_world(picture.positions[[mass]], Z_GIZMO)[0]
                    if not np.array_equal(position, gizmo.position):
                        gizmo.position = position
        return True

    # --------------------------------------------------------------------- inside
    def _show_ghost(self, wanted: bool) -> None:
        """Add or remove the node of the ghost."""
        if wanted and f"{_BODY}ghost" not in self._nodes:
            self._add_empty(f"{_BODY}ghost", "bar")
        elif not wanted and f"{_BODY}ghost" in self._nodes:
            self._nodes.pop(f"{_BODY}ghost").remove()

    def _clear(self) -> None:
        self._remove(_BODY)
        self._remove_gizmos()
        self.pictures.forget()

    def _remove(self, place: str) -> None:
        """Remove the nodes of one body."""
        for name in [name for name in self._nodes if name.startswith(place)]:
            self._nodes.pop(name).remove()

    def _remove_gizmos(self) -> None:
        for _, gizmo in self._gizmos:
            gizmo.remove()
        self._gizmos.clear()
        self._gizmo_in_hand = None

    def _add_empty(self, name: str, mesh: str, depth: float = 0.0) -> None:
        """Add a node for the page's script to fill."""
        shape = meshes()[mesh]
        self._nodes[name] = self._client.scene.add_batched_meshes_simple(
            name,
            shape.vertices,
            shape.faces,
            batched_wxyzs=np.array([[1.0, 0.0, 0.0, 0.0]]),
            batched_positions=np.zeros((1, 3)),
            batched_scales=np.full((1, 3), 1e-6),
            batched_colors=np.zeros((1, 3), np.uint8),
            position=(0.0, 0.0, depth),
            side="double",
            **_FLAT,
        )

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
            sketch = self.pictures.sketch
            if event.client_id is None or sketch is None:
                return  # set by the server
            self._gizmo_in_hand = None if event.phase == "end" else mass
            x, y = sketch.mapping.to_scene(*(float(c) for c in event.target.position[:2]))
            if event.phase == "start":
                self._post(commands.DragStart(mass, x, y, GIZMO))
            elif event.phase == "update":
                self._post(commands.Point(x, y, GIZMO, late=True))
            else:
                self._post(commands.DragEnd(GIZMO))


_SWAY = 0.12
"""Largest movement that shows how a body leaves a shape, in the body's size."""


def picture_of(session: Session) -> Picture:
    """The picture of a session: the body and, pale, its ghost.

    Without a ghost, the pale body is where the body will rest while a slider moves, what happened before the
    user went back, or how the body leaves a shape that it cannot hold.
    """
    simulation, ghost, future = session.simulation, session.ghost, session.abandoned_future
    other = damage = None
    rest = session.rest_pose_preview.positions(len(simulation.scene.masses), session.now())
    if ghost is not None:
        if not ghost.is_compiling:
            other, damage = ghost.simulation.positions, ghost.simulation.damage
    elif rest is not None:
        other, damage = rest, simulation.damage
    elif future is not None:
        other, damage = future.positions_at(simulation.time), future.damage_at(simulation.time)
    elif session.refusal is not None and session.refusal.motion is not None:
        # In the past the body may have another number of masses.
        shape = session.refused_shape
        if len(shape) == len(simulation.scene.masses):
            other = shape + _SWAY * float(np.ptp(shape, axis=0).max(initial=0.0)) * session.refusal.motion
    picture = Picture.of(simulation, other, damage)
    others = session.companions.drawn
    if not others:
        return picture
    second = side_by_side([other.scene for other in others], [Picture.of(other) for other in others])
    return replace(picture, second=second)
