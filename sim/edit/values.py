"""The numbers of single masses, springs and joints."""

from __future__ import annotations

import math
from collections.abc import Collection
from dataclasses import dataclass
from typing import Any, Literal

import msgspec
import numpy as np

from ..errors import Part, SettingError, out_of_range
from ..forces.muscles import swings
from ..motion.moment import Moment
from ..scene.columns import column
from ..scene.parts import AngularSpring, JointMuscle, LinearSpring, Mass, Motor, Muscle, SpringMuscle
from ..scene.types import Damage, Scene
from ..scene.validate import number_range
from ..text import Text
from ..text import number as shown
from .build import angle_between, positions_of, wrapped_degrees
from .edit import Edit, Selection, changed, counted, of_parts, refuse_missing
from .shape import move

Kind = Literal["masses", "linear_springs", "angular_springs"]
"""The field of a scene with the parts."""

_TYPES: dict[Kind, type] = {
    "masses": Mass,
    "linear_springs": LinearSpring,
    "angular_springs": AngularSpring,
}
_WORDS: dict[Kind, Part] = {"masses": "mass", "linear_springs": "spring", "angular_springs": "joint"}


@dataclass(frozen=True)
class Number:
    """A number of each part of a kind.

    Attributes:
        kind, field: where it is; a path such as "muscle.phase" applies only to parts that have it.
        label, unit: for people.
        low, high: its range.
        optional: whether a part may lack it.
        axis: for vectors, 0 for x and 1 for y; None for a scalar.
        whole: whether it is a whole number.
    """

    kind: Kind
    field: str
    label: str
    unit: str
    low: float
    high: float
    optional: bool = False
    axis: int | None = None
    whole: bool = False

    def of_part(self, part: Any) -> float | None:
        """Return the number of a part."""
        if "." in self.field:
            owner, field = self.field.split(".")
            return getattr(getattr(part, owner) or None, field, None)
        value = getattr(part, self.field)
        return value if self.axis is None else (value or (0.0, 0.0))[self.axis]

    def replaced(self, part: Any, value: float | None) -> Any:
        """Return the part with another number."""
        new: Any = value
        if "." in self.field:
            owner, field = self.field.split(".")
            if not (has := getattr(part, owner)):
                return part
            new = msgspec.structs.replace(has, **{field: int(new) if self.whole else new})
            return msgspec.structs.replace(part, **{owner: new})
        if self.axis is not None:
            vector: list[Any] = list(getattr(part, self.field) or (0.0, 0.0))
            vector[self.axis] = value
            if self.field == "force" and not any(vector):
                # A zero force is unset, so that removing the last force restores a body without any.
                return msgspec.structs.replace(part, force=msgspec.UNSET, keys=msgspec.UNSET)
            new = tuple(vector)
        return msgspec.structs.replace(part, **{self.field: new})


def _number(kind: Kind, field: str, label: str, optional: bool = False, axis: int | None = None) -> Number:
    low, high, unit = number_range(_TYPES[kind], field)
    return Number(kind, field, label, unit, low, high, optional, axis)


def _of_muscle(kind: Kind, muscle: type[Muscle], field: str, label: str, whole: bool = False) -> Number:
    low, high, unit = number_range(muscle, field)
    return Number(kind, f"muscle.{field}", label, unit, low, high, whole=whole)


def _of_motor(field: str, label: str) -> Number:
    low, high, unit = number_range(Motor, field)
    return Number("angular_springs", f"motor.{field}", label, unit, low, high)


NUMBERS = (
    _number("masses", "mass", Text("Mass")),
    _number("masses", "radius", Text("Radius")),
    _number("masses", "force", Text("Force x"), axis=0),
    _number("masses", "force", Text("Force y"), axis=1),
    _number("linear_springs", "stiffness", Text("Stiffness")),
    _number("linear_springs", "damping", Text("Damping")),
    _number("linear_springs", "rest_length", Text("Rest length")),
    _number("linear_springs", "strength", Text("Strength"), optional=True),
    _number("linear_springs", "yield_force", Text("Yield force"), optional=True),
    _number("linear_springs", "hardening", Text("Hardening")),
    _number("angular_springs", "stiffness", Text("Joint stiffness")),
    _number("angular_springs", "damping", Text("Joint damping")),
    _number("angular_springs", "rest_angle", Text("Rest angle")),
    _number("angular_springs", "yield_torque", Text("Yield torque"), optional=True),
    _of_muscle("linear_springs", SpringMuscle, "amplitude", Text("Muscle amplitude")),
    _of_muscle("linear_springs", SpringMuscle, "phase", Text("Muscle phase")),
    _of_muscle("linear_springs", SpringMuscle, "per_beat", Text("Muscle waves per beat"), whole=True),
    _of_muscle("angular_springs", JointMuscle, "amplitude", Text("Joint muscle amplitude")),
    _of_muscle("angular_springs", JointMuscle, "phase", Text("Joint muscle phase")),
    _of_muscle("angular_springs", JointMuscle, "per_beat", Text("Joint muscle waves per beat"), whole=True),
    _of_motor("speed", Text("Motor speed")),
    _of_motor("torque", Text("Motor torque")),
)
"""Every number that can be set for single parts."""

