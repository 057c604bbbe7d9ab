"""Drives a mode of a session's body by leading masses, as long as the page keeps asking for it."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

import sim
from sim.errors import InputError

from ..words import decimal, say
from . import log
from .modes import ModesWatch
from .record import Recorder

PIECES = 20
"""Straight pieces of a period of a led mass, each a call of `step`."""
SWELLING = 6.0
"""Periods in which an undamped mode is driven to a full bar."""
RAMP = 2.0
"""Periods in which the drive is faded in and out: a sudden start or end would excite other modes, too."""
SEEN = 0.03
"""Part of a full bar from which a mode's phase is followed."""
FURTHEST = 0.01
"""Amplitude of supports, at most, in sizes of the body."""


@dataclass(frozen=True)
class Drive:
    """Masses that are led to and fro at the frequency of a mode.

    Attributes:
        mode: its index.
        masses: that are led.
        grabbed: whether it is a single free mass, in a hand meanwhile.
        about: (k, 2) their rest positions, px.
        swings: (k, 2) their amplitudes, px.
        frequency: angular, rad/s.
        since: simulated time, s, at which the drive began.
        began: simulated time, s, of a passage through the middle, which sets the phase.
        part: of the amplitudes, 0 to 1.
        let_go: simulated time, s, at which it begins to fade.
    """

    mode: int
    masses: tuple[int, ...]
    grabbed: bool
    about: NDArray[np.float64]
    swings: NDArray[np.float64]
    frequency: float
    since: float
    began: float
    part: float
    let_go: float = math.inf

    @staticmethod
    def of(watch: ModesWatch, mode: int, simulation: sim.Simulation) -> Drive:
        """Drive a mode by all supports together, or without supports by the mass that it moves most.

        Raises:
            InputError: there is no such mode, or it is too fast for the time step.
        """
        modes = watch.found
        if modes is None or not 0 <= mode < modes.omega.size:
            raise InputError(f"there is no mode {mode + 1} to drive")
        w = float(modes.omega[mode])
        if (period := 2.0 * math.pi / w) < 4.0 * simulation.dt:
            raise InputError(say("session-mode-fast", mode=mode + 1, period=decimal(f"{period:.3g}")))
        full, mass = float(watch.full[mode]), float(modes.masses[mode])
        now = simulation.time
        if (supports := modes.supports(mode)) is None:
            most = int(np.argmax(np.hypot(*modes.shapes[mode].T)))
            about, swings = simulation.positions[[most]], full * modes.shapes[mode][[most]]
            return Drive(mode, (most,), True, about, swings, w, now, now, 1.0)
        masses, ways, felt = supports
        # A force f B sin(wt) on a mode of mass M makes its amplitude grow by f B / (2 M w) per second.
        size = min(full * 2.0 * mass * w / (felt * SWELLING * period), FURTHEST * modes.size)
        led = tuple(int(each) for each in masses)
        return Drive(mode, led, False, simulation.positions[masses], size * ways, w, now, now, 0.0)

    def in_step(self, watch: ModesWatch, simulation: sim.Simulation) -> Drive:
        """The drive in phase with the mode now, faded in, and weaker as the mode nears a full bar.

        The phase is measured again and again, since the period changes with the amplitude.
        """
        now = watch.excitation(simulation)
        if now is None:
            return self
        q, rate = float(now.amplitudes[self.mode]), float(now.rates[self.mode]) / self.frequency
        full, time = float(watch.full[self.mode]), simulation.time
        level, ramp = math.hypot(q, rate) / full, RAMP * 2.0 * math.pi / self.frequency
        part = (1.0 - min(level, 1.0)) * min((time - self.since) / ramp, 1.0)
        part *= max(1.0 - max(time - self.let_go, 0.0) / ramp, 0.0)
        if level < SEEN:
            return replace(self, part=part)
        # A force does the most work in phase with the velocity.
        ahead = math.atan2(q, rate) + 0.5 * math.pi
        return replace(self, part=part, began=time - ahead / self.frequency)

    def has_faded(self, time: float) -> bool:
        """Whether it has ended at a simulated time, s."""
        return time - self.let_go >= RAMP * 2.0 * math.pi / self.frequency

    def steps(self, dt: float) -> int:
        """Time steps of one straight piece."""
        return max(1, int(2.0 * math.pi / self.frequency / PIECES / dt))

    def lead(self, simulation: sim.Simulation, steps: int) -> list[log.Act]:
        """Acts that lead the masses through the next time steps."""
        part = self.part * math.sin(self.frequency * (simulation.time + steps * simulation.dt - self.began))
        return self._to(self.about + part * self.swings)

    def end(self) -> list[log.Act]:
        """Acts that put the masses back, or let go."""
        if self.grabbed:
            return [log.Release(mass=mass) for mass in self.masses]
        return self._to(self.about)

    def _to(self, places: NDArray[np.float64]) -> list[log.Act]:
        # Unlike a hand's, this motion is slow and smooth, and needs no limit of speed.
        pairs = zip(self.masses, places.tolist(), strict=True)
        return [log.Lead(mass=mass, to=(x, y)) for mass, (x, y) in pairs]


