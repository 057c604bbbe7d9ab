"""What the springs do to the masses: forces on any topology, and accelerations.

With L the vector of a spring and perp(L) = (L.y, -L.x), a joint that holds springs A and B has a couple G
and, under a law with an energy, that energy U. Its force on the b end of its first spring is -dU/dA, which is
-G perp(A) / |A|² and a part along A; that on the b end of its second spring +G perp(B) / |B|² and a part
along B. With V the angle from A to B and r the rest angle, the laws are

- tutorial: G = K |A||B| sin(V - r), without the parts along the springs;
- conservative: the same G, U = K |A||B| (1 - cos(V - r)) = K (|A||B| - A . R(-r) B);
- angle: G = K |A||B| (V - r), U = K |A||B| (V - r)² / 2;

and none but the last needs more trigonometry than cos r and sin r, which are in the tables. Angular
damping adds C |A||B| dV/dt to G.

A spring that shrinks to a point would have a force that jumps there, and a body may want to stay just there.
So a length is sqrt(L² + softening), in the energies, too, with a softening far too small to be seen; none for
methods with a fixed step. A . R(-r) B is without it, and in the angle's law |L| becomes
L² / sqrt(L² + softening), since V means nothing at a point.

All of it is inlined into the tutorial's loop, and for the other methods into `any_accelerations`, so that
there is one call at most. Each hands over a hundred arrays, which takes longer than some of what is called,
and whether LLVM inlines by itself depends on what was compiled before.

Loops that gather through indices are kept apart from loops over the springs in order, so that the latter,
which hold the square root, the division and most of the arithmetic, are vectorised.
"""

from __future__ import annotations

import numpy as np

from .blocks import deflection
from .jit import FAST, kernel
from .lanes import eight_at_a_time, gather_as_it_pays, whole_eights
from .links import is_linked, linked_accelerations
from .roots import inverse_root
from .tables import ANGLE, CONSERVATIVE, TUTORIAL


