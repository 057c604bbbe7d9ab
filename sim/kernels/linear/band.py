"""The rows of the matrix of an implicit step on a chain.

The matrix is a I - g Jv - Jx, where Jx and Jv are the derivatives of the accelerations with respect to
positions and velocities. Velocities are eliminated, so there are two unknowns per mass. On a chain the matrix
has five diagonals of 2×2 blocks; `two_sided_lu` factorises it.

Rows are eliminated one after another. Everything before that, the derivatives of the forces and the rows that
follow from them, is computed here for a chunk of springs at a time, in vectorised loops.
"""

from __future__ import annotations

import numpy as np

from ..core.jit import FAST, kernel
from ..core.roots import inverse_root
from ..core.vectors import from_to
from ..forces.laws import CONSERVATIVE, TUTORIAL, is_sine
from .blocks import joint_blocks, minus, plus, scaled, spring_block

CHUNK = 16
"""Number of springs whose derivatives are computed before their rows are eliminated."""
_VECTOR = 8
"""Number of springs that a vectorised loop processes at a time."""
_STRIDE = _VECTOR + CHUNK + _VECTOR
"""Length of the array of each kind of number: a chunk, and on both sides room for the end of the last one."""

_OWN, _AA, _AB, _BA, _BB, _KINDS = 0, 4, 8, 12, 16, 20
"""Kinds of numbers, four for each block: the derivative of a spring's tension by its own vector; the blocks
that the joint between it and the next spring adds, named as in `joint_blocks`; and the number of these
kinds."""
L2, L1, D, U1, U2, _ALL = 36, 40, 44, 48, 52, 56
"""The same for the five blocks of the row of the mass at which a spring begins; and the number of all kinds.
The rows are 4 kB away from the derivatives that they are built from: LLVM does not vectorise a loop that
might load soon after what it has stored."""

PARTS = _ALL * _STRIDE
"""Length of one half of `Matrix.parts`: for each kind in turn, the numbers of a chunk side by side."""

_ZERO = (0.0, 0.0, 0.0, 0.0)
"""The zero block."""
_ONE = (1.0, 0.0, 0.0, 1.0)
"""The unit block."""


@kernel(forceinline=True)
def begin(parts, k):
    """Initialise before the first chunk: there are no springs k and k + 1 on one side of it."""
    for kind in range(_KINDS):
        parts[at(kind, k)], parts[at(kind, k + 1)] = 0.0, 0.0


@kernel(forceinline=True)
def hand_on(parts, k, to):
    """Copy springs k and k + 1 of this chunk to springs `to` and `to` + 1 of the next."""
    for kind in range(_KINDS):
        parts[at(kind, to)], parts[at(kind, to + 1)] = parts[at(kind, k)], parts[at(kind, k + 1)]


@kernel(forceinline=True)
def put_empty_row(parts, k):
    """Set the chunk's row k to that of the unit matrix."""
    for kind in (L2, L1, U1, U2):
        put(parts, at(kind, k), _ZERO)
    put(parts, at(D, k), _ONE)


@kernel(internal=True, fastmath=FAST)
def put_rows(body, state, q, v, a, g, definite, first, start, stop, offset, parts):
    """Compute the rows of a chunk and write them into `parts`.

    Args:
        body, state, q, v, a, g, definite: as of `factorise_chain`.
        first: number of the chunk's row 0 in the matrix.
        start, stop: springs of the chunk whose derivatives are computed; the two on one side are known.
        offset: distance of the rows from these springs: 0 if the known springs come before them, 2 if they
            come after.
        parts: half of `Matrix.parts`.
    """
    _derive_springs(body, state, q, v, g, definite, first, start, stop, parts)
    if body.joints:
        if definite:
            _derive_joints(body, state, q, v, g, CONSERVATIVE, True, True, first, start, stop, parts)
        elif body.law == TUTORIAL and not body.joint_damped:
            _derive_joints(body, state, q, v, g, TUTORIAL, False, False, first, start, stop, parts)
        elif body.law == CONSERVATIVE and not body.joint_damped:
            _derive_joints(body, state, q, v, g, CONSERVATIVE, False, False, first, start, stop, parts)
        else:
            _derive_joints(body, state, q, v, g, body.law, True, False, first, start, stop, parts)
    # There is no spring n - 1, nor a joint before it.
    n = body.masses
    for s in range(max(n - 2, first + start), min(n, first + stop)):
        for kind in range(_AA if s == n - 2 else _OWN, _KINDS):
            parts[at(kind, s - first)] = 0.0
    _build_rows(state, v, a, g, first, start + offset, stop + offset, parts)


