"""Forces of contact, of many pairs at a time; the symbols are those of `pairs`.

Of the pairs on the list, those that touch are noted until there are enough for a batch. A loop over a batch
has no branches, so that it is vectorised, with which a step of a heap takes a third of the time. Then forces
are added in the order of the list. No bit depends on which pairs are in a batch together.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...engine.jit import FUSED, kernel
from ...engine.lanes import eight_at_a_time, whole_eights
from ...engine.tables import Body
from .broad_phase import meeting, pairs_of, segment
from .pairs import friction_coefficient, lost_in, mobilities, stretch_since
from .push import push_and_friction

BATCH = 256
"""Number of pairs whose forces are computed together, a multiple of eight: what is kept of them stays in the
first cache. Doubled or halved, no test fails."""


def room_for_batches(body: Body) -> dict[str, NDArray[Any]]:
    """The arrays of scratch that are needed here, by name; none for a body without contact."""
    if not body.environment.contact.present:
        return {}
    slots = {name: np.zeros(BATCH, np.int64) for name in ("batch_mass", "batch_a", "batch_b")}
    rows = {"batch_force": np.zeros((5, BATCH)), "batch_stretch": np.zeros((8, BATCH))}
    return {**slots, **rows, "batch_reach": np.zeros(BATCH)}


@kernel(internal=True, fastmath=FUSED)
def add_in_batches(body, state, scratch, q, v):
    """Add the forces of all pairs that touch; the list of pairs must be up to date."""
    contact, slots, count = body.environment.contact, q.size // 2, 0
    x, y, size, sized = q[:slots], q[slots:], contact.size, contact.sized
    mass, ends_a, ends_b, reaches = scratch.batch_mass, scratch.batch_a, scratch.batch_b, scratch.batch_reach
    for s in range(contact.first, contact.end_a.size):
        first, behind = pairs_of(body, s)
        a, b, thickness = np.uint64(contact.end_a[s]), np.uint64(contact.end_b[s]), contact.thickness[s]
        line = segment(x, y, a, b)
        while first < behind:
            until = min(behind, first + BATCH - count)
            began = count
            for p in range(np.uint64(first), np.uint64(until)):
                m, k = np.uint64(contact.member[p]), np.uint64(count)
                _, dx, dy = meeting(line, x[m], y[m])
                reach = thickness + size[m] if sized else thickness
                mass[k], ends_a[k], ends_b[k], reaches[k] = m, a, b, reach
                count += 1 if dx * dx + dy * dy < reach * reach else 0
            if contact.tangential > 0.0:
                _find_kept(body, state, scratch, s, began, count)
            first = until
            if count == BATCH:
                _add_batch(body, state, scratch, q, v, count)
                count = 0
    if count > 0:
        _add_batch(body, state, scratch, q, v, count)


@kernel(internal=True, fastmath=FUSED)
def _find_kept(body, state, scratch, s, began, count):
    """Note what the tangential springs of spring s have kept, for its pairs from `began` on in the batch.
    Solid masses have none."""
    kept, rows = state.contact_stretch, scratch.batch_stretch
    for k in range(began, count):
        rows[7, k] = 0.0
        if s >= body.springs:
            continue
        for i in range(state.contact_start[s], state.contact_start[s + 1]):
            if state.contact_mass[i] == scratch.batch_mass[k]:
                rows[7, k] = 1.0
                for j in range(6):
                    rows[1 + j, k] = kept[i, j]


@kernel(internal=True, fastmath=FUSED)
def _add_batch(body, state, scratch, q, v, count):
    contact, slots = body.environment.contact, q.size // 2
    mass, ends_a, ends_b, force = scratch.batch_mass, scratch.batch_a, scratch.batch_b, scratch.batch_force
    stretch, reach = scratch.batch_stretch, scratch.batch_reach
    for k in range(count, whole_eights(count)):
        mass[k], ends_a[k], ends_b[k], reach[k] = mass[0], ends_a[0], ends_b[0], reach[0]
    if contact.tangential > 0.0:
        _stretches_in_batch(
            whole_eights(count), q[:slots], q[slots:], mass, ends_a, ends_b,
            (stretch[1], stretch[2], stretch[3], stretch[4], stretch[5], stretch[6]), stretch[7], stretch[0],
        )  # fmt: skip
    _forces_in_batch(
        whole_eights(count),
        (contact.distance, contact.stiffness, contact.friction, contact.slip_speed, body.environment.step),
        lost_in(contact), (contact.tangential, contact.resisting),
        state.inverse_mass, q[:slots], q[slots:], v[:slots], v[slots:], mass, ends_a, ends_b, reach,
        stretch[0], force[0], force[1], force[2], force[3], force[4],
    )  # fmt: skip
    fx, fy = scratch.fx, scratch.fy
    for k in range(count):
        m, a, b = mass[k], ends_a[k], ends_b[k]
        x, y, gx, gy, t = force[0, k], force[1, k], force[2, k], force[3, k], force[4, k]
        fx[m] += x
        fy[m] += y
        fx[a] -= (1.0 - t) * x + gx
        fy[a] -= (1.0 - t) * y + gy
        fx[b] += gx - t * x
        fy[b] += gy - t * y


@kernel(noalias=True, fastmath=FUSED)
def _stretches_in_batch(count, x, y, mass, ends_a, ends_b, kept, there, stretch):
    """The stretch of the tangential spring of each pair of a batch, px; 0 without one."""
    eight_at_a_time()
    was, was_t, was_ahead, was_beside, was_length, was_r = kept
    for k in range(whole_eights(count)):
        m, a, b = np.uint64(mass[k]), np.uint64(ends_a[k]), np.uint64(ends_b[k])
        line = segment(x, y, a, b)
        t, dx, dy = meeting(line, x[m], y[m])
        _, _, ex, ey, per_square = line
        r = math.sqrt(dx * dx + dy * dy)
        per_r = 1.0 / (r + 1e-300)
        row = was[k], was_t[k], was_ahead[k], was_beside[k], was_length[k], was_r[k]
        now = stretch_since(row, (t, r, dx * per_r, dy * per_r, ex, ey, per_square))
        stretch[k] = now if there[k] > 0.0 else 0.0


@kernel(noalias=True, fastmath=FUSED)
def _forces_in_batch(
    count, law, lost, tangential, w, x, y, vx, vy, mass, ends_a, ends_b, reach, stretch, fx, fy, gx, gy, ts
):
    """F, G and t of each pair of a batch; the number of pairs is a multiple of eight."""
    eight_at_a_time()
    distance, stiffness, friction, slip_speed, h = law
    for k in range(whole_eights(count)):
        m, a, b = np.uint64(mass[k]), np.uint64(ends_a[k]), np.uint64(ends_b[k])
        line = segment(x, y, a, b)
        t, dx, dy = meeting(line, x[m], y[m])
        _, _, ex, ey, per_square = line
        r = math.sqrt(dx * dx + dy * dy)
        per_r = 1.0 / (r + 1e-300)
        nx, ny, lx, ly = dx * per_r, dy * per_r, -r * ey * per_square, r * ex * per_square
        turning_x, turning_y = vx[b] - vx[a], vy[b] - vy[a]
        to_x, to_y = vx[m] - vx[a] - t * turning_x, vy[m] - vy[a] - t * turning_y
        speed, along = to_x * nx + to_y * ny, to_y * nx - to_x * ny - (turning_x * lx + turning_y * ly)
        mobility, mobility_along = mobilities((w[m], w[a], w[b]), t, (nx, ny), (lx, ly))
        push, rubbing, _ = push_and_friction(
            stiffness, lost, friction_coefficient(friction, distance, ex * ex + ey * ey), slip_speed,
            tangential, h, mobility, mobility_along, reach[k] - r, speed, along, stretch[k],
        )  # fmt: skip
        fx[k], fy[k] = push * nx + rubbing * ny, push * ny - rubbing * nx
        gx[k], gy[k], ts[k] = rubbing * lx, rubbing * ly, t
