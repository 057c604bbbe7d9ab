"""Contact in the matrix of an implicit step.

Which masses touch which springs changes all the time, so the blocks that join them are not in the pattern.
What contact adds to the blocks of a mass with itself and of the two ends of a spring is, and is factorised
with the rest. With that matrix A and the other blocks R, a system (A + R) x = b is solved as x + A^-1 R x =
A^-1 b by GMRES (Saad & Schultz 1986). Few iterations suffice, about as many as there are directions in which
things touch, or fewer where the step is short. If they do not, the result is infinite, and the step is
refused.
"""

from __future__ import annotations

import math

from ..around.bounce import slopes_of_push
from ..around.broad_phase import meeting, pairs_of, segment, update_pairs
from ..around.contact import moving, pair_terms, roughness
from ..core.jit import FAST, FUSED, kernel
from .sparse import solve_sparse
from .vectors import add_multiple, dot

_ACCURACY = 1e-12
"""Residual, relative to the right-hand side, at which the iteration ends."""
_CYCLES = 4
"""Largest number of times that it begins with a new Krylov space."""

TOUCHING_G, TOUCHING_DEFINITE, TOUCHING_PAIRS = 0, 1, 2
"""In `Matrix.touching`: factor of the derivatives by velocities, 1/s, whether what could make the matrix
indefinite is left out, and the number of pairs that touch."""


@kernel(forceinline=True, fastmath=FUSED)
def change_of_pair(body, pair, d, g, definite):
    """Derivatives of a pair's F, and of G less F times that of t, by positions and g times by velocities.

    Args:
        pair: of `_pair`.
        d: along what the derivative is taken: w_i times the changes of the three masses, and c_i times them.
        g: 1/s.
        definite: leave out what could make the matrix of an implicit step indefinite.
    """
    contact = body.surroundings.contact
    t, ex, ey, inverse, vx, vy, wx, wy, terms = pair
    dx, dy, fx, fy = d
    push, friction, _, r, nx, ny, speed, along, lx, ly = terms
    square = ex * ex + ey * ey
    rise, by_speed = slopes_of_push(contact.stiffness, contact.loss, contact.distance - r, speed)
    short, rough = square < contact.distance * contact.distance, roughness(contact, square)
    held = math.tanh(along / contact.slip)
    stuck = rough * push * (1.0 - held * held) / contact.slip
    away = nx * dx + ny * dy
    past = nx * dy - ny * dx
    slide = past - (fx * lx + fy * ly)
    if definite:
        more, drag = (g * by_speed - rise) * away, g * stuck * slide
        return more * nx + drag * ny, more * ny - drag * nx, drag * lx, drag * ly
    if 0.0 < t < 1.0:
        turn = (ex * fy - ey * fx) * inverse
        shift = (ex * dx + ey * dy + r * (nx * fx + ny * fy)) * inverse
    else:
        turn, shift = past / (r + 1e-300), 0.0
    stretch = (ex * fx + ey * fy) * inverse
    spin = (ex * wy - ey * wx) * inverse
    faster = (nx * vy - ny * vx) * turn - shift * (nx * wx + ny * wy)
    sliding = (
        2.0 * r * spin * stretch
        - shift * (nx * wy - ny * wx)
        - speed * turn
        - away * spin
        - r * (fx * wy - fy * wx) * inverse
    )
    more = by_speed * (faster + g * away) - rise * away
    drag = rough * held * more + stuck * (sliding + g * slide)
    if short:
        drag += 2.0 * friction * stretch
    along_n, across_n = more + friction * turn, push * turn - drag
    longer = drag - 2.0 * friction * stretch
    lever, arm = friction * away * inverse, friction * r * inverse
    return (
        nx * along_n - ny * across_n,
        ny * along_n + nx * across_n,
        lx * longer - ey * lever - fy * arm - shift * (push * nx + friction * ny),
        ly * longer + ex * lever + fx * arm - shift * (push * ny - friction * nx),
    )


@kernel(forceinline=True, fastmath=FUSED)
def _pair(body, w, m, a, b, line, motion, met, vx, vy):
    """What the derivatives of a pair depend on; arguments as of `contact.pair_terms`."""
    _, _, ex, ey, inverse = line
    sx, sy, wx, wy = motion
    terms = pair_terms(body, w, m, a, b, line, motion, met, vx, vy)
    return met[0], ex, ey, inverse, vx - sx - met[0] * wx, vy - sy - met[0] * wy, wx, wy, terms


