"""What tangential springs do after a step: friction that holds, see `push`.

They exert their forces as parts of the terms `walls` and `contact`. What they remember from step to step is
in the tables of these. Like what has yielded, it changes after a step only: the loop of the integrators calls
`stick` once it keeps one. So a step that is refused leaves no trace, and within a step forces depend on
nothing but where masses are and how fast.
"""

from __future__ import annotations

import numpy as np

from ..kernels.core.tables import Body, State
from ..kernels.engine.jit import FAST, kernel
from ..near import nearest_points
from ..scene.types import Grips
from .contact import direction, energy_along_springs, stick_to_springs
from .term import Indices
from .walls import NOWHERE, energy_along_walls, stick_to_walls


@kernel(internal=True, fastmath=FAST)
def _energy_along(body, state, q):
    return energy_along_walls(body, state, q) + energy_along_springs(body, state, q)


@kernel(fastmath=FAST)
def stick(problem, q0, q1, v1):
    """Note all stretches at the end q1, v1 of a step from q0, and let sliders slide.

    What friction takes is entered into the balance by its power. The part that springs keep is not lost.
    """
    body, state, balance = problem.body, problem.state, problem.balance
    before = _energy_along(body, state, q0) if balance.active else 0.0
    stick_to_walls(body, state, q1, v1)
    stick_to_springs(body, state, q1, v1)
    if balance.active:
        balance.work.walls += _energy_along(body, state, q1) - before


def sticks(body: Body) -> bool:
    """Whether a body has tangential springs where it touches something."""
    environment = body.environment
    return bool(environment.walls.stretch.size) or environment.contact.tangential > 0.0


def grips_of(body: Body, mass_order: Indices, spring_order: Indices) -> Grips | None:
    """The stretches of all tangential springs; None where there are none.

    Args:
        body: the tables.
        mass_order: (n,) scene index of the mass in each slot, from slot 1 on.
        spring_order: (S,) scene index of each spring of the tables.
    """
    walls, contact = body.environment.walls, body.environment.contact
    wall, slot = np.nonzero(walls.place < NOWHERE)
    count = int(contact.held_start[-1]) if contact.tangential else 0
    if not wall.size and not count:
        return None
    rows: list[tuple[int, int, float]] = []
    if count:
        of_spring, masses = np.repeat(np.arange(body.springs), np.diff(contact.held_start)), contact.held_mass
        springs, others = spring_order[of_spring].tolist(), mass_order[masses[:count] - 1].tolist()
        rows = list(zip(springs, others, contact.held[:count, 0].tolist(), strict=True))
    masses, stretches = mass_order[slot - 1].tolist(), walls.stretch[wall, slot].tolist()
    return Grips(walls=tuple(zip(wall.tolist(), masses, stretches, strict=True)), springs=tuple(rows))


def put_grips(
    body: Body, state: State, mass_index: Indices, spring_order: Indices, grips: Grips | None
) -> None:
    """Let tangential springs have stretches at the positions of a state; all others begin anew.

    Args:
        body: the tables.
        state: the positions.
        mass_index: (n,) slot of each mass of the scene.
        spring_order: as of `grips_of`.
        grips: the stretches, as far as there are such walls, and contact.
    """
    walls, contact = body.environment.walls, body.environment.contact
    x = state.x + 1j * state.y
    if walls.stretch.size:
        walls.stretch[:], walls.place[:] = 0.0, NOWHERE
        for k, mass, stretch in grips.walls if grips else ():
            if k < len(walls.rows) and mass < mass_index.size:
                slot = mass_index[mass]
                _, _, nx, ny, *_ = walls.rows[k]
                walls.stretch[k, slot], walls.place[k, slot] = stretch, x[slot].imag * nx - x[slot].real * ny
    if contact.tangential:
        contact.held_start[:] = 0
        index = np.argsort(spring_order)
        rows = [
            row
            for row in (grips.springs if grips else ())
            if row[0] < index.size and row[1] < mass_index.size
        ]
        rows = rows[: contact.held_mass.size]
        if rows:
            spring, mass, stretch = (np.array(column) for column in zip(*rows, strict=True))
            s, m = index[spring], mass_index[mass]
            order = np.lexsort((m, s))
            s, m, stretch = s[order], m[order], stretch[order]
            a, b = body.spring_a[s], body.spring_b[s]
            t = nearest_points(x[m], x[a], x[b])
            way = direction(x[m] - x[a] - t * (x[b] - x[a]), x[b] - x[a])
            contact.held_start[:] = np.searchsorted(s, np.arange(body.springs + 1))
            contact.held_mass[: s.size] = m
            contact.held[: s.size] = np.stack((stretch, t, way.real, way.imag), 1)
