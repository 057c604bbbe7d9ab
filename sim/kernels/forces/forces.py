"""Forces of springs and joints on any topology, and accelerations.

Let L be the vector of a spring and perp(L) = (L.y, -L.x). A joint that holds springs A and B has a torque G
and, under a law with an energy, the energy U. Its force on the b end of its first spring is -dU/dA, which is
-G perp(A) / |A|² and a part along A; that on the b end of its second spring +G perp(B) / |B|² and a part
along B. With V the angle from A to B and r the rest angle, the laws are

- tutorial: G = K |A||B| sin(V - r), without the parts along the springs;
- conservative: the same G, U = K |A||B| (1 - cos(V - r)) = K (|A||B| - A . R(-r) B);
- angle: G = K |A||B| (V - r), U = K |A||B| (V - r)² / 2;

and only the last needs trigonometric functions beyond cos r and sin r, which are in the tables. Angular
damping adds C |A||B| dV/dt to G.

The force of a spring that shrinks to a point would jump there, and a body may tend to exactly that point. So
the length of a spring is computed as sqrt(L² + softening), also in energies, with a softening far too small
to be seen and practically none for methods with a fixed step. A . R(-r) B is not softened, and in the angle
law |L| becomes L² / sqrt(L² + softening), since V is undefined at a point.

Loops that gather through indices are separate from loops over the springs in order, so that the latter, which
have the square root, the division and most of the arithmetic, are vectorised. Each loop is a function of its
own whose arrays share no memory, because LLVM would otherwise check for overlaps before every loop.
"""

from __future__ import annotations

import numpy as np

from ..around.contact import push_apart
from ..around.fillings import press_from_inside
from ..around.walls import push_from_walls
from ..around.wind import blow
from ..core.jit import FAST, kernel
from ..core.lanes import eight_at_a_time, scalar_gathers_on_amd, whole_eights
from ..core.roots import inverse_root
from ..core.vectors import deflection
from .chain import chain_accelerations, is_chain_like
from .laws import CONSERVATIVE, TUTORIAL, terms