@kernel(inline="always")
def internal_forces(softened, body, live, work, x, y, vx, vy):
    """Forces of all springs on all masses, into `work.fx` and `work.fy`.

    `softened` tells whether lengths are softened at all, for those who know when they are compiled.
    """
    lx, ly, dvx, dvy, inverse = work.lx, work.ly, work.dvx, work.dvy, work.inverse
    turn, draw, tx, ty, fx, fy = work.turn, work.draw, work.tx, work.ty, work.fx, work.fy
    couple, energy, dot, friction = work.couple, work.energy, work.dot, work.friction
    hold, brake = work.hold, work.brake
    stiffness, damping, pull = body.stiffness, body.damping, live.pull
    springs, soft = whole_eights(body.springs), body.softening  # padded
    none = stiffness.size  # stands for no spring; the chain's loops have other numbers there
    tx[none], ty[none] = 0.0, 0.0
    # Unsigned indices: numba otherwise tests each one for being negative.
    for s in range(body.springs):
        a, b = np.uint64(body.spring_a[s]), np.uint64(body.spring_b[s])
        lx[s] = x[b] - x[a]
        ly[s] = y[b] - y[a]
    if body.damped or body.twisted:
        for s in range(body.springs):
            a, b = np.uint64(body.spring_a[s]), np.uint64(body.spring_b[s])
            dvx[s] = vx[b] - vx[a]
            dvy[s] = vy[b] - vy[a]
    for s in range(springs):
        inverse[s] = inverse_root(lx[s] * lx[s] + ly[s] * ly[s] + soft)
    if body.joints:
        joint_couples(body, live, work)
        if body.law == CONSERVATIVE:
            for s in range(body.hinged):
                a, b = np.uint64(body.joint_in[s]), np.uint64(body.joint_out[s])
                turn[s], draw[s], hold[s] = couple[a] - couple[b], energy[a] + energy[b], dot[a] + dot[b]
            for i in range(body.more_joint.size):
                j, s = np.uint64(body.more_joint[i]), np.uint64(body.more_joint_spring[i])
                turn[s] += body.more_joint_sign[i] * couple[j]
                draw[s] += energy[j]
                hold[s] += dot[j]
        else:
            for s in range(body.hinged):
                turn[s] = couple[np.uint64(body.joint_in[s])] - couple[np.uint64(body.joint_out[s])]
            for i in range(body.more_joint.size):
                j, s = np.uint64(body.more_joint[i]), np.uint64(body.more_joint_spring[i])
                turn[s] += body.more_joint_sign[i] * couple[j]
        if body.law == ANGLE:
            for s in range(body.hinged):
                draw[s] = energy[np.uint64(body.joint_in[s])] + energy[np.uint64(body.joint_out[s])]
            for i in range(body.more_joint.size):
                draw[np.uint64(body.more_joint_spring[i])] += energy[np.uint64(body.more_joint[i])]
            for s in range(whole_eights(body.hinged)):
                square = lx[s] * lx[s] + ly[s] * ly[s]
                hold[s] = -draw[s] * (square + 2.0 * soft) * inverse[s] * inverse[s]
                draw[s] = 0.0
    if body.law == CONSERVATIVE or body.law == ANGLE:
        for s in range(springs):
            inv = inverse[s]
            inv2 = inv * inv
            true = inverse_root(lx[s] * lx[s] + ly[s] * ly[s]) if softened else inv
            true *= true
            rate = lx[s] * dvx[s] + ly[s] * dvy[s]
            along = pull[s] * inv - stiffness[s] - (damping[s] * rate + draw[s]) * inv2 + hold[s] * true
            across = turn[s] * true
            tx[s] = along * lx[s] + across * ly[s]
            ty[s] = along * ly[s] - across * lx[s]
        if body.twisted:
            for s in range(body.hinged):
                brake[s] = friction[np.uint64(body.joint_in[s])] - friction[np.uint64(body.joint_out[s])]
            for i in range(body.more_joint.size):
                j, s = np.uint64(body.more_joint[i]), np.uint64(body.more_joint_spring[i])
                brake[s] += body.more_joint_sign[i] * friction[j]
            for s in range(whole_eights(body.hinged)):
                across = brake[s] * inverse[s] * inverse[s]
                tx[s] += across * ly[s]
                ty[s] -= across * lx[s]
    elif body.joints and body.damped:
        for s in range(springs):
            inv = inverse[s]
            inv2 = inv * inv
            rate = lx[s] * dvx[s] + ly[s] * dvy[s]
            along = pull[s] * inv - stiffness[s] - damping[s] * rate * inv2
            across = turn[s] * inv2
            tx[s] = along * lx[s] + across * ly[s]
            ty[s] = along * ly[s] - across * lx[s]
    elif body.joints:
        for s in range(springs):
            inv = inverse[s]
            along = pull[s] * inv - stiffness[s]
            across = turn[s] * (inv * inv)
            tx[s] = along * lx[s] + across * ly[s]
            ty[s] = along * ly[s] - across * lx[s]
    elif body.damped:
        for s in range(springs):
            inv = inverse[s]
            rate = lx[s] * dvx[s] + ly[s] * dvy[s]
            along = pull[s] * inv - stiffness[s] - damping[s] * rate * (inv * inv)
            tx[s] = along * lx[s]
            ty[s] = along * ly[s]
    else:
        for s in range(springs):
            along = pull[s] * inverse[s] - stiffness[s]
            tx[s] = along * lx[s]
            ty[s] = along * ly[s]
    for i in range(1, body.masses + 1):
        a, b = np.uint64(body.spring_in[i]), np.uint64(body.spring_out[i])
        fx[i] = tx[a] - tx[b]
        fy[i] = ty[a] - ty[b]
    for layer in range(1, body.layers):
        below = layer * (body.masses + 1)
        more_in, more_out = body.spring_in[below:], body.spring_out[below:]
        for i in range(1, body.masses + 1):
            a, b = np.uint64(more_in[i]), np.uint64(more_out[i])
            fx[i] += tx[a] - tx[b]
            fy[i] += ty[a] - ty[b]
    for i in range(body.more_spring.size):
        m, s = np.uint64(body.more_spring_mass[i]), np.uint64(body.more_spring[i])
        sign = body.more_spring_sign[i]
        fx[m] += sign * tx[s]
        fy[m] += sign * ty[s]


@kernel(apart=True, forceinline=True, fastmath=FAST)
def spring_forces(body, live, work, x, y, vx, vy):
    """`internal_forces`, with sums in any order."""
    eight_at_a_time()
    gather_as_it_pays()
    internal_forces(True, body, live, work, x, y, vx, vy)


