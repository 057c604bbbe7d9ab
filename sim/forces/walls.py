"""Walls: half planes, which push back the free masses that have entered them; see `push`.

With the point p and the unit normal n of a wall, a mass m at x is inside at the depth d = (p - x) . n where
that is positive. It is pushed along n with m H d² (1 + c s), with the hardness H, 1/(px s²), and the speed s
at which it enters, and slowed along the wall, t = (-n.y, n.x), by friction. A held mass is not pushed.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from ..kernels.core.tables import Body, State
from ..kernels.engine.jit import FAST, kernel
from ..kernels.engine.table import Rows, Table
from ..scene.surroundings import Wall
from ..scene.types import Scene
from .push import losses, push_and_friction, push_slopes, pushes_and_frictions, time_to_deepest
from .term import Floats, Term, Vectors, read_only

_QUICKLY = 4.0
"""Step length in time constants of friction from which it stops a mass within a fraction of the step."""


# ------------------------------------------------------------------------- rows, and how a scene gives them
class Walls(Table):
    """Read-only. W walls."""

    rows: Rows  # (W, 9), a `WallRow` each


class WallRow(NamedTuple):
    """A wall."""

    x: float  # px, a point of the surface
    y: float
    nx: float  # the unit vector to the free side
    ny: float
    hardness: float  # 1/(px s²)
    friction: float  # coefficient
    slip_speed: float  # px/s
    damping: float  # factor, s/px
    hysteresis: float  # part of the push


_NO_WALLS = read_only(Walls(rows=np.zeros((0, len(WallRow._fields)))))


def new_walls(scene: Scene) -> Walls:
    """The table of a valid scene."""
    if not scene.walls:
        return _NO_WALLS
    rows = np.array([_row(wall) for wall in scene.walls], float).reshape(-1, len(WallRow._fields))
    return read_only(Walls(rows=rows))


def _row(wall: Wall) -> WallRow:
    nx, ny = (part / math.hypot(*wall.normal) for part in wall.normal)
    lost = losses(wall.restitution, wall.bounciness)
    return WallRow(*wall.point, nx, ny, wall.hardness, wall.friction, wall.slip_speed, *lost)


@kernel(forceinline=True)
def _wall(body, k):
    """The k-th wall."""
    row = body.environment.walls.rows[k]
    return WallRow(row[0], row[1], row[2], row[3], row[4], row[5], row[6], row[7], row[8])


# ------------------------------------------------------------------------- force and energy
@kernel(forceinline=True, fastmath=FAST)
def _depth_in(wall, x, y):
    """How deep a point is inside a wall, px; negative outside."""
    return (wall.x - x) * wall.nx + (wall.y - y) * wall.ny


@kernel(forceinline=True, fastmath=FAST)
def _wall_push(wall, h, depth, vx, vy):
    """What a wall does to a mass of 1 kg inside it: (push, friction, elastic part of the push, speed along).

    Args:
        wall: the wall.
        h: `Environment.step`.
        depth: of the mass, px, positive.
        vx, vy: its velocity, px/s.
    """
    nx, ny = wall.nx, wall.ny
    along = vy * nx - vx * ny
    push, friction, elastic = push_and_friction(
        wall.hardness, wall.damping, wall.hysteresis, wall.friction, wall.slip_speed,
        h, 1.0, 1.0, depth, vx * nx + vy * ny, along,
    )  # fmt: skip
    return push, friction, elastic, along


@kernel(fastmath=FAST)
def _add_forces(body, state, scratch, q, v):
    environment, rows, slots = body.environment, body.environment.walls.rows, q.size // 2
    fx, fy, free = scratch.fx, scratch.fy, state.inverse_mass
    for k in range(rows.shape[0]):
        wall = _wall(body, k)
        for i in range(1, body.masses + 1):
            depth = _depth_in(wall, q[i], q[slots + i])
            if depth > 0.0 and free[i] > 0.0:
                push, friction, _, _ = _wall_push(wall, environment.step, depth, v[i], v[slots + i])
                fx[i] += environment.mass[i] * (push * wall.nx + friction * wall.ny)
                fy[i] += environment.mass[i] * (push * wall.ny - friction * wall.nx)


@kernel(fastmath=FAST)
def _energy(body, state, q):
    """The sum of m H d³ / 3."""
    environment, rows, slots, energy = body.environment, body.environment.walls.rows, q.size // 2, 0.0
    for k in range(rows.shape[0]):
        wall = _wall(body, k)
        for i in range(1, body.masses + 1):
            depth = _depth_in(wall, q[i], q[slots + i])
            if depth > 0.0 and state.inverse_mass[i] > 0.0:
                energy += environment.mass[i] * wall.hardness * depth * depth * depth / 3.0
    return energy


# ------------------------------------------------------------------------- the balance
@kernel(fastmath=FAST)
def _add_power(body, state, balance, q, v, part):
    """Friction, and what bouncing loses; friction on the masses of `mark_quick` is left out."""
    environment, rows, slots, power = body.environment, body.environment.walls.rows, q.size // 2, 0.0
    quick = balance.quick
    for k in range(rows.shape[0]):
        wall = _wall(body, k)
        for i in range(1, body.masses + 1):
            depth = _depth_in(wall, q[i], q[slots + i])
            if depth > 0.0 and state.inverse_mass[i] > 0.0:
                vx, vy = v[i], v[slots + i]
                push, friction, elastic, along = _wall_push(wall, environment.step, depth, vx, vy)
                rubbing = friction * along if quick.shape[0] == 0 or quick[k, i] == 0.0 else 0.0
                power += environment.mass[i] * ((push - elastic) * (vx * wall.nx + vy * wall.ny) - rubbing)
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
        wall = _wall(body, k)
        rate = h * wall.friction * wall.hardness / wall.slip_speed
        for i in range(quick.shape[1]):
            quick[k, i] = 0.0
        for i in range(1, body.masses + 1):
            depth = max(_depth_in(wall, q0[i], q0[slots + i]), _depth_in(wall, q1[i], q1[slots + i]))
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
        wall = _wall(body, k)
        for i in range(1, body.masses + 1):
            if quick[k, i] > 0.0:
                x, y, vx, vy = q[i], q[slots + i], v[i], v[slots + i]
                depth, along, friction = _depth_in(wall, x, y), vy * wall.nx - vx * wall.ny, 0.0
                if depth > 0.0:
                    _, friction, _, _ = _wall_push(wall, environment.step, depth, vx, vy)
                others = a[slots + i] * wall.nx - a[i] * wall.ny + friction
                quick[k, slots + i] += part * environment.mass[i] * others * along


@kernel(fastmath=FAST)
def work_of_quick(body, v0, v1, h, quick):
    """The work of friction on the masses of `mark_quick` in a step, which is negative, kg px²/s²."""
    environment, rows, slots, work = body.environment, body.environment.walls.rows, v0.size // 2, 0.0
    for k in range(rows.shape[0]):
        wall = _wall(body, k)
        for i in range(1, body.masses + 1):
            if quick[k, i] > 0.0:
                first = v0[slots + i] * wall.nx - v0[i] * wall.ny
                last = v1[slots + i] * wall.nx - v1[i] * wall.ny
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
    nx, ny = wall.nx, wall.ny
    friction, slip_speed = wall.friction, wall.slip_speed
    push, _, _, along = _wall_push(wall, 0.0, depth, vx, vy)
    held = math.tanh(along / slip_speed)
    drag = friction * push * (1.0 - held * held) / slip_speed
    by_depth, by_speed = push_slopes(
        wall.hardness, wall.damping, wall.hysteresis, slip_speed, depth, vx * nx + vy * ny
    )
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
        wall = _wall(body, k)
        for i in range(body.masses):
            m = matrix.order[i]
            depth = _depth_in(wall, q[m], q[slots + m])
            if depth > 0.0 and state.inverse_mass[m] > 0.0:
                by_q, by_v = _wall_derivatives(wall, depth, v[m], v[slots + m], definite)
                d = 4 * matrix.diagonal[i]
                for e in range(4):
                    matrix.blocks[d + e] += mass[m] * (by_q[e] + g * by_v[e])


@kernel(fastmath=FAST)
def _add_damping(body, state, q, v, z, factor, out):
    rows, mass, w, slots = body.environment.walls.rows, body.environment.mass, state.inverse_mass, q.size // 2
    for k in range(rows.shape[0]):
        wall = _wall(body, k)
        for m in range(1, body.masses + 1):
            depth = _depth_in(wall, q[m], q[slots + m])
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
        wall = _wall(body, k)
        nx, ny, hardness = wall.nx, wall.ny, wall.hardness
        for i in range(1, body.masses + 1):
            if state.inverse_mass[i] > 0.0:
                depth = _depth_in(wall, q[i], q[slots + i])
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
        for wall, depth, normal in self._depths(x):
            speed = v * normal.conjugate()  # real part: outwards, imaginary part: along the wall
            push, rubbing = pushes_and_frictions(
                wall.hardness, wall.damping, wall.hysteresis, wall.friction, wall.slip_speed,
                self._step, 1.0, 1.0, depth, speed,
            )  # fmt: skip
            total += self._mass * (push - 1j * rubbing) * normal
        return total

    def energy(self, x: Vectors) -> float:
        """See `Twin`; that of free masses."""
        mass = np.where(self._state.inverse_mass > 0.0, self._mass, 0.0)
        return sum(float((mass * wall.hardness * depth**3).sum()) / 3.0 for wall, depth, _ in self._depths(x))

    def _depths(self, x: Vectors) -> Iterator[tuple[WallRow, Floats, complex]]:
        """Each wall, how deep each mass is in it, px, or 0, and its normal."""
        for row in self._rows:
            wall = WallRow(*row)
            normal = complex(wall.nx, wall.ny)
            depth = ((complex(wall.x, wall.y) - x) * normal.conjugate()).real
            yield wall, np.maximum(depth, 0.0), normal


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