@kernel(fastmath=FAST)
def spring_forces(body, state, scratch, x, y, vx, vy):
    """Forces of all springs and joints on all masses, into `scratch.fx` and `scratch.fy`."""
    scalar_gathers_on_amd()
    lx, ly, dvx, dvy, inverse = scratch.lx, scratch.ly, scratch.dvx, scratch.dvy, scratch.inverse
    springs, hinged = whole_eights(body.springs), body.hinged  # padded
    _differences(body.springs, body.spring_a, body.spring_b, x, y, lx, ly)
    if body.damped or body.joint_damped:
        _differences(body.springs, body.spring_a, body.spring_b, vx, vy, dvx, dvy)
    _inverse_lengths(springs, body.softening, lx, ly, inverse)
    if body.joints:
        _joint_torques(body, state, scratch, lx, ly, inverse, scratch.torque, scratch.energy, scratch.dot)
        _at_springs(body, scratch.torque, scratch.turn, -1.0)
        if body.law == CONSERVATIVE:
            _at_springs(body, scratch.energy, scratch.draw, 1.0)
            _at_springs(body, scratch.dot, scratch.hold, 1.0)
        elif body.law != TUTORIAL:
            _at_springs(body, scratch.energy, scratch.draw, 1.0)
            _hold_by_energy(whole_eights(hinged), body.softening, lx, ly, inverse, scratch.draw, scratch.hold)
    tx, ty = scratch.tx, scratch.ty
    if body.law != TUTORIAL and body.joints:
        _tensions_with_pull(
            springs, lx, ly, dvx, dvy, inverse, state.pull, body.stiffness, body.damping,
            scratch.turn, scratch.draw, scratch.hold, tx, ty,
        )  # fmt: skip
    else:
        _tensions(
            springs, lx, ly, dvx, dvy, inverse, state.pull, body.stiffness, body.damping, scratch.turn, tx, ty
        )
    if body.joint_damped:
        _joint_friction(body, lx, ly, dvx, dvy, inverse, scratch.turning, scratch.friction)
        _at_springs(body, scratch.friction, scratch.brake, -1.0)
        _add_across(whole_eights(hinged), lx, ly, inverse, scratch.brake, tx, ty)
    none = body.stiffness.size  # stands for no spring; the chain's loops leave other values there
    tx[none], ty[none] = 0.0, 0.0
    _at_masses(body, tx, ty, scratch.fx, scratch.fy)


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def _differences(springs, spring_a, spring_b, x, y, lx, ly):
    scalar_gathers_on_amd()
    # With unsigned indices numba omits its test for negative ones.
    for s in range(springs):
        a, b = np.uint64(spring_a[s]), np.uint64(spring_b[s])
        lx[s] = x[b] - x[a]
        ly[s] = y[b] - y[a]


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def _inverse_lengths(springs, soft, lx, ly, inverse):
    eight_at_a_time()
    for s in range(springs):
        inverse[s] = inverse_root(lx[s] * lx[s] + ly[s] * ly[s] + soft)


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def _joint_torques(body, state, scratch, lx, ly, inverse, torque, energy, dot):
    """The torque and, where the law has one, the energy of every joint, at index j + 1."""
    scalar_gathers_on_amd()
    joint_a, joint_b = body.joint_a, body.joint_b
    cosine, sine, size, rest = state.torque_cos, state.torque_sin, body.torque_size, state.torque_rest
    if body.law == TUTORIAL:
        for j in range(body.joints):
            a, b = np.uint64(joint_a[j]), np.uint64(joint_b[j])
            cross = lx[a] * ly[b] - ly[a] * lx[b]
            along = lx[a] * lx[b] + ly[a] * ly[b]
            torque[j + 1] = cosine[j + 1] * cross - sine[j + 1] * along
    elif body.law == CONSERVATIVE:
        for j in range(body.joints):
            a, b = np.uint64(joint_a[j]), np.uint64(joint_b[j])
            cross = lx[a] * ly[b] - ly[a] * lx[b]
            along = lx[a] * lx[b] + ly[a] * ly[b]
            torque[j + 1] = cosine[j + 1] * cross - sine[j + 1] * along
            energy[j + 1] = size[j + 1] / (inverse[a] * inverse[b])
            dot[j + 1] = cosine[j + 1] * along + sine[j + 1] * cross
    else:
        for j in range(body.joints):
            a, b = np.uint64(joint_a[j]), np.uint64(joint_b[j])
            cross = lx[a] * ly[b] - ly[a] * lx[b]
            off = deflection(cross, lx[a] * lx[b] + ly[a] * ly[b], rest[j + 1])
            torque_term, energy_term, _ = terms(body.law, off)
            weight = (lx[a] * lx[a] + ly[a] * ly[a]) * (lx[b] * lx[b] + ly[b] * ly[b])
            weight *= size[j + 1] * (inverse[a] * inverse[b])
            torque[j + 1] = weight * torque_term
            energy[j + 1] = weight * energy_term


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def _joint_friction(body, lx, ly, dvx, dvy, inverse, turning, friction):
    """The torque of every joint's damping."""
    scalar_gathers_on_amd()
    for s in range(body.hinged):
        turning[s] = (lx[s] * dvy[s] - ly[s] * dvx[s]) * (inverse[s] * inverse[s])
    for j in range(body.joints):
        a, b = np.uint64(body.joint_a[j]), np.uint64(body.joint_b[j])
        rate = turning[b] - turning[a]
        friction[j + 1] = body.torque_damping[j + 1] / (inverse[a] * inverse[b]) * rate


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def _at_springs(body, of_joint, of_spring, sign):
    """Sum a quantity of the joints at every spring, times `sign` where it is the first spring of a joint."""
    scalar_gathers_on_amd()
    joint_in, joint_out = body.joint_in, body.joint_out
    for s in range(body.hinged):
        of_spring[s] = of_joint[np.uint64(joint_in[s])] + sign * of_joint[np.uint64(joint_out[s])]
    for i in range(body.more_joint.size):
        j, s = np.uint64(body.more_joint[i]), np.uint64(body.more_joint_spring[i])
        of_spring[s] += (1.0 if body.more_joint_sign[i] > 0.0 else sign) * of_joint[j]


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def _hold_by_energy(springs, soft, lx, ly, inverse, draw, hold):
    eight_at_a_time()
    for s in range(springs):
        square = lx[s] * lx[s] + ly[s] * ly[s]
        hold[s] = -draw[s] * (square + 2.0 * soft) * inverse[s] * inverse[s]
        draw[s] = 0.0


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def _tensions_with_pull(
    springs, lx, ly, dvx, dvy, inverse, pull, stiffness, damping, turn, draw, hold, tx, ty
):  # fmt: skip
    """The force on the b end of every spring under a law with an energy, which also pulls along springs."""
    eight_at_a_time()
    for s in range(springs):
        inv2 = inverse[s] * inverse[s]
        true = inverse_root(lx[s] * lx[s] + ly[s] * ly[s])
        true *= true
        rate = lx[s] * dvx[s] + ly[s] * dvy[s]
        along = pull[s] * inverse[s] - stiffness[s] - (damping[s] * rate + draw[s]) * inv2 + hold[s] * true
        across = turn[s] * true
        tx[s] = along * lx[s] + across * ly[s]
        ty[s] = along * ly[s] - across * lx[s]


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def _tensions(springs, lx, ly, dvx, dvy, inverse, pull, stiffness, damping, turn, tx, ty):
    """The force on the b end of every spring under the tutorial's law, or without joints."""
    eight_at_a_time()
    for s in range(springs):
        inv2 = inverse[s] * inverse[s]
        rate = lx[s] * dvx[s] + ly[s] * dvy[s]
        along = pull[s] * inverse[s] - stiffness[s] - damping[s] * rate * inv2
        across = turn[s] * inv2
        tx[s] = along * lx[s] + across * ly[s]
        ty[s] = along * ly[s] - across * lx[s]


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def _add_across(springs, lx, ly, inverse, turn, tx, ty):
    eight_at_a_time()
    for s in range(springs):
        across = turn[s] * inverse[s] * inverse[s]
        tx[s] += across * ly[s]
        ty[s] -= across * lx[s]


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def _at_masses(body, tx, ty, fx, fy):
    """Sum the tensions of the springs at every mass."""
    scalar_gathers_on_amd()
    spring_in, spring_out = body.spring_in, body.spring_out
    for i in range(1, body.masses + 1):
        a, b = np.uint64(spring_in[i]), np.uint64(spring_out[i])
        fx[i] = tx[a] - tx[b]
        fy[i] = ty[a] - ty[b]
    for layer in range(1, body.layers):
        below = layer * (body.masses + 1)
        more_in, more_out = spring_in[below:], spring_out[below:]
        for i in range(1, body.masses + 1):
            a, b = np.uint64(more_in[i]), np.uint64(more_out[i])
            fx[i] += tx[a] - tx[b]
            fy[i] += ty[a] - ty[b]
    for i in range(body.more_spring.size):
        m, s = np.uint64(body.more_spring_mass[i]), np.uint64(body.more_spring[i])
        fx[m] += body.more_spring_sign[i] * tx[s]
        fy[m] += body.more_spring_sign[i] * ty[s]