@kernel(forceinline=True, fastmath=FUSED)
def drag_of_pair(body, pair, d):
    """Derivatives of a pair's F and G by velocities; arguments as of `change_of_pair`."""
    contact = body.surroundings.contact
    _, ex, ey, _, _, _, _, _, terms = pair
    push, _, _, r, nx, ny, speed, along, lx, ly = terms
    _, by_speed = slopes_of_push(contact.stiffness, contact.loss, contact.distance - r, speed)
    held = math.tanh(along / contact.slip)
    more = by_speed * (nx * d[0] + ny * d[1])
    slide = nx * d[1] - ny * d[0] - (d[2] * lx + d[3] * ly)
    rough = roughness(contact, ex * ex + ey * ey)
    drag = rough * (held * more + push * (1.0 - held * held) / contact.slip * slide)
    return more * nx + drag * ny, more * ny - drag * nx, drag * lx, drag * ly


@kernel(internal=True, fastmath=FUSED)
def add_contact(body, state, matrix, q, v, g, definite):
    """Add what contact adds to the blocks in the pattern, and remember where, for `solve_with_contact`."""
    contact, slots = body.surroundings.contact, q.size // 2
    touched, targets = matrix.touched, matrix.spring_target
    for j in range(q.size):
        touched[0, j], touched[1, j] = q[j], v[j]
    for i in range(slots):
        touched[2, i] = state.inverse_mass[i]
    x, y, vx, vy, w = q[:slots], q[slots:], v[:slots], v[slots:], state.inverse_mass
    near, count = contact.distance * contact.distance, 0
    update_pairs(body, x, y)
    for s in range(body.springs):
        first, behind = pairs_of(body, s)
        a, b = body.spring_a[s], body.spring_b[s]
        line, motion = segment(x, y, a, b), moving(vx, vy, a, b)
        for p in range(first, behind):
            m = contact.member[p]
            met = meeting(line, x[m], y[m])
            if met[1] * met[1] + met[2] * met[2] < near:
                count += 1
                pair = _pair(body, w, m, a, b, line, motion, met, vx[m], vy[m])
                t, u = met[0], 1.0 - met[0]
                for axis in range(2):
                    one, other = (1.0, 0.0) if axis == 0 else (0.0, 1.0)
                    by_m = change_of_pair(body, pair, (one, other, 0.0, 0.0), g, definite)
                    by_e = change_of_pair(body, pair, (0.0, 0.0, one, other), g, definite)
                    for part in range(2):
                        e = 2 * part + axis
                        f, h, fe, he = by_m[part], by_m[2 + part], by_e[part], by_e[2 + part]
                        matrix.blocks[4 * matrix.of_mass[m] + e] += f
                        matrix.blocks[4 * targets[4 * s] + e] += t * t * f - t * (h + fe) + he
                        matrix.blocks[4 * targets[4 * s + 1] + e] += t * u * f + t * fe - u * h - he
                        matrix.blocks[4 * targets[4 * s + 2] + e] += u * t * f + t * h - u * fe - he
                        matrix.blocks[4 * targets[4 * s + 3] + e] += u * u * f + u * (h + fe) + he
    matrix.touching[TOUCHING_G], matrix.touching[TOUCHING_PAIRS] = g, count
    matrix.touching[TOUCHING_DEFINITE] = 1.0 if definite else 0.0


@kernel(internal=True, fastmath=FUSED)
def add_contact_damping(body, w, q, v, z, factor, out):
    """out += factor Jv z, with the part of Jv that contact adds at positions q and velocities v."""
    contact, slots = body.surroundings.contact, q.size // 2
    x, y, vx, vy, zx, zy = q[:slots], q[slots:], v[:slots], v[slots:], z[:slots], z[slots:]
    near = contact.distance * contact.distance
    update_pairs(body, x, y)
    for s in range(body.springs):
        first, behind = pairs_of(body, s)
        a, b = body.spring_a[s], body.spring_b[s]
        line, motion = segment(x, y, a, b), moving(vx, vy, a, b)
        for p in range(first, behind):
            m = contact.member[p]
            met = meeting(line, x[m], y[m])
            if met[1] * met[1] + met[2] * met[2] < near:
                pair = _pair(body, w, m, a, b, line, motion, met, vx[m], vy[m])
                t, u = met[0], 1.0 - met[0]
                ex, ey = zx[b] - zx[a], zy[b] - zy[a]
                d = (zx[m] - zx[a] - t * ex, zy[m] - zy[a] - t * ey, ex, ey)
                px, py, gx, gy = drag_of_pair(body, pair, d)
                wm, wa, wb = factor * w[m], factor * w[a], factor * w[b]
                out[m] += wm * px
                out[slots + m] += wm * py
                out[a] -= wa * (u * px + gx)
                out[slots + a] -= wa * (u * py + gy)
                out[b] += wb * (gx - t * px)
                out[slots + b] += wb * (gy - t * py)


