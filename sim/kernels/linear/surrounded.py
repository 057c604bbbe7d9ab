"""The linear systems of implicit steps of a body in surroundings.

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
from .contact import add_contact, add_contact_damping, solve_with_contact
from .sparse import assemble, eliminate
from .vectors import add_multiple, dot


@kernel(fastmath=FAST)
def factorise_surrounded(body, state, matrix, q, v, a, g, definite):
    """`implicit.factorise_matrix` of a body in surroundings."""
    assemble(body, state, matrix, q, v, g, definite)
    _add_walls(body, state.inverse_mass, matrix, q, v, g, definite)
    _add_wind(body, state, matrix, q, v, g, definite)
    if body.surroundings.contact.present:
        add_contact(body, state, matrix, q, v, g, definite)
    if not definite:  # the turning of a pressure's direction is indefinite
        _add_pressures(body, matrix, q)
    regular = eliminate(body, state, matrix, v, a, g)
    return regular and _border(body, state, matrix, q)


@kernel(fastmath=FAST)
def solve_surrounded(body, matrix, b):
    """`implicit.solve_matrix` of a body in surroundings."""
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
def add_surrounding_damping(body, state, q, v, z, factor, out):
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
