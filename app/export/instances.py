"""Where the parts of a body lie in a picture: as `app/stage/draw.js` has it in the page.

A test holds the two against each other.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..stage.looks import (
    BELLY,
    BREATH,
    CREASE,
    FILL,
    FULL_DEVIATION,
    GHOST_WIDTH,
    HALO,
    PIN,
    RING,
    ROPE,
    ROPE_PIECES,
    SHARPNESS,
    SHINE,
    THICKEST,
    THINNEST,
    WEDGE,
    WIDEST,
    YIELDED,
)
from ..stage.plan import Picture, broken_of, muscle_colors, strain_colors, turn_colors
from ..stage.sketch import Floats, Sketch


class Instances(NamedTuple):
    """Copies of one flat mesh in the page's world.

    Attributes:
        places: (k, 2) where the mesh's origin is.
        angles: (k,) radians, anticlockwise.
        lengths, widths: (k,) factors along and across.
        colors: (k, 3) sRGB.
    """

    places: Floats
    angles: Floats
    lengths: Floats
    widths: Floats
    colors: NDArray[np.uint8]

    def some(self, which: slice | NDArray[np.bool_]) -> Instances:
        """A part of the copies."""
        places, angles, lengths, widths, colors = self
        return Instances(places[which], angles[which], lengths[which], widths[which], colors[which])

    def only(self, which: NDArray[np.bool_]) -> Instances:
        """As many copies, of which the others have no size."""
        return self._replace(lengths=which * self.lengths, widths=which * self.widths)

    def seen(self) -> Instances:
        """The copies that have a size."""
        return self.some(self.lengths > 0.0)


def to_world(sketch: Sketch, positions: Floats) -> Floats:
    """(n, 2) in the page's world of (n, 2) px."""
    return sketch.mapping.to_world(positions)[:, :2]


def _rest_lengths(sketch: Sketch, picture: Picture) -> Floats:
    """(S,) the present rest lengths, in the world."""
    moved = picture.damage.set_lengths if picture.damage is not None else ()
    stretch, _ = _swings(sketch, picture)
    rest = sketch.rest_length * picture.rest_length_scale * stretch + (np.array(moved) if moved else 0.0)
    return np.maximum(rest * sketch.mapping.scale, 1e-9)


def springs(sketch: Sketch, picture: Picture, with_ropes: bool = False) -> Instances:
    """Coils or bars, without a size where a spring is broken or, unless they are wanted, a rope."""
    start, angles, lengths = _between(sketch, picture.positions)
    rest = _rest_lengths(sketch, picture)
    # A buffer that touches nothing is as long as it rests.
    lengths[sketch.buffers] = np.minimum(lengths, rest)[sketch.buffers]
    strain = (lengths / rest - 1.0) / sketch.full_strain
    widths = sketch.thickness
    if not sketch.bars:
        # A coil that is pulled far gets thinner, as a real one does, but never thicker than its masses.
        widths = widths * np.clip(np.sqrt(rest / np.maximum(lengths, 1e-12)), THINNEST, THICKEST)
    coils = Instances(start, angles, lengths, widths, _colored(strain_colors(sketch), strain))
    shown = _whole(len(lengths), broken_of(picture.damage))
    shown[sketch.ropes] &= with_ropes
    return coils.only(shown)


def ropes(sketch: Sketch, picture: Picture) -> Instances:
    """The pieces of springs that only pull: straight where taut, and hanging in a parabola where slack."""
    some = sketch.ropes
    start, angles, lengths = (each[some] for each in _between(sketch, picture.positions))
    rest = _rest_lengths(sketch, picture)[some]
    full = sketch.full_strain if len(sketch.full_strain) == 1 else sketch.full_strain[some]
    strain = np.maximum(0.0, (lengths / rest - 1.0) / full)
    sag = np.sqrt(np.maximum(0.0, (rest - lengths) * (2.0 * rest + lengths) / 8.0))
    part = np.arange(ROPE_PIECES + 1) / ROPE_PIECES
    along = (lengths * np.exp(1j * angles))[:, None] * part
    at = (start @ (1.0, 1j))[:, None] + along - 4j * sag[:, None] * part * (1.0 - part)
    piece = np.diff(at, axis=1).ravel()
    width = np.repeat(ROPE * sketch.thickness[some], ROPE_PIECES)
    first = at[:, :-1].ravel()
    colors = np.repeat(_colored(strain_colors(sketch), strain), ROPE_PIECES, axis=0)
    whole = np.repeat(_whole(len(sketch.springs), broken_of(picture.damage))[some], ROPE_PIECES)
    places = np.column_stack((first.real, first.imag))
    return Instances(places, np.angle(piece), np.abs(piece), width, colors).only(whole)


