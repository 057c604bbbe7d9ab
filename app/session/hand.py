"""The pointers of a page, and the masses that they hold and lead."""

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
"""Seconds between two of viser's own reports of a drag; masses glide from one to the next."""

MAX_HANDS = 10
"""Hands of a page, numbered from 0: one for each finger on a board."""

GIZMO = MAX_HANDS
"""Number of the hand that leads a mass by its gizmo, which may keep to an axis."""


@dataclass
class _Pointer:
    """A pointer's position, px, and the wall time, s, at which the mass that it leads arrives there."""

    x: float
    y: float
    arrival: float


@dataclass
class _Hand:
    """A mass in a hand, and its offset from the pointer, px."""

    mass: int
    dx: float
    dy: float
    pointer: _Pointer


class PointerHands:
    """The hands of a page's pointers, and the pointer that a mass follows without a button.

    Args:
        body: gives the present body.
        do: acts on it, and on its companions.
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
        """The masses in hands, in the order in which they were taken."""
        return tuple(hand.mass for hand in self._hands.values())

    def is_full(self, number: int) -> bool:
        """Whether a hand holds a mass."""
        return number in self._hands

    def point(self, number: int, x: float, y: float, arrival: float) -> None:
        """Note that a hand's pointer is at (x, y) px, where its mass is to arrive at a wall time, s.

        The pointer of hand 0, when empty, is the one that is followed; other empty hands are ignored.
        """
        pointer = _Pointer(*finite(x, y), arrival)
        if number in self._hands:
            self._hands[number].pointer = pointer
        elif number == 0:
            self._followed = pointer

    def forget_pointer(self) -> None:
        """Follow nothing until the pointer moves again."""
        self._followed = None

    def take(self, number: int, mass: int, x: float, y: float) -> None:
        """Take a mass in a hand, with its pointer at (x, y) px; another hand loses it."""
        x, y = finite(x, y)
        self.let_go(number, None)
        self._do(log.Grab(mass=mass))
        self._hands = {n: hand for n, hand in self._hands.items() if hand.mass != mass}
        px, py = self._place(mass)
        self._hands[number] = _Hand(mass, px - x, py - y, _Pointer(x, y, self._clock()))

    def let_go(self, number: int, following: int | None) -> None:
        """Let go of a hand's mass; `following` is the mass that then follows the pointer, if any."""
        if number in self._hands:
            hand = self._hands[number]
            # Lead it to where the pointer is: the last frame may not have got so far.
            self._lead(hand, None)
            del self._hands[number]
            self._do(log.Release(mass=hand.mass))
            self._followed = hand.pointer
        if following is None:
            self._followed = None

    def let_all_go(self, following: int | None) -> None:
        """Let go of all masses; see `let_go`."""
        for number in list(self._hands):
            self.let_go(number, following)
        if following is None:
            self._followed = None

    def drop(self) -> None:
        """Forget all hands; the body has let go by itself."""
        self._hands.clear()
        self._followed = None

    def steer(self, following: int | None, glide: bool) -> None:
        """Lead the masses in hands, or else the one that follows, to the pointers: gradually, or at once."""
        led = list(self._hands.values())
        if not led and following is not None and self._followed is not None:
            led = [_Hand(following, 0.0, 0.0, self._followed)]
        if not led:
            return
        if not glide:
            for hand in led:
                self._lead(hand, None)
            return
        # This frame's share of the way to where the mass is to be when the next report comes.
        now = self._clock()
        frame = min(max(now - self._last_steer, 1e-3), 2.0 * FRAME)
        self._last_steer = now
        for hand in led:
            self._lead(hand, min(1.0, frame / max(frame, hand.pointer.arrival - now + frame)))

    def _lead(self, hand: _Hand, share: float | None) -> None:
        """Lead a hand's mass a share of the way to its pointer, over some steps, or at once (None)."""
        mass, pointer = hand.mass, hand.pointer
        x, y = _clamp(pointer.x + hand.dx), _clamp(pointer.y + hand.dy)
        if self._body().rate_limited:
            # As fast as the body can follow, also after it is let go.
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
    """A position of the pointer, px, if it is finite.

    Raises:
        InputError: it is not a finite number.
    """
    if not (math.isfinite(x) and math.isfinite(y)):
        raise InputError("the pointer is nowhere: its position is not a finite number")
    return x, y


def _clamp(coordinate: float) -> float:
    return min(max(coordinate, -MAX_COORDINATE), MAX_COORDINATE)
