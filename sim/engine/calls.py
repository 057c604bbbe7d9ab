"""Calling a kernel through its address.

numba compiles a copy of a kernel into every kernel that calls it. Large kernels with many callers are
compiled once instead, and called through an address that is kept in the `Problem`, under the kernel's name,
which costs some nanoseconds.
"""

from __future__ import annotations

from numba import types

from .addresses import calls
from .jit import kernel
from .tables import Body, Drive, Matrix, Problem, Scratch, State

FLOATS = types.Array(types.float64, 1, "C")
"""numba's type of a one-dimensional array of floats."""
_FLOAT = types.float64
_BODY, _STATE, _SCRATCH, _MATRIX = (table.numba_type for table in (Body, State, Scratch, Matrix))
_PROBLEM, _DRIVE = Problem.numba_type, Drive.numba_type

BY_ADDRESS = {
    "accelerations": types.void(_BODY, _STATE, _SCRATCH, FLOATS, FLOATS, FLOATS),
    "accumulate_work": types.void(_PROBLEM, _DRIVE, _FLOAT, FLOATS, FLOATS, FLOATS, _FLOAT),
    "factorise_matrix": types.boolean(_BODY, _STATE, _MATRIX, FLOATS, FLOATS, _FLOAT, _FLOAT, types.boolean),
    "solve_matrix": types.void(_BODY, _STATE, _MATRIX, FLOATS),
    "add_damping_product": types.void(_BODY, _STATE, FLOATS, FLOATS, FLOATS, _FLOAT, FLOATS),
    "no_tunnelling": types.boolean(_BODY, FLOATS, FLOATS),
    "part_to_try": _FLOAT(_PROBLEM, *[FLOATS] * 5, _FLOAT, _FLOAT),
    "part_to_slip": types.float64(_PROBLEM, FLOATS, FLOATS, FLOATS, FLOATS, _FLOAT, _FLOAT),
    "stick": types.void(_PROBLEM, FLOATS, FLOATS, FLOATS, FLOATS, _FLOAT),
    "settle": types.boolean(_PROBLEM, *[FLOATS] * 4, _FLOAT),
}
"""Signatures of the kernels that are called through their addresses, by their names."""

_accelerations = calls(BY_ADDRESS["accelerations"])
_accumulate_work = calls(BY_ADDRESS["accumulate_work"])
_factorise_matrix = calls(BY_ADDRESS["factorise_matrix"])
_solve_matrix = calls(BY_ADDRESS["solve_matrix"])
_add_damping_product = calls(BY_ADDRESS["add_damping_product"])
_no_tunnelling = calls(BY_ADDRESS["no_tunnelling"])
_part_to_try = calls(BY_ADDRESS["part_to_try"])
_part_to_slip = calls(BY_ADDRESS["part_to_slip"])
_stick = calls(BY_ADDRESS["stick"])
_settle = calls(BY_ADDRESS["settle"])


@kernel(inline="always")
def accelerate(problem, q, v, a):
    """`forces.all.accelerations` of the problem's body, or `forces.plasticity.yielding_accelerations`."""
    _accelerations(problem.accelerations, problem.body, problem.state, problem.scratch, q, v, a)


@kernel(inline="always")
def accumulate(problem, drive, t, q, v, a, h):
    """`solve.balance.work.accumulate_work`."""
    _accumulate_work(problem.accumulate_work, problem, drive, t, q, v, a, h)


@kernel(inline="always")
def factorise(problem, q, v, a, g, definite):
    """`solve.linear.implicit.factorise_matrix` of the problem's body."""
    body, state, matrix = problem.body, problem.state, problem.matrix
    return _factorise_matrix(problem.factorise_matrix, body, state, matrix, q, v, a, g, definite)


@kernel(inline="always")
def solve(problem, b):
    """`solve.linear.implicit.solve_matrix` of the problem's body."""
    _solve_matrix(problem.solve_matrix, problem.body, problem.state, problem.matrix, b)


@kernel(inline="always")
def add_damping(problem, q, v, z, factor, out):
    """`forces.all.add_damping_product` of the problem's body."""
    _add_damping_product(problem.add_damping_product, problem.body, problem.state, q, v, z, factor, out)


@kernel(inline="always")
def no_tunnelling(problem, q, to_q):
    """`forces.touch.contact.no_tunnelling`, where there is contact."""
    return problem.no_tunnelling == 0 or _no_tunnelling(problem.no_tunnelling, problem.body, q, to_q)


@kernel(inline="always")
def part_to_try(problem, old, new, h, tolerance):
    """The part of a step to try instead of it: by `forces.plasticity.part_to_try`, where anything yields or
    breaks, and by `forces.touch.friction_history.part_to_slip`, where there are tangential springs."""
    part = 1.0
    if problem.part_to_try != 0:
        part = _part_to_try(problem.part_to_try, problem, old.q, old.v, new.q, new.v, new.a, h, tolerance)
    if problem.part_to_slip != 0:
        part = min(
            part, _part_to_slip(problem.part_to_slip, problem, old.q, old.v, new.q, new.v, h, tolerance)
        )
    return part


@kernel(inline="always")
def settle(problem, old, new, h):
    """`forces.plasticity.settle` after a step, where anything yields or breaks."""
    return problem.settle != 0 and _settle(problem.settle, problem, old.q, old.v, new.q, new.v, h)


@kernel(inline="always")
def stick(problem, old, new, h):
    """`forces.touch.friction_history.stick` after a step, where there are tangential springs."""
    if problem.stick != 0:
        _stick(problem.stick, problem, old.q, old.v, new.q, new.v, h)
