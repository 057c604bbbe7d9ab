"""The messages that have a page draw a body: its plan, the positions of its masses, and what is broken.

A frame in which nothing moved by a tenth of a pixel is not sent.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import msgspec
import numpy as np
from numpy.typing import NDArray

from sim import Scene, View
from sim.scene.types import Damage as BodyDamage

from ..wire.carrier import Mail
from ..wire.to_page import Damage, Frame, Plan, SecondPlan
from .colors import Palette, blend, palette
from .plan import Picture, broken_of, encode_damage, encode_frame, encode_plan
from .sketch import Floats, Sketch

STILL = 0.1
"""Movement below which a picture counts as unchanged, in pixels of a frame 600 pixels high."""


class Pictures:
    """The pictures of one page.

    Args:
        mail: sends messages to its script.
        sketch: makes the drawing of a scene with a palette; another one for a page that draws by itself,
            without the tone map of viser.

    Attributes:
        sketch: of the body that is drawn; None before the first.
    """

    def __init__(self, mail: Mail, sketch: Callable[[Scene, Palette], Sketch] = Sketch) -> None:
        self._mail, self._sketch = mail, sketch
        self._plan: NDArray[np.float32] | None = None
        self._plan_number = self._own_number = 0
        self._second_plan: NDArray[np.float32] | None = None
        self._view = View()
        self._drawn: Picture | None = None
        self._damaged: Picture | None = None  # the picture whose damage was sent last
        self.sketch: Sketch | None = None

    @property
    def plan_number(self) -> int:
        """The number of the plan that the page has."""
        return self._plan_number

    @property
    def drawn(self) -> Floats | None:
        """(n, 2) positions of the masses in the page's world in the last picture; read-only."""
        picture, sketch = self._drawn, self.sketch
        if picture is None or sketch is None:
            return None
        places = sketch.mapping.to_world(picture.positions)[:, :2]
        places.setflags(write=False)
        return places

    def build(
        self, scene: Scene, dark: bool, rest_angles: Floats | None = None, number: int | None = None
    ) -> Sketch:
        """Send the plan of a scene, as far as it has changed; then call `draw`.

        Args:
            scene: the scene.
            dark: the page is dark.
            rest_angles: (J,) degrees without the arrow keys' shift; None for the scene's own.
            number: number of a plan that other pages have too; None to count its own.
        """
        self._view = scene.view
        self.sketch = sketch = self._sketch(scene, palette(scene.view.colors, dark))
        if rest_angles is None:
            rest_angles = np.array([joint.rest_angle for joint in scene.angular_springs])
        plan = encode_plan(0, sketch, rest_angles)
        known = self._plan is not None and np.array_equal(plan, self._plan)
        if not known or number not in (None, self._plan_number):
            self._plan = plan
            self._own_number += number is None
            self._plan_number = self._own_number if number is None else number
            self._mail.send(Plan(numbers=encode_plan(self._plan_number, sketch, rest_angles)))
            self.forget()
        return sketch

    def build_second(self, second: Scene | None, dark: bool) -> Sketch | None:
        """Send the plan of a second body, or forget it; call it after `build`: both have the same view."""
        if second is None or self.sketch is None:
            if self._second_plan is not None:
                self._second_plan, self._drawn = None, None
            return None
        # Its surroundings are drawn with the first body; nobody drives it.
        still = tuple(msgspec.structs.replace(anchor, driven=False) for anchor in second.anchors)
        alone = msgspec.structs.replace(
            second, view=self._view, walls=(), wind=None, contact=None, anchors=still
        )
        colors = palette(second.view.colors, dark)
        rest = blend(colors.paper, colors.second, np.array([0.6]))[0]
        sketch = self._sketch(alone, replace(colors, mass=colors.second, held=colors.second, rest=rest))
        angles = np.array([joint.rest_angle for joint in second.angular_springs])
        plan = encode_plan(0, sketch, angles)
        if self._second_plan is None or not np.array_equal(plan, self._second_plan):
            self._second_plan, self._drawn = plan, None
            self._mail.send(SecondPlan(numbers=plan))
        return sketch

    def forget(self) -> None:
        """Have the next picture sent whole."""
        self._drawn = self._damaged = None

    def is_drawn(self, picture: Picture, exactly: bool) -> bool:
        """Return True if the last picture is the same, exactly or as far as it is visible."""
        drawn, sketch = self._drawn, self.sketch
        if drawn is None or sketch is None or drawn.positions.shape != picture.positions.shape:
            return False
        if (drawn.ghost is None) != (picture.ghost is None) or not self._same_damage(picture, exactly):
            return False
        moved = np.abs(picture.positions - drawn.positions).max(initial=0.0)
        if drawn.second is not None and picture.second is not None:
            moved = max(moved, np.abs(picture.second.positions - drawn.second.positions).max(initial=0.0))
        elif drawn.second is not picture.second:
            return False
        if drawn.ghost is not None and picture.ghost is not None:
            moved = max(moved, np.abs(picture.ghost - drawn.ghost).max(initial=0.0))
        turned = abs(picture.rest_angle_shift - drawn.rest_angle_shift)
        grown = abs(picture.rest_length_scale / drawn.rest_length_scale - 1.0)
        if exactly:
            return picture.time == drawn.time and not (moved or turned or grown)
        if picture.efforts != drawn.efforts:
            return False
        return bool(moved < STILL * self._pixel and turned < 0.5 and grown < 1e-3)

    def draw(self, picture: Picture, now: float, exactly: bool = False) -> bool:
        """Send a picture if it differs from the last one, and return True if it does.

        Args:
            picture: a picture of the scene that was built last.
            now: wall time, s.
            exactly: send even the smallest movement, so that a paused picture is exact.
        """
        if self.sketch is None or self.is_drawn(picture, exactly):
            return False
        self.send(picture, now, exactly)
        return True

    def send(self, picture: Picture, now: float, exactly: bool) -> None:
        """Send a picture; see `draw`."""
        self._drawn = picture
        if not self._same_damage(picture, exactly):
            self._damaged = picture
            self._mail.send(Damage(numbers=encode_damage(self._plan_number, picture)))
        self._mail.send(Frame(numbers=encode_frame(self._plan_number, picture), wall=round(now, 4)))

    def _same_damage(self, picture: Picture, exactly: bool) -> bool:
        """Return True if the page has this damage, exactly or as far as it is visible."""
        known = self._damaged
        if (known.ghost_broken if known is not None else ()) != picture.ghost_broken:
            return False
        one, other = (known.damage, known.second) if known is not None else (None, None)
        theirs = picture.second.damage if picture.second is not None else None
        return self._near_damage(one, picture.damage, exactly) and self._near_damage(
            other.damage if other is not None else None, theirs, exactly
        )

    def _near_damage(self, known: BodyDamage | None, now: BodyDamage | None, exactly: bool) -> bool:
        if broken_of(known) != broken_of(now):
            return False
        if exactly or known is None or now is None:
            return known == now
        return _near(known.set_lengths, now.set_lengths, STILL * self._pixel) and _near(
            known.set_angles, now.set_angles, 0.5
        )

    @property
    def _pixel(self) -> float:
        """A pixel of a frame 600 pixels long, in px of the scene."""
        return 1.0 / (100.0 * self.sketch.mapping.scale) if self.sketch is not None else 1.0


def _near(before: tuple[float, ...], now: tuple[float, ...], tolerance: float) -> bool:
    """Return True if numbers differ by no more than a tolerance; none at all count as zeros."""
    if before is now:
        return True
    size = max(len(before), len(now))
    one, two = (np.array(numbers or (0.0,) * size) for numbers in (before, now))
    return bool(np.abs(one - two).max(initial=0.0) <= tolerance)
