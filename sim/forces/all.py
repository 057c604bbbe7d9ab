"""The list of what acts on masses besides still air and gravity, and what follows from it.

A new force is a page and an entry here, see docs/extending.md. The kernels below call those of the terms that
act on a body. The balance, stability, what is measured, and `sim.forces.reference` go by the list, too.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from ..engine.addresses import ADDRESSES, NONE, calls
from ..engine.calls import INDIRECT_CALLS
from ..engine.jit import FAST, kernel
from ..engine.lanes import eight_at_a_time, whole_eights
from ..engine.tables import Body
from ..text import Text
from . import words
from .air import AIR, add_damping_of_still_air, add_derivatives_of_still_air, brake, power_of_still_air
from .chain import chain_accelerations, is_chain_like
from .events import LARGEST_PART, UNSEEN
from .fillings import FILLINGS
from .motors import MOTORS
from .one_sided import ONE_SIDED
from .pushes import PUSHES
from .rails import RAILS, keep_on_rails
from .resistance import RESISTANCE
from .runs import JOINTS, SPRINGS, clear
from .springs import accelerations_by
from .term import SIGNATURES, Term
from .touch.contact import CONTACT
from .touch.walls import WALLS

TERMS = (SPRINGS, JOINTS, ONE_SIDED, AIR, RESISTANCE, WALLS, FILLINGS, CONTACT, MOTORS, PUSHES, RAILS)
"""The forces; each is added to those before it."""

SURROUNDINGS = tuple(term for term in TERMS if term.field)
"""Those besides springs and joints. A chain on which none of them acts has a path of its own."""

WITH_ENERGY = tuple(term for term in TERMS if term.energy is not None)
"""Those with an energy, in the order of `energies`."""

KINETIC, GRAVITY, OTHERS = 0, 1, 2
"""Indices of the energies in what `solve.balance.energies.energies` writes; `OTHERS`: the first of those of
`WITH_ENERGY`."""
ENERGIES = OTHERS + len(WITH_ENERGY)
"""Their number."""

_OF_TERM = len(SIGNATURES)
"""Kernels that a term may have; their numbers in `ADDRESSES` follow each other."""
_FORCES, _ENERGY, _POWER, _DERIVATIVES, _DAMPING, _IMPACT, _KINK = range(_OF_TERM)
_CHAIN, _ANY, _BRAKED = (_OF_TERM * len(TERMS) + path for path in range(3))
_call_forces, _call_energy, _call_power, _call_derivatives, _call_damping, _call_impact, _call_kink = map(
    calls, SIGNATURES.values()
)
_call_accelerations = calls(INDIRECT_CALLS["accelerations"])
_ENERGY_AT = np.array([WITH_ENERGY.index(term) if term in WITH_ENERGY else 0 for term in TERMS])
"""Of each term, where its energy stands among those of `WITH_ENERGY`."""


class Part(NamedTuple):
    """A kernel of forces that is compiled by itself, and called through its address."""

    name: str
    label: str  # for people
    kernel: Any
    signature: Any
    number: int  # in `ADDRESSES`


def _parts_of(index: int, term: Term) -> dict[str, Part]:
    """The kernels of a term by their fields; those that it does not have are noted as such."""
    found = {}
    for k, (field, signature) in enumerate(SIGNATURES.items()):
        number, function = _OF_TERM * index + k, getattr(term, field)
        if function is None:
            ADDRESSES[number] = NONE
        else:
            label = Text("{term}: {kernel}", term=words.TERMS[term.name], kernel=words.KERNELS[field])
            found[field] = Part(f"{term.name}.{field}", label, function, signature, number)
    return found


@kernel(internal=True, fastmath=FAST)
def forces(body, state, scratch, q, v):
    """The forces of all terms, kg px/s², into `scratch.fx` and `scratch.fy`.

    This and those below are those of all terms together. One that is not loaded makes the result NaN.
    """
    clear(whole_eights(body.masses + 1), scratch.fx, scratch.fy)
    around = body.environment
    for i in range(around.acting.size):
        at = around.calls[around.acting[i] * _OF_TERM + _FORCES]
        if at > 0:
            _call_forces(at, body, state, scratch, q, v)
        elif at == 0:
            scratch.fx[1] = np.nan


@kernel(internal=True, fastmath=FAST)
def write_energies(body, state, q, out):
    """Write the energies of `WITH_ENERGY`, kg px²/s², into `out`, from `OTHERS` on."""
    around = body.environment
    out[OTHERS:] = 0.0
    for i in range(around.acting.size):
        term = around.acting[i]
        at = around.calls[term * _OF_TERM + _ENERGY]
        if at > 0:
            out[OTHERS + _ENERGY_AT[term]] = _call_energy(at, body, state, q)
        elif at == 0:
            out[OTHERS] = np.nan


@kernel(internal=True, fastmath=FAST)
def add_power(body, state, balance, q, v, part):
    """See `Term.add_power`."""
    around = body.environment
    balance.work.air += part * power_of_still_air(body, state, v)
    for i in range(around.acting.size):
        at = around.calls[around.acting[i] * _OF_TERM + _POWER]
        if at > 0:
            _call_power(at, body, state, balance, q, v, part)
        elif at == 0:
            balance.work.air = np.nan


@kernel(internal=True, fastmath=FAST)
def add_derivatives(body, state, matrix, q, v, g, definite):
    """See `Term.add_derivatives`."""
    around = body.environment
    add_derivatives_of_still_air(body, state, matrix, v, g)
    for i in range(around.acting.size):
        at = around.calls[around.acting[i] * _OF_TERM + _DERIVATIVES]
        if at > 0:
            _call_derivatives(at, body, state, matrix, q, v, g, definite)
        elif at == 0:
            matrix.blocks[0] = np.nan


@kernel(fastmath=FAST)
def add_damping_product(body, state, q, v, z, factor, out):
    """out += factor Jv z, with the derivatives Jv of accelerations by velocities, 1/s, at positions q and
    velocities v; `out` has no part across rails. See `Term.add_damping`."""
    around = body.environment
    add_damping_of_still_air(body, state, v, z, factor, out)
    for i in range(around.acting.size):
        at = around.calls[around.acting[i] * _OF_TERM + _DAMPING]
        if at > 0:
            _call_damping(at, body, state, q, v, z, factor, out)
        elif at == 0:
            out[1] = np.nan
    keep_on_rails(body, out)


@kernel(internal=True, fastmath=FAST)
def impact_time(body, state, q, v, a, h):
    """See `Term.impact_time`."""
    around, shortest = body.environment, np.inf
    for i in range(around.acting.size):
        at = around.calls[around.acting[i] * _OF_TERM + _IMPACT]
        if at > 0:
            shortest = min(shortest, _call_impact(at, body, state, q, v, a, h))
        elif at == 0:
            shortest = np.nan
    return shortest


@kernel(internal=True, fastmath=FAST)
def kink_fraction(problem, q, v, to_q, to_v, h, tolerance):
    """See `Term.kink_fraction`; the tolerance is that of the method, px per second."""
    body, state, part = problem.body, problem.state, 1.0
    around = body.environment
    for i in range(around.acting.size):
        at = around.calls[around.acting[i] * _OF_TERM + _KINK]
        if at > 0:
            part = min(part, _call_kink(at, body, state, q, v, to_q, to_v, h, UNSEEN * tolerance))
        elif at == 0:
            part = np.nan
    return min(part, LARGEST_PART) if part < 1.0 else 1.0


# ------------------------------------------------------------------------- accelerations
@kernel(noalias=True, fastmath=FAST)
def any_accelerations(body, state, scratch, q, v, a):
    """Like `accelerations`, of any body."""
    eight_at_a_time()
    slots = q.size // 2
    forces(body, state, scratch, q, v)
    accelerations_by(body, state, scratch, v[:slots], v[slots:], a)
    keep_on_rails(body, a)


@kernel(fastmath=FAST)
def braked_accelerations(body, state, scratch, q, v, a):
    """Like `accelerations`, of a body in still air under a law that is not the tutorial's."""
    at = body.environment.calls[_CHAIN if is_chain_like(body) else _ANY]
    if at > 0:
        _call_accelerations(at, body, state, scratch, q, v, a)
    else:
        a[1] = np.nan
    brake(body, state, v, a)
    keep_on_rails(body, a)


