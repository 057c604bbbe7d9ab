"""The numbers of a scene that a fit may change, by name."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from dataclasses import dataclass
from typing import cast

import msgspec

from ..edit.edit import of_parts
from ..edit.values import NUMBERS, set_number
from ..errors import InputError, Part, SettingError, did_you_mean, no_part_of_scene, of_field
from ..motion.quantities import quantity
from ..scene.types import Pose, Scene
from ..settings import set_value, setting_of
from ..text import Text

_PART = re.compile(r"(mass|spring|joint)(\d{1,9})\.([a-z_]+(?:\.[a-z_]+)?)", re.ASCII)
_KINDS = {"mass": "masses", "spring": "linear_springs", "joint": "angular_springs"}
_STARTS = {"x": (0, 0), "y": (0, 1), "vx": (1, 0), "vy": (1, 1)}
"""Start values of a mass: whether it is a velocity, and the axis."""
_SOLVING = ("dt", "tolerance", "template")
"""Settings that control the solver, or are not numbers."""
# Unless noted, doubling or halving one of these numbers fails no test.
_SMALL = 1e-3
"""Starting value of a number that is 0 and cannot be negative, as a fraction of its slider's maximum."""
_REACH = 1e4
"""Largest factor by which a fit changes a number."""
_RADIAN = 57.29577951308232
"""Degrees in a radian."""


@dataclass(frozen=True)
class Parameter:
    """A fitted number as a function of an unbounded variable u: exp(u), or scale * u.

    Attributes:
        name, unit: for people.
        start: the number in the scene; a small one where that is 0 and must not be negative.
        low, high: the range in which it is sought.
        logarithmic: whether it is exp(u).
        scale: the factor of u otherwise.
        write: returns the scene with another number; None if the number is not in the scene.
        spread: whether other starting values are tried.
    """

    name: str
    unit: str
    start: float
    low: float
    high: float
    logarithmic: bool
    scale: float = 1.0
    write: Callable[[Scene, float], Scene] | None = None
    spread: bool = True

    def value(self, u: float) -> float:
        """Return the number for u, clipped to its range."""
        return min(max(self.free(u), self.low), self.high)

    def free(self, u: float) -> float:
        """Return the number for u, regardless of its range."""
        return math.exp(u) if self.logarithmic else self.scale * u

    def u(self, value: float) -> float:
        """Return the u of a number."""
        return math.log(value) if self.logarithmic else value / self.scale


def parameter(name: str, scene: Scene, duration: float) -> Parameter:
    """Return the parameter for a name in `vary`: a setting, see `sim.set_value`; a number of a part, as in
    "mass1.mass", "spring0.stiffness" or "joint0.motor.torque"; or a start value of a mass, as in "mass1.vx".

    Args:
        name: what to vary.
        scene: a valid scene that has it.
        duration: length of the measurement, s, which sets the scale of velocities.

    Raises:
        InputError: there is no such number, or it cannot be fitted.
    """
    if (match := _PART.fullmatch(name)) is not None:
        return _of_part(name, scene, duration, match.group(1), int(match.group(2)), match.group(3))
    try:
        setting = setting_of(scene, name)
    except SettingError as error:
        raise InputError(
            Text(
                "{where}: {error}; or a number of a part, such as mass1.mass or "
                "spring0.stiffness, or of its start, such as mass1.vx",
                where="vary",
                error=str(error),
            )
        ) from None
    if setting.integer or name in _SOLVING:
        raise InputError(Text("{where}: {name} cannot be fitted", where="vary", name=name))

    def write(scene: Scene, value: float) -> Scene:
        return set_value(scene, name, value)

    unit = setting.unit.replace("px", scene.view.unit)
    return _made(
        name, unit, setting.read(scene), setting.low, setting.high, write, _SMALL * setting.slider[1]
    )


