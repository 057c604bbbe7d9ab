"""What tangential springs do after a step: friction that holds, see `push`.

They exert their forces as parts of the terms `walls` and `contact`. What they remember from step to step is
in the state, with what has yielded, and like that it changes after a step only: the loop of the integrators
calls `update_friction_history` once it keeps one. So a step that is refused leaves no trace, and within a
step forces depend on nothing but where masses are and how fast.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...engine.jit import FAST, kernel
from ...engine.tables import Body
from ..events import LARGEST_PART, UNSEEN
from .contact import energy_along_springs, slip_fraction_on_springs, stick_to_springs
from .pairs import TANGENTIAL_ROOM
from .walls import NOWHERE, energy_along_walls, slip_fraction_on_walls, stick_to_walls


@kernel(internal=True, fastmath=FAST)
def _energy_along(body, state, q, kept):
    return energy_along_walls(body, state, q, kept) + energy_along_springs(body, state, q)


@kernel(fastmath=FAST)
def slip_fraction(problem, q0, v0, q1, v1, h, tolerance):
    """The part of a step of h seconds from q0, v0 to q1, v1 that should be tried instead of it: up to where
    something begins to touch, to slide, or turns round; 1 if the step may be kept. `tolerance`: px per s."""
    body, state, unseen = problem.body, problem.state, UNSEEN * tolerance
    part = min(
        slip_fraction_on_walls(body, state, q0, v0, q1, v1, h, unseen),
        slip_fraction_on_springs(body, state, q0, v0, q1, v1, h, unseen),
    )
    return min(part, LARGEST_PART) if part < 1.0 else 1.0


@kernel(fastmath=FAST)
def update_friction_history(problem, q0, v0, q1, v1, h):
    """Note all stretches at the end q1, v1 of a step of h seconds from q0, v0, and let sliders slide.

    With h = 0, as under a fixed step, what was between is not looked at. What friction takes is entered into
    the balance by its power. The part that springs keep is not lost.

    Returns:
        Whether any force has jumped.
    """
    body, state, balance = problem.body, problem.state, problem.balance
    before = _energy_along(body, state, q0, True) if balance.active else 0.0
    jumped = stick_to_walls(body, state, q0, v0, q1, v1, h)
    stick_to_springs(body, state, problem.scratch, q0, v0, q1, v1, h)
    if balance.active:
        balance.work.walls += _energy_along(body, state, q1, True) - before
    return jumped


def room_in_state(body: Body, slots: int) -> dict[str, NDArray[Any]]:
    """The arrays for tangential springs in a state with so many slots, by name; there is no spring yet."""
    walls, found = body.environment.walls, {}
    if walls.tangential:
        shape = len(walls.rows), slots
        found |= {"wall_stretch": np.zeros(shape), "wall_place": np.full(shape, NOWHERE)}
        if walls.runs:
            found["wall_time"] = np.zeros(1)
        if walls.static:
            found["wall_slides"] = np.zeros(shape)
    if body.environment.contact.tangential > 0.0:
        masses, stretches = _room(body)
        start = np.zeros(body.springs + 1, np.int64)
        found |= {"contact_start": start, "contact_mass": masses, "contact_stretch": stretches}
    return found


def room_in_scratch(body: Body) -> dict[str, NDArray[Any]]:
    """The arrays in scratch for the tangential springs at the end of a step, by name."""
    if body.environment.contact.tangential == 0.0:
        return {}
    masses, stretches = _room(body)
    return {"next_mass": masses, "next_stretch": stretches}


def _room(body: Body) -> tuple[NDArray[np.int64], NDArray[np.float64]]:
    count = TANGENTIAL_ROOM * body.springs
    return np.zeros(count, np.int64), np.zeros((count, 6))
