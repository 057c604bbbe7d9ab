"""Plays a log, and compares the outcome with what was recorded."""

from __future__ import annotations

import time

import numpy as np

import sim
from sim.errors import InputError, SceneError, SettingError, of_field
from sim.motion.solver import UNLIMITED

from ..words import decimal, say
from ..words.keys import Key
from . import log
from .history import History
from .log import Entry, Log

_MAX_OWED = 0.5
"""Simulated seconds that a replay catches up on, at most."""

_TOO_HEAVY: Key = "session-too-heavy"


class Player:
    """Plays a log in a simulation.

    Args:
        record: the log.
        simulation: the body of `record.scene`, at its start.
        energy: whether to follow the energy throughout, regardless of the log.
        history: whose reel notes what is done; None for a body that nobody takes back in time.

    Attributes:
        record, simulation: as above.
        steps: steps done so far.
        difference: a sentence on the first difference from the record, or None.
    """

    def __init__(
        self, record: Log, simulation: sim.Simulation, energy: bool = False, history: History | None = None
    ) -> None:
        self.record, self.simulation, self._energy, self._history = record, simulation, energy, history
        if energy:
            simulation.track_energy(True)
        self.steps = 0
        self.difference: str | None = None
        self._index = self._times = self._checks = 0
        self._digest = ""
        self._agreed = simulation.step_count  # at the last check that agreed
        self._owed = 0.0

    @property
    def ended(self) -> bool:
        """Whether the log is at its end."""
        return self._index >= len(self.record.entries)

    @property
    def at(self) -> int:
        """Index of the next entry."""
        return self._index

    @property
    def upcoming(self) -> Entry:
        """The next entry."""
        return self.record.entries[self._index]

    def do(self, attempts: int = UNLIMITED) -> int:
        """Do the next entry once; the steps that were done.

        Args:
            attempts: as for `advance`.

        Raises:
            InputError: it cannot be done; names the line.
        """
        entry, history = self.upcoming, self._history
        if history is not None:
            history.ready(self.simulation, self.simulation.complete)
        try:
            done = self._do(entry, attempts)
        except (InputError, SceneError, SettingError) as error:
            raise self._named(str(error)) from None
        self.steps += done
        self._times += 1
        if self._times >= entry.times:
            self._index, self._times = self._index + 1, 0
        return done

    def advance(self, seconds: float, budget: float, most: int, attempts: int) -> int:
        """Advance by some simulated seconds; the steps that were done.

        Args:
            seconds: simulated time, s; what a call of `step` exceeds it by is subtracted later.
            budget: seconds of computing after which no further entry is begun.
            most: steps of one call, at most.
            attempts: attempts in one call, at most, regardless of the record.

        Raises:
            InputError: as `do`, or a call exceeds these limits.
        """
        self._owed = min(self._owed + seconds, _MAX_OWED)
        done, end = 0, time.perf_counter() + budget
        while not self.ended:
            entry = self.upcoming
            if isinstance(entry, log.Step):
                if self._owed <= 0.0:
                    break
                if entry.n > most:
                    raise self._named(say(_TOO_HEAVY))
                self._owed -= entry.n * self.simulation.dt
            done += self.do(attempts)
            if time.perf_counter() >= end:
                break
        return done

    @property
    def agrees(self) -> bool:
        """Whether nothing has differed so far."""
        return self.difference is None

    @property
    def verdict(self) -> str:
        """How the replay compares with what was recorded, in one sentence."""
        if self.difference is not None:
            return self.difference
        steps, checks = str(self.steps), self._checks
        if not self._digest:
            return say("session-replayed", steps=steps, checks=checks)
        return say("session-replayed.digest", steps=steps, checks=checks, digest=self._digest)

    def _named(self, reason: str) -> InputError:
        line = self.record.lines[self._index]
        return InputError(of_field(f"{self.record.source}: line {line}", reason))

    def _do(self, entry: Entry, most: int) -> int:
        simulation = self.simulation
        match entry:
            case log.Step(n=n, attempts=attempts):
                allowed = UNLIMITED if attempts is None else attempts
                done = simulation.step(n, min(allowed, most))
                self._note(log.Step(n=n, attempts=min(allowed, most)))
                if done < n and most < allowed and simulation.divergence is None:
                    raise InputError(say(_TOO_HEAVY))
                return done
            case log.FollowEnergy() if self._energy:
                pass
            case log.Act():
                entry.do(simulation)
                self._note(entry)
            case log.Restore():
                if self._history is not None:
                    self._history.reel.close()
                moment = self.record.moments.get(self._index)
                simulation.restore(moment or log.moment_of(entry, simulation.capture().scene))
            case log.Check():
                self._check(entry)
        return 0

    def _note(self, entry: Entry) -> None:
        if self._history is not None:
            self._history.reel.note(entry)

    def _check(self, check: log.Check) -> None:
        self._checks += 1
        if self.difference is not None:
            return
        self._digest = log.digest_of(self.simulation)
        moves = (check.digest, check.step) == (self._digest, self.simulation.step_count)
        if moves and (not check.state or check.state == log.state_of(self.simulation)):
            self._agreed = check.step
            return
        some = log.noted(self.simulation)
        if moves:
            how = say("session-differs-hidden")
        elif len(check.at) == len(some):
            apart = float(np.hypot(*(some - check.at).T).max())
            unit = self.simulation.scene.view.unit
            how = say("session-differs-apart", distance=decimal(f"{apart:.3g} {unit}"))
        else:
            how = say("session-differs-unknown")
        step, time_then, agreed = str(check.step), decimal(f"{check.time:.6g}"), str(self._agreed)
        number, checks = str(self._checks), str(self.record.checks)
        here, machine = str(log.this_machine()), str(self.record.machine)
        if here == machine:
            self.difference = say(
                "session-differs",
                step=step,
                time=time_then,
                check=number,
                checks=checks,
                agreed=agreed,
                how=how,
            )
        else:
            self.difference = say(
                "session-differs.elsewhere",
                step=step,
                time=time_then,
                check=number,
                checks=checks,
                agreed=agreed,
                how=how,
                machine=machine,
                here=here,
            )