def muscles(sketch: Sketch, picture: Picture, of_joints: bool) -> Instances:
    """Bellies along springs, or halos around the masses of joints; without a size on what is broken."""
    rows = sketch.muscles[sketch.muscles[:, 0] == of_joints]
    part = rows[:, 1].astype(np.int64)
    whole = _whole(len(sketch.springs), broken_of(picture.damage))
    breath = (1.0 if of_joints else -1.0) * np.sign(rows[:, 2]) * _waves(sketch, rows, picture)
    if of_joints:
        tip = sketch.joint_mass[part]
        places, angles = to_world(sketch, picture.positions)[tip], np.zeros(len(part))
        lengths = widths = HALO * (1.0 + BREATH * breath) * sketch.radius[tip]
        moves = whole[sketch.joint_a[part]] & whole[sketch.joint_b[part]]
    else:
        places, angles, lengths = (each[part] for each in _between(sketch, picture.positions))
        widths = BELLY * (1.0 + BREATH * breath) * sketch.thickness[part] * (1.0 if sketch.bars else 2.0)
        moves = whole[part]
    return Instances(places, angles, lengths, widths, _colored(muscle_colors(sketch), breath)).only(moves)


def _swings(sketch: Sketch, picture: Picture) -> tuple[Floats, Floats]:
    """(S,) by which factor muscles stretch rest lengths, and (J,) degrees by which they turn rest angles."""
    rows = sketch.muscles
    swing, of_joints, part = (
        rows[:, 2] * _waves(sketch, rows, picture),
        rows[:, 0] == 1.0,
        rows[:, 1].astype(np.int64),
    )
    stretch, turn = np.ones(len(sketch.springs)), np.zeros(len(sketch.joint_a))
    stretch[part[~of_joints]] += swing[~of_joints]
    turn[part[of_joints]] = swing[of_joints]
    return stretch, turn


def _waves(sketch: Sketch, rows: Floats, picture: Picture) -> Floats:
    """(k,) the wave of each muscle; of one that keys work, with the effort of these."""
    frequency, phase = sketch.beat
    efforts = np.array((*(picture.efforts or (0.0, 0.0)), 1.0))[rows[:, 6].astype(np.int64)]
    beats = np.copysign(frequency * picture.time, efforts) + phase / 360.0
    size = np.sin(math.tau * (rows[:, 5] * beats + rows[:, 3] / 360.0))
    size = np.where(rows[:, 4] == 1.0, np.exp(SHARPNESS * (size - 1.0)), size)
    return np.where(rows[:, 4] == 2.0, efforts, np.abs(efforts) * size)


def yielded(sketch: Sketch, picture: Picture) -> Instances:
    """Bars along springs, which have a size where these have yielded and are not broken."""
    start, angles, lengths = _between(sketch, picture.positions)
    count = len(lengths)
    moved = picture.damage.set_lengths if picture.damage is not None else ()
    marked = np.abs(np.array(moved) if moved else np.zeros(count)) > YIELDED * sketch.rest_length
    marked &= _whole(count, broken_of(picture.damage))
    colors = np.tile(sketch.ink_colors()[3], (count, 1))
    return Instances(start, angles, lengths, CREASE * sketch.thickness, colors).only(marked)


def ghost(sketch: Sketch, picture: Picture) -> Instances:
    """Thin bars along the springs of a second body, which there must be; without a size on a broken one."""
    assert picture.ghost is not None
    start, angles, lengths = _between(sketch, picture.ghost)
    count = len(lengths)
    colors = np.tile(sketch.ink_colors()[2], (count, 1))
    bars = Instances(start, angles, lengths, np.full(count, GHOST_WIDTH), colors)
    return bars.only(_whole(count, picture.ghost_broken))