STARTS = (
    _number("masses", "position", Text("Start x"), axis=0),
    _number("masses", "position", Text("Start y"), axis=1),
)
"""Start positions of masses, in the saved pose if there is one: of several the middle; they move together."""


def number(kind: str, field: str) -> Number:
    """Return one of `NUMBERS`.

    Raises:
        SettingError: there is none of that name.
    """
    for each in NUMBERS:
        if (each.kind, each.field) == (kind, field):
            return each
    known = ", ".join(f"{each.kind}.{each.field}" for each in NUMBERS)
    raise SettingError(
        Text("{where}: there is no such number; there are {known}", where=f"{kind}.{field}", known=known)
    )


def values_of(scene: Scene, of: Number, parts: Collection[int]) -> set[float | None]:
    """Return the different values that some parts have."""
    if of.axis is not None or "." in of.field:
        every = getattr(scene, of.kind)
        return {of.of_part(every[i]) for i in parts}
    found = np.unique(column(getattr(scene, of.kind), of.field)[list(parts)])
    return {None if math.isnan(value) else value for value in found.tolist()}


def set_number(
    scene: Scene, of: Number, parts: Collection[int], value: float | None, shift: float = 0.0
) -> Edit:
    """Set a number of some parts to the same value; None removes it where it is optional.

    Args:
        scene: the scene with the parts.
        of: the number.
        parts: their indices.
        value: the new value.
        shift: degrees that keys have added to all rest angles since the scene was last set; the value of a
            rest angle includes them.

    Raises:
        SettingError: the value is out of range, or the number contradicts the others of a part.
        SceneError: a part does not exist.
    """
    _refuse_value(of, value)
    if of.field == "rest_angle" and value is not None:
        value = _turned(value, -shift)
    return _with_values(scene, of, dict.fromkeys(parts, value), f"{of.label} set")


@dataclass(frozen=True)
class Way:
    """How parts of a kind can be set to act.

    Attributes:
        kind: the kind of part.
        verb: such as "touch".
        field: of the part.
        words: for people, by the name of each choice; "" for what parts do unless something is set.
        values: of the field, by the name of each choice but "".
    """

    kind: Kind
    verb: str
    field: str
    words: dict[str, str]
    values: dict[str, Any]

    def of_part(self, part: Any) -> str:
        """Return the name of how a part acts; of a direction that has no name, the nearest one's."""
        value = getattr(part, self.field)
        if self.field == "rail" and value:
            return max(self.values, key=lambda name: abs(np.dot(self.values[name], value)))
        if self.field == "motor" and value:
            return value.keys or "motor"
        if self.field == "muscle":
            return f"steady {value.keys}" if value.wave == "steady" else value.keys or ""
        return next((name for name, each in self.values.items() if value == each), "")


_ONLY = "act", "only"
_BY_KEYS = {
    "left-right": "with the keys Left and Right",
    "up-down": "with the keys Up and Down",
}
_WORK = {
    "": "to the beat",
    **{keys: f"to the beat, {words}" for keys, words in _BY_KEYS.items()},
    **{f"steady {keys}": f"steadily, {words}" for keys, words in _BY_KEYS.items()},
}
WAYS: dict[str, Way] = {
    "touch": Way("masses", "touch", "solid", {"": "no other mass", "solid": "other balls"}, {"solid": True}),
    "move": Way(
        "masses",
        "move",
        "rail",
        {"": "freely", "level": "to and fro on a rail", "upright": "up and down on a rail"},
        {"level": (1.0, 0.0), "upright": (0.0, 1.0)},
    ),
    "springs": Way(
        "linear_springs",
        *_ONLY,
        {"": "both ways", "pull": "pulls only", "push": "pushes only"},
        {"pull": "pull", "push": "push"},
    ),
    "joints": Way(
        "angular_springs",
        *_ONLY,
        {"": "on both sides", "above": "above its angle only", "below": "below its angle only"},
        {"above": "above", "below": "below"},
    ),
    "turn": Way(
        "angular_springs",
        "turn",
        "motor",
        {
            "": "freely",
            "motor": "by a motor",
            **{keys: f"by a motor, {words}" for keys, words in _BY_KEYS.items()},
        },
        {"motor": Motor(), "left-right": Motor(keys="left-right"), "up-down": Motor(keys="up-down")},
    ),
    "forces": Way(
        "masses", "are pushed", "keys", {"": "always", **_BY_KEYS}, {keys: keys for keys in _BY_KEYS}
    ),
    "muscles": Way("linear_springs", "work", "muscle", _WORK, {}),
    "joint muscles": Way("angular_springs", "work", "muscle", _WORK, {}),
}
"""How parts can be set to act; muscles only where they are."""