@kernel(forceinline=True)
def joint_couples(body, live, work):
    """The couple and, where the law has one, the energy of every joint, from the vectors in `work`."""
    lx, ly, inverse, couple, energy = work.lx, work.ly, work.inverse, work.couple, work.energy
    if body.law == TUTORIAL:
        for j in range(body.joints):
            a, b = np.uint64(body.joint_a[j]), np.uint64(body.joint_b[j])
            cross = lx[a] * ly[b] - ly[a] * lx[b]
            dot = lx[a] * lx[b] + ly[a] * ly[b]
            couple[j + 1] = live.couple_cos[j + 1] * cross - live.couple_sin[j + 1] * dot
    elif body.law == CONSERVATIVE:
        for j in range(body.joints):
            a, b = np.uint64(body.joint_a[j]), np.uint64(body.joint_b[j])
            cross = lx[a] * ly[b] - ly[a] * lx[b]
            dot = lx[a] * lx[b] + ly[a] * ly[b]
            cos, sin = live.couple_cos[j + 1], live.couple_sin[j + 1]
            couple[j + 1] = cos * cross - sin * dot
            energy[j + 1] = body.couple_size[j + 1] / (inverse[a] * inverse[b])
            work.dot[j + 1] = cos * dot + sin * cross
    else:
        for j in range(body.joints):
            a, b = np.uint64(body.joint_a[j]), np.uint64(body.joint_b[j])
            cross = lx[a] * ly[b] - ly[a] * lx[b]
            off = deflection(cross, lx[a] * lx[b] + ly[a] * ly[b], live.couple_rest[j + 1])
            weight = (lx[a] * lx[a] + ly[a] * ly[a]) * (lx[b] * lx[b] + ly[b] * ly[b])
            couple[j + 1] = body.couple_size[j + 1] * weight * (inverse[a] * inverse[b]) * off
            energy[j + 1] = 0.5 * couple[j + 1] * off
    if body.twisted:
        turning, friction = work.turning, work.friction
        for s in range(body.hinged):
            inv = inverse[s]
            turning[s] = (lx[s] * work.dvy[s] - ly[s] * work.dvx[s]) * (inv * inv)
        for j in range(body.joints):
            a, b = np.uint64(body.joint_a[j]), np.uint64(body.joint_b[j])
            rate = turning[b] - turning[a]
            friction[j + 1] = body.couple_damping[j + 1] / (inverse[a] * inverse[b]) * rate
        if body.law == TUTORIAL:
            for j in range(body.joints):
                couple[j + 1] += friction[j + 1]


@kernel(apart=True, forceinline=True, fastmath=FAST)
def accelerations(body, live, work, q, v, a):
    """Accelerations of all masses at positions q and velocities v; zero where a mass is held.

    q, v and a are flat: x of every place, then y of every place.
    """
    eight_at_a_time()
    places = q.size // 2
    x, y, vx, vy = q[:places], q[places:], v[:places], v[places:]
    # What most bodies need is compiled into each integrator, since a call costs more than a short chain.
    if is_linked(body):
        if body.ring:
            _close_ring(body.masses, q)
            _close_ring(body.masses, v)
        linked_accelerations(body, live, work, x, y, vx, vy, a[:places], a[places:])
        if body.ring:
            _open_ring(body.masses, q)
            _open_ring(body.masses, v)
    else:
        any_accelerations(body, live, work, x, y, vx, vy, a)


@kernel(forceinline=True)
def _close_ring(masses, flat):
    """Let the last mass of a ring stand before the first, and the first two behind the last."""
    for x in (0, flat.size // 2):
        behind = x + masses + 1
        flat[x], flat[behind], flat[behind + 1] = flat[behind - 1], flat[x + 1], flat[x + 2]


@kernel(forceinline=True)
def _open_ring(masses, flat):
    """Make those padding again: what is solved for, and how far off it is, is asked of all places alike."""
    for x in (0, flat.size // 2):
        behind = x + masses + 1
        flat[x] = flat[behind] = flat[behind + 1] = 0.0


@kernel(inner=True, fastmath=FAST)
def any_accelerations(body, live, work, x, y, vx, vy, a):
    """`accelerations` of any body, under any law."""
    eight_at_a_time()
    places = x.size
    spring_forces(body, live, work, x, y, vx, vy)
    fx, fy, ax, ay = work.fx, work.fy, a[:places], a[places:]
    w, air, gx, gy = live.inverse_mass, live.air, live.gx, live.gy
    for i in range(1, body.masses + 1):
        ax[i] = fx[i] * w[i] - air[i] * (vx[i] * abs(vx[i])) + gx[i]
    for i in range(1, body.masses + 1):
        ay[i] = fy[i] * w[i] - air[i] * (vy[i] * abs(vy[i])) + gy[i]
