"""The forces of springs and joints in any body, most of them several at a time.

Springs join masses in pairs, and joints join springs in pairs. Where both ends count up by one from each pair
to the next, the pairs are a run: a chain is one run, a cloth has one for each line of it. What a run needs is
loaded as it stands, several pairs at a time, and not one by one through indices.

What a run exerts is put into a row, by the number of its end a; runs with the same distance b - a share one.
An end i then finds what acts on it at row[i - distance], as an end b, and at row[i], as an end a. Rows have
zeros where there is nothing. The pairs in no run come after the runs. They are loaded through indices; what
they exert is gathered through one index an end and layer, or added one by one, see `Links`.

The forces are those of `springs` and `joints`. Loops over runs go over whole eights, so that they have no
scalar remainder. What they write behind a run is overwritten by the next one, or is in padding; in rows they
write zeros there. Each loop is a function of its own whose arrays share no memory, because LLVM would
otherwise check for overlaps before every loop.
"""

from __future__ import annotations

import numpy as np

from ..engine.jit import FAST, kernel
from ..engine.lanes import eight_at_a_time, scalar_gathers_on_amd, whole_eights
from ..engine.numerics.roots import inverse_root
from ..engine.table import Floats, Indices
from ..engine.tables import Links, padded
from .joints import (
    CONSERVATIVE,
    NO_JOINTS,
    TUTORIAL,
    JointsReference,
    add_joint_damping,
    add_joint_derivatives,
    bend,
    joint_energies,
    rub,
)
from .springs import SpringsReference, add_spring_damping, add_spring_derivatives, spring_energies, tension
from .term import Term

# Unless noted, doubling or halving one of these numbers fails no test.
_SHORTEST_RUN = 5
"""Pairs from which on a run is one; shorter ones take longer than pairs one by one. Doubled,
`test_what_a_state_leaves_behind_does_not_show_in_the_next` fails; halved,
`test_grids_are_in_runs_however_they_are_listed`."""
_FILLED = 0.25
"""The part of the ends that must have something in a row, for there to be one. Doubled,
`test_grids_are_in_runs_however_they_are_listed` fails."""


# ------------------------------------------------------------------------- runs, and how a body gives them
def order_in_runs(a: Indices, b: Indices, ends: int, groups: np.ndarray | None = None) -> Indices:
    """The order of pairs in which runs are long, and come before all pairs that are in none.

    Args:
        a, b: both ends of each pair.
        ends: number of ends.
        groups: 0 or 1 for each pair: those of one group come before those of the other.
    """
    if groups is None:
        groups = np.zeros(a.size, np.int64)
    # One key for a stable sort, which takes a tenth of the time of sorting by three: most scenes list runs.
    most = int(max(a.max(initial=0), b.max(initial=0))) + 1
    order = np.argsort((groups * (2 * most) + (b - a + most)) * most + a, kind="stable")
    a, b, groups = a[order], b[order], groups[order]
    inside = np.concatenate([_in_runs(a[groups == g], b[groups == g], ends) for g in (0, 1)])
    return order[np.lexsort((~inside, groups))]


def _in_runs(a: Indices, b: Indices, ends: int) -> np.ndarray:
    """Whether each pair, in this order, is in a run that is long enough, in a row that is full enough."""
    _, count, row = _runs(a, b)
    long = count >= _SHORTEST_RUN
    in_row = np.bincount(row, count * long)
    return np.repeat(long & (in_row[row] >= _FILLED * ends), count)


def _runs(a: Indices, b: Indices) -> tuple[Indices, Indices, Indices]:
    """The runs of pairs: the first pair of each, their number, and its row."""
    begins = np.ones(a.size, np.bool_)
    begins[1:] = (np.diff(a) != 1) | (np.diff(b) != 1)
    first = np.flatnonzero(begins)
    count, distance = np.diff(first, append=a.size), (b - a)[first]
    # In a row, each run begins behind the one before, and so overwrites what that has written there.
    new_row = np.ones(first.size, np.bool_)
    new_row[1:] = (np.diff(distance) != 0) | (a[first[1:]] < (a[first] + count)[:-1])
    return first, count, np.cumsum(new_row) - 1


