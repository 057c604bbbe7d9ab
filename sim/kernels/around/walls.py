"""Walls, which push back the masses that have entered them, see `bounce`.

A mass m that has entered with the depth d is pushed out with m H d², with the hardness H.
"""

from __future__ import annotations

import math

from ..core.jit import FAST, kernel
from ..core.surroundings import (
    WALL_FRICTION,
    WALL_HARDNESS,
    WALL_LOSS,
    WALL_NORMAL_X,
    WALL_NORMAL_Y,
    WALL_SLIP,
    WALL_X,
    WALL_Y,
)
from .bounce import push_and_friction, slopes_of_push, time_to_deepest

_QUICKLY = 4.0
"""Step length in time constants of friction from which it stops a mass within a fraction of the step."""


@kernel(forceinline=True, fastmath=FAST)
def depth_in(wall, x, y):
    """How deep a point is inside a wall, px; negative outside."""
    return (wall[WALL_X] - x) * wall[WALL_NORMAL_X] + (wall[WALL_Y] - y) * wall[WALL_NORMAL_Y]


@kernel(forceinline=True, fastmath=FAST)
def wall_terms(wall, h, depth, vx, vy):
    """What a wall does to a mass of 1 kg inside it: (push, friction, elastic part of the push, speed along).

    Args:
        wall: a row of `Surroundings.walls`.
        h: `Surroundings.step`.
        depth: of the mass, px, positive.
        vx, vy: its velocity, px/s.
    """
    nx, ny = wall[WALL_NORMAL_X], wall[WALL_NORMAL_Y]
    along = vy * nx - vx * ny
    push, friction, elastic = push_and_friction(
        wall[WALL_HARDNESS], wall[WALL_LOSS], wall[WALL_FRICTION], wall[WALL_SLIP],
        h, 1.0, 1.0, depth, vx * nx + vy * ny, along,
    )  # fmt: skip
    return push, friction, elastic, along


@kernel(fastmath=FAST)
def push_from_walls(body, inverse_mass, x, y, vx, vy, ax, ay):
    """Add the accelerations that walls give to free masses."""
    around = body.surroundings
    for k in range(around.walls.shape[0]):
        wall = around.walls[k]
        nx, ny = wall[WALL_NORMAL_X], wall[WALL_NORMAL_Y]
        for i in range(1, body.masses + 1):
            depth = depth_in(wall, x[i], y[i])
            if depth > 0.0 and inverse_mass[i] > 0.0:
                push, friction, _, _ = wall_terms(wall, around.step, depth, vx[i], vy[i])
                share = inverse_mass[i] * around.mass[i]  # 1, but where a statics solver changes masses
                ax[i] += share * (push * nx + friction * ny)
                ay[i] += share * (push * ny - friction * nx)


@kernel(fastmath=FAST)
def shortest_impact(body, inverse_mass, q, v, a, h):
    """The shortest time, s, in which a mass gets as deep into a wall as its speed leads.

    It is that of masses that are in a wall, or enter one within h seconds, and infinite where there are none.

    Args:
        a: flat accelerations, px/s².
    """
    around, shortest, slots = body.surroundings, math.inf, q.size // 2
    for k in range(around.walls.shape[0]):
        wall = around.walls[k]
        nx, ny, hardness = wall[WALL_NORMAL_X], wall[WALL_NORMAL_Y], wall[WALL_HARDNESS]
        for i in range(1, body.masses + 1):
            depth = depth_in(wall, q[i], q[slots + i])
            speed = nx * v[i] + ny * v[slots + i]
            if inverse_mass[i] > 0.0:
                pull = nx * a[i] + ny * a[slots + i]
                shortest = min(shortest, time_to_deepest(hardness, depth, speed, pull, h))
    return shortest


