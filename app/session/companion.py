"""What goes along with a session's body, in the time that this leaves of a frame."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from typing import Any, ClassVar

import sim

from .pacing import Costs


class Companion(ABC):
    """One of them.

    Args and attributes:
        bodies: its own.

    Attributes:
        name: of its kind, in the history.
        span: simulated seconds of its past that it needs to go back.
        by_hand: whether the same is done by hand to its bodies as to the session's.
        in_step: whether the body's clock waits for it.
        drawn: whether its body is drawn with a look of its own beside the session's.
        cost: seconds of computing in the last frames, on average.
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
        """Whether its method is still being compiled; by NumPy, it would say nothing of that method."""
        return any(body.plain for body in self.bodies)

    @property
    def is_late(self) -> bool:
        """Whether it has not come as far in time as the session's body yet."""
        return False

    def touch(self) -> None:  # noqa: B027  most do not mind
        """Know that something was done by hand to the session's body."""

    def is_ready(self, simulation: sim.Simulation) -> bool:
        """Whether it may go on; when its method has just become ready, it begins with the body."""
        if not self.is_compiling:
            return True
        ready = [body.take_compiled() for body in self.bodies]
        if all(ready):
            self.begin(simulation)
        return False

    def _count(self, seconds: float) -> None:
        """Note what a frame's steps took."""
        self.cost += 0.1 * (seconds - self.cost)
        for body in self.bodies:
            body.stats()

    @abstractmethod
    def begin(self, simulation: sim.Simulation) -> None:
        """Begin where the body is, as for another motion."""

    @abstractmethod
    def adapt(self, simulation: sim.Simulation) -> None:
        """Go on after the body's settings have changed, or something else than steps was done to it."""

    @abstractmethod
    def capture(self) -> Any:
        """What there is to come back to; None if there is nothing."""

    @abstractmethod
    def go_back(self, past: Sequence[tuple[float, Any]], simulation: sim.Simulation) -> None:
        """Be as at a moment that the body has gone to.

        Args:
            past: what was kept of the `span` until that moment, with the times, s; empty if nothing was.
            simulation: the body.
        """

    @abstractmethod
    def follow(self, simulation: sim.Simulation, steps: int, budget: float) -> None:
        """Go on by what the body has just done.

        Args:
            simulation: the body.
            steps: time steps that it has done.
            budget: seconds of computing that this may take.
        """
