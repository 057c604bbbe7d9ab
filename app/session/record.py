"""Acts on a simulation, and records a log of it that can be replayed bit for bit."""

from __future__ import annotations

from dataclasses import replace
from time import perf_counter

import sim
from sim.model.system import same_topology
from sim.solve.registry import METHODS
from sim.store.files import encode_fields

from . import log
from .history import History
from .log import Entry

CHECK_EVERY = 1.0
"""Simulated seconds between two checks."""

TOO_LONG = "the log before this had grown too long; it starts anew here"
"""Note in the header of a log that was restarted."""


class Recorder:
    """The only way in which a session acts on its body.

    Steps that a replay could not repeat are left out: while kernels are being compiled, a motion depends on
    when that is done. The log then continues from where they led.

    Args:
        simulation: the body, at its scene's start.
        note: why it is not at its scene's start, if it is not.
        history: whose reel notes everything, too; None for a body that nobody takes back in time.

    Attributes:
        simulation: the body.
        acts: number of acts.
        visited: digests of the moments that the log restores; see `log.digest_of`.
    """

    def __init__(self, simulation: sim.Simulation, note: str = "", history: History | None = None) -> None:
        self.simulation, self._history = simulation, history
        self.acts = 0
        self._follows_energy = False
        self._begin(note)
        if note:
            self._continue_here()

    def _restart(self) -> None:
        """Restart the log; the simulation is at the scene's start."""
        self._begin("")
        self._note_held()

    def _begin(self, note: str) -> None:
        self._scene = self.simulation.capture().scene  # in the header
        self._text = note
        self._lines: list[bytes] = []
        self._size = 0
        self._last: Entry | None = None  # not written yet, since it may be repeated
        self._times = 0
        self._moment: tuple[sim.Moment, bool, str] | None = None  # restored, and not written yet
        self.visited: set[str] = set()
        self._checked = self.simulation.time
        self._complete = self.simulation.complete

    # --------------------------------------------------------------------- what can be done to a body
    def do(self, act: log.Act) -> None:
        """Do something; another number of masses makes another body, and restarts the log.

        Raises:
            InputError, SettingError: it cannot be done.
        """
        self.acts += 1
        if not isinstance(act, log.Lead):  # a restart would lose the leads before the next step
            self._make_room()
        if isinstance(act, log.FollowEnergy):
            self._follows_energy = act.on
        self._prepare()
        if not isinstance(act, log.Set | log.Choose):  # the rest, which hands do in every frame, is simple
            act.do(self.simulation)
            self._note(act)
            return
        masses, began = len(self.simulation.scene.masses), perf_counter()
        act.do(self.simulation)
        if self._history is not None:
            self._history.reel.spend(perf_counter() - began)
        if len(self.simulation.scene.masses) != masses:
            self._restart()
        else:
            self._note(act)
            # Another method may wait for other kernels.
            self._complete = self._complete and self.simulation.complete

    def set_scene(self, scene: sim.Scene, keys_too: bool) -> None:
        """Continue with another scene's settings; another number of masses makes another body, at its start.

        Args:
            scene: has the same masses, springs and joints, or comes from the same recipe.
            keys_too: whether to undo what keys have changed.
        """
        moment = self.simulation.capture()
        if not same_topology(moment.scene, scene):
            self._leave()
            self.simulation.replace(scene)
            self._restart()
            return
        if keys_too:
            moment = replace(moment, rest_length_scale=scene.rest_length_scale, rest_angle_shift=0.0)
        self.restore(replace(moment, scene=scene))

    def restore(self, moment: sim.Moment) -> None:
        """See `Simulation.restore`. Of many in a row, the last one is recorded."""
        present = self.simulation.capture().scene
        self._leave()
        self.simulation.restore(moment)
        self._complete = self._complete and self.simulation.complete
        self._defer(moment, moment.scene is not present)

    def reset(self) -> None:
        """See `Simulation.reset`; restarts the log."""
        self._leave()
        self.simulation.reset()
        self._restart()

    def step(self, n: int, attempts: int | None = None) -> int:
        """See `Simulation.step`."""
        self._prepare()
        done = self.simulation.step(n, attempts)
        if not self._complete:
            if self.simulation.complete:
                self._continue_here()
            return done
        if n > 0:
            # For fixed steps that were all done, attempts do not matter.
            free = done == n and not METHODS[self.simulation.method].adaptive
            self._note(log.Step(n=n, attempts=None if free else attempts))
            if abs(self.simulation.time - self._checked) >= CHECK_EVERY:
                self._check()
            self._make_room()
        return done

    def _prepare(self) -> None:
        """Let the history make a checkpoint before something is done."""
        if self._history is not None:
            self._history.ready(self.simulation, self._complete)

    def _leave(self) -> None:
        """Let the history know that the body goes on from another state."""
        if self._history is not None:
            self._history.reel.close()

    # --------------------------------------------------------------------- the log
    def file(self) -> bytes:
        """The log up to now, as a file that ends with a check.

        Raises:
            SceneError: the scene cannot be written.
        """
        if not self._complete:
            self._continue_here()
        self._flush()
        end = encode_fields(log.check_of(self.simulation))
        return b"\n".join([log.encode_header(self._scene, self._text), *self._lines, end, b""])

    def _note(self, entry: Entry) -> None:
        if not self._complete:
            return
        if self._history is not None:
            self._history.reel.note(entry)
        if self._moment is not None:
            self._flush()
        if entry == self._last:
            self._times += 1
            return
        self._write_last()
        self._last, self._times = entry, 1

    def _defer(self, moment: sim.Moment, with_scene: bool) -> None:
        """Note that the body is at a moment, to be written once it does something from there."""
        with_scene = with_scene or (self._moment is not None and self._moment[1])
        self._moment = moment, with_scene, log.digest_of(self.simulation)

    def _flush(self) -> None:
        """Write all that is deferred."""
        self._write_last()
        if self._moment is not None:
            moment, with_scene, digest = self._moment
            self._moment = None
            self.visited.add(digest)
            self._write(log.restore_entry(moment, with_scene))

    def _write_last(self) -> None:
        if self._last is not None:
            entry = self._last
            self._last = None
            self._write(entry, self._times)

    def _write(self, entry: Entry, times: int = 1) -> None:
        line = encode_fields(entry)
        if times > 1:
            line = line[:-1] + b',"times":%d}' % times
        if self._lines:
            self._size += len(line) + 1
        self._lines.append(line)

    def _check(self) -> None:
        self._flush()
        self._checked = self.simulation.time
        self._write(log.check_of(self.simulation))

    def _make_room(self) -> None:
        """Restart the log if it is too long; called when no act is to take effect in the next steps."""
        if self._size <= log.MAX_LOG_BYTES:
            return
        self._begin(TOO_LONG)
        self._continue_here()

    def _continue_here(self) -> None:
        """Continue the log at this moment, and put the body into the state in which a replay will start."""
        moment, grabbed = self.simulation.capture(), self.simulation.grabbed
        self._complete = True
        self._leave()
        self.simulation.restore(moment)
        self._defer(moment, with_scene=True)
        for mass in grabbed:
            self.do(log.Grab(mass=mass))
        self.simulation.track_energy(self._follows_energy)
        self._note_held()
        self._complete = self.simulation.complete

    def _note_held(self) -> None:
        self._note(log.Keys.of(self.simulation.keys))
        self._note(log.FollowEnergy(on=self._follows_energy))
