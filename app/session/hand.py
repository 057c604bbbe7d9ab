"""What the pointer of a page does to its body: taking hold of a mass, leading it, letting it go."""

from __future__ import annotations

import math
from collections.abc import Callable

import sim
from sim.errors import InputError
from sim.motion.divergence import FARTHEST

from .record import Recorder

FRAME = 1.0 / 60.0
"""Seconds of a frame."""

DRAG_EVENT = 0.05
"""Seconds between two of viser's own reports of a drag; a mass is led smoothly from one to the next."""

Body = Recorder | sim.Simulation


class PointerHand:
    """The pointer of a page, and the mass in its hand.

    Args:
        bodies: the body, and others that are to do the same.
        clock: wall time, s.

    Attributes:
        by_gizmo: whether a gizmo leads the mass in hand, which may keep to an axis.
    """

    def __init__(self, bodies: Callable[[], list[Body]], clock: Callable[[], float]) -> None:
        self._bodies, self._clock = bodies, clock
        self._held: tuple[int, float, float] | None = None  # mass, and where it is held off the pointer
        self._pointer: tuple[float, float] | None = None
        self._arrival = 0.0  # when a led mass is to be at the pointer
        self._pointed_at = -math.inf  # when the page's script last told where the pointer is
        self._last_steer = clock()
        self.by_gizmo = False

    @property
    def mass(self) -> int | None:
        """The mass in hand."""
        return self._held[0] if self._held else None

    def point(self, x: float, y: float, at: float) -> None:
        """The page's script tells where the pointer is, px, at a wall time, s."""
        self._pointed_at = at
        if self._held is None or not self.by_gizmo:
            self._pointer, self._arrival = finite(x, y), at + FRAME

    def drag_to(self, x: float, y: float, at: float) -> None:
        """viser tells where the mass in hand is dragged, px, at a wall time, s."""
        # The page's script is faster and tells the same, but a gizmo may keep to an axis.
        if self._held is not None and (self.by_gizmo or at - self._pointed_at > 0.2):
            self._pointer, self._arrival = finite(x, y), at + DRAG_EVENT

    def forget_pointer(self) -> None:
        """Nothing is to follow until the pointer moves again."""
        self._pointer = None

    def take(self, mass: int, x: float, y: float, by_gizmo: bool) -> None:
        """Take hold of a mass, with the pointer at (x, y) px."""
        x, y = finite(x, y)
        self.let_go(None)
        for body in self._bodies():
            body.grab(mass)
        px, py = self._place(mass)
        self._held = (mass, px - x, py - y)
        self._pointer = (x, y)
        self.by_gizmo = by_gizmo

    def let_go(self, following: int | None) -> None:
        """Let go of the mass in hand; `following`: the mass that goes on following the pointer, if any."""
        if self._held is not None:
            mass = self._held[0]
            # Where the pointer left it: the last frame may not have led it all the way.
            self.steer(None, glide=False)
            self._held = None
            for body in self._bodies():
                body.release(mass)
        if following is None:
            self._pointer = None

    def drop(self) -> None:
        """Have nothing in hand any more; the bodies have let go by themselves."""
        self._held = self._pointer = None

    def steer(self, following: int | None, glide: bool) -> None:
        """Lead the mass in hand, or else one that follows, to the pointer: over some steps, or at once."""
        if self._pointer is None:
            return
        x, y = self._pointer
        if self._held is not None:
            mass, dx, dy = self._held
            x, y = x + dx, y + dy
        elif following is not None:
            mass = following
        else:
            return
        x, y = _clamp(x), _clamp(y)
        bodies = self._bodies()
        if bodies[0].rate_limited:
            # As fast as it can follow while time passes, also after it was let go; the ghost as it does.
            for body in bodies:
                if body.rate_limited:
                    body.follow(mass, (x, y))
            return
        if not glide:
            for body in bodies:
                body.move(mass, (x, y))
            return
        # This frame's share of the way to where the mass is to be when the next report comes.
        now = self._clock()
        frame = min(max(now - self._last_steer, 1e-3), 2.0 * FRAME)
        self._last_steer = now
        share = min(1.0, frame / max(frame, self._arrival - now + frame))
        px, py = self._place(mass)
        for body in bodies:
            body.lead(mass, (px + (x - px) * share, py + (y - py) * share))

    def _place(self, mass: int) -> tuple[float, float]:
        body = self._bodies()[0]
        simulation = body.simulation if isinstance(body, Recorder) else body
        x, y = simulation.positions[mass].tolist()
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
    return min(max(coordinate, -FARTHEST), FARTHEST)
