"""What the drawing of a scene needs besides where its masses are: pure numpy, no viser.

Every kind of thing is one instanced node: all masses, all springs, all wedges, all pins. The page's script
makes their instances from the positions, and draws what is behind the body.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import msgspec
import numpy as np
from numpy.typing import NDArray

from sim import Scene
from sim.forces.environment import new_environment
from sim.scene.columns import column, ends, has_any
from sim.scene.types import is_loaded, is_surrounded

from .colors import Palette, Rgb, palette, plain, sent
from .shapes import COILS

Floats = NDArray[np.float64]

MANY = 40
"""Beyond so many masses, springs are thin bars instead of coils and wedges have one slice: as legible, and
less to send."""

NET = 1.25
"""Springs per mass beyond which a body is a net, as a girder or a cloth: its springs are bars, too, since
coils would run into each other."""

FULL_STRAIN, MIN_STRAIN = 0.1, 1e-6
"""Relative stretch at which a spring has its full colour, at most and at least."""

WEDGE_SLICES = 6

LONGEST_LOAD, SHORTEST_LOAD = 0.6, 0.3
"""Length of the arrow of the largest constant force, in the world; of any other at least, as a part of it."""

WORLD_SIZE = 6.0
"""What the longer side of the scene's frame measures in the page's world."""

Z_GIZMO = -0.3
"""Depth in the world: the page draws what is nearer later. The body lies in front (static/draw.js), so that a
press on a mass takes hold of the mass, not of a gizmo's arrow across it."""


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


def world_size(scene: Scene) -> tuple[float, float]:
    """Width and height of a scene's frame, in the page's world."""
    xmin, ymin, xmax, ymax = scene.view.frame
    size = Mapping.of(scene).scale
    return (xmax - xmin) * size, (ymax - ymin) * size


class Sketch:
    """Everything about a scene's drawing that does not move.

    Args:
        scene: what is drawn.
        palette: the colours.
        encode: makes bytes of colours: `colors.sent` for viser's page, `colors.plain` for a picture.

    Attributes:
        mapping: px to world.
        palette, encode: as above.
        full_strain: strain at which each spring has its full colour, (S,), or (1,) where none has a limit.
        bars: whether springs are bars instead of coils.
        yields: whether any spring can yield.
        radius: (n,) of each mass in the world.
        environment: the table of what surrounds the body, its masses by their index; None where nothing does.
        contact: px, the distance at which contact begins; 0 where there is none.
        medium, ground: whether the body is in a medium, and whether it lies on the ground.
        muscles: (k, 6) whether a muscle is a joint's, the index of its spring or joint, amplitude (of a
            joint's degrees), phase (degrees), whether its wave is a pulse, and waves in a beat.
        beat: frequency (Hz) and phase (degrees) of what they keep to.
        loads: (k, 3) of each constant force which mass it acts on, and its arrow in the world.
    """

    def __init__(
        self, scene: Scene, palette: Palette, encode: Callable[[Rgb], NDArray[np.uint8]] = sent
    ) -> None:
        self.mapping = mapping = Mapping.of(scene)
        self.palette = palette
        self.encode = encode
        n = len(scene.masses)
        self.many = n > MANY
        self.springs = np.stack(ends(scene.linear_springs), 1)
        self.bars = self.many or len(self.springs) > NET * n
        self.full_strain = _full_strains(scene)
        self.yields = has_any(scene.linear_springs, "yield_force")
        self.rest_length = column(scene.linear_springs, "rest_length")
        self.radius = column(scene.masses, "radius") * mapping.scale
        self.held = np.array([a.mass for a in scene.anchors], np.int64)
        self.driven = next((a.mass for a in scene.anchors if a.driven), None)
        self.slices = 1 if self.many else WEDGE_SLICES
        self.joint_a, self.joint_b = ends(scene.angular_springs)
        # The mass at the tip of each wedge is the one that both springs share, and the wedge ends at spring b
        # as it leaves that mass.
        ends_a, ends_b = self.springs[self.joint_a], self.springs[self.joint_b]
        leaves = (ends_b[:, :1] == ends_a).any(1)
        self.joint_mass = np.where(leaves, ends_b[:, 0], ends_b[:, 1])
        self.joint_sense = np.where(leaves, 1.0, -1.0)
        self.environment = None
        if is_surrounded(scene):
            # Of contact, nothing but its distance is drawn.
            drawn = msgspec.structs.replace(scene, contact=None)
            self.environment = new_environment(drawn, np.arange(n), self.springs, n)
        self.contact = scene.contact.distance if scene.contact else 0.0
        self.medium, self.ground = bool(scene.medium), bool(scene.ground)
        self.loads = _load_arrows(scene, mapping)
        self.muscles = _muscles(scene)
        self.beat = (scene.beat.frequency, scene.beat.phase) if scene.beat else (0.0, 0.0)
        self.thickness = self._spring_thickness()
        self.spring_shape = self._spring_shape()

    @staticmethod
    def plain(scene: Scene, dark: bool = False) -> Sketch:
        """The drawing for a file, whose colours nothing changes on their way."""
        return Sketch(scene, palette(scene.view.colors, dark), plain)

    def _spring_thickness(self) -> Floats:
        """(S,) amplitude of each coil, or width of each bar, in the world."""
        if not len(self.springs):
            return np.zeros(0)
        smaller = self.radius[self.springs].min(1)
        if self.bars:
            return (0.55 if self.many else 0.8) * smaller
        return np.minimum(0.95 * smaller, 0.32 * np.maximum(self.rest_length * self.mapping.scale, 1e-3))

    def _spring_shape(self) -> str:
        """The mesh that suits most of the springs: a bar, or the coil nearest to their slimness."""
        if self.bars or not len(self.springs):
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
        """(4, 3) colours of the supports, the ring, the ghost and the mark of springs that have yielded."""
        colors = self.palette
        return self.encode(np.vstack((colors.held, colors.brand, colors.brand, colors.ink)))

    @property
    def pinned(self) -> NDArray[np.int64]:
        """Held masses that are not driven."""
        return self.held[self.held != self.driven] if self.driven is not None else self.held


