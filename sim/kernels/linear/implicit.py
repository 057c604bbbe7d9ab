"""The linear systems of implicit steps: a I - g Jv - Jx, factorised and solved, and the product with Jv.

Jx and Jv are the derivatives of the accelerations by positions, 1/s², and by velocities, 1/s. Velocities are
eliminated from the systems, so there are two unknowns a mass.

Walls and wind add to the blocks on the diagonal. The pressure of a filling adds to those of neighbours around
its loop, and, since it depends on the area, a product of two vectors: with c, minus the derivative of the
pressure by the area, and the area's gradient g, the matrix gets c M^-1 g gᵀ. That is full, so it is not
stored. The sparse part is factorised without it, and the Sherman-Morrison-Woodbury formula corrects each
solution. Contact is in `contact`.
"""

from __future__ import annotations

from ..around.fillings import area_of, neighbours, pressure_at
from ..around.walls import depth_in, derivatives_at_wall
from ..around.wind import wind_at
from ..core.jit import FAST, kernel
from ..core.vectors import from_to, inverse_of
from .contact import add_contact, add_contact_damping, solve_with_contact
from .sparse import assemble, eliminate
from .vectors import add_multiple, dot


@kernel(fastmath=FAST)
def factorise_matrix(body, state, matrix, q, v, a, g, definite):
    """Build and factorise a I - g Jv - Jx at positions q and velocities v.

    With `definite`, terms that could make the matrix indefinite are left out.

    Returns:
        Whether all pivots are regular.
    """
    assemble(body, state, matrix, q, v, g, definite)
    if body.surroundings.present:
        _add_walls(body, state.inverse_mass, matrix, q, v, g, definite)
        _add_wind(body, state, matrix, q, v, g, definite)
        if body.surroundings.contact.present:
            add_contact(body, state, matrix, q, v, g, definite)
        if not definite:  # the turning of a pressure's direction is indefinite
            _add_pressures(body, matrix, q)
    regular = eliminate(body, state, matrix, v, a, g)
    return regular and _border(body, state, matrix, q)


@kernel(fastmath=FAST)
def solve_matrix(body, matrix, b):
    """Solve with the last factors, in place; b is a flat vector, x of every slot, then y."""
    solve_with_contact(body, matrix, b)
    fillings = body.surroundings.fillings.shape[0]
    for k in range(fillings):
        matrix.corrections[fillings, k] = dot(body.masses, matrix.borders[k], b)
    for k in range(fillings):
        part = 0.0
        for i in range(fillings):
            part += matrix.corrections[k, i] * matrix.corrections[fillings, i]
        add_multiple(body.masses, -part, matrix.borders[fillings + k], b)


@kernel(fastmath=FAST)
def add_damping_product(body, state, q, v, z, factor, out):
    """out += factor Jv z, with Jv at positions q and velocities v; all vectors are flat."""
    slots, w, air = z.size // 2, state.inverse_mass, state.air
    if body.damped:
        _add_spring_damping(body, w, q, z, factor, out)
    if body.joint_damped:
        _add_joint_damping(body, w, q, z, factor, out)
    for i in range(1, body.masses + 1):
        out[i] -= factor * 2.0 * air[i] * abs(v[i]) * z[i]
        out[slots + i] -= factor * 2.0 * air[i] * abs(v[slots + i]) * z[slots + i]
    if body.surroundings.present:
        _add_surrounding_damping(body, state, q, v, z, factor, out)


@kernel(fastmath=FAST)
def _add_spring_damping(body, w, q, z, factor, out):
    """A damper's force on its b end is -c u (u . L'), with the unit vector u and the rate L' of a spring."""
    slots = z.size // 2
    for s in range(body.springs):
        a, b = body.spring_a[s], body.spring_b[s]
        (x, y), (zx, zy) = from_to(q, a, b), from_to(z, a, b)
        inverse = inverse_of(x, y, body.softening)
        along = -factor * body.damping[s] * (x * zx + y * zy) * (inverse * inverse)
        out[b] += w[b] * along * x
        out[slots + b] += w[b] * along * y
        out[a] -= w[a] * along * x
        out[slots + a] -= w[a] * along * y


