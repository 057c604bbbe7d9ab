"""What a page shows of the body of another page, while it has none of its own.

A picture is encoded once, and sent to all lines that look at it at the same time: thirty pages cost little
more than one. Everything else reaches a page by its mail, in order, as always.
"""

from __future__ import annotations

from typing import Protocol

import numpy as np

from app.classroom.live import SharedView
from sim import Scene

from ...session.framing import Bounds
from ...stage.pictures import STILL
from ...stage.plan import Picture, encode_frame
from ...stage.sketch import Floats, Mapping, world_size
from ...wire.carrier import Mail, encoded
from ...wire.line import Line, send_at_once
from ...wire.to_page import Frame, PageState
from ...words.english import name_of

RESYNC_EVERY = 1.0
"""Seconds after which a page is also sent the picture by its mail: a slow page has missed some."""


class Drawing(Protocol):
    """What draws a page's picture; see `Pictures`."""

    def build(
        self, scene: Scene, dark: bool, rest_angles: Floats | None = None, number: int | None = None
    ) -> object:
        """Draw another scene from now on."""
        ...

    def draw(self, picture: Picture, now: float, exactly: bool = False) -> bool:
        """Draw where its masses are."""
        ...


class Onlooker:
    """A page that looks at the body of another one.

    Args:
        mail: to the page's script.
        drawing: draws its picture.
        page: its number.
        line: its connection, by which it gets pictures that are encoded once for all; None for a page of
            viser's, which gets each by its mail.
    """

    def __init__(self, mail: Mail, drawing: Drawing, page: str, line: Line | None = None) -> None:
        self._mail, self._drawing, self._page, self._line = mail, drawing, page, line
        self._state: tuple[int, bool, float, bool] | None = None
        self._synced: SharedView | None = None
        self._sync_due = 0.0
        self._audience: set[Line] = set()

    def show(self, view: SharedView, dark: bool, now: float, bounds: Bounds | None = None) -> bool:
        """Send what the page does not have yet; return whether there was anything.

        Args:
            view: of the other page.
            dark: whether the page is dark.
            now: wall time, s.
            bounds: (2, 2) px, where its body moves; None if that is not known.
        """
        state = view.number, view.playing, view.speed, bounds is not None
        broadcast = self._line is not None and is_broadcast(view)
        is_synced = view is self._synced or (broadcast and now < self._sync_due)
        if is_synced and state == self._state:
            return False
        if self._state is None or self._state[0] != view.number:
            self._drawing.build(view.scene, dark, view.rest_angles, view.number)
        self._drawing.draw(view.picture, now, exactly=True)
        self._synced, self._sync_due = view, now + RESYNC_EVERY
        self._mail.send(_page_state(view, self._page, bounds))
        self._state = state
        if self._line is not None:
            if view.audience is not self._audience:
                self._audience.discard(self._line)
                self._audience = view.audience
            self._audience.add(self._line)
        return True

    def leave(self) -> None:
        """Stop looking: the page shows something else, or is gone."""
        if self._line is not None:
            self._audience.discard(self._line)
        self._state = self._synced = None


def is_broadcast(view: SharedView) -> bool:
    """Whether its pictures are sent to all pages at once: those of a moving body with nothing broken."""
    return view.playing and view.picture.ghost is None and view.picture.damage is None


def broadcast(view: SharedView, now: float) -> None:
    """Send its picture to all pages that look at it; `now` is wall time, s."""
    if view.audience and is_broadcast(view):
        frame = Frame(numbers=encode_frame(view.number, view.picture), wall=round(now, 4))
        send_at_once(view.audience, encoded(frame))


def same_view(before: SharedView, after: SharedView) -> bool:
    """Whether two views cannot be told apart; of bodies at rest in time, whether they are equal."""
    then, now = before.picture, after.picture
    if (before.number, before.playing, before.speed) != (after.number, after.playing, after.speed):
        return False
    if then.damage != now.damage or then.ghost_broken != now.ghost_broken:
        return False
    if then.ghost is None or now.ghost is None:
        if then.ghost is not now.ghost:
            return False
    else:
        return not after.playing and then.time == now.time and np.array_equal(then.ghost, now.ghost)
    moved = np.abs(now.positions - then.positions).max(initial=0.0)
    turned = abs(now.rest_angle_shift - then.rest_angle_shift)
    grown = abs(now.rest_length_scale / then.rest_length_scale - 1.0)
    if not after.playing:
        return then.time == now.time and not (moved or turned or grown)
    return bool(moved < STILL / (100.0 * Mapping.of(after.scene).scale) and turned < 0.5 and grown < 1e-3)


def _page_state(view: SharedView, page: str, bounds: Bounds | None) -> PageState:
    """Return the state of a page that only looks."""
    scene = view.scene
    width, height = world_size(scene)
    return PageState(
        page=page,
        scene=-1 - view.opening,  # no number of a scene that the page itself opens
        title=name_of(scene),
        width=width,
        height=height,
        view=() if bounds is None else Mapping.of(scene).box(bounds),
        unit=scene.view.unit,
        playing=view.playing,
        speed=view.speed,
    )
