"""The list of what acts on masses besides springs, joints and gravity, and what follows from it.

A new force is a page and an entry here, see docs/extending.md. The kernels below join those of the pages. The
balance, stability, what is measured, and `sim.physics` go by the list, too.
"""

from __future__ import annotations

from ..kernels.engine.jit import FAST, kernel
from ..kernels.engine.lanes import eight_at_a_time, scalar_gathers_on_amd
from .air import AIR
from .chain import chain_accelerations, is_chain_like
from .contact import CONTACT
from .fillings import FILLINGS
from .nets import is_net, net_forces
from .resistance import RESISTANCE
from .springs import accelerations_by, spring_forces
from .term import in_turn, least_of, never, nothing, written
from .walls import WALLS

TERMS = (AIR, RESISTANCE, WALLS, FILLINGS, CONTACT)
"""The forces; each is added to those before it."""

WITH_ENERGY = tuple(term for term in TERMS if term.energy is not None)
"""Those with an energy, in the order of `energies`."""

KINETIC, LINEAR, ANGULAR, GRAVITY, OTHERS = 0, 1, 2, 3, 4
"""Indices of the energies in what `kernels.energy.energies.energies` writes; `OTHERS`: the first of those of
`WITH_ENERGY`."""
ENERGIES = OTHERS + len(WITH_ENERGY)
"""Their number."""

_add_each = in_turn(term.add_forces for term in TERMS)


@kernel(internal=True, fastmath=FAST)
def add_forces(body, state, scratch, q, v):
    """See `Term.add_forces`; this and those below are those of all terms together."""
    # One test for all: those of each term take a fifth of the step of a dozen masses that have none.
    if body.environment.present:
        _add_each(body, state, scratch, q, v)


write_energies = written((term.energy for term in WITH_ENERGY), OTHERS)
"""Kernel (body, state, q, out): writes the energies of `WITH_ENERGY`, kg px²/s², into `out`."""

add_power = in_turn(term.add_power for term in TERMS if term.add_power is not nothing)
"""See `Term.add_power`."""

add_derivatives = in_turn(term.add_derivatives for term in TERMS if term.add_derivatives is not nothing)
"""See `Term.add_derivatives`."""

add_damping = in_turn(term.add_damping for term in TERMS if term.add_damping is not nothing)
"""See `Term.add_damping`."""

impact_time = least_of(term.impact_time for term in TERMS if term.impact_time is not never)
"""See `Term.impact_time`."""


@kernel(noalias=True, fastmath=FAST)
def accelerations(body, state, scratch, q, v, a):
    """Accelerations of all masses at positions q and velocities v; zero where a mass is held.

    q, v and a are flat: x of every slot, then y of every slot.
    """
    scalar_gathers_on_amd()
    eight_at_a_time()
    slots = q.size // 2
    x, y, vx, vy = q[:slots], q[slots:], v[:slots], v[slots:]
    if is_chain_like(body):
        chain_accelerations(body, state, scratch, q, v, a)
    else:
        if is_net(body):
            net_forces(body, state, scratch, q, v)
        else:
            spring_forces(body, state, scratch, x, y, vx, vy)
        add_forces(body, state, scratch, q, v)
        accelerations_by(body, state, scratch, vx, vy, a)
