"""All that goes along with the body of a session."""

from __future__ import annotations

import time
from collections.abc import Iterator, Mapping, Sequence
from typing import TypeVar

import sim

from .companion import Companion
from .history import History

_C = TypeVar("_C", bound=Companion)


class Companions:
    """What goes along with the body of a session: at most one of each kind."""

    def __init__(self) -> None:
        self._all: dict[type[Companion], Companion] = {}

    def __iter__(self) -> Iterator[Companion]:
        return iter(tuple(self._all.values()))

    def __len__(self) -> int:
        return len(self._all)

    def get(self, kind: type[_C]) -> _C | None:
        """The one of a kind, if there is one."""
        one = self._all.get(kind)
        return one if isinstance(one, kind) else None

    def add(self, one: Companion, history: History) -> None:
        """Have one go along, in place of another of its kind, whose past is forgotten."""
        history.forget(one.name)
        self._all[type(one)] = one

    def remove(self, kind: type[Companion], history: History) -> None:
        """Have none of a kind."""
        history.forget(kind.name)
        self._all.pop(kind, None)

    @property
    def bodies(self) -> list[sim.Simulation]:
        """Those to which the same is done by hand as to the session's body."""
        return [body for one in self if one.by_hand for body in one.bodies]

    @property
    def second(self) -> sim.Simulation | None:
        """The body that is drawn with a look of its own beside the session's, if there is one."""
        return next((one.bodies[0] for one in self if one.drawn), None)

    @property
    def are_in_step(self) -> bool:
        """Whether the body's clock waits for one of them."""
        return any(one.in_step for one in self)

    @property
    def are_late(self) -> bool:
        """Whether one for which the body's clock waits has not come as far as the body."""
        return any(one.is_late for one in self)

    def capture(self) -> Mapping[str, object]:
        """What there is to come back to, by name."""
        return {one.name: kept for one in self if (kept := one.capture()) is not None}

    def begin(self, simulation: sim.Simulation, history: History) -> None:
        """Begin where the body is; their past is of another motion."""
        for one in self:
            history.forget(one.name)
            one.begin(simulation)

    def adapt(self, simulation: sim.Simulation) -> None:
        """Go on after the body's settings have changed."""
        for one in self:
            one.adapt(simulation)

    def touch(self) -> None:
        """Know that something was done by hand to the body."""
        for one in self:
            one.touch()

    def go_back(self, history: History, index: int, simulation: sim.Simulation) -> None:
        """Be as at a moment of the history, to which the body has gone."""
        for one in self:
            one.go_back(history.beside(one.name, index, one.span), simulation)

    def keep_pace(self, simulation: sim.Simulation, steps: int, budget: float) -> None:
        """Have those go on by what the body has just done for which its clock waits.

        Args:
            simulation: the body.
            steps: time steps that it has done.
            budget: seconds of computing that this may take.
        """
        for one in self:
            if one.in_step:
                one.follow(simulation, steps, budget)

    def follow(self, simulation: sim.Simulation, steps: int, led: Sequence[int], budget: float) -> None:
        """Have the others go on by what the body has just done.

        Args:
            simulation: the body.
            steps: time steps that it has done.
            led: the masses that were led at a limited speed, and are to be where they came to.
            budget: seconds of computing that this may take.
        """
        began = time.perf_counter()
        for one in self:
            if one.in_step or not one.is_ready(simulation):
                continue
            for body in one.bodies:
                if not body.rate_limited:
                    for mass in led:
                        body.lead(mass, tuple(simulation.positions[mass]))
            one.follow(simulation, steps, budget - (time.perf_counter() - began))