@kernel(fastmath=FAST)
def accelerations(body, state, scratch, q, v, a):
    """Accelerations of all masses at positions q and velocities v; zero where a mass is held.

    q, v and a are flat: x of every slot, then y of every slot.
    """
    path = _CHAIN if is_chain_like(body) else _ANY
    at = body.environment.calls[_BRAKED if body.environment.air.brakes else path]
    if at > 0:
        _call_accelerations(at, body, state, scratch, q, v, a)
    else:
        a[1] = np.nan


_PATHS = {
    number: Part(function.py_func.__name__, label, function, INDIRECT_CALLS["accelerations"], number)
    for number, label, function in (
        (_CHAIN, Text("accelerations in chains"), chain_accelerations),
        (_ANY, Text("accelerations in any body"), any_accelerations),
        (_BRAKED, Text("accelerations in air"), braked_accelerations),
    )
}
_BY_TERM = [_parts_of(index, term) for index, term in enumerate(TERMS)]

PARTS = (*_PATHS.values(), *(part for parts in _BY_TERM for part in parts.values()))
"""All kernels of forces that are compiled by themselves."""


def paths_of(body: Body) -> tuple[Part, ...]:
    """The kernels that compute the accelerations of a body; each calls the next one."""
    braked = (_PATHS[_BRAKED],) if body.environment.air.brakes else ()
    return *braked, _PATHS[_CHAIN if is_chain_like.py_func(body) else _ANY]


def parts_of(body: Body, *fields: str) -> tuple[str, ...]:
    """The names of some kernels, such as "add_forces", of the terms that act on a body."""
    acting = (_BY_TERM[index] for index in body.environment.acting.tolist())
    return tuple(parts[field].name for parts in acting for field in fields if field in parts)
