"""The description of a body as a paragraph, in the language that is spoken now."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from sim.analysis.description import Description, Motion, Piece, Shape, direction
from sim.analysis.modes import Modes
from sim.errors import InputError, SceneError
from sim.scene.types import Scene

from ...words import Key, listed, number, say

MOST_SWINGING = 300
"""Masses of a body whose slowest vibration is sought, at most: it takes a moment."""

_MANY = 6
"""Held masses that are listed, at most."""
_EACH = 8
"""Bodies of a scene that are described one by one, at most."""
_RUN = 3
"""Masses in a row from which on only the first and the last of them are named."""
_UNHEARD = 0.01
"""Part of the box by which something must have moved to be said."""
_SLOW = 0.5
"""Degrees a second from which a body turns."""
_LASTING = 0.005
"""Part of a swing that is lost, below which it is next to nothing."""
_NEARLY = 1.0
"""Amplitude of the slowest swing, px, below which a body is nearly at rest."""

_WAYS = ("right", "upRight", "up", "upLeft", "left", "downLeft", "down", "downRight")
_SHAPES: dict[str, Key] = {
    "mass": "describe-mass",
    "chain": "describe-chain",
    "ring": "describe-ring",
    "tree": "describe-tree",
    "net": "describe-net",
}


@dataclass(frozen=True, slots=True)
class Swing:
    """The slowest vibration of a body about its rest.

    Attributes:
        period: s, of a damped swing.
        lost: part of its amplitude that it loses in one.
        away: how far a mass is from its place at rest, px, at most; of a body that may float, in the frame
            that moves with it.
    """

    period: float
    lost: float
    away: float


def swing_of(found: Description, scene: Scene, positions: NDArray[np.float64]) -> Swing | None:
    """Find how a body of one piece swings; None where it does not, or where that takes too long to find.

    Args:
        found: what it is like.
        scene: its scene.
        positions: (n, 2) of its masses, px.
    """
    if len(found.pieces) > 1 or not 1 < len(scene.masses) <= MOST_SWINGING:
        return None
    try:
        modes = Modes(scene, 1)
    except (InputError, SceneError):
        return None
    if not modes.omega.size:
        return None
    ratio = float(modes.damping_ratios[0])
    if not ratio < 1.0:
        return None
    damped = math.sqrt(1.0 - ratio * ratio)
    return Swing(
        period=math.tau / (float(modes.omega[0]) * damped),
        lost=1.0 - math.exp(-math.tau * ratio / damped),
        away=float(modes.away(positions).max()),
    )


def paragraph(
    found: Description, scene: Scene, swing: Swing | None = None, before: Description | None = None
) -> str:
    """The sentences about a body.

    Args:
        found: what it is like.
        scene: its scene.
        swing: how it swings about its rest, if that is known.
        before: what it was like when it was described last.
    """
    return " ".join(_sentences(found, scene, swing, before))


def _sentences(
    found: Description, scene: Scene, swing: Swing | None, before: Description | None
) -> Iterator[str]:
    unit, up = scene.view.unit, -1.0 if scene.view.y_down else 1.0
    left, bottom, right, top = found.box
    pieces = found.pieces
    yield from _pieces(_in_order(pieces, up)[0] if 1 < len(pieces) <= _EACH else pieces)
    if len(scene.masses) > 1:
        width, height = f"{number(right - left)} {unit}", f"{number(top - bottom)} {unit}"
        if len(found.pieces) > 1:
            yield say("describe-lies.all", width=width, height=height)
        else:
            yield say("describe-lies", width=width, height=height)
    if len(found.pieces) > 1:
        yield from _bodies(found, unit, up)
    else:
        yield from _hangs(found.motion, top - bottom, unit)
        yield from _motion(found.motion, swing, unit, up)
    if found.stretched is not None:
        spring, strain = found.stretched
        yield say("describe-stretched", spring=str(spring), percent=number(100.0 * strain))
    if found.squeezed is not None:
        spring, strain = found.squeezed
        yield say("describe-squeezed", spring=str(spring), percent=number(-100.0 * strain))
    if found.touching:
        yield say("describe-touching", count=found.touching)
    if found.broken:
        yield say("describe-broken", count=found.broken)
    if found.yielded:
        yield say("describe-yielded", count=found.yielded)
    if swing is not None:
        if swing.lost < _LASTING:
            yield say("describe-swings-on", period=number(swing.period))
        else:
            yield say("describe-swings", period=number(swing.period), percent=number(100.0 * swing.lost))
    if before is not None:
        yield from _changes(found, before, unit, up)


def _pieces(pieces: Sequence[Piece]) -> Iterator[str]:
    """What there is, and what holds it; pieces that are alike are counted together."""
    kinds: defaultdict[tuple[Shape, int, int, int, int, bool], list[Piece]] = defaultdict(list)
    for one in pieces:
        kinds[one.shape, len(one.masses), one.springs, one.joints, one.loops, bool(one.held)].append(one)
    for (shape, masses, springs, joints, loops, _), alike in kinds.items():
        count = len(alike)
        match shape:
            case "mass":
                yield say("describe-mass", count=count)
            case "net":
                yield say(
                    "describe-net", count=count, masses=masses, springs=springs, joints=joints, loops=loops
                )
            case _:
                key = _SHAPES[shape]
                yield say(key, count=count, masses=masses, springs=springs, joints=joints)
        yield _held(alike, len(pieces) > 1)


def _held(pieces: list[Piece], are_several: bool) -> str:
    """What holds some pieces, of several or of one."""
    held = [(mass, side) for piece in pieces for mass, side in zip(piece.held, piece.sides, strict=True)]
    if not held:
        return say("describe-free.parts", count=len(pieces)) if are_several else say("describe-free")
    if len(held) == 1 and pieces[0].shape == "mass":
        return say("describe-held.mass", mass=str(held[0][0]))
    if len(held) == 1:
        return say("describe-held", mass=str(held[0][0]), side=held[0][1])
    if len(held) <= _MANY:
        masses = listed([str(mass) for mass, _ in sorted(held)])
        return say("describe-held-many", count=len(held), masses=masses)
    return say("describe-held-most", count=len(held))


def way_in_words(vector: tuple[float, float], up: float) -> str:
    """The direction of a vector, in words."""
    return say("describe-way", way=_WAYS[round(direction(vector, up) / 45.0) % 8])


def _bodies(found: Description, unit: str, up: float) -> Iterator[str]:
    """How each of several pieces lies and moves, in the order in which they lie; of many, how they move."""
    pieces = [piece for piece in found.pieces if len(piece.masses) > len(piece.held)]
    if 0 < len(pieces) <= _EACH:
        pieces, side = _in_order(pieces, up)
        for i, piece in enumerate(pieces, start=1):
            masses = _runs(piece.masses)
            yield say("describe-piece", number=str(i), side=side, count=len(piece.masses), masses=masses)
            yield from _hangs(piece.motion, found.box[3] - found.box[1], unit)
            if not found.motion.is_still:
                yield from _motion(piece.motion, None, unit, up)
    elif not found.motion.is_still:
        yield _fastest("describe-moves.all", found.motion, unit, up)
    if found.motion.is_still:
        yield say("describe-still.all")


def _in_order(pieces: Sequence[Piece], up: float) -> tuple[list[Piece], Literal["left", "top"]]:
    """Pieces from the left or from the top, along which they are farther apart."""
    centres = np.array([piece.motion.centre for piece in pieces])
    across, upward = np.ptp(centres, axis=0)
    places = centres[:, 0] if across >= upward else -up * centres[:, 1]
    return [pieces[at] for at in np.argsort(places, kind="stable")], "left" if across >= upward else "top"


def _runs(masses: tuple[int, ...]) -> str:
    """Numbers of masses, such as "0–9 and 12"; they ascend."""
    runs: list[list[int]] = []
    for mass in masses:
        if runs and mass == runs[-1][-1] + 1:
            runs[-1].append(mass)
        else:
            runs.append([mass])
    parts = ([f"{run[0]}–{run[-1]}"] if len(run) >= _RUN else map(str, run) for run in runs)
    return listed([text for part in parts for text in part])


def _hangs(motion: Motion, height: float, unit: str) -> Iterator[str]:
    if motion.hangs is not None and motion.hangs > _UNHEARD * height > 0.0:
        yield say("describe-hangs", mass=str(motion.lowest), depth=f"{number(motion.hangs)} {unit}")


def _motion(motion: Motion, swing: Swing | None, unit: str, up: float) -> Iterator[str]:
    if motion.is_still and swing is not None and swing.away >= _NEARLY:
        yield say("describe-still.away", length=f"{number(swing.away)} {unit}")
        return
    if motion.is_still:
        yield say("describe-still")
        return
    if swing is not None and max(swing.away, motion.speed * swing.period / math.tau) < _NEARLY:
        yield say("describe-still.nearly", length=f"{number(_NEARLY)} {unit}")
        return
    yield _fastest("describe-moves", motion, unit, up)
    drift = math.hypot(*motion.drift)
    if drift > 0.1 * motion.speed:
        yield say("describe-drifts", whole=way_in_words(motion.drift, up), speed=f"{number(drift)} {unit}/s")
    degrees = math.degrees(motion.turning)
    if abs(degrees) >= _SLOW:
        sense = "counterclockwise" if degrees > 0.0 else "clockwise"
        yield say("describe-turns", sense=sense, degrees=number(abs(degrees)))


def _fastest(key: Key, motion: Motion, unit: str, up: float) -> str:
    way, speed = way_in_words(motion.velocity, up), f"{number(motion.speed)} {unit}/s"
    return say(key, mass=str(motion.fastest), way=way, speed=speed)


def _changes(found: Description, before: Description, unit: str, up: float) -> Iterator[str]:
    """What is different from before."""
    if [piece.masses for piece in found.pieces] != [piece.masses for piece in before.pieces]:
        if found.broken > before.broken:
            yield say("describe-broke", count=found.broken - before.broken)
        else:
            yield say("describe-built")
        return
    (x, y), (old_x, old_y) = found.motion.centre, before.motion.centre
    way = x - old_x, y - old_y
    size = max(found.box[2] - found.box[0], found.box[3] - found.box[1])
    if found.broken > before.broken:
        yield say("describe-broke", count=found.broken - before.broken)
    if math.hypot(*way) > _UNHEARD * size:
        yield say("describe-moved", way=way_in_words(way, up), length=f"{number(math.hypot(*way))} {unit}")
    elif found.broken == before.broken:
        yield say("describe-same")