@kernel(fastmath=FAST)
def energy_in_walls(body, inverse_mass, x, y):
    """The energy of all free masses inside walls, kg px²/s²."""
    around, energy = body.surroundings, 0.0
    for k in range(around.walls.shape[0]):
        wall = around.walls[k]
        for i in range(1, body.masses + 1):
            depth = depth_in(wall, x[i], y[i])
            if depth > 0.0 and inverse_mass[i] > 0.0:
                energy += around.mass[i] * wall[WALL_HARDNESS] * depth * depth * depth / 3.0
    return energy


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
    around, slots, found = body.surroundings, q0.size // 2, False
    for k in range(around.walls.shape[0]):
        wall = around.walls[k]
        stiffness = h * wall[WALL_FRICTION] * wall[WALL_HARDNESS] / wall[WALL_SLIP]
        for i in range(quick.shape[1]):
            quick[k, i] = 0.0
        for i in range(1, body.masses + 1):
            depth = max(depth_in(wall, q0[i], q0[slots + i]), depth_in(wall, q1[i], q1[slots + i]))
            if depth > 0.0 and inverse_mass[i] > 0.0 and stiffness * depth * depth > _QUICKLY:
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
    around, slots = body.surroundings, q.size // 2
    for k in range(around.walls.shape[0]):
        wall = around.walls[k]
        nx, ny = wall[WALL_NORMAL_X], wall[WALL_NORMAL_Y]
        for i in range(1, body.masses + 1):
            if quick[k, i] > 0.0:
                x, y, vx, vy = q[i], q[slots + i], v[i], v[slots + i]
                depth, along, friction = depth_in(wall, x, y), vy * nx - vx * ny, 0.0
                if depth > 0.0:
                    _, friction, _, _ = wall_terms(wall, around.step, depth, vx, vy)
                pull = a[slots + i] * nx - a[i] * ny + friction
                quick[k, slots + i] += part * around.mass[i] * pull * along


@kernel(fastmath=FAST)
def work_of_quick(body, v0, v1, h, quick):
    """The work of friction on the masses of `mark_quick` in a step, which is negative, kg px²/s²."""
    around, slots, work = body.surroundings, v0.size // 2, 0.0
    for k in range(around.walls.shape[0]):
        wall = around.walls[k]
        nx, ny = wall[WALL_NORMAL_X], wall[WALL_NORMAL_Y]
        for i in range(1, body.masses + 1):
            if quick[k, i] > 0.0:
                first = v0[slots + i] * nx - v0[i] * ny
                last = v1[slots + i] * nx - v1[i] * ny
                work += 0.5 * around.mass[i] * (last * last - first * first) - h * quick[k, slots + i]
    return work


@kernel(fastmath=FAST)
def power_of_walls(body, inverse_mass, x, y, vx, vy, quick):
    """The power of friction and of what bouncing loses, which is negative, kg px²/s³.

    Friction on the masses of `mark_quick` is left out.
    """
    around, power = body.surroundings, 0.0
    for k in range(around.walls.shape[0]):
        wall = around.walls[k]
        nx, ny = wall[WALL_NORMAL_X], wall[WALL_NORMAL_Y]
        for i in range(1, body.masses + 1):
            depth = depth_in(wall, x[i], y[i])
            if depth > 0.0 and inverse_mass[i] > 0.0:
                push, friction, elastic, along = wall_terms(wall, around.step, depth, vx[i], vy[i])
                rubbing = friction * along if quick.shape[0] == 0 or quick[k, i] == 0.0 else 0.0
                power += around.mass[i] * ((push - elastic) * (vx[i] * nx + vy[i] * ny) - rubbing)
    return power


@kernel(fastmath=FAST)
def derivatives_at_wall(wall, depth, vx, vy, definite):
    """The derivatives of a wall's acceleration of a mass inside it by position and by velocity, two blocks.

    They are those without the softening for explicit methods, which use no derivatives. `definite`
    leaves out what could make the matrix of an implicit step indefinite.
    """
    nx, ny = wall[WALL_NORMAL_X], wall[WALL_NORMAL_Y]
    rough, slip = wall[WALL_FRICTION], wall[WALL_SLIP]
    push, _, _, along = wall_terms(wall, 0.0, depth, vx, vy)
    held = math.tanh(along / slip)
    stuck = rough * push * (1.0 - held * held) / slip
    rise, by_speed = slopes_of_push(wall[WALL_HARDNESS], wall[WALL_LOSS], depth, vx * nx + vy * ny)
    by_depth = -rise  # of the push, along the normal
    # The force is push * (n - rough * held * t), with t = (-ny, nx).
    fx, fy = nx + rough * held * ny, ny - rough * held * nx
    if definite:
        fx, fy = nx, ny
    by_position = (by_depth * fx * nx, by_depth * fx * ny, by_depth * fy * nx, by_depth * fy * ny)
    by_velocity = (
        by_speed * fx * nx - stuck * ny * ny,
        by_speed * fx * ny + stuck * ny * nx,
        by_speed * fy * nx + stuck * nx * ny,
        by_speed * fy * ny - stuck * nx * nx,
    )
    return by_position, by_velocity
