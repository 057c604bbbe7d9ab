"""Match the columns of measurements with quantities of a scene."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass

from ..errors import InputError
from ..motion.quantities import COUNTED, Quantity, quantity
from ..scene.types import Scene
from ..text import Text
from .measurements import Column, Measurement, of_column
from .units import Unit, known_scale, unit_of

_EXPRESSION = re.compile(
    r"\s*(?:([-+]?\d+(?:\.\d*)?)\s*(?=[-+]))?\s*([-+]?)\s*([a-z]+(?:\d+|\[[\d.,]+\])?\.[a-z_]+)\s*", re.ASCII
)
_WHICH = re.compile(r"(?:(?P<group>.*?)\s+)?(?P<what>\D+?)[ _]?(?P<number>\d{1,6})?", re.ASCII | re.DOTALL)
_LETTER = re.compile(r"(?:mass|point|masse|punkt)[ _]?([a-z])", re.IGNORECASE | re.ASCII)

_OF_MASSES = {
    **dict.fromkeys(("x", "position x", "x position", "pos x"), "x"),
    **dict.fromkeys(("y", "position y", "y position", "pos y", "height", "höhe"), "y"),
    **dict.fromkeys(("vx", "v_x", "velocity x"), "vx"),
    **dict.fromkeys(("vy", "v_y", "velocity y"), "vy"),
    **dict.fromkeys(("v", "speed"), "speed"),
    **dict.fromkeys(("ax", "a_x", "acceleration x", "linear acceleration x"), "ax"),
    **dict.fromkeys(("ay", "a_y", "acceleration y", "linear acceleration y"), "ay"),
}
_ANGLES = ("angle", "theta", "θ", "phi", "φ", "winkel")
_OF_SPRINGS = {
    **dict.fromkeys(("force", "f", "kraft"), "force"),
    **dict.fromkeys(("length", "l", "länge"), "length"),
}


@dataclass(frozen=True, eq=False)
class Match:
    """A column matched with a quantity: it measures `offset + sign * quantity`, in the scene's units.

    Attributes:
        column: the measured values.
        quantity: the scene's quantity.
        sign: 1 or -1.
        offset: in the quantity's unit.
        unit: the unit of the column.
        scale: number of the scene's length units in the unit's length; None if unknown.
    """

    column: Column
    quantity: Quantity
    sign: float
    offset: float
    unit: Unit
    scale: float | None

    @property
    def text(self) -> str:
        """The match as it was written."""
        offset = f"{self.offset:g} " if self.offset else ""
        sign = "-" if self.sign < 0.0 else "+" if self.offset else ""
        return f"{offset}{sign}{' ' if self.offset else ''}{self.quantity.name}"


def matched(
    measurement: Measurement, scene: Scene, match: Mapping[str, str] | None = None
) -> tuple[Match, ...]:
    """Return the columns that are quantities of a scene, by their names or as given.

    Args:
        measurement: the table.
        scene: the scene with the quantities.
        match: quantities by column name, as in "mass1.x", "-mass1.y", "90 - spring0.direction" or a formula;
            an empty text leaves a column out, and columns not named are left out, too. None for the result of
            `guesses`.

    Raises:
        InputError: there is no such column or quantity, a unit does not fit its quantity, or no column is a
            quantity.
    """
    wanted = guesses(measurement, scene) if match is None else match
    found = []
    for name, text in wanted.items():
        column = measurement.column(name)
        if text.strip():
            found.append(_match(measurement, column, text, scene))
    if not found:
        known = ", ".join(column.name for column in measurement.columns) or Text("none")
        raise InputError(
            Text(
                "{measurement}: say which quantity each column is; of its columns ({known}) "
                "none tells it by its name",
                measurement=measurement.name,
                known=known,
            )
        )
    return tuple(found)


def _match(measurement: Measurement, column: Column, text: str, scene: Scene) -> Match:
    parts = _EXPRESSION.fullmatch(text)
    offset, sign, name = parts.groups() if parts else ("", "", text)
    try:
        found = quantity(name, scene)
        if found.kind.of == "mass" and found.index in {anchor.mass for anchor in scene.anchors}:
            raise InputError(Text("mass {mass} is held, so that it tells nothing", mass=found.index))
        unit = unit_of(column.unit, found.kind.unit, scene.view.unit)
    except InputError as error:
        raise InputError(of_column(measurement.name, column.name, str(error))) from None
    return Match(
        column,
        found,
        -1.0 if sign == "-" else 1.0,
        float(offset or 0.0),
        unit,
        known_scale(unit, scene.view.unit),
    )


def guesses(measurement: Measurement, scene: Scene) -> dict[str, str]:
    """Guess the quantity of each column from its name; an empty text where the name gives none.

    Names of quantities stand for themselves, as in softrod's own tables. "x", "vy", "angle", "force" and the
    like refer to the last free mass, the joint or spring next to it, or the part named by a number or letter.
    Where the scene's y axis points down, "y" is assumed to point up, as in Tracker.
    """
    own = {column.name for column in measurement.columns} >= {"step", "x0", "y0"}
    return {column.name: _guess(column, scene, own) for column in measurement.columns}


def _guess(column: Column, scene: Scene, own: bool) -> str:
    held = {anchor.mass for anchor in scene.anchors}
    try:
        found = quantity(column.name, scene)
    except InputError:
        pass
    else:
        return "" if found.kind.of == "mass" and found.index in held else found.name
    text = _guessed_text(column.name.strip().lower(), scene, own)
    if not text:
        return ""
    name = text.split()[-1].lstrip("-")
    try:
        unit_of(column.unit, quantity(name, scene).kind.unit, scene.view.unit)
    except InputError:
        return ""
    return text


def _guessed_text(name: str, scene: Scene, own: bool) -> str:
    letter = _LETTER.match(name)
    base = name[letter.end() :].strip() if letter else name
    parts = _WHICH.fullmatch(base)
    if parts is None:
        return ""
    what, number = parts["what"].strip(), parts["number"]
    if parts["group"] and f"{parts['group']} {what}" in _OF_MASSES:
        what = f"{parts['group']} {what}"
    held = {anchor.mass for anchor in scene.anchors}
    free = [i for i in range(len(scene.masses)) if i not in held]
    if not free:
        return ""
    mass = free[-1]
    if number:
        mass = int(number)
    elif letter and ord(letter.group(1).lower()) - ord("a") < len(free):
        mass = free[ord(letter.group(1).lower()) - ord("a")]
    if what in _OF_MASSES and mass in free:
        found = _OF_MASSES[what]
        flipped = scene.view.y_down and not own and found in ("y", "vy", "ay")
        return f"{'-' if flipped else ''}mass{mass}.{found}"
    springs = [s for s, each in enumerate(scene.linear_springs) if mass in (each.a, each.b)]
    spring = int(number) if number else springs[0] if springs else 0
    if what in _OF_SPRINGS and spring < COUNTED["spring"](scene):
        return f"spring{spring}.{_OF_SPRINGS[what]}"
    if what in _ANGLES:
        joint = int(number or 0)
        if joint < COUNTED["joint"](scene):
            return f"joint{joint}.angle"
        if spring < COUNTED["spring"](scene):
            # 0 when hanging, and increasing towards +x.
            hangs_from_first = (
                scene.linear_springs[spring].a in held or scene.linear_springs[spring].b not in held
            )
            if hangs_from_first:
                return f"90 {'-' if scene.view.y_down else '+'} spring{spring}.direction"
    return ""
