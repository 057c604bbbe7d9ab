"""Ghost, predictability copies and rival: bodies stepped with the main one, in what time a frame has left."""

from __future__ import annotations

import time
from abc import ABC, abstractmethod
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, ClassVar, TypeVar

import sim

from .history import History
from .pacing import Costs


class Companion(ABC):
    """One or several bodies that follow the session's.

    Args and attributes:
        bodies: its own.

    Attributes:
        name: of its kind, in the history.
        span: simulated seconds of its past that it needs to go back.
        by_hand: whether hands and keys act on its bodies as they do on the session's.
        in_step: whether the session's clock waits for it.
        drawn: whether its bodies are drawn, with a look of their own.
        cost: running average of the seconds of computing per frame.
        costs: what its steps cost.
    """

    name: ClassVar[str]
    span: ClassVar[float] = 0.0
    by_hand: ClassVar[bool] = True
    in_step: ClassVar[bool] = False
    drawn: ClassVar[bool] = False

    def __init__(self, bodies: tuple[sim.Simulation, ...]) -> None:
        self.bodies = bodies
        self.cost, self.costs = 0.0, Costs()

    @property
    def is_compiling(self) -> bool:
        """Whether it waits for its method's kernels; steps by NumPy would not be those of that method."""
        return any(body.plain for body in self.bodies)

    @property
    def is_late(self) -> bool:
        """Whether its simulated time is behind that of the session's body."""
        return False

    def touch(self) -> None:  # noqa: B027  most need not know
        """Note that hands or keys have acted on the session's body."""

    def is_ready(self, simulation: sim.Simulation) -> bool:
        """Whether it can be stepped; when its kernels have just become ready, it starts from the body."""
        if not self.is_compiling:
            return True
        ready = [body.take_compiled() for body in self.bodies]
        if all(ready):
            self.begin(simulation)
        return False

    def _count(self, seconds: float) -> None:
        """Enter the computing time of a frame into the average."""
        self.cost += 0.1 * (seconds - self.cost)
        for body in self.bodies:
            body.stats()

    @abstractmethod
    def begin(self, simulation: sim.Simulation) -> None:
        """Start from the state of the session's body, as for a new motion."""

    @abstractmethod
    def adapt(self, simulation: sim.Simulation) -> None:
        """Continue after the settings of the session's body have changed, or its state by more than steps."""

    @abstractmethod
    def capture(self) -> Any:
        """What `go_back` needs of the present state; None if there is nothing."""

    @abstractmethod
    def go_back(self, past: Sequence[tuple[float, Any]], simulation: sim.Simulation) -> None:
        """Return to a moment that the session's body has returned to.

        Args:
            past: times, s, and captured states of the `span` up to that moment; empty if there are none.
            simulation: the session's body.
        """

    @abstractmethod
    def follow(self, simulation: sim.Simulation, steps: int, budget: float) -> None:
        """Catch up with the session's body.

        Args:
            simulation: the session's body.
            steps: time steps that it has just done.
            budget: seconds of computing that this may take.
        """


_C = TypeVar("_C", bound=Companion)


class Companions:
    """The companions of a session's body, at most one of each kind."""

    def __init__(self) -> None:
        self._all: dict[type[Companion], Companion] = {}

    def __iter__(self) -> Iterator[Companion]:
        return iter(tuple(self._all.values()))

    def __len__(self) -> int:
        return len(self._all)

    def get(self, kind: type[_C]) -> _C | None:
        """The companion of a kind, if there is one."""
        one = self._all.get(kind)
        return one if isinstance(one, kind) else None

    def add(self, one: Companion, history: History) -> None:
        """Add a companion; one of the same kind is replaced, and its past forgotten."""
        history.forget(one.name)
        self._all[type(one)] = one

    def remove(self, kind: type[Companion], history: History) -> None:
        """Remove the companion of a kind, and its past."""
        history.forget(kind.name)
        self._all.pop(kind, None)

    @property
    def bodies(self) -> list[sim.Simulation]:
        """The bodies on which hands and keys act as on the session's."""
        return [body for one in self if one.by_hand for body in one.bodies]

    @property
    def drawn(self) -> list[sim.Simulation]:
        """The bodies that are drawn, with a look of their own."""
        return [body for one in self if one.drawn for body in one.bodies]

    @property
    def are_in_step(self) -> bool:
        """Whether the session's clock waits for one of them."""
        return any(one.in_step for one in self)

    @property
    def are_late(self) -> bool:
        """Whether one for which the session's clock waits is behind."""
        return any(one.is_late for one in self)

    def capture(self) -> Mapping[str, object]:
        """Their present states, by name."""
        return {one.name: state for one in self if (state := one.capture()) is not None}

    def begin(self, simulation: sim.Simulation, history: History) -> None:
        """Start all from the state of the session's body; their past belongs to another motion."""
        for one in self:
            history.forget(one.name)
            one.begin(simulation)

    def adapt(self, simulation: sim.Simulation) -> None:
        """See `Companion.adapt`."""
        for one in self:
            one.adapt(simulation)

    def touch(self) -> None:
        """See `Companion.touch`."""
        for one in self:
            one.touch()

    def go_back(self, history: History, index: int, simulation: sim.Simulation) -> None:
        """Return all to a moment of the history, to which the session's body has returned."""
        for one in self:
            one.go_back(history.past_of(one.name, index, one.span), simulation)

    def keep_pace(self, simulation: sim.Simulation, steps: int, budget: float) -> None:
        """Have those that the session's clock waits for catch up; see `Companion.follow`."""
        for one in self:
            if one.in_step:
                one.follow(simulation, steps, budget)

    def follow(self, simulation: sim.Simulation, steps: int, led: Sequence[int], budget: float) -> None:
        """Have the others catch up; see `Companion.follow`.

        Args:
            led: the masses that were led at a limited speed: theirs are led to where these came to.
            simulation, steps, budget: as there.
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
