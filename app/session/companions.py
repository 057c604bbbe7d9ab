"""All that goes along with the body of a session."""

from __future__ import annotations

import time
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import sim

from .companion import Companion
from .ghost import Ghost
from .history import History
from .rival import Rival
from .shadow import Foresight


@dataclass
class Companions:
    """What goes along with the body of a session.

    Attributes:
        ghost: the second body, if one is wanted.
        foresight: tells how fast errors grow, if that is wanted.
        rival: the other body of a race, if there is one.
    """

    ghost: Ghost | None = None
    foresight: Foresight | None = None
    rival: Rival | None = None

    def __iter__(self) -> Iterator[Companion]:
        return (one for _, one in self._named())

    def _named(self) -> Iterator[tuple[str, Companion]]:
        names = "ghost", "foresight", "rival"
        return ((name, one) for name in names if (one := getattr(self, name)) is not None)

    @property
    def bodies(self) -> list[sim.Simulation]:
        """Those to which the same is done by hand as to the session's body."""
        return [body for one in self if one.by_hand for body in one.bodies]

    def capture(self) -> Mapping[str, object]:
        """What there is to come back to, by name."""
        return {name: kept for name, one in self._named() if (kept := one.capture()) is not None}

    def begin(self, simulation: sim.Simulation, history: History) -> None:
        """Begin where the body is; their past is of another motion."""
        for name, one in self._named():
            history.forget(name)
            one.begin(simulation)

    def adapt(self, simulation: sim.Simulation) -> None:
        """Go on after the body's settings have changed."""
        for one in self:
            one.adapt(simulation)

    def go_back(self, history: History, index: int, simulation: sim.Simulation) -> None:
        """Be as at a moment of the history, to which the body has gone."""
        for name, one in self._named():
            one.go_back(history.beside(name, index, one.span), simulation)

    def keep_pace(self, simulation: sim.Simulation, steps: int, budget: float) -> None:
        """Have a rival go on by what the body has just done; the body's clock waits for it.

        Args:
            simulation: the body.
            steps: time steps that it has done.
            budget: seconds of computing that this may take.
        """
        if self.rival is not None:
            self.rival.follow(simulation, steps, budget)

    def follow(self, simulation: sim.Simulation, steps: int, led: Sequence[int], budget: float) -> None:
        """Have the others go on by what the body has just done.

        Args:
            simulation: the body.
            steps: time steps that it has done.
            led: the masses that were led at a limited speed, and are to be where they came to.
            budget: seconds of computing that this may take.
        """
        began = time.perf_counter()
        for one in (self.ghost, self.foresight):
            if one is None or not one.is_ready(simulation):
                continue
            for body in one.bodies:
                if not body.rate_limited:
                    for mass in led:
                        body.lead(mass, tuple(simulation.positions[mass]))
            one.follow(simulation, steps, budget - (time.perf_counter() - began))
