"""What the pointers of a page do to its body: taking hold of masses, leading them, letting them go."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import sim
from sim.errors import InputError
from sim.scene.numbers import MAX_COORDINATE

from . import log

FRAME = 1.0 / 60.0
"""Seconds of a frame."""

DRAG_EVENT = 0.05
"""Seconds between two of viser's own reports of a drag; a mass is led smoothly from one to the next."""

MAX_HANDS = 10
"""Hands that the pointers of a page have at most, numbered from 0: as many as fingers on a board."""

GIZMO = MAX_HANDS
"""Number of the hand that leads a mass by its gizmo, which may keep to an axis."""


@dataclass
class _Pointer:
    """Where a pointer is, px, and the wall time, s, at which what it leads is to be there."""

    x: float
    y: float
    arrival: float


@dataclass
class _Hand:
    """A mass in hand, and where it is held off the pointer, px."""

    mass: int
    dx: float
    dy: float
    pointer: _Pointer


class PointerHands:
    """The pointers of a page, each with a mass in its hand, and the one that a mass follows without a button.

    Args:
        body: the body as it is now.
        do: does something to it, and to those that are to do the same.
        clock: wall time, s.
    """

    def __init__(
        self,
        body: Callable[[], sim.Simulation],
        do: Callable[[log.Act], None],
        clock: Callable[[], float],
    ) -> None:
        self._body, self._do, self._clock = body, do, clock
        self._hands: dict[int, _Hand] = {}
        self._followed: _Pointer | None = None
        self._last_steer = clock()

    @property
    def masses(self) -> tuple[int, ...]:
        """The masses in hand, in the order in which they were taken."""
        return tuple(hand.mass for hand in self._hands.values())

    def is_full(self, number: int) -> bool:
        """Whether a hand has a mass."""
        return number in self._hands

    def point(self, number: int, x: float, y: float, arrival: float) -> None:
        """The pointer of a hand is at (x, y) px, where its mass is to be at a wall time, s.

        That of an empty hand 0 is the one that is followed; no other empty hand matters.
        """
        pointer = _Pointer(*finite(x, y), arrival)
        if number in self._hands:
            self._hands[number].pointer = pointer
        elif number == 0:
            self._followed = pointer

    def forget_pointer(self) -> None:
        """Nothing is to follow until the pointer moves again."""
        self._followed = None

    def take(self, number: int, mass: int, x: float, y: float) -> None:
        """Have a hand take hold of a mass, with its pointer at (x, y) px; one that had the mass loses it."""
        x, y = finite(x, y)
        self.let_go(number, None)
        self._do(log.Grab(mass=mass))
        self._hands = {n: hand for n, hand in self._hands.items() if hand.mass != mass}
        px, py = self._place(mass)
        self._hands[number] = _Hand(mass, px - x, py - y, _Pointer(x, y, self._clock()))

    def let_go(self, number: int, following: int | None) -> None:
        """Have a hand let go of its mass; `following`: the mass that then follows the pointer, if any."""
        if number in self._hands:
            hand = self._hands[number]
            # Where the pointer left it: the last frame may not have led it all the way.
            self._lead(hand, None)
            del self._hands[number]
            self._do(log.Release(mass=hand.mass))
            self._followed = hand.pointer
        if following is None:
            self._followed = None

    def let_all_go(self, following: int | None) -> None:
        """Have all hands let go; see `let_go`."""
        for number in list(self._hands):
            self.let_go(number, following)
        if following is None:
            self._followed = None

    def drop(self) -> None:
        """Have nothing in hand any more; the bodies have let go by themselves."""
        self._hands.clear()
        self._followed = None

    def steer(self, following: int | None, glide: bool) -> None:
        """Lead the masses in hand, or else one that follows, to the pointers: over some steps, or at once."""
        led = list(self._hands.values())
        if not led and following is not None and self._followed is not None:
            led = [_Hand(following, 0.0, 0.0, self._followed)]
        if not led:
            return
        if not glide:
            for hand in led:
                self._lead(hand, None)
            return
        # This frame's share of the way to where a mass is to be when the next report comes.
        now = self._clock()
        frame = min(max(now - self._last_steer, 1e-3), 2.0 * FRAME)
        self._last_steer = now
        for hand in led:
            self._lead(hand, min(1.0, frame / max(frame, hand.pointer.arrival - now + frame)))

    def _lead(self, hand: _Hand, share: float | None) -> None:
        """Lead the mass in a hand to its pointer: a share of the way over some steps, or at once (None)."""
        mass, pointer = hand.mass, hand.pointer
        x, y = _clamp(pointer.x + hand.dx), _clamp(pointer.y + hand.dy)
        if self._body().rate_limited:
            # As fast as it can follow while time passes, also after it was let go.
            self._do(log.Follow(mass=mass, to=(x, y)))
        elif share is None:
            self._do(log.Move(mass=mass, to=(x, y)))
        else:
            px, py = self._place(mass)
            self._do(log.Lead(mass=mass, to=(px + (x - px) * share, py + (y - py) * share)))

    def _place(self, mass: int) -> tuple[float, float]:
        x, y = self._body().positions[mass].tolist()
        return x, y


def finite(x: float, y: float) -> tuple[float, float]:
    """A place of the pointer, px.

    Raises:
        InputError: it is not a finite number.
    """
    if not (math.isfinite(x) and math.isfinite(y)):
        raise InputError("the pointer is nowhere: its position is not a finite number")
    return x, y


def _clamp(coordinate: float) -> float:
    return min(max(coordinate, -MAX_COORDINATE), MAX_COORDINATE)