def acting(scene: Scene, way: Way, parts: Collection[int]) -> Collection[int]:
    """Return those of some parts that can act in a way: of springs and joints for muscles, those with one."""
    if way.field != "muscle":
        return parts
    every = getattr(scene, way.kind)
    return [i for i in parts if every[i].muscle]


def ways_of(scene: Scene, way: Way, parts: Collection[int]) -> set[str]:
    """Return the names of the different ways in which some parts act."""
    every = getattr(scene, way.kind)
    return {way.of_part(every[i]) for i in parts}


def set_way(scene: Scene, way: Way, parts: Collection[int], name: str) -> Edit:
    """Let some parts act in a way.

    Args:
        scene: the scene.
        way: one of `WAYS`.
        parts: indices of parts of its kind.
        name: of the choice.

    Raises:
        SettingError: there is no such choice.
        SceneError: a part does not exist.
    """
    if name not in way.words:
        raise SettingError(
            Text("{name!r} is not one of {known}", name=name, known=", ".join(filter(None, way.words)))
        )
    scene = of_parts(scene)
    every = getattr(scene, way.kind)
    refuse_missing(parts, len(every), _WORDS[way.kind])
    parts = acting(scene, way, parts)
    new = [(i, msgspec.structs.replace(every[i], **_fields(scene, every[i], way, name))) for i in parts]
    verb = way.verb if len(parts) > 1 else _SINGULAR.get(way.verb, f"{way.verb}s")
    what = f"{counted(len(parts), _WORDS[way.kind])} {verb} {way.words[name]}"
    return Edit(what, msgspec.structs.replace(scene, **{way.kind: changed(every, new)}))


_SINGULAR = {"touch": "touches", "are pushed": "is pushed"}
_PUSH = 1000.0
"""Acceleration of a mass by a force that it gets with its keys, px/s², without gravity; with gravity twice
that. Doubled or halved, no test fails."""


def _fields(scene: Scene, part: Any, way: Way, name: str) -> dict[str, Any]:
    """Return the fields with which a part acts in a way; a motor, a muscle or a force keeps its numbers."""
    old, value = getattr(part, way.field), way.values.get(name, msgspec.UNSET)
    if way.field == "motor" and old and value:
        value = msgspec.structs.replace(old, keys=value.keys)
    elif way.field == "motor" and value and not part.muscle:
        return {"motor": value, "stiffness": 0.0}  # a joint that holds its angle would hold against it
    if way.field == "muscle":
        wave = "steady" if name.startswith("steady") else "sine" if old.wave == "steady" else old.wave
        value = msgspec.structs.replace(old, keys=name.removeprefix("steady ") or msgspec.UNSET, wave=wave)
    if way.field == "keys" and name and not part.force:
        force = part.mass * (2.0 * math.hypot(*scene.gravity) or _PUSH)
        up = -force if scene.view.y_down else force
        return {"keys": value, "force": (force, 0.0) if name == "left-right" else (0.0, up)}
    return {way.field: value}


def scale_number(
    scene: Scene, of: Number, parts: Collection[int], largest: float, shift: float = 0.0
) -> Edit:
    """Scale a number of some parts so that the largest gets a value and the others keep their ratio to it.

    The largest is that of the largest magnitude; if it is negative, its magnitude gets the value.

    Args:
        scene, of, parts, shift: as in `set_number`.
        largest: the new value of the largest.

    Raises:
        SettingError, SceneError: as `set_number`.
    """
    _refuse_value(of, largest)
    refuse_missing(parts, len(getattr(scene, of.kind)), _WORDS[of.kind])
    every, shift = getattr(scene, of.kind), shift if of.field == "rest_angle" else 0.0
    has = {i: value for i in parts if (value := of.of_part(every[i])) is not None}
    values = {i: _turned(value, shift) for i, value in has.items()}
    old = max(map(abs, values.values()), default=0.0)
    scaled = {i: largest * (value / old) if old else largest for i, value in values.items()}
    for value in scaled.values():
        _refuse_value(of, value)
    new: dict[int, float | None] = {i: _turned(value, -shift) for i, value in scaled.items()}
    return _with_values(scene, of, new, f"{of.label} scaled")


def middle_of_starts(scene: Scene, of: Number, masses: Collection[int]) -> float:
    """Return a coordinate in `STARTS`, px: for several masses, of the centre of their bounding box."""
    starts = scene.pose.positions if scene.pose else [mass.position for mass in scene.masses]
    values = [starts[i][of.axis or 0] for i in masses]
    return (min(values) + max(values)) / 2.0


