"""A page's body in time: playing and pausing, going back to what is past, and playing a log."""

from __future__ import annotations

import math
import time
from typing import Literal

import sim
from sim.body.system import same_topology
from sim.edit.edit import Selection
from sim.errors import InputError

from . import commands
from .commands import Command
from .history import OldFuture
from .log import Log
from .notices import Notice
from .record import Recorder
from .replay import Player
from .running import Running

MOST_SECONDS = 0.5
"""Seconds of computing that single steps, or one call of a replay, may take, by what steps have cost."""

_AFTER_REPLAY = "it begins where a replay was left"


class Timeline(Running):
    """Which moment of a body the page shows, and how it goes on from there; see `Session`.

    Args and attributes: see `Running`.
    """

    def play(self, on: bool) -> None:
        """Let the clock run, from the moment that is shown, or stand."""
        if on:
            self._branch()
            self.offer_back = self.waits = False
        if on != self.playing:
            self.playing = on
            self.pacer.restart()
            self.revision += 1

    # --------------------------------------------------------------------- inside
    def _apply_to_time(self, command: Command) -> bool:
        """Apply a command about what is past; whether it is one."""
        history = self.history
        match command:
            case commands.GoTo(time):
                if not math.isfinite(time):
                    raise InputError(f"t = {time} s: that is no time to go to")
                self._show(history.nearest(time))
            case commands.GoBack(seconds):
                if not math.isfinite(seconds):
                    raise InputError(f"{seconds} s: that is no time to go back by")
                self._show(history.back(seconds))
            case commands.GoForward():
                self._show(min(history.shown + 1, history.last))
            case commands.ForgetFuture():
                self.old_future = None
                self.revision += 1
            case commands.BackBeforeDivergence():
                self._show(history.before_runaway())
            case _:
                return False
        return True

    def _branch(self) -> None:
        """What comes from here on takes the place of what came after the moment that is shown."""
        if self.replay is not None:
            if self.history.scrubbed:
                self._show(self.history.last)
        elif newer := self.history.cut():
            self.old_future = OldFuture.of(newer)
            self.revision += 1

    def _show(self, index: int) -> None:
        """Pause, and show a moment that is past."""
        self.play(False)
        history, before = self.history, self.simulation.capture().scene
        if self.replay is None:
            self._let_go()
            if not history.scrubbed:
                # What was changed since the last frame is not to be lost.
                history.amend(self.simulation.capture(), *self._moments_beside())
            self.recorder.restore(history[index])
        elif index == history.last:
            self.simulation = self.replay.simulation  # it has to go on as if nobody had looked back
        else:
            self._viewer = self._viewer or sim.Simulation(history[index].scene, wait=self._wait)
            self._viewer.restore(history[index])
            self.simulation = self._viewer
        self.hands.forget_pointer()
        history.shown = index
        self.offer_back = False
        self._changed_from(before)
        self._go_back_beside(index)
        self.revision += 1
        self._stability_due = 0.0

    def _changed_from(self, before: sim.Scene) -> None:
        """Have the page look at the settings again, if they are no longer those of a scene."""
        scene = self.simulation.capture().scene
        if scene is not before:
            self.revision += 1
            self.versions.find(scene)
            if not same_topology(before, scene):
                self.generation += 1
                self.joint = min(self.joint, max(0, len(scene.angular_springs) - 1))
                self.selection = Selection()  # other parts may have its numbers
                self.old_future = None
            elif (scene.force_law, scene.integrator.method) != (before.force_law, before.integrator.method):
                self.generation += 1  # other controls

    def _begin_replay(self, record: Log) -> None:
        """Show a log's body, and play what was done to it."""
        self._open(record.scene)
        self.replay = Player(record, self.simulation)
        self.play(True)

    def _play_log(self, player: Player, now: float, budget: float) -> None:
        """Go on by a frame of a replay."""
        simulation = player.simulation
        if not simulation.complete:
            simulation.take_compiled()  # by other methods, it would not be the same
            return
        steps = self.pacer.grant(now, simulation.dt, math.inf)
        scene, began = simulation.capture().scene, time.perf_counter()
        try:
            pacer = self.pacer
            most, attempts = pacer.affordable(MOST_SECONDS), pacer.attempts(MOST_SECONDS)
            done = player.advance(steps * simulation.dt, budget, most, attempts)
        except InputError as error:
            self._end_replay(f"It cannot go on: {error}.")
            return
        stats = simulation.stats()
        self.fallbacks += stats.fallbacks
        self.pacer.record(now, simulation.dt, done, time.perf_counter() - began, stats, missed=0)
        self._remember()
        self._changed_from(scene)
        if player.ended:
            self.play(False)
            begins = "It agrees with the log: " if player.agrees else "It does not agree with the log: it "
            self._end_replay(f"{begins}{player.verdict}.", "info" if player.agrees else "warning")

    def _end_replay(self, text: str, kind: Literal["info", "warning"] = "info") -> None:
        self.replay = self._viewer = None
        self.recorder = Recorder(self.simulation, _AFTER_REPLAY)
        self.recorder.keys = frozenset()
        self.revision += 1
        self.notices.append(Notice(kind, "The replay has ended", text))
