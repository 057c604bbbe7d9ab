"""The picture of one page: the viser nodes of its scene, and the messages that fill them.

The nodes are empty: the page's script fills them from the plan of the body and the positions of its masses
(canvas.js). A frame in which nothing moved by a tenth of a pixel is not sent.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import msgspec
import numpy as np
import viser
from numpy.typing import NDArray

from sim import Scene
from sim.scene.types import Damage as BodyDamage

from ..session import commands
from ..session.hand import GIZMO
from ..session.session import Session
from ..stage.colors import blend, palette
from ..stage.plan import Picture, broken_of, encode_damage, encode_frame, encode_plan
from ..stage.shapes import meshes
from ..stage.sketch import Z_GIZMO, Floats, Sketch
from ..stage.together import side_by_side
from ..wire.carrier import Mail
from ..wire.to_page import Damage, Frame, Plan, SecondPlan

STILL = 0.1
"""Movement below which a picture counts as unchanged, in pixels of a frame 600 pixels high."""

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
        self._second_plan: NDArray[np.float32] | None = None
        self._plan: NDArray[np.float32] | None = None
        self._plan_number = self._own_number = 0
        self._drawn: Picture | None = None
        self._damaged: Picture | None = None  # the picture whose damage was sent last
        self._gizmo_in_hand: int | None = None
        self.sketch: Sketch | None = None

    @property
    def plan_number(self) -> int:
        """The number of the plan that the page has."""
        return self._plan_number

    @property
    def nodes(self) -> tuple[str, ...]:
        """The names of all nodes, including gizmos."""
        return (*self._nodes, *(gizmo.name for _, gizmo in self._gizmos))

    @property
    def drawn(self) -> Floats | None:
        """(n, 2) positions of the masses in the page's world in the last picture; read-only."""
        picture, sketch = self._drawn, self.sketch
        if picture is None or sketch is None:
            return None
        places = sketch.mapping.to_world(picture.positions)[:, :2]
        places.setflags(write=False)
        return places

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
        self.sketch = sketch = Sketch(scene, palette(scene.view.colors, dark))
        kinds = kinds_of(sketch)
        shape = (scene.view, kinds, *sketch.held.tolist())
        self._view = scene.view
        if rest_angles is None:
            rest_angles = np.array([joint.rest_angle for joint in scene.angular_springs])
        with self._client.atomic():
            if shape != self._built:
                self._clear()
                self._built = shape
                for name, mesh in kinds.items():
                    self._add_empty(f"{_BODY}{name}", mesh)
            plan = encode_plan(0, sketch, rest_angles)
            known = self._plan is not None and np.array_equal(plan, self._plan)
            if not known or number not in (None, self._plan_number):
                self._plan = plan
                self._own_number += number is None
                self._plan_number = self._own_number if number is None else number
                self._mail.send(Plan(numbers=encode_plan(self._plan_number, sketch, rest_angles)))
                self._drawn = self._damaged = None

    def build_second(self, second: Scene | None, dark: bool) -> None:
        """Create the nodes of a second body behind the first, or remove them.

        Call it after `build`: both have the same view.
        """
        if second is None or self.sketch is None:
            if self._second_built:
                self._remove(_SECOND)
                self._second_built, self._second_plan, self._drawn = (), None, None
            return
        # Its surroundings are drawn with the first body; nobody drives it.
        still = tuple(msgspec.structs.replace(anchor, driven=False) for anchor in second.anchors)
        alone = msgspec.structs.replace(
            second, view=self._view, walls=(), wind=None, contact=None, anchors=still
        )
        colors = palette(second.view.colors, dark)
        rest = blend(colors.paper, colors.second, np.array([0.6]))[0]
        sketch = Sketch(alone, replace(colors, mass=colors.second, held=colors.second, rest=rest))
        kinds = kinds_of(sketch)
        angles = np.array([joint.rest_angle for joint in second.angular_springs])
        with self._client.atomic():
            if kinds != dict(self._second_built):
                self._remove(_SECOND)
                self._second_built, self._drawn = tuple(kinds.items()), None
                for name, mesh in kinds.items():
                    self._add_empty(f"{_SECOND}{name}", mesh, _BEHIND)
            plan = encode_plan(0, sketch, angles)
            if self._second_plan is None or not np.array_equal(plan, self._second_plan):
                self._second_plan, self._drawn = plan, None
                self._mail.send(SecondPlan(numbers=plan))

    def show_gizmos(self, on: bool) -> None:
        """Add a gizmo at each held mass, or remove them."""
        if on != bool(self._gizmos) and self.sketch is not None:
            with self._client.atomic():
                self._remove_gizmos()
                if on:
                    self._add_gizmos(self.sketch)
            self._drawn = None  # has the next picture place them

    def draw(self, picture: Picture, now: float, force: bool = False) -> bool:
        """Send a picture if it differs from the last one, and return True if it does.

        Args:
            picture: a picture of the scene that was built last.
            now: wall time, s.
            force: send even the smallest movement, so that a paused picture is exact.
        """
        sketch = self.sketch
        if sketch is None or self._is_drawn(picture, exactly=force):
            return False
        self._drawn = picture
        with self._client.atomic():
            self._show_ghost(picture.ghost is not None)
            if not self._same_damage(picture, exactly=force):
                self._damaged = picture
                self._mail.send(Damage(numbers=encode_damage(self._plan_number, picture)))
            self._mail.send(Frame(numbers=encode_frame(self._plan_number, picture), wall=round(now, 4)))
            for mass, gizmo in self._gizmos:
                # While a gizmo is dragged it belongs to the pointer.
                if mass != self._gizmo_in_hand:
                    position = sketch.mapping.to_world(picture.positions[[mass]], Z_GIZMO)[0]
                    if not np.array_equal(position, gizmo.position):
                        gizmo.position = position
        return True

    # --------------------------------------------------------------------- inside
    def _same_damage(self, picture: Picture, exactly: bool) -> bool:
        """Return True if the page has this damage, exactly or as far as it is visible."""
        known = self._damaged
        if (known.ghost_broken if known is not None else ()) != picture.ghost_broken:
            return False
        one, other = (known.damage, known.second) if known is not None else (None, None)
        theirs = picture.second.damage if picture.second is not None else None
        return self._near_damage(one, picture.damage, exactly) and self._near_damage(
            other.damage if other is not None else None, theirs, exactly
        )

    def _near_damage(self, known: BodyDamage | None, now: BodyDamage | None, exactly: bool) -> bool:
        if broken_of(known) != broken_of(now):
            return False
        if exactly or known is None or now is None:
            return known == now
        return _near(known.set_lengths, now.set_lengths, STILL * self._pixel) and _near(
            known.set_angles, now.set_angles, 0.5
        )

    def _show_ghost(self, wanted: bool) -> None:
        """Add or remove the node of the ghost."""
        if wanted and f"{_BODY}ghost" not in self._nodes:
            self._add_empty(f"{_BODY}ghost", "bar")
        elif not wanted and f"{_BODY}ghost" in self._nodes:
            self._nodes.pop(f"{_BODY}ghost").remove()

    def _is_drawn(self, picture: Picture, exactly: bool) -> bool:
        """Return True if the last picture is the same, exactly or as far as it is visible."""
        drawn, sketch = self._drawn, self.sketch
        if drawn is None or sketch is None or drawn.positions.shape != picture.positions.shape:
            return False
        if (drawn.ghost is None) != (picture.ghost is None) or not self._same_damage(picture, exactly):
            return False
        moved = np.abs(picture.positions - drawn.positions).max(initial=0.0)
        if drawn.second is not None and picture.second is not None:
            moved = max(moved, np.abs(picture.second.positions - drawn.second.positions).max(initial=0.0))
        elif drawn.second is not picture.second:
            return False
        if drawn.ghost is not None and picture.ghost is not None:
            moved = max(moved, np.abs(picture.ghost - drawn.ghost).max(initial=0.0))
        turned = abs(picture.rest_angle_shift - drawn.rest_angle_shift)
        grown = abs(picture.rest_length_scale / drawn.rest_length_scale - 1.0)
        if exactly:
            return picture.time == drawn.time and not (moved or turned or grown)
        return bool(moved < STILL * self._pixel and turned < 0.5 and grown < 1e-3)

    @property
    def _pixel(self) -> float:
        """A pixel of a frame 600 pixels long, in px of the scene."""
        return 1.0 / (100.0 * self.sketch.mapping.scale) if self.sketch is not None else 1.0

    def _clear(self) -> None:
        self._remove(_BODY)
        self._remove_gizmos()
        self._drawn = self._damaged = None

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
            if event.client_id is None or self.sketch is None:
                return  # set by the server
            self._gizmo_in_hand = None if event.phase == "end" else mass
            x, y = self.sketch.mapping.to_scene(*(float(c) for c in event.target.position[:2]))
            if event.phase == "start":
                self._post(commands.DragStart(mass, x, y, GIZMO))
            elif event.phase == "update":
                self._post(commands.Point(x, y, GIZMO, late=True))
            else:
                self._post(commands.DragEnd(GIZMO))


def _near(before: tuple[float, ...], now: tuple[float, ...], tolerance: float) -> bool:
    """Return True if numbers differ by no more than a tolerance; none at all count as zeros."""
    if before is now:
        return True
    size = max(len(before), len(now))
    one, two = (np.array(numbers or (0.0,) * size) for numbers in (before, now))
    return bool(np.abs(one - two).max(initial=0.0) <= tolerance)


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
