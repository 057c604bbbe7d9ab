"""What the drawing of a scene needs besides where its masses are: pure numpy, no viser.

Every kind of thing is one instanced node: all masses, all springs, all wedges, all pins. The page's script
makes their instances from the positions.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import msgspec
import numpy as np
from numpy.typing import NDArray

from sim import Scene
from sim.body.surroundings import new_surroundings
from sim.scene.types import is_surrounded

from .colors import Palette, Rgb, sent
from .shapes import COILS

Floats = NDArray[np.float64]

MANY = 40
"""From so many masses on, springs are bars instead of coils and wedges have one slice: as legible, and less
to send."""

WEDGE_SLICES = 6

WORLD_SIZE = 6.0
"""What the longer side of the scene's frame measures in the page's world."""

Z_GRID, Z_GIZMO = -0.4, -0.3
"""Depths in the world: the page draws what is nearer later. The body lies in front of both (static/draw.js).
A press on a mass takes hold of the mass, not of a gizmo's arrow across it."""


@dataclass(frozen=True)
class Mapping:
    """The scene's coordinates (px) to the page's world and back."""

    center: tuple[float, float]
    scale: float
    flip: float  # -1 where y grows downwards

    @staticmethod
    def of(scene: Scene) -> Mapping:
        """The frame's middle is the world's origin."""
        xmin, ymin, xmax, ymax = scene.view.frame
        scale = WORLD_SIZE / max(xmax - xmin, ymax - ymin)
        return Mapping(((xmin + xmax) / 2.0, (ymin + ymax) / 2.0), scale, -1.0 if scene.view.y_down else 1.0)

    def to_world(self, points: Floats, z: float = 0.0) -> Floats:
        """(n, 3) of (n, 2)."""
        return np.column_stack(
            (
                (points[:, 0] - self.center[0]) * self.scale,
                (points[:, 1] - self.center[1]) * (self.scale * self.flip),
                np.full(len(points), z),
            )
        )

    def to_scene(self, x: float, y: float) -> tuple[float, float]:
        """A point of the world in px."""
        return self.center[0] + x / self.scale, self.center[1] + y / (self.scale * self.flip)


