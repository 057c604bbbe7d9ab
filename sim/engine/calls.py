"""Calls of kernels through their addresses.

numba compiles a copy of a kernel into every kernel that calls it. Large kernels with many callers are instead
compiled once and called through an address stored in the `Problem` under the kernel's name, which costs a few
nanoseconds.
"""

from __future__ import annotations

from numba import types

from .addresses import calls
from .jit import kernel
from .tables import Body, Matrix, PrescribedMotion, Problem, Scratch, State

FLOATS = types.Array(types.float64, 1, "C")
"""numba type of a one-dimensional array of floats."""
_FLOAT = types.float64
_BODY, _STATE, _SCRATCH, _MATRIX = (table.numba_type for table in (Body, State, Scratch, Matrix))
_PROBLEM, _DRIVE = Problem.numba_type, PrescribedMotion.numba_type

INDIRECT_CALLS = {
    "accelerations": types.void(_BODY, _STATE, _SCRATCH, FLOATS, FLOATS, FLOATS),
    "accumulate_work": types.void(_PROBLEM, _DRIVE, _FLOAT, FLOATS, FLOATS, FLOATS, _FLOAT),
    "factorise_matrix": types.boolean(_BODY, _STATE, _MATRIX, FLOATS, FLOATS, _FLOAT, _FLOAT, types.boolean),
    "solve_matrix": types.void(_BODY, _STATE, _MATRIX, FLOATS),
    "add_damping_product": types.void(_BODY, _STATE, FLOATS, FLOATS, FLOATS, _FLOAT, FLOATS),
    "no_tunnelling": types.boolean(_BODY, FLOATS, FLOATS),
    "event_fraction": _FLOAT(_PROBLEM, *[FLOATS] * 5, _FLOAT, _FLOAT),
    "kink_fraction": _FLOAT(_PROBLEM, *[FLOATS] * 4, _FLOAT, _FLOAT),
    "slip_fraction": types.float64(_PROBLEM, FLOATS, FLOATS, FLOATS, FLOATS, _FLOAT, _FLOAT),
    "update_friction_history": types.boolean(_PROBLEM, FLOATS, FLOATS, FLOATS, FLOATS, _FLOAT),
    "commit_plasticity": types.boolean(_PROBLEM, *[FLOATS] * 4, _FLOAT),
}
"""Signatures of the kernels that are called through their addresses, by name."""

_accelerations = calls(INDIRECT_CALLS["accelerations"])
_accumulate_work = calls(INDIRECT_CALLS["accumulate_work"])
_factorise_matrix = calls(INDIRECT_CALLS["factorise_matrix"])
_solve_matrix = calls(INDIRECT_CALLS["solve_matrix"])
_add_damping_product = calls(INDIRECT_CALLS["add_damping_product"])
_no_tunnelling = calls(INDIRECT_CALLS["no_tunnelling"])
_event_fraction = calls(INDIRECT_CALLS["event_fraction"])
_kink_fraction = calls(INDIRECT_CALLS["kink_fraction"])
_slip_fraction = calls(INDIRECT_CALLS["slip_fraction"])
_update_friction_history = calls(INDIRECT_CALLS["update_friction_history"])
_commit_plasticity = calls(INDIRECT_CALLS["commit_plasticity"])


@kernel(inline="always")
def accelerate(problem, q, v, a):
    """Call `forces.all.accelerations` of the problem's body, or
    `forces.plasticity.yielding_accelerations`."""
    _accelerations(problem.accelerations, problem.body, problem.state, problem.scratch, q, v, a)


@kernel(inline="always")
def accumulate(problem, drive, t, q, v, a, h):
    """Call `solve.balance.work.accumulate_work`."""
    _accumulate_work(problem.accumulate_work, problem, drive, t, q, v, a, h)


@kernel(inline="always")
def factorise(problem, q, v, a, g, definite):
    """Call `solve.linear.implicit.factorise_matrix` of the problem's body."""
    body, state, matrix = problem.body, problem.state, problem.matrix
    return _factorise_matrix(problem.factorise_matrix, body, state, matrix, q, v, a, g, definite)


@kernel(inline="always")
def solve(problem, b):
    """Call `solve.linear.implicit.solve_matrix` of the problem's body."""
    _solve_matrix(problem.solve_matrix, problem.body, problem.state, problem.matrix, b)


@kernel(inline="always")
def add_damping(problem, q, v, z, factor, out):
    """Call `forces.all.add_damping_product` of the problem's body."""
    _add_damping_product(problem.add_damping_product, problem.body, problem.state, q, v, z, factor, out)


@kernel(inline="always")
def no_tunnelling(problem, q, to_q):
    """Call `forces.touch.contact.no_tunnelling`, where there is contact."""
    return problem.no_tunnelling == 0 or _no_tunnelling(problem.no_tunnelling, problem.body, q, to_q)


@kernel(inline="always")
def event_fraction(problem, old, new, h, tolerance):
    """Return the fraction of a step to try instead of it: from `forces.plasticity.event_fraction`, where
    anything yields or breaks, from `forces.all.kink_fraction`, where a force has kinks, and from
    `forces.touch.friction_history.slip_fraction`, where there are tangential springs."""
    part = 1.0
    if problem.event_fraction != 0:
        part = _event_fraction(
            problem.event_fraction, problem, old.q, old.v, new.q, new.v, new.a, h, tolerance
        )
    if problem.kink_fraction != 0:
        part = min(
            part, _kink_fraction(problem.kink_fraction, problem, old.q, old.v, new.q, new.v, h, tolerance)
        )
    if problem.slip_fraction != 0:
        part = min(
            part, _slip_fraction(problem.slip_fraction, problem, old.q, old.v, new.q, new.v, h, tolerance)
        )
    return part


@kernel(inline="always")
def commit_plasticity(problem, old, new, h):
    """Call `forces.plasticity.commit_plasticity` after a step, where anything yields or breaks."""
    return problem.commit_plasticity != 0 and _commit_plasticity(
        problem.commit_plasticity, problem, old.q, old.v, new.q, new.v, h
    )


@kernel(inline="always")
def update_friction_history(problem, old, new, h):
    """Call `forces.touch.friction_history.update_friction_history` after a step, where there are tangential
    springs; return whether a force has jumped."""
    return problem.update_friction_history != 0 and _update_friction_history(
        problem.update_friction_history, problem, old.q, old.v, new.q, new.v, h
    )