def new_links(
    a: Indices, b: Indices, ends: int, nothing: int, begin: int = 0, has_runs: bool = True
) -> Links:
    """The table of pairs in the order of `order_in_runs`, or along a chain or a ring.

    Args:
        a, b: both ends of each pair.
        ends: number of ends.
        nothing: number of a pair that exerts nothing.
        begin: number of the first pair.
        has_runs: whether to look for runs; without, which is slower, results differ by rounding.
    """
    inside = _in_runs(a, b, ends) & has_runs
    loose = a.size if inside.all() else int(inside.argmin())
    first, count, row = _runs(a[:loose], b[:loose])
    distances = (b - a)[first[np.searchsorted(row, np.arange(row.max(initial=-1) + 1))]]
    rows = -(-distances.size // 2) * 2
    # Rows are so far apart that no end is looked for in another one.
    gap = padded(int(abs(distances).max(initial=0)) + 8)
    at_a = gap + np.arange(rows) * (padded(ends) + gap)
    at_b = at_a.copy()
    at_b[: distances.size] -= distances
    layers, into, out_of, rest, rest_end, rest_sign = slot_tables(
        b[loose:], a[loose:], ends, first=begin + loose, nothing=nothing
    )
    return Links(
        first=begin + first,
        a=a[first],
        b=b[first],
        count=count,
        row=at_a[row] + a[first],
        at_a=at_a,
        at_b=at_b,
        room=gap + rows * (padded(ends) + gap),
        loose=begin + loose,
        behind=begin + a.size,
        ends=ends,
        layers=layers,
        into=into,
        out_of=out_of,
        rest=rest,
        rest_end=rest_end,
        rest_sign=rest_sign,
    )


def slot_tables(
    plus: Indices, minus: Indices, ends: int, first: int, nothing: int
) -> tuple[int, Indices, Indices, Indices, Indices, Floats]:
    """Tables for summing, at each end, the pairs that act on it, with sign plus or minus.

    Each layer has one slot of each sign for every end; pairs that find no slot go into lists. There are as
    many layers as have something for at least half of the ends, since a layer is gathered in vectors, empty
    slots included, and the lists are processed one by one.

    Args:
        plus, minus: the ends that each pair acts on with that sign.
        ends: number of ends.
        first: number of the first pair.
        nothing: value of an empty slot.

    Returns:
        Number of layers; (layers ends,) the pairs in the slots of either sign, one layer after another; and
        for what is in the lists: the pair, the end and the sign.
    """
    places = [_places(end_of, ends) for end_of in (plus, minus)]
    layers = 0
    while 2 * sum(int((place == layers).sum()) for place in places) >= max(ends, 1):
        layers += 1
    slots = np.full((2, layers, ends), nothing, np.int64)
    left: list[tuple[Indices, Indices, Floats]] = []
    for slot, end_of, place, sign in zip(slots, (plus, minus), places, (1.0, -1.0), strict=True):
        found = place < layers
        slot[place[found], end_of[found]] = first + np.flatnonzero(found)
        rest = np.flatnonzero(~found)
        left.append((first + rest, end_of[rest], np.full(rest.size, sign)))
    pair, end, signs = (np.concatenate(columns) for columns in zip(*left, strict=True))
    return layers, slots[0].ravel(), slots[1].ravel(), pair, end, signs


def _places(end_of: Indices, ends: int) -> Indices:
    """How many pairs with the same end come before each pair."""
    order = np.argsort(end_of, kind="stable")
    starts = np.cumsum(np.bincount(end_of, minlength=ends)) - np.bincount(end_of, minlength=ends)
    places = np.empty(end_of.size, np.int64)
    places[order] = np.arange(end_of.size) - starts[end_of[order]]
    return places


# ------------------------------------------------------------------------- the sum of all forces
@kernel(noalias=True, fastmath=FAST)
def add_spring_forces(body, state, scratch, q, v):
    """Add the forces of all springs and joints on all masses to `scratch.fx` and `scratch.fy`."""
    scalar_gathers_on_amd()
    eight_at_a_time()
    slots, law = q.size // 2, body.law
    x, y, vx, vy = q[:slots], q[slots:], v[:slots], v[slots:]
    held, free, fx, fy = body.held, body.free, scratch.fx, scratch.fy
    _put_vectors(body, scratch, held, x, y, vx, vy)
    _put_vectors(body, scratch, free, x, y, vx, vy)
    if law != NO_JOINTS:
        # Each sine law has loops of its own, which therefore have no branches.
        if law == CONSERVATIVE:
            _put_bends(CONSERVATIVE, body, state, scratch)
        elif law == TUTORIAL:
            _put_bends(TUTORIAL, body, state, scratch)
        else:
            _put_bends(law, body, state, scratch)
        if body.joint_damped:
            _put_rates(held, vx, vy, scratch.dvx, scratch.dvy)
            _add_rubs(body, scratch)
        joints, rows, alone = body.bends, scratch.joint_rows, scratch.joint_alone
        clear(whole_eights(body.hinged), scratch.held_x, scratch.held_y)
        _sum_at_ends(
            joints, 1.0, (rows[2], rows[3]), (rows[0], rows[1]), (alone[2], alone[3]), (alone[0], alone[1]),
            (scratch.held_x, scratch.held_y),
        )  # fmt: skip
        _put_tensions(True, body, state, scratch, held, scratch.held_rows, vx, vy)
    else:
        _put_tensions(False, body, state, scratch, held, scratch.held_rows, vx, vy)
    _put_tensions(False, body, state, scratch, free, scratch.free_rows, vx, vy)
    tx, ty, none = scratch.tx, scratch.ty, body.stiffness.size
    tx[none], ty[none] = 0.0, 0.0  # where others leave other numbers
    for links, rows in ((held, scratch.held_rows), (free, scratch.free_rows)):
        of_runs, of_others = (rows[0], rows[1]), (tx, ty)
        _sum_at_ends(links, -1.0, of_runs, of_runs, of_others, of_others, (fx, fy))


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def clear(count, x, y):
    for i in range(count):
        x[i], y[i] = 0.0, 0.0


@kernel(forceinline=True, fastmath=FAST)
def _sum_at_ends(links, sign, rows_b, rows_a, of_b, of_a, out):
    """Add to every end what the pairs exert on it as an end b, and `sign` times that as an end a.

    Args:
        links: the pairs.
        sign: 1 or -1.
        rows_b, rows_a: rows of what runs exert, x and y.
        of_b, of_a: what each of the other pairs does.
        out: of each end.
    """
    for k in range(0, links.at_a.size, 2):
        _add_rows(links, k, sign, rows_b[0], rows_a[0], out[0])
        _add_rows(links, k, sign, rows_b[1], rows_a[1], out[1])
    for layer in range(links.layers):
        _add_layer(links, layer, sign, of_b, of_a, out)
    x, y = out
    for k in range(links.rest.size):
        pair, end = np.uint64(links.rest[k]), np.uint64(links.rest_end[k])
        if links.rest_sign[k] > 0.0:
            x[end] += of_b[0][pair]
            y[end] += of_b[1][pair]
        else:
            x[end] += sign * of_a[0][pair]
            y[end] += sign * of_a[1][pair]


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def _add_rows(links, k, sign, row_b, row_a, out):
    eight_at_a_time()
    # With unsigned indices numba omits its test for negative ones, which would keep loops from vectorising.
    a0, a1 = np.uint64(links.at_a[k]), np.uint64(links.at_a[k + 1])
    b0, b1 = np.uint64(links.at_b[k]), np.uint64(links.at_b[k + 1])
    for i in range(whole_eights(links.ends)):
        j = np.uint64(i)
        out[j] += row_b[b0 + j] + row_b[b1 + j] + sign * (row_a[a0 + j] + row_a[a1 + j])


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def _add_layer(links, layer, sign, of_b, of_a, out):
    scalar_gathers_on_amd()
    (bx, by), (ax, ay), (x, y) = of_b, of_a, out
    into, out_of, begin = links.into, links.out_of, np.uint64(layer * links.ends)
    for i in range(links.ends):
        end = np.uint64(i)
        b, a = np.uint64(into[begin + end]), np.uint64(out_of[begin + end])
        x[end] += bx[b] + sign * ax[a]
        y[end] += by[b] + sign * ay[a]


# ------------------------------------------------------------------------- vectors of springs, and rates
@kernel(forceinline=True, fastmath=FAST)
def _put_vectors(body, scratch, links, x, y, vx, vy):
    """The vectors of springs and 1 / length; and the rates of those that are in no run."""
    lx, ly, inverse = scratch.lx, scratch.ly, scratch.inverse
    for r in range(links.first.size):
        _vectors_of_run(links, r, body.softening, x, y, lx, ly, inverse)
    if links.loose < links.behind:
        first, behind, a, b = links.loose, links.behind, body.spring_a, body.spring_b
        _differences(first, behind, a, b, x, y, lx, ly)
        if body.damped or body.joint_damped:
            _differences(first, behind, a, b, vx, vy, scratch.dvx, scratch.dvy)
        _inverses(first, behind, body.softening, lx, ly, inverse)


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def _vectors_of_run(links, r, soft, x, y, lx, ly, inverse):
    eight_at_a_time()
    first, start_a, start_b = np.uint64(links.first[r]), np.uint64(links.a[r]), np.uint64(links.b[r])
    for i in range(whole_eights(links.count[r])):
        s, a, b = first + np.uint64(i), start_a + np.uint64(i), start_b + np.uint64(i)
        to_x, to_y = x[b] - x[a], y[b] - y[a]
        lx[s], ly[s], inverse[s] = to_x, to_y, inverse_root(to_x * to_x + to_y * to_y + soft)


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def _differences(first, behind, spring_a, spring_b, x, y, lx, ly):
    scalar_gathers_on_amd()
    for i in range(first, behind):
        s = np.uint64(i)
        a, b = np.uint64(spring_a[s]), np.uint64(spring_b[s])
        lx[s], ly[s] = x[b] - x[a], y[b] - y[a]


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def _inverses(first, behind, soft, lx, ly, inverse):
    eight_at_a_time()
    for i in range(first, behind):
        s = np.uint64(i)
        inverse[s] = inverse_root(lx[s] * lx[s] + ly[s] * ly[s] + soft)


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def _put_rates(links, vx, vy, dvx, dvy):
    """The rates of the vectors of springs in runs."""
    eight_at_a_time()
    for r in range(links.first.size):
        first, start_a, start_b = np.uint64(links.first[r]), np.uint64(links.a[r]), np.uint64(links.b[r])
        for i in range(links.count[r]):  # no further: behind may be rates of springs in no run
            s, a, b = first + np.uint64(i), start_a + np.uint64(i), start_b + np.uint64(i)
            dvx[s], dvy[s] = vx[b] - vx[a], vy[b] - vy[a]


# ------------------------------------------------------------------------- forces of joints on springs
@kernel(forceinline=True, fastmath=FAST)
def _put_bends(law, body, state, scratch):
    """What joints exert on the b ends of the springs that they hold, without their damping."""
    joints, rows, alone = body.bends, scratch.joint_rows, scratch.joint_alone
    vectors = scratch.lx, scratch.ly, scratch.inverse
    numbers = state.torque_cos, state.torque_sin, body.angular_stiffness, state.torque_rest
    for r in range(joints.first.size):
        _bends_of_run(law, joints, r, body.softening, vectors, numbers, (rows[0], rows[1], rows[2], rows[3]))
    if joints.loose < joints.behind:
        ends, out = (body.joint_a, body.joint_b), (alone[0], alone[1], alone[2], alone[3])
        _bends_alone(law, joints.loose, joints.behind, ends, body.softening, vectors, numbers, out)


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def _bends_of_run(law, joints, r, soft, vectors, numbers, out):
    eight_at_a_time()
    (lx, ly, inverse), (cos, sin, size, rest), (on_ax, on_ay, on_bx, on_by) = vectors, numbers, out
    first, row, count = np.uint64(joints.first[r] + 1), np.uint64(joints.row[r]), joints.count[r]
    start_a, start_b = np.uint64(joints.a[r]), np.uint64(joints.b[r])
    for i in range(whole_eights(count)):
        j, to = first + np.uint64(i), row + np.uint64(i)
        a, b = start_a + np.uint64(i), start_b + np.uint64(i)
        of_a, of_b = (lx[a], ly[a], inverse[a]), (lx[b], ly[b], inverse[b])
        ax, ay, bx, by = bend(law, of_a, of_b, cos[j], sin[j], size[j], rest[j], soft)
        inside = i < count
        on_ax[to] = ax if inside else 0.0
        on_ay[to] = ay if inside else 0.0
        on_bx[to] = bx if inside else 0.0
        on_by[to] = by if inside else 0.0


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def _bends_alone(law, first, behind, ends, soft, vectors, numbers, out):
    scalar_gathers_on_amd()
    (lx, ly, inverse), (cos, sin, size, rest), (on_ax, on_ay, on_bx, on_by) = vectors, numbers, out
    joint_a, joint_b = ends
    for i in range(first, behind):
        j, to = np.uint64(i + 1), np.uint64(i)
        a, b = np.uint64(joint_a[to]), np.uint64(joint_b[to])
        of_a, of_b = (lx[a], ly[a], inverse[a]), (lx[b], ly[b], inverse[b])
        ax, ay, bx, by = bend(law, of_a, of_b, cos[j], sin[j], size[j], rest[j], soft)
        on_ax[to], on_ay[to], on_bx[to], on_by[to] = ax, ay, bx, by


@kernel(forceinline=True, fastmath=FAST)
def _add_rubs(body, scratch):
    """Add what the joints' damping exerts."""
    joints, rows, alone = body.bends, scratch.joint_rows, scratch.joint_alone
    vectors = scratch.lx, scratch.ly, scratch.inverse, scratch.dvx, scratch.dvy
    for r in range(joints.first.size):
        out = rows[0], rows[1], rows[2], rows[3]
        _rubs_of_run(joints, r, body.softening, vectors, body.torque_damping, out)
    ends, out = (body.joint_a, body.joint_b), (alone[0], alone[1], alone[2], alone[3])
    _rubs_alone(joints.loose, joints.behind, ends, body.softening, vectors, body.torque_damping, out)


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def _rubs_of_run(joints, r, soft, vectors, damping, out):
    eight_at_a_time()
    (lx, ly, inverse, dvx, dvy), (on_ax, on_ay, on_bx, on_by) = vectors, out
    first, row, count = np.uint64(joints.first[r] + 1), np.uint64(joints.row[r]), joints.count[r]
    start_a, start_b = np.uint64(joints.a[r]), np.uint64(joints.b[r])
    for i in range(whole_eights(count)):
        j, to = first + np.uint64(i), row + np.uint64(i)
        a, b = start_a + np.uint64(i), start_b + np.uint64(i)
        of_a, of_b = (lx[a], ly[a], inverse[a], dvx[a], dvy[a]), (lx[b], ly[b], inverse[b], dvx[b], dvy[b])
        ax, ay, bx, by = rub(of_a, of_b, damping[j], soft)
        inside = i < count
        on_ax[to] += ax if inside else 0.0
        on_ay[to] += ay if inside else 0.0
        on_bx[to] += bx if inside else 0.0
        on_by[to] += by if inside else 0.0


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def _rubs_alone(first, behind, ends, soft, vectors, damping, out):
    scalar_gathers_on_amd()
    (lx, ly, inverse, dvx, dvy), (on_ax, on_ay, on_bx, on_by) = vectors, out
    joint_a, joint_b = ends
    for i in range(first, behind):
        j, to = np.uint64(i + 1), np.uint64(i)
        a, b = np.uint64(joint_a[to]), np.uint64(joint_b[to])
        of_a, of_b = (lx[a], ly[a], inverse[a], dvx[a], dvy[a]), (lx[b], ly[b], inverse[b], dvx[b], dvy[b])
        ax, ay, bx, by = rub(of_a, of_b, damping[j], soft)
        on_ax[to] += ax
        on_ay[to] += ay
        on_bx[to] += bx
        on_by[to] += by


# ------------------------------------------------------------------------- forces of springs on masses
@kernel(forceinline=True, fastmath=FAST)
def _put_tensions(bent, body, state, scratch, links, rows, vx, vy):
    """The forces on the b ends of springs, `bent` with what joints add: of runs into rows."""
    vectors, joints = (scratch.lx, scratch.ly, scratch.inverse), (scratch.held_x, scratch.held_y)
    numbers = state.rest_tension, body.stiffness, body.damping
    for r in range(links.first.size):
        _tensions_of_run(bent, links, r, vectors, (vx, vy), numbers, joints, (rows[0], rows[1]))
    if links.loose < links.behind:
        rates, out = (scratch.dvx, scratch.dvy), (scratch.tx, scratch.ty)
        _tensions_alone(bent, links.loose, links.behind, vectors, rates, numbers, joints, out)


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def _tensions_of_run(bent, links, r, vectors, speeds, numbers, joints, out):
    eight_at_a_time()
    (lx, ly, inverse), (vx, vy), (held_x, held_y), (tx, ty) = vectors, speeds, joints, out
    rest_tension, stiffness, damping = numbers
    first, start_a, start_b = np.uint64(links.first[r]), np.uint64(links.a[r]), np.uint64(links.b[r])
    row, count = np.uint64(links.row[r]), links.count[r]
    for i in range(whole_eights(count)):
        s, a, b = first + np.uint64(i), start_a + np.uint64(i), start_b + np.uint64(i)
        x, y, to = lx[s], ly[s], row + np.uint64(i)
        along = tension(
            x, y, inverse[s], vx[b] - vx[a], vy[b] - vy[a], rest_tension[s], stiffness[s], damping[s]
        )
        of_x, of_y = along * x, along * y
        if bent:
            of_x += held_x[s]
            of_y += held_y[s]
        tx[to] = of_x if i < count else 0.0
        ty[to] = of_y if i < count else 0.0


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def _tensions_alone(bent, first, behind, vectors, rates, numbers, joints, out):
    eight_at_a_time()
    (lx, ly, inverse), (dvx, dvy), (held_x, held_y), (tx, ty) = vectors, rates, joints, out
    rest_tension, stiffness, damping = numbers
    for i in range(first, behind):
        s = np.uint64(i)
        x, y = lx[s], ly[s]
        along = tension(x, y, inverse[s], dvx[s], dvy[s], rest_tension[s], stiffness[s], damping[s])
        tx[s], ty[s] = along * x, along * y
        if bent:
            tx[s] += held_x[s]
            ty[s] += held_y[s]


SPRINGS = Term(
    "linear",
    lambda scene: bool(scene.linear_springs),
    SpringsReference,
    add_spring_forces,
    causes=("linear stiffness", "linear damping"),
    energy=spring_energies,
    label="linear springs",
    add_derivatives=add_spring_derivatives,
    add_damping=add_spring_damping,
)

JOINTS = Term(
    "angular",
    lambda scene: bool(scene.angular_springs),
    JointsReference,
    causes=("angular stiffness", "angular damping"),
    energy=joint_energies,
    label="angular springs",
    add_derivatives=add_joint_derivatives,
    add_damping=add_joint_damping,
)