def set_start(scene: Scene, of: Number, masses: Collection[int], value: float) -> Edit:
    """Move masses together so that their middle starts at a coordinate, one of `STARTS`.

    Their current positions move by the same amount. Springs keep their rest lengths.

    Raises:
        SettingError: the value is out of range.
        SceneError: as `move`.
    """
    _refuse_value(of, value)
    by = value - middle_of_starts(scene, of, masses)
    return move(scene, masses, (by, 0.0) if of.axis == 0 else (0.0, by))


def take_as_rest(moment: Moment, parts: Selection) -> Edit:
    """Make the selected springs and joints rest as they are at a moment; if only masses are selected, all
    those that these move. Parts with muscles also rest as they are then, and continue to move from there.

    Raises:
        SettingError: no springs or joints are affected, or a spring is too long.
    """
    scene, damage, places = of_parts(moment.scene), moment.damage or Damage(), positions_of(moment)
    springs, joints = parts.springs, parts.joints
    if not (springs or joints):
        every, masses = scene.linear_springs, parts.masses
        springs = frozenset(s for s, each in enumerate(every) if each.a in masses or each.b in masses)
        pairs = enumerate(scene.angular_springs)
        joints = frozenset(j for j, each in pairs if each.a in springs or each.b in springs)
    if not (springs or joints):
        raise SettingError(Text("no spring and no joint is selected that could rest as it is"))
    length, angle = number("linear_springs", "rest_length"), number("angular_springs", "rest_angle")
    beat = scene.beat

    def swing(part: LinearSpring | AngularSpring) -> float:
        if not (beat and part.muscle):
            return 0.0
        return float(swings(beat, [part.muscle], moment.steer, moment.time)[0])

    lengths: dict[int, float | None] = {}
    for s in springs:
        spring = scene.linear_springs[s]
        yielded = damage.set_lengths[s] if damage.set_lengths else 0.0
        now = math.dist(places[spring.a], places[spring.b]) - yielded
        lengths[s] = max(now, 0.0) / moment.rest_length_scale / (1.0 + swing(spring))
        _refuse_value(length, lengths[s])
    angles: dict[int, float | None] = {}
    for j in joints:
        joint = scene.angular_springs[j]
        turned = moment.rest_angle_shift + (damage.set_angles[j] if damage.set_angles else 0.0)
        angles[j] = _turned(angle_between(scene, joint.a, joint.b, places), -turned - swing(joint))
    first = _with_values(scene, length, lengths, "")
    return Edit("rest as it is", _with_values(first.scene, angle, angles, "").scene)


def _turned(angle: float, by: float) -> float:
    """Return a rest angle, degrees, turned and wrapped into (-180, 180]; unchanged if it is not turned."""
    return wrapped_degrees(angle + by) if by else angle


def _refuse_value(of: Number, value: float | None) -> None:
    if value is None:
        if not of.optional:
            raise SettingError(Text("{label}: it cannot be left out", label=of.label))
    elif not of.low <= value <= of.high:
        raise SettingError(out_of_range(of.label, shown(value), shown(of.low), shown(of.high), of.unit))
    elif of.whole and value != int(value):
        raise SettingError(Text("{where}: {value:g} is not a whole number", where=of.label, value=value))


def _with_values(scene: Scene, of: Number, values: dict[int, float | None], label: str) -> Edit:
    scene = of_parts(scene)
    refuse_missing(values, len(getattr(scene, of.kind)), _WORDS[of.kind])
    every = getattr(scene, of.kind)
    new = [(i, of.replaced(every[i], value)) for i, value in values.items()]
    for _, part in new:
        _refuse_contradiction(part)
    parts = changed(every, new)
    what = counted(len(values), _WORDS[of.kind])
    return Edit(f"{label}: {what}", msgspec.structs.replace(scene, **{of.kind: parts}))


def _refuse_contradiction(part: Mass | LinearSpring | AngularSpring) -> None:
    """Refuse contradictory numbers, as `sim.scene.validate` does in a file."""
    match part:
        case LinearSpring(yield_force=None, hardening=hardening) if hardening:
            raise SettingError(Text("Hardening: it has no effect on a spring without a yield force"))
        case LinearSpring(yield_force=float(), stiffness=0.0):
            raise SettingError(Text("Stiffness: a spring that yields needs one"))
        case LinearSpring(yield_force=float(limit), strength=float(strength)) if strength < limit:
            raise SettingError(
                Text(
                    "Strength: {strength:g} is below the yield force {limit:g}",
                    strength=strength,
                    limit=limit,
                )
            )
        case AngularSpring(yield_torque=float(), stiffness=0.0):
            raise SettingError(Text("Joint stiffness: a joint that yields needs one"))
        case _:
            pass