class Sketch:
    """Everything about a scene's drawing that does not move.

    Args:
        scene: what is drawn.
        palette: the colours.
        encode: makes bytes of colours: `colors.sent` for viser's page, `colors.plain` for a picture.

    Attributes:
        mapping: px to world.
        palette, encode: as above.
        radius: (n,) of each mass in the world.
        around: the table of what surrounds the body, its masses by their index; None where nothing does.
    """

    def __init__(
        self, scene: Scene, palette: Palette, encode: Callable[[Rgb], NDArray[np.uint8]] = sent
    ) -> None:
        self.mapping = mapping = Mapping.of(scene)
        self.palette = palette
        self.encode = encode
        n = len(scene.masses)
        self.many = n > MANY
        self.springs = np.array([(s.a, s.b) for s in scene.linear_springs], np.int64).reshape(-1, 2)
        self.rest_length = np.array([s.rest_length for s in scene.linear_springs])
        self.radius = np.array([m.radius for m in scene.masses]) * mapping.scale
        self.held = np.array([a.mass for a in scene.anchors], np.int64)
        self.driven = next((a.mass for a in scene.anchors if a.driven), None)
        self.slices = 1 if self.many else WEDGE_SLICES
        joints = np.array([(j.a, j.b) for j in scene.angular_springs], np.int64).reshape(-1, 2)
        self.joint_a, self.joint_b = joints[:, 0], joints[:, 1]
        # The mass at the tip of each wedge is the one that both springs share, and the wedge ends at spring b
        # as it leaves that mass.
        ends_a, ends_b = self.springs[self.joint_a], self.springs[self.joint_b]
        leaves = (ends_b[:, :1] == ends_a).any(1)
        self.joint_mass = np.where(leaves, ends_b[:, 0], ends_b[:, 1])
        self.joint_sense = np.where(leaves, 1.0, -1.0)
        self.around = None
        if is_surrounded(scene):
            # Contact is not drawn.
            drawn = msgspec.structs.replace(scene, contact=None)
            self.around = new_surroundings(drawn, np.arange(n), self.springs, n)
        self.thickness = self._spring_thickness()
        self.spring_shape = self._spring_shape()

    def _spring_thickness(self) -> Floats:
        """(S,) amplitude of each coil, or width of each bar, in the world."""
        if not len(self.springs):
            return np.zeros(0)
        smaller = self.radius[self.springs].min(1)
        if self.many:
            return 0.55 * smaller
        return np.minimum(0.95 * smaller, 0.32 * np.maximum(self.rest_length * self.mapping.scale, 1e-3))

    def _spring_shape(self) -> str:
        """The mesh that suits most of the springs: a bar, or the coil nearest to their slimness."""
        if self.many or not len(self.springs):
            return "bar"
        slimness = float(np.median(np.maximum(self.rest_length * self.mapping.scale, 1e-9) / self.thickness))
        return min(COILS, key=lambda name: abs(np.log(COILS[name] / slimness)))

    def mass_colors(self) -> NDArray[np.uint8]:
        """(3n, 3) colours of the discs."""
        n = len(self.radius)
        fill = np.tile(self.palette.mass, (n, 1))
        fill[self.held] = self.palette.held
        if self.driven is not None:
            fill[self.driven] = self.palette.mass
        shine = fill + (255.0 - fill) * 0.55
        return self.encode(np.vstack((np.tile(self.palette.ink, (n, 1)), fill, shine)))

    def ink_colors(self) -> NDArray[np.uint8]:
        """(3, 3) colours of the supports, the ring and the ghost."""
        return self.encode(np.vstack((self.palette.held, self.palette.driven, self.palette.driven)))

    @property
    def pinned(self) -> NDArray[np.int64]:
        """Held masses that are not driven."""
        return self.held[self.held != self.driven] if self.driven is not None else self.held

    # --------------------------------------------------------------------- paper
    def grid(self, scene: Scene) -> tuple[Floats, Floats, Floats, NDArray[np.uint8]]:
        """Thin bars far beyond the frame: positions (k, 3), turns (k, 4), scales (k, 3), colours (k, 3)."""
        xmin, ymin, xmax, ymax = scene.view.frame
        size = max(xmax - xmin, ymax - ymin)
        major = nice(size / 5.0)
        minor = major / 5.0
        steps = int(np.ceil(1.6 * size / minor / 5.0)) * 5
        cx, cy = (round(c / major) * major for c in self.mapping.center)
        offset = np.arange(-steps, steps + 1) * minor
        reach = steps * minor
        across = np.column_stack((np.full(len(offset), cx - reach), cy + offset))
        upward = np.column_stack((cx + offset, np.full(len(offset), cy - reach * self.mapping.flip)))
        is_major = np.arange(-steps, steps + 1) % 5 == 0
        places = self.mapping.to_world(np.vstack((across, upward)), Z_GRID)
        places[:, 2] += 0.01 * np.tile(is_major, 2)
        angles = np.repeat((0.0, np.pi / 2.0), len(offset))
        length = 2.0 * reach * self.mapping.scale
        width = np.where(np.tile(is_major, 2), 0.012, 0.010)
        scales = np.column_stack((np.full(len(places), length), width, np.ones(len(places))))
        colors = np.where(np.tile(is_major, 2)[:, None], self.palette.grid_major, self.palette.grid)
        return places, turns(angles), scales, self.encode(colors)


def turns(angles: Floats) -> Floats:
    """(n, 4) quaternions (w, x, y, z) of turns about z, in radians."""
    result = np.zeros((len(angles), 4))
    result[:, 0] = np.cos(angles / 2.0)
    result[:, 3] = np.sin(angles / 2.0)
    return result


def nice(value: float) -> float:
    """The next of 1, 2, 5, 10, 20, ... at or below a positive value."""
    power = 10.0 ** np.floor(np.log10(value))
    return float(power * max(step for step in (1.0, 2.0, 5.0) if step * power <= value * (1.0 + 1e-9)))