def _muscles(scene: Scene) -> Floats:
    """See `Sketch`; none where there is no beat, since they rest."""
    rows = [
        (
            joint,
            part,
            each.muscle.amplitude,
            each.muscle.phase,
            each.muscle.wave == "pulse",
            each.muscle.per_beat,
        )
        for joint, parts in enumerate((scene.linear_springs, scene.angular_springs))
        for part, each in enumerate(parts)
        if scene.beat and each.muscle
    ]
    return np.array(rows, float).reshape(-1, 6)


def _load_arrows(scene: Scene, mapping: Mapping) -> Floats:
    """See `Sketch`: as long as the forces are large, but none too short to be seen."""
    if not is_loaded(scene):
        return np.zeros((0, 3))
    loaded = [(i, *mass.force) for i, mass in enumerate(scene.masses) if mass.force and any(mass.force)]
    rows = np.array(loaded, float).reshape(-1, 3)
    sizes = np.hypot(rows[:, 1], rows[:, 2])
    lengths = LONGEST_LOAD * np.maximum(sizes / sizes.max(initial=0.0), SHORTEST_LOAD)
    rows[:, 1:] *= (lengths / sizes)[:, None] * (1.0, mapping.flip)
    return rows


def _full_strains(scene: Scene) -> Floats:
    """See `Sketch`: a spring that yields or breaks before FULL_STRAIN has its full colour there."""
    springs = scene.linear_springs
    strains = np.full(len(springs), FULL_STRAIN)
    force = np.fmin(column(springs, "strength"), column(springs, "yield_force"))  # NaN where there is neither
    stiffness = column(springs, "stiffness") * column(springs, "rest_length")
    early = force < FULL_STRAIN * stiffness
    strains[early] = force[early] / stiffness[early]
    return np.maximum(strains, MIN_STRAIN) if (strains < FULL_STRAIN).any() else np.array([FULL_STRAIN])
