"""What surrounds a body in a picture, as lines and polygons in pixels; as `app/stage/environment.js`
has it in a page.

Points are (k, 2) arrays, y downwards. Distances that are pixels in the page go by `Window.unit`.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from sim.forces.fillings import FillingRow
from sim.forces.plasticity import leaking
from sim.scene.surroundings import STILL_AIR

from ..stage.looks import (
    ARC_BEYOND,
    ARC_HEAD,
    ARC_OPEN,
    CREST,
    DENSE,
    GRAIN,
    GRAINS,
    HATCH,
    HEAD,
    PARTS,
    POINT,
    RIPPLE,
    RIPPLES,
    SIDE,
    STREAK,
    STREAKS,
    STROKE,
    WORKS,
)
from ..stage.plan import Picture, belts
from ..stage.sketch import Floats, Sketch
from .window import Window


class Wall(NamedTuple):
    """What a picture shows of a wall.

    Attributes:
        at, normal: (2,) a point of the surface, and the direction to the free side.
        corners: (k, 2) of the part in view.
        surface: (2, 2) ends of the surface in view, or (0, 2).
        belt: px/s, see `app.stage.plan.belts`.
    """

    at: Floats
    normal: Floats
    corners: Floats
    surface: Floats
    belt: float = 0.0


def walls(sketch: Sketch, window: Window) -> list[Wall]:
    """The scene's walls, each with the part of its surface that no other covers."""
    if sketch.environment is None:
        return []
    rows = sketch.environment.walls.rows
    found = [_in_view(row, sketch, window) for row in rows[:, :4]]
    for k, speed in enumerate(belts(sketch, rows).tolist()):
        found[k] = found[k]._replace(belt=speed)
    return [
        wall._replace(surface=_uncovered(wall, [other for other in found if other is not wall]))
        for wall in found
    ]


def rails(sketch: Sketch, window: Window) -> list[Floats]:
    """(2, 2) the ends of each rail in view."""
    found = [_in_view(row, sketch, window).surface for row in sketch.rails]
    return [ends for ends in found if len(ends)]


def _in_view(row: Floats, sketch: Sketch, window: Window) -> Wall:
    at = window.pixels(sketch.mapping.to_world(row[None, :2])[:, :2])[0]
    normal = np.array((row[2], -row[3] * sketch.mapping.flip))
    width, height = window.size
    box = np.array(((0.0, 0.0), (width, 0.0), (width, height), (0.0, height)))
    depths = (at - box) @ normal
    corners: list[Floats] = []
    surface: list[Floats] = []
    for i in range(4):
        depth, after = depths[i], depths[(i + 1) % 4]
        if depth >= 0.0:
            corners.append(box[i])
        if (depth >= 0.0) != (after >= 0.0):
            crossing = box[i] + depth / (depth - after) * (box[(i + 1) % 4] - box[i])
            corners.append(crossing)
            surface.append(crossing)
    return Wall(at, normal, np.array(corners).reshape(-1, 2), np.array(surface).reshape(-1, 2))


def _uncovered(wall: Wall, others: list[Wall]) -> Floats:
    ends = wall.surface
    for other in others:
        if len(ends) < 2:
            break
        a, b = (ends - other.at) @ other.normal
        if a < 0.0 and b < 0.0:
            return np.zeros((0, 2))
        if (a < 0.0) != (b < 0.0):
            crossing = ends[0] + a / (a - b) * (ends[1] - ends[0])
            ends = np.array((crossing, ends[1]) if a < 0.0 else (ends[0], crossing))
    return ends


