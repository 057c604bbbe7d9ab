"""The axes of a class's plot: what its pupils found over what they set."""

from __future__ import annotations

from msgspec import Struct

import sim
from sim.errors import InputError, SettingError
from sim.motion.quantities import quantity
from sim.scene.lesson import Reading
from sim.settings import CHOICES, setting_of

from ..lessons import reading_text, reading_unit
from ..words.settings import label_of
from .room import Room


class Axes(Struct, frozen=True, kw_only=True):
    """The axes of the class's plot, in words.

    Attributes:
        what, unit: what was found: the ordinate.
        over, over_unit: what the first slider of the step sets: the abscissa.
        turned: whether the ordinate grows downwards.
    """

    what: str = ""
    unit: str = ""
    over: str = ""
    over_unit: str = ""
    turned: bool = False


def first_setting(room: Room, stop: int) -> str:
    """Return the key of the first number that a stop's step has a slider for; empty without one."""
    step = room.step_at(stop)
    controls = step.controls if step is not None else ()
    return next((key for key in controls if key not in CHOICES), "")


def axes_of(room: Room, stop: int) -> Axes:
    """Return the axes of the plot of a stop; empty where its step collects nothing."""
    step, scene = room.step_at(stop), room.scenes[room.stops[stop].scene]
    collect = step.collect if step is not None else None
    if collect is None:
        return Axes()
    over, over_unit = _abscissa(scene, first_setting(room, stop))
    return Axes(
        what=reading_text(collect, scene),
        unit=reading_unit(collect, scene),
        over=over,
        over_unit=over_unit,
        turned=_grows_downwards(collect, scene),
    )


def _abscissa(scene: sim.Scene, key: str) -> tuple[str, str]:
    """Label and unit of what a slider sets, as the slider has them."""
    if not key:
        return "", ""
    try:
        setting = setting_of(scene, key)
    except SettingError:
        return key, ""
    return label_of(setting), setting.unit.replace("px", scene.view.unit)


def _grows_downwards(collect: Reading, scene: sim.Scene) -> bool:
    """Whether it is a y of a scene whose y does."""
    if collect.of == "period" or not scene.view.y_down:
        return False
    try:
        return quantity(collect.quantity, scene).kind.vertical
    except InputError:
        return False
