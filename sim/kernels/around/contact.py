"""Contact of masses with linear springs, for which see also `bounce` and `broad_phase`.

Let p = (1 - t) a + t b be the point of a spring that is nearest to a mass, e = b - a the spring's vector, r the
distance, n the unit vector from p to the mass, and tau the one across. Where r is less than the distance of
contact, the mass is pushed along n, and the masses a and b get the opposite force in the shares 1 - t and t.
The push depends on r and its rate.

The speed of sliding is that relative to the spring, which turns: tau . v - r (e x e')/|e|², with the velocity v
of the mass relative to p. It is zero where everything turns like a rigid body. Friction acts along its gradient
by the velocities, which takes energy whenever anything slides, and has neither a sum nor a torque: besides the
force on the mass there is a couple on the spring. A spring shorter than the distance of contact could not bear
that, so friction decreases with the square of its length there.

A pair's forces are w_i F + c_i G with the weights w = (1, t - 1, -t) and c = (0, -1, 1) of the mass, a and b.
"""

from __future__ import annotations

import math

from ..core.jit import FUSED, kernel
from .bounce import push_and_friction, slopes_of_push
from .broad_phase import DIAGONAL, cover_pairs, farthest_move, nearest_point, pairs_of, update_pairs

_SURE = 0.5
"""Movement of a mass relative to a spring in a step, as a fraction of the distance of contact, that is
harmless."""

_TINY = 1e-300
"""px², added to squared lengths that are divided by."""


@kernel(forceinline=True, fastmath=FUSED)
def meeting(x, y, m, a, b):
    """How mass m and the spring from a to b lie: t, the vector from the nearest point to m, and e."""
    ex, ey = x[b] - x[a], y[b] - y[a]
    t = nearest_point(x[m], y[m], x[a], y[a], ex, ey)
    return t, x[m] - x[a] - t * ex, y[m] - y[a] - t * ey, ex, ey


@kernel(forceinline=True, fastmath=FUSED)
def rates(vx, vy, m, a, b, t):
    """The velocity of m relative to the point t of the spring, and the rate of e."""
    ex, ey = vx[b] - vx[a], vy[b] - vy[a]
    return vx[m] - vx[a] - t * ex, vy[m] - vy[a] - t * ey, ex, ey


@kernel(forceinline=True, fastmath=FUSED)
def pair_terms(body, w, m, a, b, met, rate):
    """(push, friction, elastic part of the push, its direction, outward speed, speed of sliding, lever).

    The lever is the vector by which the speed of sliding decreases with the rate of e.

    Args:
        w: inverse masses, which matter for methods of first order only.
        m, a, b: slots of the masses.
        met: of `meeting`.
        rate: of `rates`.
    """
    contact, h = body.surroundings.contact, body.surroundings.step
    t, dx, dy, ex, ey = met
    r, square = math.sqrt(dx * dx + dy * dy), ex * ex + ey * ey
    nx, ny = dx / (r + _TINY), dy / (r + _TINY)
    lx, ly = -r * ey / (square + _TINY), r * ex / (square + _TINY)
    speed = rate[0] * nx + rate[1] * ny
    along = rate[1] * nx - rate[0] * ny - (rate[2] * lx + rate[3] * ly)
    across, around = 0.0, 0.0
    if h > 0.0:
        u = 1.0 - t
        across = w[m] + u * u * w[a] + t * t * w[b]
        around = (
            w[m]
            + w[a] * ((lx + u * ny) * (lx + u * ny) + (ly - u * nx) * (ly - u * nx))
            + w[b] * ((lx - t * ny) * (lx - t * ny) + (ly + t * nx) * (ly + t * nx))
        )
    rough = contact.friction * min(square / (contact.distance * contact.distance), 1.0)
    push, friction, elastic = push_and_friction(
        contact.stiffness, contact.loss, rough, contact.slip,
        h, across, around, contact.distance - r, speed, along,
    )  # fmt: skip
    return push, friction, elastic, nx, ny, speed, along, lx, ly


