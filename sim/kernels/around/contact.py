"""Contact of masses with linear springs, for which see also `bounce` and `broad_phase`.

Let p = (1 - t) a + t b be the point of a spring that is nearest to a mass, e = b - a the spring's vector, r
the distance, n the unit vector from p to the mass, and tau the one across. Where r is less than the distance
of contact, the mass is pushed along n, and the masses a and b get the opposite force in the shares 1 - t and
t. The push depends on r and its rate.

The speed of sliding is that relative to the spring, which turns: tau . v - r (e x e')/|e|², with the velocity
v of the mass relative to p. It is zero where everything turns like a rigid body. Friction acts along its
gradient by the velocities, which takes energy whenever anything slides, and has neither a sum nor a torque:
besides the force on the mass there is a couple on the spring. A spring shorter than the distance of contact
could not bear that, so friction decreases with the square of its length there.

A pair's forces are w_i F + c_i G with the weights w = (1, t - 1, -t) and c = (0, -1, 1) of the mass, a and b.
"""

from __future__ import annotations

import math

from ..core.jit import FUSED, kernel
from .bounce import push_and_friction, time_to_deepest
from .broad_phase import cover_pairs, meeting, pairs_of, relative_move, segment, update_pairs

_SURE = 0.5
"""Movement of a mass relative to a spring in a step, as a fraction of the distance of contact, that is
harmless."""


@kernel(forceinline=True, fastmath=FUSED)
def moving(vx, vy, a, b):
    """How the spring from mass a to mass b moves: the velocity of its start, and the rate of e."""
    return vx[a], vy[a], vx[b] - vx[a], vy[b] - vy[a]


@kernel(forceinline=True, fastmath=FUSED)
def pair_terms(body, w, m, a, b, line, motion, met, vx, vy):
    """(push, friction, elastic part of the push, r, its direction, outward speed, speed of sliding, lever).

    The lever is the vector by which the speed of sliding decreases with the rate of e.

    Args:
        w: inverse masses, which matter for explicit methods with a fixed step only.
        m, a, b: slots of the masses.
        line, motion: of `segment` and `moving`.
        met: of `meeting`.
        vx, vy: velocity of the mass, px/s.
    """
    contact, h = body.surroundings.contact, body.surroundings.step
    _, _, ex, ey, inverse = line
    sx, sy, wx, wy = motion
    t, dx, dy = met
    r = math.sqrt(dx * dx + dy * dy)
    per_r = 1.0 / (r + 1e-300)
    nx, ny, lx, ly = dx * per_r, dy * per_r, -r * ey * inverse, r * ex * inverse
    vx, vy = vx - sx - t * wx, vy - sy - t * wy
    speed = vx * nx + vy * ny
    along = vy * nx - vx * ny - (wx * lx + wy * ly)
    across, around = 0.0, 0.0
    if h > 0.0:
        u = 1.0 - t
        across = w[m] + u * u * w[a] + t * t * w[b]
        around = (
            w[m]
            + w[a] * ((lx + u * ny) * (lx + u * ny) + (ly - u * nx) * (ly - u * nx))
            + w[b] * ((lx - t * ny) * (lx - t * ny) + (ly + t * nx) * (ly + t * nx))
        )
    push, friction, elastic = push_and_friction(
        contact.stiffness, contact.loss, roughness(contact, ex * ex + ey * ey), contact.slip,
        h, across, around, contact.distance - r, speed, along,
    )  # fmt: skip
    return push, friction, elastic, r, nx, ny, speed, along, lx, ly


@kernel(forceinline=True, fastmath=FUSED)
def roughness(contact, square):
    """The coefficient of friction on a spring with the squared length `square`."""
    whole = contact.distance * contact.distance
    return contact.friction * (square / whole) if square < whole else contact.friction


@kernel(internal=True, fastmath=FUSED)
def push_apart(body, w, x, y, vx, vy, fx, fy):
    """Add the forces of contact on all masses; w: inverse masses."""
    contact = body.surroundings.contact
    near = contact.distance * contact.distance
    update_pairs(body, x, y)
    for s in range(body.springs):
        first, behind = pairs_of(body, s)
        if first == behind:
            continue
        a, b = body.spring_a[s], body.spring_b[s]
        line, motion = segment(x, y, a, b), moving(vx, vy, a, b)
        ax, ay, bx, by = 0.0, 0.0, 0.0, 0.0
        for p in range(first, behind):
            m = contact.member[p]
            met = meeting(line, x[m], y[m])
            t, dx, dy = met
            if dx * dx + dy * dy < near:
                terms = pair_terms(body, w, m, a, b, line, motion, met, vx[m], vy[m])
                push, friction, _, _, nx, ny, _, _, lx, ly = terms
                px, py = push * nx + friction * ny, push * ny - friction * nx
                gx, gy = friction * lx, friction * ly
                fx[m] += px
                fy[m] += py
                ax -= (1.0 - t) * px + gx
                ay -= (1.0 - t) * py + gy
                bx += gx - t * px
                by += gy - t * py
        fx[a] += ax
        fy[a] += ay
        fx[b] += bx
        fy[b] += by


