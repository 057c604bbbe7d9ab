"""Why a simulation stopped."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property, partial
from typing import Literal

from ..engine.tables import State
from ..forces.words import CAUSES
from ..model.system import System
from ..scene.numbers import MAX_COORDINATE, MAX_SPEED, RUNAWAY_SPEED
from ..scene.types import Scene
from ..solve.registry import METHODS
from ..solve.steps import guard
from ..text import Text
from .motion import Outcome
from .stability import StabilityEstimate, StabilityMeter

Quantity = Literal["number", "position", "speed", "step"]
"""What went wrong; see `Divergence.quantity`."""

LIMITS: dict[int, tuple[Quantity, float]] = {
    guard.BAD_NUMBER: ("number", math.inf),
    guard.BAD_POSITION: ("position", MAX_COORDINATE),
    guard.BAD_SPEED: ("speed", RUNAWAY_SPEED),
    guard.STUCK: ("step", 0.0),
}
"""Quantity and limit for each code of `guard`. Coordinates are limited to the range of a scene file, so that
every state can be saved; a method that chooses its steps may be faster."""


@dataclass(frozen=True)
class Divergence:
    """Why a simulation stopped; the state is the last good one.

    Attributes:
        mass: the first mass at which it was found.
        step: number of the step that was not done, counted from the start.
        quantity: "position" or "speed" passed its limit, a "number" became NaN or infinite, or no "step" was
            short enough.
        limit: the limit that was passed, px or px/s; infinite for "number", 0 for "step".
        dt: the time step, s.
        find_stability: finds `stability`, which takes far longer than a run that explodes.
        adaptive: whether the method has a tolerance, so that the time step cannot be the cause.
        driven: whether the force law has no energy, so that the law itself can make the body ever faster.
    """

    mass: int
    step: int
    quantity: Quantity
    limit: float
    dt: float
    find_stability: Callable[[], StabilityEstimate] = field(repr=False, compare=False)
    adaptive: bool = False
    driven: bool = False

    @cached_property
    def stability(self) -> StabilityEstimate:
        """The stability limit in question: that of the body at its start or, if the time step was below it,
        in its last good shape."""
        return self.find_stability()

    def __str__(self) -> str:
        match self.quantity:
            case "number":
                what = Text(
                    "mass {mass} would get a position or velocity that is not a finite number", mass=self.mass
                )
            case "position":
                what = Text(
                    "mass {mass} went too far (over {limit:,.0f} px)", mass=self.mass, limit=self.limit
                )
            case "step":
                what = Text("no step from here is short enough")
            case "speed":
                what = Text(
                    "mass {mass} became too fast (over {limit:,.0f} px/s)", mass=self.mass, limit=self.limit
                )
        return Text(
            "stopped before step {step}: {what}; {reason}", step=self.step, what=what, reason=self.reason
        )

    @property
    def reason(self) -> str:
        """The likely cause, in words."""
        if self.stability.cause is not None and self.dt > self.stability.limit:
            return Text(
                "time step {dt:.4g} s is above the stability limit {limit:.2g} s, set by the {cause}",
                dt=self.dt,
                limit=self.stability.limit,
                cause=CAUSES[self.stability.cause],
            )
        if self.adaptive and self.driven:
            return Text("the tutorial's force law has no energy and can drive a body ever faster")
        if self.adaptive:
            return Text("the body was moved or set up too violently")
        if math.isinf(self.stability.limit):
            return Text("the body was moved or set up too violently for this time step")
        if self.driven:
            return Text(
                "the time step is below the stability limit, but that is for small motions about one pose; "
                "large or fast ones can pass it, and the tutorial's force law has no energy and can drive a "
                "body ever faster"
            )
        return Text(
            "the time step is below the stability limit, but that is for small motions about one pose; large "
            "or fast ones can pass it"
        )


def explain(scene: Scene, system: System, state: State, steps: int, outcome: Outcome) -> Divergence:
    """Why a simulation stopped after so many steps, by how its last call went."""
    quantity, limit = LIMITS[outcome.status]
    method, dt = METHODS[scene.integrator.method], scene.integrator.dt
    limit = MAX_SPEED if quantity == "speed" and method.adaptive else limit
    driven = scene.force_law == "tutorial" and system.body.joints > 0
    mass = int(system.mass_order[outcome.mass_index - 1]) if outcome.mass_index > 0 else 0
    find = partial(limit_to_blame, system, state.copied(), method.name, dt)
    return Divergence(mass, steps, quantity, limit, dt, find, method.adaptive, driven)


def limit_to_blame(system: System, state: State, method: str, dt: float) -> StabilityEstimate:
    """The stability limit in question after a divergence.

    The last good state is usually distorted already, so the limit is that of the body at its start or, if the
    time step is below that, of its last shape. Velocities are set to zero, since those of an exploding body
    are a consequence of the divergence.
    """
    masses = slice(1, system.body.masses + 1)
    rest = state.copied()
    rest.vx[:] = rest.vy[:] = 0.0
    rest.x[masses], rest.y[masses] = system.start[:2]
    estimate = StabilityMeter(system, method).update(rest)
    if estimate.limit < dt:
        return estimate
    rest.x[masses], rest.y[masses] = state.x[masses], state.y[masses]
    return StabilityMeter(system, method).update(rest)
