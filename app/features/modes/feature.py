"""The modes of a page's body, while its strip is open: how much of each is in the motion, and how the body is
put into one."""

from __future__ import annotations

import math
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from sim.analysis.modes import Modes

from ...session.modes import ModesWatch
from ...session.session import Command, Refresh, Session
from ...ui.commands import Row
from ...ui.feature import Drawn, Feature
from ...ui.page import Page
from ...wire.messages import FromPage
from ...wire.sections import joined
from ...words import say
from . import messages

LEVELS_EVERY = 1.0 / 20.0
"""Least time between two sets of levels while the body moves, s; the page interpolates between them."""

MAX_LOAD = 0.1
"""Largest share of the time that projecting the motion onto the modes may take."""

MIN_CHANGE = 2e-4
"""Change of a level, as a part of a full bar, below which nothing is sent."""


class ShowModes(Command):
    """Open or close the strip of modes; toggle it by default."""

    on: bool | None = None
    refresh = Refresh.SETTINGS

    def apply(self, session: Session, at: float) -> None:
        on = session.modes is None if self.on is None else self.on
        if not on:
            session.driving.end()
        session.modes = (session.modes or ModesWatch()) if on else None


class PutIntoMode(Command):
    """Put the body into a mode, with a part of the amplitude of a full bar."""

    mode: int
    part: float
    acts = True

    def apply(self, session: Session, at: float) -> None:
        watch = session.modes
        if watch is None or watch.excitation(session.simulation) is None or watch.found is None:
            return
        if not (0 <= self.mode < len(watch.full) and math.isfinite(self.part)):
            return
        mode, modes = self.mode, watch.found
        amplitude = min(max(self.part, 0.0), 1.0) * float(watch.full[mode])
        session.jump_to(lambda now: modes.put(now, mode, amplitude), f"mode {mode + 1}", f"mode {mode}")


class DriveMode(Command):
    """Drive a mode by hand from now on, or stop driving (-1)."""

    mode: int
    acts = True

    def apply(self, session: Session, at: float) -> None:
        driving, watch = session.driving, session.modes
        if self.mode < 0:
            driving.fade()
        elif not driving.goes_on(self.mode, at) and watch is not None:
            session.play(True)
            driving.begin(watch, self.mode)

    def takes_over(self, session: Session) -> bool:
        return self.mode >= 0

    def playing_after(self, playing: bool) -> bool:
        return playing or self.mode >= 0


class ModesFeature(Feature):
    """Sends a page the modes of its body, and puts the body into them."""

    messages: ClassVar = {messages.PutMode: "modes", messages.DriveMode: "modes"}
    commands: ClassVar = {
        "modes": Row(ShowModes(), ("V",), needs="modes"),
        "mute": Row("page", ("M",), needs="modes"),
    }
    controls: ClassVar = {"modes": "the strip of modes, in the View menu"}

    def __init__(self, page: Page) -> None:
        super().__init__(page)
        self._on = False
        self._shapes = -1
        self._sent: tuple[int, float, NDArray[np.float32]] | None = None
        self._due = 0.0

    def hear(self, said: FromPage) -> None:
        """See `Feature`."""
        match said:
            case messages.PutMode(mode, part):
                self.session.post(PutIntoMode(mode, part))
            case messages.DriveMode(mode):
                self.session.post(DriveMode(mode))

    def frame(self, drawn: Drawn) -> None:
        """See `Feature`."""
        session = self.session
        watch = session.modes
        if watch is None:
            if self._on:
                self._on, self._shapes, self._sent = False, -1, None
                self.page.mail.send(messages.ModeShapes(numbers=np.zeros(0, np.float32)))
                self.page.mail.send(messages.Modes())
            return
        self._on = True
        modes, drive = watch.found, session.driving.drive
        if modes is None:
            self._shapes, self._sent = -1, None
            self.page.mail.send(messages.Modes(on=True, number=watch.number, trouble=watch.trouble))
            return
        if self._shapes != watch.number:
            self._shapes, self._sent = watch.number, None
            self.page.mail.send(messages.ModeShapes(numbers=encode_shapes(watch.number, modes)))
        state = messages.Modes(
            on=True,
            number=watch.number,
            trouble="" if modes.omega.size else say("modes-still"),
            frequencies=_rounded(modes.omega / (2.0 * math.pi)),
            damping=_rounded(modes.damping_ratios),
            full=_rounded(watch.full),
            driven=-1 if drive is None or drive.let_go < math.inf else drive.mode,
        )
        self.page.mail.send(state)
        self._tell_levels(session, modes)

    def _tell_levels(self, session: Session, modes: Modes) -> None:
        now, watch, simulation = session.now(), session.modes, session.simulation
        if watch is None or simulation.divergence is not None:
            return
        running = session.playing
        if running and now < self._due:
            return
        if self._sent is not None and not running and self._sent[1] == simulation.time and now < self._due:
            return
        began = session.now()
        found = watch.excitation(simulation)
        if found is None:
            return
        amplitudes = np.hypot(found.amplitudes, found.rates / modes.omega)
        numbers = encode_levels(
            watch.number,
            simulation.time,
            amplitudes / watch.full,
            found.energies,
            found.others,
            found.touching / watch.unit,
            watch.unit,
            found.frames,
        )
        self._due = now + max(LEVELS_EVERY, (session.now() - began) / MAX_LOAD) - 1e-3
        if self._sent is not None:
            number, _, before = self._sent
            if number == watch.number and np.abs(numbers[3:] - before[3:]).max(initial=0.0) < MIN_CHANGE:
                self._sent = number, simulation.time, before
                return
        self._sent = watch.number, simulation.time, numbers
        self.page.mail.send(messages.ModeLevels(numbers=numbers))


def encode_shapes(number: int, modes: Modes) -> NDArray[np.float32]:
    """Encode the shapes of modes, which the page draws over the body.

    Args:
        number: of these shapes; the state of the modes has it, too.
        modes: of the body.
    """
    sections: list[NDArray[np.float64] | list[float]] = [
        [float(number), modes.size],
        modes.rest.ravel(),
        modes.part.astype(float),
    ]
    for mode in range(modes.omega.size):
        marks = modes.marks(mode)
        nodes = [value for spring, along in marks.nodes for value in (float(spring), along)]
        sections += [modes.shapes[mode].ravel(), nodes, [float(mass) for mass in marks.antinodes]]
    return joined(*sections)


def encode_levels(
    number: int,
    time: float,
    levels: NDArray[np.float64],
    energies: NDArray[np.float64],
    others: float,
    touching: float,
    unit: float,
    frames: NDArray[np.float64],
) -> NDArray[np.float32]:
    """Encode how much of each mode is in a motion.

    Args:
        number: of the shapes.
        time: simulated, s.
        levels: (k,) amplitudes in those of full bars.
        energies: (k,) of the modes, kg px²/s².
        others: energy in none of them; negative where the modes would have more than the body has.
        touching: contact energy, in units.
        unit: energy that fills the bar of what is in no mode.
        frames: (P, 4) see `Excitation`.
    """
    whole = float(energies.sum()) + abs(others)
    # A body at rest has rounding errors only.
    shares = np.append(energies, others) / whole if whole > 1e-12 * unit else np.zeros(len(energies) + 1)
    other = math.copysign(math.sqrt(abs(others) / unit), others)
    return joined([number, time, other, touching], levels, shares, frames)


def _rounded(values: NDArray[np.float64]) -> tuple[float, ...]:
    """Round to the digits that can be seen, so that rounding errors are no change."""
    return tuple(float(f"{value:.7g}") for value in values.tolist())