@kernel(internal=True, fastmath=FUSED)
def push_apart(body, w, x, y, vx, vy, fx, fy):
    """Add the forces of contact on all masses; w: inverse masses."""
    contact = body.surroundings.contact
    square = contact.distance * contact.distance
    update_pairs(body, x, y)
    for s in range(body.springs):
        first, behind = pairs_of(body, s)
        a, b = body.spring_a[s], body.spring_b[s]
        for p in range(first, behind):
            m = contact.member[p]
            met = meeting(x, y, m, a, b)
            t, dx, dy, _, _ = met
            if dx * dx + dy * dy < square:
                terms = pair_terms(body, w, m, a, b, met, rates(vx, vy, m, a, b, t))
                push, friction, _, nx, ny, _, _, lx, ly = terms
                px, py = push * nx + friction * ny, push * ny - friction * nx
                gx, gy = friction * lx, friction * ly
                fx[m] += px
                fy[m] += py
                fx[a] -= (1.0 - t) * px + gx
                fy[a] -= (1.0 - t) * py + gy
                fx[b] += gx - t * px
                fy[b] += gy - t * py


@kernel(internal=True, fastmath=FUSED)
def energy_of_contact(body, x, y):
    """The energy of all pairs that touch, kg px²/s²."""
    contact, energy = body.surroundings.contact, 0.0
    update_pairs(body, x, y)
    for s in range(body.springs):
        first, behind = pairs_of(body, s)
        for p in range(first, behind):
            _, dx, dy, _, _ = meeting(x, y, contact.member[p], body.spring_a[s], body.spring_b[s])
            depth = contact.distance - math.sqrt(dx * dx + dy * dy)
            if depth > 0.0:
                energy += contact.stiffness * depth * depth * depth / 3.0
    return energy


@kernel(internal=True, fastmath=FUSED)
def power_of_contact(body, w, x, y, vx, vy):
    """The power of friction and of what bouncing loses, which is negative, kg px²/s³."""
    contact, power = body.surroundings.contact, 0.0
    square = contact.distance * contact.distance
    update_pairs(body, x, y)
    for s in range(body.springs):
        first, behind = pairs_of(body, s)
        a, b = body.spring_a[s], body.spring_b[s]
        for p in range(first, behind):
            m = contact.member[p]
            met = meeting(x, y, m, a, b)
            if met[1] * met[1] + met[2] * met[2] < square:
                terms = pair_terms(body, w, m, a, b, met, rates(vx, vy, m, a, b, met[0]))
                push, friction, elastic, _, _, speed, along, _, _ = terms
                power += (push - elastic) * speed - friction * along
    return power


@kernel(internal=True, fastmath=FUSED)
def stays_apart(body, q, to_q):
    """Whether in a step from q to to_q no mass can have passed through a spring or gone far into one."""
    contact, slots = body.surroundings.contact, q.size // 2
    x, y, to_x, to_y = q[:slots], q[slots:], to_q[:slots], to_q[slots:]
    sure = _SURE * contact.distance
    moved = 2.0 * DIAGONAL * farthest_move(body.masses, q, to_x, to_y)
    if moved <= sure:
        return True
    cover_pairs(body, x, y, moved)
    for s in range(body.springs):
        first, behind = pairs_of(body, s)
        a, b = body.spring_a[s], body.spring_b[s]
        for p in range(first, behind):
            m = contact.member[p]
            _, dx, dy, _, _ = meeting(x, y, m, a, b)
            ux, uy = to_x[m] - x[m], to_y[m] - y[m]
            past_a = (ux - to_x[a] + x[a]) ** 2 + (uy - to_y[a] + y[a]) ** 2
            past_b = (ux - to_x[b] + x[b]) ** 2 + (uy - to_y[b] + y[b]) ** 2
            way = math.sqrt(max(past_a, past_b))
            if way > sure and way > math.sqrt(dx * dx + dy * dy) - sure:
                return False
    return True
