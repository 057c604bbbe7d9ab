"""A motion as keyframes for game engines, spreadsheets and the like: a table of places over time."""

from __future__ import annotations

from sim.errors import InputError
from sim.store.csv_text import csv_text

from .clip import Clip

FPS = 60
"""Frames a second by default."""

SLOWEST = 1
"""Frames a second, at least."""

FASTEST = 240
"""Frames a second, at most."""

MAX_NUMBERS = 10_000_000
"""In a file."""


def check_size(clip: Clip, rate: int, numbers: int) -> None:
    """Refuse a motion that would make too large a file.

    Args:
        clip: the motion.
        rate: frames a second.
        numbers: of each frame.

    Raises:
        InputError: it would.
    """
    frames = clip.count(1.0 / rate)
    if frames * numbers > MAX_NUMBERS:
        raise InputError(
            f"{frames} frames of {numbers} numbers are too many, there may be {MAX_NUMBERS} in all; "
            "take fewer seconds or fewer frames a second"
        )


def motion_csv(clip: Clip, rate: int, decimal_comma: bool = False) -> bytes:
    """The places of all masses in each frame: time from the first one, s, then x0, y0, x1, y1 and so on, px.

    Numbers have ten digits.

    Raises:
        InputError: the table would be too long.
    """
    masses = len(clip.scene.masses)
    check_size(clip, rate, 2 * masses)
    head = ("time", *(f"{axis}{i}" for i in range(masses) for axis in "xy"))
    rows = (
        (k / rate, *frame.picture.positions.ravel().tolist()) for k, frame in enumerate(clip.frames_at(rate))
    )
    return csv_text((head, *rows), decimal_comma, "{:.10g}".format).encode()