def deviations(sketch: Sketch, picture: Picture, rest_angles: Floats) -> Floats:
    """(J,) how far each joint is off its rest angle, degrees in (-180, 180]; 0 where a stop does not act.

    Args:
        sketch: of the scene.
        picture: what is drawn.
        rest_angles: (J,) degrees, without the shift of the arrow keys and without what has yielded.
    """
    along = picture.positions[sketch.springs[:, 1]] - picture.positions[sketch.springs[:, 0]]
    a, b = along[sketch.joint_a], along[sketch.joint_b]
    cross, dot = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0], a[:, 0] * b[:, 0] + a[:, 1] * b[:, 1]
    moved = picture.damage.set_angles if picture.damage is not None else ()
    _, turn = _swings(sketch, picture)
    rest = rest_angles + picture.rest_angle_shift + turn + (np.array(moved) if moved else 0.0)
    off = np.degrees(np.arctan2(cross, dot)) - rest
    off -= 360.0 * np.ceil((off - 180.0) / 360.0)
    stops, sides = sketch.stops.T
    off[stops] = np.where(sides * off[stops] < 0.0, 0.0, off[stops])
    return off


def wedges(sketch: Sketch, picture: Picture, rest_angles: Floats) -> Instances:
    """Thin triangles from the rest angle to the present one, `sketch.slices` of them for each whole joint."""
    off = deviations(sketch, picture, rest_angles)
    holds = _whole(len(sketch.springs), broken_of(picture.damage))
    whole = holds[sketch.joint_a] & holds[sketch.joint_b]
    off, tip, sense = off[whole], sketch.joint_mass[whole], sketch.joint_sense[whole]
    world, slices = to_world(sketch, picture.positions), sketch.slices
    ends = sketch.springs[sketch.joint_b[whole]]
    along = (world[ends[:, 1]] - world[ends[:, 0]]) * sense[:, None]
    present = np.arctan2(along[:, 1], along[:, 0])
    turn = np.radians(off) * sketch.mapping.flip
    half = np.minimum(np.minimum(np.abs(turn) / slices, 3.0) / 2.0, WIDEST)
    reach = WEDGE * sketch.radius[tip] * (np.cos(half) if slices == 1 else 1.0)
    part = 1.0 - (np.arange(slices) + 0.5) / slices
    return Instances(
        np.repeat(world[tip], slices, axis=0),
        (present[:, None] - turn[:, None] * part).ravel(),
        np.repeat(reach, slices),
        np.repeat(2.0 * reach * np.tan(half), slices),
        np.repeat(_colored(turn_colors(sketch), off / FULL_DEVIATION), slices, axis=0),
    )


def masses(sketch: Sketch, picture: Picture) -> Instances:
    """Rims, then fills, then shines: discs."""
    world, radius = to_world(sketch, picture.positions), sketch.radius
    shine = world + 0.3 * radius[:, None] * np.array((-1.0, 1.0))
    sizes = np.concatenate((radius, FILL * radius, SHINE * radius))
    return Instances(
        np.vstack((world, world, shine)), np.zeros(len(sizes)), sizes, sizes, sketch.mass_colors()
    )


def pins(sketch: Sketch, picture: Picture) -> Instances:
    """Supports of the masses that are held."""
    return _upright(sketch, picture, sketch.pinned, PIN, 0)


def ring(sketch: Sketch, picture: Picture) -> Instances:
    """Around the driven mass, if there is one."""
    driven = () if sketch.driven is None else (sketch.driven,)
    return _upright(sketch, picture, np.array(driven, np.int64), RING, 1)


def _upright(
    sketch: Sketch, picture: Picture, which: NDArray[np.int64], factor: float, ink: int
) -> Instances:
    sizes = factor * sketch.radius[which]
    colors = np.tile(sketch.ink_colors()[ink], (len(which), 1))
    return Instances(to_world(sketch, picture.positions[which]), np.zeros(len(which)), sizes, sizes, colors)


def _between(sketch: Sketch, positions: Floats) -> tuple[Floats, Floats, Floats]:
    """Where each spring starts, its angle and its length, in the world."""
    world = to_world(sketch, positions)
    start = world[sketch.springs[:, 0]]
    dx, dy = (world[sketch.springs[:, 1]] - start).T
    return start, np.arctan2(dy, dx), np.hypot(dx, dy)


def _whole(count: int, broken: tuple[int, ...]) -> NDArray[np.bool_]:
    whole = np.ones(count, bool)
    whole[list(broken)] = False
    return whole


def _colored(table: NDArray[np.uint8], values: Floats) -> NDArray[np.uint8]:
    """The colours of a table for values from -1 to 1."""
    last = len(table) - 1
    return table[np.floor((np.clip(values, -1.0, 1.0) + 1.0) / 2.0 * last + 0.5).astype(np.int64)]
