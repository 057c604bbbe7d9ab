"""Contact of masses with linear springs and of solid masses with each other: force, energy, balance,
derivatives, and what it asks of a step.

Symbols, rows and the force of a pair are in `pairs`, how pairs are found in `broad_phase`.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...engine.jit import FUSED, kernel
from ...engine.table import Indices
from ...engine.tables import Body, State
from ...near import near_pairs, nearest_points
from ..events import kept_stretch, slip_fraction, stretch_since_touch, touch_fraction
from ..term import Floats, Term, Vectors
from .batch import add_in_batches
from .broad_phase import cover_pairs, meeting, pairs_of, reach_of, relative_move, segment, update_pairs
from .pairs import (
    Contacts,
    add_at_pair,
    friction_on,
    has_contact,
    lost_in,
    mobilities,
    new_contacts,
    pair_at,
    place_of,
    stretch_since,
)
from .push import friction_slopes, push_slopes, pushes_and_frictions, softened_for, time_to_deepest

_SURE = 0.5
"""Movement of a mass relative to a spring in a step, as a fraction of the distance of contact, that is
harmless."""


# ------------------------------------------------------------------------- force
@kernel(internal=True, fastmath=FUSED)
def _add_forces(body, state, scratch, q, v):
    slots = q.size // 2
    update_pairs(body, q[:slots], q[slots:])
    add_in_batches(body, state, scratch, q, v)


# ------------------------------------------------------------------------- energy and balance
@kernel(internal=True, fastmath=FUSED)
def _energy(body, state, q):
    """The sum of k d³ / 3, and what tangential springs have."""
    contact, energy, slots = body.environment.contact, 0.0, q.size // 2
    if contact.present:
        update_pairs(body, q[:slots], q[slots:])
        for s in range(contact.first, contact.end_a.size):
            energy += energy_on(body, q, s)
    return energy + energy_along_springs(body, state, q)


@kernel(forceinline=True, fastmath=FUSED)
def energy_on(body, q, s):
    """The energy of the masses that touch what is touched as number s, kg px²/s²; the list of pairs must be
    up to date."""
    contact, energy, slots = body.environment.contact, 0.0, q.size // 2
    first, behind = pairs_of(body, s)
    line = segment(q[:slots], q[slots:], contact.end_a[s], contact.end_b[s])
    for p in range(first, behind):
        m = contact.member[p]
        _, dx, dy = meeting(line, q[m], q[slots + m])
        depth = reach_of(contact, s, m) - math.sqrt(dx * dx + dy * dy)
        if depth > 0.0:
            energy += contact.stiffness * depth * depth * depth / 3.0
    return energy


@kernel(internal=True, fastmath=FUSED)
def energy_along_springs(body, state, q):
    """The energy of the tangential springs at positions q, kg px²/s²."""
    contact, energy, slots = body.environment.contact, 0.0, q.size // 2
    if contact.present and contact.tangential > 0.0:
        update_pairs(body, q[:slots], q[slots:])
        for s in range(body.springs):
            energy += energy_along_spring(body, state, q, s)
    return energy


@kernel(internal=True, fastmath=FUSED)
def energy_along_spring(body, state, q, s):
    """That of the tangential springs of one spring; the list of pairs must be up to date."""
    contact, energy = body.environment.contact, 0.0
    if contact.tangential > 0.0:
        first, behind = pairs_of(body, s)
        for p in range(first, behind):
            touches, pair = pair_at(body, state, state.inverse_mass, s, contact.member[p], q, state.v)
            if touches:
                energy += 0.5 * pair.tangential * pair.stretch * pair.stretch
    return energy


@kernel(internal=True, fastmath=FUSED)
def _slider(body, pair, pull):
    """(stretch, speed along, largest friction, rate of that) of a pair, as in `events.slip_fraction`; `pull`:
    the acceleration outwards of its mass, px/s²."""
    contact, depth = body.environment.contact, pair.reach - pair.r
    friction = friction_on(contact, pair.ex * pair.ex + pair.ey * pair.ey)
    by_depth, by_speed = 0.0, 0.0
    if depth > 0.0:
        by_depth, by_speed = push_slopes(contact.stiffness, lost_in(contact), depth, pair.speed)
    return (
        pair.stretch,
        pair.along,
        friction * pair.push,
        friction * (by_speed * pull - by_depth * pair.speed),
    )


@kernel(internal=True, fastmath=FUSED)
def slip_fraction_on_springs(body, state, q, v, to_q, to_v, h, unseen):
    """The part of a step that leads just beyond where a mass begins to touch a spring, or to slide along it,
    or turns round; see `events.slip_fraction`."""
    contact, w, slots, part = body.environment.contact, state.inverse_mass, q.size // 2, 1.0
    if not (contact.present and contact.tangential > 0.0):
        return part
    spring = contact.tangential, contact.resisting
    update_pairs(body, to_q[:slots], to_q[slots:])
    for s in range(body.springs):
        first, behind = pairs_of(body, s)
        for p in range(first, behind):
            m = contact.member[p]
            near, pair = pair_at(body, state, w, s, m, to_q, to_v, contact.margin)
            was_near, old = pair_at(body, state, w, s, m, q, v, contact.margin)
            if near and was_near and max(pair.reach - pair.r, old.reach - old.r) > 0.0:
                weights, n, arm = (w[m], w[pair.a], w[pair.b]), (pair.nx, pair.ny), (pair.lx, pair.ly)
                _, mobility = mobilities(weights, pair.t, n, arm)
                pull = (pair.speed - old.speed) / h
                start, end = _slider(body, old, pull), _slider(body, pair, pull)
                if pair.gripped:
                    part = min(part, slip_fraction(h, spring, mobility, start, end, unseen))
                elif pair.r < pair.reach <= old.r:
                    depths = pair.reach - old.r, pair.reach - pair.r
                    speeds = old.speed, pair.speed
                    part = min(part, touch_fraction(h, spring, mobility, depths, speeds, end, unseen))
    return part


@kernel(internal=True, fastmath=FUSED)
def stick_to_springs(body, state, scratch, q0, v0, q, v, h):
    """Note the stretch of each tangential spring at the end of a step, and let sliders slide: see `push`.

    Arguments: see `friction_history.update_friction_history`.
    """
    contact, slots, count = body.environment.contact, q.size // 2, 0
    masses, stretches = scratch.next_mass, scratch.next_stretch
    if not (contact.present and contact.tangential > 0.0):
        return
    update_pairs(body, q[:slots], q[slots:])
    for s in range(body.springs):
        first, behind = pairs_of(body, s)
        row = count
        for p in range(first, behind):
            m = contact.member[p]
            touches, pair = pair_at(body, state, state.inverse_mass, s, m, q, v)
            if touches and count < masses.size:
                was_near, old = False, pair
                if h > 0.0:
                    was_near, old = pair_at(body, state, state.inverse_mass, s, m, q0, v0, contact.margin)
                pull = (pair.speed - old.speed) / h if was_near else 0.0
                start, end, stretch = _slider(body, old, pull), _slider(body, pair, pull), 0.0
                if pair.gripped:
                    stretch = kept_stretch(h if was_near else 0.0, pair.tangential, start, end)
                elif was_near and old.r > pair.reach:
                    was = 0.0, *place_of(old)
                    here = pair.t, pair.r, pair.nx, pair.ny, pair.ex, pair.ey, pair.per_square
                    stretch = stretch_since_touch(
                        h, pair.tangential, (pair.reach - old.r, pair.reach - pair.r),
                        (old.speed, pair.speed), stretch_since(was, here), (old.along, pair.along), end[2],
                    )  # fmt: skip
                masses[count], stretches[count, 0] = pair.m, stretch
                t, ahead, beside, length, r = place_of(pair)
                stretches[count, 1], stretches[count, 2], stretches[count, 3] = t, ahead, beside
                stretches[count, 4], stretches[count, 5] = length, r
                count += 1
        state.contact_start[s] = row  # no later spring needs what it was
    state.contact_start[body.springs] = count
    for k in range(count):
        state.contact_mass[k] = masses[k]
        for i in range(stretches.shape[1]):
            state.contact_stretch[k, i] = stretches[k, i]


@kernel(internal=True, fastmath=FUSED)
def _add_power(body, state, balance, q, v, part):
    """Friction, and what bouncing loses."""
    contact, power, slots = body.environment.contact, 0.0, q.size // 2
    if not contact.present:
        return
    update_pairs(body, q[:slots], q[slots:])
    for s in range(contact.first, contact.end_a.size):
        first, behind = pairs_of(body, s)
        for p in range(first, behind):
            touches, pair = pair_at(body, state, state.inverse_mass, s, contact.member[p], q, v)
            if touches:
                power += (pair.push - pair.elastic) * pair.speed - pair.friction * pair.along
    balance.work.walls += part * power


# ------------------------------------------------------------------------- derivatives
COUPLING_G, COUPLING_DEFINITE, COUPLING_PAIRS = 0, 1, 2
"""In `Matrix.coupling`: factor of the derivatives by velocities, 1/s, whether what could make the matrix
indefinite is left out, and the number of pairs that touch."""


@kernel(forceinline=True, fastmath=FUSED)
def _pair_jvp(contact, pair, change, g, definite):
    """How F and G change when the masses of a pair move, to first order.

    With the changes x_i of the positions of the mass, a and b, let D = sum of w_i x_i be that of the mass
    relative to p, as if t were fixed, and E = sum of c_i x_i that of e. From r n = x_m - a - t e, which is
    at right angles to e unless t is at an end of the spring,

        t changes by `shift` = (e . D + r n . E) / |e|², or 0 at an end;
        r by `away` = n . D, so d by minus that;
        n turns by `turn` = (e x E) / |e|², or (n x D) / r at an end, that is by turn tau;
        |e|² by 2 `stretch` |e|², with stretch = (e . E) / |e|².

    With `spin` = (e x e') / |e|², the speeds s = n . V and u = n x V - r spin change by

        `faster` = turn (n x V) - shift (n . e'),
        `sliding` = 2 r spin stretch - shift (n x e') - turn s - away spin - r (E x e') / |e|²,

    and if the velocities change by g D and g E, too, by g away and g `slide`, where slide = n x D - L . E.
    With these, the push changes by `more` = dN/ds (faster + g away) - dN/dd away, and friction T(mu N, z, u)
    by `drag` = mu dT/d(mu N) more + dT/du (sliding + g slide) + dT/dz slide, as the stretch z of a tangential
    spring changes like what u is the rate of, plus 2 stretch mu N dT/d(mu N) where mu is in proportion to
    |e|². So, since n changes by turn tau and tau by -turn n,

        F = N n - T tau changes by (more + T turn) n + (N turn - drag) tau,
        G = T L by drag L + T ((away J e + r J E) / |e|² - 2 stretch L), with J x = (-x.y, x.x).

    The weights w_i change by -shift c_i, so the change of w_i F + c_i G is w_i (that of F) + c_i (that of G
    less shift F).

    Args:
        contact: the table.
        pair: the pair.
        change: D.x, D.y, E.x, E.y, px.
        g: 1/s.
        definite: leave out what could make the matrix of an implicit step indefinite: all but
            -dN/dd away, dT/dz, and the terms with g, without friction's part in proportion to the push.

    Returns:
        The x and y of the change of F, and of that of G less shift F, kg px/s².
    """
    dx, dy, fx, fy = change
    t, r, nx, ny, ex, ey, lx, ly = pair.t, pair.r, pair.nx, pair.ny, pair.ex, pair.ey, pair.lx, pair.ly
    vx, vy, wx, wy, speed = pair.vx, pair.vy, pair.wx, pair.wy, pair.speed
    push, friction, per_square = pair.push, pair.friction, pair.per_square
    spring = contact.tangential, contact.resisting
    square = ex * ex + ey * ey
    by_depth, by_speed = push_slopes(contact.stiffness, lost_in(contact), pair.reach - r, speed)
    coefficient = friction_on(contact, square)
    most = coefficient * push
    held, stiff, stuck = friction_slopes(most, contact.slip_speed, spring, pair.along, pair.stretch)
    stiff = stiff if pair.gripped else 0.0
    away, past = nx * dx + ny * dy, nx * dy - ny * dx
    slide = past - (fx * lx + fy * ly)
    if definite:
        more, drag = (g * by_speed - by_depth) * away, (g * stuck + stiff) * slide
        return more * nx + drag * ny, more * ny - drag * nx, drag * lx, drag * ly
    if 0.0 < t < 1.0:
        turn = (ex * fy - ey * fx) * per_square
        shift = (ex * dx + ey * dy + r * (nx * fx + ny * fy)) * per_square
    else:
        turn, shift = past / (r + 1e-300), 0.0
    stretch, spin = (ex * fx + ey * fy) * per_square, (ex * wy - ey * wx) * per_square
    faster = (nx * vy - ny * vx) * turn - shift * (nx * wx + ny * wy)
    sliding = (
        2.0 * r * spin * stretch
        - shift * (nx * wy - ny * wx)
        - speed * turn
        - away * spin
        - r * (fx * wy - fy * wx) * per_square
    )
    more = by_speed * (faster + g * away) - by_depth * away
    drag = coefficient * held * more + stuck * (sliding + g * slide) + stiff * slide
    if square < contact.distance * contact.distance:
        drag += 2.0 * held * most * stretch
    along_n, across_n = more + friction * turn, push * turn - drag
    longer = drag - 2.0 * friction * stretch
    by_away, by_turn = friction * away * per_square, friction * r * per_square
    return (
        nx * along_n - ny * across_n,
        ny * along_n + nx * across_n,
        lx * longer - ey * by_away - fy * by_turn - shift * (push * nx + friction * ny),
        ly * longer + ex * by_away + fx * by_turn - shift * (push * ny - friction * nx),
    )


@kernel(forceinline=True, fastmath=FUSED)
def _pair_damping_jvp(contact, pair, change):
    """How F and G change when the velocities of a pair change, to first order, kg px/s².

    `change`: that of `_pair_jvp` for velocities, px/s. The terms are those there with g.
    """
    dx, dy, fx, fy = change
    nx, ny, lx, ly = pair.nx, pair.ny, pair.lx, pair.ly
    _, by_speed = push_slopes(contact.stiffness, lost_in(contact), pair.reach - pair.r, pair.speed)
    more, slide = by_speed * (nx * dx + ny * dy), nx * dy - ny * dx - (fx * lx + fy * ly)
    coefficient = friction_on(contact, pair.ex * pair.ex + pair.ey * pair.ey)
    held, _, stuck = friction_slopes(
        coefficient * pair.push,
        contact.slip_speed,
        (contact.tangential, contact.resisting),
        pair.along,
        pair.stretch,
    )
    drag = coefficient * held * more + stuck * slide
    return more * nx + drag * ny, more * ny - drag * nx, drag * lx, drag * ly


@kernel(internal=True, fastmath=FUSED)
def _add_derivatives(body, state, matrix, q, v, g, definite):
    """What contact adds to the blocks in the pattern: of a mass with itself, and of the ends of a spring.

    With f, h the changes of F and G by D and fe, he those by E, the force on i changes with the position of
    j by w_i w_j f + w_i c_j fe + c_i w_j h + c_i c_j he. The blocks that join the mass to the spring are not
    in the pattern; what they are made of is remembered for `add_coupling`.
    """
    contact, slots = body.environment.contact, q.size // 2
    if not contact.present:
        return
    at, targets, blocks, count = matrix.coupling_state, matrix.spring_target, matrix.blocks, 0
    for j in range(q.size):
        at[0, j], at[1, j] = q[j], v[j]
    for i in range(slots):
        at[2, i] = state.inverse_mass[i]
    update_pairs(body, q[:slots], q[slots:])
    for s in range(contact.first, contact.end_a.size):
        first, behind = pairs_of(body, s)
        bb, ba, ab, aa = 0, 0, 0, 4 * matrix.of_mass[contact.end_a[s]]
        if s < body.springs:
            bb, ba = 4 * targets[4 * s], 4 * targets[4 * s + 1]
            ab, aa = 4 * targets[4 * s + 2], 4 * targets[4 * s + 3]
        for p in range(first, behind):
            touches, pair = pair_at(body, state, state.inverse_mass, s, contact.member[p], q, v)
            if touches:
                count += 1
                t, u, mm = pair.t, 1.0 - pair.t, 4 * matrix.of_mass[pair.m]
                for axis in range(2):
                    one, other = (1.0, 0.0) if axis == 0 else (0.0, 1.0)
                    by_d = _pair_jvp(contact, pair, (one, other, 0.0, 0.0), g, definite)
                    by_e = _pair_jvp(contact, pair, (0.0, 0.0, one, other), g, definite)
                    for part in range(2):
                        e = 2 * part + axis
                        f, h, fe, he = by_d[part], by_d[2 + part], by_e[part], by_e[2 + part]
                        blocks[mm + e] += f
                        if s >= body.springs:
                            blocks[aa + e] += f
                            continue
                        blocks[bb + e] += t * t * f - t * (h + fe) + he
                        blocks[ba + e] += t * u * f + t * fe - u * h - he
                        blocks[ab + e] += u * t * f + t * h - u * fe - he
                        blocks[aa + e] += u * u * f + u * (h + fe) + he
    matrix.coupling[COUPLING_G], matrix.coupling[COUPLING_PAIRS] = g, count
    matrix.coupling[COUPLING_DEFINITE] = 1.0 if definite else 0.0


@kernel(internal=True, fastmath=FUSED)
def add_coupling(body, state, matrix, z, out):
    """out += R z, with the blocks of a I - g Jv - Jx that join masses to springs, of the last factors."""
    contact, slots = body.environment.contact, z.size // 2
    q, v, w = matrix.coupling_state[0], matrix.coupling_state[1], matrix.coupling_state[2]
    g, definite = matrix.coupling[COUPLING_G], matrix.coupling[COUPLING_DEFINITE] > 0.0
    update_pairs(body, q[:slots], q[slots:])
    for s in range(contact.first, contact.end_a.size):
        first, behind = pairs_of(body, s)
        for p in range(first, behind):
            touches, pair = pair_at(body, state, w, s, contact.member[p], q, v)
            if touches:
                m, a, b, t, u = pair.m, pair.a, pair.b, pair.t, 1.0 - pair.t
                ax, ay, bx, by = z[a], z[slots + a], z[b], z[slots + b]
                change = (-u * ax - t * bx, -u * ay - t * by, bx - ax, by - ay)
                force = _pair_jvp(contact, pair, change, g, definite)
                add_at_pair(pair, (-w[m], 0.0, 0.0), force, (out[:slots], out[slots:]))
                force = _pair_jvp(contact, pair, (z[m], z[slots + m], 0.0, 0.0), g, definite)
                add_at_pair(pair, (0.0, -w[a], -w[b]), force, (out[:slots], out[slots:]))


@kernel(internal=True, fastmath=FUSED)
def _add_damping(body, state, q, v, z, factor, out):
    contact, w, slots = body.environment.contact, state.inverse_mass, q.size // 2
    if not contact.present:
        return
    update_pairs(body, q[:slots], q[slots:])
    for s in range(contact.first, contact.end_a.size):
        first, behind = pairs_of(body, s)
        for p in range(first, behind):
            touches, pair = pair_at(body, state, w, s, contact.member[p], q, v)
            if touches:
                m, a, b, t = pair.m, pair.a, pair.b, pair.t
                ex, ey = z[b] - z[a], z[slots + b] - z[slots + a]
                change = (z[m] - z[a] - t * ex, z[slots + m] - z[slots + a] - t * ey, ex, ey)
                factors = factor * w[m], factor * w[a], factor * w[b]
                add_at_pair(
                    pair, factors, _pair_damping_jvp(contact, pair, change), (out[:slots], out[slots:])
                )


# ------------------------------------------------------------------------- what it asks of a step
@kernel(internal=True, fastmath=FUSED)
def _impact_time(body, state, q, v, a, h):
    contact, w, shortest, slots = body.environment.contact, state.inverse_mass, math.inf, q.size // 2
    if not contact.present:
        return shortest
    update_pairs(body, q[:slots], q[slots:])
    for s in range(contact.first, contact.end_a.size):
        first, behind = pairs_of(body, s)
        i, k = contact.end_a[s], contact.end_b[s]
        line = segment(q[:slots], q[slots:], i, k)
        for p in range(first, behind):
            m = contact.member[p]
            t, dx, dy = meeting(line, q[m], q[slots + m])
            u, r = 1.0 - t, math.sqrt(dx * dx + dy * dy)
            mobility = w[m] + u * u * w[i] + t * t * w[k]
            if mobility > 0.0:
                nx, ny = dx / (r + 1e-300), dy / (r + 1e-300)
                speed = _outwards(v, nx, ny, slots, m, i, k, t)
                outwards = _outwards(a, nx, ny, slots, m, i, k, t)
                hardness, depth = contact.stiffness * mobility, reach_of(contact, s, m) - r
                shortest = min(shortest, time_to_deepest(hardness, depth, speed, outwards, h))
    return shortest


@kernel(forceinline=True, fastmath=FUSED)
def _outwards(v, nx, ny, slots, m, a, b, t):
    """The part along (nx, ny) of flat rates of mass m, relative to those of the point t on a spring."""
    u = 1.0 - t
    x, y = v[m] - u * v[a] - t * v[b], v[slots + m] - u * v[slots + a] - t * v[slots + b]
    return x * nx + y * ny


@kernel(fastmath=FUSED)
def no_tunnelling(body, q, to_q):
    """Whether in a step from q to to_q no mass can have passed through a spring or gone far into one."""
    contact, slots = body.environment.contact, q.size // 2
    x, y, to_x, to_y = q[:slots], q[slots:], to_q[:slots], to_q[slots:]
    moved = relative_move(body.masses, q, to_x, to_y)
    if moved <= _SURE * contact.least:
        return True
    cover_pairs(body, x, y, moved)
    for s in range(contact.first, contact.end_a.size):
        first, behind = pairs_of(body, s)
        a, b = contact.end_a[s], contact.end_b[s]
        line = segment(x, y, a, b)
        for p in range(first, behind):
            m = contact.member[p]
            _, dx, dy = meeting(line, x[m], y[m])
            ux, uy = to_x[m] - x[m], to_y[m] - y[m]
            past_a = (ux - to_x[a] + x[a]) ** 2 + (uy - to_y[a] + y[a]) ** 2
            past_b = (ux - to_x[b] + x[b]) ** 2 + (uy - to_y[b] + y[b]) ** 2
            way, sure = math.sqrt(max(past_a, past_b)), _SURE * reach_of(contact, s, m)
            if way > sure and way > math.sqrt(dx * dx + dy * dy) - sure:
                return False
    return True


# ------------------------------------------------------------------------- in NumPy
class ContactReference:
    """Contact in NumPy; see `Reference`.

    Pairs that are nearer than the distance of contact plus a margin are kept until some mass has moved by
    half of the margin.
    """

    def __init__(self, body: Body, state: State) -> None:
        self._contact, self._step = body.environment.contact, body.environment.step
        self._state, self._springs = state, body.springs
        self._ends = np.stack((self._contact.end_a, self._contact.end_b), 1)
        self._masses = np.arange(1, body.masses + 1)
        self._at = np.full(state.inverse_mass.size, np.inf + 0j)
        self._pairs = np.zeros((4, 0), np.int64)

    def forces(self, x: Vectors, v: Vectors) -> Vectors:
        """See `Reference`."""
        total = np.zeros_like(x)
        if not self._contact.present:
            return total
        (_, m, a, b), t, normal, arm, push, friction, _, _ = self._pushed(x, v)
        force, couple = (push - 1j * friction) * normal, friction * arm
        np.add.at(total, m, force)
        np.add.at(total, a, -(1.0 - t) * force - couple)
        np.add.at(total, b, -t * force + couple)
        return total

    def _pushed(self, x: Vectors, v: Vectors) -> tuple[Any, ...]:
        """Of the pairs that touch: spring, mass and ends; t; n; L; N; T; the stretch; the most it may be."""
        contact = self._contact
        pairs, t, gap = self._touching(x)
        _, m, a, b = pairs
        spring, turning = x[b] - x[a], v[b] - v[a]
        normal, square = gap / np.maximum(abs(gap), 1e-300), np.maximum(abs(spring) ** 2, 1e-300)
        arm = 1j * spring * abs(gap) / square
        rate = (v[m] - v[a] - t * turning) * normal.conjugate()
        speed = rate - 1j * (turning * arm.conjugate()).real
        free, tangent = self._state.inverse_mass, 1j * normal
        mobility = free[m] + (1.0 - t) ** 2 * free[a] + t**2 * free[b]
        mobility_along = (
            free[m] + free[a] * abs(arm - (1.0 - t) * tangent) ** 2 + free[b] * abs(arm + t * tangent) ** 2
        )
        coefficient = contact.friction * np.minimum(square / max(contact.distance, 1e-150) ** 2, 1.0)
        stretch = self._stretches(pairs, t, gap, spring)
        tangential = contact.tangential, contact.resisting
        push, friction = pushes_and_frictions(
            contact.stiffness, (contact.damping, contact.hysteresis, contact.calm), coefficient,
            contact.slip_speed, tangential, self._step, mobility, mobility_along,
            self._reach(pairs) - abs(gap), speed, stretch,
        )  # fmt: skip
        stiffness, _ = softened_for(tangential, self._step, mobility_along)
        return pairs, t, normal, arm, push, friction, stretch, (stiffness, coefficient * push)

    def _stretches(self, pairs: NDArray[np.int64], t: Floats, gap: Vectors, spring: Vectors) -> Floats:
        """(k,) px, of tangential springs; 0 for pairs that have none yet."""
        state, stretch = self._state, np.zeros(t.size)
        if not self._contact.tangential or not t.size:
            return stretch
        of_spring = np.repeat(np.arange(self._springs), np.diff(state.contact_start))
        known = of_spring * self._at.size + state.contact_mass[: of_spring.size]  # in ascending order
        keys = pairs[0] * self._at.size + pairs[1]
        k = np.searchsorted(known, keys)
        found = np.append(known, -1)[k] == keys
        was, way = state.contact_stretch[k[found]], direction(gap, spring)[found]
        # The sine of the angle by which n has turned relative to the spring, and the way along the spring.
        turned = ((was[:, 2] - 1j * was[:, 3]) * way).imag
        length, r = 0.5 * (abs(spring[found]) + was[:, 4]), 0.5 * (abs(gap[found]) + was[:, 5])
        stretch[found] = was[:, 0] + r * turned - np.copysign(length, way.imag) * (t[found] - was[:, 1])
        return stretch

    def update_friction_history(self, x: Vectors, v: Vectors) -> None:
        """`stick_to_springs`."""
        contact, state = self._contact, self._state
        if not (contact.present and contact.tangential):
            return
        (s, m, a, b), t, _, _, _, _, stretch, (stiffness, most) = self._pushed(x, v)
        order, bound = np.lexsort((m, s)), most / stiffness
        order = order[s[order] < self._springs][: state.contact_mass.size]
        kept = np.column_stack((np.clip(stretch, -bound, bound), *places(x, m, a, b, t)))
        state.contact_start[:] = np.searchsorted(s[order], np.arange(self._springs + 1))
        state.contact_mass[: order.size], state.contact_stretch[: order.size] = m[order], kept[order]

    def energy(self, x: Vectors) -> float:
        """See `Reference`."""
        contact = self._contact
        if not contact.present:
            return 0.0
        pairs, _, gap = self._touching(x)
        energy = float((contact.stiffness * (self._reach(pairs) - abs(gap)) ** 3).sum()) / 3.0
        if not contact.tangential:
            return energy
        *_, stretch, (stiffness, _) = self._pushed(x, np.zeros_like(x))
        return energy + 0.5 * float((stiffness * stretch**2).sum())

    def _reach(self, pairs: NDArray[np.int64]) -> Floats:
        """(k,) the distance at which each pair touches, px."""
        return self._contact.thickness[pairs[0]] + self._contact.size[pairs[1]]

    def _touching(self, x: Vectors) -> tuple[NDArray[np.int64], Floats, Vectors]:
        """(4, k) the spring, the mass and the ends of the spring of each pair, the nearest point, and the way
        from it."""
        contact = self._contact
        here = self._masses
        if not contact.present or not np.isfinite(x[here]).all():
            return self._pairs[:, :0], np.zeros(0), x[:0]
        if not 2.0 * float(abs(x[here] - self._at[here]).max()) <= contact.margin:
            self._pairs, self._at = self._near(x), x.copy()
        _, m, a, b = self._pairs
        t = nearest_points(x[m], x[a], x[b])
        gap = x[m] - x[a] - t * (x[b] - x[a])
        near = abs(gap) < self._reach(self._pairs)
        return self._pairs[:, near], t[near], gap[near]

    def _near(self, x: Vectors) -> NDArray[np.int64]:
        """(4, k) what is touched, the mass and the ends of the former, of each pair that may touch."""
        contact, first = self._contact, self._contact.first
        found, mass = near_pairs(x, self._masses, self._ends[first:], contact.reach + contact.margin)
        touched = first + found
        never = np.repeat(np.arange(len(self._ends)), np.diff(contact.apart_start))
        apart = np.isin(touched * x.size + mass, never * x.size + contact.apart)
        broken = np.concatenate((contact.broken, np.zeros(len(self._ends) - self._springs)))[touched] != 0.0
        balls = (contact.size[mass] > 0.0) & (mass > self._ends[touched, 0])
        may = np.where(touched < self._springs, ~broken, balls)
        return np.stack((touched, mass, *self._ends[touched].T))[:, ~apart & may]


def direction(gap: Vectors, spring: Vectors) -> Vectors:
    """Of a vector relative to a spring's, of length 1."""
    relative = spring.conjugate() * gap
    return relative / np.maximum(abs(relative), 1e-300)


def places(x: Vectors, m: Indices, a: Indices, b: Indices, t: Floats) -> tuple[NDArray[Any], ...]:
    """(k,) each of `pairs.place_of`, of masses that touch springs from a to b at t."""
    spring = x[b] - x[a]
    gap = x[m] - x[a] - t * spring
    way = direction(gap, spring)
    return t, way.real, way.imag, abs(spring), abs(gap)


def _bounds(body: Body) -> tuple[Floats, Floats]:
    """See `Term.bounds`: of a mass that is on a spring, as deep as it can be."""
    contact, each = body.environment.contact, np.ones(body.masses)
    stiff = contact.stiffness * contact.reach
    return 4.0 * stiff * each, 2.0 * contact.damping * stiff * contact.reach * each


CONTACT = Term(
    "contact",
    has_contact,
    ContactReference,
    _add_forces,
    field="contact",
    table=Contacts,
    new=new_contacts,
    energy=_energy,
    label="contact",
    add_power=_add_power,
    add_derivatives=_add_derivatives,
    add_damping=_add_damping,
    impact_time=_impact_time,
    bounds=_bounds,
    touches=True,
    holds=True,
    sticks=lambda contact: contact.tangential > 0.0,
)
