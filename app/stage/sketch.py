"""The drawing of a scene apart from the positions of its masses: pure numpy, no viser.

All parts of a kind are one instanced node: masses, springs, wedges, pins. The page's script makes the
instances from the positions, and draws what is behind the body."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import msgspec
import numpy as np
from numpy.typing import NDArray

from sim import Scene
from sim.forces.environment import is_surrounded, new_environment
from sim.forces.motors import has_motors
from sim.forces.muscles import steer_of
from sim.forces.one_sided import SIDES
from sim.forces.rails import has_rails
from sim.scene.columns import column, ends, has_any
from sim.scene.types import is_loaded, is_pushed

from .colors import Palette, Rgb, palette, plain, sent
from .shapes import COILS

Floats = NDArray[np.float64]

SIMPLIFY_ABOVE_MASSES = 40
"""Number of masses beyond which springs are thin bars instead of coils and wedges have one slice: as legible,
and less to send."""

NET_SPRINGS_PER_MASS = 1.25
"""Springs per mass beyond which a body is a net, such as a girder or a cloth: its springs are bars, too,
since coils would overlap."""

FULL_STRAIN = 0.1
"""Relative stretch at which a spring has its full colour, unless it yields or breaks before."""

MIN_STRAIN = 1e-6
"""Least such stretch, against division by zero."""

WEDGE_SLICES = 6
"""Triangles of a wedge."""

LONGEST_LOAD = 0.6
"""Length of the arrow of the largest constant force, in the world."""

SHORTEST_LOAD = 0.3
"""Least length of the others, as a part of that."""

WORLD_SIZE = 6.0
"""Length of the longer side of the scene's frame in the page's world."""

Z_GIZMO = -0.3
"""Depth of gizmos in the world, behind the body (draw.js), so that a press on a mass grabs the mass, not the
arrow of a gizmo across it."""


@dataclass(frozen=True)
class Mapping:
    """Converts between coordinates of the scene (px) and of the page's world."""

    center: tuple[float, float]
    scale: float
    flip: float  # -1 where y grows downwards

    @staticmethod
    def of(scene: Scene) -> Mapping:
        """The mapping of a scene; the centre of its frame is the origin of the world."""
        xmin, ymin, xmax, ymax = scene.view.frame
        scale = WORLD_SIZE / max(xmax - xmin, ymax - ymin)
        return Mapping(((xmin + xmax) / 2.0, (ymin + ymax) / 2.0), scale, -1.0 if scene.view.y_down else 1.0)

    def to_world(self, points: Floats, z: float = 0.0) -> Floats:
        """(n, 3) places in the world of (n, 2) points in px."""
        return np.column_stack(
            (
                (points[:, 0] - self.center[0]) * self.scale,
                (points[:, 1] - self.center[1]) * (self.scale * self.flip),
                np.full(len(points), z),
            )
        )

    def box(self, bounds: Floats) -> tuple[float, float, float, float]:
        """Left, right, low and high end, in the world, of a box in px, (2, 2): its least x and y, and its
        largest."""
        (left, low, _), (right, high, _) = self.to_world(bounds).tolist()
        return left, right, min(low, high), max(low, high)

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
        scene: the scene.
        palette: the colours.
        encode: converts colours to bytes: `colors.sent` for viser's page, `colors.plain` for a picture.

    Attributes:
        mapping: px to world.
        palette, encode: as above.
        full_strain: strain at which each spring has its full colour, (S,), or (1,) if all have the same.
        bars: springs are bars instead of coils.
        yields: a spring can yield.
        radius: (n,) of each mass in the world.
        environment: the surroundings of the body, with indices of masses; None without any.
        contact: px, the distance at which contact begins; 0 without contact.
        medium, ground: the body is in a medium; it lies on the ground.
        muscles: (k, 7) for each muscle: 1 for a joint, 0 for a spring; index of that; amplitude (degrees for
            a joint); phase (degrees); 0 for a sine, 1 for a pulse, 2 for a steady one; waves in a beat; and
            which keys work it: 0 Left and Right, 1 Up and Down, -1 none.
        beat: frequency (Hz) and phase (degrees) of the beat.
        rails: (k, 4) for each mass on a rail: where it starts, px, and a unit vector across the rail.
        ropes, buffers: indices of the springs that only pull, and only push.
        stops: (k, 2) for each joint that acts on one side: its index, and 1 above or -1 below the rest angle.
        loads: (k, 3) for each constant force: index of the mass, and the arrow in the world.
        pushes: (k, 4) the same of each force that keys work, and which keys.
        motors: (k, 3) for each motor: index of the joint, the sign of its speed, and which keys, or -1.
    """

    def __init__(
        self, scene: Scene, palette: Palette, encode: Callable[[Rgb], NDArray[np.uint8]] = sent
    ) -> None:
        self.mapping = mapping = Mapping.of(scene)
        self.palette = palette
        self.encode = encode
        n = len(scene.masses)
        self.many = n > SIMPLIFY_ABOVE_MASSES
        self.springs = np.stack(ends(scene.linear_springs), 1)
        self.bars = self.many or len(self.springs) > NET_SPRINGS_PER_MASS * n
        self.full_strain = _full_strains(scene)
        self.yields = has_any(scene.linear_springs, "yield_force")
        self.rest_length = column(scene.linear_springs, "rest_length")
        self.radius = column(scene.masses, "radius") * mapping.scale
        self.held = np.array([a.mass for a in scene.anchors], np.int64)
        self.driven = next((a.mass for a in scene.anchors if a.driven), None)
        self.slices = 1 if self.many else WEDGE_SLICES
        self.joint_a, self.joint_b = ends(scene.angular_springs)
        # The tip of each wedge is at the mass that both springs share, and the wedge ends at spring b.
        ends_a, ends_b = self.springs[self.joint_a], self.springs[self.joint_b]
        leaves = (ends_b[:, :1] == ends_a).any(1)
        self.joint_mass = np.where(leaves, ends_b[:, 0], ends_b[:, 1])
        self.joint_sense = np.where(leaves, 1.0, -1.0)
        self.environment = None
        if is_surrounded(scene):
            # Of contact, only the distance is drawn.
            drawn = msgspec.structs.replace(scene, contact=None)
            self.environment = new_environment(
                drawn,
                np.arange(n),
                self.springs,
                n,
                np.arange(len(self.springs)),
                np.arange(len(self.joint_a)),
            )
        self.contact = scene.contact.distance if scene.contact else 0.0
        self.medium, self.ground = bool(scene.medium), bool(scene.ground)
        self.loads, self.pushes = _load_arrows(scene, mapping)
        self.motors = _motors(scene)
        self.ropes, self.buffers = (
            np.array([s for s, spring in enumerate(scene.linear_springs) if spring.only == side], np.int64)
            for side in ("pull", "push")
        )
        self.rails = _rails(scene)
        self.stops = np.array(
            [(j, SIDES[joint.only]) for j, joint in enumerate(scene.angular_springs) if joint.only], np.int64
        ).reshape(-1, 2)
        self.muscles = _muscles(scene)
        self.beat = (scene.beat.frequency, scene.beat.phase) if scene.beat else (0.0, 0.0)
        self.thickness = self._spring_thickness()
        self.spring_shape = self._spring_shape()

    @staticmethod
    def plain(scene: Scene, dark: bool = False) -> Sketch:
        """The drawing for a file, without a tone map."""
        return Sketch(scene, palette(scene.view.colors, dark), plain)

    def _spring_thickness(self) -> Floats:
        """(S,) amplitudes of coils, or widths of bars, in the world."""
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


def _rails(scene: Scene) -> Floats:
    """See `Sketch`."""
    if not has_rails(scene):
        return np.zeros((0, 4))
    starts = scene.pose.positions if scene.pose else [mass.position for mass in scene.masses]
    rows = []
    for (x, y), mass in zip(starts, scene.masses, strict=True):
        if mass.rail:
            along = np.array(mass.rail) / np.hypot(*mass.rail)
            rows.append((x, y, -along[1], along[0]))
    return np.array(rows)


def _muscles(scene: Scene) -> Floats:
    """See `Sketch`; none without a beat, since they are then at rest."""
    rows = [
        (
            joint,
            part,
            each.muscle.amplitude,
            each.muscle.phase,
            ("sine", "pulse", "steady").index(each.muscle.wave),
            each.muscle.per_beat,
            steer_of(each.muscle.keys),
        )
        for joint, parts in enumerate((scene.linear_springs, scene.angular_springs))
        for part, each in enumerate(parts)
        if scene.beat and each.muscle
    ]
    return np.array(rows, float).reshape(-1, 7)


def _motors(scene: Scene) -> Floats:
    """See `Sketch`."""
    if not has_motors(scene):
        return np.zeros((0, 3))
    rows = [
        (j, np.sign(motor.speed), steer_of(motor.keys))
        for j, joint in enumerate(scene.angular_springs)
        if (motor := joint.motor)
    ]
    return np.array(rows, float)


def _load_arrows(scene: Scene, mapping: Mapping) -> tuple[Floats, Floats]:
    """See `Sketch.loads` and `pushes`: lengths in proportion to the forces, but none too short to be seen."""
    if not is_loaded(scene) and not is_pushed(scene):
        return np.zeros((0, 3)), np.zeros((0, 4))
    loaded = [
        (i, *mass.force, steer_of(mass.keys))
        for i, mass in enumerate(scene.masses)
        if mass.force and any(mass.force)
    ]
    rows = np.array(loaded, float).reshape(-1, 4)
    sizes = np.hypot(rows[:, 1], rows[:, 2])
    lengths = LONGEST_LOAD * np.maximum(sizes / sizes.max(initial=0.0), SHORTEST_LOAD)
    rows[:, 1:3] *= (lengths / sizes)[:, None] * (1.0, mapping.flip)
    pushed = rows[:, 3] >= 0.0
    return rows[~pushed, :3], rows[pushed]


def _full_strains(scene: Scene) -> Floats:
    """See `Sketch`: a spring that yields or breaks before FULL_STRAIN has its full colour there."""
    springs = scene.linear_springs
    strains = np.full(len(springs), FULL_STRAIN)
    force = np.fmin(column(springs, "strength"), column(springs, "yield_force"))  # NaN where there is neither
    stiffness = column(springs, "stiffness") * column(springs, "rest_length")
    early = force < FULL_STRAIN * stiffness
    strains[early] = force[early] / stiffness[early]
    return np.maximum(strains, MIN_STRAIN) if (strains < FULL_STRAIN).any() else np.array([FULL_STRAIN])
