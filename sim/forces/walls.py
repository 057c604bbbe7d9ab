"""Walls: half planes, which push back the free masses that have entered them; see `push`.

With the point p and the unit normal n of a wall, a mass m at x is inside at the depth d = (p - x) . n where
that is positive. It is pushed along n with m H d² (1 + c s), with the hardness H, 1/(px s²), and the speed s
at which it enters, and slowed along the wall, t = (-n.y, n.x), by friction. A held mass is not pushed.
"""

from __future__ import annotations

import math

import numpy as np

from ..kernels.core.tables import Body, State
from ..kernels.engine.jit import FAST, kernel
from ..kernels.engine.table import Rows, Table
from ..scene.surroundings import Wall
from ..scene.types import Scene
from .push import damping_factor, push_and_friction, push_slopes, pushes_and_frictions, time_to_deepest
from .term import Floats, Term, Vectors, read_only

_QUICKLY = 4.0
"""Step length in time constants of friction from which it stops a mass within a fraction of the step."""


# ------------------------------------------------------------------------- rows, and how a scene gives them
class Walls(Table):
    """Read-only. W walls."""

    rows: Rows  # (W, 8), see the WALL_ constants


WALL_X, WALL_Y, WALL_NORMAL_X, WALL_NORMAL_Y = 0, 1, 2, 3
"""In a row: a point of the surface, px, and the unit vector to the free side."""
WALL_HARDNESS, WALL_FRICTION, WALL_SLIP, WALL_DAMPING = 4, 5, 6, 7
"""In a row: hardness, 1/(px s²), coefficient of friction, slip speed, px/s, and damping factor, s/px."""
WALL_ROW = 8
"""Length of a row."""


def new_walls(scene: Scene) -> Walls:
    """The table of a valid scene."""
    return read_only(Walls(rows=np.array([_row(wall) for wall in scene.walls], float).reshape(-1, WALL_ROW)))


def _row(wall: Wall) -> list[float]:
    size = math.hypot(*wall.normal)
    normal = [part / size for part in wall.normal]
    damping = damping_factor(wall.bounciness)
    return [*wall.point, *normal, wall.hardness, wall.friction, wall.slip_speed, damping]


# ------------------------------------------------------------------------- force and energy
@kernel(forceinline=True, fastmath=FAST)
def depth_in(wall, x, y):
    """How deep a point is inside a wall, px; negative outside."""
    return (wall[WALL_X] - x) * wall[WALL_NORMAL_X] + (wall[WALL_Y] - y) * wall[WALL_NORMAL_Y]


@kernel(forceinline=True, fastmath=FAST)
def _wall_push(wall, h, depth, vx, vy):
    """What a wall does to a mass of 1 kg inside it: (push, friction, elastic part of the push, speed along).

    Args:
        wall: a row.
        h: `Environment.step`.
        depth: of the mass, px, positive.
        vx, vy: its velocity, px/s.
    """
    nx, ny = wall[WALL_NORMAL_X], wall[WALL_NORMAL_Y]
    along = vy * nx - vx * ny
    push, friction, elastic = push_and_friction(
        wall[WALL_HARDNESS], wall[WALL_DAMPING], wall[WALL_FRICTION], wall[WALL_SLIP],
        h, 1.0, 1.0, depth, vx * nx + vy * ny, along,
    )  # fmt: skip
    return push, friction, elastic, along


@kernel(fastmath=FAST)
def _add_forces(body, state, scratch, q, v):
    environment, rows, slots = body.environment, body.environment.walls.rows, q.size // 2
    fx, fy, free = scratch.fx, scratch.fy, state.inverse_mass
    for k in range(rows.shape[0]):
        wall = rows[k]
        nx, ny = wall[WALL_NORMAL_X], wall[WALL_NORMAL_Y]
        for i in range(1, body.masses + 1):
            depth = depth_in(wall, q[i], q[slots + i])
            if depth > 0.0 and free[i] > 0.0:
                push, friction, _, _ = _wall_push(wall, environment.step, depth, v[i], v[slots + i])
                fx[i] += environment.mass[i] * (push * nx + friction * ny)
                fy[i] += environment.mass[i] * (push * ny - friction * nx)


@kernel(fastmath=FAST)
def _energy(body, state, q):
    """The sum of m H d³ / 3."""
    environment, rows, slots, energy = body.environment, body.environment.walls.rows, q.size // 2, 0.0
    for k in range(rows.shape[0]):
        wall = rows[k]
        for i in range(1, body.masses + 1):
            depth = depth_in(wall, q[i], q[slots + i])
            if depth > 0.0 and state.inverse_mass[i] > 0.0:
                energy += environment.mass[i] * wall[WALL_HARDNESS] * depth * depth * depth / 3.0
    return energy


