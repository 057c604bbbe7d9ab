"""The list of the masses that may touch each spring and each solid mass, found with a uniform grid in a hash
table.

The list holds all pairs that are nearer than the distance of contact plus a margin. As long as no mass has
moved by more than half of the margin, apart from what all move together, no other pair can touch (Verlet
1967), so it is made anew only then. That takes a time in proportion to the number of masses and springs, if
springs are about equally long.
"""

from __future__ import annotations

import math

from ...engine.bits import from_bits, size_bits
from ...engine.jit import FAST, FUSED, kernel

# Unless noted, doubling or halving one of these numbers fails no test.
_FARTHEST = 1e8
"""Coordinate, px, beyond which no pairs are looked for: such a state is refused anyway."""

_TOO_LONG = 2.0
"""Margin of a list, relative to the usual one, above which it is made anew, because it has too many pairs."""


@kernel(forceinline=True, fastmath=FUSED)
def segment(x, y, a, b):
    """The spring from mass a to mass b: its start, its vector e, and 1 / |e|², which is never infinite."""
    ex, ey = x[b] - x[a], y[b] - y[a]
    return x[a], y[a], ex, ey, 1.0 / (ex * ex + ey * ey + 1e-300)


@kernel(forceinline=True, fastmath=FUSED)
def meeting(line, x, y):
    """How a point lies to a segment: where the nearest point is, as a fraction, and the vector from there."""
    ax, ay, ex, ey, inverse = line
    dx, dy = x - ax, y - ay
    t = min(max((dx * ex + dy * ey) * inverse, 0.0), 1.0)
    return t, dx - t * ex, dy - t * ey


@kernel(internal=True, fastmath=FUSED)
def update_pairs(body, x, y):
    """Make the list anew unless it holds all pairs that touch at these positions."""
    contact = body.environment.contact
    margin = contact.number[0]
    moved = relative_move(body.masses, contact.at, x, y)
    if not (moved <= margin and margin <= _TOO_LONG * contact.margin):
        _find_pairs(body, x, y, contact.margin)


@kernel(internal=True, fastmath=FUSED)
def cover_pairs(body, x, y, margin):
    """Make the list anew unless it holds all pairs that are nearer than the distance plus a margin (px)."""
    contact = body.environment.contact
    moved = relative_move(body.masses, contact.at, x, y)
    if not moved + margin <= contact.number[0]:
        _find_pairs(body, x, y, max(margin, contact.margin))


@kernel(forceinline=True)
def reach_of(contact, s, m):
    """The distance at which mass m touches what is touched as number s, px; see `pairs`."""
    return contact.thickness[s] + contact.size[m]


@kernel(forceinline=True)
def pairs_of(body, s):
    """Where the masses that may touch what is touched as number s start and end in the list."""
    contact = body.environment.contact
    if s < contact.first or (s < body.springs and contact.broken[s] != 0.0):
        return 0, 0
    if contact.crowded[0] != 0:
        return 0, _gather(body, s, 0)
    return contact.start[s], contact.start[s + 1]


@kernel(fastmath=FAST)
def relative_move(masses, at, x, y):
    """How far masses may have moved relative to each other since positions `at`, px; NaN if any is."""
    slots, most, ux, uy = x.size, 0, 0.0, 0.0
    for i in range(1, masses + 1):
        ux += x[i] - at[i]
        uy += y[i] - at[slots + i]
    ux, uy = ux / masses, uy / masses
    for i in range(1, masses + 1):
        dx, dy = x[i] - at[i] - ux, y[i] - at[slots + i] - uy
        most = max(most, size_bits(dx * dx + dy * dy))
    return 2.0 * math.sqrt(from_bits(most))


@kernel(fastmath=FUSED)
def _find_pairs(body, x, y, margin):
    contact, slots, far = body.environment.contact, x.size, 0
    start = contact.start
    contact.crowded[0] = 0
    for i in range(1, body.masses + 1):
        contact.at[i], contact.at[slots + i] = x[i], y[i]
        far = max(far, size_bits(x[i]), size_bits(y[i]))
    if not from_bits(far) <= _FARTHEST:
        contact.number[0] = -1.0
        for s in range(start.size):
            start[s] = 0
        return
    contact.number[0] = margin
    _fill_grid(body, x, y)
    behind = 0
    for s in range(contact.first, start.size - 1):
        start[s] = behind
        if behind + body.masses > contact.member.size:
            contact.crowded[0] = 1
            return
        behind = _gather(body, s, behind)
    start[start.size - 1] = behind


