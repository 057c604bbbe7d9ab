"""The forces of springs and joints in nets: cloth, jelly, flags, bridges.

Springs of a net come in runs in which both ends count up by one from each spring to the next, and so do its
joints, whose ends are springs. So what a run needs is loaded as it stands, several at a time, and not one by
one through indices. The forces are those of `springs`, under the tutorial's law, under the conservative law,
or without joints.

What belongs to a run is put into a row, by the number of its end a; runs with the same distance b - a share
one. An end i then finds what it needs at row[i - distance], as an end b, and at row[i], as an end a. Rows
have zeros where there is nothing. So the forces of springs are summed at the masses, and the numbers of
joints are found by the springs that they hold. Springs and joints that are in no run follow one by one.

Loops go over whole eights, so that they have no scalar remainder. What they write behind a run is overwritten
by the next one, or is in padding; in rows they write zeros there.
"""

from __future__ import annotations

import numpy as np

from ..kernels.core.roots import inverse_root
from ..kernels.core.tables import Net, Runs, padded
from ..kernels.engine.jit import FAST, kernel
from ..kernels.engine.lanes import eight_at_a_time, whole_eights
from ..kernels.engine.table import Indices
from .joints import CONSERVATIVE, NO_JOINTS, SINE_LAWS, TUTORIAL
from .term import read_only

_SHORTEST_RUN = 5
"""Number of springs or joints from which on a run is one."""
_IN_RUNS = 0.75
"""The part of a body's springs that must be in runs, for the body to be a net."""
_FILLED = 0.25
"""The part of the ends that must have something in a row, for there to be one."""


# ------------------------------------------------------------------------- runs, and how a body gives them
NO_NET = Net.empty().replaced(springs=Runs.empty(), joints=Runs.empty())
"""The table of a body that is none."""


def order_in_runs(a: Indices, b: Indices, groups: np.ndarray) -> Indices:
    """The order of pairs (a, b) in which runs are long, in one group (0 or 1) after another."""
    # One key for a stable sort, which takes a tenth of the time of sorting by three: most scenes list runs.
    most = int(max(a.max(initial=0), b.max(initial=0))) + 1
    return np.argsort((groups * (2 * most) + (b - a + most)) * most + a, kind="stable")


def new_net(ends: tuple[Indices, Indices], masses: int, held: tuple[Indices, Indices], hinged: int) -> Net:
    """The table of a body, if it is a net.

    Args:
        ends: (S,) each, the masses at the ends a and b of each spring, counted from 0.
        masses: their number.
        held: (J,) each, the springs that each joint holds.
        hinged: the number of springs that joints hold, which come first.
    """
    of_springs, springs = _runs(*ends, masses, np.arange(len(ends[0])) < hinged), len(ends[0])
    if springs == 0 or of_springs.loose.size > (1.0 - _IN_RUNS) * springs:
        return NO_NET
    of_joints = _runs(*held, hinged, np.ones(len(held[0]), np.bool_), most_rows=2)
    return read_only(
        Net(
            present=True,
            springs=of_springs,
            joints=of_joints,
            hinged=int((of_springs.first < hinged).sum()),
            gap=padded(int(abs(of_joints.at_a - of_joints.at_b).max()) + 8),
        )
    )


