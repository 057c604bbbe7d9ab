"""Positions from the turning and stretching of springs along a spanning forest, see `Matrix.walk`.

A long rod turns a lot in one step while it hardly stretches, and positions are strongly nonlinear in that
motion. As a complex number, the vector of a spring becomes vector * (1 + z), for any rotation.
"""

from __future__ import annotations

from ...engine.jit import FAST, kernel
from ...engine.tables import SPARE

_MIN_SQUARE = 1e-100
"""Lower bound of squared lengths in denominators, px²; any tiny number does."""


@kernel(internal=True, fastmath=FAST)
def store_direction(problem, q, step, least):
    """Add a step from positions q to the history of the springs' vectors.

    Steps that together are shorter than `least` (s) count as one, since the next step is much longer.
    """
    matrix, integrator = problem.matrix, problem.integrator
    alpha, slots = integrator.alpha, q.size // 2
    if 0.0 < alpha.last < least:
        alpha.last += step
        return
    last, older = alpha.rows[1], alpha.rows[2]
    for j in range(1, q.size - SPARE):
        older[j] = last[j]
    for i in range(matrix.walk.size):
        m = matrix.walk[i]
        p = matrix.parent[m]
        last[m], last[slots + m] = q[m] - q[p], q[slots + m] - q[slots + p]
    alpha.older = alpha.last
    alpha.last = step


@kernel(internal=True, fastmath=FAST)
def predict(problem, q, step, to_q, vector):
    """Extrapolate from positions q how each spring of the forest turned and stretched in two steps.

    z - z²/2, the logarithm of 1 + z to second order, is extrapolated as a polynomial of time. Held masses and
    those without a parent keep their positions in `to_q`; `vector` is scratch.
    """
    matrix, integrator = problem.matrix, problem.integrator
    alpha, slots = integrator.alpha, q.size // 2
    last, older = alpha.rows[1], alpha.rows[2]
    h1, h0 = alpha.last, alpha.older
    if h1 == 0.0:
        return
    c1, c0 = step / h1, 0.0
    if h0 > 0.0:
        ratio = (h1 + step) / (h0 + h1)
        c1, c0 = c1 * (1.0 + ratio), -step / h0 * ratio
    n = matrix.walk.size
    for i in range(n):
        m = matrix.walk[i]
        p, k = matrix.parent[m], slots + m
        vector[m], vector[k] = _extrapolated(
            q[m] - q[p], q[k] - q[slots + p], last[m], last[k], older[m], older[k], c1, c0
        )
    _add_up(matrix, problem.state.inverse_mass, vector, to_q)


@kernel(internal=True, fastmath=FAST)
def turn_and_stretch(matrix, inverse_mass, q, move, vector):
    """Apply an update to the positions q by turning and stretching each spring; `vector` is scratch."""
    slots, n = q.size // 2, matrix.walk.size
    for i in range(n):
        m = matrix.walk[i]
        p, k = matrix.parent[m], slots + m
        vector[m], vector[k] = _updated(
            q[m] - q[p], q[k] - q[slots + p], move[m] - move[p], move[k] - move[slots + p]
        )
    for i in range(n):
        m = matrix.walk[i]
        if matrix.parent[m] == 0 or inverse_mass[m] == 0.0:
            q[m] += move[m]
            q[slots + m] += move[slots + m]
    _add_up(matrix, inverse_mass, vector, q)


@kernel(forceinline=True, fastmath=FAST)
def _add_up(matrix, inverse_mass, vector, q):
    """Compute positions from the vectors, except of held masses and of those without a parent."""
    slots = q.size // 2
    for i in range(matrix.walk.size):
        m = matrix.walk[i]
        p = matrix.parent[m]
        if not (p == 0 or inverse_mass[m] == 0.0):
            q[m], q[slots + m] = q[p] + vector[m], q[slots + p] + vector[slots + m]


@kernel(forceinline=True, fastmath=FAST)
def _extrapolated(x, y, x1, y1, x0, y0, c1, c0):
    """Extrapolate (x, y) from (x1, y1) a step ago and (x0, y0) two ago; unchanged if it varies too much."""
    square1, square0 = max(x1 * x1 + y1 * y1, _MIN_SQUARE), max(x0 * x0 + y0 * y0, _MIN_SQUARE)
    both = 1.0 / (square1 * square0)  # one division instead of two
    re1, im1 = _logarithm(x, y, x1, y1, square0 * both)
    re0, im0 = _logarithm(x1, y1, x0, y0, square1 * both)
    stretch, turn = 1.0 + c1 * re1 + c0 * re0, c1 * im1 + c0 * im0
    turned_x, turned_y = _turned(x, y, stretch, turn)
    tame = _is_tame(stretch, turn)
    return turned_x if tame else x, turned_y if tame else y


@kernel(forceinline=True, fastmath=FAST)
def _updated(x, y, dx, dy):
    """A vector turned and stretched so that it changes by (dx, dy) to first order."""
    inverse = 1.0 / max(x * x + y * y, _MIN_SQUARE)
    stretch, turn = 1.0 + (x * dx + y * dy) * inverse, (x * dy - y * dx) * inverse
    turned_x, turned_y = _turned(x, y, stretch, turn)
    tame = _is_tame(stretch, turn)
    return turned_x if tame else x + dx, turned_y if tame else y + dy


@kernel(forceinline=True, fastmath=FAST)
def _logarithm(x, y, x0, y0, inverse):
    """The logarithm of (x + iy) / (x0 + iy0), to second order in the angle; `inverse` is 1 / (x0² + y0²)."""
    re, im = (x * x0 + y * y0) * inverse - 1.0, (y * x0 - x * y0) * inverse
    return re + 0.5 * im * im, im


@kernel(forceinline=True, fastmath=FAST)
def _turned(x, y, stretch, turn):
    """A vector turned (by Cayley's map, without trigonometry) and stretched."""
    half = 0.5 * turn
    scale = stretch / (1.0 + half * half)
    cos, sin = (1.0 - half * half) * scale, 2.0 * half * scale
    return cos * x - sin * y, sin * x + cos * y


@kernel(forceinline=True, fastmath=FAST)
def _is_tame(stretch, turn):
    # Not `and`: a loop with branches is not vectorised.
    return (stretch > 0.4) & (stretch < 2.5) & (turn > -1.4) & (turn < 1.4)