def _of_part(name: str, scene: Scene, duration: float, of: str, index: int, what: str) -> Parameter:
    if of == "mass" and what in _STARTS:
        found = quantity(name, scene)
        is_velocity, axis = _STARTS[what]
        if index in {anchor.mass for anchor in scene.anchors}:
            raise InputError(Text("{where}: mass {index} is held", where=f"vary: {name}", index=index))
        start = start_of(scene)[is_velocity][index][axis]
        size = size_of(scene)
        scale = size / duration * math.tau if is_velocity else size
        return Parameter(
            name,
            found.unit,
            start,
            start - 1e3 * scale,
            start + 1e3 * scale,
            False,
            scale,
            lambda scene, value: with_start(scene, {(index, is_velocity, axis): value}),
        )
    fitted = [each for each in NUMBERS if each.kind == _KINDS[of] and each.axis is None and not each.whole]
    numbers = {each.field: each for each in fitted}
    numbers.pop("radius", None)
    if what not in numbers:
        also = ["x", "y", "vx", "vy"] if of == "mass" else []
        there = [*numbers, *also]
        meant, known = did_you_mean(what, there), ", ".join(there)
        raise InputError(
            of_field(
                f"vary: {name}",
                Text("of a mass there are {known}{meant}", known=known, meant=meant)
                if of == "mass"
                else Text("of a spring there are {known}{meant}", known=known, meant=meant)
                if of == "spring"
                else Text("of a joint there are {known}{meant}", known=known, meant=meant),
            )
        )
    parts = getattr(scene, _KINDS[of])
    if index >= len(parts):
        raise InputError(of_field(f"vary: {name}", no_part_of_scene(cast(Part, of), index, len(parts))))
    number = numbers[what]
    value = number.of_part(
        of_parts(scene).masses[index] if of == "mass" else getattr(of_parts(scene), _KINDS[of])[index]
    )
    if value is None:
        has_none = (
            Text("spring {index} has none", index=index)
            if of == "spring"
            else Text("joint {index} has none", index=index)
        )
        raise InputError(of_field(f"vary: {name}", has_none))
    unit = number.unit.replace("px", scene.view.unit)
    largest = max((number.of_part(part) or 0.0 for part in parts), default=0.0)

    def write(scene: Scene, value: float) -> Scene:
        return set_number(scene, number, (index,), value).scene

    return _made(name, unit, value, number.low, number.high, write, _SMALL * max(largest, 1.0))


def _made(
    name: str,
    unit: str,
    value: float,
    low: float,
    high: float,
    write: Callable[[Scene, float], Scene],
    small: float,
) -> Parameter:
    if unit == "°":
        # Angles, after any number of turns.
        return Parameter(name, unit, value, low, high, False, _RADIAN, write)
    if value < 0.0 or (value == 0.0 and low < 0.0):
        scale = abs(value) or 1e6 * small
        return Parameter(
            name,
            unit,
            value,
            max(low, value - _REACH * scale),
            min(high, value + _REACH * scale),
            False,
            scale,
            write,
        )
    start = value or small
    return Parameter(name, unit, start, max(low, start / _REACH), min(high, start * _REACH), True, 1.0, write)


# ------------------------------------------------------------------------- start values of masses
Starts = tuple[list[list[float]], list[list[float]]]


def start_of(scene: Scene) -> Starts:
    """Return the positions and velocities at which the masses start."""
    if scene.pose is not None:
        return [list(p) for p in scene.pose.positions], [list(v) for v in scene.pose.velocities]
    return [list(m.position) for m in scene.masses], [list(m.velocity) for m in scene.masses]


def with_start(scene: Scene, changes: dict[tuple[int, int, int], float]) -> Scene:
    """Return the scene with other start positions (0) or velocities (1), keyed by mass, these, and axis."""
    both = start_of(scene)
    for (mass, of, axis), value in changes.items():
        both[of][mass][axis] = value
    places, velocities = (tuple((x, y) for x, y in each) for each in both)
    damage = scene.pose.damage if scene.pose else None
    return msgspec.structs.replace(scene, pose=Pose(positions=places, velocities=velocities, damage=damage))


def size_of(scene: Scene) -> float:
    """Return the larger side of the bounding box at the start, px."""
    places = start_of(scene)[0]
    return max(max(axis) - min(axis) for axis in zip(*places, strict=True)) or 1.0
