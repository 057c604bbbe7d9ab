"""The versions of a session's scene, between which undo and redo go."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import msgspec
import numpy as np
from numpy.typing import NDArray

from sim import Moment, Scene
from sim.edit.edit import Edit, carried, inverse

MAX_STEPS = 1000
"""Steps that are stored; beyond, the oldest is forgotten."""
MAX_BYTES = 64_000_000
"""Bytes that they may take, estimated."""

_PER_PART = 16
"""Estimated bytes of an element of a list that changed; the parts themselves are shared."""
_OVERHEAD = 2000
"""Estimated bytes of a step besides that."""


@dataclass(frozen=True)
class Step:
    """One change of the scene.

    Attributes:
        label: what was done.
        forward, backward: edits there and back, if the motion continues.
        before, after: moments to go to instead, if the step is to another body or to other positions and
            velocities.
        scale, shift: factor of the rest length scale, and addition to all rest angles, which are not in the
            scene: a setting includes what keys have changed.
        key: changes with the same key in a row are one step; empty for a step that has ended.
        until: time, s, after which they are not.
    """

    label: str
    forward: Edit
    backward: Edit
    before: Moment | None = None
    after: Moment | None = None
    scale: float = 1.0
    shift: float = 0.0
    key: str = ""
    until: float = math.inf

    @property
    def is_state(self) -> bool:
        """Whether only positions and velocities differ, and the scene is the same."""
        return self.before is not None and self.forward.scene is self.backward.scene

    @property
    def bytes(self) -> int:
        """Estimated memory, without what it shares with other steps."""
        one, two = self.backward.scene, self.forward.scene
        fields: Sequence[str] = Scene.__struct_fields__
        parts = sum(
            len(value)
            for field in fields
            if isinstance(value := getattr(two, field), tuple) and value is not getattr(one, field)
        )
        maps = self.forward.masses, self.forward.springs, self.forward.joints
        moments = (self.before, self.after) if self.is_state else ()
        rows = sum(moment.rows.nbytes for moment in moments if moment is not None)
        return _OVERHEAD + rows + _PER_PART * (parts + 2 * sum(len(each) for each in maps if each))


class Versions:
    """The changes in order, and which version is the present one.

    Scenes are compared by identity, since a past moment has the very scene of its time. Only the phase of a
    beat may differ: at another tempo, waves of muscles continue in phase, also when that is undone.
    """

    def __init__(self) -> None:
        self.clear()

    def clear(self) -> None:
        """Forget everything."""
        self._steps: list[Step] = []
        self._bytes = 0
        self._at = 0  # number of steps up to the present version

    def copy(self) -> Versions:
        """A copy, to continue independently."""
        other = Versions()
        other._steps, other._bytes, other._at = list(self._steps), self._bytes, self._at
        return other

    @property
    def undoable(self) -> str:
        """Label of what the next undo takes back; empty if there is nothing."""
        return self._steps[self._at - 1].label if self._at else ""

    @property
    def redoable(self) -> str:
        """Label of what the next redo does again; empty if there is nothing."""
        return self._steps[self._at].label if self._at < len(self._steps) else ""

    @property
    def bytes(self) -> int:
        """Estimated memory of all steps."""
        return self._bytes

    def __len__(self) -> int:
        return len(self._steps)

    def add_edit(
        self, edit: Edit, before: Moment, key: str = "", now: float = 0.0, within: float = math.inf
    ) -> None:
        """Add an edit.

        Args:
            edit: the edit.
            before: the moment at which it was made.
            key: edits with the same key in a row are one step.
            now: wall time, s.
            within: seconds between two of them, at most.
        """
        step = Step(edit.label, edit, inverse(edit, before.scene, before), key=key, until=now + within)
        last = self._last_of(key, now)
        if last is not None and not (edit.moves_parts or last.forward.moves_parts):
            self._drop_last()
            forward = replace(edit, shift=_sum(last.forward.shift, edit.shift))
            backward = replace(last.backward, shift=_sum(last.backward.shift, step.backward.shift))
            step = replace(step, forward=forward, backward=backward)
        self._add(step)

    def add_change(self, label: str, before: Moment, after: Moment, key: str = "") -> None:
        """Add a change of a number or choice, over which the motion continues.

        Args:
            label: what was changed.
            before, after: moments just before and after.
            key: of the number; changes of one number in a row are one step.
        """
        scale = after.rest_length_scale / before.rest_length_scale
        shift = after.rest_angle_shift - before.rest_angle_shift
        step = Step(label, Edit(label, after.scene), Edit(label, before.scene), scale=scale, shift=shift)
        step = replace(step, key=key)
        last = self._last_of(key)
        if last is not None and last.before is None:
            self._drop_last()
            step = replace(step, backward=last.backward, scale=scale * last.scale, shift=shift + last.shift)
        self._add(step)

    def add_leap(self, label: str, before: Moment, after: Moment, key: str = "") -> None:
        """Add a step to another body, or to other positions and velocities of the same one.

        Args:
            label: what was done.
            before, after: moments just before and after.
            key: as for a change.
        """
        last = self._last_of(key)
        if last is not None and last.before is not None:
            self._drop_last()
            before = last.before
        self._add(Step(label, Edit(label, after.scene), Edit(label, before.scene), before, after, key=key))

    def amend_leap(self, after: Moment) -> None:
        """Replace the body of the last such step."""
        if self._at and (before := self._steps[-1].before) is not None:
            label = self._steps[-1].label
            self._drop_last()
            self.add_leap(label, before, after)

    def end_step(self) -> None:
        """End the last step: the next change is another one."""
        if self._at:
            self._steps[self._at - 1] = replace(self._steps[self._at - 1], key="")

    def has_undo(self, scene: Scene) -> bool:
        """Whether there is a change that led to the present scene."""
        return self._at > 0 and _same(self._steps[self._at - 1].forward.scene, scene)

    def has_redo(self, scene: Scene) -> bool:
        """Whether there is a change of the present scene to do again."""
        return self._at < len(self._steps) and _same(self._steps[self._at].backward.scene, scene)

    def undo(self, moment: Moment) -> tuple[Moment, Edit | None] | None:
        """Take back the last change of the present motion; None if there is none.

        Returns:
            the moment to continue at, and the edit that leads there, or None if it is another body's.
        """
        if not self.has_undo(moment.scene):
            return None
        self._at -= 1
        step = self._steps[self._at]
        if step.before is not None:
            self._steps[self._at] = replace(step, after=moment)  # redo returns to here
        return _continued(
            step,
            step.before,
            step.backward,
            moment,
            rest_length_scale=moment.rest_length_scale / step.scale,
            rest_angle_shift=moment.rest_angle_shift - step.shift,
        )

    def redo(self, moment: Moment) -> tuple[Moment, Edit | None] | None:
        """Do again what was taken back last; see `undo`."""
        if not self.has_redo(moment.scene):
            return None
        step = self._steps[self._at]
        if step.after is not None:
            self._steps[self._at] = replace(step, before=moment)  # undo returns to here
        else:
            # What is removed again will come back from where it is now.
            self._steps[self._at] = replace(step, backward=inverse(step.forward, moment.scene, moment))
        self._at += 1
        return _continued(
            step,
            step.after,
            step.forward,
            moment,
            rest_length_scale=moment.rest_length_scale * step.scale,
            rest_angle_shift=moment.rest_angle_shift + step.shift,
        )

    def find(self, scene: Scene) -> None:
        """Go to the version of a past moment's scene: undo and redo continue from there."""
        for at, known in self._nearest():
            if _same(known, scene):
                self._at = at
                return

    def known(self, scene: Scene) -> Scene:
        """The version that equals a scene that was made once more; the scene itself if there is none."""
        return next((known for _, known in self._nearest() if known == scene), scene)

    def return_to(self, scene: Scene) -> Scene | None:
        """Go to the version that equals a scene; the scene that it is known by, or None if there is none."""
        for at, known in self._nearest():
            if known == scene or _same(known, scene):
                self._at = at
                return known if known == scene else scene
        return None

    # --------------------------------------------------------------------- inside
    def _last_of(self, key: str, now: float = 0.0) -> Step | None:
        """The last step, if a change with that key continues it."""
        last = self._steps[self._at - 1] if self._at else None
        goes_on = key and last is not None and last.key == key and now <= last.until
        return last if goes_on and not self.redoable else None

    def _drop_last(self) -> None:
        self._bytes -= self._steps.pop().bytes
        self._at -= 1

    def _nearest(self) -> list[tuple[int, Scene]]:
        """All versions and their scenes, those with the fewest steps from the present one first."""
        scenes = [step.backward.scene for step in self._steps]
        scenes += [step.forward.scene for step in self._steps[-1:]]
        return sorted(enumerate(scenes), key=lambda version: abs(version[0] - self._at))

    def _add(self, step: Step) -> None:
        if self._at and not _same(self._steps[self._at - 1].forward.scene, step.backward.scene):
            self.clear()  # there was a change that was not added
        for gone in self._steps[self._at :]:
            self._bytes -= gone.bytes
        del self._steps[self._at :]
        self._steps.append(step)
        self._bytes += step.bytes
        while len(self._steps) > MAX_STEPS or (self._bytes > MAX_BYTES and len(self._steps) > 1):
            self._bytes -= self._steps.pop(0).bytes
        self._at = len(self._steps)