# ------------------------------------------------------------------------- the balance
@kernel(fastmath=FAST)
def _add_power(body, state, balance, q, v, part):
    """Friction, and what bouncing loses; friction on the masses of `mark_quick` is left out."""
    environment, rows, slots, power = body.environment, body.environment.walls.rows, q.size // 2, 0.0
    quick = balance.quick
    for k in range(rows.shape[0]):
        wall = rows[k]
        nx, ny = wall[WALL_NORMAL_X], wall[WALL_NORMAL_Y]
        for i in range(1, body.masses + 1):
            depth = depth_in(wall, q[i], q[slots + i])
            if depth > 0.0 and state.inverse_mass[i] > 0.0:
                vx, vy = v[i], v[slots + i]
                push, friction, elastic, along = _wall_push(wall, environment.step, depth, vx, vy)
                rubbing = friction * along if quick.shape[0] == 0 or quick[k, i] == 0.0 else 0.0
                power += environment.mass[i] * ((push - elastic) * (vx * nx + vy * ny) - rubbing)
    balance.work.walls += part * power


@kernel(fastmath=FAST)
def mark_quick(body, inverse_mass, q0, q1, h, quick):
    """Whether friction on a wall would stop any mass within a fraction of a step of h seconds.

    Where it does, the speeds of a step have errors that the tolerance allows, but friction in proportion to
    them would seem to take many times the energy that there is. So its work is found from the change of the
    kinetic energy along the wall and the work of all other forces there, which goes by the way that is made.

    Args:
        q0, q1: flat positions at both ends of the step.
        quick: (W, 2 slots) in its first half, 1 for each such mass; cleared otherwise.
    """
    rows, slots, found = body.environment.walls.rows, q0.size // 2, False
    for k in range(rows.shape[0]):
        wall = rows[k]
        rate = h * wall[WALL_FRICTION] * wall[WALL_HARDNESS] / wall[WALL_SLIP]
        for i in range(quick.shape[1]):
            quick[k, i] = 0.0
        for i in range(1, body.masses + 1):
            depth = max(depth_in(wall, q0[i], q0[slots + i]), depth_in(wall, q1[i], q1[slots + i]))
            if depth > 0.0 and inverse_mass[i] > 0.0 and rate * depth * depth > _QUICKLY:
                quick[k, i], found = 1.0, True
    return found


@kernel(fastmath=FAST)
def gather_others(body, q, v, a, part, quick):
    """Add, weighted by `part`, the power along each wall of all forces but its friction, kg px²/s³.

    Args:
        q, v, a: flat positions, velocities and accelerations.
        part: of the step.
        quick: of `mark_quick`; the powers are in its second half.
    """
    environment, rows, slots = body.environment, body.environment.walls.rows, q.size // 2
    for k in range(rows.shape[0]):
        wall = rows[k]
        nx, ny = wall[WALL_NORMAL_X], wall[WALL_NORMAL_Y]
        for i in range(1, body.masses + 1):
            if quick[k, i] > 0.0:
                x, y, vx, vy = q[i], q[slots + i], v[i], v[slots + i]
                depth, along, friction = depth_in(wall, x, y), vy * nx - vx * ny, 0.0
                if depth > 0.0:
                    _, friction, _, _ = _wall_push(wall, environment.step, depth, vx, vy)
                others = a[slots + i] * nx - a[i] * ny + friction
                quick[k, slots + i] += part * environment.mass[i] * others * along


@kernel(fastmath=FAST)
def work_of_quick(body, v0, v1, h, quick):
    """The work of friction on the masses of `mark_quick` in a step, which is negative, kg px²/s²."""
    environment, rows, slots, work = body.environment, body.environment.walls.rows, v0.size // 2, 0.0
    for k in range(rows.shape[0]):
        wall = rows[k]
        nx, ny = wall[WALL_NORMAL_X], wall[WALL_NORMAL_Y]
        for i in range(1, body.masses + 1):
            if quick[k, i] > 0.0:
                first = v0[slots + i] * nx - v0[i] * ny
                last = v1[slots + i] * nx - v1[i] * ny
                kinetic = 0.5 * environment.mass[i] * (last * last - first * first)
                work += kinetic - h * quick[k, slots + i]
    return work


# ------------------------------------------------------------------------- derivatives
@kernel(fastmath=FAST)
def _wall_derivatives(wall, depth, vx, vy, definite):
    """The derivatives of a wall's acceleration f of a mass inside it: two blocks, 1/s² and 1/s.

    With the push N(d, s), the normal n, t = (-n.y, n.x), the speeds s = v . n outwards and u = v . t along,
    the friction coefficient mu and the slip speed w, f = N (n - mu tanh(u/w) t). With d' = -n by position,

        df/dx = -dN/dd (n - mu tanh(u/w) t) nᵀ,
        df/dv = dN/ds (n - mu tanh(u/w) t) nᵀ - mu N (1 - tanh²(u/w)) / w t tᵀ.

    The push is that without the softening for explicit methods, which use no derivatives. With `definite`,
    friction along t, which is not symmetric, is left out of the first factors.
    """
    nx, ny = wall[WALL_NORMAL_X], wall[WALL_NORMAL_Y]
    friction, slip_speed = wall[WALL_FRICTION], wall[WALL_SLIP]
    push, _, _, along = _wall_push(wall, 0.0, depth, vx, vy)
    held = math.tanh(along / slip_speed)
    drag = friction * push * (1.0 - held * held) / slip_speed
    by_depth, by_speed = push_slopes(wall[WALL_HARDNESS], wall[WALL_DAMPING], depth, vx * nx + vy * ny)
    fx, fy = nx + friction * held * ny, ny - friction * held * nx
    if definite:
        fx, fy = nx, ny
    by_position = (-by_depth * fx * nx, -by_depth * fx * ny, -by_depth * fy * nx, -by_depth * fy * ny)
    by_velocity = (
        by_speed * fx * nx - drag * ny * ny,
        by_speed * fx * ny + drag * ny * nx,
        by_speed * fy * nx + drag * nx * ny,
        by_speed * fy * ny - drag * nx * nx,
    )
    return by_position, by_velocity


