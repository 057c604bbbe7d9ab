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
def power_of_walls(body, inverse_mass, x, y, vx, vy):
    """The power of friction and of what bouncing loses, which is negative, kg px²/s³."""
    around, power = body.surroundings, 0.0
    for k in range(around.walls.shape[0]):
        wall = around.walls[k]
        nx, ny = wall[WALL_NORMAL_X], wall[WALL_NORMAL_Y]
        for i in range(1, body.masses + 1):
            depth = depth_in(wall, x[i], y[i])
            if depth > 0.0 and inverse_mass[i] > 0.0:
                push, friction, elastic, along = wall_terms(wall, around.step, depth, vx[i], vy[i])
                power += around.mass[i] * ((push - elastic) * (vx[i] * nx + vy[i] * ny) - friction * along)
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