def _continued(
    step: Step, there: Moment | None, edit: Edit, now: Moment, **keys: float
) -> tuple[Moment, Edit | None]:
    """The moment to continue at after a step, and the edit that leads there; see `Versions.undo`.

    Args:
        step: the step.
        there: the moment that it leads to, if the motion does not continue.
        edit: that leads there otherwise.
        now: the present moment.
        keys: what the step makes of the effect of the arrow keys.
    """
    if there is None:
        there = carried(edit, now)
        return replace(there, scene=_in_time(there.scene, now), **keys), edit
    if not step.is_state:
        return there, None
    # The same body, for which time continues.
    scene = _in_time(there.scene, now)
    return replace(there, scene=scene, time=now.time, step_count=now.step_count), edit


def _same(known: Scene, scene: Scene) -> bool:
    """Whether a scene is a known version, except for the phase of its beat."""
    one, other = known.beat, scene.beat
    if known is scene or not one or not other or one.frequency != other.frequency:
        return known is scene
    return msgspec.structs.replace(known, beat=other) == scene


def _in_time(scene: Scene, now: Moment) -> Scene:
    """A scene whose beat continues in the phase of a moment's."""
    beat = scene.beat and now.scene.beat and now.scene.beat.at_tempo(scene.beat.frequency, now.time)
    return msgspec.structs.replace(scene, beat=beat) if beat and beat != scene.beat else scene


def _sum(one: NDArray[np.float64] | None, two: NDArray[np.float64] | None) -> NDArray[np.float64] | None:
    if one is None or two is None:
        return one if two is None else two
    return one + two