@kernel(fastmath=FAST)
def _add_joint_damping(body, w, q, z, factor, out):
    """A joint's damper has the torque -C |A||B| V', where V' is the rate of the angle from A to B.

    A spring with the vector L and the rate L' turns at (L x L') / |L|². A torque T turns it by the force
    T (-L.y, L.x) / |L|² on its b end.
    """
    slots = z.size // 2
    for j in range(body.joints):
        s, r = body.joint_a[j], body.joint_b[j]
        a0, a1, b0, b1 = body.spring_a[s], body.spring_b[s], body.spring_a[r], body.spring_b[r]
        (ax, ay), (bx, by) = from_to(q, a0, a1), from_to(q, b0, b1)
        (zax, zay), (zbx, zby) = from_to(z, a0, a1), from_to(z, b0, b1)
        inv_a, inv_b = inverse_of(ax, ay, body.softening), inverse_of(bx, by, body.softening)
        per_a, per_b = inv_a * inv_a, inv_b * inv_b
        rate = (bx * zby - by * zbx) * per_b - (ax * zay - ay * zax) * per_a
        torque = factor * body.torque_damping[j + 1] * rate / (inv_a * inv_b)
        for one, other, x, y in (
            (a0, a1, torque * per_a * ax, torque * per_a * ay),
            (b0, b1, -torque * per_b * bx, -torque * per_b * by),
        ):
            out[other] -= w[other] * y
            out[slots + other] += w[other] * x
            out[one] += w[one] * y
            out[slots + one] -= w[one] * x


@kernel(fastmath=FAST)
def _add_surrounding_damping(body, state, q, v, z, factor, out):
    """out += factor Jv z, with the part of Jv that surroundings add at positions q and velocities v."""
    around, w, slots = body.surroundings, state.inverse_mass, q.size // 2
    for k in range(around.walls.shape[0]):
        wall = around.walls[k]
        for m in range(1, body.masses + 1):
            depth = depth_in(wall, q[m], q[slots + m])
            if depth > 0.0 and w[m] > 0.0:
                _, block = derivatives_at_wall(wall, depth, v[m], v[slots + m], False)
                share = factor * w[m] * around.mass[m]
                out[m] += share * (block[0] * z[m] + block[1] * z[slots + m])
                out[slots + m] += share * (block[2] * z[m] + block[3] * z[slots + m])
    if around.air_friction > 0.0:
        for m in range(1, body.masses + 1):
            ux, uy, _, _, _, _ = wind_at(around, state.clock[0], q[m], q[slots + m])
            drag = 2.0 * factor * around.air_friction * w[m]
            out[m] -= drag * abs(v[m] - ux) * z[m]
            out[slots + m] -= drag * abs(v[slots + m] - uy) * z[slots + m]
    if around.contact.present:
        add_contact_damping(body, w, q, v, z, factor, out)


@kernel(fastmath=FAST)
def _add_walls(body, inverse_mass, matrix, q, v, g, definite):
    around, blocks, slots = body.surroundings, matrix.blocks, q.size // 2
    for k in range(around.walls.shape[0]):
        wall = around.walls[k]
        for i in range(body.masses):
            m = matrix.order[i]
            depth = depth_in(wall, q[m], q[slots + m])
            if depth > 0.0 and inverse_mass[m] > 0.0:
                by_q, by_v = derivatives_at_wall(wall, depth, v[m], v[slots + m], definite)
                mass, d = around.mass[m], 4 * matrix.diagonal[i]
                for e in range(4):
                    blocks[d + e] += mass * (by_q[e] + g * by_v[e])


