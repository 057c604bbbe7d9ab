"""What a page shows of the body of another page, where it has none of its own.

A picture is encoded once, and goes to all pages that look on at the same time, beside viser's queues: thirty
pages cost little more than one. All else that a page has to know goes by its mail, in order, as ever.
"""

from __future__ import annotations

import numpy as np
import viser

from app.classroom.live import Front
from sim.scene.types import shown_name

from ... import viser_inside as viser_inside
from ...stage.plan import encode_frame
from ...stage.sketch import Mapping, world_size
from ...ui.view import STILL, Canvas
from ...wire.carrier import Mail, encoded
from ...wire.to_page import Frame, PageState

SURE_EVERY = 1.0
"""Seconds after which a page is sent the picture by its mail, too: one that was slow has missed some."""


class FrontView:
    """What one page shows of the teacher's body.

    Args:
        client: the page.
        mail: to its script.
        canvas: its picture.
        page: its number.
    """

    def __init__(self, client: viser.ClientHandle, mail: Mail, canvas: Canvas, page: str) -> None:
        self._client, self._mail, self._canvas, self._page = client, mail, canvas, page
        self._told: tuple[int, bool, float] | None = None
        self._sure: Front | None = None
        self._sure_due = 0.0
        self._audience: set[viser.ClientHandle] = set()

    def show(self, front: Front, dark: bool, now: float) -> bool:
        """Show it, as far as the page does not yet; returns whether the page was told anything.

        Args:
            front: what the teacher's page shows.
            dark: whether the page is dark.
            now: wall time, s.
        """
        state = front.number, front.playing, front.speed
        is_sure = front is self._sure or (travels(front) and now < self._sure_due)
        if is_sure and state == self._told:
            return False
        with self._client.atomic():
            if self._told is None or self._told[0] != front.number:
                self._canvas.build(front.scene, dark, front.rest_angles, front.number)
            self._canvas.draw(front.picture, now, force=True)
            self._sure, self._sure_due = front, now + SURE_EVERY
            self._mail.send(_state(front, self._page))
        self._told = state
        if front.audience is not self._audience:
            self._audience.discard(self._client)
            self._audience = front.audience
        self._audience.add(self._client)
        return True

    def leave(self) -> None:
        """The page shows something else, or is gone."""
        self._audience.discard(self._client)
        self._told = self._sure = None


def travels(front: Front) -> bool:
    """Whether its pictures go to all pages at once: those of a body in motion of which nothing has broken."""
    return front.playing and front.picture.ghost is None and front.picture.damage is None


def send(front: Front, now: float) -> None:
    """Send its picture to all pages that look on; `now` is wall time, s."""
    if front.audience and travels(front):
        frame = Frame(numbers=encode_frame(front.number, front.picture), wall=round(now, 4))
        viser_inside.send_at_once(tuple(front.audience), viser_inside.batch(encoded(frame)))


def looks_alike(before: Front, after: Front) -> bool:
    """Whether nobody can tell from each other what two of them show; of what stands still, exactly."""
    then, now = before.picture, after.picture
    if (before.number, before.playing, before.speed) != (after.number, after.playing, after.speed):
        return False
    if then.damage != now.damage or then.ghost_broken != now.ghost_broken:
        return False
    if (then.ghost is None) != (now.ghost is None):
        return False
    if then.ghost is not None and now.ghost is not None:
        return not after.playing and then.time == now.time and np.array_equal(then.ghost, now.ghost)
    moved = np.abs(now.positions - then.positions).max(initial=0.0)
    turned = abs(now.rest_angle_shift - then.rest_angle_shift)
    grown = abs(now.rest_length_scale / then.rest_length_scale - 1.0)
    if not after.playing:
        return then.time == now.time and not (moved or turned or grown)
    return bool(moved < STILL / (100.0 * Mapping.of(after.scene).scale) and turned < 0.5 and grown < 1e-3)


def _state(front: Front, page: str) -> PageState:
    """How things are on a page that only looks on."""
    scene = front.scene
    width, height = world_size(scene)
    return PageState(
        page=page,
        scene=-1 - front.opening,  # no number of one that the page itself opens
        title=shown_name(scene),
        width=width,
        height=height,
        unit=scene.view.unit,
        playing=front.playing,
        speed=front.speed,
    )
