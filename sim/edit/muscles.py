"""Adding muscles to springs and joints, changing and removing them."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar, cast

import msgspec

from ..errors import SettingError
from ..scene.parts import AngularSpring, Beat, JointMuscle, LinearSpring, SpringMuscle, Wave
from ..scene.types import Scene, is_muscular
from ..scene.validate import number_range
from ..text import Text
from .edit import Edit, Selection, changed, counted, of_parts, refuse_missing

DECIMALS = 9
"""Decimals to which amplitudes and phases are rounded, since they may be changed in steps."""

P = TypeVar("P", LinearSpring, AngularSpring)
M = TypeVar("M", SpringMuscle, JointMuscle)


def muscles_of(scene: Scene, parts: Selection) -> Selection:
    """Return those of some springs and joints that have a muscle.

    Raises:
        SceneError: one of them does not exist.
    """
    refuse_missing(parts.springs, len(scene.linear_springs), "spring")
    refuse_missing(parts.joints, len(scene.angular_springs), "joint")
    springs = frozenset(s for s in parts.springs if scene.linear_springs[s].muscle)
    return Selection(
        springs=springs, joints=frozenset(j for j in parts.joints if scene.angular_springs[j].muscle)
    )


def give_muscles(scene: Scene, parts: Selection) -> Edit:
    """Add a muscle to each of some springs and joints without one, and a beat if the scene has none.

    Raises:
        SettingError: none of them lacks one.
        SceneError: one of them does not exist.
    """
    have = muscles_of(scene, parts)
    springs, joints = parts.springs - have.springs, parts.joints - have.joints
    if not (springs or joints):
        raise SettingError(Text("select springs or joints that are to have a muscle"))
    scene = of_parts(scene)
    given = msgspec.structs.replace(
        scene,
        linear_springs=changed(
            scene.linear_springs, ((s, _with(scene.linear_springs[s], SpringMuscle())) for s in springs)
        ),
        angular_springs=changed(
            scene.angular_springs, ((j, _with(scene.angular_springs[j], JointMuscle())) for j in joints)
        ),
        beat=scene.beat or Beat(),
    )
    return Edit(f"{counted(len(springs) + len(joints), 'muscle')} added", given)


def toggle_muscles(scene: Scene, parts: Selection) -> Edit:
    """Add muscles to those of some springs and joints without one; if all have one, remove them.

    Raises:
        SettingError: no springs or joints are given.
        SceneError: one of them does not exist.
    """
    have = muscles_of(scene, parts)
    every = (have.springs or have.joints) and have == parts._replace(masses=frozenset())
    return (take_muscles if every else give_muscles)(scene, parts)


def take_muscles(scene: Scene, parts: Selection) -> Edit:
    """Remove the muscles of some springs and joints; without any muscle left, the beat is removed, too.

    Raises:
        SettingError: none of them has one.
        SceneError: one of them does not exist.
    """
    have = _having(scene, parts)
    scene = of_parts(scene)
    left = msgspec.structs.replace(
        scene,
        linear_springs=changed(
            scene.linear_springs, ((s, _with(scene.linear_springs[s], None)) for s in have.springs)
        ),
        angular_springs=changed(
            scene.angular_springs, ((j, _with(scene.angular_springs[j], None)) for j in have.joints)
        ),
    )
    if not is_muscular(left):
        left = msgspec.structs.replace(left, beat=msgspec.UNSET)
    return Edit(f"{counted(len(have.springs) + len(have.joints), 'muscle')} removed", left)


def move_muscles(scene: Scene, parts: Selection, later: float, stretch: float, turn: float) -> Edit:
    """Shift the muscles of some springs and joints along the beat and change their amplitudes, all equally.

    Args:
        scene: the scene.
        parts: the springs and joints; those without a muscle do not change.
        later: beats by which each reaches its peak later.
        stretch: added to the amplitudes of springs, which stay within their range.
        turn: degrees added to the amplitudes of joints, which stay within theirs.

    Raises:
        SettingError: none of them has a muscle.
        SceneError: one of them does not exist.
    """
    most_stretch = number_range(SpringMuscle, "amplitude")[1]
    most_turn = number_range(JointMuscle, "amplitude")[1]

    def moved(muscle: M, by: float, most: float) -> M:
        amplitude = min(max(round(muscle.amplitude + by, DECIMALS), -most), most)
        phase = _in_turn(muscle.phase - 360.0 * muscle.per_beat * later)
        return msgspec.structs.replace(muscle, phase=phase, amplitude=amplitude)

    return _changed(
        scene,
        parts,
        "moved",
        lambda muscle: moved(muscle, stretch, most_stretch),
        lambda muscle: moved(muscle, turn, most_turn),
    )


def shape_muscles(
    scene: Scene, parts: Selection, wave: Wave | None = None, per_beat: int | None = None
) -> Edit:
    """Change the wave, or the number of waves per beat, of the muscles of some springs and joints.

    Each reaches its peak when it did before, or one of its waves does.

    Raises:
        SettingError, SceneError: as `move_muscles`.
    """

    def shaped(muscle: M) -> M:
        muscle = msgspec.structs.replace(muscle, wave=muscle.wave if wave is None else wave)
        if per_beat is None:
            return muscle
        return with_crest(msgspec.structs.replace(muscle, per_beat=per_beat), crest(muscle))

    return _changed(scene, parts, "changed", shaped, shaped)


def spread_muscles(scene: Scene, parts: Selection) -> Edit:
    """Spread the muscles of some springs and joints evenly over a beat: springs in their order, and joints in
    theirs.

    Raises:
        SettingError, SceneError: as `move_muscles`.
    """
    have = _having(scene, parts)

    def phases(indices: frozenset[int]) -> dict[int, float]:
        """Return the parts of the beat at which they peak, the first when the beat begins."""
        count = len(indices)
        return {index: k / count for k, index in enumerate(sorted(indices))}

    springs, joints = phases(have.springs), phases(have.joints)
    return _changed_each(
        scene,
        have,
        "spread",
        lambda muscle, s: with_crest(muscle, springs[s]),
        lambda muscle, j: with_crest(muscle, joints[j]),
    )


def crest(muscle: SpringMuscle | JointMuscle) -> float:
    """Return the part of a beat at which a muscle's wave first peaks: 0..1, below 1 / per_beat."""
    return (90.0 - muscle.phase) % 360.0 / 360.0 / muscle.per_beat