def hatching(wall: Wall, sketch: Sketch, window: Window) -> Floats:
    """(k, 2, 2) strokes along a wall's surface, which stay where they are in the scene; on a belt, pairs that
    point where it runs."""
    if len(wall.surface) < 2:
        return np.zeros((0, 2, 2))
    along = np.array((-wall.normal[1], wall.normal[0]))
    low, high = sorted((wall.surface - wall.at) @ along)
    scale = sketch.mapping.scale * window.step
    gap = 2.0 ** round(math.log2(HATCH * window.unit / scale)) * scale
    k = np.arange(math.ceil(low / gap), math.floor(high / gap) + 1)
    begin = wall.at + (k * gap)[:, None] * along
    size = STROKE * window.unit
    if not wall.belt:
        return np.stack((begin, begin - size * (wall.normal + along)), axis=1)
    tip, back = begin - size * wall.normal, math.copysign(0.5 * size, wall.belt) * along
    strokes = (tip - back + side * 0.5 * size * wall.normal for side in (1.0, -1.0))
    return np.concatenate([np.stack((tip, end), axis=1) for end in strokes])


def fillings(
    sketch: Sketch, positions: Floats, broken: Sequence[int], window: Window
) -> list[tuple[bool, Floats]]:
    """Of each filling that has not got out whether it is a gas, and the polygon of its loop."""
    table = sketch.environment.fillings if sketch.environment is not None else None
    if table is None or not len(table.rows):
        return []
    places = window.pixels(sketch.mapping.to_world(positions)[:, :2])
    loops = table.loops()
    left = set(leaking(loops, sketch.springs, np.array(broken, np.int64)))
    kinds = [bool(FillingRow(*row).is_gas) for row in table.rows]
    return [(kinds[k], places[loop]) for k, loop in enumerate(loops) if k not in left]


def load_arrows(sketch: Sketch, positions: Floats, window: Window) -> tuple[Floats, Floats]:
    """(k, 2, 2) shafts and (k, 3, 2) heads of the arrows of constant forces on masses."""
    which = sketch.loads[:, 0].astype(int)
    begin = window.pixels(sketch.mapping.to_world(positions[which])[:, :2])
    arrows = sketch.loads[:, 1:] * (window.step, -window.step)
    length = np.hypot(*arrows.T)[:, None]
    along = arrows / length
    across = np.column_stack((-along[:, 1], along[:, 0]))
    size = np.minimum(HEAD * window.unit, 0.6 * length)
    tip, base = begin + arrows, begin + arrows - size * along
    side = SIDE / HEAD * size * across
    return np.stack((begin, base), 1), np.stack((base + side, tip, base - side), 1)


def driven_arrows(sketch: Sketch, picture: Picture, window: Window) -> tuple[list[Floats], list[Floats]]:
    """Strokes (k, 2) of what motors and keys do: of what works now, and of what rests. Each motor has an arc
    about the mass of its joint, with a head where it turns to, and each force that keys work an arrow."""
    works: list[Floats] = []
    rests: list[Floats] = []
    world = sketch.mapping.to_world(picture.positions)[:, :2]
    places = window.pixels(world) @ (1.0, 1.0j)
    efforts = (*(picture.efforts or (0.0, 0.0)), 1.0)

    def add(effort: float, line: Floats, heading: complex, size: float) -> None:
        back = -size * heading
        ends = line[-1] + back * np.array((1.0 + 1j * SIDE / HEAD, 0.0, 1.0 - 1j * SIDE / HEAD))
        for stroke in (line, ends):
            (works if abs(effort) > WORKS else rests).append(np.column_stack((stroke.real, stroke.imag)))

    for joint, turn, keys in sketch.motors.tolist():
        j, effort = int(joint), efforts[int(keys)]
        mass, ends = sketch.joint_mass[j], sketch.springs[sketch.joint_b[j]]
        far = ends[1] if sketch.joint_sense[j] > 0 else ends[0]
        way = -sketch.mapping.flip * turn * (-1.0 if effort < -WORKS else 1.0)
        radius = sketch.radius[mass] * window.step + ARC_BEYOND * window.unit
        along = np.angle(places[far] - places[mass])
        angles = along + way * np.linspace(0.5 * ARC_OPEN, math.tau - 0.5 * ARC_OPEN, 48)
        size = ARC_HEAD * window.unit
        heading = np.exp(1j * (angles[-1] + way * (0.5 * math.pi - 0.5 * size / radius)))
        add(effort, places[mass] + radius * np.exp(1j * angles), heading, size)
    for mass, x, y, keys in sketch.pushes.tolist():
        effort = efforts[int(keys)]
        arrow = window.step * complex(x, -y) * (-1.0 if effort < -WORKS else 1.0)
        size = min(HEAD * window.unit, 0.6 * abs(arrow))
        add(effort, places[int(mass)] + arrow * np.array((0.0, 1.0)), arrow / abs(arrow), size)
    return works, rests


