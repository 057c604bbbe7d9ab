"""Calling a kernel through its address.

numba compiles a copy of a kernel into every kernel that calls it. Large kernels with many callers are
compiled once instead, and called through an address that is kept in the `Problem`, which costs some
nanoseconds.
"""

from __future__ import annotations

from numba import types

from ..engine.addresses import caller, intrinsic_call
from ..engine.jit import kernel
from .tables import Body, Drive, Matrix, Problem, Scratch, State

FLOATS = types.Array(types.float64, 1, "C")
"""numba's type of a one-dimensional array of floats."""
_F8 = types.float64
_BODY: tuple[types.Type, ...] = tuple(t.numba_type for t in (Body, State, Scratch))

ACCELERATIONS = types.void(*_BODY, FLOATS, FLOATS, FLOATS)
ACCUMULATE = types.void(Problem.numba_type, Drive.numba_type, _F8, FLOATS, FLOATS, FLOATS, _F8)
FACTORISE = types.boolean(
    Body.numba_type, State.numba_type, Matrix.numba_type, FLOATS, FLOATS, _F8, _F8, types.boolean
)
SOLVE = types.void(Body.numba_type, Matrix.numba_type, FLOATS)
RESISTANCE = types.void(Body.numba_type, State.numba_type, FLOATS, FLOATS, FLOATS, _F8, FLOATS)
APART = types.boolean(Body.numba_type, FLOATS, FLOATS)
OVERSTRAINED = types.boolean(Problem.numba_type, FLOATS, _F8)
SETTLE = types.boolean(Problem.numba_type, FLOATS)
"""This and the seven above: signatures of the kernels that are called through their addresses."""


@intrinsic_call
def _call_accelerations(_context, address, body, state, scratch, q, v, a):
    return caller(ACCELERATIONS)


@intrinsic_call
def _call_accumulate(_context, address, problem, drive, t, q, v, a, h):
    return caller(ACCUMULATE)


@intrinsic_call
def _call_factorise(_context, address, body, state, matrix, q, v, a, g, definite):
    return caller(FACTORISE)


@intrinsic_call
def _call_solve(_context, address, body, matrix, b):
    return caller(SOLVE)


@intrinsic_call
def _call_resistance(_context, address, body, state, q, v, z, factor, out):
    return caller(RESISTANCE)


@intrinsic_call
def _call_apart(_context, address, body, q, to_q):
    return caller(APART)


@intrinsic_call
def _call_overstrained(_context, address, problem, q, tolerance):
    return caller(OVERSTRAINED)


@intrinsic_call
def _call_settle(_context, address, problem, q):
    return caller(SETTLE)


@kernel(inline="always")
def accelerate(problem, q, v, a):
    """`forces.all.accelerations` of the problem's body."""
    _call_accelerations(problem.accelerations, problem.body, problem.state, problem.scratch, q, v, a)


@kernel(inline="always")
def accumulate(problem, drive, t, q, v, a, h):
    """`energy.work.accumulate_work`."""
    _call_accumulate(problem.accumulate, problem, drive, t, q, v, a, h)


@kernel(inline="always")
def factorise(problem, q, v, a, g, definite):
    """`linear.implicit.factorise_matrix` of the problem's body."""
    return _call_factorise(
        problem.factorise, problem.body, problem.state, problem.matrix, q, v, a, g, definite
    )


@kernel(inline="always")
def solve(problem, b):
    """`linear.implicit.solve_matrix` of the problem's body."""
    _call_solve(problem.solve, problem.body, problem.matrix, b)


@kernel(inline="always")
def add_damping(problem, q, v, z, factor, out):
    """`linear.implicit.add_damping_product` of the problem's body."""
    _call_resistance(problem.resistance, problem.body, problem.state, q, v, z, factor, out)


@kernel(inline="always")
def no_tunnelling(problem, q, to_q):
    """`forces.contact.no_tunnelling`, where there is contact."""
    return problem.apart == 0 or _call_apart(problem.apart, problem.body, q, to_q)


@kernel(inline="always")
def within_strength(problem, q, tolerance):
    """Whether no spring is strained at positions q so far beyond its limits that a step should be shorter."""
    return problem.settle == 0 or not _call_overstrained(problem.overstrained, problem, q, tolerance)


@kernel(inline="always")
def settle(problem, q):
    """`forces.limits.settle`, after a step that has led to positions q."""
    return problem.settle != 0 and _call_settle(problem.settle, problem, q)