def _runs(a: Indices, b: Indices, ends: int, groups: np.ndarray, most_rows: int | None = None) -> Runs:
    """The runs of pairs (a, b).

    Args:
        a, b: of each pair.
        ends: number of ends.
        groups: of each pair; no run and no row is in two groups.
        most_rows: number of rows that there may be.
    """
    begins = np.ones(a.size, np.bool_)
    begins[1:] = (np.diff(a) != 1) | (np.diff(b) != 1) | (groups[1:] != groups[:-1])
    first = np.flatnonzero(begins)
    count, distance = np.diff(first, append=a.size), (b - a)[first]
    # In a row, each run begins behind the one before, and so overwrites what that has written there. Those of
    # another group are not written in the same turn.
    new_row, group = np.ones(first.size, np.bool_), groups[first]
    new_row[1:] = (
        (np.diff(distance) != 0) | (a[first[1:]] < (a[first] + count)[:-1]) | (group[1:] != group[:-1])
    )
    row = np.cumsum(new_row) - 1
    long = count >= _SHORTEST_RUN
    in_row = np.bincount(row, count * long, int(new_row.sum()))
    fullest = np.argsort(-in_row, kind="stable")[:most_rows]
    filled = np.zeros(in_row.size, np.bool_)
    filled[fullest] = in_row[fullest] >= _FILLED * ends
    kept = long & filled[row]
    distance, row = distance[new_row][filled], (np.cumsum(filled) - 1)[row[kept]]
    rows = max(2, -(-distance.size // 2) * 2)
    # Rows are so far apart that no end is looked for in another one.
    gap = padded(int(abs(distance).max(initial=0)) + 8)
    at_a = gap + np.arange(rows) * (padded(ends) + gap)
    at_b = at_a.copy()
    at_b[: distance.size] -= distance
    return read_only(
        Runs(
            first=first[kept],
            a=a[first[kept]],
            b=b[first[kept]],
            count=count[kept],
            row=at_a[row] + a[first[kept]],
            at_a=at_a,
            at_b=at_b,
            loose=np.flatnonzero(~np.repeat(kept, count)),
            room=int(at_a[-1]) + padded(ends) + gap,
        )
    )


@kernel(forceinline=True)
def is_net(body):
    """Whether `net_forces` handles a body."""
    return body.net.present and body.law in SINE_LAWS and not body.joint_damped


# ------------------------------------------------------------------------- force
@kernel(forceinline=True, fastmath=FAST)
def net_forces(body, state, scratch, q, v):
    """Like `springs.spring_forces`, for a net."""
    law = body.law
    net, slots, gap = body.net, q.size // 2, np.uint64(body.net.gap)
    runs, joints, rows_x, rows_y = net.springs, net.joints, scratch.spring_rows[0], scratch.spring_rows[1]
    x, y, vx, vy = q[1:slots], q[slots + 1 :], v[1:slots], v[slots + 1 :]
    fx, fy, inverse = scratch.fx[1:], scratch.fy[1:], scratch.inverse
    lx, ly, length = scratch.vectors[0], scratch.vectors[1], scratch.vectors[2]
    rest_tension, stiffness, damping = state.rest_tension, body.stiffness, body.damping
    for r in range(runs.first.size):
        _vectors(runs, r, gap, body.softening, x, y, lx, ly, length, inverse)
        if law == NO_JOINTS or r >= net.hinged:
            _tensions(
                runs, r, gap, vx, vy, rest_tension, stiffness, damping, lx, ly, inverse, rows_x, rows_y
            )  # fmt: skip
    for k in range(runs.loose.size):
        s = np.uint64(runs.loose[k])
        a, b = np.uint64(body.spring_a[s] - 1), np.uint64(body.spring_b[s] - 1)
        _put_vector(s, gap, body.softening, x[b] - x[a], y[b] - y[a], lx, ly, length, inverse)
    if law != NO_JOINTS:
        cos, sin, size = scratch.joint_rows[0], scratch.joint_rows[1], scratch.joint_rows[2]
        _spread(joints, state.torque_cos, state.torque_sin, body.torque_size, cos, sin, size)
        # Each law has a loop of its own, which therefore has no branches.
        for r in range(net.hinged):
            if law == CONSERVATIVE:
                _tensions_with_joints(
                    CONSERVATIVE, runs, joints, r, gap, vx, vy, rest_tension, stiffness, damping,
                    lx, ly, length, inverse, cos, sin, size, rows_x, rows_y,
                )  # fmt: skip
            else:
                _tensions_with_joints(
                    TUTORIAL, runs, joints, r, gap, vx, vy, rest_tension, stiffness, damping,
                    lx, ly, length, inverse, cos, sin, size, rows_x, rows_y,
                )  # fmt: skip
    _sum_at_ends(runs, body.masses, rows_x, fx)
    _sum_at_ends(runs, body.masses, rows_y, fy)
    for k in range(runs.loose.size):
        s = np.uint64(runs.loose[k])
        a, b = np.uint64(body.spring_a[s] - 1), np.uint64(body.spring_b[s] - 1)
        to_x, to_y, inv = lx[gap + s], ly[gap + s], inverse[s]
        along = _along(
            to_x, to_y, inv, vx[b] - vx[a], vy[b] - vy[a], rest_tension[s], stiffness[s], damping[s]
        )
        tx, ty = along * to_x, along * to_y
        if law != NO_JOINTS and s < np.uint64(body.hinged):
            cos, sin, size = scratch.joint_rows[0], scratch.joint_rows[1], scratch.joint_rows[2]
            a0, a1 = np.uint64(joints.at_a[0]), np.uint64(joints.at_a[1])
            b0, b1 = np.uint64(joints.at_b[0]), np.uint64(joints.at_b[1])
            given_x, given_y = _given_by_rows(
                law, s, gap, to_x, to_y, inv, a0, a1, b0, b1, lx, ly, length, cos, sin, size
            )
            tx += given_x
            ty += given_y
        _add_tension(body, s, tx, ty, scratch.fx, scratch.fy)
    if law != NO_JOINTS:
        for k in range(joints.loose.size):
            j = np.uint64(joints.loose[k])
            s, r = np.uint64(body.joint_a[j]), np.uint64(body.joint_b[j])
            a, b, j = gap + s, gap + r, j + np.uint64(1)
            cos, sin, size = state.torque_cos, state.torque_sin, body.torque_size
            tx, ty = _given(law, 1.0, lx[a], ly[a], inverse[s], b, j, lx, ly, length, cos, sin, size)
            _add_tension(body, s, tx, ty, scratch.fx, scratch.fy)
            tx, ty = _given(law, -1.0, lx[b], ly[b], inverse[r], a, j, lx, ly, length, cos, sin, size)
            _add_tension(body, r, tx, ty, scratch.fx, scratch.fy)


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def _vectors(runs, r, gap, soft, x, y, lx, ly, length, inverse):
    """What all need to know of the springs of run r."""
    eight_at_a_time()
    # With unsigned indices numba omits its test for negative ones.
    first, start_a, start_b = np.uint64(runs.first[r]), np.uint64(runs.a[r]), np.uint64(runs.b[r])
    for i in range(whole_eights(runs.count[r])):
        s, a, b = first + np.uint64(i), start_a + np.uint64(i), start_b + np.uint64(i)
        _put_vector(s, gap, soft, x[b] - x[a], y[b] - y[a], lx, ly, length, inverse)


@kernel(inline="always")
def _put_vector(s, gap, soft, x, y, lx, ly, length, inverse):
    square = x * x + y * y + soft
    inv = inverse_root(square)
    lx[gap + s], ly[gap + s], length[gap + s], inverse[s] = x, y, square * inv, inv


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def _tensions(runs, r, gap, vx, vy, rest_tension, stiffness, damping, lx, ly, inverse, rows_x, rows_y):
    """The forces on the b ends of the springs of run r, which no joint holds, into its row."""
    eight_at_a_time()
    first, start_a, start_b = np.uint64(runs.first[r]), np.uint64(runs.a[r]), np.uint64(runs.b[r])
    row, count = np.uint64(runs.row[r]), runs.count[r]
    for i in range(whole_eights(count)):
        s, a, b = first + np.uint64(i), start_a + np.uint64(i), start_b + np.uint64(i)
        x, y = lx[gap + s], ly[gap + s]
        along = _along(
            x, y, inverse[s], vx[b] - vx[a], vy[b] - vy[a], rest_tension[s], stiffness[s], damping[s]
        )
        rows_x[row + np.uint64(i)] = along * x if i < count else 0.0
        rows_y[row + np.uint64(i)] = along * y if i < count else 0.0


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def _tensions_with_joints(
    law, runs, joints, r, gap, vx, vy, rest_tension, stiffness, damping, lx, ly, length, inverse,
    cos, sin, size, rows_x, rows_y,
):  # fmt: skip
    """Likewise for springs that joints hold, with what these do."""
    eight_at_a_time()
    first, start_a, start_b = np.uint64(runs.first[r]), np.uint64(runs.a[r]), np.uint64(runs.b[r])
    row, count = np.uint64(runs.row[r]), runs.count[r]
    # Of both rows of joints: where they begin for springs that come first and second, and their distance.
    a0, a1 = np.uint64(joints.at_a[0]), np.uint64(joints.at_a[1])
    b0, b1 = np.uint64(joints.at_b[0]), np.uint64(joints.at_b[1])
    for i in range(whole_eights(count)):
        s, a, b = first + np.uint64(i), start_a + np.uint64(i), start_b + np.uint64(i)
        x, y, inv = lx[gap + s], ly[gap + s], inverse[s]
        along = _along(x, y, inv, vx[b] - vx[a], vy[b] - vy[a], rest_tension[s], stiffness[s], damping[s])
        given_x, given_y = _given_by_rows(
            law, s, gap, x, y, inv, a0, a1, b0, b1, lx, ly, length, cos, sin, size
        )
        tx, ty = along * x + given_x, along * y + given_y
        rows_x[row + np.uint64(i)] = tx if i < count else 0.0
        rows_y[row + np.uint64(i)] = ty if i < count else 0.0


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def _spread(joints, cos, sin, size, rows_cos, rows_sin, rows_size):
    """Put the numbers of joints into rows."""
    eight_at_a_time()
    for r in range(joints.first.size):
        first, row, count = np.uint64(joints.first[r] + 1), np.uint64(joints.row[r]), joints.count[r]
        for i in range(whole_eights(count)):
            j, to = first + np.uint64(i), row + np.uint64(i)
            rows_cos[to] = cos[j] if i < count else 0.0
            rows_sin[to] = sin[j] if i < count else 0.0
            rows_size[to] = size[j] if i < count else 0.0


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def _sum_at_ends(runs, ends, row, out):
    """The sum at every end: plus what is in the rows for it as an end b, minus that for it as an end a."""
    eight_at_a_time()
    for k in range(0, runs.at_a.size, 2):
        a0, a1 = np.uint64(runs.at_a[k]), np.uint64(runs.at_a[k + 1])
        b0, b1 = np.uint64(runs.at_b[k]), np.uint64(runs.at_b[k + 1])
        if k == 0:
            for i in range(whole_eights(ends)):
                j = np.uint64(i)
                out[i] = row[b0 + j] + row[b1 + j] - (row[a0 + j] + row[a1 + j])
        else:
            for i in range(whole_eights(ends)):
                j = np.uint64(i)
                out[i] += row[b0 + j] + row[b1 + j] - (row[a0 + j] + row[a1 + j])


@kernel(inline="always")
def _add_tension(body, s, tx, ty, fx, fy):
    a, b = np.uint64(body.spring_a[s]), np.uint64(body.spring_b[s])
    fx[a] -= tx
    fy[a] -= ty
    fx[b] += tx
    fy[b] += ty


@kernel(inline="always")
def _along(x, y, inv, u, v, rest_tension, stiffness, damping):
    """The force on the b end of a spring without joints, per vector; u and v are the vector's rate."""
    return rest_tension * inv - stiffness - damping * (x * u + y * v) * (inv * inv)


@kernel(inline="always")
def _given_by_rows(law, s, gap, x, y, inv, a0, a1, b0, b1, lx, ly, length, cos, sin, size):
    """The force on the b end of spring s by all joints in rows, whether it is in a run itself or not."""
    here, far0, far1 = gap + s, a0 - b0, a1 - b1
    first_x, first_y = _given(law, 1.0, x, y, inv, here + far0, a0 + s, lx, ly, length, cos, sin, size)
    second_x, second_y = _given(law, -1.0, x, y, inv, here - far0, b0 + s, lx, ly, length, cos, sin, size)
    third_x, third_y = _given(law, 1.0, x, y, inv, here + far1, a1 + s, lx, ly, length, cos, sin, size)
    fourth_x, fourth_y = _given(law, -1.0, x, y, inv, here - far1, b1 + s, lx, ly, length, cos, sin, size)
    return first_x + second_x + (third_x + fourth_x), first_y + second_y + (third_y + fourth_y)


@kernel(inline="always")
def _given(law, sign, x, y, inv, other, j, lx, ly, length, cos, sin, size):
    """The force on the b end of a spring by joint j, which holds it and another one.

    Args:
        law: CONSERVATIVE or TUTORIAL.
        sign: 1 if the spring is the joint's first one, -1 if it is the second one.
        x, y, inv: the spring's vector, px, and 1 / its length.
        other: the other spring in lx, ly and length.
        j: the joint in cos, sin and size, which are its stiffness, kg/s², times the cosine and the sine of
            its rest angle; and itself.
    """
    to_x, to_y, turned = lx[other], ly[other], sign * sin[j]
    if law == CONSERVATIVE:
        # Of the energy K (|A||B| - A . R(-r) B), which `chain` takes apart likewise.
        along = size[j] * length[other] * inv
        return cos[j] * to_x + turned * to_y - along * x, cos[j] * to_y - turned * to_x - along * y
    across = (cos[j] * (x * to_y - y * to_x) - turned * (x * to_x + y * to_y)) * (inv * inv)
    return -across * y, across * x