@kernel(inline="always")
def at(kind, k):
    """Index in `Matrix.parts` of a number of the chunk's spring k; k may exceed the chunk by two on either
    side.

    It is inlined by numba, since numba otherwise compiles a copy of the caller for every constant `kind`.
    """
    return np.uint64(_STRIDE * kind + _VECTOR + k)


@kernel(forceinline=True, fastmath=FAST)
def _derive_springs(body, state, q, v, g, definite, first, start, stop, parts):
    for k in range(start, stop):
        s = np.uint64(first + k)
        one, other = first + k + 1, first + k + 2
        vector, rate = from_to(q, one, other), from_to(v, one, other)
        inv = _inverse_of(vector, body.softening)
        block = spring_block(
            body.stiffness[s], body.damping[s], state.pull[s], inv, vector, rate, g, definite
        )
        put(parts, at(_OWN, k), block)


@kernel(forceinline=True, fastmath=FAST)
def _derive_joints(body, state, q, v, g, law, joint_damped, definite, first, start, stop, parts):
    """`law`, `joint_damped` and `definite` are constants in every call, so that each gets its own loop."""
    soft = body.softening
    for k in range(start, stop):
        index, other, third = np.uint64(first + k + 1), first + k + 2, first + k + 3
        vector, after = from_to(q, index, other), from_to(q, other, third)
        rate, rate_after, damping, rest = (0.0, 0.0), (0.0, 0.0), 0.0, 0.0
        if joint_damped:
            rate, rate_after = from_to(v, index, other), from_to(v, other, third)
            damping = body.torque_damping[index]
        if not is_sine(law):
            rest = state.torque_rest[index]
        aa, ab, ba, bb = joint_blocks(
            law,
            body.torque_size[index],
            state.torque_cos[index],
            state.torque_sin[index],
            rest,
            damping,
            vector,
            after,
            _inverse_of(vector, soft),
            _inverse_of(after, soft),
            soft,
            rate,
            rate_after,
            g,
            definite,
        )
        put(parts, at(_AA, k), aa)
        put(parts, at(_AB, k), ab)
        put(parts, at(_BA, k), ba)
        put(parts, at(_BB, k), bb)


@kernel(forceinline=True, fastmath=FAST)
def _inverse_of(vector, softening):
    """1 / the length of a spring's vector, in vectorised loops."""
    return inverse_root(vector[0] * vector[0] + vector[1] * vector[1] + softening)


@kernel(forceinline=True, fastmath=FAST)
def put(parts, i, block):
    """Store a block: its first number at index i, and each other number one stride after the last."""
    stride = np.uint64(_STRIDE)
    parts[i] = block[0]
    parts[i + stride] = block[1]
    parts[i + stride + stride] = block[2]
    parts[i + stride + stride + stride] = block[3]


@kernel(forceinline=True, fastmath=FAST)
def part(parts, i):
    """Load a block that `put` has stored."""
    stride = np.uint64(_STRIDE)
    return parts[i], parts[i + stride], parts[i + stride + stride], parts[i + stride + stride + stride]


@kernel(forceinline=True, fastmath=FAST)
def _build_rows(state, v, a, g, first, start, stop, parts):
    """Build rows from the derivatives of each spring's tension by its own vector and its neighbours'."""
    slots = v.size // 2
    for k in range(start, stop):
        m = np.uint64(first + k + 1)
        w, drag = state.inverse_mass[m], 2.0 * state.air[m] * g
        last_back, back = part(parts, at(_BA, k - 2)), part(parts, at(_BA, k - 1))
        last_ahead, ahead = part(parts, at(_AB, k - 1)), part(parts, at(_AB, k))
        last_own, own = _whole(parts, k - 1), _whole(parts, k)
        diagonal = scaled(-w, minus(plus(last_own, own), plus(last_ahead, back)))
        diagonal = (
            diagonal[0] + a + drag * abs(v[m]),
            diagonal[1],
            diagonal[2],
            diagonal[3] + a + drag * abs(v[np.uint64(slots) + m]),
        )
        put(parts, at(L2, k), scaled(w, last_back))
        put(parts, at(L1, k), scaled(w, minus(last_own, plus(last_back, back))))
        put(parts, at(D, k), diagonal)
        put(parts, at(U1, k), scaled(w, minus(own, plus(last_ahead, ahead))))
        put(parts, at(U2, k), scaled(w, ahead))


@kernel(forceinline=True, fastmath=FAST)
def _whole(parts, k):
    """The derivative of a spring's tension by its own vector, with the joints at both its ends."""
    return plus(part(parts, at(_OWN, k)), plus(part(parts, at(_AA, k)), part(parts, at(_BB, k - 1))))