@kernel(noalias=True, fastmath=FAST)
def accelerations(body, state, scratch, q, v, a):
    """Accelerations of all masses at positions q and velocities v; zero where a mass is held.

    q, v and a are flat: x of every slot, then y of every slot.
    """
    scalar_gathers_on_amd()
    eight_at_a_time()
    slots = q.size // 2
    x, y, vx, vy = q[:slots], q[slots:], v[:slots], v[slots:]
    if is_chain_like(body):
        if body.ring:
            _close_ring(body.masses, q)
            _close_ring(body.masses, v)
        chain_accelerations(body, state, scratch, x, y, vx, vy, a[:slots], a[slots:])
        if body.ring:
            _open_ring(body.masses, q)
            _open_ring(body.masses, v)
    else:
        any_accelerations(body, state, scratch, x, y, vx, vy, a)


@kernel(forceinline=True)
def _close_ring(masses, flat):
    """Copy the last mass of a ring to the slot before the first, and the first two to after the last."""
    for x in (0, flat.size // 2):
        behind = x + masses + 1
        flat[x], flat[behind], flat[behind + 1] = flat[behind - 1], flat[x + 1], flat[x + 2]


@kernel(forceinline=True)
def _open_ring(masses, flat):
    """Clear these copies again: error estimates and linear solvers look at all slots alike."""
    for x in (0, flat.size // 2):
        behind = x + masses + 1
        flat[x] = flat[behind] = flat[behind + 1] = 0.0


@kernel(internal=True, fastmath=FAST)
def any_accelerations(body, state, scratch, x, y, vx, vy, a):
    """`accelerations` of any body, under any law."""
    scalar_gathers_on_amd()
    eight_at_a_time()
    spring_forces(body, state, scratch, x, y, vx, vy)
    around = body.surroundings
    if around.present:
        press_from_inside(around, x, y, scratch.fx, scratch.fy)
        if around.contact.present:
            push_apart(body, state.inverse_mass, x, y, vx, vy, scratch.fx, scratch.fy)
    _from_forces(body, state, scratch, vx, vy, a)
    if around.present:
        ax, ay = a[: x.size], a[x.size :]
        push_from_walls(body, state.inverse_mass, x, y, vx, vy, ax, ay)
        if around.air_friction > 0.0:
            blow(body, state, scratch, x, y, vx, vy, ax, ay)


@kernel(noalias=True, forceinline=True, fastmath=FAST)
def _from_forces(body, state, scratch, vx, vy, a):
    """Accelerations by the forces in `scratch.fx` and `scratch.fy`, still air and gravity."""
    eight_at_a_time()
    slots = vx.size
    fx, fy, ax, ay = scratch.fx, scratch.fy, a[:slots], a[slots:]
    w, air, gx, gy = state.inverse_mass, state.air, state.gx, state.gy
    for i in range(1, body.masses + 1):
        ax[i] = fx[i] * w[i] - air[i] * (vx[i] * abs(vx[i])) + gx[i]
    for i in range(1, body.masses + 1):
        ay[i] = fy[i] * w[i] - air[i] * (vy[i] * abs(vy[i])) + gy[i]
