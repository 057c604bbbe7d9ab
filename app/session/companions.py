"""All that goes along with the body of a session."""

from __future__ import annotations

import time
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import sim

from .companion import Companion
from .ghost import Ghost
from .history import History
from .shadow import Foresight


@dataclass
class Companions:
    """What goes along with the body of a session.

    Attributes:
        ghost: the second body, if one is wanted.
        foresight: tells how fast errors grow, if that is wanted.
    """

    ghost: Ghost | None = None
    foresight: Foresight | None = None

    def __iter__(self) -> Iterator[Companion]:
        return (one for one in (self.ghost, self.foresight) if one is not None)

    def _named(self) -> Iterator[tuple[str, Companion]]:
        return ((name, one) for name in ("ghost", "foresight") if (one := getattr(self, name)) is not None)

    @property
    def bodies(self) -> list[sim.Simulation]:
        """Those of all of them."""
        return [body for one in self for body in one.bodies]

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

    def follow(self, simulation: sim.Simulation, steps: int, led: Sequence[int], budget: float) -> None:
        """Go on by what the body has just done.

        Args:
            simulation: the body.
            steps: time steps that it has done.
            led: the masses that were led at a limited speed, and are to be where they came to.
            budget: seconds of computing that this may take.
        """
        began = time.perf_counter()
        for one in self:
            if not one.is_ready(simulation):
                continue
            for body in one.bodies:
                if not body.rate_limited:
                    for mass in led:
                        body.lead(mass, tuple(simulation.positions[mass]))
            one.follow(simulation, steps, budget - (time.perf_counter() - began))