def with_crest(muscle: M, at: float) -> M:
    """Return the muscle with the peak of its wave at a part of the beat."""
    return msgspec.structs.replace(muscle, phase=_in_turn(90.0 - 360.0 * muscle.per_beat * at))


# ------------------------------------------------------------------------- inside
def _in_turn(phase: float) -> float:
    """Return a phase, degrees, wrapped to 0..360 and without rounding errors."""
    return round(phase % 360.0, DECIMALS) % 360.0


def _having(scene: Scene, parts: Selection) -> Selection:
    have = muscles_of(scene, parts)
    if not (have.springs or have.joints):
        raise SettingError(Text("no muscle is selected"))
    return have


def _changed(
    scene: Scene,
    parts: Selection,
    label: str,
    spring: Callable[[SpringMuscle], SpringMuscle],
    joint: Callable[[JointMuscle], JointMuscle],
) -> Edit:
    return _changed_each(
        scene, parts, label, lambda muscle, _: spring(muscle), lambda muscle, _: joint(muscle)
    )


def _changed_each(
    scene: Scene,
    parts: Selection,
    label: str,
    spring: Callable[[SpringMuscle, int], SpringMuscle],
    joint: Callable[[JointMuscle, int], JointMuscle],
) -> Edit:
    have = _having(scene, parts)
    scene = of_parts(scene)
    springs = [(s, scene.linear_springs[s]) for s in have.springs]
    joints = [(j, scene.angular_springs[j]) for j in have.joints]
    new = msgspec.structs.replace(
        scene,
        linear_springs=changed(
            scene.linear_springs,
            ((s, _with(part, spring(cast(SpringMuscle, part.muscle), s))) for s, part in springs),
        ),
        angular_springs=changed(
            scene.angular_springs,
            ((j, _with(part, joint(cast(JointMuscle, part.muscle), j))) for j, part in joints),
        ),
    )
    return Edit(f"{counted(len(springs) + len(joints), 'muscle')} {label}", new)


def _with(part: P, muscle: SpringMuscle | JointMuscle | None) -> P:
    return msgspec.structs.replace(part, muscle=msgspec.UNSET if muscle is None else muscle)