def skin(sketch: Sketch, positions: Floats, broken: tuple[int, ...], window: Window) -> tuple[Floats, float]:
    """(k, 2, 2) the springs that are not broken, and how wide they are, pixels, so that they touch where
    contact begins; none where there is no contact."""
    if not sketch.contact:
        return np.zeros((0, 2, 2)), 0.0
    places = window.pixels(sketch.mapping.to_world(positions)[:, :2])
    lines = places[np.delete(sketch.springs, list(broken), axis=0)]
    return lines, sketch.contact * sketch.mapping.scale * window.step


def nice(value: float) -> float:
    """The next of 1, 2, 5, 10, 20, ... at or below a positive value."""
    power = 10.0 ** math.floor(math.log10(value))
    return power * max(step for step in (1.0, 2.0, 5.0) if step * power <= value * (1.0 + 1e-9))


def grid(sketch: Sketch, frame: tuple[float, float, float, float], window: Window) -> tuple[Floats, Floats]:
    """(k, 2, 2) thin lines, and every fifth, at round numbers; over all of the picture."""
    xmin, ymin, xmax, ymax = frame
    scale = sketch.mapping.scale * window.step
    major = nice(max(xmax - xmin, ymax - ymin) / 5.0)
    dense = major / 5.0 * scale < DENSE
    every = (major if dense else major / 5.0) * scale
    origin = window.pixels(sketch.mapping.to_world(np.zeros((1, 2)))[:, :2])[0]
    thin: list[Floats] = []
    thick: list[Floats] = []
    if major * scale < DENSE:
        return np.zeros((0, 2, 2)), np.zeros((0, 2, 2))
    for axis in (0, 1):
        extent, across = window.size[axis], window.size[1 - axis]
        k = np.arange(math.ceil(-origin[axis] / every), math.floor((extent - origin[axis]) / every) + 1)
        lines = np.zeros((len(k), 2, 2))
        lines[:, :, axis] = (origin[axis] + k * every)[:, None]
        lines[:, 1, 1 - axis] = across
        fifth = np.full(len(k), dense) | (k % 5 == 0)
        thin.append(lines[~fifth])
        thick.append(lines[fifth])
    return np.concatenate(thin), np.concatenate(thick)


def streaks(sketch: Sketch, time: float, window: Window) -> list[Floats]:
    """Lines of the wind, one in each cell of a lattice that drifts with the mean wind, with their points.

    Gusts stand still for who moves with the mean wind: a streak is a piece of a line of that still pattern.

    Args:
        sketch: of the scene.
        time: simulated seconds.
        window: of the picture.
    """
    if sketch.environment is None or not _blows(sketch):
        return []
    air = sketch.environment.air
    mapping, scale = sketch.mapping, sketch.mapping.scale * window.step
    wind = np.array((air.wind_x, air.wind_y))
    drift = air.wind_x * time, air.wind_y * time
    place = _scattered(sketch, window, STREAKS, drift).places
    lasting = STREAK * window.unit / (math.hypot(*wind) * scale * PARTS)
    points = [place + drift]
    for _ in range(PARTS):
        place = place - lasting * _air(air.waves[:, :-1], wind, place)
        points.append(place + drift)
    flat = mapping.to_world(np.concatenate(points))[:, :2]
    lines = window.pixels(flat).reshape(PARTS + 1, -1, 2).swapaxes(0, 1)
    return [*lines, *_points(lines[:, 0], lines[:, 1], POINT * window.unit)]


