"""Edits: a new scene, with a record of which of its parts were there before."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple, TypeVar

import msgspec
import numpy as np
from numpy.typing import NDArray

from ..errors import Part, SceneError, no_part
from ..forces.plasticity import leaking
from ..model.system import joint_stiffness
from ..motion.moment import Moment
from ..scene.columns import ends
from ..scene.numbers import MAX_MASSES, MAX_SPRINGS
from ..scene.parts import Anchor, AngularSpring, LinearSpring, Mass
from ..scene.types import Damage, Pose, Scene
from ..text import Text

T = TypeVar("T")
Ended = TypeVar("Ended", LinearSpring, AngularSpring)
Map = tuple[int, ...] | None
"""For each part after an edit, its index before, or -1 if it is new; None if no index changed."""


class Selection(NamedTuple):
    """Some parts of a scene, by their indices.

    Attributes:
        masses, springs, joints: indices of masses, linear springs and angular springs.
    """

    masses: frozenset[int] = frozenset()
    springs: frozenset[int] = frozenset()
    joints: frozenset[int] = frozenset()


@dataclass(frozen=True)
class Edit:
    """A scene made by editing another.

    Attributes:
        label: what was done, in a few words, as in "2 springs removed".
        scene: the new scene, which is valid.
        masses, springs, joints: for each part of the new scene, its index in the old one.
        lost: (4, k) x, y (px), vx, vy (px/s) of masses that are restored by an undo, in their order.
        lost_damage: what had yielded and broken in the new scene before, for springs and joints that are
            restored by an undo.
        shift: (2, n) px by which the edit moves the masses of the new scene, or None.
        stops: whether all masses are at rest after it.
        select: the selection afterwards; None to keep what is selected, as far as it still exists.
    """

    label: str
    scene: Scene
    masses: Map = None
    springs: Map = None
    joints: Map = None
    lost: NDArray[np.float64] | None = None
    lost_damage: Damage | None = None
    shift: NDArray[np.float64] | None = None
    stops: bool = False
    select: Selection | None = None

    @property
    def moves_parts(self) -> bool:
        """Whether parts were added or removed, so that indices before and after differ."""
        return self.masses is not None or self.springs is not None or self.joints is not None


def existing(selection: Selection, scene: Scene) -> Selection:
    """Return those parts of a selection that a scene has."""
    counts = len(scene.masses), len(scene.linear_springs), len(scene.angular_springs)
    there = (
        frozenset(i for i in parts if 0 <= i < count) for parts, count in zip(selection, counts, strict=True)
    )
    return Selection(*there)


def still_selected(edit: Edit, selection: Selection) -> Selection:
    """Return the selection after an edit."""
    if edit.select is not None:
        return edit.select
    kept = (
        parts if origin is None else frozenset(new for new, old in enumerate(origin) if old in parts)
        for parts, origin in zip(selection, (edit.masses, edit.springs, edit.joints), strict=True)
    )
    return Selection(*kept)


def carried(edit: Edit, moment: Moment) -> Moment:
    """Return the moment from which a motion continues after an edit. New parts start as in the scene.

    Args:
        edit: an edit of the moment's scene.
        moment: of the motion before.
    """
    scene = edit.scene
    if edit.masses is None:
        rows = moment.rows
    else:
        origin = np.array(edit.masses, np.int64)
        new = origin < 0
        rows = np.empty((4, origin.size))
        rows[:, ~new] = moment.rows[:, origin[~new]]
        if edit.lost is not None and edit.lost.shape[1] == new.sum():
            rows[:, new] = edit.lost
        elif new.any():
            starts = [scene.masses[i] for i in np.flatnonzero(new)]
            rows[:, new] = np.array([(*mass.position, *mass.velocity) for mass in starts], float).T
    held = [anchor.mass for anchor in scene.anchors]
    if held or edit.shift is not None or edit.stops:
        rows = rows.copy()
        rows[2:, held] = 0.0
        if edit.stops:
            rows[2:] = 0.0
        if edit.shift is not None:
            rows[:2] += edit.shift
    damage = _carried_damage(moment.damage, edit.springs, edit.joints, edit.lost_damage)
    # After parts were added or removed, static friction starts anew.
    grips = None if edit.moves_parts else moment.grips
    return dataclasses.replace(moment, scene=scene, rows=rows, damage=damage, grips=grips)


def _carried_damage(
    damage: Damage | None, springs: Map, joints: Map, lost: Damage | None = None
) -> Damage | None:
    """Return the yielding and breakage of springs and joints after an edit."""
    if damage is None and lost is None:
        return None
    damage, lost = damage or Damage(), lost or Damage()
    broken = damage.broken
    if springs is not None:
        gone, back = set(damage.broken), set(lost.broken)
        broken = tuple(i for i, old in enumerate(springs) if (old in gone if old >= 0 else i in back))
    lengths = _values(damage.set_lengths, springs, lost.set_lengths)
    hardened = _values(damage.hardened, springs, lost.hardened)
    angles = _values(damage.set_angles, joints, lost.set_angles)
    left = Damage(broken=broken, set_lengths=lengths, hardened=hardened, set_angles=angles)
    return left if broken or any(lengths) or any(hardened) or any(angles) else None


def _values(values: tuple[float, ...], origin: Map, lost: tuple[float, ...]) -> tuple[float, ...]:
    """Return a value for each part after an edit: its own from before, or the one restored with it."""
    if origin is None or not (values or lost):
        return values
    own, back = values or (0.0,) * len(origin), lost or (0.0,) * len(origin)
    return tuple(own[old] if old >= 0 else back[new] for new, old in enumerate(origin))


def inverse(edit: Edit, before: Scene, moment: Moment | None = None) -> Edit:
    """Return the inverse edit, which restores exactly the scene before.

    Args:
        edit: an edit of `before`.
        before: the scene that was edited.
        moment: of the motion when it was edited, from which removed parts are restored.
    """
    masses = _inverted(edit.masses, len(before.masses))
    lost = None
    if masses is not None and moment is not None:
        lost = moment.rows[:, [i for i, new in enumerate(masses) if new < 0]]
    shift = None
    if edit.shift is not None:
        shift = np.zeros((2, len(before.masses)))
        for new, old in enumerate(edit.masses or range(len(before.masses))):
            if old >= 0:
                shift[:, old] = -edit.shift[:, new]
    return Edit(
        edit.label,
        before,
        masses,
        _inverted(edit.springs, len(before.linear_springs)),
        _inverted(edit.joints, len(before.angular_springs)),
        lost,
        moment.damage if moment is not None else None,
        shift,
    )


def _inverted(origin: Map, count: int) -> Map:
    if origin is None:
        return None
    back = [-1] * count
    for new, old in enumerate(origin):
        if old >= 0:
            back[old] = new
    return tuple(back)


# ------------------------------------------------------------------------- building blocks of edits
def of_parts(scene: Scene) -> Scene:
    """Return the scene with the same masses and springs but without the recipes or template they came from.

    The joints of a diagonal template keep their actual stiffness, sqrt(2) times the number in the scene.
    """
    changes: dict[str, object] = {}
    if scene.bodies:
        changes |= {"bodies": (), "links": ()}
    if scene.template is not None:
        joints = tuple(
            msgspec.structs.replace(joint, stiffness=stiffness)
            for joint, stiffness in zip(scene.angular_springs, joint_stiffness(scene), strict=True)
        )
        changes |= {"template": None, "angular_springs": joints}
    return msgspec.structs.replace(scene, **changes) if changes else scene


def with_added(
    label: str,
    scene: Scene,
    masses: Sequence[Mass] = (),
    springs: Sequence[LinearSpring] = (),
    joints: Sequence[AngularSpring] = (),
    anchors: Sequence[Anchor] = (),
) -> Edit:
    """Append parts to a scene of parts.

    Raises:
        SceneError: there are too many.
    """

    def added(old: Sequence[object], new: Sequence[object], most: int, refusal: Text) -> Map:
        if len(old) + len(new) > most:
            raise SceneError(refusal)
        return (*range(len(old)), *(-1,) * len(new)) if new else None

    maps = (
        added(scene.masses, masses, MAX_MASSES, Text("a scene has {most} masses at most", most=MAX_MASSES)),
        added(
            scene.linear_springs,
            springs,
            MAX_SPRINGS,
            Text("a scene has {most} springs at most", most=MAX_SPRINGS),
        ),
        added(
            scene.angular_springs,
            joints,
            MAX_SPRINGS,
            Text("a scene has {most} angular springs at most", most=MAX_SPRINGS),
        ),
    )
    every = (*scene.masses, *masses)
    larger = msgspec.structs.replace(
        scene,
        masses=every,
        linear_springs=(*scene.linear_springs, *springs),
        angular_springs=(*scene.angular_springs, *joints),
        anchors=(*scene.anchors, *anchors),
        pose=_carried_pose(scene.pose, every, *maps),
    )
    return Edit(label, larger, *maps)


def _carried_pose(
    pose: Pose | None, new: Sequence[Mass], masses: Map, springs: Map, joints: Map
) -> Pose | None:
    """Return a pose after an edit; `new` are the masses then, and added ones start as they specify."""
    if pose is None:
        return None
    positions, velocities = pose.positions, pose.velocities
    if masses is not None:
        pairs = list(zip(masses, new, strict=True))
        positions = tuple(positions[old] if old >= 0 else mass.position for old, mass in pairs)
        velocities = tuple(velocities[old] if old >= 0 else mass.velocity for old, mass in pairs)
    damage = _carried_damage(pose.damage, springs, joints)
    return Pose(positions=positions, velocities=velocities, damage=damage)


def without(scene: Scene, gone: Selection) -> tuple[Scene, Map, Map, Map]:
    """Remove parts from a scene of parts; return it with the old indices of masses, springs and joints.

    Springs, joints and anchors that depend on a removed mass or spring are removed with it. A filling is
    removed when a spring of its loop is, as when one breaks, or when fewer than three masses of its loop are
    left.

    Raises:
        SceneError: no mass would be left.
    """
    masses = [i for i in range(len(scene.masses)) if i not in gone.masses]
    if not masses:
        raise SceneError(Text("a scene needs at least one mass, so the last one cannot be removed"))
    at = {old: new for new, old in enumerate(masses)}
    springs = [
        s
        for s, spring in enumerate(scene.linear_springs)
        if s not in gone.springs and spring.a in at and spring.b in at
    ]
    spring_at = {old: new for new, old in enumerate(springs)}
    joints = [
        j
        for j, joint in enumerate(scene.angular_springs)
        if j not in gone.joints and joint.a in spring_at and joint.b in spring_at
    ]
    maps = (
        _map(masses, scene.masses),
        _map(springs, scene.linear_springs),
        _map(joints, scene.angular_springs),
    )
    replace = msgspec.structs.replace
    changes: dict[str, Any] = {}
    if maps[0] is not None:
        changes["masses"] = tuple(scene.masses[i] for i in masses)
        changes["anchors"] = tuple(replace(a, mass=at[a.mass]) for a in scene.anchors if a.mass in at)
    if maps[0] is not None or maps[1] is not None:
        changes["linear_springs"] = tuple(_renumbered(scene.linear_springs[s], at) for s in springs)
        removed = np.setdiff1d(np.arange(len(scene.linear_springs)), springs)
        loops = [np.array(filling.masses) for filling in scene.fillings]
        empty = leaking(loops, np.stack(ends(scene.linear_springs), 1), removed) if loops else ()
        full = [f for k, f in enumerate(scene.fillings) if k not in empty]
        left = [(f, tuple(at[i] for i in f.masses if i in at)) for f in full]
        changes["fillings"] = tuple(replace(f, masses=loop) for f, loop in left if len(loop) >= 3)
    if maps[1] is not None or maps[2] is not None:
        changes["angular_springs"] = tuple(_renumbered(scene.angular_springs[j], spring_at) for j in joints)
    if changes:
        changes["pose"] = _carried_pose(scene.pose, changes.get("masses", scene.masses), *maps)
    return replace(scene, **changes), *maps


def _map(kept: list[int], parts: Sequence[object]) -> Map:
    return tuple(kept) if len(kept) < len(parts) else None


def _renumbered(part: Ended, at: dict[int, int]) -> Ended:
    """Return a part with the new indices at its ends; the same object if these do not change."""
    a, b = at[part.a], at[part.b]
    return part if a == part.a and b == part.b else msgspec.structs.replace(part, a=a, b=b)


def changed(parts: Sequence[T], new: Iterable[tuple[int, T]]) -> tuple[T, ...]:
    """Return the parts with some of them replaced."""
    every = list(parts)
    for i, part in new:
        every[i] = part
    return tuple(every)


def refuse_missing(parts: Iterable[int], count: int, what: Part = "mass") -> None:
    """Refuse parts that a scene does not have.

    Args:
        parts: indices.
        count: how many there are.
        what: their name.

    Raises:
        SceneError: one of them does not exist.
    """
    for i in parts:
        if not 0 <= i < count:
            raise SceneError(no_part(what, i, count))


def counted(count: int, what: str) -> str:
    """Return a count with its noun, as in "2 springs"."""
    several = {"mass": "masses"}.get(what, f"{what}s")
    return f"{count} {what if count == 1 else several}"
