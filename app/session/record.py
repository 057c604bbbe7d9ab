"""Acts on a simulation, and keeps a log of it that can be replayed bit for bit."""

from __future__ import annotations

from dataclasses import replace

import sim
from sim.body.system import same_topology
from sim.methods.registry import METHODS
from sim.store.files import encode_fields

from . import log
from .log import Entry

CHECK_EVERY = 1.0
"""Simulated seconds between two checks."""

TOO_LONG = "the log before this had grown too long; it starts anew here"


class Recorder:
    """All that a session does to its body goes through this.

    What a replay could not do in the same way is not noted step by step: while kernels are still being
    compiled, how a body goes on depends on when that is done. Then the log goes on from where that led.

    Args:
        simulation: the body, at its scene's start.

    Attributes:
        simulation: the body.
        acts: how often something was done to it.
        visited: digests of the moments that the log goes back to, or on from, see `log.digest_of`.
    """

    def __init__(self, simulation: sim.Simulation, note: str = "") -> None:
        self.simulation = simulation
        self.acts = 0
        self._follows_energy = False
        self._begin(note)
        if note:
            self._go_on_from_here()

    def _restart(self) -> None:
        """Start the log anew at the scene's start, where the simulation is."""
        self._begin("")
        self._note_holding()

    def _begin(self, note: str) -> None:
        self._scene = self.simulation.capture().scene  # what the header has
        self._text = note
        self._lines: list[bytes] = []
        self._size = 0
        self._last: Entry | None = None  # not in the lines yet: it may come again
        self._times = 0
        self._moment: tuple[sim.Moment, bool, str] | None = None  # gone back to, and not noted yet
        self.visited: set[str] = set()
        self._checked = self.simulation.time
        self._complete = self.simulation.complete

    # --------------------------------------------------------------------- what can be done to a body
    def do(self, act: log.Act) -> None:
        """Do something; with another number of masses it is another body, and the log starts anew.

        Raises:
            InputError, SettingError: it cannot be done.
        """
        self.acts += 1
        if not isinstance(act, log.Lead):  # which is over at the next step, and would be lost
            self._make_room()
        if isinstance(act, log.FollowEnergy):
            self._follows_energy = act.on
        if not isinstance(act, log.Set | log.Choose):  # of which there is one a frame while a hand leads
            act.do(self.simulation)
            self._note(act)
            return
        masses = len(self.simulation.scene.masses)
        act.do(self.simulation)
        if len(self.simulation.scene.masses) != masses:
            self._restart()
        else:
            self._note(act)
            # Another method may wait for other kernels.
            self._complete = self._complete and self.simulation.complete

    def set_scene(self, scene: sim.Scene, keys_too: bool) -> None:
        """Go on with another scene's settings; another number of masses is another body, at its start.

        Args:
            scene: has the same masses, springs and joints, or comes from the same recipe.
            keys_too: whether rest lengths and angles are the scene's, too, without what keys have changed.
        """
        moment = self.simulation.capture()
        if not same_topology(moment.scene, scene):
            self.simulation.replace(scene)
            self._restart()
            return
        if keys_too:
            moment = replace(moment, rest_length_scale=scene.rest_length_scale, rest_angle_shift=0.0)
        self.restore(replace(moment, scene=scene))

    def restore(self, moment: sim.Moment) -> None:
        """See `Simulation.restore`. Of many in a row, the last is noted."""
        present = self.simulation.capture().scene
        self.simulation.restore(moment)
        self._complete = self._complete and self.simulation.complete
        self._put_off(moment, moment.scene is not present)

    def reset(self) -> None:
        """See `Simulation.reset`; the log starts anew."""
        self.simulation.reset()
        self._restart()

    def step(self, n: int, attempts: int | None = None) -> int:
        """See `Simulation.step`."""
        done = self.simulation.step(n, attempts)
        if not self._complete:
            if self.simulation.complete:
                self._go_on_from_here()
            return done
        if n > 0:
            # A method with fixed steps that came to the end could have tried more.
            free = done == n and not METHODS[self.simulation.method].adaptive
            self._note(log.Step(n=n, attempts=None if free else attempts))
            if abs(self.simulation.time - self._checked) >= CHECK_EVERY:
                self._check()
            self._make_room()
        return done

    # --------------------------------------------------------------------- the log
    def file(self) -> bytes:
        """The log until now, as a file; a check ends it.

        Raises:
            SceneError: the scene cannot be written.
        """
        if not self._complete:
            self._go_on_from_here()
        self._settle()
        end = encode_fields(log.check_of(self.simulation))
        return b"\n".join([log.encode_header(self._scene, self._text), *self._lines, end, b""])

    def _note(self, entry: Entry) -> None:
        if not self._complete:
            return
        if self._moment is not None:
            self._settle()
        if entry == self._last:
            self._times += 1
            return
        self._write_last()
        self._last, self._times = entry, 1

    def _put_off(self, moment: sim.Moment, with_scene: bool) -> None:
        """The body is at a moment now; it is noted when it is known that it stays there."""
        with_scene = with_scene or (self._moment is not None and self._moment[1])
        self._moment = moment, with_scene, log.digest_of(self.simulation)

    def _settle(self) -> None:
        """Write all that waits to be."""
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
        self._settle()
        self._checked = self.simulation.time
        self._write(log.check_of(self.simulation))

    def _make_room(self) -> None:
        """Start the log anew if it has grown too long: before something is done, or after steps, so that
        nothing is lost that was to be done in the next steps."""
        if self._size <= log.MAX_LOG_BYTES:
            return
        self._begin(TOO_LONG)
        self._go_on_from_here()

    def _go_on_from_here(self) -> None:
        """Let the body go on as a replay will that begins at this moment, and note so."""
        moment, grabbed = self.simulation.capture(), self.simulation.grabbed
        self._complete = True
        self.simulation.restore(moment)
        self._put_off(moment, with_scene=True)
        for mass in grabbed:
            self.do(log.Grab(mass=mass))
        self.simulation.track_energy(self._follows_energy)
        self._note_holding()
        self._complete = self.simulation.complete

    def _note_holding(self) -> None:
        self._note(log.Keys.of(self.simulation.keys))
        self._note(log.FollowEnergy(on=self._follows_energy))