def ripples(sketch: Sketch, window: Window) -> Floats:
    """(k, p, 2) lines of a medium that stands still; where wind moves it, its streaks show that instead."""
    if not sketch.medium or _blows(sketch):
        return np.zeros((0, 2, 2))
    part = np.linspace(0.0, 1.0, 2 * PARTS + 1)
    ripple = np.column_stack(((part - 0.5) * RIPPLE, -CREST * np.sin(4.0 * math.pi * part)))
    return _scattered(sketch, window, RIPPLES).pixels[:, None] + window.unit * ripple


def grains(sketch: Sketch, window: Window) -> Floats:
    """(k, 2, 2) lines of the ground."""
    if not sketch.ground:
        return np.zeros((0, 2, 2))
    i, j, _, pixels = _scattered(sketch, window, GRAINS)
    turn, long = math.pi * _chance(i, j, 2), GRAIN * window.unit * (0.2 + 0.8 * _chance(i, j, 3))
    return np.stack((pixels, pixels + np.column_stack((long * np.cos(turn), long * np.sin(turn)))), axis=1)


def _blows(sketch: Sketch) -> bool:
    """Whether there is wind to be drawn."""
    air = sketch.environment.air if sketch.environment is not None else None
    return air is not None and math.hypot(air.wind_x, air.wind_y) >= STILL_AIR


class _Scattered(NamedTuple):
    """Places over all of a picture, one in each cell of a lattice."""

    i: np.ndarray  # of the cells
    j: np.ndarray
    places: Floats  # (k, 2) px, before the lattice has drifted
    pixels: Floats  # (k, 2) after that


def _scattered(
    sketch: Sketch, window: Window, apart: float, drift: tuple[float, float] = (0.0, 0.0)
) -> _Scattered:
    """Places that are so many pixels apart, about, of a lattice that has drifted by so many px."""
    mapping = sketch.mapping
    cell = 2.0 ** round(math.log2(apart * window.unit / (mapping.scale * window.step)))
    corners = np.array(((0.0, 0.0), window.size))
    world = (corners - (window.x, window.y)) / (window.step, -window.step)
    ends = np.array([mapping.to_scene(x, y) for x, y in world])
    first = np.floor((ends.min(0) - drift) / cell).astype(int)
    last = np.ceil((ends.max(0) - drift) / cell).astype(int)
    i, j = np.mgrid[first[0] : last[0] + 1, first[1] : last[1] + 1].reshape(2, -1)
    places = np.column_stack(((i + _chance(i, j, 0)) * cell, (j + _chance(i, j, 1)) * cell))
    return _Scattered(i, j, places, window.pixels(mapping.to_world(places + drift)[:, :2]))


def _air(waves: Floats, wind: Floats, places: Floats) -> Floats:
    """(n, 2) velocity of the air, px/s, at places that the mean wind carries along."""
    sine = np.sin(places @ waves[:, :2].T + waves[:, 4])
    return wind + sine @ waves[:, 2:4]


def _chance(i: np.ndarray, j: np.ndarray, k: int) -> Floats:
    """Numbers from 0 to 1 that look like chance, always the same for a cell."""
    value = np.sin(127.1 * i + 311.7 * j + 74.7 * k) * 43758.5453
    return value - np.floor(value)


def _points(tips: Floats, after: Floats, size: float) -> list[Floats]:
    """The points of arrows that come from somewhere."""
    back = after - tips
    length = np.hypot(*back.T)
    back = back[length > 0.0] / length[length > 0.0][:, None] * size
    tips = tips[length > 0.0]
    side = np.column_stack((-back[:, 1], back[:, 0])) * 0.7
    return list(np.stack((tips + back + side, tips, tips + back - side), axis=1))
