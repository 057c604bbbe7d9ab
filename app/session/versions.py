"""The versions of a scene that a session has had: what undo and redo lead to."""

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
MAX_BYTES = 64_000_000
"""What is kept; beyond either the oldest is forgotten."""

_PER_PART = 16
"""Bytes of a part of a list that changed, about: the parts themselves are shared."""
_OVERHEAD = 2000
"""Bytes of a step beside that, about."""


@dataclass(frozen=True)
class Step:
    """One change of the scene.

    Attributes:
        label: what was done.
        forward, backward: there and back, if the motion goes on over it.
        before, after: the moments to be at instead, where it is another body's, or the same one has other
            places and speeds.
        scale, shift: by what the change multiplied the rest length scale, and what it added to all rest
            angles, beside the scene: settings take in what keys have done.
        key: changes with the same one that follow each other are one step; empty for a step that has ended.
        until: after this time, s, they are not.
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
        """Whether the scene is the same before and after, and only places and speeds differ."""
        return self.before is not None and self.forward.scene is self.backward.scene

    @property
    def bytes(self) -> int:
        """What it takes, about, beside what it shares with other steps."""
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

    Scenes are told apart by being the same object: a moment that is gone back to has the very scene of then.
    Only the phase of a beat may be another one: at another tempo waves of muscles go on from where they are,
    also when that is undone.
    """

    def __init__(self) -> None:
        self.clear()

    def clear(self) -> None:
        """Forget everything."""
        self._steps: list[Step] = []
        self._bytes = 0
        self._at = 0  # so many steps lead to the present version

    def copy(self) -> Versions:
        """The same, to go on from here in another way."""
        other = Versions()
        other._steps, other._bytes, other._at = list(self._steps), self._bytes, self._at
        return other

    @property
    def undoable(self) -> str:
        """What the next undo takes back; empty if there is nothing."""
        return self._steps[self._at - 1].label if self._at else ""

    @property
    def redoable(self) -> str:
        """What the next redo does again; empty if there is nothing."""
        return self._steps[self._at].label if self._at < len(self._steps) else ""

    @property
    def bytes(self) -> int:
        """What all of it takes, about."""
        return self._bytes

    def __len__(self) -> int:
        return len(self._steps)

    def add_edit(
        self, edit: Edit, before: Moment, key: str = "", now: float = 0.0, within: float = math.inf
    ) -> None:
        """An edit was made.

        Args:
            edit: which.
            before: the moment at which it was made.
            key: edits with the same one that follow each other are one step.
            now: s.
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
        """A number or a choice was changed, and the motion goes on.

        Args:
            label: what was changed.
            before, after: just before and after.
            key: which number it was; changes of one number that follow each other are one step.
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
        """Another body took the place of the one before, or the same one has other places and speeds.

        Args:
            label: what was done.
            before, after: just before and after.
            key: as for a change.
        """
        last = self._last_of(key)
        if last is not None and last.before is not None:
            self._drop_last()
            before = last.before
        self._add(Step(label, Edit(label, after.scene), Edit(label, before.scene), before, after, key=key))

    def amend_leap(self, after: Moment) -> None:
        """The body that has just taken the place of another is this one after all."""
        if self._at and (before := self._steps[-1].before) is not None:
            label = self._steps[-1].label
            self._drop_last()
            self.add_leap(label, before, after)

    def end_step(self) -> None:
        """What is changed from here on is another step."""
        if self._at:
            self._steps[self._at - 1] = replace(self._steps[self._at - 1], key="")

    def has_undo(self, scene: Scene) -> bool:
        """Whether there is a change of a scene, the present one, to take back."""
        return self._at > 0 and _same(self._steps[self._at - 1].forward.scene, scene)

    def has_redo(self, scene: Scene) -> bool:
        """Whether there is a change of a scene, the present one, to do again."""
        return self._at < len(self._steps) and _same(self._steps[self._at].backward.scene, scene)

    def undo(self, moment: Moment) -> tuple[Moment, Edit | None] | None:
        """How the present motion goes on without the last change; None if there is none to take back.

        Returns:
            the moment to go on at, and the edit that leads there, or None where it is another body's.
        """
        if not self.has_undo(moment.scene):
            return None
        self._at -= 1
        step = self._steps[self._at]
        if step.before is not None:
            # A redo comes back to where this was left.
            self._steps[self._at] = replace(step, after=moment)
            return _at_time_of(step, step.before, moment), step.backward if step.is_state else None
        back = carried(step.backward, moment)
        back = replace(
            back,
            scene=_in_time(back.scene, moment),
            rest_length_scale=moment.rest_length_scale / step.scale,
            rest_angle_shift=moment.rest_angle_shift - step.shift,
        )
        return back, step.backward

    def redo(self, moment: Moment) -> tuple[Moment, Edit | None] | None:
        """How the present motion goes on with what was taken back last; see `undo`."""
        if not self.has_redo(moment.scene):
            return None
        step = self._steps[self._at]
        self._at += 1
        if step.after is not None:
            self._steps[self._at - 1] = replace(step, before=moment)
            return _at_time_of(step, step.after, moment), step.forward if step.is_state else None
        # What is removed again comes back from where it is now.
        self._steps[self._at - 1] = replace(step, backward=inverse(step.forward, moment.scene, moment))
        there = carried(step.forward, moment)
        there = replace(
            there,
            scene=_in_time(there.scene, moment),
            rest_length_scale=moment.rest_length_scale * step.scale,
            rest_angle_shift=moment.rest_angle_shift + step.shift,
        )
        return there, step.forward

    def find(self, scene: Scene) -> None:
        """A moment that is past is shown, with its scene: undo and redo go on from that version."""
        for at in sorted(range(len(self._steps) + 1), key=lambda at: abs(at - self._at)):
            if (known := self._scene(at)) is not None and _same(known, scene):
                self._at = at
                return

    def return_to(self, scene: Scene) -> Scene | None:
        """Be at the version that equals a scene, and return what that version knows it by; None if no version
        does."""
        for at in sorted(range(len(self._steps) + 1), key=lambda at: abs(at - self._at)):
            known = self._scene(at)
            if known is not None and (known == scene or _same(known, scene)):
                self._at = at
                return known if known == scene else scene
        return None

    # --------------------------------------------------------------------- inside
    def _last_of(self, key: str, now: float = 0.0) -> Step | None:
        """The last step, if one with that key goes on with it."""
        last = self._steps[self._at - 1] if self._at else None
        goes_on = key and last is not None and last.key == key and now <= last.until
        return last if goes_on and not self.redoable else None

    def _drop_last(self) -> None:
        self._bytes -= self._steps.pop().bytes
        self._at -= 1

    def _scene(self, at: int) -> Scene | None:
        if at < len(self._steps):
            return self._steps[at].backward.scene
        return self._steps[-1].forward.scene if self._steps else None

    def _add(self, step: Step) -> None:
        if self._at and not _same(self._steps[self._at - 1].forward.scene, step.backward.scene):
            self.clear()  # something changed that was not told
        for gone in self._steps[self._at :]:
            self._bytes -= gone.bytes
        del self._steps[self._at :]
        self._steps.append(step)
        self._bytes += step.bytes
        while len(self._steps) > MAX_STEPS or (self._bytes > MAX_BYTES and len(self._steps) > 1):
            self._bytes -= self._steps.pop(0).bytes
        self._at = len(self._steps)


def _at_time_of(step: Step, moment: Moment, now: Moment) -> Moment:
    """The moment to be at: of the same body, time goes on."""
    if not step.is_state:
        return moment
    return replace(moment, scene=_in_time(moment.scene, now), time=now.time, step_count=now.step_count)


def _same(known: Scene, scene: Scene) -> bool:
    """Whether a scene is a version that is known, but for the phase of its beat."""
    one, other = known.beat, scene.beat
    if known is scene or not one or not other or one.frequency != other.frequency:
        return known is scene
    return msgspec.structs.replace(known, beat=other) == scene


def _in_time(scene: Scene, now: Moment) -> Scene:
    """A scene whose beat goes on from where that of a moment is."""
    beat = scene.beat and now.scene.beat and now.scene.beat.at_tempo(scene.beat.frequency, now.time)
    return msgspec.structs.replace(scene, beat=beat) if beat and beat != scene.beat else scene


def _sum(one: NDArray[np.float64] | None, two: NDArray[np.float64] | None) -> NDArray[np.float64] | None:
    if one is None or two is None:
        return one if two is None else two
    return one + two