@kernel(fastmath=FAST)
def _add_wind(body, state, matrix, q, v, g, definite):
    around, blocks, slots = body.surroundings, matrix.blocks, q.size // 2
    if around.air_friction > 0.0:
        for i in range(body.masses):
            m, d = matrix.order[i], 4 * matrix.diagonal[i]
            ux, uy, xx, xy, yx, yy = wind_at(around, state.clock[0], q[m], q[slots + m])
            drag_x = 2.0 * around.air_friction * abs(v[m] - ux)
            drag_y = 2.0 * around.air_friction * abs(v[slots + m] - uy)
            blocks[d] -= g * drag_x
            blocks[d + 3] -= g * drag_y
            if not definite:
                blocks[d] += drag_x * xx
                blocks[d + 1] += drag_x * xy
                blocks[d + 2] += drag_y * yx
                blocks[d + 3] += drag_y * yy


@kernel(fastmath=FAST)
def _add_pressures(body, matrix, q):
    """What the turning of the pressures' directions adds, at the rows of each mass and its neighbours."""
    around, blocks, slots = body.surroundings, matrix.blocks, q.size // 2
    for k in range(around.fillings.shape[0]):
        pressure, _ = pressure_at(around.fillings[k], area_of(around, k, q[:slots], q[slots:]))
        for i in range(around.loop_start[k], around.loop_start[k + 1]):
            before, after = 4 * matrix.loop_target[2 * i], 4 * matrix.loop_target[2 * i + 1]
            blocks[after + 1] += 0.5 * pressure
            blocks[after + 2] -= 0.5 * pressure
            blocks[before + 1] -= 0.5 * pressure
            blocks[before + 2] += 0.5 * pressure


@kernel(fastmath=FAST)
def _border(body, state, matrix, q):
    """Prepare the correction for the products of gradients; whether its own small matrix is regular.

    `borders` gets the gradients g, and then c A^-1 M^-1 g with the factorised sparse part A; `corrections`
    the inverse of I + gᵀ c A^-1 M^-1 g.
    """
    around, w, slots = body.surroundings, state.inverse_mass, q.size // 2
    borders, small, count = matrix.borders, matrix.corrections, body.surroundings.fillings.shape[0]
    x, y = q[:slots], q[slots:]
    for k in range(count):
        gradient, solved = borders[k], borders[count + k]
        for j in range(q.size):
            gradient[j], solved[j] = 0.0, 0.0
        _, slope = pressure_at(around.fillings[k], area_of(around, k, x, y))
        for i in range(around.loop_start[k], around.loop_start[k + 1]):
            m = around.loop[i]
            before, after = neighbours(around, k, i)
            gradient[m] += 0.5 * (y[after] - y[before])
            gradient[slots + m] += 0.5 * (x[before] - x[after])
        for i in range(around.loop_start[k], around.loop_start[k + 1]):
            m = around.loop[i]
            solved[m] = -slope * w[m] * gradient[m]
            solved[slots + m] = -slope * w[m] * gradient[slots + m]
        solve_with_contact(body, matrix, solved)
    for i in range(count):
        for k in range(count):
            small[i, k] = dot(body.masses, borders[i], borders[count + k]) + (1.0 if i == k else 0.0)
    return _invert(small, count)


@kernel(fastmath=FAST)
def _invert(a, n):
    """Invert the first n rows and columns in place (Gauss-Jordan, no pivoting); whether it is regular.

    Without springs the matrix is I plus a positive semidefinite one, for which pivoting is not needed.
    """
    regular = True
    for p in range(n):
        pivot = 1.0 / a[p, p]
        if not abs(pivot) < 1e12:
            regular = False
        a[p, p] = 1.0
        for k in range(n):
            a[p, k] *= pivot
        for i in range(n):
            if i != p:
                factor = a[i, p]
                a[i, p] = 0.0
                for k in range(n):
                    a[i, k] -= factor * a[p, k]
    return regular