@kernel(fastmath=FAST)
def _add_derivatives(body, state, matrix, q, v, g, definite):
    rows, mass, slots = body.environment.walls.rows, body.environment.mass, q.size // 2
    for k in range(rows.shape[0]):
        wall = rows[k]
        for i in range(body.masses):
            m = matrix.order[i]
            depth = depth_in(wall, q[m], q[slots + m])
            if depth > 0.0 and state.inverse_mass[m] > 0.0:
                by_q, by_v = _wall_derivatives(wall, depth, v[m], v[slots + m], definite)
                d = 4 * matrix.diagonal[i]
                for e in range(4):
                    matrix.blocks[d + e] += mass[m] * (by_q[e] + g * by_v[e])


@kernel(fastmath=FAST)
def _add_damping(body, state, q, v, z, factor, out):
    rows, mass, w, slots = body.environment.walls.rows, body.environment.mass, state.inverse_mass, q.size // 2
    for k in range(rows.shape[0]):
        wall = rows[k]
        for m in range(1, body.masses + 1):
            depth = depth_in(wall, q[m], q[slots + m])
            if depth > 0.0 and w[m] > 0.0:
                _, block = _wall_derivatives(wall, depth, v[m], v[slots + m], False)
                share = factor * w[m] * mass[m]
                out[m] += share * (block[0] * z[m] + block[1] * z[slots + m])
                out[slots + m] += share * (block[2] * z[m] + block[3] * z[slots + m])


# ------------------------------------------------------------------------- what it asks of a step
@kernel(fastmath=FAST)
def _impact_time(body, state, q, v, a, h):
    rows, slots, shortest = body.environment.walls.rows, q.size // 2, math.inf
    for k in range(rows.shape[0]):
        wall = rows[k]
        nx, ny, hardness = wall[WALL_NORMAL_X], wall[WALL_NORMAL_Y], wall[WALL_HARDNESS]
        for i in range(1, body.masses + 1):
            if state.inverse_mass[i] > 0.0:
                depth = depth_in(wall, q[i], q[slots + i])
                speed, outwards = nx * v[i] + ny * v[slots + i], nx * a[i] + ny * a[slots + i]
                shortest = min(shortest, time_to_deepest(hardness, depth, speed, outwards, h))
    return shortest


# ------------------------------------------------------------------------- in NumPy
class WallsTwin:
    """Walls in NumPy; see `Twin`. For a unit vector n, conj(n) v has the parts of v along n and across it."""

    def __init__(self, body: Body, state: State) -> None:
        self._rows, self._step = body.environment.walls.rows, body.environment.step
        self._mass, self._state = body.environment.mass, state

    def forces(self, x: Vectors, v: Vectors) -> Vectors:
        """See `Twin`; also on masses that are held."""
        total = np.zeros_like(x)
        for row, depth, normal in self._depths(x):
            _, _, _, _, hardness, friction, slip_speed, damping = row
            speed = v * normal.conjugate()  # real part: outwards, imaginary part: along the wall
            push, rubbing = pushes_and_frictions(
                hardness, damping, friction, slip_speed, self._step, 1.0, 1.0, depth, speed
            )
            total += self._mass * (push - 1j * rubbing) * normal
        return total

    def energy(self, x: Vectors) -> float:
        """See `Twin`; that of free masses."""
        mass = np.where(self._state.inverse_mass > 0.0, self._mass, 0.0)
        return sum(
            float((mass * row[WALL_HARDNESS] * depth**3).sum()) / 3.0 for row, depth, _ in self._depths(x)
        )

    def _depths(self, x: Vectors) -> list[tuple[Floats, Floats, complex]]:
        """Of each wall its row, how deep each mass is in it, px, or 0, and its normal."""
        normals = [complex(row[WALL_NORMAL_X], row[WALL_NORMAL_Y]) for row in self._rows]
        return [
            (row, np.maximum(((complex(row[WALL_X], row[WALL_Y]) - x) * n.conjugate()).real, 0.0), n)
            for row, n in zip(self._rows, normals, strict=True)
        ]


WALLS = Term(
    "walls",
    WallsTwin,
    _add_forces,
    energy=_energy,
    label="depth in walls",
    add_power=_add_power,
    add_derivatives=_add_derivatives,
    add_damping=_add_damping,
    impact_time=_impact_time,
)