@kernel(internal=True, fastmath=FUSED)
def shortest_hit(body, w, q, v, a, h):
    """The shortest time, s, in which a mass gets as deep into what it touches as its speed leads.

    It is that of pairs that touch, or do so within h seconds, and infinite where there are none.

    Args:
        w: inverse masses, 1/kg.
        a: flat accelerations, px/s².
    """
    contact, shortest, slots = body.surroundings.contact, math.inf, q.size // 2
    x, y = q[:slots], q[slots:]
    update_pairs(body, x, y)
    for s in range(body.springs):
        first, behind = pairs_of(body, s)
        if first == behind:
            continue
        i, k = body.spring_a[s], body.spring_b[s]
        line = segment(x, y, i, k)
        for p in range(first, behind):
            m = contact.member[p]
            t, dx, dy = meeting(line, x[m], y[m])
            u, r = 1.0 - t, math.sqrt(dx * dx + dy * dy)
            across = w[m] + u * u * w[i] + t * t * w[k]
            if across > 0.0:
                nx, ny = dx / (r + 1e-300), dy / (r + 1e-300)
                speed = _outwards(v, nx, ny, slots, m, i, k, t)
                pull = _outwards(a, nx, ny, slots, m, i, k, t)
                hardness, depth = contact.stiffness * across, contact.distance - r
                shortest = min(shortest, time_to_deepest(hardness, depth, speed, pull, h))
    return shortest


@kernel(forceinline=True, fastmath=FUSED)
def _outwards(v, nx, ny, slots, m, a, b, t):
    """The part along (nx, ny) of flat rates of mass m, relative to those of the point t on a spring."""
    u = 1.0 - t
    x, y = v[m] - u * v[a] - t * v[b], v[slots + m] - u * v[slots + a] - t * v[slots + b]
    return x * nx + y * ny


@kernel(internal=True, fastmath=FUSED)
def energy_of_contact(body, x, y):
    """The energy of all pairs that touch, kg px²/s²."""
    energy = 0.0
    update_pairs(body, x, y)
    for s in range(body.springs):
        energy += energy_on_spring(body, x, y, s)
    return energy


@kernel(forceinline=True, fastmath=FUSED)
def energy_on_spring(body, x, y, s):
    """The energy of the masses that touch a spring, kg px²/s²; the list of pairs must be up to date."""
    contact, energy = body.surroundings.contact, 0.0
    first, behind = pairs_of(body, s)
    line = segment(x, y, body.spring_a[s], body.spring_b[s])
    for p in range(first, behind):
        m = contact.member[p]
        _, dx, dy = meeting(line, x[m], y[m])
        depth = contact.distance - math.sqrt(dx * dx + dy * dy)
        if depth > 0.0:
            energy += contact.stiffness * depth * depth * depth / 3.0
    return energy


@kernel(internal=True, fastmath=FUSED)
def power_of_contact(body, w, x, y, vx, vy):
    """The power of friction and of what bouncing loses, which is negative, kg px²/s³."""
    contact, power = body.surroundings.contact, 0.0
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
                terms = pair_terms(body, w, m, a, b, line, motion, met, vx[m], vy[m])
                push, friction, elastic, _, _, _, speed, along, _, _ = terms
                power += (push - elastic) * speed - friction * along
    return power


@kernel(fastmath=FUSED)
def stays_apart(body, q, to_q):
    """Whether in a step from q to to_q no mass can have passed through a spring or gone far into one."""
    contact, slots = body.surroundings.contact, q.size // 2
    x, y, to_x, to_y = q[:slots], q[slots:], to_q[:slots], to_q[slots:]
    sure = _SURE * contact.distance
    moved = relative_move(body.masses, q, to_x, to_y)
    if moved <= sure:
        return True
    cover_pairs(body, x, y, moved)
    for s in range(body.springs):
        first, behind = pairs_of(body, s)
        a, b = body.spring_a[s], body.spring_b[s]
        line = segment(x, y, a, b)
        for p in range(first, behind):
            m = contact.member[p]
            _, dx, dy = meeting(line, x[m], y[m])
            ux, uy = to_x[m] - x[m], to_y[m] - y[m]
            past_a = (ux - to_x[a] + x[a]) ** 2 + (uy - to_y[a] + y[a]) ** 2
            past_b = (ux - to_x[b] + x[b]) ** 2 + (uy - to_y[b] + y[b]) ** 2
            way = math.sqrt(max(past_a, past_b))
            if way > sure and way > math.sqrt(dx * dx + dy * dy) - sure:
                return False
    return True