class Driving:
    """Starts, continues and ends the drive of a mode.

    Args:
        body: gives the present body.
        do: acts on it, and on its companions.

    Attributes:
        drive: the present one; None while no mode is driven.
        said_at: wall time, s, at which the page last asked for a drive.
    """

    def __init__(self, body: Callable[[], sim.Simulation], do: Callable[[log.Act], None]) -> None:
        self._body, self._do = body, do
        self.drive: Drive | None = None
        self.said_at = -math.inf

    def goes_on(self, mode: int, at: float) -> bool:
        """Note that the page asks for a mode at a wall time, s; whether that mode is driven already."""
        self.said_at = at
        return self.drive is not None and self.drive.mode == mode and self.drive.let_go == math.inf

    def begin(self, watch: ModesWatch, mode: int) -> None:
        """Drive a mode in place of any other.

        Raises:
            InputError: it cannot be driven, see `Drive.of`.
        """
        self.end()
        drive = Drive.of(watch, mode, self._body())
        for mass in drive.masses if drive.grabbed else ():
            self._do(log.Grab(mass=mass))
        self.drive = drive

    def fade(self) -> None:
        """Fade out: supports come to rest where they were, and a hand lets go."""
        drive = self.drive
        if drive is None or drive.grabbed:
            self.end()
        elif drive.let_go == math.inf:
            self.drive = replace(drive, let_go=self._body().time)

    def end(self) -> None:
        """End the drive at once."""
        drive, self.drive = self.drive, None
        for act in drive.end() if drive is not None else ():
            self._do(act)

    def drop(self) -> None:
        """Forget the drive; the body that was driven is gone."""
        self.drive = None

    def step(self, recorder: Recorder, watch: ModesWatch | None, steps: int, attempts: int) -> int:
        """Do some steps, and lead the masses that drive a mode meanwhile.

        Args:
            recorder: of the body.
            watch: its modes; None while nobody looks at them.
            steps: time steps.
            attempts: steps that an adaptive method may try for all of them together.

        Returns:
            The time steps that were done.
        """
        simulation = recorder.simulation
        if self.drive is not None and self.drive.has_faded(simulation.time):
            self.end()
        if self.drive is None:
            return recorder.step(steps, attempts=attempts)
        if watch is not None and not self.drive.grabbed:
            self.drive = self.drive.in_step(watch, simulation)
        done, each, last = 0, self.drive.steps(simulation.dt), simulation.work + attempts
        while done < steps and (left := last - simulation.work) > 0:
            n = min(each, steps - done)
            for act in self.drive.lead(simulation, n):
                self._do(act)
            did = recorder.step(n, attempts=left)
            done += did
            if did < n:
                break
        return done
