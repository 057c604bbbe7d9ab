"""The list of the masses that may touch each spring, found with a uniform grid in a hash table.

The list holds all pairs that are nearer than the distance of contact plus a margin. As long as no mass has
moved by more than half of the margin, no other pair can touch (Verlet 1967), so it is made anew only then.
That takes a time in proportion to the number of masses and springs, if springs are about equally long.
"""

from __future__ import annotations

import math

import numpy as np

from ..core.bits import from_bits, size_bits
from ..core.jit import FUSED, kernel

DIAGONAL = 1.4142135623730951
"""Largest movement of a mass if no coordinate changes by more than 1."""

_FARTHEST = 1e8
"""Coordinate, px, beyond which no pairs are looked for: such a state is refused anyway."""

_TOO_LONG = 2.0
"""Margin of a list, relative to the usual one, above which it is made anew, because it has too many pairs."""


@kernel(forceinline=True, fastmath=FUSED)
def nearest_point(x, y, ax, ay, ex, ey):
    """The point of a segment that is nearest to a point, as a fraction of the way from a to a + e."""
    square = ex * ex + ey * ey
    along = (x - ax) * ex + (y - ay) * ey
    if along <= 0.0:
        return 0.0
    if along >= square:
        return 1.0
    return along / square


@kernel(internal=True, fastmath=FUSED)
def update_pairs(body, x, y):
    """Make the list anew unless it holds all pairs that touch at these positions."""
    contact = body.surroundings.contact
    margin = contact.number[0]
    if not (
        2.0 * DIAGONAL * farthest_move(body.masses, contact.at, x, y) <= margin
        and margin <= _TOO_LONG * contact.margin
    ):
        _find_pairs(body, x, y, contact.margin)


@kernel(internal=True, fastmath=FUSED)
def cover_pairs(body, x, y, margin):
    """Make the list anew unless it holds all pairs that are nearer than the distance plus a margin (px)."""
    contact = body.surroundings.contact
    moved = 2.0 * DIAGONAL * farthest_move(body.masses, contact.at, x, y)
    if not moved + margin <= contact.number[0]:
        _find_pairs(body, x, y, max(margin, contact.margin))


@kernel(forceinline=True)
def pairs_of(body, s):
    """Where the masses that may touch spring s start and end in the list."""
    contact = body.surroundings.contact
    if contact.crowded[0] != 0:
        return 0, _gather(body, s, 0)
    return contact.start[s], contact.start[s + 1]


@kernel(fastmath=FUSED)
def farthest_move(masses, at, x, y):
    """The largest difference of a coordinate from positions `at`, px; NaN if any is."""
    slots, most = x.size, 0
    for i in range(1, masses + 1):
        most = max(most, size_bits(x[i] - at[i]), size_bits(y[i] - at[slots + i]))
    return from_bits(most)


@kernel(fastmath=FUSED)
def _find_pairs(body, x, y, margin):
    contact, slots, far = body.surroundings.contact, x.size, 0
    start = contact.start
    contact.crowded[0] = 0
    for i in range(1, body.masses + 1):
        contact.at[i], contact.at[slots + i] = x[i], y[i]
        far = max(far, size_bits(x[i]), size_bits(y[i]))
    if not from_bits(far) <= _FARTHEST:
        contact.number[0] = -1.0
        for s in range(body.springs + 1):
            start[s] = 0
        return
    contact.number[0] = margin
    _fill_grid(body, x, y)
    behind = 0
    for s in range(body.springs):
        start[s] = behind
        if behind + body.masses > contact.member.size:
            contact.crowded[0] = 1
            return
        behind = _gather(body, s, behind)
    start[body.springs] = behind


@kernel(fastmath=FUSED)
def _fill_grid(body, x, y):
    """Sort the masses by the buckets of their cells."""
    contact = body.surroundings.contact
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
    """Write the masses that may touch spring s into the list, in ascending order; returns where they end."""
    contact = body.surroundings.contact
    at, member, slots = contact.at, contact.member, contact.at.size // 2
    a, b = body.spring_a[s], body.spring_b[s]
    ax, ay, bx, by = at[a], at[slots + a], at[b], at[slots + b]
    reach, per_px, buckets = contact.distance + contact.number[0], 1.0 / contact.cell, contact.bucket_start.size - 1
    left, right = math.floor((min(ax, bx) - reach) * per_px), math.floor((max(ax, bx) + reach) * per_px)
    low, high = math.floor((min(ay, by) - reach) * per_px), math.floor((max(ay, by) + reach) * per_px)
    behind = first
    if float(right - left + 1) * float(high - low + 1) > body.masses:
        for m in range(1, body.masses + 1):
            behind = _add_if_near(body, s, m, reach, behind)
        return behind
    for column in range(left, right + 1):
        for row in range(low, high + 1):
            k = _bucket_of(column, row, buckets)
            for p in range(contact.bucket_start[k], contact.bucket_start[k + 1]):
                m = contact.bucket[p]
                if contact.column[m] == column and contact.row[m] == row:
                    behind = _add_if_near(body, s, m, reach, behind)
    for p in range(first + 1, behind):
        m, k = member[p], p
        while k > first and member[k - 1] > m:
            member[k] = member[k - 1]
            k -= 1
        member[k] = m
    return behind


@kernel(forceinline=True, fastmath=FUSED)
def _add_if_near(body, s, m, reach, behind):
    contact = body.surroundings.contact
    at, slots = contact.at, contact.at.size // 2
    a, b = body.spring_a[s], body.spring_b[s]
    ax, ay = at[a], at[slots + a]
    ex, ey, x, y = at[b] - ax, at[slots + b] - ay, at[m], at[slots + m]
    t = nearest_point(x, y, ax, ay, ex, ey)
    dx, dy = x - ax - t * ex, y - ay - t * ey
    if dx * dx + dy * dy <= reach * reach:
        for p in range(contact.apart_start[s], contact.apart_start[s + 1]):
            if contact.apart[p] == m:
                return behind
        contact.member[behind] = m
        return behind + 1
    return behind