@kernel(fastmath=FUSED)
def _fill_grid(body, x, y):
    """Sort the masses by the buckets of their cells."""
    contact = body.environment.contact
    start, per_px, buckets = contact.bucket_start, 1.0 / contact.cell, contact.bucket_start.size - 1
    for k in range(buckets + 1):
        start[k] = 0
    for i in range(1, body.masses + 1):
        contact.column[i], contact.row[i] = math.floor(x[i] * per_px), math.floor(y[i] * per_px)
        start[_bucket_of(contact.column[i], contact.row[i], buckets) + 1] += 1
    for k in range(buckets):
        start[k + 1] += start[k]
    for i in range(body.masses, 0, -1):  # from behind, so that each bucket's start is left where it belongs
        k = _bucket_of(contact.column[i], contact.row[i], buckets) + 1
        start[k] -= 1
        contact.bucket[start[k]] = i
    # `start[k + 1]` is now where bucket k starts.
    for k in range(buckets):
        start[k] = start[k + 1]
    start[buckets] = body.masses


@kernel(forceinline=True)
def _bucket_of(column, row, buckets):
    """After Teschner et al., "Optimized spatial hashing for collision detection of deformable objects"."""
    return ((column * 73856093) ^ (row * 19349663)) & (buckets - 1)


@kernel(fastmath=FUSED)
def _gather(body, s, first):
    """Write the masses that may touch what is touched as number s into the list, in ascending order; returns
    where they end."""
    contact = body.environment.contact
    at, member, slots = contact.at, contact.member, contact.at.size // 2
    reach, buckets = contact.reach + contact.number[0], contact.bucket_start.size - 1
    per_px = 1.0 / contact.cell
    line = segment(at[:slots], at[slots:], contact.end_a[s], contact.end_b[s])
    ax, ay, ex, ey, _ = line
    left = math.floor((ax + min(ex, 0.0) - reach) * per_px)
    right = math.floor((ax + max(ex, 0.0) + reach) * per_px)
    low = math.floor((ay + min(ey, 0.0) - reach) * per_px)
    high = math.floor((ay + max(ey, 0.0) + reach) * per_px)
    behind = first
    if float(right - left + 1) * float(high - low + 1) > body.masses:
        for m in range(1, body.masses + 1):
            if _is_near(body, s, line, m):
                member[behind] = m
                behind += 1
    else:
        for column in range(left, right + 1):
            for row in range(low, high + 1):
                k = _bucket_of(column, row, buckets)
                for p in range(contact.bucket_start[k], contact.bucket_start[k + 1]):
                    m = contact.bucket[p]
                    here = contact.column[m] == column and contact.row[m] == row
                    if here and _is_near(body, s, line, m):
                        q = behind
                        while q > first and member[q - 1] > m:
                            member[q] = member[q - 1]
                            q -= 1
                        member[q] = m
                        behind += 1
    return _without_apart(contact, s, first, behind)


@kernel(forceinline=True, fastmath=FUSED)
def _is_near(body, s, line, m):
    """Whether mass m may touch what is touched as number s, whose line is given."""
    contact = body.environment.contact
    if s >= body.springs and not (contact.size[m] > 0.0 and m > contact.end_a[s]):
        return False
    _, dx, dy = meeting(line, contact.at[m], contact.at[contact.at.size // 2 + m])
    near = reach_of(contact, s, m) + contact.number[0]
    return dx * dx + dy * dy <= near * near


@kernel(forceinline=True)
def _without_apart(contact, s, first, behind):
    """Take the masses that never touch what is touched as number s out of the list; returns where it ends."""
    member, apart, to = contact.member, contact.apart, first
    p, last = contact.apart_start[s], contact.apart_start[s + 1]
    for k in range(first, behind):
        m = member[k]
        while p < last and apart[p] < m:
            p += 1
        if p == last or apart[p] != m:
            member[to] = m
            to += 1
    return to