@kernel(internal=True, fastmath=FAST)
def solve_with_contact(body, matrix, b):
    """Like `sparse.solve_sparse`, with all of contact."""
    solve_sparse(body, matrix, b)
    if not body.surroundings.contact.present or matrix.touching[TOUCHING_PAIRS] == 0.0:
        return
    space, hessenberg, width = matrix.krylov, matrix.hessenberg, matrix.hessenberg.shape[1]
    x, right, most = space[width], space[width + 1], width - 1
    masses, slots = body.masses, b.size // 2
    cosine, sine, rest = hessenberg[width], hessenberg[width + 1], hessenberg[width + 2]
    for j in range(b.size):
        x[j], right[j] = 0.0, 0.0
    add_multiple(masses, 1.0, b, right)
    whole, cycle, size = 0.0, 0, math.inf
    while cycle < _CYCLES:
        # The residual of what has been found so far.
        if cycle == 0:
            for j in range(b.size):
                space[0, j] = right[j]
        else:
            _couple(body, matrix, x, space[0])
            solve_sparse(body, matrix, space[0])
            for j in range(b.size):
                space[0, j] = right[j] - x[j] - space[0, j]
        size = math.sqrt(dot(masses, space[0], space[0]))
        whole = size if cycle == 0 else whole
        if not size > _ACCURACY * whole:
            break
        for j in range(b.size):
            space[0, j] /= size
        rest[0], steps = size, 0
        while steps < most and abs(rest[steps]) > _ACCURACY * whole:
            k = steps
            new = space[k + 1]
            _couple(body, matrix, space[k], new)
            solve_sparse(body, matrix, new)
            for j in range(b.size):
                new[j] += space[k, j]
            for i in range(k + 1):
                along = dot(masses, space[i], new)
                hessenberg[i, k] = along
                for j in range(b.size):
                    new[j] -= along * space[i, j]
            length = math.sqrt(dot(masses, new, new))
            for j in range(b.size):
                new[j] /= length + 1e-300
            for i in range(k):  # the rotations so far
                upper, lower = hessenberg[i, k], hessenberg[i + 1, k]
                hessenberg[i, k] = cosine[i] * upper + sine[i] * lower
                hessenberg[i + 1, k] = cosine[i] * lower - sine[i] * upper
            upper = hessenberg[k, k]
            diagonal = math.sqrt(upper * upper + length * length) + 1e-300
            cosine[k], sine[k] = upper / diagonal, length / diagonal
            hessenberg[k, k] = diagonal
            rest[k + 1] = -sine[k] * rest[k]
            rest[k] *= cosine[k]
            steps += 1
        size = abs(rest[steps])
        for i in range(steps - 1, -1, -1):
            for k in range(i + 1, steps):
                rest[i] -= hessenberg[i, k] * rest[k]
            rest[i] /= hessenberg[i, i]
            for j in range(b.size):
                x[j] += rest[i] * space[i, j]
        cycle += 1
        if not size > _ACCURACY * whole:
            break
    found = size <= _ACCURACY * whole
    for i in range(1, masses + 1):
        b[i], b[slots + i] = (x[i], x[slots + i]) if found else (math.inf, math.inf)


@kernel(fastmath=FUSED)
def _couple(body, matrix, z, out):
    """out = R z, with the blocks that are not in the pattern."""
    contact, slots = body.surroundings.contact, z.size // 2
    q, v, w = matrix.touched[0], matrix.touched[1], matrix.touched[2]
    x, y, vx, vy = q[:slots], q[slots:], v[:slots], v[slots:]
    g, definite = matrix.touching[TOUCHING_G], matrix.touching[TOUCHING_DEFINITE] > 0.0
    near = contact.distance * contact.distance
    for j in range(out.size):
        out[j] = 0.0
    update_pairs(body, x, y)
    for s in range(body.springs):
        first, behind = pairs_of(body, s)
        a, b = body.spring_a[s], body.spring_b[s]
        line, motion = segment(x, y, a, b), moving(vx, vy, a, b)
        for p in range(first, behind):
            m = contact.member[p]
            met = meeting(line, x[m], y[m])
            if met[1] * met[1] + met[2] * met[2] < near:
                pair = _pair(body, w, m, a, b, line, motion, met, vx[m], vy[m])
                t, u = met[0], 1.0 - met[0]
                ax, ay, bx, by = z[a], z[slots + a], z[b], z[slots + b]
                d = (-u * ax - t * bx, -u * ay - t * by, bx - ax, by - ay)
                fx, fy, _, _ = change_of_pair(body, pair, d, g, definite)
                out[m] -= w[m] * fx
                out[slots + m] -= w[m] * fy
                d = (z[m], z[slots + m], 0.0, 0.0)
                fx, fy, gx, gy = change_of_pair(body, pair, d, g, definite)
                out[a] += w[a] * (u * fx + gx)
                out[slots + a] += w[a] * (u * fy + gy)
                out[b] -= w[b] * (gx - t * fx)
                out[slots + b] -= w[b] * (gy - t * fy)
