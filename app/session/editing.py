"""Editing a page's body while it runs or stands; undo and redo of all that changes the scene."""

from __future__ import annotations

import sim
from sim.edit.edit import Edit, Selection, carried, existing, still_selected
from sim.edit.texts import as_own

from . import commands
from .commands import Command
from .timeline import Timeline


class Editing(Timeline):
    """Changes of the scene itself; see `Session`.

    Args and attributes: see `Running`.
    """

    def _apply_to_scene(self, command: Command) -> bool:
        """Apply a command that edits the body, or takes an edit back; whether it is one."""
        match command:
            case commands.Change(make, key, within):
                before = self.simulation.capture()
                edit = as_own(make(before, self.selection), before.scene)
                if edit.scene is not before.scene:
                    self._branch()
                    self.versions.add_edit(edit, before, key, self.now(), within)
                    self._go_on_as(carried(edit, before), edit)
            case commands.Visit():
                self.versions.end_step()
            case commands.Select(find):
                moment = self.simulation.capture()
                self.selection = existing(find(moment, self.selection), moment.scene)
            case commands.Undo():
                self._step_versions(self.versions.undo)
            case commands.Redo():
                self._step_versions(self.versions.redo)
            case _:
                return False
        return True

    def _step_versions(self, step: commands.StepVersions) -> None:
        taken = step(self.simulation.capture())
        if taken is not None:
            self._branch()
            self._go_on_as(*taken)

    def _go_on_as(self, moment: sim.Moment, edit: Edit | None) -> None:
        """Go on at a moment of an edited scene, at the same time.

        Args:
            moment: of the scene as it is now.
            edit: what made it of the one before; None where it is another body's.
        """
        self.hands.drop()
        self.lesson_begun = True  # it goes on where it was
        self.recorder.restore(moment)
        if edit is None:
            self.openings += 1
            self.selection = Selection()
        else:
            self.selection = still_selected(edit, self.selection)
        if edit is None or edit.moves_parts:
            self.old_future = None
            self.joint = min(self.joint, max(0, len(moment.scene.angular_springs) - 1))
            self.follow = self.follow and self.driven is not None
        self.generation += 1  # other controls
        if self.ghost is not None:
            self.history.forget_ghosts()
            self.ghost.start_from(self.simulation)
        if self.foresight is not None:
            self.history.forget_shadows()
            self.foresight.begin(self.simulation)
        self.history.amend(self.simulation.capture(), *self._moments_beside())
        self.revision += 1
        self._stability_due = 0.0
